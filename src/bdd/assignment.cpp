#include <heed/bdd/bdd.h>

#include <cassert>

#include "kernel.h"

/// Evaluation, one satisfying assignment, all of them.
namespace heed::bdd {

bool Bdd::evaluate(const std::vector<bool>& assignment) const {
  return evaluate([&](Var variable) { return static_cast<bool>(assignment.at(variable)); });
}

bool Bdd::evaluate(const std::function<bool(Var)>& assignment) const {
  assert(valid());
  Edge edge = edge_;
  while (edge > 1) edge = assignment(kernel_->variable(edge) - 1) ? kernel_->high(edge) : kernel_->low(edge);
  return edge == true_edge;
}

std::vector<Literal> Bdd::pick_path() const {
  assert(valid() && !is_false());
  std::vector<Literal> literals;
  for (Edge edge = edge_; edge > 1;) {
    const bool value = kernel_->low(edge) == false_edge;
    literals.push_back({kernel_->variable(edge) - 1, value});
    edge = value ? kernel_->high(edge) : kernel_->low(edge);
  }
  return literals;
}

std::vector<bool> Bdd::pick(std::span<const Var> variables) const {
  assert(valid() && !is_false());
  std::vector<bool> values;
  Bdd rest = *this;
  for (const Var variable : variables) {
    Bdd without = rest.cofactor(variable, false);
    values.push_back(without.is_false());
    rest = values.back() ? rest.cofactor(variable, true) : std::move(without);
  }
  return values;
}

Bdd Bdd::pick_cube(std::span<const Var> variables) const {
  const std::vector<bool> values = pick(variables);
  std::vector<Literal> literals;
  for (std::size_t i = 0; i < values.size(); ++i) literals.push_back({variables[i], values[i]});
  return manager().cube(literals);
}

Assignments::Assignments(const Bdd& function, std::span<const Var> variables)
    : variables_(variables.begin(), variables.end()),
      rest_(variables.size() + 1),
      values_(variables.size(), 0) {
  rest_.front() = function;
}

/// Takes the least assignment of the variables from \p depth on under those before it. \returns false if
/// there is none
bool Assignments::descend(std::size_t depth) {
  if (rest_[depth].is_false()) return false;
  for (; depth < variables_.size(); ++depth) {
    const Bdd without = rest_[depth].cofactor(variables_[depth], false);
    values_[depth] = without.is_false() ? 1 : 0;
    rest_[depth + 1] = values_[depth] == 0 ? without : rest_[depth].cofactor(variables_[depth], true);
  }
  assert(rest_.back().is_true());
  return true;
}

bool Assignments::next() {
  if (!started_) {
    started_ = true;
    return descend(0);
  }
  for (std::size_t depth = variables_.size(); depth-- > 0;) {
    if (values_[depth] != 0) continue;
    rest_[depth + 1] = rest_[depth].cofactor(variables_[depth], true);
    values_[depth] = 1;
    if (descend(depth + 1)) return true;
    values_[depth] = 0;
  }
  return false;
}

}  // namespace heed::bdd
