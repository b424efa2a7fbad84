#include "text_lexer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace heed::owl {
namespace {

constexpr std::array<bool, 256> make_ends() {
  std::array<bool, 256> out{};
  for (std::size_t c = 0; c <= 0x20; ++c) out[c] = true;
  for (const char c : std::string_view("()<>{}[],\"@^=#")) out[static_cast<unsigned char>(c)] = true;
  return out;
}
constexpr std::array<bool, 256> ends_word = make_ends();

}  // namespace

TextLexer::TextLexer(const util::SourceText& source) : source_(source), text_(source.text()) {
  if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
}

char TextLexer::peek() {
  while (at_ < text_.size()) {
    const char c = text_[at_];
    if (c == '#')
      at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
    else if (c == ' ' || c == '\t' || c == '\r' || c == '\n')
      ++at_;
    else
      return c;
  }
  return '\0';
}

bool TextLexer::take(char c) {
  if (peek() != c || at_ >= text_.size()) return false;
  ++at_;
  return true;
}

void TextLexer::expect(char c, std::string_view what) {
  if (!take(c)) fail(at_, "syntax", fmt::format("expected '{}' {}, found {}", c, what, found()));
}

std::string TextLexer::found() const {
  if (at_ >= text_.size()) return "the end of the document";
  std::size_t end = at_;
  while (end < text_.size() && end < at_ + 40 && !ends_word[static_cast<unsigned char>(text_[end])]) ++end;
  if (end == at_) {
    const auto c = static_cast<unsigned char>(text_[at_]);
    if (c < 0x20) return fmt::format("character {}", c);
    ++end;
  }
  return fmt::format("'{}'", text_.substr(at_, end - at_));
}

std::string_view TextLexer::iri() {
  const std::size_t begin = ++at_;
  for (; at_ < text_.size() && text_[at_] != '>'; ++at_) {
    const char c = text_[at_];
    if (static_cast<unsigned char>(c) <= 0x20 || c == '<' || c == '"')
      fail(at_, "bad-iri",
           static_cast<unsigned char>(c) <= 0x20 ? std::string("an IRI holds no white space")
                                                 : fmt::format("an IRI holds no '{}'", c),
           "an IRI ends with '>'; write %20 for a blank");
  }
  if (at_ >= text_.size()) fail(begin - 1, "bad-iri", "the IRI has no closing '>'");
  return text_.substr(begin, at_++ - begin);
}

std::string TextLexer::string() {
  const std::size_t begin = at_++;
  std::string out;
  for (;;) {
    const std::size_t stop = text_.find_first_of("\"\\", at_);
    if (stop == std::string_view::npos) fail(begin, "open-string", "the string has no end");
    out.append(text_, at_, stop - at_);
    at_ = stop + 1;
    if (text_[stop] == '"') return out;
    const char next = ahead();
    if (next == '"' || next == '\\')
      out += next, ++at_;
    else
      out += '\\';
  }
}

std::string_view TextLexer::word() {
  peek();
  const std::size_t begin = at_;
  while (at_ < text_.size() && !ends_word[static_cast<unsigned char>(text_[at_])]) ++at_;
  return text_.substr(begin, at_ - begin);
}

std::string_view TextLexer::next_word() {
  peek();
  const std::size_t begin = at_;
  const std::string_view out = word();
  at_ = begin;
  return out;
}

void TextLexer::skip() {
  const char c = peek();
  if (c == '"') {
    string();
  } else if (c == '<') {
    const std::size_t end = text_.find_first_of(" \t\r\n<\">", at_ + 1);
    at_ = end != std::string_view::npos && text_[end] == '>' ? end + 1 : at_ + 1;
  } else if (word().empty()) {
    ++at_;
  }
}

std::string_view TextLexer::language() {
  const std::size_t begin = ++at_;
  const auto is_part = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
  };
  while (is_part(ahead())) ++at_;
  if (at_ == begin) fail(begin, "syntax", "expected a language behind '@'", "such as @en");
  return text_.substr(begin, at_ - begin);
}

}  // namespace heed::owl
