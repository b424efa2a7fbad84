// Forward over (state of the chain, last transition of the machine). What is assumed of a step may speak of
// the observation after it, which becomes inputs of a machine of its own, called as they are with a prime.
#include "assumed.h"

#include "letters.h"

#include <heed/logic/parse.h>
#include <heed/logic/rewrite.h>

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace heed::job {
namespace {

using logic::Formula;

std::string primed(const std::string& name) {
  return name + "'";
}

/// X over an input is that input with a prime.
Formula over_both(const Formula& written) {
  const Formula formula = logic::push_next(written);
  std::unordered_map<const void*, Formula> done;
  for (const Formula& node : logic::postorder(formula)) {
    std::vector<Formula> operands;
    for (const Formula& operand : node.operands()) operands.push_back(done.at(operand.identity()));
    Formula made = node;
    if (node.op() == logic::Op::Next)
      made = logic::name(primed(node[0].name()));
    else if (!operands.empty())
      made = Formula::make(node.op(), std::move(operands), node.location());
    done.emplace(node.identity(), std::move(made));
  }
  return done.at(formula.identity());
}

model::Mealy with_primes(const model::Mealy& machine) {
  model::Mealy shell;
  shell.name = machine.name;
  shell.inputs = machine.inputs;
  shell.outputs = machine.outputs;
  for (const model::Variable& input : machine.inputs) {
    shell.inputs.push_back(input);
    shell.inputs.back().name = primed(input.name);
  }
  return shell;
}

class Assumed {
 public:
  Assumed(const spec::Gr1& spec, const ReadyApproach& approach, const model::Mealy& machine)
      : approach_(approach),
        machine_(machine),
        shell_(with_primes(machine)),
        first_(clauses(spec.env_init)),
        every_(clauses(spec.env_safety)),
        at_start_(first_, shell_, {}),
        in_step_(every_, shell_, {}) {
    for (const Formula& formula : every_) {
      const auto names = logic::names_of(formula).current;
      of_one_step_.push_back(std::none_of(names.begin(), names.end(),
                                          [](const std::string& name) { return name.ends_with('\''); }));
    }
  }

  sim::Rational broken(util::Budget& budget) {
    const model::Valuation& blank = approach_.plan.binding.blank;
    const auto letter = machine_.input_letter(blank);
    const auto* row = letter ? machine_.find(0, *letter) : nullptr;
    if (row == nullptr || !keeps(at_start_, first_.size(), blank, *row, blank)) return 1;
    layer_[{0, row}] = 1;
    for (std::uint32_t cell = 0; cell < approach_.chain->cells; ++cell) {
      budget.check();
      pass_cell();
    }
    // What is assumed of the last observation alone.
    for (const auto& [at, probability] : layer_)
      if (!keeps_now(*at.second)) broken_ += probability;
    return broken_;
  }

 private:
  using Row = model::Mealy::Transition;

  static std::vector<Formula> clauses(const std::vector<spec::Clause>& part) {
    std::vector<Formula> formulas;
    for (const spec::Clause& clause : part) formulas.push_back(over_both(clause.formula));
    return formulas;
  }

  void pass_cell() {
    const sim::Chain& chain = *approach_.chain;
    const auto before = std::exchange(layer_, {});
    for (const auto& [at, probability] : before)
      for (std::uint32_t i = chain.first[at.first]; i < chain.first[at.first + 1]; ++i) {
        const sim::Chain::Step& step = chain.steps[i];
        const sim::Rational share = probability * step.probability;
        const Row* next = keeps_step(*at.second, step.seen);
        if (next == nullptr)
          broken_ += share;
        else
          layer_[{step.next, next}] += share;
      }
  }

  /// The row that answers what is reported next; nullptr where that is not allowed.
  const Row* keeps_step(const Row& last, std::uint64_t seen) {
    const auto [known, added] = known_.try_emplace({&last, seen}, nullptr);
    if (!added) return known->second;
    model::Valuation reported = approach_.plan.binding.blank;
    for (const sim::Binding::Wire& wire : approach_.plan.binding.wires)
      if (seen >> wire.feature & 1) reported[wire.input] = wire.value;
    if (!keeps(in_step_, every_.size(), machine_.input_letters[last.input], last, reported)) return nullptr;
    const auto letter = machine_.input_letter(reported);
    return known->second = letter ? machine_.find(last.next, *letter) : nullptr;
  }

  /// What is assumed of every observation by itself.
  bool keeps_now(const Row& row) {
    for (std::size_t f = 0; f < every_.size(); ++f)
      if (of_one_step_[f] &&
          !in_step_.holds(f, doubled(machine_.input_letters[row.input], machine_.input_letters[row.input]),
                          machine_.output_letters[row.output]))
        return false;
    return true;
  }

  bool keeps(LetterFormulas& formulas, std::size_t count, const model::Valuation& now, const Row& row,
             const model::Valuation& next) const {
    for (std::size_t f = 0; f < count; ++f)
      if (!formulas.holds(f, doubled(now, next), machine_.output_letters[row.output])) return false;
    return true;
  }

  static model::Valuation doubled(model::Valuation now, const model::Valuation& next) {
    now.insert(now.end(), next.begin(), next.end());
    return now;
  }

  const ReadyApproach& approach_;
  const model::Mealy& machine_;
  model::Mealy shell_;
  std::vector<Formula> first_, every_;
  std::vector<bool> of_one_step_;  ///< Of `every_`.
  LetterFormulas at_start_, in_step_;
  std::map<std::pair<std::uint32_t, const Row*>, sim::Rational> layer_;
  std::map<std::pair<const Row*, std::uint64_t>, const Row*> known_;  ///< Only looked up.
  sim::Rational broken_ = 0;
};

}  // namespace

sim::Rational assumptions_broken(const spec::Gr1& spec, const ReadyApproach& approach,
                                 const model::Mealy& machine, util::Budget& budget) {
  if (!approach.chain)
    throw util::LimitExceeded(util::LimitExceeded::Kind::Size, "the approach has no small chain");
  return Assumed(spec, approach, machine).broken(budget);
}

}  // namespace heed::job
