#include <heed/awareness/policy.h>

#include "policy_compiler.h"
#include "told.h"

#include <algorithm>
#include <array>

namespace heed::awareness {
namespace {

constexpr std::array<std::string_view, 6> words{"full",       "tree",     "tree-or-full",
                                                "definition", "at-least", "identifying"};
constexpr std::array<std::string_view, 3> acting_words{"cautious", "common", "brave"};

}  // namespace

std::string_view to_string(PolicyOptions::Kind kind) {
  return words[static_cast<std::size_t>(kind)];
}

std::optional<PolicyOptions::Kind> read_policy(std::string_view word) {
  const auto place = std::find(words.begin(), words.end(), word);
  if (place == words.end()) return std::nullopt;
  return static_cast<PolicyOptions::Kind>(place - words.begin());
}

std::string_view to_string(PolicyOptions::Acting acting) {
  return acting_words[static_cast<std::size_t>(acting)];
}

std::optional<PolicyOptions::Acting> read_acting(std::string_view word) {
  const auto place = std::find(acting_words.begin(), acting_words.end(), word);
  if (place == acting_words.end()) return std::nullopt;
  return static_cast<PolicyOptions::Acting>(place - acting_words.begin());
}

const RecognisedEntity* Recognition::find_entity(std::size_t entity) const {
  const auto place =
      std::find_if(entities.begin(), entities.end(), [&](const auto& r) { return r.entity == entity; });
  return place == entities.end() ? nullptr : &*place;
}

const PrescribedBehaviour* Recognition::find_behaviour(std::size_t behaviour) const {
  const auto place = std::find_if(behaviours.begin(), behaviours.end(),
                                  [&](const auto& p) { return p.behaviour == behaviour; });
  return place == behaviours.end() ? nullptr : &*place;
}

void PolicyCompiler::note(std::string code, std::string message, std::string hint) {
  result_.notes.push_back(
      {util::Severity::Warning, {}, std::move(code), std::move(message), std::move(hint), ""});
}

/// What suffices for \p entity: its own rule and that of its equivalents, seeing it as a feature of others,
/// and its members.
void PolicyCompiler::add_entity(std::size_t entity, const std::map<std::size_t, Rule>& own) {
  Rule rule;
  for (std::size_t e = 0; e < catalogue_.entities.size(); ++e)
    if (e == entity || equivalent(catalogue_, e, entity)) {
      const Axioms why = e == entity ? Axioms{} : catalogue_.is_below(e, entity)->axioms;
      if (const auto found = own.find(e); found != own.end())
        rule = either(rule, because_of(found->second, why));
      for (std::size_t f = 0; f < catalogue_.features.size(); ++f)
        if (catalogue_.features[f].entity == e && perception_.perceivable[f])
          rule = either(rule, all_rule({{perception_.feature_atom[f], why}}));
    }
  RecognisedEntity result{
      entity, "recognised_" + catalogue_.entities[entity].atom, rule.formula, {}, {}, rule.evidence, true};
  for (const RecognisedEntity& member : result_.entities) {
    const auto& parents = catalogue_.entities[member.entity].parents;
    const auto up =
        std::find_if(parents.begin(), parents.end(), [&](const Entailed& p) { return p.index == entity; });
    if (up == parents.end() || equivalent(catalogue_, member.entity, entity)) continue;
    Rule of_member{logic::name(member.name), member.evidence, member.evidence_complete};
    rule = either(rule, because_of(std::move(of_member), up->axioms));
  }
  if (rule.formula.op() == logic::Op::False) return;
  result.formula = rule.formula;
  result.evidence = rule.evidence;
  result.evidence_complete = rule.complete;
  for (const Evidence& evidence : rule.evidence) result.axioms = join(result.axioms, evidence.axioms);
  result_.entities.push_back(std::move(result));
}

void PolicyCompiler::add_entities(const std::map<std::size_t, Rule>& own) {
  for (const std::size_t e : bottom_up(catalogue_))
    if (catalogue_.entities[e].satisfiable) add_entity(e, own);
}

/// A recognised entity makes everything above it recognised, so the most general prescribers are enough.
void PolicyCompiler::add_behaviours() {
  for (std::size_t b = 0; b < catalogue_.behaviours.size(); ++b) {
    PrescribedBehaviour prescribed{
        b, "prescribed_" + catalogue_.behaviours[b].atom, logic::truth(false), {}, {}};
    for (const RecognisedEntity& candidate : result_.entities) {
      const Entailed* why = catalogue_.prescribes(candidate.entity, b);
      if (why == nullptr) continue;
      const auto& up = catalogue_.entities[candidate.entity].ancestors;
      const bool covered = std::any_of(up.begin(), up.end(), [&](const Entailed& a) {
        const bool first = !equivalent(catalogue_, candidate.entity, a.index) || a.index < candidate.entity;
        return first && catalogue_.prescribes(a.index, b) != nullptr &&
               result_.find_entity(a.index) != nullptr;
      });
      if (covered) continue;
      prescribed.because.push_back(candidate.entity);
      prescribed.formula = prescribed.formula || logic::name(candidate.name);
      prescribed.axioms = join(prescribed.axioms, why->axioms);
    }
    if (!prescribed.because.empty()) result_.behaviours.push_back(std::move(prescribed));
  }
}

Recognition PolicyCompiler::compile() {
  check_options();
  over_ = resolve_items(options_.over);
  order_ = resolve_items(options_.order);
  note_words();
  if (asks_for_candidates()) {
    possible_.emplace(catalogue_, perception_, options_.closed, options_.direct.value_or(true));
    result_.situations = possible_->situations();
    note_acting_words();
    note_wide_symbols();
  }
  std::map<std::size_t, Rule> own;
  for (const std::size_t e : targets()) own[e] = rule_for(e);
  add_entities(own);
  add_behaviours();
  if (possible_) act();
  return std::move(result_);
}

Recognition compile_policy(const Catalogue& catalogue, const Perception& perception,
                           const PolicyOptions& options) {
  return PolicyCompiler(catalogue, perception, options).compile();
}

}  // namespace heed::awareness
