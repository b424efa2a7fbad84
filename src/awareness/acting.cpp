#include <heed/awareness/explain.h>

#include "policy_compiler.h"
#include "told.h"

#include <fmt/format.h>

#include <algorithm>

namespace heed::awareness {

bool PolicyCompiler::asks_for_candidates() const {
  return options_.kind == PolicyOptions::Kind::Identifying ||
         options_.acting != PolicyOptions::Acting::Cautious || !options_.fallback.empty();
}

Rule PolicyCompiler::identifying_rule(std::size_t entity) {
  if (!catalogue_.entities[entity].satisfiable) return {};
  return either(possible_->recognised(entity), possible_->identified(entity, evidence_work_));
}

/// With a candidate: what recognised things prescribe, what all candidates call for, or what some candidate
/// calls for. With none: the fallback and what recognised things prescribe.
logic::Formula PolicyCompiler::acting_formula(std::size_t behaviour, const logic::Formula& cautious) const {
  const bool falls_back =
      std::any_of(options_.fallback.begin(), options_.fallback.end(), [&](const Name& name) {
        const std::size_t b = catalogue_.behaviour(name);
        const auto& up = catalogue_.behaviours[b].general;
        return b == behaviour || std::any_of(up.begin(), up.end(), [&](const Entailed& general) {
                 return general.index == behaviour;
               });
      });
  const logic::Formula fallback = falls_back ? possible_->nothing_fits() : logic::truth(false);
  switch (options_.acting) {
    case PolicyOptions::Acting::Common:
      return possible_->common(behaviour) || (possible_->nothing_fits() && cautious) || fallback;
    case PolicyOptions::Acting::Brave:
      return possible_->brave(behaviour) || (possible_->nothing_fits() && cautious) || fallback;
    case PolicyOptions::Acting::Cautious:
      break;
  }
  return cautious || fallback;
}

void PolicyCompiler::act() {
  std::vector<PrescribedBehaviour> all;
  for (std::size_t b = 0; b < catalogue_.behaviours.size(); ++b) {
    PrescribedBehaviour prescribed{
        b, "prescribed_" + catalogue_.behaviours[b].atom, logic::truth(false), {}, {}};
    if (const PrescribedBehaviour* known = result_.find_behaviour(b)) prescribed = *known;
    if (options_.kind == PolicyOptions::Kind::Identifying) {
      const Rule called = possible_->called_for(b);
      prescribed.formula = prescribed.formula || called.formula;
      for (const Evidence& evidence : called.evidence)
        prescribed.axioms = join(prescribed.axioms, evidence.axioms);
    }
    prescribed.formula = acting_formula(b, prescribed.formula);
    if (prescribed.formula.op() != logic::Op::False) all.push_back(std::move(prescribed));
  }
  result_.behaviours = std::move(all);
}

void PolicyCompiler::note_acting_words() {
  if (options_.acting == PolicyOptions::Acting::Common)
    result_.words += "; prescribed is what everything that it can still be prescribes";
  if (options_.acting == PolicyOptions::Acting::Brave)
    result_.words += "; prescribed is what anything that it can still be prescribes";
  if (options_.fallback.empty()) return;
  std::vector<std::string> labels;
  for (const Name& name : options_.fallback)
    labels.push_back("'" + catalogue_.behaviours[catalogue_.behaviour(name)].label + "'");
  result_.words += fmt::format("; {} when nothing in the catalogue fits", fmt::join(labels, " and "));
}

/// Only where candidates fall away does it matter what a symbol rules out.
void PolicyCompiler::note_wide_symbols() {
  for (Warning& wide : judge_perception(catalogue_, perception_))
    result_.notes.push_back({util::Severity::Warning, wide.location, wide.code, std::move(wide.message),
                             std::move(wide.hint), because_text(catalogue_, wide.axioms)});
}

}  // namespace heed::awareness
