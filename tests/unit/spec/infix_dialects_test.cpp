#include "unit/spec/formula_value.h"

#include <heed/spec/dialect.h>
#include <heed/spec/gr1c.h>
#include <heed/spec/slugsin.h>
#include <heed/spec/structured_slugs.h>
#include <heed/util/file.h>

#include <fmt/format.h>

#include <random>

namespace heed::spec {
namespace {

using test::Values;

Gr1 structured(const std::string& text) {
  return read_structured_slugs(util::SourceText("test.structuredslugs", text));
}
Gr1 gr1c(const std::string& text) {
  return read_gr1c(util::SourceText("test.spc", text));
}

const std::string head = "[INPUT]\na\nx:0...5\n[OUTPUT]\nb\nc\ny:2...9\n";

std::vector<Values> all_valuations(const std::vector<std::string>& names) {
  std::vector<Values> out;
  for (std::size_t bits = 0; bits < (std::size_t{1} << names.size()); ++bits) {
    Values values;
    for (std::size_t i = 0; i < names.size(); ++i) values[names[i]] = (bits >> i) & 1;
    out.push_back(values);
  }
  return out;
}

/// Both readings of \p left and \p right agree for all values of a, b, c and of their next values.
void expect_same(const logic::Formula& left, const logic::Formula& right, const std::string& text) {
  for (const Values& now : all_valuations({"a", "b", "c"}))
    for (const Values& next : all_valuations({"a", "b", "c"}))
      ASSERT_EQ(test::value_of(left, now, next), test::value_of(right, now, next)) << text;
}

TEST(StructuredSlugs, operators_bind_as_its_compiler_says) {
  const std::vector<std::pair<std::string, std::string>> same{{"a | b & c", "a | (b & c)"},
                                                              {"! a & b", "(! a) & b"},
                                                              {"a -> b -> c", "(a -> b) -> c"},
                                                              {"a <-> b -> c", "a <-> (b -> c)"},
                                                              {"a ^ b | c", "a ^ (b | c)"},
                                                              {"a -> b ^ c", "a -> (b ^ c)"},
                                                              {"X a & b", "a' & b"},
                                                              {"next(a & b)", "a' & b'"},
                                                              {"() (a | b)", "a' | b'"},
                                                              {"~ X a", "! a'"},
                                                              {"a /\\ b \\/ c", "(a && b) || c"},
                                                              {"a --> b <--> c", "(a -> b) <-> c"},
                                                              {"c & [a | b]", "(a | b) & c"},
                                                              {"& a | b c", "a & (b | c)"},
                                                              {"$ 2 | a b & ? 0 c", "(a | b) & c"},
                                                              {"TRUE -> a", "a"},
                                                              {"a <-> b <-> c", "(a <-> b) <-> c"},
                                                              {"FALSE | a'", "a'"}};
  for (const auto& [left, right] : same) {
    const Gr1 spec = structured(head + "[SYS_LIVENESS]\n" + left + "\n" + right + "\n");
    expect_same(spec.sys_justice[0].formula, spec.sys_justice[1].formula, left);
  }
}

/// Comparisons and sums against plain arithmetic, for every value of x, y and their next values.
TEST(StructuredSlugs, sums_never_wrap_around) {
  using Meaning = std::function<bool(int x, int y, int xn, int yn)>;
  const std::vector<std::pair<std::string, Meaning>> rows{
      {"x + 1 <= y", [](int x, int y, int, int) { return x + 1 <= y; }},
      {"x' = x + 1", [](int x, int, int xn, int) { return xn == x + 1; }},
      {"y + y' + x != 3 + (x' + 8)", [](int x, int y, int xn, int yn) { return y + yn + x != 11 + xn; }},
      {"! y > 7", [](int, int y, int, int) { return y <= 7; }},
      {"X y < x", [](int, int, int xn, int yn) { return yn < xn; }},
      {"next(x >= 3) & y = 2", [](int, int y, int xn, int) { return xn >= 3 && y == 2; }},
      {"x LEASTSIGNIFICANTBITOVERWRITES 45 = 45 ",
       [](int x, int, int, int) { return ((45 & ~7) | x) == 45; }},
      {"x@1 -> x@0.0.5'", [](int x, int, int xn, int) { return (x & 2) == 0 || (xn & 1) != 0; }},
      {"| ! y@2 y@0.2.9", [](int, int y, int, int) { return ((y - 2) & 4) == 0 || ((y - 2) & 1) != 0; }}};
  for (const auto& [text, meaning] : rows) {
    const Gr1 spec = structured(head + "[SYS_LIVENESS]\n" + text + "\n");
    for (int i = 0; i < 6 * 8 * 6 * 8; ++i) {
      const int x = i % 6, y = 2 + i / 6 % 8, xn = i / 48 % 6, yn = 2 + i / 288;
      const auto value =
          test::value_of(spec.sys_justice[0].formula, {{"x", x}, {"y", y}}, {{"x", xn}, {"y", yn}});
      ASSERT_EQ(value != 0, meaning(x, y, xn, yn)) << text << ' ' << x << ' ' << y << ' ' << xn << ' ' << yn;
    }
  }
}

TEST(StructuredSlugs, flaws_are_told_with_their_place) {
  const std::vector<test::Flaw> flaws{{"[INPUT]\nx:0..5\n", "type 2:3"},
                                      {"[INPUT]\nx:5...0\n", "empty-range 2:3"},
                                      {"[INPUT]\nx:a...5\n", "number 2:3"},
                                      {"[INPUT]\nnext\n", "name 2:1"},
                                      {"[INPUT]\na@b\n", "name 2:1"},
                                      {"[OBSERVABLE_INPUT]\na\n", "not-supported 1:1"},
                                      {head + "[SYS_TRANS]\nb & \n", "syntax 9:4"},
                                      {head + "[SYS_TRANS]\n(b | c\n", "syntax 9:1"},
                                      {head + "[SYS_TRANS]\nb | c)\n", "syntax 9:6"},
                                      {head + "[SYS_TRANS]\n![b | c)\n", "syntax 9:8"},
                                      {head + "[SYS_TRANS]\nb c\n", "syntax 9:3"},
                                      {head + "[SYS_TRANS]\nx & b\n", "type 9:1"},
                                      {head + "[SYS_TRANS]\nb = 1\n", "type 9:1"},
                                      {head + "[SYS_TRANS]\nx - 1 = 0\n", "not-supported 9:3"},
                                      {head + "[SYS_TRANS]\nx' = 2 & X x' = 1\n", "next-twice 9:12"},
                                      {head + "[SYS_TRANS]\nF b\n", "temporal 9:1"},
                                      {head + "[SYS_TRANS]\n[] b\n", "unknown-section 9:1"},
                                      {head + "[SYS_TRANS]\nb & []c\n", "temporal 9:5"},
                                      {head + "[ENV_TRANS]\na' & X b\n", "not-allowed-here 9:8"},
                                      {head + "[SYS_TRANS]\nx > z\n", "unknown-name 9:5"},
                                      {head + "[SYS_TRANS]\nx > 99999999999\n", "number 9:5"}};
  for (const test::Flaw& flaw : flaws)
    EXPECT_EQ(test::refusal([&] { (void)structured(flaw.text); }), flaw.refusal) << flaw.text;
}

TEST(Gr1c, operators_bind_as_gr1c_says) {
  const std::vector<std::pair<std::string, std::string>> same{{"a | b & c", "(a | b) & c"},
                                                              {"a & b | c", "(a & b) | c"},
                                                              {"!a & b", "(!a) & b"},
                                                              {"a -> b -> c", "(a -> b) -> c"},
                                                              {"a <-> b -> c", "a <-> (b -> c)"},
                                                              {"a -> b | c & a'", "a -> ((b | c) & a')"},
                                                              {"a ' & b #comment ;\n | c", "(a' & b) | c"},
                                                              {"True & b", "b"}};
  for (const auto& [left, right] : same) {
    const Gr1 spec = gr1c("ENV: a;\nSYS: b c;\nSYSTRANS: [] " + left + " & [](" + right + ");\n");
    ASSERT_EQ(spec.sys_safety.size(), 2U) << left;
    expect_same(spec.sys_safety[0].formula, spec.sys_safety[1].formula, left);
  }
}

TEST(Gr1c, lists_parts_and_ranges) {
  const Gr1 spec = gr1c(
      "# a comment; with a semicolon\nSYSGOAL: []<>b&c &[]<> !b;\nENV: a n [0,6];SYS: b c;\n"
      "ENVINIT: !a & n<=2;\nSYSINIT:;\nENVTRANS: []n'!=3 & [](n=1->n'>=1);\nSYSGOAL: []<>c;");
  EXPECT_EQ(spec.sys_justice.size(), 3U);
  EXPECT_EQ(spec.env_safety.size(), 2U);
  EXPECT_EQ(spec.inputs[1].domain, model::Domain::integer(0, 6));
  EXPECT_EQ(spec.sys_justice[0].text, "b&c");
  EXPECT_EQ(spec.initial, InitialQuantifiers::ForallExists);
}

TEST(Gr1c, flaws_are_told_with_their_place) {
  const std::string some = "ENV: a n [0,3];\nSYS: b;\n";
  const std::vector<test::Flaw> flaws{{"SYSGOAL:;\n", "no-variables 1:1"},
                                      {"ENV: a;\nSYS: b a;\n", "duplicate-name 2:8"},
                                      {"ENV: a [1,3];\n", "range 1:9"},
                                      {"ENV: a [0 3];\n", "syntax 1:11"},
                                      {"ENV: a [0,3.5];\n", "number 1:11"},
                                      {"ENV: a\n", "syntax 1:1"},
                                      {"GOAL: a;\n", "unknown-part 1:1"},
                                      {some + "ENVINIT: a;\nENVINIT: ;\n", "duplicate-part 4:1"},
                                      {some + "ENVINIT: b;\n", "not-allowed-here 3:10"},
                                      {some + "SYSINIT: a;\n", "not-allowed-here 3:10"},
                                      {some + "ENVTRANS: [] b';\n", "not-allowed-here 3:14"},
                                      {some + "SYSGOAL: []<>b';\n", "not-allowed-here 3:14"},
                                      {some + "SYSGOAL: <>b;\n", "reachability 3:10"},
                                      {some + "SYSTRANS: b;\n", "syntax 3:11"},
                                      {some + "SYSTRANS: []<>b;\n", "syntax 3:11"},
                                      {some + "SYSTRANS: [](b & []a);\n", "syntax 3:13"},
                                      {some + "SYSTRANS: [] n = a;\n", "type 3:18"},
                                      {some + "SYSTRANS: [] 3 = n;\n", "syntax 3:16"},
                                      {some + "SYSTRANS: [] n;\n", "type 3:14"},
                                      {some + "SYSTRANS: [] b @ a;\n", "syntax 3:16"}};
  for (const test::Flaw& flaw : flaws)
    EXPECT_EQ(test::refusal([&] { (void)gr1c(flaw.text); }), flaw.refusal) << flaw.text;
}

TEST(InfixDialects, depth_is_bounded_and_length_is_not) {
  const std::string parentheses(100'000, '('), nots(100'000, '!');
  EXPECT_EQ(test::refusal([&] { (void)structured(head + "[SYS_TRANS]\n" + parentheses + "a\n"); }),
            "too-deep 9:10001");
  EXPECT_EQ(test::refusal([&] { (void)gr1c("SYS: a;\nSYSTRANS: []" + nots + "a;"); }), "too-deep 2:10013");
  std::string chain = "a";
  for (int i = 0; i < 100'000; ++i) chain += i % 2 == 0 ? " & b" : " | a";
  EXPECT_EQ(gr1c("SYS: a b;\nSYSTRANS: [] " + chain + ";").sys_safety.size(), 1U);
}

/// The example of each page is read, and written and read again.
TEST(Dialect, documented_examples_are_read) {
  for (const Dialect dialect : {Dialect::Slugsin, Dialect::StructuredSlugs, Dialect::Gr1c}) {
    const std::string page =
        util::read_file(fmt::format("{}/docs/formats/{}.md", HEED_SOURCE_DIR, to_string(dialect))).text();
    const std::size_t begin = page.find("```text\n") + 8, end = page.find("```", begin);
    const std::string name = dialect == Dialect::Gr1c ? "x.spc" : fmt::format("x.{}", to_string(dialect));
    const Gr1 spec = read_any(util::SourceText(name, page.substr(begin, end - begin)));
    EXPECT_FALSE(spec.outputs.empty()) << name;
    EXPECT_EQ(read_any(util::SourceText(name, write_as(spec, dialect))).outputs.size(), spec.outputs.size());
  }
}

TEST(Dialect, follows_the_extension_and_else_the_content) {
  const auto of = [](const std::string& name, const std::string& text) {
    return to_string(dialect_of(util::SourceText(name, text)));
  };
  EXPECT_EQ(of("x.spc", ""), "gr1c");
  EXPECT_EQ(of("x.slugsin", ""), "slugsin");
  EXPECT_EQ(of("x.structuredslugs", ""), "structuredslugs");
  EXPECT_EQ(of("x.gr1", "[INPUT]"), "gr1");
  EXPECT_EQ(of("-", "# c\n[INPUT]\na\n[SYS_TRANS]\n| a ! a\n"), "slugsin");
  EXPECT_EQ(of("-", "[INPUT]\nx:0...3\n"), "structuredslugs");
  EXPECT_EQ(of("-", "[INPUT]\na\n[ENV_TRANS]\na & a'\n"), "structuredslugs");
  EXPECT_EQ(of("-", "# c\n  ENVINIT:;\n"), "gr1c");
  EXPECT_EQ(of("-", "[input]\na : boolean\n"), "gr1");
  for (const char* word : {"gr1", "slugsin", "structuredslugs", "gr1c"})
    EXPECT_EQ(to_string(dialect_named(word).value()), word);
  EXPECT_FALSE(dialect_named("spectra").has_value());
}

}  // namespace
}  // namespace heed::spec
