#include <heed/bdd/bdd.h>

#include <algorithm>
#include <cassert>

#include "inspect.h"
#include "operations.h"

/// The handles: each operation checks what belongs together and runs one recursion.
namespace heed::bdd {

Bdd::Bdd(Kernel* kernel, std::uint32_t edge)
    : kernel_(kernel), edge_(edge), slot_(kernel->handles.open(edge)) {}

Bdd::Bdd(const Bdd& other) noexcept : kernel_(other.kernel_), edge_(other.edge_), slot_(other.slot_) {
  if (kernel_ != nullptr) kernel_->handles.share(slot_);
}

Bdd::Bdd(Bdd&& other) noexcept
    : kernel_(std::exchange(other.kernel_, nullptr)), edge_(other.edge_), slot_(other.slot_) {
  other.edge_ = 0;
}

Bdd& Bdd::operator=(const Bdd& other) noexcept {
  Bdd copy(other);
  return *this = std::move(copy);
}

Bdd& Bdd::operator=(Bdd&& other) noexcept {
  std::swap(kernel_, other.kernel_);
  std::swap(edge_, other.edge_);
  std::swap(slot_, other.slot_);
  return *this;
}

Bdd::~Bdd() {
  if (kernel_ != nullptr) kernel_->handles.close(slot_);
}

Manager& Bdd::manager() const {
  assert(valid());
  return *kernel_->owner;
}

Bdd Bdd::operator!() const {
  assert(valid());
  Bdd result(*this);
  result.edge_ ^= 1U;
  return result;
}

Bdd Bdd::operator&(const Bdd& other) const {
  assert(valid() && kernel_ == other.kernel_);
  return kernel_->run([&] { return conjoin(*kernel_, edge_, other.edge_); });
}

Bdd Bdd::operator|(const Bdd& other) const {
  assert(valid() && kernel_ == other.kernel_);
  return kernel_->run([&] { return disjoin(*kernel_, edge_, other.edge_); });
}

Bdd Bdd::operator^(const Bdd& other) const {
  assert(valid() && kernel_ == other.kernel_);
  return kernel_->run([&] { return exclusive_or(*kernel_, edge_, other.edge_); });
}

Bdd Bdd::ite(const Bdd& then, const Bdd& otherwise) const {
  assert(valid() && kernel_ == then.kernel_ && kernel_ == otherwise.kernel_);
  return kernel_->run([&] { return if_then_else(*kernel_, edge_, then.edge_, otherwise.edge_); });
}

bool Bdd::entails(const Bdd& other) const {
  assert(valid() && kernel_ == other.kernel_);
  return disjoint(*kernel_, edge_, other.edge_ ^ 1U);
}

Bdd Bdd::exists(const Bdd& cube) const {
  assert(valid() && kernel_ == cube.kernel_);
  return kernel_->run([&] { return bdd::exists(*kernel_, edge_, cube.edge_); });
}

Bdd Bdd::forall(const Bdd& cube) const {
  assert(valid() && kernel_ == cube.kernel_);
  return kernel_->run([&] { return bdd::exists(*kernel_, edge_ ^ 1U, cube.edge_) ^ 1U; });
}

Bdd Bdd::and_exists(const Bdd& other, const Bdd& cube) const {
  assert(valid() && kernel_ == other.kernel_ && kernel_ == cube.kernel_);
  return kernel_->run([&] { return bdd::and_exists(*kernel_, edge_, other.edge_, cube.edge_); });
}

Bdd Bdd::and_forall(const Bdd& other, const Bdd& cube) const {
  return forall(cube) & other.forall(cube);
}

Bdd Bdd::or_forall(const Bdd& other, const Bdd& cube) const {
  assert(valid() && kernel_ == other.kernel_ && kernel_ == cube.kernel_);
  return kernel_->run(
      [&] { return bdd::and_exists(*kernel_, edge_ ^ 1U, other.edge_ ^ 1U, cube.edge_) ^ 1U; });
}

Bdd Bdd::implies_forall(const Bdd& other, const Bdd& cube) const {
  assert(valid() && kernel_ == other.kernel_ && kernel_ == cube.kernel_);
  return kernel_->run([&] { return bdd::and_exists(*kernel_, edge_, other.edge_ ^ 1U, cube.edge_) ^ 1U; });
}

Bdd Bdd::next() const {
  assert(valid());
  return kernel_->run([&] { return shift_next(*kernel_, edge_); });
}

Bdd Bdd::current() const {
  assert(valid());
  return kernel_->run([&] { return shift_current(*kernel_, edge_); });
}

Bdd Bdd::and_next(const Bdd& other) const {
  assert(valid() && kernel_ == other.kernel_);
  return kernel_->run([&] { return bdd::and_next(*kernel_, edge_, other.edge_); });
}

Bdd Bdd::and_exists_next(const Bdd& other, const Bdd& cube) const {
  assert(valid() && kernel_ == other.kernel_ && kernel_ == cube.kernel_);
  return kernel_->run([&] { return bdd::and_exists_next(*kernel_, edge_, other.edge_, cube.edge_); });
}

Bdd Bdd::implies_forall_next(const Bdd& other, const Bdd& cube) const {
  assert(valid() && kernel_ == other.kernel_ && kernel_ == cube.kernel_);
  return kernel_->run(
      [&] { return bdd::and_exists_next(*kernel_, edge_, other.edge_ ^ 1U, cube.edge_) ^ 1U; });
}

Bdd Bdd::cofactor(const Bdd& cube) const {
  assert(valid() && kernel_ == cube.kernel_ && !cube.is_false());
  return kernel_->run([&] { return bdd::cofactor(*kernel_, edge_, cube.edge_); });
}

Bdd Bdd::cofactor(Var variable, bool value) const {
  assert(valid() && variable < kernel_->variable_count());
  if (kernel_->variable(edge_) == variable + 1) return value ? high() : low();
  return cofactor(manager().literal(variable, value));
}

Bdd Bdd::restrict(const Bdd& care) const {
  assert(valid() && kernel_ == care.kernel_);
  return kernel_->run([&] { return restrict_to(*kernel_, edge_, care.edge_); });
}

Bdd Bdd::constrain(const Bdd& care) const {
  assert(valid() && kernel_ == care.kernel_);
  return kernel_->run([&] { return constrain_to(*kernel_, edge_, care.edge_); });
}

Bdd Bdd::minimise(const Bdd& care) const {
  Bdd smaller = restrict(care);
  return smaller.node_count() < node_count() ? smaller : *this;
}

Bdd Bdd::compose(std::span<const std::pair<Var, Bdd>> substitution) const {
  assert(valid());
  // Made anew in each attempt: a reordering between two of them moves the last level.
  return kernel_->run([&] {
    Substitution map{{}, 0, kernel_->new_substitution()};
    for (std::uint32_t v = 0; v <= kernel_->variable_count(); ++v) {
      kernel_->push(v == 0 ? true_edge : kernel_->make(v, false_edge, true_edge));
      map.function.push_back(v == 0 ? true_edge : kernel_->make(v, false_edge, true_edge));
    }
    for (const auto& [variable, function] : substitution) {
      assert(variable < kernel_->variable_count() && function.kernel_ == kernel_);
      map.function[variable + 1] = function.edge_;
      map.last_level = std::max(map.last_level, kernel_->level_of(variable + 1));
    }
    const Edge result = substitution.empty() ? edge_ : bdd::compose(*kernel_, edge_, map);
    kernel_->pop(kernel_->variable_count() + 1);
    return result;
  });
}

Bdd Bdd::compose(Var variable, const Bdd& function) const {
  const std::pair<Var, Bdd> substitution[] = {{variable, function}};
  return compose(substitution);
}

Bdd Bdd::support() const {
  const std::vector<Var> variables = support_variables();
  return manager().cube(variables);
}

std::vector<Var> Bdd::support_variables() const {
  assert(valid());
  std::vector<Var> variables = bdd::support_variables(*kernel_, edge_);
  for (Var& variable : variables) --variable;
  return variables;
}

bool Bdd::depends_on(Var variable) const {
  assert(valid());
  return bdd::depends_on(*kernel_, edge_, variable + 1);
}

double Bdd::count(std::size_t variables) const {
  assert(valid());
  return count_double(*kernel_, edge_, variables);
}

std::vector<std::uint64_t> Bdd::count_words(std::size_t variables) const {
  assert(valid());
  return count_exactly(*kernel_, edge_, variables);
}

std::string Bdd::count_decimal(std::size_t variables) const {
  return decimal(count_words(variables));
}

std::size_t Bdd::node_count() const {
  assert(valid());
  const Edge roots[] = {edge_};
  return shared_size(*kernel_, roots);
}

Var Bdd::top() const {
  assert(valid() && !is_constant());
  return kernel_->variable(edge_) - 1;
}

Bdd Bdd::low() const {
  assert(valid() && !is_constant());
  return Bdd(kernel_, kernel_->low(edge_));
}

Bdd Bdd::high() const {
  assert(valid() && !is_constant());
  return Bdd(kernel_, kernel_->high(edge_));
}

}  // namespace heed::bdd
