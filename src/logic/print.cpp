#include "print.h"

#include "lexer.h"
#include "precedence.h"

#include <heed/logic/parse.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace heed::logic {
namespace {

std::string replace_each(const std::string& text,
                         std::initializer_list<std::pair<char, const char*>> replacements) {
  std::string out;
  for (const char c : text) {
    const auto* found = std::find_if(replacements.begin(), replacements.end(),
                                     [c](const auto& pair) { return pair.first == c; });
    if (found == replacements.end())
      out += c;
    else
      out += found->second;
  }
  return out;
}

std::string quoted(const std::string& word) {
  if (is_plain_name(word)) return word;
  return '"' + replace_each(word, {{'"', "\\\""}, {'\\', "\\\\"}}) + '"';
}

std::string html(const std::string& text) {
  return replace_each(text, {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}});
}

std::string latex(const std::string& text) {
  return replace_each(text, {{'_', "\\_"},
                             {'&', "\\&"},
                             {'%', "\\%"},
                             {'#', "\\#"},
                             {'$', "\\$"},
                             {'{', "\\{"},
                             {'}', "\\}"},
                             {'\\', "\\backslash{}"},
                             {'^', "\\^{}"},
                             {'~', "\\~{}"}});
}

/// One operator in the four notations.
struct Sign {
  Op op;
  const char* ascii;
  const char* unicode;
  const char* html;
  const char* latex;
};

constexpr Sign signs[] = {{Op::Not, "!", "\u00ac", "&not;", "\\lnot "},
                          {Op::And, "&", "\u2227", "&and;", "\\land"},
                          {Op::Or, "|", "\u2228", "&or;", "\\lor"},
                          {Op::Implies, "->", "\u2192", "&rarr;", "\\rightarrow"},
                          {Op::Iff, "<->", "\u2194", "&harr;", "\\leftrightarrow"},
                          {Op::Eq, "=", "=", "=", "="},
                          {Op::Ne, "!=", "\u2260", "&ne;", "\\neq"},
                          {Op::Lt, "<", "<", "&lt;", "<"},
                          {Op::Le, "<=", "\u2264", "&le;", "\\leq"},
                          {Op::Gt, ">", ">", "&gt;", ">"},
                          {Op::Ge, ">=", "\u2265", "&ge;", "\\geq"},
                          {Op::Add, "+", "+", "+", "+"},
                          {Op::Sub, "-", "-", "-", "-"},
                          {Op::Mul, "*", "*", "*", "\\cdot"},
                          {Op::Next, "X ", "\u25cb", "&#9675;", "\\bigcirc "},
                          {Op::Always, "G ", "\u25a1", "&#9633;", "\\Box "},
                          {Op::Eventually, "F ", "\u25c7", "&#9671;", "\\Diamond "},
                          {Op::Until, "U", "U", "U", "\\mathbin{\\mathsf{U}}"},
                          {Op::WeakUntil, "W", "W", "W", "\\mathbin{\\mathsf{W}}"},
                          {Op::Release, "R", "R", "R", "\\mathbin{\\mathsf{R}}"},
                          {Op::Previous, "Y ", "Y ", "Y ", "\\mathsf{Y}\\,"},
                          {Op::Once, "O ", "O ", "O ", "\\mathsf{O}\\,"},
                          {Op::Historically, "H ", "H ", "H ", "\\mathsf{H}\\,"},
                          {Op::Since, "S", "S", "S", "\\mathbin{\\mathsf{S}}"}};

/// Writes a formula from a stack of what is still to come: text, or a part and how tightly it must bind.
class Printer {
 public:
  explicit Printer(Notation notation, std::size_t most = SIZE_MAX) : notation_(notation), most_(most) {}

  std::string print(const Formula& formula) {
    todo_.push_back({&formula, BindNothing, {}});
    while (!todo_.empty()) {
      if (out_.size() > most_) return out_ + "...";
      const Item item = std::move(todo_.back());
      todo_.pop_back();
      if (item.formula == nullptr)
        out_ += item.text;
      else
        write(*item.formula, item.level);
    }
    return std::move(out_);
  }

 private:
  struct Item {
    const Formula* formula = nullptr;
    int level = BindNothing;
    std::string text{};
  };

  void write(const Formula& formula, int level);
  void write_atom(const Formula& formula);
  void write_prefix(const Formula& formula);
  void write_infix(const Formula& formula);
  void push(std::string text) { todo_.push_back({nullptr, BindNothing, std::move(text)}); }
  void push(const Formula& formula, int level) { todo_.push_back({&formula, level, {}}); }
  [[nodiscard]] const char* sign(Op op) const;
  [[nodiscard]] std::string word(const char* text) const;

  Notation notation_;
  std::size_t most_;
  std::string out_;
  std::vector<Item> todo_;
};

const char* Printer::sign(Op op) const {
  const Sign& found =
      *std::find_if(std::begin(signs), std::end(signs), [op](const Sign& s) { return s.op == op; });
  switch (notation_) {
    case Notation::Ascii:
    case Notation::Textbook:
      return found.ascii;
    case Notation::Unicode:
      return found.unicode;
    case Notation::Html:
      return found.html;
    case Notation::Latex:
      return found.latex;
  }
  return found.ascii;
}

std::string Printer::word(const char* text) const {
  return notation_ == Notation::Latex ? std::string("\\mathit{") + text + '}' : std::string(text);
}

/// `x'` for names and terms; formulas take the prefix.
bool is_postfix_next(const Formula& formula) {
  const Formula* inner = &formula;
  while (inner->op() == Op::Next) inner = &(*inner)[0];
  return inner->op() == Op::Name || inner->op() == Op::Number || is_arithmetic(inner->op());
}

void Printer::write(const Formula& formula, int level) {
  // Within a comparison or a sum the prime is all that binds tightly enough.
  const bool prefix =
      (notation_ == Notation::Textbook || notation_ == Notation::Unicode) && level <= BindPrefix;
  const bool postfix = formula.op() == Op::Next && is_postfix_next(formula) && !prefix;
  const int own = postfix ? int{BindPostfix} : binding(formula.op());
  if (own < level) {
    out_ += '(';
    push(")");
  }
  if (postfix) {
    push("'");
    push(formula[0], BindPostfix);
  } else if (formula.operands().empty()) {
    write_atom(formula);
  } else if (is_prefix(formula.op())) {
    write_prefix(formula);
  } else {
    write_infix(formula);
  }
}

void Printer::write_atom(const Formula& formula) {
  if (formula.op() == Op::True) {
    out_ += word("true");
  } else if (formula.op() == Op::False) {
    out_ += word("false");
  } else if (formula.op() == Op::Number) {
    out_ += std::to_string(formula.number());
  } else if (notation_ == Notation::Html) {
    out_ += html(quoted(formula.name()));
  } else if (notation_ == Notation::Latex) {
    out_ += word(latex(formula.name()).c_str());
  } else {
    out_ += quoted(formula.name());
  }
}

void Printer::write_prefix(const Formula& formula) {
  const bool again = formula.op() == Op::Always && formula[0].op() == Op::Eventually;
  if (again && (notation_ == Notation::Ascii || notation_ == Notation::Textbook)) {
    out_ += "GF ";
    push(formula[0][0], BindPrefix);
    return;
  }
  out_ += sign(formula.op());
  push(formula[0], BindPrefix);
}

void Printer::write_infix(const Formula& formula) {
  const Op op = formula.op();
  const bool chain = op == Op::And || op == Op::Or || is_comparison(op);
  const int own = binding(op);
  const int left = chain || is_right_associative(op) ? own + 1 : own;
  const int right = is_right_associative(op) ? own : own + 1;
  const std::string between = std::string(" ") + sign(op) + ' ';
  for (std::size_t i = formula.operands().size(); i-- > 0;) {
    push(formula[i], i == 0 ? left : right);
    if (i > 0) push(between);
  }
}

}  // namespace

std::string to_string(const Formula& formula) {
  return Printer(Notation::Ascii).print(formula);
}

std::string to_string(const Formula& formula, Notation notation) {
  return Printer(notation).print(formula);
}

std::string to_short_string(const Formula& formula, std::size_t bytes) {
  return Printer(Notation::Ascii, bytes).print(formula);
}

}  // namespace heed::logic
