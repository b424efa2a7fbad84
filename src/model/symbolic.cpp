#include <heed/model/symbolic.h>

#include <tuple>

namespace heed::model {

bool evaluate(const Diagrams& diagrams, Function function, const std::vector<bool>& bits) {
  bool negated = false;
  while (function >> 1 != 0) {
    negated ^= (function & 1U) != 0;
    const Diagrams::Node& node = diagrams.nodes[(function >> 1) - 1];
    function = bits[node.bit] ? node.high : node.low;
  }
  return negated == ((function & 1U) != 0);
}

std::size_t bit_width(const Domain& domain) {
  std::size_t bits = 0;
  while ((std::int64_t{1} << bits) < domain.size()) ++bits;
  return bits;
}

namespace {

bool same(const Variable& a, const Variable& b) {
  return std::tie(a.name, a.domain, a.comment) == std::tie(b.name, b.domain, b.comment);
}

bool same(const Output& a, const Output& b) {
  return same(a.variable, b.variable) && a.role == b.role;
}

template <typename T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!same(a[i], b[i])) return false;
  return true;
}

}  // namespace

bool SymbolicController::operator==(const SymbolicController& other) const {
  const auto parts = [](const SymbolicController& c) {
    return std::tie(c.name, c.assumptions, c.notes, c.diagrams, c.start, c.legal, c.updates, c.derived,
                    c.winning, c.goals);
  };
  return parts(*this) == parts(other) && same(inputs, other.inputs) && same(outputs, other.outputs) &&
         same(memories, other.memories) && same(definitions, other.definitions);
}

}  // namespace heed::model
