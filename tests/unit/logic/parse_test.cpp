#include <gtest/gtest.h>
#include <heed/logic/parse.h>
#include <heed/util/diagnostic.h>
#include <heed/util/file.h>
#include <heed/util/random.h>

#include <filesystem>
#include <fstream>

namespace heed::logic {
namespace {

/// Fully bracketed prefix form, written here independently of the printer.
std::string shape(const Formula& f) {
  static const char* const words[] = {
      "true", "false", "name", "number", "not", "and", "or", "implies", "iff", "eq", "ne", "lt", "le", "gt",
      "ge",   "add",   "sub",  "mul",    "X",   "G",   "F",  "U",       "W",   "R",  "Y",  "O",  "H",  "S"};
  if (f.op() == Op::Name) return f.name();
  if (f.op() == Op::Number) return std::to_string(f.number());
  std::string out = words[static_cast<int>(f.op())];
  if (f.operands().empty()) return out;
  out.insert(0, 1, '(');
  for (const Formula& operand : f.operands()) out += " " + shape(operand);
  return out + ")";
}

struct Reading {
  const char* text;
  const char* shape;
};

class Reads : public ::testing::TestWithParam<Reading> {};

TEST_P(Reads, WithTheRightBinding) {
  EXPECT_EQ(shape(parse(GetParam().text)), GetParam().shape) << GetParam().text;
}

INSTANTIATE_TEST_SUITE_P(
    All, Reads,
    ::testing::Values(
        Reading{"a & b | c & d", "(or (and a b) (and c d))"}, Reading{"a & b & c", "(and a b c)"},
        Reading{"(a & b) & c", "(and (and a b) c)"}, Reading{"a -> b -> c", "(implies a (implies b c))"},
        Reading{"a <-> b <-> c", "(iff (iff a b) c)"}, Reading{"a U b W c", "(U a (W b c))"},
        Reading{"a U b -> c | d U e", "(implies (U a b) (U (or c d) e))"}, Reading{"!a U b", "(U (not a) b)"},
        Reading{"G a & b", "(and (G a) b)"}, Reading{"GF a & b", "(and (G (F a)) b)"},
        Reading{"G F a", "(G (F a))"}, Reading{"GFa", "GFa"}, Reading{"X x = 1 & a", "(and (X (eq x 1)) a)"},
        Reading{"!x = 1", "(not (eq x 1))"},
        Reading{"x' = x + 1 * y - 2", "(eq (X x) (sub (add x (mul 1 y)) 2))"},
        Reading{"x-3<-2", "(lt (sub x 3) -2)"}, Reading{"x - -3 >= 0", "(ge (sub x -3) 0)"},
        Reading{"(x + 1)' * 2 <= y", "(le (mul (X (add x 1)) 2) y)"}, Reading{"X a'", "(X (X a))"},
        Reading{"(a & b)'", "(X (and a b))"}, Reading{"a''", "(X (X a))"},
        Reading{"[]<>~a && b || c", "(or (and (G (F (not a))) b) c)"},
        Reading{"□◇¬a ∧ b ∨ ○c → d ↔ e", "(iff (implies (or (and (G (F (not a))) b) (X c)) d) e)"},
        Reading{"x ≠ 1 ∧ x ≤ 2 ∧ x ≥ 0", "(and (ne x 1) (le x 2) (ge x 0))"},
        Reading{"\"G\" & \"main road\" & \"a\\\"b\\\\\"", "(and G main road a\"b\\)"},
        Reading{"O H Y a S b R c", "(S (O (H (Y a))) (R b c))"},
        Reading{"colour = red.dark", "(eq colour red.dark)"}, Reading{"straße & été_2", "(and straße été_2)"},
        Reading{"true & !false", "(and true (not false))"}, Reading{"((a))", "a"},
        Reading{" \t\n a \r\n", "a"}, Reading{"Gx & Xa", "(and Gx Xa)"}, Reading{"(x) = (1)", "(eq x 1)"},
        Reading{"a & X b = c", "(and a (X (eq b c)))"},
        Reading{"-9223372036854775808 < x", "(lt -9223372036854775808 x)"}));

/// Draws well-sorted formulas over all operators, odd names included.
class Generator {
 public:
  explicit Generator(std::uint64_t seed) : random_(seed, 9) {}

  Formula formula(int depth) {
    if (depth == 0) return random_.below(8) == 0 ? Formula::make(pick({Op::True, Op::False}), {}) : a_name();
    switch (random_.below(5)) {
      case 0:
        return Formula::make(
            pick({Op::Not, Op::Next, Op::Always, Op::Eventually, Op::Previous, Op::Once, Op::Historically}),
            {formula(depth - 1)});
      case 1:
        return Formula::make(pick({Op::Eq, Op::Ne, Op::Lt, Op::Le, Op::Gt, Op::Ge}),
                             {term(depth - 1), term(depth - 1)});
      case 2: {
        std::vector<Formula> operands;
        for (std::uint32_t i = 0; i < 2 + random_.below(2); ++i) operands.push_back(formula(depth - 1));
        if (operands.size() < 2) operands.push_back(a_name());
        return Formula::make(pick({Op::And, Op::Or}), std::move(operands));
      }
      default:
        return Formula::make(pick({Op::Implies, Op::Iff, Op::Until, Op::WeakUntil, Op::Release, Op::Since}),
                             {formula(depth - 1), formula(depth - 1)});
    }
  }

 private:
  Op pick(std::vector<Op> ops) { return ops[random_.below(static_cast<std::uint32_t>(ops.size()))]; }
  Formula a_name() {
    static const char* const names[] = {"a",    "b",         "x.y",   "_1",  "G", "GF",
                                        "true", "main road", "q\"\\", "été", "→", "1a"};
    return name(names[random_.below(12)]);
  }
  Formula term(int depth) {
    if (depth <= 0 || random_.below(3) == 0)
      return random_.below(2) == 0 ? a_name() : number(static_cast<std::int64_t>(random_.below(9)) - 4);
    if (random_.below(4) == 0) return Formula::make(Op::Next, {term(depth - 1)});
    return Formula::make(pick({Op::Add, Op::Sub, Op::Mul}), {term(depth - 1), term(depth - 1)});
  }

  util::CounterRandom random_;
};

TEST(Print, ReadsBackInAsciiAndUnicode) {
  for (std::uint64_t seed = 0; seed < 5'000; ++seed) {
    const Formula formula = Generator(seed).formula(static_cast<int>(seed % 6));
    for (const Notation notation : {Notation::Ascii, Notation::Unicode}) {
      const std::string text = to_string(formula, notation);
      ASSERT_EQ(parse(text), formula) << text << "\n" << shape(formula);
      ASSERT_EQ(to_string(parse(text), notation), text);
    }
  }
}

/// Every pair of parentheses is needed: without it the text is another formula or none.
TEST(Print, WritesNoParenthesesInVain) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const Formula formula = Generator(seed).formula(4);
    const std::string text = to_string(formula);
    if (text.find('"') != std::string::npos) continue;
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '(') open.push_back(i);
      if (text[i] != ')') continue;
      std::string without = text;
      without[i] = without[open.back()] = ' ';
      open.pop_back();
      try {
        EXPECT_FALSE(parse(without) == formula) << text << "\n" << without;
      } catch (const util::InputError&) {
      }
    }
  }
}

TEST(Print, ForPeople) {
  const Formula formula = parse("G (a_b & x < 2 -> X (c | !d)) & GF e");
  EXPECT_EQ(to_string(formula), "G (a_b & x < 2 -> X (c | !d)) & GF e");
  EXPECT_EQ(to_string(formula, Notation::Unicode), "□(a_b ∧ x < 2 → ○(c ∨ ¬d)) ∧ □◇e");
  EXPECT_EQ(to_string(parse("a & \"<b>\" < x"), Notation::Html), "a &and; &quot;&lt;b&gt;&quot; &lt; x");
  EXPECT_EQ(to_string(parse("G (a_b U c)"), Notation::Latex),
            "\\Box (\\mathit{a\\_b} \\mathbin{\\mathsf{U}} \\mathit{c})");
}

TEST(Parse, NodesKnowWhereTheyStand) {
  const util::SourceText source("task.toml", "G (a ->\n  X b)", 7, 11);
  const Formula formula = parse(source);
  EXPECT_EQ(to_string(formula.location()), "task.toml:7:11");
  EXPECT_EQ(to_string(formula[0].location()), "task.toml:7:14");
  EXPECT_EQ(to_string(formula[0][1].location()), "task.toml:8:3");
}

std::string repeat(const std::string& text, int times) {
  std::string out;
  for (int i = 0; i < times; ++i) out += text;
  return out;
}

TEST(Parse, NestsTenThousandDeep) {
  constexpr int depth = 9'999;
  const std::string texts[] = {repeat("(", depth) + "a" + repeat(")", depth),
                               repeat("!", depth) + "a",
                               "a" + repeat("'", depth),
                               repeat("(a & ", depth) + "b" + repeat(")", depth),
                               repeat("a -> ", depth) + "b",
                               "a" + repeat(" <-> b", depth)};
  for (const std::string& text : texts) {
    const Formula formula = parse(text);
    EXPECT_EQ(parse(to_string(formula)), formula);
  }
  EXPECT_EQ(parse("a" + repeat(" & b", 100'000)).operands().size(), 100'001U) << "long is not deep";
}

TEST(Parse, RefusesDeeperNestingWithAMessage) {
  constexpr int depth = 100'000;
  const std::string texts[] = {repeat("(", depth) + "a" + repeat(")", depth),
                               repeat("!", depth) + "a",
                               "a" + repeat("'", depth),
                               repeat("(a & ", depth) + "b" + repeat(")", depth),
                               repeat("a -> ", depth) + "b",
                               "a" + repeat(" <-> b", depth),
                               repeat("(", depth)};
  for (const std::string& text : texts) {
    try {
      (void)parse(text);
      FAIL() << text.substr(0, 10);
    } catch (const util::InputError& error) {
      EXPECT_EQ(error.diagnostic().code, "nesting");
    }
  }
}

/// Files whose first line is `expect: CODE LINE:COLUMN | part of message or hint`; the formula follows.
TEST(Parse, RefusesFlawedFiles) {
  const std::filesystem::path folder = std::filesystem::path(HEED_SOURCE_DIR) / "tests/regress/logic/flawed";
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string text = util::read_file(entry.path().string()).text();
    const std::size_t line_end = text.find('\n'), bar = text.find(" | ");
    ASSERT_TRUE(text.starts_with("expect: ") && bar < line_end) << entry.path();
    const std::string expected = text.substr(8, bar - 8), part = text.substr(bar + 3, line_end - bar - 3);
    try {
      (void)parse(util::SourceText("f", text.substr(line_end + 1)));
      ADD_FAILURE() << entry.path() << " was accepted";
    } catch (const util::InputError& error) {
      const util::Diagnostic& found = error.diagnostic();
      EXPECT_EQ(found.code + " " + to_string(found.location).substr(2), expected) << entry.path();
      EXPECT_NE((found.message + "; " + found.hint).find(part), std::string::npos) << error.what();
      EXPECT_NE(found.excerpt.find('^'), std::string::npos);
    }
    ++files;
  }
  EXPECT_GE(files, 20);
}

/// Whatever the bytes are, the reader answers with a formula or an InputError.
TEST(Parse, SurvivesRandomBytes) {
  const std::string alphabet = "abGFXU'\"\\()!&|<->=+-*129 ~.[]\xe2\x97\xa1\xc3\xff\n";
  for (std::uint64_t seed = 0; seed < 20'000; ++seed) {
    util::CounterRandom random(seed, 4);
    std::string text;
    for (std::uint32_t i = random.below(14); i > 0; --i)
      text += alphabet[random.below(static_cast<std::uint32_t>(alphabet.size()))];
    try {
      const Formula formula = parse(text);
      EXPECT_EQ(parse(to_string(formula)), formula) << text;
    } catch (const util::InputError&) {
    }
  }
}

}  // namespace
}  // namespace heed::logic
