#include <heed/spec/gr1c.h>
#include <heed/util/diagnostic.h>

#include "infix.h"
#include "peer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

// The file is cut into parts at its semicolons first, so that variables may be declared after their use, as
// in gr1c. Each formula of a part ends where the next `& []` begins.

namespace heed::spec {
namespace {

using logic::Formula;
using logic::Op;

enum class Form : std::uint8_t { Variables, Init, Step, Goal };

struct PartKind {
  std::string_view word;
  Form form;
  bool env;
  std::vector<Clause> Gr1::*clauses;
};

constexpr std::array<PartKind, 8> part_kinds{{{"ENV", Form::Variables, true, nullptr},
                                              {"SYS", Form::Variables, false, nullptr},
                                              {"ENVINIT", Form::Init, true, &Gr1::env_init},
                                              {"SYSINIT", Form::Init, false, &Gr1::sys_init},
                                              {"ENVTRANS", Form::Step, true, &Gr1::env_safety},
                                              {"SYSTRANS", Form::Step, false, &Gr1::sys_safety},
                                              {"ENVGOAL", Form::Goal, true, &Gr1::env_justice},
                                              {"SYSGOAL", Form::Goal, false, &Gr1::sys_justice}}};

bool begins_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool in_word(char c) {
  return begins_word(c) || is_digit(c) || c == '.';
}

struct Known {
  model::Domain domain;
  bool input = false;
};

class Reader {
 public:
  Reader(const util::SourceText& source, const util::Limits& limits)
      : source_(source), text_(source.text()), infix_(source, limits, grammar()) {}

  Gr1 read() {
    spec_.name = stem_of(source_.name());
    cut();
    for (const Part& part : parts_)
      if (part.kind->form == Form::Variables) read_variables(part);
    if (known_.empty())
      fail(0, "no-variables", "the specification has no variables", "declare some in ENV: or SYS:");
    for (const Part& part : parts_) {
      part_ = &part;
      if (part.kind->form == Form::Init) read_init(part);
      if (part.kind->form == Form::Step || part.kind->form == Form::Goal) read_list(part);
    }
    return std::move(spec_);
  }

 private:
  struct Part {
    const PartKind* kind;
    std::size_t name, begin, end;  ///< Its name, and its body up to the semicolon.
  };

  /// The first offset from \p at on that is neither blank nor in a comment; \p end when there is none.
  [[nodiscard]] std::size_t skip(std::size_t at, std::size_t end) const {
    while (at < end) {
      if (text_[at] == '#')
        at = std::min(text_.find('\n', at), end);
      else if (is_blank(text_[at]) || text_[at] == '\n')
        ++at;
      else
        break;
    }
    return at;
  }

  void cut() {
    for (std::size_t at = skip(0, text_.size()); at < text_.size(); at = skip(at, text_.size())) {
      Part part{kind(at), at, 0, 0};
      part.begin = at + part.kind->word.size() + 1;
      for (part.end = part.begin; part.end < text_.size() && text_[part.end] != ';';)
        part.end = text_[part.end] == '#' ? std::min(text_.find('\n', part.end), text_.size()) : part.end + 1;
      if (part.end == text_.size())
        fail(at, "syntax", fmt::format("{} is not closed by a semicolon", part.kind->word));
      parts_.push_back(part);
      at = part.end + 1;
    }
  }

  [[nodiscard]] const PartKind* kind(std::size_t at) const {
    std::size_t end = at;
    while (end < text_.size() && in_word(text_[end])) ++end;
    const std::string_view word = text_.substr(at, end - at);
    std::vector<std::string> known;
    for (const PartKind& kind : part_kinds) {
      if (kind.word == word && end < text_.size() && text_[end] == ':') return &kind;
      known.push_back(fmt::format("{}:", kind.word));
    }
    if (word.empty())
      fail(at, "syntax", fmt::format("expected a part such as SYSTRANS: and found '{}'", text_[at]));
    fail(at, "unknown-part", fmt::format("expected a part such as SYSTRANS: and found '{}'", word),
         util::suggestion(fmt::format("{}:", word), known));
  }

  void read_variables(const Part& part) {
    for (std::size_t at = skip(part.begin, part.end); at < part.end; at = skip(at, part.end)) {
      const std::size_t begin = at;
      if (!begins_word(text_[at]))
        fail(at, "name", fmt::format("expected the name of a variable and found '{}'", text_[at]),
             "a name begins with a letter or _");
      while (at < part.end && in_word(text_[at])) ++at;
      std::string name(text_.substr(begin, at - begin));
      if (name == "True" || name == "False") fail(begin, "name", fmt::format("'{}' is a constant", name));
      Known known{model::Domain::boolean(), part.kind->env};
      const std::size_t after = skip(at, part.end);
      if (after < part.end && text_[after] == '[') known.domain = range(at = after, part.end);
      if (!known_.emplace(name, known).second)
        fail(begin, "duplicate-name", fmt::format("the name '{}' is declared twice", name));
      names_.push_back(name);
      add_variable(spec_, known.input, {std::move(name), known.domain, {}, source_.at(begin)});
    }
  }

  /// `[0,n]`, with \p at on the bracket, and behind it afterwards.
  [[nodiscard]] model::Domain range(std::size_t& at, std::size_t end) const {
    ++at;
    const std::size_t first = skip(at, end);
    const std::int32_t low = number(at, end);
    if (low != 0)
      fail(first, "range", fmt::format("the range begins at {}, and gr1c knows [0,n] only", low),
           "shift the variable's values");
    expect(at, end, ',');
    const std::int32_t high = number(at, end);
    expect(at, end, ']');
    return model::Domain::integer(low, high);
  }

  void expect(std::size_t& at, std::size_t end, char c) const {
    at = skip(at, end);
    if (at == end || text_[at] != c) fail(at, "syntax", fmt::format("expected '{}' in a range [0,n]", c));
    ++at;
  }

  [[nodiscard]] std::int32_t number(std::size_t& at, std::size_t end) const {
    at = skip(at, end);
    std::int32_t value = 0;
    const char* const stop = text_.data() + end;
    const auto [rest, error] = std::from_chars(text_.data() + at, stop, value);
    if (at == end || !is_digit(text_[at]) || error != std::errc() || (rest != stop && *rest == '.'))
      fail(at, "number", "expected an integer of 32 bits");
    at = static_cast<std::size_t>(rest - text_.data());
    return value;
  }

  void read_init(const Part& part) {
    bool& given = part.kind->env ? env_init_given_ : sys_init_given_;
    if (given) fail(part.name, "duplicate-part", fmt::format("a second {}", part.kind->word));
    const std::size_t begin = skip(part.begin, part.end);
    if (begin == part.end) return;
    given = true;
    const std::size_t stop = read_formula(begin);
    if (stop != part.end) fail(stop, "syntax", "expected ';' after the initial condition");
  }

  /// `[] f & [] g`, or with `[]<>`.
  void read_list(const Part& part) {
    const bool goals = part.kind->form == Form::Goal;
    std::size_t at = skip(part.begin, part.end);
    while (at < part.end) {
      const bool always = text_.substr(at, 2) == "[]";
      if (text_.substr(at, 2) == "<>")
        fail(at, "reachability", "a goal to be reached once belongs to a reachability game, not to GR(1)",
             "gr1c's program rg plays those; write []<> for a goal to be reached again and again");
      const bool often = always && text_.substr(at + 2, 2) == "<>";
      if (!always || often != goals)
        fail(at, "syntax",
             fmt::format("expected '{}' before a formula of {}", goals ? "[]<>" : "[]", part.kind->word));
      at = read_formula(skip(at + (goals ? 4 : 2), part.end));
      if (at == part.end) break;
      at = skip(at + 1, part.end);  // behind the & that ended the formula
    }
  }

  std::size_t read_formula(std::size_t begin) {
    primed_ = false;
    std::size_t stop = 0;
    const Formula formula = infix_.read(begin, stop);
    std::size_t end = stop;
    while (end > begin && (is_blank(text_[end - 1]) || text_[end - 1] == '\n')) --end;
    Clause clause;
    clause.formula =
        part_->kind->form == Form::Step && !primed_ ? on_steps(formula, source_.at(begin)) : formula;
    clause.text = text_.substr(begin, end - begin);
    if (!formula.is_true() || part_->kind->form == Form::Goal)
      (spec_.*part_->kind->clauses).push_back(std::move(clause));
    return stop;
  }

  [[nodiscard]] Operand resolve(std::string_view word, std::size_t begin) {
    const bool primed = word.ends_with('\'');
    std::size_t length = 0;
    while (length < word.size() && in_word(word[length])) ++length;
    const std::string name(word.substr(0, length));
    if (name == "True" || name == "False") {
      if (primed) fail(begin, "syntax", "a constant has no next value");
      return {logic::truth(name == "True"), begin};
    }
    const auto found = known_.find(name);
    if (found == known_.end())
      fail(begin, "unknown-name", fmt::format("unknown variable '{}'", name), util::suggestion(name, names_));
    check(begin, name, found->second, primed);
    primed_ = primed_ || primed;
    Formula value = Formula::make_name(name, source_.at(begin));
    if (primed) value = Formula::make(Op::Next, {value}, source_.at(begin));
    const model::Domain& domain = found->second.domain;
    return {value, begin, domain.kind == model::Domain::Kind::Integer, true, domain.low, domain.high};
  }

  void check(std::size_t begin, const std::string& name, const Known& known, bool primed) const {
    const PartKind& kind = *part_->kind;
    const auto refuse = [&](const char* why) {
      fail(begin, "not-allowed-here",
           fmt::format("'{}{}' may not stand in {}", name, primed ? "'" : "", kind.word), why);
    };
    if (kind.form == Form::Init && known.input != kind.env)
      refuse(kind.env ? "the environment's start speaks of its own variables only"
                      : "in gr1c's usual reading the system's start speaks of its own variables only");
    if (!primed) return;
    if (kind.form == Form::Init) refuse("a start has no next values");
    if (kind.form == Form::Goal) refuse("a goal is a set of states");
    if (kind.env && !known.input) refuse("the environment moves before the system answers");
  }

  [[nodiscard]] InfixGrammar grammar() {
    InfixGrammar grammar;
    grammar.lex = [this](std::size_t at) { return lex(at); };
    grammar.resolve = [this](std::string_view word, std::size_t begin, bool) { return resolve(word, begin); };
    // gr1c gives & and | the same binding power.
    grammar.power = [](Sign sign) { return sign == Sign::Iff ? 1 : sign == Sign::Implies ? 2 : 3; };
    grammar.plain_comparisons = true;
    return grammar;
  }

  [[nodiscard]] Token lex(std::size_t at) const {
    const std::size_t end = part_->end;
    at = skip(at, end);
    if (at == end) return {Sign::End, end, end};
    if (begins_word(text_[at])) {
      std::size_t stop = at;
      while (stop < end && in_word(text_[stop])) ++stop;
      const std::size_t prime = skip(stop, end);
      if (prime < end && text_[prime] == '\'') stop = prime + 1;
      return {Sign::Name, at, stop};
    }
    if (is_digit(text_[at])) {
      std::size_t stop = at;
      while (stop < end && is_digit(text_[stop])) ++stop;
      if (stop < end && text_[stop] == '.') fail(at, "number", "expected an integer of 32 bits");
      return {Sign::Number, at, stop};
    }
    if (text_[at] == '&' && text_.substr(skip(at + 1, end), 2) == "[]") return {Sign::End, at, at};
    return lex_sign(at);
  }

  [[nodiscard]] Token lex_sign(std::size_t at) const {
    struct Spelling {
      std::string_view text;
      Sign sign;
    };
    static constexpr std::array<Spelling, 13> spellings{{{"<->", Sign::Iff},
                                                         {"->", Sign::Implies},
                                                         {"!=", Sign::Ne},
                                                         {"<=", Sign::Le},
                                                         {">=", Sign::Ge},
                                                         {"&", Sign::And},
                                                         {"|", Sign::Or},
                                                         {"!", Sign::Not},
                                                         {"=", Sign::Eq},
                                                         {"<", Sign::Lt},
                                                         {">", Sign::Gt},
                                                         {"(", Sign::Open},
                                                         {")", Sign::Close}}};
    const std::string_view rest = text_.substr(at, part_->end - at);
    if (rest.starts_with("[]") || rest.starts_with("<>"))
      fail(at, "temporal", "a temporal operator inside a formula",
           "[] and []<> stand before the formulas of a list");
    for (const Spelling& spelling : spellings)
      if (rest.starts_with(spelling.text)) return {spelling.sign, at, at + spelling.text.size()};
    fail(at, "syntax", fmt::format("'{}' is no part of a formula", rest[0]));
  }

  [[noreturn]] void fail(std::size_t offset, std::string code, std::string message,
                         std::string hint = {}) const {
    throw util::InputError(source_, offset, std::move(code), std::move(message), std::move(hint));
  }

  const util::SourceText& source_;
  std::string_view text_;
  InfixReader infix_;
  Gr1 spec_;
  std::vector<Part> parts_;
  const Part* part_ = nullptr;
  std::map<std::string, Known> known_;
  std::vector<std::string> names_;
  bool env_init_given_ = false, sys_init_given_ = false;
  bool primed_ = false;
};

}  // namespace

Gr1 read_gr1c(const util::SourceText& source, const util::Limits& limits) {
  check_size(source, limits);
  return Reader(source, limits).read();
}

}  // namespace heed::spec
