#pragma once

#include <heed/logic/formula.h>
#include <heed/model/variable.h>
#include <heed/util/limits.h>
#include <heed/util/source.h>

#include <optional>
#include <string>
#include <string_view>

namespace heed::spec {

/// Reads along one line of a `.gr1` file. Every failure is an InputError at the place where it is.
class Cursor {
 public:
  Cursor(const util::SourceText& source, std::size_t begin, std::size_t end, const util::Limits& limits)
      : source_(source), at_(begin), end_(end), limits_(limits) {}

  [[nodiscard]] bool done();
  [[nodiscard]] std::size_t offset() const { return at_; }
  [[nodiscard]] util::Location location() const { return source_.at(at_); }
  /// Takes \p text if it comes next, after blanks.
  [[nodiscard]] bool accept(std::string_view text);
  void expect(std::string_view text, const std::string& where);
  void expect_end();
  /// A word of letters and dashes as keys and attributes have; empty if none comes.
  [[nodiscard]] std::string word();
  [[nodiscard]] std::string name(const std::string& what);
  [[nodiscard]] std::string quoted();
  [[nodiscard]] std::int32_t integer();
  [[nodiscard]] model::Domain type();
  /// A value of \p domain as its code.
  [[nodiscard]] std::int32_t value(const model::Domain& domain);
  /// The rest of the line.
  [[nodiscard]] logic::Formula formula();

  [[noreturn]] void fail(std::string code, std::string message, std::string hint = {}) const;
  [[noreturn]] void fail_at(std::size_t offset, std::string code, std::string message,
                            std::string hint = {}) const;

 private:
  [[nodiscard]] std::string_view rest() const {
    return std::string_view(source_.text()).substr(at_, end_ - at_);
  }
  void skip_blanks();
  [[nodiscard]] bool at_integer();

  const util::SourceText& source_;
  std::size_t at_, end_;
  const util::Limits& limits_;
};

}  // namespace heed::spec
