#include <algorithm>
#include <cassert>

#include "inspect.h"
#include "operations.h"
#include "reorder.h"

namespace heed::bdd {

Manager::Manager(const ManagerOptions& options, util::Budget* budget)
    : kernel_(std::make_unique<Kernel>(this, options, budget)) {}

Manager::~Manager() {
  assert(kernel_->handles.open_slots() == 0 && "a handle outlives its manager");
}

void Manager::set_budget(util::Budget* budget) {
  kernel_->budget = budget;
}

Var Manager::new_variable() {
  return new_group(1);
}

Pair Manager::new_pair() {
  const Var first = kernel_->add_variables(2, true) - 1;
  return {first, first + 1};
}

Var Manager::new_group(std::size_t size) {
  assert(size > 0);
  return kernel_->add_variables(size, false) - 1;
}

std::size_t Manager::variable_count() const {
  return kernel_->variable_count();
}

bool Manager::is_paired(Var variable) const {
  assert(variable < variable_count());
  return kernel_->next_of(variable + 1) != kernel_->current_of(variable + 1);
}

Var Manager::partner(Var variable) const {
  assert(is_paired(variable));
  return kernel_->next_of(variable + 1) + kernel_->current_of(variable + 1) - (variable + 1) - 1;
}

Bdd Manager::constant(bool value) {
  return Bdd(kernel_.get(), value ? true_edge : false_edge);
}

Bdd Manager::variable(Var variable) {
  return literal(variable, true);
}

Bdd Manager::literal(Var variable, bool value) {
  assert(variable < variable_count());
  const Edge flip = value ? 0 : 1;
  return kernel_->run([&] { return kernel_->make(variable + 1, false_edge, true_edge) ^ flip; });
}

Bdd Manager::cube(std::span<const Var> variables) {
  std::vector<Literal> literals;
  for (const Var variable : variables) literals.push_back({variable, true});
  return cube(literals);
}

Bdd Manager::cube(std::span<const Literal> literals) {
  return kernel_->run([&] {
    std::vector<Literal> sorted(literals.begin(), literals.end());
    const auto depth = [&](const Literal& literal) { return kernel_->level_of(literal.variable + 1); };
    const auto deeper = [&](const Literal& a, const Literal& b) { return depth(a) > depth(b); };
    if (!std::is_sorted(sorted.begin(), sorted.end(), deeper))
      std::stable_sort(sorted.begin(), sorted.end(), deeper);
    Edge result = true_edge;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      assert(sorted[i].variable < variable_count());
      if (i > 0 && sorted[i].variable == sorted[i - 1].variable) {
        if (sorted[i].value != sorted[i - 1].value) return false_edge;
        continue;
      }
      const std::uint32_t variable = sorted[i].variable + 1;
      result = sorted[i].value ? kernel_->make(variable, false_edge, result)
                               : kernel_->make(variable, result, false_edge);
    }
    return result;
  });
}

Bdd Manager::conjunction(std::span<const Bdd> operands) {
  std::vector<Bdd> level(operands.begin(), operands.end());
  if (level.empty()) return constant(true);
  while (level.size() > 1) {
    std::vector<Bdd> above;
    for (std::size_t i = 0; i + 1 < level.size(); i += 2) above.push_back(level[i] & level[i + 1]);
    if (level.size() % 2 != 0) above.push_back(level.back());
    level = std::move(above);
  }
  return level.front();
}

Bdd Manager::disjunction(std::span<const Bdd> operands) {
  std::vector<Bdd> complements;
  for (const Bdd& operand : operands) complements.push_back(!operand);
  return !conjunction(complements);
}

Bdd Manager::conjunction_exists(std::span<const Bdd> operands, const Bdd& cube) {
  std::vector<std::vector<Var>> due(operands.size() + 1);
  std::vector<std::size_t> last(variable_count(), 0);
  for (std::size_t i = 0; i < operands.size(); ++i) {
    for (const Var variable : operands[i].support_variables()) last[variable] = i + 1;
  }
  for (const Var variable : cube.support_variables()) due[last[variable]].push_back(variable);
  Bdd result = constant(true);
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const Bdd now = this->cube(due[i + 1]);
    result = result.and_exists(operands[i], now);
  }
  return result;
}

std::size_t Manager::node_count(std::span<const Bdd> diagrams) const {
  std::vector<Edge> roots;
  for (const Bdd& diagram : diagrams) {
    assert(diagram.kernel_ == kernel_.get());
    roots.push_back(diagram.edge_);
  }
  return shared_size(*kernel_, roots);
}

Bdd Manager::transfer(const Bdd& source, std::span<const Var> map) {
  const Bdd sources[] = {source};
  return deserialise(*this, serialise(sources), map).front();
}

std::size_t Manager::level(Var variable) const {
  assert(variable < variable_count());
  return kernel_->level_of(variable + 1);
}

std::vector<Var> Manager::order() const {
  std::vector<Var> result(variable_count());
  for (Var v = 0; v < result.size(); ++v) result[level(v)] = v;
  return result;
}

void Manager::set_order(std::span<const Var> order) {
  assert(order.size() == variable_count());
  std::vector<std::uint32_t> inner;
  for (const Var variable : order) inner.push_back(variable + 1);
  Reorderer(*kernel_).set_order(inner);
}

void Manager::sift(const SiftOptions& options) {
  Reorderer(*kernel_).sift(options);
}

void Manager::set_automatic_reordering(bool on) {
  kernel_->options.automatic_reordering = on;
}

void Manager::set_steps_per_reordering(std::uint32_t steps) {
  kernel_->options.steps_per_reordering = steps;
}

bool Manager::automatic_reordering() const {
  return kernel_->options.automatic_reordering;
}

void Manager::set_sift_options(const SiftOptions& options) {
  kernel_->sift_options = options;
}

void Manager::collect_garbage() {
  kernel_->collect();
}

Statistics Manager::statistics() const {
  return kernel_->statistics();
}

bool Manager::consistent() const {
  return kernel_->consistent();
}

}  // namespace heed::bdd
