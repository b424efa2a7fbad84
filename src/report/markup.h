#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace heed::report {

/// Builds XHTML-compatible markup: what is opened is closed in order, text and attributes are cleaned and
/// escaped. The result parses as HTML and as XML alike.
class Markup {
 public:
  using Attribute = std::pair<std::string_view, std::string>;
  using Attributes = std::vector<Attribute>;

  /// Closes its element at the end of the C++ scope.
  class Scope {
   public:
    explicit Scope(Markup& markup) : markup_(&markup) {}
    Scope(Scope&& other) noexcept : markup_(std::exchange(other.markup_, nullptr)) {}
    Scope& operator=(Scope&&) = delete;
    ~Scope() {
      if (markup_ != nullptr) markup_->close();
    }

   private:
    Markup* markup_;
  };

  [[nodiscard]] Scope scope(std::string_view tag, const Attributes& attributes = {});
  /// An element that holds text alone.
  void element(std::string_view tag, std::string_view content, const Attributes& attributes = {});
  /// An element without content that HTML closes itself (`meta`, `br`) or that stands in SVG.
  void leaf(std::string_view tag, const Attributes& attributes = {});
  void text(std::string_view content);
  /// \pre \p markup is well formed and trusted: this program's own style sheet, doctype or fragment.
  void raw(std::string_view markup) { out_ += markup; }
  /// \pre every scope has ended
  [[nodiscard]] std::string finish();

 private:
  void open(std::string_view tag, const Attributes& attributes);
  void close();
  void start(std::string_view tag, const Attributes& attributes);

  std::string out_;
  std::vector<std::string> open_;
};

/// `&`, `<`, `>` and both quotes as entities, after clean().
[[nodiscard]] std::string escape(std::string_view text);

/// A coordinate: two decimals at most.
[[nodiscard]] std::string coordinate(double value);

/// `data-path` (a JSON pointer) and `data-value` of a number of the document, appended to \p attributes.
[[nodiscard]] Markup::Attributes with_data(Markup::Attributes attributes, std::string path, double value);

}  // namespace heed::report
