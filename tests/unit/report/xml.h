#pragma once

#include <cctype>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

/// Is a text well-formed XML? Stricter than readers that forgive; knows elements, attributes, the five
/// entities and character references, a doctype without subset. Nothing else may appear.
namespace heed::report::test {

class XmlReader {
 public:
  explicit XmlReader(std::string_view text) : text_(text) {}

  /// The first flaw, or nothing.
  std::string flaw() {
    if (text_.starts_with("<!DOCTYPE html>")) at_ = text_.find('>') + 1;
    while (at_ < text_.size() && flaw_.empty()) {
      if (text_[at_] == '<')
        tag();
      else if (text_[at_] == '&')
        entity();
      else if (static_cast<unsigned char>(text_[at_]) < 0x20 && text_[at_] != '\n' && text_[at_] != '\t')
        fail("control character");
      else
        ++at_;
    }
    if (flaw_.empty() && !open_.empty()) fail("open: " + open_.back());
    return flaw_;
  }

 private:
  void fail(const std::string& what) {
    if (flaw_.empty()) flaw_ = what + " at " + std::to_string(at_);
  }

  std::string name() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '-'))
      ++at_;
    if (begin == at_) fail("name expected");
    return std::string(text_.substr(begin, at_ - begin));
  }

  void entity() {
    const std::size_t end = text_.find(';', at_);
    const std::string_view word = end == std::string_view::npos ? "" : text_.substr(at_ + 1, end - at_ - 1);
    static const std::set<std::string_view> known{"amp", "lt", "gt", "quot", "apos", "#39"};
    if (!known.contains(word)) return fail("entity");
    at_ = end + 1;
  }

  void attribute(std::set<std::string>& seen) {
    if (!seen.insert(name()).second) fail("attribute twice");
    if (text_.substr(at_, 2) != "=\"") return fail("quoted value expected");
    at_ += 2;
    while (at_ < text_.size() && text_[at_] != '"' && flaw_.empty()) {
      if (text_[at_] == '<') fail("< in a value");
      if (text_[at_] == '&')
        entity();
      else
        ++at_;
    }
    ++at_;
  }

  void tag() {
    ++at_;
    if (text_.substr(at_, 1) == "/") {
      ++at_;
      const std::string closed = name();
      if (open_.empty() || open_.back() != closed) return fail("closes " + closed);
      open_.pop_back();
    } else {
      const std::string opened = name();
      std::set<std::string> seen;
      while (text_.substr(at_, 1) == " " && flaw_.empty()) {
        ++at_;
        attribute(seen);
      }
      if (text_.substr(at_, 1) == "/")
        ++at_;
      else
        open_.push_back(opened);
    }
    if (text_.substr(at_, 1) != ">") return fail("> expected");
    ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<std::string> open_;
  std::string flaw_;
};

inline std::string flaw(std::string_view text) {
  return XmlReader(text).flaw();
}

}  // namespace heed::report::test
