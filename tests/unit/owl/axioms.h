#pragma once

#include "support.h"

#include <map>
#include <set>

namespace heed::owl::test {

/// The end of the word that begins at \p at: quoted texts and IRIs may hold anything.
inline std::size_t word_end(std::string_view text, std::size_t at) {
  std::size_t end = at;
  for (bool quoted = false; end < text.size(); ++end) {
    if (quoted && text[end] == '\\')
      ++end;
    else if (text[end] == '"')
      quoted = !quoted;
    else if (text[end] == '<' && !quoted)
      end = text.find('>', end);
    else if (!quoted && std::string_view(" ()").find(text[end]) != std::string_view::npos)
      break;
  }
  return end;
}

/// Functional-style text with the operands of commutative constructors in a fixed order.
inline std::string sorted_text(std::string_view text) {
  static const std::set<std::string> commutative = {
      "ObjectIntersectionOf", "ObjectUnionOf",        "ObjectOneOf", "EquivalentClasses",
      "DisjointClasses",      "DifferentIndividuals", "DataOneOf",   "SameIndividual"};
  struct Open {
    std::string head;
    std::vector<std::string> parts;
  };
  std::vector<Open> open{{"", {}}};
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == ')') {
      Open done = std::move(open.back());
      open.pop_back();
      if (commutative.contains(done.head)) std::sort(done.parts.begin(), done.parts.end());
      std::string out = done.head + "(";
      for (const std::string& part : done.parts) out += part + " ";
      open.back().parts.push_back(out + ")");
      ++at;
    } else if (text[at] == ' ') {
      ++at;
    } else {
      const std::size_t end = word_end(text, at);
      std::string word(text.substr(at, end - at));
      const bool opens = end < text.size() && text[end] == '(';
      if (opens)
        open.push_back({std::move(word), {}});
      else
        open.back().parts.push_back(std::move(word));
      at = opens ? end + 1 : end;
    }
  }
  std::string out;
  for (const std::string& part : open.front().parts) out += part;
  return out;
}

inline std::string blank_names_alike(std::string text) {
  for (std::size_t at = text.find("_:d"); at != std::string::npos; at = text.find("_:d", at + 3))
    text.erase(at + 3, text.find_first_of(" )", at) - at - 3);
  return text;
}

/// The axioms as texts, whatever their order; blank nodes are called alike, so that two ontologies that
/// differ in their names only give the same.
template <class Keep>
std::multiset<std::string> axiom_set(const Ontology& ontology, Keep keep) {
  std::multiset<std::string> out;
  for (const Axiom& axiom : ontology.axioms()) {
    if (!keep(axiom)) continue;
    out.insert(sorted_text(blank_names_alike(to_functional(axiom, ontology))));
  }
  return out;
}

inline std::multiset<std::string> logical(const Ontology& ontology) {
  return axiom_set(ontology, is_logical);
}
inline std::multiset<std::string> all_axioms(const Ontology& ontology) {
  return axiom_set(ontology, [](const Axiom&) { return true; });
}

/// Every ontology of the corpus that is one file, by its path below the corpus.
inline std::vector<std::string> corpus_files() {
  std::vector<std::string> out;
  for (const char* folder : {"/owl/signs", "/owl/public", "/owl/auto"})
    if (std::filesystem::exists(corpus() + folder))
      for (const auto& entry : std::filesystem::recursive_directory_iterator(corpus() + folder))
        if (entry.path().extension() != ".xml" && entry.path().extension() != ".md" &&
            entry.path().filename() != "LICENSE" && entry.is_regular_file())
          out.push_back(entry.path().string());
  std::sort(out.begin(), out.end());
  return out;
}

inline Ontology read_path(const std::string& path) {
  util::Diagnostics diagnostics;
  return read(util::read_file(path), {}, diagnostics);
}

}  // namespace heed::owl::test
