#pragma once

#include <heed/util/diagnostic.h>

#include <string>
#include <string_view>

namespace heed::owl {

/// The terminals of Turtle (RDF 1.1 Turtle, section 6.5) over one text.
class TurtleLexer {
 public:
  explicit TurtleLexer(const util::SourceText& source) : source_(source), text_(source.text()) {}

  /// Over white space and comments; the next character, 0 at the end.
  char peek();
  [[nodiscard]] std::size_t offset() const { return at_; }
  [[nodiscard]] char ahead(std::size_t by) const { return at_ + by < text_.size() ? text_[at_ + by] : '\0'; }
  void advance(std::size_t by = 1) { at_ += by; }
  /// Takes \p word when it stands here and no name goes on behind it.
  bool take_word(std::string_view word, bool any_case = false);
  void expect(char c, std::string_view what);

  std::string iri_reference();      ///< \pre at '<'; escapes resolved, relative as written
  std::string_view blank_label();   ///< \pre at "_:"
  std::string string_literal();     ///< \pre at a quote, short or long
  std::string_view language_tag();  ///< \pre at '@'
  /// A prefixed name: the prefix without its colon, and the local part with its escapes resolved.
  std::string_view prefix();
  std::string local_name();
  struct Number {
    std::string_view text;
    enum class Type { Integer, Decimal, Double } type;
  };
  Number number();  ///< \pre at a digit, a sign or a point

  [[noreturn]] void fail(std::size_t offset, const char* code, std::string message,
                         std::string hint = {}) const {
    throw util::InputError(source_, offset, code, std::move(message), std::move(hint));
  }

 private:
  void escape(std::string& out, bool names_only);
  const util::SourceText& source_;
  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace heed::owl
