#include "markup.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "format.h"

namespace heed::report {

namespace {

/// Blank space before these would show; before all others a line feed keeps the source readable.
bool is_inline(std::string_view tag) {
  constexpr std::array<std::string_view, 16> tags{"a",     "abbr",   "b",    "code", "em",  "i",
                                                  "small", "span",   "sub",  "sup",  "var", "bdi",
                                                  "tspan", "strong", "time", "kbd"};
  return std::find(tags.begin(), tags.end(), tag) != tags.end();
}

}  // namespace

std::string escape(std::string_view text) {
  std::string result;
  for (const char c : clean(text)) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string coordinate(double value) {
  return compact(value, 2);
}

Markup::Attributes with_data(Markup::Attributes attributes, std::string path, double value) {
  attributes.emplace_back("data-path", std::move(path));
  attributes.emplace_back("data-value", shortest(value));
  return attributes;
}

void Markup::start(std::string_view tag, const Attributes& attributes) {
  if (!is_inline(tag)) out_ += '\n';
  out_ += '<';
  out_ += tag;
  for (const auto& [name, value] : attributes) {
    out_ += ' ';
    out_ += name;
    out_ += "=\"" + escape(value) + '"';
  }
}

void Markup::open(std::string_view tag, const Attributes& attributes) {
  start(tag, attributes);
  out_ += '>';
  open_.emplace_back(tag);
}

void Markup::close() {
  assert(!open_.empty());
  out_ += "</" + open_.back() + '>';
  open_.pop_back();
}

Markup::Scope Markup::scope(std::string_view tag, const Attributes& attributes) {
  open(tag, attributes);
  return Scope(*this);
}

void Markup::element(std::string_view tag, std::string_view content, const Attributes& attributes) {
  open(tag, attributes);
  text(content);
  close();
}

void Markup::leaf(std::string_view tag, const Attributes& attributes) {
  start(tag, attributes);
  out_ += "/>";
}

void Markup::text(std::string_view content) {
  out_ += escape(content);
}

std::string Markup::finish() {
  assert(open_.empty());
  return std::move(out_) + '\n';
}

}  // namespace heed::report
