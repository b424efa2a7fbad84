#include <heed/awareness/explain.h>
#include <heed/logic/parse.h>

#include "concepts.h"
#include "evidence.h"
#include "told.h"

#include <heed/owl/print.h>

#include <fmt/format.h>

#include <algorithm>

namespace heed::awareness {
namespace {

std::string quoted_list(const std::vector<std::string>& atoms) {
  return atoms.empty() ? "nothing" : fmt::format("'{}'", fmt::join(atoms, "', '"));
}

/// A minimal part of \p seen for which the rule still holds: drop what can be dropped, in alphabetic order.
std::vector<std::string> shrink(std::set<std::string> seen,
                                const std::function<bool(const std::set<std::string>&)>& holds) {
  const std::vector<std::string> all(seen.begin(), seen.end());
  for (const std::string& atom : all) {
    seen.erase(atom);
    if (!holds(seen)) seen.insert(atom);
  }
  return {seen.begin(), seen.end()};
}

bool derived(const Recognition& recognition, const std::string& name, const std::set<std::string>& seen) {
  const auto values = derived_values(recognition, seen);
  const auto found = values.find(name);
  return found != values.end() && found->second;
}

/// Axioms behind a minimal set: from the list of evidence, or, where that was cut short, all axioms of the
/// entity's rule.
Axioms axioms_for(const RecognisedEntity& entity, const std::vector<std::string>& atoms) {
  for (const Evidence& evidence : entity.evidence)
    if (evidence.atoms == atoms) return evidence.axioms;
  return entity.axioms;
}

/// The listed evidence of which least is missing.
std::vector<std::string> missing(const RecognisedEntity& entity, const std::set<std::string>& seen) {
  std::vector<std::string> best;
  bool any = false;
  for (const Evidence& evidence : entity.evidence) {
    std::vector<std::string> lacks;
    for (const std::string& atom : evidence.atoms)
      if (!seen.contains(atom)) lacks.push_back(atom);
    if (!any || lacks.size() < best.size()) best = lacks;
    any = true;
  }
  return best;
}

}  // namespace

std::vector<AxiomText> axiom_texts(const Catalogue& catalogue, const std::vector<owl::AxiomId>& axioms) {
  std::vector<AxiomText> result;
  for (const owl::AxiomId id : axioms) {
    const owl::Axiom& axiom = catalogue.ontology.axiom(id);
    result.push_back({id, owl::to_text(axiom, catalogue.ontology), axiom.location});
  }
  return result;
}

Explanation explain_formula(const Catalogue& catalogue, const SigmaFormula& formula) {
  return {fmt::format("{} ({})", logic::to_string(formula.formula, logic::Notation::Textbook),
                      to_string(formula.kind)),
          true,
          {{formula.sentence, axiom_texts(catalogue, formula.axioms), formula.entailed}}};
}

Explanation explain_entity(const Catalogue& catalogue, std::size_t entity) {
  const Entity& it = catalogue.entities[entity];
  Explanation result{fmt::format("'{}' ({})", it.label, it.atom), true, {}};
  if (!it.satisfiable)
    result.steps.push_back({"Nothing can be one: what is said of it contradicts itself.",
                            axiom_texts(catalogue, it.impossible), inclusions_impossible(catalogue, entity)});
  for (const Entailed& up : it.parents)
    result.steps.push_back({fmt::format("It is a '{}'.", catalogue.entities[up.index].label),
                            axiom_texts(catalogue, up.axioms),
                            inclusions_below(catalogue, entity, up.index)});
  for (const Entailed& has : catalogue.described(entity)) {
    const Feature& feature = catalogue.features[has.index];
    if (feature.entity == entity) continue;
    const std::string how = feature.kind == Feature::Kind::Class ? "" : feature.role_atom + " ";
    result.steps.push_back({fmt::format("It has the feature {}'{}'.", how, feature.label),
                            axiom_texts(catalogue, has.axioms),
                            inclusions_has(catalogue, entity, has.index)});
  }
  for (const Entailed& act : it.behaviours)
    result.steps.push_back({fmt::format("It prescribes to '{}'.", catalogue.behaviours[act.index].label),
                            axiom_texts(catalogue, act.axioms),
                            inclusions_prescribes(catalogue, entity, act.index)});
  return result;
}

Explanation explain_behaviour(const Catalogue& catalogue, std::size_t behaviour) {
  const Behaviour& it = catalogue.behaviours[behaviour];
  Explanation result{fmt::format("'{}' ({})", it.label, it.atom), true, {}};
  for (const Entailed& up : it.parents)
    result.steps.push_back({fmt::format("It is a special way to '{}'.", catalogue.behaviours[up.index].label),
                            axiom_texts(catalogue, up.axioms),
                            inclusions_special(catalogue, behaviour, up.index)});
  for (std::size_t e = 0; e < catalogue.entities.size(); ++e)
    if (const Entailed* act = catalogue.prescribes(e, behaviour); act != nullptr)
      result.steps.push_back({fmt::format("'{}' prescribes it.", catalogue.entities[e].label),
                              axiom_texts(catalogue, act->axioms),
                              inclusions_prescribes(catalogue, e, behaviour)});
  return result;
}

Explanation explain_warning(const Catalogue& catalogue, const Warning& warning) {
  const std::string why = warning.axioms.empty() ? "" : ", because of";
  Explanation result{
      warning.message,
      true,
      {{fmt::format("Warning [{}]{}", warning.code, why), axiom_texts(catalogue, warning.axioms)}}};
  if (warning.code == "unsatisfiable-entity")
    result.steps[0].entailed = inclusions_impossible(catalogue, warning.entities[0]);
  if (warning.code == "unasserted-subsumption" || warning.code == "unasserted-equivalence")
    result.steps[0].entailed = inclusions_below(catalogue, warning.entities[0], warning.entities[1]);
  if (warning.code == "unasserted-equivalence")
    if (const Entailed* back = catalogue.is_below(warning.entities[1], warning.entities[0]); back != nullptr)
      result.steps.push_back({"The other way round, because of", axiom_texts(catalogue, back->axioms),
                              inclusions_below(catalogue, warning.entities[1], warning.entities[0])});
  if (!warning.hint.empty()) result.steps.push_back({"Hint: " + warning.hint + ".", {}});
  return result;
}

Explanation explain_recognition(const Catalogue& catalogue, const Recognition& recognition,
                                std::size_t entity, const std::set<std::string>& seen) {
  const std::string label = catalogue.entities[entity].label;
  const RecognisedEntity* rule = recognition.find_entity(entity);
  if (rule == nullptr)
    return {fmt::format("'{}' is never recognised by this policy ({})", label, recognition.words), false, {}};
  if (!derived(recognition, rule->name, seen)) {
    const auto lacks = missing(*rule, seen);
    Explanation result{fmt::format("'{}' is not recognised", label),
                       false,
                       {{fmt::format("The nearest evidence lacks {}.", quoted_list(lacks)), {}}}};
    if (auto why = why_impossible(catalogue, recognition, entity, seen)) result.steps = {std::move(*why)};
    return result;
  }
  const auto why =
      shrink(seen, [&](const std::set<std::string>& part) { return derived(recognition, rule->name, part); });
  const Axioms axioms = axioms_for(*rule, why);
  return {fmt::format("'{}' is recognised", label),
          true,
          {{fmt::format("{} suffices (policy: {}).", quoted_list(why), recognition.words),
            axiom_texts(catalogue, axioms)}}};
}

namespace {

/// A reaction that is not what recognised entities prescribe: because of what it can still be, or in spite of
/// it.
Explanation explain_candidates(const Catalogue& catalogue, const Recognition& recognition,
                               const PrescribedBehaviour& rule, const std::set<std::string>& seen) {
  const bool holds = derived(recognition, rule.name, seen);
  Explanation result{
      fmt::format("'{}' is {}prescribed", catalogue.behaviours[rule.behaviour].label, holds ? "" : "not "),
      holds,
      {{fmt::format("Policy: {}.", recognition.words), {}}}};
  for (const Situation& situation : recognition.situations) {
    const bool told =
        situation.kind == Situation::Kind::Conflict || situation.kind == Situation::Kind::Unknown;
    if (told && derived(recognition, situation.name, seen))
      result.steps.push_back({situation.words + ".", {}});
    if (situation.kind != Situation::Kind::Possible || !derived(recognition, situation.name, seen)) continue;
    const Entailed* act = catalogue.prescribes(*situation.entity, rule.behaviour);
    result.steps.push_back(
        {fmt::format("{}{}.", situation.words, act != nullptr ? ", which prescribes it" : ""),
         act != nullptr ? axiom_texts(catalogue, act->axioms) : std::vector<AxiomText>{}});
  }
  return result;
}

}  // namespace

Explanation explain_reaction(const Catalogue& catalogue, const Recognition& recognition,
                             std::size_t behaviour, const std::set<std::string>& seen) {
  const std::string label = catalogue.behaviours[behaviour].label;
  Explanation result{fmt::format("'{}' is not prescribed", label), false, {}};
  const PrescribedBehaviour* rule = recognition.find_behaviour(behaviour);
  if (rule == nullptr) return result;
  for (const std::size_t entity : rule->because) {
    const Explanation why = explain_recognition(catalogue, recognition, entity, seen);
    if (!why.holds) continue;
    result.holds = true;
    result.subject = fmt::format("'{}' is prescribed", label);
    result.steps.push_back({why.subject + ".", {}});
    result.steps.insert(result.steps.end(), why.steps.begin(), why.steps.end());
    result.steps.push_back(
        {fmt::format("A '{}' prescribes to '{}'.", catalogue.entities[entity].label, label),
         axiom_texts(catalogue, catalogue.prescribes(entity, behaviour)->axioms),
         inclusions_prescribes(catalogue, entity, behaviour)});
  }
  if (derived(recognition, rule->name, seen) == result.holds) return result;
  return explain_candidates(catalogue, recognition, *rule, seen);
}

namespace {

std::string lines_of(const std::vector<AxiomText>& axioms, std::size_t indent) {
  std::string text;
  for (const AxiomText& axiom : axioms)
    text += fmt::format("{:{}}{}  {}  ({})\n", "", indent, owl::to_string(axiom.id), axiom.text,
                        util::to_string(axiom.location));
  return text;
}

}  // namespace

std::string because_text(const Catalogue& catalogue, const std::vector<owl::AxiomId>& axioms) {
  if (axioms.empty()) return "";
  std::string text = "because\n" + lines_of(axiom_texts(catalogue, axioms), 2);
  text.pop_back();
  return text;
}

std::string to_text(const Explanation& explanation) {
  std::string text = explanation.subject + "\n";
  for (const ExplanationStep& step : explanation.steps) {
    text += fmt::format("  {}\n", step.sentence);
    if (step.all.empty()) text += lines_of(step.axioms, 4);
    for (std::size_t i = 0; i < step.all.size(); ++i) {
      const std::string& cause = step.all[i].derived_from;
      text += fmt::format("    justification {} of {}{}{}\n", i + 1, step.all_listed ? "" : "at least ",
                          step.all.size(), cause.empty() ? "" : ", derived: " + cause);
      text += lines_of(step.all[i].axioms, 6);
    }
    if (!step.all_listed) text += "    ... there are more\n";
  }
  return text;
}

}  // namespace heed::awareness
