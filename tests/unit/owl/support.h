#pragma once

#include <heed/owl/print.h>
#include <heed/owl/read.h>
#include <heed/util/file.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace heed::owl::test {

inline std::string corpus() {
  const char* given = std::getenv("HEED_CORPUS");
  return given != nullptr ? given : std::string(HEED_SOURCE_DIR) + "/../shared/corpus";
}

inline const std::string turtle_head =
    "@prefix : <http://e/#> . @prefix owl: <http://www.w3.org/2002/07/owl#> . @prefix rdf: "
    "<http://www.w3.org/1999/02/22-rdf-syntax-ns#> . @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> . "
    "@prefix xsd: "
    "<http://www.w3.org/2001/XMLSchema#> .\n";

struct Read {
  Ontology ontology;
  util::Diagnostics diagnostics;
};

inline Read read_text(const std::string& text, const std::string& name = "test.ttl",
                      const util::Limits& limits = {}) {
  Read out;
  out.ontology = read(util::SourceText(name, text), limits, out.diagnostics);
  return out;
}

inline Read turtle(const std::string& body) {
  return read_text(turtle_head + body);
}

inline Read rdf_xml(const std::string& body, const std::string& doctype = "") {
  return read_text("<?xml version=\"1.0\"?>\n" + doctype +
                       "<rdf:RDF xmlns=\"http://e/#\" xml:base=\"http://e/\" "
                       "xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\" "
                       "xmlns:rdfs=\"http://www.w3.org/2000/01/rdf-schema#\" "
                       "xmlns:owl=\"http://www.w3.org/2002/07/owl#\">\n" +
                       body + "\n</rdf:RDF>\n",
                   "test.owl");
}

inline Read owl_xml(const std::string& body, const std::string& attributes = "") {
  return read_text(
      "<?xml version=\"1.0\"?>\n<Ontology xmlns=\"http://www.w3.org/2002/07/owl#\" "
      "xml:base=\"http://e/\" ontologyIRI=\"http://e/\"" +
          attributes + "><Prefix name=\"\" IRI=\"http://e/#\"/>\n" + body + "\n</Ontology>\n",
      "test.owx");
}

/// The axioms in functional-style syntax with the namespaces cut off, declarations left out, in document
/// order.
inline std::vector<std::string> short_axioms(const Ontology& ontology, bool declarations = false) {
  std::vector<std::string> out;
  for (const Axiom& axiom : ontology.axioms()) {
    if (!declarations && axiom.as<Declaration>()) continue;
    std::string text = to_functional(axiom, ontology);
    for (const std::string& cut : {std::string("http://e/#"), std::string("http://www.w3.org/2002/07/owl#"),
                                   std::string("http://www.w3.org/2000/01/rdf-schema#"),
                                   std::string("http://www.w3.org/2001/XMLSchema#"),
                                   std::string("http://www.w3.org/1999/02/22-rdf-syntax-ns#")})
      for (std::size_t at = text.find(cut); at != std::string::npos; at = text.find(cut))
        text.erase(at, cut.size());
    std::erase(text, '<');
    std::erase(text, '>');
    out.push_back(text);
  }
  return out;
}

/// The diagnostic of the InputError that \p run throws.
template <class Run>
util::Diagnostic refused(Run run) {
  try {
    run();
  } catch (const util::InputError& error) {
    return error.diagnostic();
  }
  ADD_FAILURE() << "not refused";
  return {};
}

}  // namespace heed::owl::test
