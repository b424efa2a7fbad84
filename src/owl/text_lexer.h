#pragma once

#include <heed/util/diagnostic.h>

#include <string>
#include <string_view>

namespace heed::owl {

/// The terminals that the functional-style and the Manchester syntax share: IRIs, names, strings, numbers.
class TextLexer {
 public:
  explicit TextLexer(const util::SourceText& source);

  /// Over white space and comments; the next character, 0 at the end.
  char peek();
  [[nodiscard]] bool at_end() { return peek() == '\0' && at_ >= text_.size(); }
  [[nodiscard]] std::size_t offset() const { return at_; }
  [[nodiscard]] char ahead(std::size_t by = 0) const {
    return at_ + by < text_.size() ? text_[at_ + by] : '\0';
  }
  /// Takes \p c where it comes next.
  bool take(char c);
  void expect(char c, std::string_view what);
  void go_back(std::size_t offset) { at_ = offset; }

  std::string_view iri();  ///< \pre at '<'. Between the brackets.
  std::string string();    ///< \pre at '"'. With \" and \\ resolved; may span lines.
  /// Up to white space or one of ()<>{}[],"@^=# ; empty where none comes.
  std::string_view word();
  /// The word that word() would take.
  std::string_view next_word();
  /// Over one token of whatever kind. \pre not at_end()
  void skip();
  std::string_view language();  ///< \pre at '@'

  [[noreturn]] void fail(std::size_t offset, const char* code, std::string message,
                         std::string hint = {}) const {
    throw util::InputError(source_, offset, code, std::move(message), std::move(hint));
  }
  /// "'x'", or "the end of the document".
  [[nodiscard]] std::string found() const;

 private:
  const util::SourceText& source_;
  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace heed::owl
