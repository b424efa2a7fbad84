// Roots and roles of an ontology that comes without a scenario. A role whose name speaks of actions or
// behaviours binds what is prescribed; the classes that are described by it, and by other roles, are the
// entities; what the roles lead to are behaviours and features. Of each kind the topmost classes are taken as
// roots.

#include <heed/awareness/catalogue.h>
#include <heed/job/knowledge.h>
#include <heed/owl/read.h>
#include <heed/util/diagnostic.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

namespace heed::job {
namespace {

using owl::Iri;

bool names_action(std::string_view local) {
  std::string lower;
  for (const char c : local) lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const char* word : {"action", "behavio", "prescri", "requires", "oblig"})
    if (lower.find(word) != std::string::npos) return true;
  return false;
}

/// The child of owl:Thing above \p iri (the smallest id, if several): its topmost group.
std::optional<Iri> topmost(const dl::Reasoner& reasoner, Iri iri) {
  const dl::Taxonomy& taxonomy = reasoner.taxonomy();
  std::size_t node = taxonomy.node_of(iri);
  if (node == dl::Taxonomy::npos || node < 2) return std::nullopt;
  while (!taxonomy.nodes[node].parents.empty() && taxonomy.nodes[node].parents.front() != 0)
    node = taxonomy.nodes[node].parents.front();
  return taxonomy.nodes[node].classes.front();
}

/// Roots in order of how many of \p used stand below them, most first.
std::vector<Iri> roots_of(const dl::Reasoner& reasoner, const std::set<Iri>& used) {
  std::map<Iri, std::size_t> count;
  for (const Iri iri : used)
    if (const auto top = topmost(reasoner, iri)) ++count[*top];
  std::vector<Iri> roots;
  for (const auto& [iri, n] : count) roots.push_back(iri);
  std::stable_sort(roots.begin(), roots.end(), [&](Iri a, Iri b) { return count[a] > count[b]; });
  return roots;
}

/// What one role binds: the classes that are described by it, and the named fillers.
struct Use {
  std::set<Iri> described, fillers, individuals;
};
using Uses = std::map<Iri, Use>;

/// Existential restrictions of \p expression, through intersections, as descriptions of \p described.
void collect(Iri described, const owl::ClassExpression& expression, Uses& uses) {
  using Kind = owl::ClassExpression::Kind;
  std::vector<owl::ClassExpression> open{expression};
  while (!open.empty()) {
    const owl::ClassExpression next = open.back();
    open.pop_back();
    if (next.kind() == Kind::Intersection)
      open.insert(open.end(), next.operands().begin(), next.operands().end());
    const bool some = next.kind() == Kind::Some && next.filler().is_named();
    if ((!some && next.kind() != Kind::HasValue) || next.property().inverse) continue;
    Use& use = uses[next.property().iri];
    use.described.insert(described);
    if (some)
      use.fillers.insert(next.filler().iri());
    else
      use.individuals.insert(next.individuals().front());
  }
}

Uses uses_of_roles(const owl::Ontology& ontology) {
  Uses uses;
  for (const owl::Axiom& axiom : ontology.axioms()) {
    if (const auto* inclusion = std::get_if<owl::SubClassOf>(&axiom.content)) {
      if (inclusion->sub.is_named()) collect(inclusion->sub.iri(), inclusion->super, uses);
    } else if (const auto* same = std::get_if<owl::EquivalentClasses>(&axiom.content)) {
      for (const owl::ClassExpression& named : same->classes)
        if (named.is_named())
          for (const owl::ClassExpression& other : same->classes) collect(named.iri(), other, uses);
    }
  }
  return uses;
}

/// The classes that a role leads to; for an individual those it is an instance of.
void add_fillers(const dl::Reasoner& reasoner, const Use& use, std::set<Iri>& classes) {
  classes.insert(use.fillers.begin(), use.fillers.end());
  for (const Iri individual : use.individuals)
    for (const Iri type : reasoner.types(individual, true)) classes.insert(type);
}

std::vector<Word> words_of(const owl::Ontology& ontology, const std::vector<Iri>& iris) {
  std::vector<Word> words;
  for (const Iri iri : iris) words.push_back({std::string(ontology.text(iri)), {}});
  return words;
}

std::string listed(const owl::Ontology& ontology, const std::vector<Word>& words) {
  std::vector<std::string> names;
  for (const Word& word : words) names.emplace_back(ontology.local_name(*ontology.find(word.text)));
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

KnowledgePart guess_knowledge(const std::string& path, const util::Limits& limits, util::Budget& budget,
                              util::Diagnostics& notes) {
  util::Diagnostics ignored;
  owl::ImportOptions imports;
  imports.allow_missing = true;
  const owl::Ontology ontology = owl::load(path, imports, limits, ignored);
  const dl::Reasoner reasoner(ontology, budget);
  std::set<Iri> prescribers, described, behaviours, features;
  std::vector<Iri> action_roles, feature_roles;
  const Uses uses = uses_of_roles(ontology);
  for (const auto& [role, use] : uses)
    if (names_action(ontology.local_name(role))) {
      action_roles.push_back(role);
      add_fillers(reasoner, use, behaviours);
      prescribers.insert(use.described.begin(), use.described.end());
    }
  std::vector<Iri> entities = roots_of(reasoner, prescribers);
  if (entities.size() > 1) entities.resize(1);
  for (const auto& [role, use] : uses) {
    if (names_action(ontology.local_name(role))) continue;
    const auto about_entity = [&](Iri iri) { return topmost(reasoner, iri) == entities.front(); };
    if (entities.empty() || !std::any_of(use.described.begin(), use.described.end(), about_entity)) continue;
    feature_roles.push_back(role);
    add_fillers(reasoner, use, features);
  }
  const util::Location whole{std::make_shared<const std::string>(path), 0, 0};
  if (entities.empty() || feature_roles.empty())
    throw util::InputError(
        whole, "no-roots", "cannot tell which classes are entities, features and behaviours",
        "name them: --entities, --features, --behaviours, --feature-roles, --action-roles");
  KnowledgePart part;
  part.ontology = {path, {}};
  part.allow_missing_imports = true;
  part.entities = words_of(ontology, entities);
  part.features = words_of(ontology, roots_of(reasoner, features));
  part.behaviours = words_of(ontology, roots_of(reasoner, behaviours));
  part.feature_roles = words_of(ontology, feature_roles);
  part.action_roles = words_of(ontology, action_roles);
  notes.push_back(
      {util::Severity::Note,
       whole,
       "guessed-roots",
       fmt::format(
           "taken from its structure: entities below {}; features below {} by {}; behaviours below {} by {}",
           listed(ontology, part.entities), listed(ontology, part.features),
           listed(ontology, part.feature_roles), listed(ontology, part.behaviours),
           listed(ontology, part.action_roles)),
       "give a scenario, or name them with --entities and so on",
       {}});
  return part;
}

}  // namespace heed::job
