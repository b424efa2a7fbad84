#include "plant.h"

#include <heed/spec/compose.h>
#include <heed/util/diagnostic.h>

#include "nodes.h"

#include <fmt/format.h>

#include <algorithm>

namespace heed::spec {

using logic::Formula;
using logic::Op;

PlantTerms::PlantTerms(const model::Fts& plant) : plant_(plant), deterministic_(plant.deterministic()) {
  for (const auto& [name, states] : plant.labels) labels_.emplace(name, &states);
  for (const auto& [name, values] : plant.values) values_.emplace(name, &values);
  for (std::uint32_t i = 0; i < plant.states.size(); ++i) states_.emplace(plant.states[i], i);
  enabled_.assign(plant.actions.size(), StateSet(plant.states.size()));
  for (const auto& transition : plant.transitions) enabled_[transition.action][transition.from] = true;
}

const StateSet* PlantTerms::label(const std::string& name) const {
  const auto found = labels_.find(name);
  return found == labels_.end() ? nullptr : found->second;
}

const std::vector<std::int32_t>* PlantTerms::value(const std::string& name) const {
  const auto found = values_.find(name);
  return found == values_.end() ? nullptr : found->second;
}

std::optional<std::uint32_t> PlantTerms::state(const std::string& name) const {
  const auto found = states_.find(name);
  return found == states_.end() ? std::nullopt : std::optional(found->second);
}

StateSet PlantTerms::enabled(std::uint32_t action) const {
  return enabled_[action];
}

Formula PlantTerms::inside(const StateSet& states) const {
  const auto count = static_cast<std::size_t>(std::count(states.begin(), states.end(), true));
  if (count == states.size()) return logic::truth(true);
  const bool listed = count <= states.size() / 2;
  std::vector<Formula> parts;
  for (std::uint32_t i = 0; i < states.size(); ++i)
    if (states[i] == listed)
      parts.push_back(
          logic::compare(listed ? Op::Eq : Op::Ne, logic::name(plant_state), logic::name(plant_.states[i])));
  return listed ? logic::any_of(std::move(parts)) : logic::all_of(std::move(parts));
}

Formula PlantTerms::next_inside(const StateSet& states) const {
  if (std::find(states.begin(), states.end(), false) == states.end()) return logic::truth(true);
  if (!deterministic_) return logic::next(inside(states));
  std::vector<StateSet> before(plant_.actions.size(), StateSet(plant_.states.size()));
  for (const auto& transition : plant_.transitions)
    if (states[transition.to]) before[transition.action][transition.from] = true;
  std::vector<Formula> ways;
  for (std::uint32_t a = 0; a < before.size(); ++a) {
    if (std::find(before[a].begin(), before[a].end(), true) == before[a].end()) continue;
    const Formula chosen = logic::compare(Op::Eq, logic::name(plant_action), logic::name(plant_.actions[a]));
    ways.push_back(before[a] == enabled_[a] ? chosen : chosen && inside(before[a]));
  }
  return logic::any_of(std::move(ways));
}

namespace {

StateSet combine(Op op, const std::vector<const StateSet*>& operands) {
  StateSet out = *operands[0];
  for (std::size_t s = 0; s < out.size(); ++s) {
    bool value = out[s];
    for (std::size_t k = 1; k < operands.size(); ++k) {
      const bool other = (*operands[k])[s];
      if (op == Op::And) value = value && other;
      if (op == Op::Or) value = value || other;
      if (op == Op::Implies) value = !value || other;
      if (op == Op::Iff) value = value == other;
    }
    out[s] = op == Op::Not ? !value : value;
  }
  return out;
}

bool is_connective(Op op) {
  return op >= Op::Not && op <= Op::Iff;
}

/// One formula, bottom up. Per node: what it says of this step, what Next of it says, and the set of states
/// that it describes if it speaks of nothing else. Next distributes over connectives, so that `X (red &
/// stopping)` finds its `X stopping`; above other temporal operators it stays for lowering to deal with.
class Expander {
 public:
  Expander(const Formula& root, const PlantTerms& terms)
      : nodes_(root), terms_(terms), parts_(nodes_.size()) {}

  Expanded run() {
    for (std::size_t i = 0; i < nodes_.size(); ++i) parts_[i] = part(i);
    refuse_bare_value(nodes_.size() - 1);
    return {now(nodes_.size() - 1), parts_.back().states};
  }

 private:
  /// Where `states` is set the formulas are made of it on demand: most sets only become part of larger ones.
  struct Part {
    Formula now, then;
    std::optional<StateSet> states{};
    bool changed = false;
  };

  Part part(std::size_t i) const {
    const Formula& node = nodes_[i];
    if (node.op() == Op::Name) {
      const StateSet* states = terms_.label(node.name());
      return states ? described(*states) : unchanged(node);
    }
    if (is_comparison(node.op())) {
      if (!mentions_plant(node, terms_)) return unchanged(node);
      Expanded expanded = expand_comparison(node, terms_);
      if (expanded.states) return described(std::move(*expanded.states));
      return {expanded.formula, logic::next(expanded.formula), std::nullopt, true};
    }
    if (node.op() == Op::Next) return next(i);
    if (node.op() >= Op::Add && node.op() <= Op::Mul) return unchanged(node);
    for (const std::uint32_t operand : nodes_.operands(i)) refuse_bare_value(operand);
    return is_connective(node.op()) ? connective(i) : temporal(i);
  }

  static Part unchanged(const Formula& node) { return {node, logic::next(node)}; }

  static Part described(StateSet states) { return {{}, {}, std::move(states), true}; }

  [[nodiscard]] Formula now(std::size_t i) const {
    return parts_[i].states ? terms_.inside(*parts_[i].states) : parts_[i].now;
  }
  [[nodiscard]] Formula then(std::size_t i) const {
    return parts_[i].states ? terms_.next_inside(*parts_[i].states) : parts_[i].then;
  }

  [[nodiscard]] Part next(std::size_t i) const {
    const std::uint32_t operand = nodes_.operands(i)[0];
    if (!parts_[operand].changed) return unchanged(nodes_[i]);
    const Formula coming = then(operand);
    return {coming, logic::next(coming), std::nullopt, true};
  }

  [[nodiscard]] Part connective(std::size_t i) const {
    const auto& operands = nodes_.operands(i);
    std::vector<const StateSet*> sets;
    bool changed = false;
    for (const std::uint32_t k : operands) {
      changed = changed || parts_[k].changed;
      if (parts_[k].states) sets.push_back(&*parts_[k].states);
    }
    const Op op = nodes_[i].op();
    if (!changed) return unchanged(nodes_[i]);
    if (sets.size() == operands.size()) return described(combine(op, sets));
    std::vector<Formula> present, coming;
    for (const std::uint32_t k : operands) {
      present.push_back(now(k));
      coming.push_back(then(k));
    }
    return {build(op, std::move(present)), build(op, std::move(coming)), std::nullopt, true};
  }

  static Formula build(Op op, std::vector<Formula> operands) {
    switch (op) {
      case Op::Not:
        return !operands[0];
      case Op::And:
        return logic::all_of(std::move(operands));
      case Op::Or:
        return logic::any_of(std::move(operands));
      case Op::Implies:
        return logic::implies(operands[0], operands[1]);
      default:
        return logic::iff(operands[0], operands[1]);
    }
  }

  [[nodiscard]] Part temporal(std::size_t i) const {
    const Formula& node = nodes_[i];
    std::vector<Formula> operands;
    bool changed = false;
    for (const std::uint32_t k : nodes_.operands(i)) {
      changed = changed || parts_[k].changed;
      operands.push_back(now(k));
    }
    if (!changed) return unchanged(node);
    const Formula rebuilt = Formula::make(node.op(), std::move(operands), node.location());
    return {rebuilt, logic::next(rebuilt), std::nullopt, true};
  }

  void refuse_bare_value(std::size_t i) const {
    const Formula& node = nodes_[i];
    if (node.op() == Op::Name && terms_.value(node.name()))
      throw util::InputError(
          node.location(), "type",
          fmt::format("the plant value '{}' stands where a truth value is expected", node.name()),
          fmt::format("compare it, as in '{} = 0'", node.name()));
  }

  Nodes nodes_;
  const PlantTerms& terms_;
  std::vector<Part> parts_;
};

}  // namespace

Expanded expand(const Formula& formula, const PlantTerms& terms) {
  return Expander(formula, terms).run();
}

Formula expand_plant(const Formula& formula, const model::Fts& plant) {
  return expand(formula, PlantTerms(plant)).formula;
}

}  // namespace heed::spec
