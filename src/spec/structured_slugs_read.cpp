#include <heed/spec/structured_slugs.h>
#include <heed/util/diagnostic.h>

#include "infix.h"
#include "peer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

// Declarations are read first: slugs' compiler knows them all before it reads a formula. A line that is
// already in prefix notation is read as such, by the compiler's own test.

namespace heed::spec {
namespace {

using logic::Formula;
using logic::Op;

constexpr std::string_view overwrite_word = "LEASTSIGNIFICANTBITOVERWRITES";
constexpr std::array<std::string_view, 9> reserved{"X",     "F",    "G",    "U",           "W",
                                                   "FALSE", "TRUE", "next", overwrite_word};
constexpr std::array<std::string_view, 3> other_inputs{"[OBSERVABLE_INPUT]", "[UNOBSERVABLE_INPUT]",
                                                       "[CONTROLLABLE_INPUT]"};

bool begins_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '.';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool in_word(char c) {
  return begins_word(c) || is_digit(c) || c == '@' || c == '\'';
}

struct Known {
  model::Variable variable;
  bool input = false;
  std::size_t bits = 0;  ///< Of an integer.
};

std::size_t bits_for(const model::Domain& domain) {
  std::size_t bits = 0;
  while ((std::int64_t{1} << bits) < domain.size()) ++bits;
  return bits;
}

/// Bit \p bit of `variable - low`, as comparisons of the variable.
Formula bit_of(const Known& known, std::size_t bit, const Formula& value) {
  const model::Domain& domain = known.variable.domain;
  const std::int64_t block = std::int64_t{1} << bit;
  std::vector<Formula> parts;
  for (std::int64_t first = block; first < domain.size(); first += 2 * block) {
    const std::int64_t low = domain.low + first, high = low + block - 1;
    parts.push_back(joined_flat(Op::And, {Formula::make(Op::Ge, {value, logic::number(low)}),
                                          Formula::make(Op::Le, {value, logic::number(high)})}));
  }
  return joined_flat(Op::Or, std::move(parts));
}

class Reader {
 public:
  Reader(const util::SourceText& source, const util::Limits& limits)
      : source_(source),
        text_(source.text()),
        prefix_(source, limits,
                [this](std::string_view word, std::size_t begin) { return prefix_name(word, begin); }),
        infix_(source, limits, grammar()) {}

  Gr1 read() {
    spec_.name = stem_of(source_.name());
    for_each_line(source_, [this](std::size_t begin, std::size_t end) { collect(begin, end); });
    for (const Line& line : lines_) read_formula(line);
    return std::move(spec_);
  }

 private:
  struct Line {
    const SlugsSection* section;
    std::size_t begin, end;
  };

  void collect(std::size_t begin, std::size_t end) {
    const std::string_view line = text_.substr(begin, end - begin);
    if (line[0] == '[') {
      if (std::find(other_inputs.begin(), other_inputs.end(), line) != other_inputs.end())
        fail(begin, "not-supported", fmt::format("{} belongs to games with partial information", line),
             "they are outside GR(1)");
      section_ = find_section(source_, begin, line);
    } else if (section_ == nullptr) {
      fail(begin, "no-section", "a line outside any section", "begin with a section such as [INPUT]");
    } else if (section_->clauses != nullptr) {
      lines_.push_back({section_, begin, end});
    } else {
      declare(begin, line);
    }
  }

  void declare(std::size_t begin, std::string_view line) {
    const std::size_t colon = line.find(':');
    std::string name(line.substr(0, colon));
    while (!name.empty() && is_blank(name.back())) name.pop_back();
    const bool fits =
        !name.empty() && begins_word(name[0]) &&
        std::all_of(name.begin(), name.end(), [](char c) { return in_word(c) && c != '@' && c != '\''; });
    if (!fits || std::find(reserved.begin(), reserved.end(), name) != reserved.end())
      fail(begin, "name", fmt::format("'{}' cannot stand as a name", name),
           "a name begins with a letter, _ or . and goes on with these and digits; X F G U W next TRUE FALSE "
           "are reserved");
    Known known{{name, model::Domain::boolean(), {}, source_.at(begin)}, section_->input};
    if (colon != std::string_view::npos) {
      known.variable.domain = range(begin + colon + 1, line.substr(colon + 1));
      known.bits = bits_for(known.variable.domain);
    }
    add_variable(spec_, known.input, known.variable);
    names_.push_back(name);
    if (!known_.emplace(name, std::move(known)).second)
      fail(begin, "duplicate-name", fmt::format("the name '{}' is declared twice", name));
  }

  [[nodiscard]] model::Domain range(std::size_t begin, std::string_view text) const {
    const std::size_t dots = text.find("...");
    if (dots == std::string_view::npos)
      fail(begin, "type", "expected a range such as 0...10 after the colon");
    const std::int32_t low = number(begin, text.substr(0, dots));
    const std::int32_t high = number(begin + dots + 3, text.substr(dots + 3));
    if (low > high) fail(begin, "empty-range", fmt::format("the range {}...{} is empty", low, high));
    return model::Domain::integer(low, high);
  }

  [[nodiscard]] std::int32_t number(std::size_t begin, std::string_view text) const {
    while (!text.empty() && is_blank(text.front())) {
      text.remove_prefix(1);
      ++begin;
    }
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    std::int32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || error != std::errc() || end != text.data() + text.size())
      fail(begin, "number", "expected an integer of 32 bits");
    return value;
  }

  void read_formula(const Line& line) {
    section_ = line.section;
    primed_ = false;
    if (is_prefix(text_.substr(line.begin, line.end - line.begin))) {
      const Read read = prefix_.read(line.begin, line.end);
      return add_clauses(spec_, source_, *section_, read, line.end, prefix_.conjuncts());
    }
    end_ = line.end;
    std::size_t stop = 0;
    const Formula formula = infix_.read(line.begin, stop);
    add_clauses(spec_, source_, *section_, {formula, line.begin, primed_}, line.end, {});
  }

  /// Whether reading the words from right to left leaves one value: then slugs takes the line as it is.
  [[nodiscard]] bool is_prefix(std::string_view line) const {
    std::size_t values = 0;
    for (std::size_t end = line.size(); end > 0;) {
      std::size_t begin = end;
      while (begin > 0 && line[begin - 1] != ' ') --begin;
      const std::string_view word = line.substr(begin, end - begin);
      end = begin == 0 ? 0 : begin - 1;
      if (word == "$") return true;
      if (word == "|" || word == "&" || word == "^") {
        if (values < 2) return false;
        --values;
      } else if (word == "0" || word == "1" || is_bit(word)) {
        ++values;
      } else if (!word.empty() && word != "!" && line.find(" $ ") == std::string_view::npos &&
                 line.substr(0, 2) != "$ ") {
        return false;
      }
    }
    return values == 1;
  }

  /// A Boolean variable, or a bit of an integer, primed or not.
  [[nodiscard]] bool is_bit(std::string_view word) const {
    if (word.ends_with('\'')) word.remove_suffix(1);
    const auto found = known_.find(std::string(word.substr(0, word.find('@'))));
    if (found == known_.end()) return false;
    const bool integer = found->second.variable.domain.kind == model::Domain::Kind::Integer;
    return integer ? bit_index(found->second, word) < found->second.bits
                   : word.find('@') == std::string_view::npos;
  }

  /// Which bit of an integer a name such as `x@0.0.7` or `x@1` means; too large when it means none.
  [[nodiscard]] static std::size_t bit_index(const Known& known, std::string_view word) {
    const std::string& name = known.variable.name;
    const model::Domain& domain = known.variable.domain;
    if (word == fmt::format("{}@0.{}.{}", name, domain.low, domain.high)) return 0;
    for (std::size_t i = 1; i < known.bits; ++i)
      if (word == fmt::format("{}@{}", name, i)) return i;
    return known.bits;
  }

  [[nodiscard]] const Known& find(std::string_view word, std::size_t begin) const {
    const auto found = known_.find(std::string(word.substr(0, word.find('@'))));
    if (found == known_.end())
      fail(begin, "unknown-name", fmt::format("unknown variable '{}'", word), util::suggestion(word, names_));
    return found->second;
  }

  [[nodiscard]] Operand resolve(std::string_view word, std::size_t begin, bool next) {
    if (word == "TRUE" || word == "FALSE") return {logic::truth(word == "TRUE"), begin};
    bool primed = word.ends_with('\'');
    if (primed && next)
      fail(begin, "next-twice", fmt::format("'{}' is primed and stands below a next operator", word));
    const std::string_view name = word.substr(0, word.size() - (primed ? 1 : 0));
    const Known& known = find(name, begin);
    primed = primed || next;
    primed_ = primed_ || primed;
    check_place(source_, begin, *section_, word, known.input, primed);
    const model::Domain& domain = known.variable.domain;
    Formula value = Formula::make_name(known.variable.name, source_.at(begin));
    if (primed) value = Formula::make(Op::Next, {value}, source_.at(begin));
    if (domain.kind == model::Domain::Kind::Boolean || name.find('@') != std::string_view::npos) {
      if (!is_bit(name))
        fail(begin, "unknown-name", fmt::format("'{}' has no such bit", known.variable.name));
      const bool bit = domain.kind != model::Domain::Kind::Boolean;
      return {bit ? bit_of(known, bit_index(known, name), value) : value, begin};
    }
    Operand result{value, begin, true, true, domain.low, domain.high, known.bits};
    if (domain.low != 0) result.bits = bits_of_sum(known.bits, domain.low);
    return result;
  }

  /// slugs adds the lower bound to the encoded value.
  [[nodiscard]] static std::size_t bits_of_sum(std::size_t bits, std::int32_t low) {
    std::size_t other = 0;
    for (std::int32_t rest = low; rest > 0; rest >>= 1) ++other;
    return std::max(bits, other) + (bits != 0 && other != 0 ? 1 : 0);
  }

  [[nodiscard]] Read prefix_name(std::string_view word, std::size_t begin) {
    const std::string_view bare = word.ends_with('\'') ? word.substr(0, word.size() - 1) : word;
    const Operand value = resolve(word, begin, false);
    if (value.integer)
      fail(begin, "type", fmt::format("'{}' is an integer, and prefix notation knows its bits only", bare));
    return {value.formula, begin, word.size() != bare.size()};
  }

  [[nodiscard]] InfixGrammar grammar() {
    InfixGrammar grammar;
    grammar.lex = [this](std::size_t at) { return lex(at); };
    grammar.resolve = [this](std::string_view word, std::size_t begin, bool next) {
      return resolve(word, begin, next);
    };
    grammar.power = [](Sign sign) { return static_cast<int>(sign); };
    return grammar;
  }

  [[nodiscard]] Token lex(std::size_t at) const {
    while (at < end_ && is_blank(text_[at])) ++at;
    if (at >= end_) return {Sign::End, end_, end_};
    if (begins_word(text_[at])) return lex_word(at);
    if (is_digit(text_[at])) {
      std::size_t end = at;
      while (end < end_ && is_digit(text_[end])) ++end;
      return {Sign::Number, at, end};
    }
    return lex_sign(at);
  }

  [[nodiscard]] Token lex_word(std::size_t at) const {
    std::size_t end = at;
    while (end < end_ && in_word(text_[end])) ++end;
    const std::string_view word = text_.substr(at, end - at);
    if (word == "X" || word == "next") return {Sign::Next, at, end};
    if (word == overwrite_word) return {Sign::Overwrite, at, end};
    if (word == "F" || word == "G" || word == "U" || word == "W") refuse_temporal(at, word);
    return {Sign::Name, at, end};
  }

  [[nodiscard]] Token lex_sign(std::size_t at) const {
    struct Spelling {
      std::string_view text;
      Sign sign;
      bool square = false;
    };
    static constexpr std::array<Spelling, 25> spellings{
        {{"<-->", Sign::Iff}, {"<->", Sign::Iff}, {"-->", Sign::Implies}, {"->", Sign::Implies},
         {"()", Sign::Next},  {"[]", Sign::End},  {"<>", Sign::End},      {"/\\", Sign::And},
         {"\\/", Sign::Or},   {"&&", Sign::And},  {"||", Sign::Or},       {"!=", Sign::Ne},
         {"<=", Sign::Le},    {">=", Sign::Ge},   {"&", Sign::And},       {"|", Sign::Or},
         {"^", Sign::Xor},    {"!", Sign::Not},   {"~", Sign::Not},       {"=", Sign::Eq},
         {"<", Sign::Lt},     {">", Sign::Gt},    {"+", Sign::Plus},      {"(", Sign::Open},
         {")", Sign::Close}}};
    const std::string_view rest = text_.substr(at, end_ - at);
    for (const Spelling& spelling : spellings)
      if (rest.starts_with(spelling.text)) {
        if (spelling.sign == Sign::End) refuse_temporal(at, spelling.text);
        return {spelling.sign, at, at + spelling.text.size(), spelling.square};
      }
    if (rest[0] == '[') return {Sign::Open, at, at + 1, true};
    if (rest[0] == ']') return {Sign::Close, at, at + 1, true};
    if (rest[0] == '-' || rest[0] == '*' || rest[0] == '/')
      fail(at, "not-supported", fmt::format("slugs' compiler has no '{}' in its sums", rest[0]),
           "bring the term to the other side, or repeat it");
    fail(at, "syntax", fmt::format("'{}' is no part of a formula", rest[0]));
  }

  [[noreturn]] void refuse_temporal(std::size_t at, std::string_view word) const {
    fail(at, "temporal", fmt::format("the temporal operator '{}' in a part of a GR(1) specification", word),
         "the section already says always or again and again; only next is left to write");
  }

  [[noreturn]] void fail(std::size_t offset, std::string code, std::string message,
                         std::string hint = {}) const {
    throw util::InputError(source_, offset, std::move(code), std::move(message), std::move(hint));
  }

  const util::SourceText& source_;
  std::string_view text_;
  PrefixReader prefix_;
  InfixReader infix_;
  Gr1 spec_;
  const SlugsSection* section_ = nullptr;
  std::vector<Line> lines_;
  std::map<std::string, Known> known_;
  std::vector<std::string> names_;
  std::size_t end_ = 0;
  bool primed_ = false;  ///< The formula being read speaks of the next step.
};

}  // namespace

Gr1 read_structured_slugs(const util::SourceText& source, const util::Limits& limits) {
  check_size(source, limits);
  return Reader(source, limits).read();
}

}  // namespace heed::spec
