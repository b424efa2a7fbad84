#include <heed/logic/parse.h>
#include <heed/spec/gr1.h>
#include <heed/spec/symbols.h>
#include <heed/spec/text.h>
#include <heed/util/diagnostic.h>

#include <gtest/gtest.h>

namespace heed::spec {
namespace {

Gr1 base() {
  return read_gr1(
      util::SourceText("base.gr1",
                       "[input]\na : boolean\ncolour : {red, blue}\n[output]\ny : {red, green}\nn : 0..3\n"
                       "[memory]\nm : boolean = false\nm' = a'\n[define]\nd := a & m\n"));
}

std::string code(const Gr1& spec) {
  try {
    validate(spec);
  } catch (const util::InputError& error) {
    return error.diagnostic().code;
  }
  return "";
}

/// Each part with each kind of formula: the table of gr1.h, cell by cell.
TEST(Validate, the_table_of_places) {
  struct Row {
    std::vector<Clause> Gr1::*part;
    std::vector<bool> admits;  // a, a', y = red, y' = red, m, m', d, d'
  };
  const std::vector<std::string> formulas{"a", "a'", "y = red", "y' = red", "m", "m'", "d", "d'"};
  const std::vector<bool> all(8, true), present{true, false, true, false, true, false, true, false};
  const std::vector<Row> rows{{&Gr1::env_init, {true, false, false, false, false, false, false, false}},
                              {&Gr1::env_safety, {true, true, true, false, true, false, true, false}},
                              {&Gr1::env_justice, all},
                              {&Gr1::sys_init, present},
                              {&Gr1::sys_safety, all},
                              {&Gr1::sys_justice, all}};
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t f = 0; f < formulas.size(); ++f) {
      Gr1 spec = base();
      (spec.*rows[r].part).push_back({logic::parse(formulas[f]), Origin::Task, formulas[f]});
      EXPECT_EQ(code(spec).empty(), rows[r].admits[f]) << r << " " << formulas[f];
    }
}

TEST(Validate, types_of_comparisons) {
  const std::vector<std::pair<const char*, bool>> formulas{
      {"colour = red", true}, {"red = colour", true}, {"colour = green", false},  {"y = green", true},
      {"colour = y", false},  {"n = 3", true},        {"n < n' + 1", true},       {"colour < red", false},
      {"n = a", false},       {"a = m", true},        {"colour' = colour", true}, {"a + 1 = 2", false},
      {"n & a", false},       {"!(n = 2)", true},     {"colour = 1", false}};
  for (const auto& [text, fits] : formulas) {
    Gr1 spec = base();
    spec.sys_safety.push_back({logic::parse(text), Origin::Task, text});
    EXPECT_EQ(code(spec).empty(), fits) << text;
  }
}

TEST(Validate, declarations) {
  const auto with = [](auto change) {
    Gr1 spec = base();
    change(spec);
    return code(spec);
  };
  EXPECT_EQ(with([](auto&) {}), "");
  EXPECT_EQ(with([](auto& s) { s.definitions[0].name = "a"; }), "duplicate-name");
  EXPECT_EQ(with([](auto& s) { s.outputs[0].role = model::OutputRole::Memory; }), "role");
  EXPECT_EQ(with([](auto& s) { s.memories[0].initial = {}; }), "no-initial-value");
  EXPECT_EQ(with([](auto& s) { s.memories[0].initial = {2}; }), "value");
  EXPECT_EQ(with([](auto& s) { s.memories[0].update = logic::parse("y' = red"); }), "next-not-allowed");
  EXPECT_EQ(with([](auto& s) { s.outputs[1].variable.domain.low = 9; }), "empty-range");
  EXPECT_EQ(with([](auto& s) {
              s.definitions.insert(s.definitions.begin(), {"e", logic::parse("d")});
            }),
            "definition-order");
}

TEST(Symbols, a_value_hides_a_variable_in_its_comparison) {
  Gr1 spec = base();
  spec.inputs.push_back({"red", model::Domain::boolean(), ""});
  const Symbols symbols(spec);
  EXPECT_EQ(enumeration_value(logic::parse("colour = red"), 1, symbols), 0);
  EXPECT_EQ(enumeration_value(logic::parse("colour = red"), 0, symbols), std::nullopt);
  EXPECT_EQ(enumeration_value(logic::parse("green = y'"), 0, symbols), 1);
  EXPECT_EQ(enumeration_value(logic::parse("n = red"), 1, symbols), std::nullopt);
  spec.sys_safety.push_back({logic::parse("red -> colour = red"), Origin::Task, ""});
  EXPECT_EQ(code(spec), "");
}

TEST(Symbols, definitions_are_sorted_and_keep_their_order_where_they_can) {
  Gr1 spec = base();
  spec.definitions = {{"p", logic::parse("q | r")},
                      {"s", logic::parse("a")},
                      {"r", logic::parse("a")},
                      {"q", logic::parse("r & s")}};
  sort_definitions(spec);
  std::string order;
  for (const auto& d : spec.definitions) order += d.name;
  EXPECT_EQ(order, "rsqp");
  EXPECT_EQ(code(spec), "");
}

TEST(Symbols, a_long_chain_of_definitions_is_no_deep_call) {
  Gr1 spec = base();
  for (int i = 0; i < 20000; ++i)
    spec.definitions.push_back({"d" + std::to_string(i), logic::name("d" + std::to_string(i + 1))});
  spec.definitions.push_back({"d20000", logic::name("a")});
  sort_definitions(spec);
  EXPECT_EQ(spec.definitions[1].name, "d20000");
}

}  // namespace
}  // namespace heed::spec
