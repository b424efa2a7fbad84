#include "lexer.h"

#include <fmt/format.h>
#include <heed/util/diagnostic.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

namespace heed::logic {
namespace {

struct Spelling {
  std::string_view text;
  Op op;
};

// Longer spellings first: the first that fits is taken.
constexpr std::array symbols{
    Spelling{"<->", Op::Iff},        Spelling{"->", Op::Implies},    Spelling{"&&", Op::And},
    Spelling{"||", Op::Or},          Spelling{"[]", Op::Always},     Spelling{"<>", Op::Eventually},
    Spelling{"!=", Op::Ne},          Spelling{"<=", Op::Le},         Spelling{">=", Op::Ge},
    Spelling{"\u2227", Op::And},     Spelling{"\u2228", Op::Or},     Spelling{"\u00ac", Op::Not},
    Spelling{"\u25cb", Op::Next},    Spelling{"\u25a1", Op::Always}, Spelling{"\u25c7", Op::Eventually},
    Spelling{"\u2192", Op::Implies}, Spelling{"\u2194", Op::Iff},    Spelling{"\u2260", Op::Ne},
    Spelling{"\u2264", Op::Le},      Spelling{"\u2265", Op::Ge},     Spelling{"&", Op::And},
    Spelling{"|", Op::Or},           Spelling{"!", Op::Not},         Spelling{"~", Op::Not},
    Spelling{"=", Op::Eq},           Spelling{"<", Op::Lt},          Spelling{">", Op::Gt},
    Spelling{"+", Op::Add},          Spelling{"-", Op::Sub},         Spelling{"*", Op::Mul}};

constexpr std::array letters{Spelling{"X", Op::Next},       Spelling{"G", Op::Always},
                             Spelling{"F", Op::Eventually}, Spelling{"Y", Op::Previous},
                             Spelling{"O", Op::Once},       Spelling{"H", Op::Historically},
                             Spelling{"U", Op::Until},      Spelling{"W", Op::WeakUntil},
                             Spelling{"R", Op::Release},    Spelling{"S", Op::Since}};

struct Mistake {
  std::string_view text, hint;
};

constexpr std::array mistakes{Mistake{"<=>", "write <->"},
                              Mistake{"=>", "write ->"},
                              Mistake{"==", "write ="},
                              Mistake{"=<", "write <="},
                              Mistake{"<-", "write b -> a for a <- b"},
                              Mistake{"/=", "write !="},
                              Mistake{"/\\", "write &"},
                              Mistake{"\\/", "write |"},
                              Mistake{"^", "write !(a <-> b)"},
                              Mistake{":=", "write ="},
                              Mistake{";", "write one formula, joined by &"}};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// One code point at the start of a text; nothing when it is not UTF-8.
struct CodePoint {
  std::uint32_t value = 0;
  std::size_t bytes = 0;
};

std::optional<CodePoint> decode(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i]));
  };
  const std::uint32_t head = byte(0);
  if (head < 0x80) return CodePoint{head, 1};
  const std::size_t bytes = head >= 0xf0 ? 4 : head >= 0xe0 ? 3 : 2;
  if (head < 0xc2 || head > 0xf4 || text.size() < bytes) return std::nullopt;
  std::uint32_t value = head & (0x7fU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0U) != 0x80) return std::nullopt;
    value = (value << 6U) | (byte(i) & 0x3fU);
  }
  const bool overlong = (bytes == 3 && value < 0x800) || (bytes == 4 && value < 0x10000);
  if (overlong || value > 0x10ffff || (value >= 0xd800 && value <= 0xdfff)) return std::nullopt;
  return CodePoint{value, bytes};
}

// NameStartChar and NameChar of XML 1.0 beyond ASCII: a stable definition of "letter" without a Unicode
// library.
bool is_letter(std::uint32_t c) {
  using Range = std::pair<std::uint32_t, std::uint32_t>;
  constexpr std::array<Range, 13> ranges{{{0xc0, 0xd6},
                                          {0xd8, 0xf6},
                                          {0xf8, 0x2ff},
                                          {0x370, 0x37d},
                                          {0x37f, 0x1fff},
                                          {0x200c, 0x200d},
                                          {0x2070, 0x218f},
                                          {0x2c00, 0x2fef},
                                          {0x3001, 0xd7ff},
                                          {0xf900, 0xfdcf},
                                          {0xfdf0, 0xfffd},
                                          {0x10000, 0xeffff},
                                          {'_', '_'}}};
  if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')) return true;
  return std::any_of(ranges.begin(), ranges.end(), [c](Range r) { return c >= r.first && c <= r.second; });
}

bool is_name_part(std::uint32_t c) {
  return is_letter(c) || (c >= '0' && c <= '9') || c == '.' || c == 0xb7 || (c >= 0x300 && c <= 0x36f);
}

/// Bytes of the unquoted name at the start of \p text; 0 when none starts there.
std::size_t name_length(std::string_view text) {
  std::size_t length = 0;
  while (length < text.size()) {
    const auto c = decode(text.substr(length));
    if (!c || !(length == 0 ? is_letter(c->value) : is_name_part(c->value))) break;
    length += c->bytes;
  }
  return length;
}

}  // namespace

bool is_reserved(std::string_view word) {
  const auto spells = [word](const Spelling& s) { return s.text == word; };
  return word == "GF" || word == "true" || word == "false" ||
         std::any_of(letters.begin(), letters.end(), spells);
}

bool is_plain_name(std::string_view word) {
  return !word.empty() && name_length(word) == word.size() && !is_reserved(word);
}

void Lexer::skip_space() {
  const std::string& text = source_.text();
  while (offset_ < text.size() &&
         std::string_view(" \t\r\n\f\v").find(text[offset_]) != std::string_view::npos)
    ++offset_;
}

Token Lexer::take(Token token, std::size_t bytes) {
  token.offset = offset_;
  if (token.text.empty()) token.text = std::string(rest().substr(0, bytes));
  offset_ += bytes;
  return token;
}

Token Lexer::next(bool operand_expected) {
  skip_space();
  const std::string_view text = rest();
  if (text.empty()) return take({Token::Kind::End}, 0);
  const char c = text[0];
  if (c == '(') return take({Token::Kind::Open}, 1);
  if (c == ')') return take({Token::Kind::Close}, 1);
  if (c == '\'') return take({Token::Kind::Prime}, 1);
  if (c == '"') return read_quoted();
  const bool negative = operand_expected && c == '-' && text.size() > 1 && is_digit(text[1]);
  if (negative || is_digit(c)) return read_number();
  if (name_length(text) > 0) return read_name();
  return read_symbol();
}

Token Lexer::read_number() {
  const std::string_view text = rest();
  Token token{Token::Kind::Number};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), token.number);
  if (error != std::errc())
    throw util::InputError(source_, offset_, "number", "the number does not fit 64 bits",
                           "numbers range from -9223372036854775808 to 9223372036854775807");
  const auto bytes = static_cast<std::size_t>(end - text.data());
  if (name_length(text.substr(bytes)) > 0)
    throw util::InputError(source_, offset_, "name", "a name cannot start with a digit",
                           "quote it, or start it with a letter or _");
  return take(std::move(token), bytes);
}

Token Lexer::read_name() {
  const std::size_t length = name_length(rest());
  const std::string_view word = rest().substr(0, length);
  if (word == "true") return take({Token::Kind::True}, length);
  if (word == "false") return take({Token::Kind::False}, length);
  if (word == "GF") return take({Token::Kind::Operator, Op::Always, true}, length);
  for (const Spelling& letter : letters)
    if (letter.text == word) return take({Token::Kind::Operator, letter.op}, length);
  return take({Token::Kind::Name}, length);
}

Token Lexer::read_quoted() {
  const std::string_view text = rest();
  Token token{Token::Kind::Name};
  std::size_t i = 1;
  while (i < text.size() && text[i] != '"' && static_cast<unsigned char>(text[i]) >= ' ') {
    const bool escape = text[i] == '\\';
    if (escape && (i + 1 == text.size() || (text[i + 1] != '"' && text[i + 1] != '\\')))
      throw util::InputError(source_, offset_ + i, "name", "unknown escape in a quoted name",
                             "only \\\" and \\\\ are known");
    if (escape) ++i;
    const auto c = decode(text.substr(i));
    if (!c) throw util::InputError(source_, offset_ + i, "encoding", "the text is not UTF-8");
    token.text += text.substr(i, c->bytes);
    i += c->bytes;
  }
  if (i >= text.size() || text[i] != '"')
    throw util::InputError(source_, offset_, "name", "the quoted name has no closing quote on its line",
                           "add \" where the name ends");
  if (token.text.empty()) throw util::InputError(source_, offset_, "name", "a quoted name is empty");
  return take(std::move(token), i + 1);
}

Token Lexer::read_symbol() {
  const auto starts = [text = rest()](std::string_view s) { return text.substr(0, s.size()) == s; };
  // `a < -3` without a space is a comparison, not the arrow that other languages have.
  const bool less_than_negative = starts("<-") && rest().size() > 2 && is_digit(rest()[2]);
  const bool equivalence = starts("<->");
  for (const Mistake& mistake : mistakes)
    if (starts(mistake.text) && !equivalence && !(mistake.text == "<-" && less_than_negative))
      refuse_symbol();
  for (const Spelling& symbol : symbols)
    if (starts(symbol.text)) return take({Token::Kind::Operator, symbol.op}, symbol.text.size());
  refuse_symbol();
}

void Lexer::refuse_symbol() const {
  for (const Mistake& mistake : mistakes)
    if (rest().substr(0, mistake.text.size()) == mistake.text)
      throw util::InputError(source_, offset_, "syntax",
                             fmt::format("'{}' is no operator here", mistake.text),
                             std::string(mistake.hint));
  const auto c = decode(rest());
  if (!c) throw util::InputError(source_, offset_, "encoding", "the text is not UTF-8");
  if (c->value < ' ' || c->value == 0x7f)
    throw util::InputError(source_, offset_, "syntax", "a control character cannot stand in a formula");
  throw util::InputError(source_, offset_, "syntax",
                         fmt::format("'{}' cannot stand in a formula", rest().substr(0, c->bytes)),
                         "names with other characters are quoted: \"a-b\"");
}

}  // namespace heed::logic
