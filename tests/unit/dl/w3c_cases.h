#pragma once

#include "support.h"

#include <map>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace heed::dl::test {

/// A test case of the W3C, as its catalogue (an ontology itself) describes it.
struct W3cCase {
  std::string name;
  std::set<std::string> kinds;               ///< "ConsistencyTest", ...
  std::map<std::string, std::string> texts;  ///< "rdfXmlPremiseOntology", ...
  std::set<std::string> species;             ///< "FULL" and, unless it is only that, "DL".
  std::vector<std::string> imports;          ///< Names of the documents it imports.
  std::string import_iri;                    ///< Of a document that others import.
};

inline std::string after_hash(std::string_view iri) {
  return std::string(iri.substr(iri.find_last_of("#/") + 1));
}

/// All cases and imported documents by the name of their resource.
inline std::map<std::string, W3cCase> w3c_cases(const std::string& path) {
  util::Diagnostics diagnostics;
  const owl::Ontology o = owl::read(util::read_file(path), {}, diagnostics);
  std::map<std::string, W3cCase> out;
  const auto name = [&](owl::Iri iri) { return after_hash(o.text(iri)); };
  const auto value = [&](owl::Iri property, owl::Iri subject, const owl::AnnotationValue& object) {
    W3cCase& entry = out[name(subject)];
    if (const auto* literal = std::get_if<owl::Literal>(&object)) {
      (name(property) == "identifier" ? entry.name : entry.texts[name(property)]) = literal->value;
    } else if (name(property) == "species") {
      entry.species.insert(name(std::get<owl::Iri>(object)));
    } else if (name(property) == "importedOntology") {
      entry.imports.push_back(name(std::get<owl::Iri>(object)));
    } else if (name(property) == "importedOntologyIRI") {
      entry.import_iri = std::string(o.text(std::get<owl::Iri>(object)));
    }
  };
  for (const owl::Axiom& axiom : o.axioms()) {
    if (const auto* type = axiom.as<owl::ClassAssertion>(); type != nullptr && type->of.is_named())
      out[name(type->individual)].kinds.insert(name(type->of.iri()));
    if (const auto* data = axiom.as<owl::DataPropertyAssertion>())
      value(data->property, data->source, data->value);
    if (const auto* note = axiom.as<owl::AnnotationAssertion>())
      value(note->property, note->subject, note->value);
    if (const auto* role = axiom.as<owl::ObjectPropertyAssertion>(); role != nullptr && !role->negative)
      value(role->property.iri, role->source, role->target);
  }
  return out;
}

/// Two documents whose names have the same numbers: both begin with the declarations of all entities of
/// either.
struct Aligned {
  owl::Ontology premise, conclusion;
};

inline std::string declarations_of(const owl::Ontology& a, const owl::Ontology& b) {
  static constexpr std::pair<owl::EntityKind, const char*> kinds[] = {
      {owl::EntityKind::Class, "Class"},
      {owl::EntityKind::Datatype, "Datatype"},
      {owl::EntityKind::ObjectProperty, "ObjectProperty"},
      {owl::EntityKind::DataProperty, "DataProperty"},
      {owl::EntityKind::NamedIndividual, "NamedIndividual"}};
  std::string out;
  for (const owl::Ontology* o : {&a, &b})
    for (const auto& [kind, word] : kinds)
      for (const owl::Iri iri : o->entities(kind))
        if (!o->is_anonymous(iri))
          out += std::string("Declaration(") + word + "(<" + std::string(o->text(iri)) + ">))\n";
  return out;
}

inline Aligned align(const owl::Ontology& premise, const owl::Ontology& conclusion) {
  const std::string names = declarations_of(premise, conclusion);
  const auto again = [&](const owl::Ontology& o) {
    std::string text = "Ontology(\n" + names;
    for (const owl::Axiom& axiom : o.axioms())
      if (owl::is_logical(axiom)) text += owl::to_functional(axiom, o) + "\n";
    util::Diagnostics diagnostics;
    return owl::read(util::SourceText("aligned.ofn", text + ")"), {}, diagnostics);
  };
  return {again(premise), again(conclusion)};
}

/// What a document states, in which unnamed individuals stand for existence: a tree of them below a named one
/// becomes a type of that one. Empty where they form no such tree.
class Statements {
 public:
  explicit Statements(const owl::Ontology& o) : ontology_(o) {
    for (const owl::Axiom& axiom : o.axioms()) {
      if (!owl::is_logical(axiom)) continue;
      if (!sort(axiom)) out_.push_back(axiom.content);
    }
  }
  /// Nothing when an unnamed individual is left that no named one leads to.
  [[nodiscard]] std::optional<std::vector<owl::AxiomContent>> take() {
    std::set<owl::Iri> reached;
    for (const auto& [source, edges] : edges_)
      if (!ontology_.is_anonymous(source))
        for (const auto& edge : edges) {
          auto filler = rolled(edge.second, reached, 0);
          if (!filler) return std::nullopt;
          out_.emplace_back(owl::ClassAssertion{owl::ClassExpression::some(edge.first, *filler), source});
        }
    for (const owl::Iri node : unnamed_)
      if (!reached.contains(node)) return std::nullopt;
    return out_;
  }

 private:
  using Edge = std::pair<owl::ObjectProperty, owl::Iri>;

  bool sort(const owl::Axiom& axiom) {
    if (const auto* type = axiom.as<owl::ClassAssertion>();
        type && ontology_.is_anonymous(type->individual)) {
      types_[type->individual].push_back(type->of);
      unnamed_.insert(type->individual);
      return true;
    }
    if (const auto* data = axiom.as<owl::DataPropertyAssertion>();
        data && ontology_.is_anonymous(data->source)) {
      types_[data->source].push_back(owl::ClassExpression::data_has_value(data->property, data->value));
      unnamed_.insert(data->source);
      return true;
    }
    const auto* role = axiom.as<owl::ObjectPropertyAssertion>();
    if (role == nullptr || role->negative) return false;
    for (const owl::Iri end : {role->source, role->target})
      if (ontology_.is_anonymous(end)) unnamed_.insert(end);
    if (!ontology_.is_anonymous(role->source) && !ontology_.is_anonymous(role->target)) return false;
    edges_[role->source].emplace_back(role->property, role->target);
    return true;
  }

  std::optional<owl::ClassExpression> rolled(owl::Iri node, std::set<owl::Iri>& reached, int depth) {
    if (!ontology_.is_anonymous(node)) return owl::ClassExpression::one_of({node});
    if (depth > 20 || !reached.insert(node).second) return std::nullopt;
    std::vector<owl::ClassExpression> parts = types_[node];
    for (const Edge& edge : edges_[node]) {
      auto filler = rolled(edge.second, reached, depth + 1);
      if (!filler) return std::nullopt;
      parts.push_back(owl::ClassExpression::some(edge.first, *filler));
    }
    return owl::ClassExpression::intersection(parts);
  }

  const owl::Ontology& ontology_;
  std::vector<owl::AxiomContent> out_;
  std::map<owl::Iri, std::vector<Edge>> edges_;
  std::map<owl::Iri, std::vector<owl::ClassExpression>> types_;
  std::set<owl::Iri> unnamed_;
};

}  // namespace heed::dl::test
