#pragma once

#include "document.h"

#include <map>
#include <string>
#include <string_view>

namespace heed::owl {

/// The names of one document in an axiom syntax: prefixes, relative IRIs, anonymous individuals, and what
/// each name is used as.
class Names {
 public:
  /// Knows the standard prefixes rdf, rdfs, xsd and owl.
  Names(const util::SourceText& source, const ReadContext& context);

  void declare_prefix(std::string_view prefix, std::string_view uri);
  void set_base(std::string_view base) { base_ = base; }
  [[nodiscard]] const std::string& base() const { return base_; }
  /// \throws InputError  `undeclared-prefix`
  Iri prefixed(std::string_view prefix, std::string_view local, std::size_t offset);
  /// "p:name", or a name of the empty prefix.
  Iri abbreviated(std::string_view name, std::size_t offset);
  /// Against \p base. A warning where it holds what no IRI holds.
  Iri resolved(std::string_view base, std::string_view reference, std::size_t offset);
  Iri full(std::string_view reference, std::size_t offset) { return resolved(base_, reference, offset); }
  Iri anonymous(std::string_view label);

  void use(EntityKind kind, Iri iri) { context_.kinds.add(kind, iri); }
  [[nodiscard]] const KindTable& kinds() const { return context_.kinds; }
  [[nodiscard]] const IriTable& iris() const { return context_.iris; }
  [[nodiscard]] const util::Limits& limits() const { return context_.limits; }
  [[nodiscard]] const std::map<std::string, std::string, std::less<>>& prefixes() const { return prefixes_; }
  /// Brings rdf:PlainLiteral to a string with or without a language, and languages to lower case.
  [[nodiscard]] static Literal literal(std::string value, Iri datatype, std::string_view language);

  void warn(std::size_t offset, const char* code, std::string message, std::string hint = {});
  [[noreturn]] void fail(std::size_t offset, const char* code, std::string message,
                         std::string hint = {}) const;

 private:
  /// What scratch_ holds. A warning where that is new and no IRI.
  Iri checked(std::size_t offset);

  const util::SourceText& source_;
  ReadContext context_;
  std::string base_;
  std::map<std::string, std::string, std::less<>> prefixes_;
  std::map<std::string, Iri, std::less<>> anonymous_;
  std::string scratch_;
};

}  // namespace heed::owl
