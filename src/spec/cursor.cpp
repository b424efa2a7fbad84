#include "cursor.h"

#include <heed/logic/parse.h>
#include <heed/util/diagnostic.h>

#include "words.h"

#include <fmt/format.h>

#include <charconv>

namespace heed::spec {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_lower_or_upper(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Every byte that a formula's reader could take as part of an unquoted name; it is the one to refuse exotic
/// letters.
bool is_name_byte(char c) {
  return is_lower_or_upper(c) || is_digit(c) || c == '_' || c == '.' || static_cast<unsigned char>(c) >= 0x80;
}

}  // namespace

void Cursor::skip_blanks() {
  while (at_ < end_ && (source_.text()[at_] == ' ' || source_.text()[at_] == '\t')) ++at_;
}

bool Cursor::done() {
  skip_blanks();
  return at_ == end_;
}

bool Cursor::accept(std::string_view text) {
  skip_blanks();
  if (rest().substr(0, text.size()) != text) return false;
  at_ += text.size();
  return true;
}

void Cursor::expect(std::string_view text, const std::string& where) {
  if (!accept(text)) fail("syntax", fmt::format("expected '{}' {}", text, where));
}

void Cursor::expect_end() {
  if (!done()) fail("syntax", "expected the end of the line");
}

std::string Cursor::word() {
  skip_blanks();
  std::size_t length = 0;
  while (length < rest().size() &&
         (is_lower_or_upper(rest()[length]) || rest()[length] == '-' || rest()[length] == '_'))
    ++length;
  std::string out(rest().substr(0, length));
  at_ += length;
  return out;
}

std::string Cursor::name(const std::string& what) {
  skip_blanks();
  if (!rest().empty() && rest()[0] == '"') return quoted();
  std::size_t length = 0;
  while (length < rest().size() && is_name_byte(rest()[length])) ++length;
  std::string text(rest().substr(0, length));
  if (length == 0)
    fail("syntax", fmt::format("expected {}", what), "a name starts with a letter or _, or is quoted");
  if (quoted_name(text) != text)
    fail("syntax", fmt::format("'{}' cannot stand as a name", text),
         fmt::format("it is reserved or starts with no letter: quote it, \"{}\"", text));
  at_ += length;
  return text;
}

std::string Cursor::quoted() {
  skip_blanks();
  const std::size_t start = at_;
  if (!accept("\"")) fail("syntax", "expected a text in quotation marks");
  std::string out;
  for (; at_ < end_ && source_.text()[at_] != '"'; ++at_) {
    char c = source_.text()[at_];
    if (c == '\\') {
      if (++at_ == end_) break;
      c = source_.text()[at_];
      if (c != '"' && c != '\\' && c != 'n')
        fail("syntax", "unknown escape", "only \\\", \\\\ and \\n are known");
      if (c == 'n') c = '\n';
    }
    out += c;
  }
  if (!accept("\"")) fail_at(start, "syntax", "the text has no closing quotation mark on its line");
  return out;
}

bool Cursor::at_integer() {
  skip_blanks();
  const std::string_view text = rest();
  return !text.empty() && (is_digit(text[0]) || (text[0] == '-' && text.size() > 1 && is_digit(text[1])));
}

std::int32_t Cursor::integer() {
  if (!at_integer()) fail("syntax", "expected an integer");
  std::int32_t out = 0;
  const auto [end, error] = std::from_chars(rest().data(), rest().data() + rest().size(), out);
  if (error != std::errc()) fail("number", "the number does not fit 32 bits");
  at_ += static_cast<std::size_t>(end - rest().data());
  return out;
}

model::Domain Cursor::type() {
  skip_blanks();
  const std::size_t start = at_;
  if (at_integer()) {
    const std::int32_t low = integer();
    expect("..", "between the bounds of a range");
    const std::int32_t high = integer();
    if (low > high) fail_at(start, "empty-range", fmt::format("the range {}..{} is empty", low, high));
    return model::Domain::integer(low, high);
  }
  if (accept("{")) {
    std::vector<std::string> values;
    do {
      values.push_back(name("a value of the enumeration"));
    } while (accept(","));
    expect("}", "after the values of an enumeration");
    return model::Domain::enumeration(std::move(values));
  }
  if (const std::string found = word(); found != "boolean")
    fail_at(start, "type", found.empty() ? "expected a type" : fmt::format("unknown type '{}'", found),
            "types are boolean, 0..4, {a, b}");
  return model::Domain::boolean();
}

std::int32_t Cursor::value(const model::Domain& domain) {
  skip_blanks();
  const std::size_t start = at_;
  if (domain.kind == model::Domain::Kind::Integer) {
    const std::int32_t code = integer();
    if (code < domain.low || code > domain.high)
      fail_at(start, "value", fmt::format("{} is outside {}..{}", code, domain.low, domain.high));
    return code;
  }
  const bool boolean = domain.kind == model::Domain::Kind::Boolean;
  const std::string text = boolean ? word() : name("a value");
  if (const auto code = domain.read(text)) return *code;
  fail_at(start, "value", fmt::format("'{}' is no value here", text),
          boolean ? "write true or false" : util::suggestion(text, domain.values));
}

logic::Formula Cursor::formula() {
  skip_blanks();
  const util::Location start = location();
  const util::SourceText text(source_.name(), std::string(rest()), start.line, start.column);
  at_ = end_;
  return logic::parse(text, limits_);
}

void Cursor::fail(std::string code, std::string message, std::string hint) const {
  fail_at(at_, std::move(code), std::move(message), std::move(hint));
}

void Cursor::fail_at(std::size_t offset, std::string code, std::string message, std::string hint) const {
  throw util::InputError(source_, offset, std::move(code), std::move(message), std::move(hint));
}

}  // namespace heed::spec
