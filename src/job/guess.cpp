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
#include <optional>
#include <set>

namespace heed::job {
namespace {

using owl::Iri;

std::string lower_case(std::string_view text) {
  std::string lower;
  for (const char c : text) lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

bool names_action(std::string_view local) {
  const std::string lower = lower_case(local);
  for (const char* word :
       {"action", "behavio", "prescri", "requires", "oblig", "callsfor", "calls_for", "demand"})
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

/// What an ontology is guessed to be made of; classes or, where it only speaks of these, individuals.
struct Guess {
  std::vector<Iri> entities, features, behaviours, feature_roles, action_roles;
  std::optional<Iri> subclass_role;

  [[nodiscard]] bool whole() const { return !entities.empty() && !feature_roles.empty(); }
};

/// Whether a role binds what is prescribed: as told, else by its name.
class ActionRoles {
 public:
  ActionRoles(const owl::Ontology& ontology, const std::vector<Word>& told) : ontology_(ontology) {
    for (const Word& word : told) told_.insert(word.text);
  }
  [[nodiscard]] bool operator()(Iri role) const {
    const std::string local(ontology_.local_name(role));
    if (told_.empty()) return names_action(local);
    return told_.contains(local) || told_.contains(std::string(ontology_.text(role)));
  }

 private:
  const owl::Ontology& ontology_;
  std::set<std::string> told_;
};

Guess guess_from_classes(const dl::Reasoner& reasoner, const Uses& uses, const ActionRoles& prescribes) {
  Guess guess;
  std::set<Iri> prescribers, behaviours, features;
  for (const auto& [role, use] : uses)
    if (prescribes(role)) {
      guess.action_roles.push_back(role);
      add_fillers(reasoner, use, behaviours);
      prescribers.insert(use.described.begin(), use.described.end());
    }
  guess.entities = roots_of(reasoner, prescribers);
  if (guess.entities.empty()) return guess;
  guess.entities.resize(1);
  const auto about_entity = [&](Iri iri) { return topmost(reasoner, iri) == guess.entities.front(); };
  for (const auto& [role, use] : uses) {
    if (prescribes(role)) continue;
    if (!std::any_of(use.described.begin(), use.described.end(), about_entity)) continue;
    guess.feature_roles.push_back(role);
    add_fillers(reasoner, use, features);
  }
  guess.features = roots_of(reasoner, features);
  guess.behaviours = roots_of(reasoner, behaviours);
  return guess;
}

bool names_subclass(std::string_view local) {
  const std::string lower = lower_case(local);
  return lower == "isa" || lower == "is_a" || lower.find("subclass") != std::string::npos ||
         lower.find("kindof") != std::string::npos || lower.find("kind_of") != std::string::npos;
}

/// Things that are modelled as individuals with role assertions: `hasColor(yield, red)`.
Guess guess_from_individuals(const owl::Ontology& ontology, const dl::Reasoner& reasoner,
                             const ActionRoles& prescribes) {
  Uses uses;
  Guess guess;
  std::set<Iri> below, things, features, behaviours;
  for (const owl::Axiom& axiom : ontology.axioms()) {
    const auto* said = axiom.as<owl::ObjectPropertyAssertion>();
    if (said == nullptr || said->negative || said->property.inverse) continue;
    if (names_subclass(ontology.local_name(said->property.iri))) {
      guess.subclass_role = said->property.iri;
      below.insert(said->source);
      things.insert(said->target);
    } else {
      uses[said->property.iri].described.insert(said->source);
      uses[said->property.iri].individuals.insert(said->target);
    }
  }
  for (const auto& [role, use] : uses) {
    (prescribes(role) ? guess.action_roles : guess.feature_roles).push_back(role);
    add_fillers(reasoner, use, prescribes(role) ? behaviours : features);
    things.insert(use.described.begin(), use.described.end());
  }
  if (guess.action_roles.empty()) return {};
  for (const Iri thing : things)
    if (!below.contains(thing)) guess.entities.push_back(thing);
  guess.features.assign(features.begin(), features.end());
  guess.behaviours.assign(behaviours.begin(), behaviours.end());
  return guess;
}

/// What to choose from, for whoever has to name the roots.
std::string choices(const owl::Ontology& ontology, const dl::Reasoner& reasoner, const Uses& uses) {
  std::set<Iri> tops;
  std::vector<Iri> roles;
  for (const auto& [role, use] : uses) {
    roles.push_back(role);
    for (const auto* classes : {&use.described, &use.fillers})
      for (const Iri iri : *classes)
        if (const auto top = topmost(reasoner, iri)) tops.insert(*top);
  }
  if (roles.empty()) return "no class is described by a role; such as --entities Sign --features Colour ...";
  return fmt::format(
      "say which role prescribes, --action-roles NAME, or name all roots: --entities, --features, "
      "--behaviours "
      "(roles: {}; topmost classes: {})",
      listed(ontology, words_of(ontology, roles)),
      listed(ontology, words_of(ontology, {tops.begin(), tops.end()})));
}

KnowledgePart part_of(const owl::Ontology& ontology, const KnowledgePart& known, const Guess& guess) {
  KnowledgePart part = known;
  part.allow_missing_imports = true;
  part.entities = words_of(ontology, guess.entities);
  part.features = words_of(ontology, guess.features);
  part.behaviours = words_of(ontology, guess.behaviours);
  part.feature_roles = words_of(ontology, guess.feature_roles);
  part.action_roles = words_of(ontology, guess.action_roles);
  if (!part.subclass_role && guess.subclass_role)
    part.subclass_role = words_of(ontology, {*guess.subclass_role}).front();
  return part;
}

}  // namespace

KnowledgePart guess_knowledge(const KnowledgePart& known, const util::Limits& limits, util::Budget& budget,
                              util::Diagnostics& notes) {
  util::Diagnostics ignored;
  owl::ImportOptions imports;
  imports.allow_missing = true;
  const std::string& path = known.ontology.text;
  const owl::Ontology ontology = owl::load(path, imports, limits, ignored);
  const dl::Reasoner reasoner(ontology, budget);
  const Uses uses = uses_of_roles(ontology);
  const ActionRoles prescribes(ontology, known.action_roles);
  Guess guess = guess_from_classes(reasoner, uses, prescribes);
  if (!guess.whole()) guess = guess_from_individuals(ontology, reasoner, prescribes);
  const util::Location whole{std::make_shared<const std::string>(path), 0, 0};
  if (!guess.whole())
    throw util::InputError(whole, "no-roots",
                           "cannot tell which classes are entities, features and behaviours",
                           choices(ontology, reasoner, uses));
  KnowledgePart part = part_of(ontology, known, guess);
  notes.push_back(
      {util::Severity::Note,
       whole,
       "guessed-roots",
       fmt::format(
           "taken from its structure: entities below {}; features below {} by {}; behaviours below {} by "
           "{}{}",
           listed(ontology, part.entities), listed(ontology, part.features),
           listed(ontology, part.feature_roles), listed(ontology, part.behaviours),
           listed(ontology, part.action_roles),
           part.subclass_role ? "; 'is a kind of' is " + listed(ontology, {*part.subclass_role}) : ""),
       "give a scenario, or name them with --entities and so on",
       {}});
  return part;
}

}  // namespace heed::job
