#include <fmt/format.h>

#include <algorithm>

#include "format.h"
#include "html_parts.h"

namespace heed::report {

namespace {

/// Longer lists begin folded; print unfolds them.
constexpr std::size_t longest_open_list = 12;

Markup::Attributes details(std::size_t items) {
  if (items <= longest_open_list) return {{"open", "open"}};
  return {};
}

void write_summary(Markup& page, std::string_view words, std::size_t items) {
  const auto summary = page.scope("summary");
  page.text(fmt::format("{} ", words));
  page.element("span", fmt::format("({})", items), {{"class", "place"}});
}

void write_axiom(Markup& page, const Axiom& axiom, std::string_view lead, const char* tag) {
  const auto paragraph = page.scope(tag, {{"class", "because"}});
  page.text(lead);
  page.element("code", axiom.text);
  page.text(" ");
  page.element("span", short_place(axiom.location), {{"class", "place"}});
}

void write_formula(Markup& page, const KnowledgeFormula& formula) {
  const auto item = page.scope("li", {{"id", "formula-" + formula.id}});
  page.element("code", formula.text);
  if (!formula.sentence.empty()) page.element("p", formula.sentence);
  for (const Axiom& axiom : formula.axioms) write_axiom(page, axiom, "because ", "p");
}

std::string kind_title(const std::string& kind) {
  if (kind == "recognition") return "What is taken for what";
  if (kind == "prescription") return "What a thing prescribes, from the next step on";
  if (kind == "subclass") return "What a thing also is";
  if (kind == "disjointness") return "What excludes what";
  return kind;
}

void write_clause(Markup& page, const SpecificationClause& clause) {
  const auto item = page.scope("li");
  std::string origin = clause.origin;
  if (!clause.axioms.empty()) origin += " · " + join(clause.axioms, ", ");
  page.element("span", origin, {{"class", "origin"}});
  page.element("code", clause.text);
}

}  // namespace

void write_ontology(Markup& page, const RunResult& result) {
  const Ontology& ontology = result.ontology;
  const auto part = section(page, "ontology", "What it was told",
                            "The ontology, and the axioms in it that the controllers rest on.");
  {
    const auto list = page.scope("dl", {{"class", "facts"}});
    const auto fact = [&](const char* name, std::uint64_t value) {
      if (value == 0) return;
      const auto pair = page.scope("div");
      page.element("dt", name);
      page.element("dd", grouped(value));
    };
    fact("axioms", ontology.axioms);
    fact("classes", ontology.classes);
    fact("properties", ontology.properties);
    fact("individuals", ontology.individuals);
    fact("entities", ontology.entities);
    fact("features", ontology.features);
    fact("behaviours", ontology.behaviours);
  }
  if (!ontology.file.empty() || !ontology.iri.empty()) {
    const auto paragraph = page.scope("p", {{"class", "because"}});
    page.element("code", ontology.file);
    page.text(" ");
    page.element("code", ontology.iri);
  }
  if (ontology.excerpt.empty()) return;
  const auto fold = page.scope("details", details(ontology.excerpt.size()));
  write_summary(page, "Axioms used", ontology.excerpt.size());
  const auto list = page.scope("ul", {{"class", "list"}});
  for (const Axiom& axiom : ontology.excerpt) {
    const auto item = page.scope("li", {{"id", "axiom-" + axiom.id}});
    page.element("span", fmt::format("{} · {}", axiom.id, short_place(axiom.location)),
                 {{"class", "origin"}});
    page.element("code", axiom.text);
  }
}

void write_knowledge(Markup& page, const RunResult& result) {
  if (result.knowledge.empty()) return;
  const auto part = section(page, "knowledge", "What follows from it",
                            "σ: the knowledge as temporal logic, each formula with the axioms it came from.");
  std::vector<std::string> kinds;
  for (const KnowledgeFormula& formula : result.knowledge)
    if (std::find(kinds.begin(), kinds.end(), formula.kind) == kinds.end()) kinds.push_back(formula.kind);
  for (const std::string& kind : kinds) {
    const auto of_kind = [&](const KnowledgeFormula& formula) { return formula.kind == kind; };
    const auto count =
        static_cast<std::size_t>(std::count_if(result.knowledge.begin(), result.knowledge.end(), of_kind));
    const auto fold = page.scope("details", details(count));
    write_summary(page, kind_title(kind), count);
    const auto list = page.scope("ul", {{"class", "list"}});
    for (const KnowledgeFormula& formula : result.knowledge)
      if (of_kind(formula)) write_formula(page, formula);
  }
}

void write_specification(Markup& page, const RunResult& result) {
  if (result.specification.empty()) return;
  const auto part = section(page, "specification", "What was asked",
                            "The game that was solved: what the environment is assumed to do, and what the "
                            "controller must guarantee for it.");
  for (const SpecificationSection& one : result.specification) {
    if (one.clauses.empty()) continue;
    const auto fold = page.scope("details", details(one.clauses.size()));
    write_summary(page, one.title.empty() ? one.name : one.title, one.clauses.size());
    const auto list = page.scope("ul", {{"class", "list"}});
    for (const SpecificationClause& clause : one.clauses) write_clause(page, clause);
  }
}

}  // namespace heed::report
