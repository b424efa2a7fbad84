#include "dialects/verdict.h"

#include <heed/logic/parse.h>
#include <heed/spec/text.h>
#include <heed/util/diagnostic.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <random>

namespace heed::dialects {
namespace {

/// A random specification in heed's own format: Booleans, an integer that starts below zero, an enumeration,
/// memories and definitions, clauses with and without Next, goals about steps.
class Maker {
 public:
  explicit Maker(unsigned seed) : random_(seed) {}

  std::string spec() {
    std::string out =
        "[input]\na : boolean\nn : -1..1\n[output]\nb : boolean\ncolour : {red, green, blue}\n\"two words\" "
        ": 2..4\n";
    out += fmt::format("[memory]\nm : boolean = {}\nm' = {}\n", pick({"true", "false"}),
                       formula(now_and_inputs));
    out +=
        fmt::format("k : 0..2 = 1\nk' = 0 when {}\nk' = 2 when {}\n", formula(now_and_inputs), formula(now));
    out += fmt::format("[define]\nd := {}\ne := d | {}\n", formula(inputs_only), formula(plain_now));
    section(out, "env init", inputs_only, 1);
    section(out, "env safety", random_() % 2 == 0 ? past : now_and_inputs, 2);
    section(out, "env safety", present_inputs, 1);
    section(out, "env justice", everything, 2);
    section(out, "sys init", now, 1);
    section(out, "sys safety", everything, 2);
    section(out, "sys safety", now, 1);
    section(out, "sys justice", everything, 2);
    return out;
  }

 private:
  using Atoms = std::vector<const char*>;
  static inline const Atoms inputs_only{"a", "n = 0", "n < 1"};
  static inline const Atoms present_inputs{"a", "n >= 0", "m", "k = 1", "k > n", "d"};
  static inline const Atoms plain_now{"a", "b", "n > 0", "m", "colour = red"};
  static inline const Atoms past{"a", "b", "m", "e", "colour != blue", "k < 2"};
  static inline const Atoms now{
      "a", "b", "n > 0", "m", "d", "e", "k = 2", "colour = green", "\"two words\" - n > 2"};
  static inline const Atoms now_and_inputs{"a", "a'",           "b", "n' > n",    "n' = 0",
                                           "m", "colour = red", "d", "k + n' > 1"};
  static inline const Atoms everything{
      "a",  "a'",      "b'",  "b",     "n' > n", "colour' = colour", "X (e & b)", "\"two words\"' * n = 2",
      "m'", "k' != k", "X d", "b = a'"};

  std::string pick(const Atoms& atoms) { return atoms[random_() % atoms.size()]; }

  std::string formula(const Atoms& atoms) {
    const std::string x = pick(atoms), y = pick(atoms), z = pick(atoms);
    switch (random_() % 5) {
      case 0:
        return fmt::format("({}) | ({})", x, y);
      case 1:
        return fmt::format("!({}) | ({})", x, y);
      case 2:
        return fmt::format("(({}) <-> ({})) | ({})", x, y, z);
      case 3:
        return fmt::format("({}) -> ({})", x, y);
      default:
        return fmt::format("({}) | !({}) & ({})", x, y, z);
    }
  }

  void section(std::string& out, const char* name, const Atoms& atoms, std::size_t most) {
    out += fmt::format("[{}]\n", name);
    for (std::size_t i = random_() % (most + 1); i > 0; --i) out += formula(atoms) + "\n";
  }

  std::mt19937 random_;
};

TEST(RoundTrip, random_specifications_keep_their_verdict) {
  std::map<std::string, int> seen;
  for (unsigned seed = 0; seed < 200; ++seed) {
    const std::string text = Maker(seed).spec();
    const spec::Gr1 spec = spec::read_gr1(util::SourceText("random.gr1", text));
    const std::string expected = verdict(spec, 0);
    ++seen[expected];
    for (const spec::Dialect dialect : all_dialects) {
      const spec::Gr1 back = again(spec, dialect);
      ASSERT_EQ(verdict(back, 0), expected) << seed << ' ' << to_string(dialect) << '\n' << text;
      if (dialect == spec::Dialect::Gr1 || seed % 4 != 0) continue;
      ASSERT_EQ(verdict(again(back, spec::Dialect::Gr1c), 0), expected) << seed << ' ' << to_string(dialect);
    }
  }
  EXPECT_GT(seen["R"], 10);
  EXPECT_GT(seen["U"], 10);
}

TEST(RoundTrip, what_a_target_cannot_say_is_refused_with_the_reason) {
  for (const char* option : {"timing = moore", "initial = exists-exists"}) {
    const spec::Gr1 spec = spec::read_gr1(
        util::SourceText("x.gr1", fmt::format("[options]\n{}\n[output]\nb : boolean\n", option)));
    for (const auto dialect : {spec::Dialect::Slugsin, spec::Dialect::StructuredSlugs, spec::Dialect::Gr1c})
      try {
        (void)spec::write_as(spec, dialect);
        ADD_FAILURE() << option;
      } catch (const util::InputError& error) {
        EXPECT_EQ(error.diagnostic().code, "not-expressible");
        EXPECT_FALSE(error.diagnostic().hint.empty());
      }
  }
}

/// A constraint on the present in a peer's TRANS section is about states that are left: a deadlocked
/// environment wins nothing, although the constraint is broken.
TEST(RoundTrip, constraints_on_the_present_are_about_steps) {
  const auto of = [](const std::string& text) {
    return verdict(spec::read_any(util::SourceText("x.slugsin", "[INPUT]\na\n[OUTPUT]\nb\n" + text)), 0);
  };
  EXPECT_EQ(of("[SYS_TRANS]\n0\n"), "U");
  EXPECT_EQ(of("[SYS_TRANS]\n0\n[ENV_TRANS]\n0\n"), "R");
  EXPECT_EQ(of("[SYS_INIT]\n0\n[ENV_TRANS]\n0\n"), "U");
  EXPECT_EQ(of("[SYS_INIT]\n! b\n[SYS_TRANS]\nb\n[ENV_TRANS]\na\n[ENV_INIT]\n! a\n"), "R");
  EXPECT_EQ(of("[SYS_LIVENESS]\n& a' b'\n[ENV_LIVENESS]\na\n"), "R");
  EXPECT_EQ(of("[SYS_LIVENESS]\n& a b'\n"), "U");
}

}  // namespace
}  // namespace heed::dialects
