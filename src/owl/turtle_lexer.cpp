#include "turtle_lexer.h"

#include "utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

namespace heed::owl {
namespace {

/// Characters of PN_CHARS; what lies beyond ASCII is taken as one.
bool is_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' ||
         static_cast<unsigned char>(c) >= 0x80;
}

bool same_letter(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

}  // namespace

char TurtleLexer::peek() {
  while (at_ < text_.size()) {
    const char c = text_[at_];
    if (c == '#') {
      at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
    } else if (c == ' ' || c == '\t' || c == '\r' || c == '\n') {
      ++at_;
    } else {
      return c;
    }
  }
  return '\0';
}

bool TurtleLexer::take_word(std::string_view word, bool any_case) {
  const std::string_view here = text_.substr(at_, word.size());
  if (here.size() != word.size()) return false;
  if (any_case ? !std::equal(here.begin(), here.end(), word.begin(), same_letter) : here != word)
    return false;
  const char next = ahead(word.size());
  if (is_name(next) || next == ':') return false;
  at_ += word.size();
  return true;
}

void TurtleLexer::expect(char c, std::string_view what) {
  if (peek() != c) fail(at_, "turtle-syntax", fmt::format("expected '{}' {}", c, what));
  ++at_;
}

void TurtleLexer::escape(std::string& out, bool names_only) {
  const std::size_t begin = at_++;
  const char kind = ahead(0);
  ++at_;
  if (kind == 'u' || kind == 'U') {
    const std::string_view digits = text_.substr(at_, kind == 'u' ? 4 : 8);
    std::uint32_t code = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    if (error != std::errc() || end != digits.data() + (kind == 'u' ? 4 : 8) || !is_scalar_value(code))
      fail(begin, "bad-escape", "the escape is no Unicode character",
           "write \\u and four, or \\U and eight hexadecimal digits");
    at_ += digits.size();
    return append_utf8(code, out);
  }
  constexpr std::string_view letters = "tbnrf\"'\\";
  constexpr std::string_view meanings = "\t\b\n\r\f\"'\\";
  const std::size_t which = letters.find(kind);
  if (names_only || which == std::string_view::npos || kind == '\0')
    fail(begin, "bad-escape", "unknown escape",
         "known: \\t \\b \\n \\r \\f \\\" \\' \\\\ \\uXXXX \\UXXXXXXXX");
  out += meanings[which];
}

std::string TurtleLexer::iri_reference() {
  const std::size_t begin = at_++;
  std::string out;
  for (;;) {
    const char c = ahead(0);
    if (c == '>') return ++at_, out;
    if (c == '\\') {
      escape(out, true);
    } else if (static_cast<unsigned char>(c) <= 0x20 ||
               std::string_view("<\"{}|^`").find(c) != std::string_view::npos) {
      if (at_ >= text_.size()) fail(begin, "bad-iri", "the IRI has no closing '>'");
      fail(at_, "bad-iri",
           static_cast<unsigned char>(c) <= 0x20 ? std::string("an IRI holds no white space")
                                                 : fmt::format("an IRI holds no '{}'", c),
           "write %20 for a blank; an IRI ends with '>'");
    } else {
      out += c;
      ++at_;
    }
  }
}

std::string_view TurtleLexer::blank_label() {
  at_ += 2;
  const std::size_t begin = at_;
  while (is_name(ahead(0)) || ahead(0) == '.') ++at_;
  while (at_ > begin && text_[at_ - 1] == '.') --at_;
  if (at_ == begin) fail(begin, "turtle-syntax", "expected the name of a blank node behind '_:'");
  return text_.substr(begin, at_ - begin);
}

std::string TurtleLexer::string_literal() {
  const std::size_t begin = at_;
  const char quote = ahead(0);
  const bool is_long = ahead(1) == quote && ahead(2) == quote;
  at_ += is_long ? 3 : 1;
  std::string out;
  for (;;) {
    if (at_ >= text_.size()) fail(begin, "open-string", "the string has no end");
    const char c = text_[at_];
    if (c == quote && (!is_long || (ahead(1) == quote && ahead(2) == quote))) break;
    if (!is_long && (c == '\n' || c == '\r'))
      fail(begin, "open-string", "the string does not end on its line",
           "put a string of several lines in three quotes");
    if (c == '\\') {
      escape(out, false);
    } else {
      out += c;
      ++at_;
    }
  }
  at_ += is_long ? 3 : 1;
  return out;
}

std::string_view TurtleLexer::language_tag() {
  const std::size_t begin = ++at_;
  while (std::isalnum(static_cast<unsigned char>(ahead(0))) != 0 || (ahead(0) == '-' && at_ > begin)) ++at_;
  if (at_ == begin) fail(begin, "turtle-syntax", "expected a language behind '@'", "such as @en");
  return text_.substr(begin, at_ - begin);
}

std::string_view TurtleLexer::prefix() {
  const std::size_t begin = at_;
  while (is_name(ahead(0)) || (ahead(0) == '.' && at_ > begin)) ++at_;
  if (ahead(0) != ':') {
    const std::string_view found =
        text_.substr(begin, std::max<std::size_t>(at_ - begin, begin < text_.size() ? 1 : 0));
    at_ = begin;
    if (found.empty())
      fail(begin, "turtle-syntax", "the document ends in the middle of a statement",
           "a statement ends with '.'");
    fail(begin, "turtle-syntax",
         fmt::format("expected an IRI, a name, a literal, '[' or '(', found '{}'", found),
         "a name has a prefix with ':', an IRI stands in <>");
  }
  ++at_;
  return text_.substr(begin, at_ - 1 - begin);
}

std::string TurtleLexer::local_name() {
  std::string out;
  for (;;) {
    const char c = ahead(0);
    if (is_name(c) || c == ':' || c == '%') {
      out += c;
      ++at_;
    } else if (c == '.' && (is_name(ahead(1)) || ahead(1) == ':' || ahead(1) == '.' || ahead(1) == '%' ||
                            ahead(1) == '\\')) {
      std::size_t next = 1;
      while (ahead(next) == '.') ++next;
      if (!is_name(ahead(next)) && ahead(next) != ':' && ahead(next) != '%' && ahead(next) != '\\')
        return out;
      out.append(next, '.');
      at_ += next;
    } else if (c == '\\' &&
               std::string_view("_~.-!$&'()*+,;=/?#@%").find(ahead(1)) != std::string_view::npos) {
      out += ahead(1);
      at_ += 2;
    } else {
      return out;
    }
  }
}

TurtleLexer::Number TurtleLexer::number() {
  const std::size_t begin = at_;
  const auto digits = [&] {
    const std::size_t first = at_;
    while (std::isdigit(static_cast<unsigned char>(ahead(0))) != 0) ++at_;
    return at_ - first;
  };
  auto type = Number::Type::Integer;
  if (ahead(0) == '+' || ahead(0) == '-') ++at_;
  std::size_t count = digits();
  const bool exponent_follows = ahead(1) == 'e' || ahead(1) == 'E';
  if (ahead(0) == '.' &&
      (std::isdigit(static_cast<unsigned char>(ahead(1))) != 0 || (count > 0 && exponent_follows))) {
    ++at_;
    count += digits();
    type = Number::Type::Decimal;
  }
  if (count == 0) fail(begin, "turtle-syntax", "expected a number");
  if (ahead(0) == 'e' || ahead(0) == 'E') {
    ++at_;
    if (ahead(0) == '+' || ahead(0) == '-') ++at_;
    if (digits() == 0) fail(begin, "turtle-syntax", "the number has an exponent without digits");
    type = Number::Type::Double;
  }
  return {text_.substr(begin, at_ - begin), type};
}

}  // namespace heed::owl
