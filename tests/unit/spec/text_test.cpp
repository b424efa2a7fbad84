#include <heed/logic/parse.h>
#include <heed/spec/print.h>
#include <heed/spec/text.h>
#include <heed/util/diagnostic.h>
#include <heed/util/file.h>
#include <heed/util/random.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace heed::spec {
namespace {

namespace fs = std::filesystem;

const fs::path source_dir = HEED_SOURCE_DIR;

Gr1 read(const std::string& text) {
  return read_gr1(util::SourceText("test.gr1", text));
}

util::Diagnostic refusal(const std::string& text) {
  try {
    static_cast<void>(read(text));
  } catch (const util::InputError& error) {
    return error.diagnostic();
  }
  return {};
}

/// Everything of a specification but texts and locations, one line per fact.
std::vector<std::string> facts(const Gr1& spec) {
  std::vector<std::string> out{spec.name, to_string(spec.timing), to_string(spec.initial)};
  const auto axioms = [](const std::vector<std::string>& list) {
    std::string all;
    for (const auto& axiom : list) all += axiom + ";";
    return all;
  };
  for (const auto& v : spec.inputs) out.push_back(v.name + to_string(v.domain) + v.comment);
  for (const auto& v : spec.outputs)
    out.push_back(v.variable.name + to_string(v.variable.domain) + v.variable.comment +
                  std::to_string(static_cast<int>(v.role)));
  for (const auto& m : spec.memories) {
    std::string fact =
        m.variable.name + to_string(m.variable.domain) + m.comment + std::to_string(static_cast<int>(m.role));
    for (const auto code : m.initial) fact += "," + std::to_string(code);
    for (const auto& c : m.cases)
      fact += "|" + std::to_string(c.value) + ":" + std::to_string(c.guard.hash());
    out.push_back(fact + std::to_string(m.update.hash()));
  }
  for (const auto& d : spec.definitions)
    out.push_back(d.name + d.comment + axioms(d.axioms) + std::to_string(static_cast<int>(d.role)) +
                  std::to_string(d.formula.hash()));
  for (auto part : {&Gr1::env_init, &Gr1::env_safety, &Gr1::env_justice, &Gr1::sys_init, &Gr1::sys_safety,
                    &Gr1::sys_justice}) {
    out.push_back("part");
    for (const Clause& c : spec.*part)
      out.push_back(to_string(c.origin) + axioms(c.axioms) + std::to_string(c.formula.hash()));
  }
  return out;
}

void expect_round_trip(const Gr1& spec) {
  const std::string text = write_gr1(spec);
  const Gr1 again = read(text);
  EXPECT_EQ(facts(again), facts(spec)) << text;
  EXPECT_EQ(write_gr1(again), text);
}

std::string example_of_the_docs() {
  const std::string docs = util::read_file((source_dir / "docs/formats/gr1.md").string()).text();
  const std::size_t begin = docs.find("```text\n") + 8;
  return docs.substr(begin, docs.find("```", begin) - begin);
}

TEST(Text, the_documented_example_is_read) {
  const Gr1 spec = read(example_of_the_docs());
  EXPECT_EQ(spec.name, "crossing");
  EXPECT_EQ(spec.inputs.size(), 2U);
  EXPECT_EQ(spec.inputs[1].comment, "cars waiting");
  EXPECT_EQ(spec.memories.size(), 3U) << "two and the monitor of the request";
  EXPECT_EQ(spec.definitions[0].axioms, std::vector<std::string>{"a7"});
  EXPECT_EQ(spec.sys_safety[0].origin, Origin::Binding);
  EXPECT_EQ(spec.sys_justice.size(), 2U);
  expect_round_trip(spec);
}

TEST(Text, accepted_files_round_trip) {
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(source_dir / "tests/regress/spec")) {
    if (entry.path().extension() != ".gr1") continue;
    SCOPED_TRACE(entry.path());
    ++files;
    expect_round_trip(read_gr1(util::read_file(entry.path().string())));
  }
  EXPECT_GT(files, 0U);
}

std::string head(const std::string& text, const std::string& key) {
  const std::size_t begin = text.find("# " + key + ": ") + key.size() + 4;
  return text.substr(begin, text.find('\n', begin) - begin);
}

TEST(Text, flawed_files_are_refused_where_and_as_they_say) {
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(source_dir / "tests/regress/spec/flawed")) {
    if (entry.path().extension() != ".gr1") continue;
    ++files;
    const util::SourceText source = util::read_file(entry.path().string());
    try {
      static_cast<void>(read_gr1(source));
      ADD_FAILURE() << entry.path() << " was accepted";
    } catch (const util::InputError& error) {
      const auto& d = error.diagnostic();
      EXPECT_EQ(d.code, head(source.text(), "error")) << entry.path() << '\n' << error.what();
      EXPECT_EQ(std::to_string(d.location.line) + ":" + std::to_string(d.location.column),
                head(source.text(), "at"))
          << entry.path() << '\n'
          << error.what();
    }
  }
  EXPECT_GE(files, 30U);
}

TEST(Text, hints_name_the_nearest_word) {
  EXPECT_EQ(refusal("[sys safty]\n").hint, "did you mean 'sys safety'?");
  EXPECT_EQ(refusal("[options]\ninitial = forall-exist\n").hint, "did you mean 'forall-exists'?");
  EXPECT_EQ(refusal("[input]\nsign : boolean\n[env init]\nsgn\n").hint, "did you mean 'sign'?");
}

TEST(Text, line_ends_and_blanks_do_not_matter) {
  const Gr1 plain = read("[input]\na : boolean\n[env init]\na\n");
  EXPECT_EQ(facts(read("\r\n  [input]  # c\r\n\ta:boolean\r\n[env init]\r\n  a  # \"\r\n")), facts(plain));
  EXPECT_EQ(facts(read("[input]\na : boolean\n[env init]\na")), facts(plain));
  EXPECT_EQ(facts(read("")), facts(Gr1{}));
}

TEST(Text, deep_nesting_is_read_or_refused) {
  const auto nested = [](std::size_t depth) {
    return "[input]\na : boolean\n[env init]\n" + std::string(depth, '(') + "a" + std::string(depth, ')') +
           "\n";
  };
  EXPECT_EQ(read(nested(9000)).env_init.size(), 1U);
  EXPECT_FALSE(refusal(nested(100000)).message.empty());
  std::string nots = "[input]\na : boolean\n[sys safety]\n" + std::string(9000, '!') + "a'\n";
  EXPECT_EQ(read(nots).sys_safety.size(), 1U);
}

std::string random_formula(util::CounterRandom& random, const std::vector<std::string>& atoms,
                           unsigned depth) {
  const auto atom = [&] { return atoms[random.below(static_cast<std::uint32_t>(atoms.size()))]; };
  if (depth == 0) return atom();
  const std::vector<std::string> signs{" & ", " | ", " -> ", " <-> "};
  return "(" + random_formula(random, atoms, depth - 1) + signs[random.below(4)] + "!(" +
         random_formula(random, atoms, depth - 1) + "))";
}

TEST(Text, random_specifications_round_trip) {
  const Gr1 base =
      read("[input]\na : boolean\nn : 0..3\n[output]\ny : {s, t}\n[memory]\nm : boolean = true\nm' = m\n");
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    util::CounterRandom random(11, seed);
    Gr1 spec = base;
    const std::vector<std::string> now{"a", "n > 2", "n + 1 = 3", "y = s", "y != t", "m"};
    std::vector<std::string> then = now;
    then.insert(then.end(), {"a'", "X (n = 2)", "n' < n", "y' = y", "X (y = t & m)", "y' = t"});
    spec.memories[0].update = logic::parse(random_formula(random, now, 2));
    spec.definitions.push_back({"d",
                                logic::parse(random_formula(random, now, 1)),
                                model::OutputRole::Prescribed,
                                "why\n\"so\"",
                                {"x\\y"}});
    spec.sys_safety.push_back(
        {logic::parse(random_formula(random, then, 3)), Origin::Knowledge, "", {"b1", "b2"}});
    spec.sys_justice.push_back({logic::parse(random_formula(random, then, 2)), Origin::Task, ""});
    expect_round_trip(spec);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(Listing, shows_every_clause_with_its_source) {
  const std::string text = listing(read(example_of_the_docs()));
  for (const char* part :
       {"specification crossing (mealy, initial forall-exists)", "light := red | queue > 2",
        "# recognised: a7", "place : {far, near}, at first far", "halt -> go = stay", "# binding",
        "# cars waiting"})
    EXPECT_THAT(text, testing::HasSubstr(part));
}

}  // namespace
}  // namespace heed::spec
