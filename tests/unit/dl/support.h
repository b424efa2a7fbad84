#pragma once

#include <heed/dl/justifier.h>
#include <heed/dl/reasoner.h>
#include <heed/owl/print.h>
#include <heed/owl/read.h>
#include <heed/util/file.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace heed::dl::test {

inline std::string corpus() {
  const char* given = std::getenv("HEED_CORPUS");
  return given != nullptr ? given : std::string(HEED_SOURCE_DIR) + "/../shared/corpus";
}

/// Turtle without its prefixes; all on one line, so that line 2 is the first of \p body.
inline owl::Ontology turtle(const std::string& body) {
  util::Diagnostics diagnostics;
  return owl::read(
      util::SourceText(
          "test.ttl",
          "@prefix : <http://e/#> . @prefix owl: <http://www.w3.org/2002/07/owl#> . @prefix rdf: "
          "<http://www.w3.org/1999/02/22-rdf-syntax-ns#> . @prefix rdfs: "
          "<http://www.w3.org/2000/01/rdf-schema#> . @prefix xsd: "
          "<http://www.w3.org/2001/XMLSchema#> .\n" +
              body),
      {}, diagnostics);
}

/// A reasoner with short names for questions.
struct Asked {
  explicit Asked(const std::string& body) : ontology(turtle(body)), reasoner(ontology, budget) {}
  [[nodiscard]] owl::Iri iri(const std::string& name) const {
    const auto found = ontology.find("http://e/#" + name);
    if (!found) ADD_FAILURE() << "no name " << name;
    return found.value_or(owl::Iri{});
  }
  [[nodiscard]] owl::ClassExpression cls(const std::string& name) const {
    return owl::ClassExpression::named(iri(name));
  }
  [[nodiscard]] bool below(const std::string& sub, const std::string& super) const {
    return reasoner.subsumes(iri(super), iri(sub));
  }
  [[nodiscard]] bool satisfiable(const std::string& name) const { return reasoner.satisfiable(iri(name)); }
  [[nodiscard]] bool is_a(const std::string& individual, const std::string& name) const {
    for (const owl::Iri type : reasoner.types(iri(individual)))
      if (type == iri(name)) return true;
    return false;
  }

  util::Budget budget;
  owl::Ontology ontology;
  Reasoner reasoner;
};

}  // namespace heed::dl::test
