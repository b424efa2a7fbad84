#pragma once

#include "ontology_data.h"

#include <heed/owl/expression.h>
#include <heed/util/diagnostic.h>
#include <heed/util/limits.h>

#include <string>
#include <utility>
#include <vector>

namespace heed::owl {

/// A node of an RDF graph: an IRI (by its id in the table), a blank node or a literal (by their numbers in
/// the graph).
class Term {
 public:
  Term() = default;
  static Term iri(Iri iri) { return Term(iri.id); }
  static Term blank(std::uint32_t number) { return Term(number | blank_bit); }
  static Term literal(std::uint32_t number) { return Term(number | literal_bit); }

  [[nodiscard]] bool is_iri() const { return (bits_ & (blank_bit | literal_bit)) == 0; }
  [[nodiscard]] bool is_blank() const { return (bits_ & blank_bit) != 0; }
  [[nodiscard]] bool is_literal() const { return (bits_ & literal_bit) != 0; }
  [[nodiscard]] Iri as_iri() const { return Iri{bits_}; }
  [[nodiscard]] std::uint32_t number() const { return bits_ & ~(blank_bit | literal_bit); }
  [[nodiscard]] std::uint32_t bits() const { return bits_; }
  friend bool operator==(Term a, Term b) = default;
  friend bool operator==(Term a, Iri b) { return a.bits_ == b.id; }

 private:
  explicit Term(std::uint32_t bits) : bits_(bits) {}
  static constexpr std::uint32_t blank_bit = 1U << 30;
  static constexpr std::uint32_t literal_bit = 1U << 31;
  std::uint32_t bits_ = 0;
};

struct Triple {
  Term subject;
  Iri predicate;
  Term object;
  std::uint32_t offset;  ///< In the source, where people would look for it.
};

/// One document as RDF: triples in document order. The names are in a table that documents of one closure
/// share.
struct Graph {
  util::SourceText source;
  std::vector<Triple> triples;
  std::vector<Literal> literals;
  std::uint32_t blank_count = 0;
  std::vector<std::pair<std::string, std::string>> prefixes;

  Term new_blank() { return Term::blank(blank_count++); }
  Term add_literal(Literal literal) {
    literals.push_back(std::move(literal));
    return Term::literal(static_cast<std::uint32_t>(literals.size() - 1));
  }
  void add(Term subject, Iri predicate, Term object, std::size_t offset) {
    triples.push_back({subject, predicate, object, static_cast<std::uint32_t>(offset)});
  }
};

/// What a reader of one document needs beside the text.
struct ReadContext {
  IriTable& iris;
  KindTable& kinds;
  const util::Limits& limits;
  util::Diagnostics& diagnostics;
  std::size_t document = 0;  ///< Its number in the closure; keeps anonymous individuals apart.
};

[[nodiscard]] Graph read_rdf_xml(const util::SourceText& source, ReadContext context);
[[nodiscard]] Graph read_turtle(const util::SourceText& source, ReadContext context);

/// A warning with excerpt at \p offset.
[[nodiscard]] util::Diagnostic warning_at(const util::SourceText& source, std::size_t offset,
                                          std::string code, std::string message, std::string hint = {});

}  // namespace heed::owl
