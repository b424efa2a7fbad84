#include <heed/check/verify.h>
#include <heed/logic/parse.h>

#include "cycles.h"
#include "explore.h"
#include "rules.h"

namespace heed::check {
namespace {

/// Clauses built by programs may have no text: refutations name them by their formula.
spec::Gr1 with_texts(spec::Gr1 spec) {
  for (auto part : {&spec::Gr1::sys_init, &spec::Gr1::sys_safety, &spec::Gr1::sys_justice})
    for (spec::Clause& clause : spec.*part)
      if (clause.text.empty()) clause.text = logic::to_string(clause.formula);
  return spec;
}

}  // namespace

Verdict verify(const model::Mealy& machine, const spec::Gr1& spec, util::Budget& budget,
               const Options& options) {
  spec::validate(spec);
  const spec::Gr1 named = with_texts(spec);
  const Rules rules(named);
  Verdict verdict;
  Explorer explorer(machine, rules, budget, options);
  explorer.run(verdict);
  if (verdict.refutations.size() < options.most) check_justice(explorer, rules, budget, options, verdict);
  verdict.verified = verdict.refutations.empty();
  return verdict;
}

}  // namespace heed::check
