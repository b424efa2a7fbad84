#include <heed/bdd/cofactor_table.h>

#include <algorithm>
#include <cassert>

#include "operations.h"

namespace heed::bdd {

CofactorTable::CofactorTable(Manager& manager, std::span<const Var> order, std::size_t width)
    : kernel_(manager.kernel_.get()), width_(width), vectors_(width + 1), now_(width + 1, 0) {
  literals_.reserve(order.size());
  for (const Var variable : order)
    literals_.push_back({manager.literal(variable, false), manager.literal(variable, true)});
  kernel_->handles.attach({&vectors_.letters(), width + 1});
  kernel_->handles.attach({&now_, width + 1});
}

CofactorTable::~CofactorTable() {
  kernel_->handles.detach(&vectors_.letters());
  kernel_->handles.detach(&now_);
}

CofactorTable::Id CofactorTable::root(std::span<const Bdd> functions) {
  assert(functions.size() == width_);
  now_[0] = 0;
  for (std::size_t i = 0; i < width_; ++i) {
    assert(functions[i].kernel_ == kernel_);
    now_[1 + i] = functions[i].edge_;
  }
  return intern();
}

CofactorTable::Id CofactorTable::root(const CofactorTable& from, Id id, std::span<const std::uint32_t> places,
                                      const Bdd& cube) {
  assert(places.size() == width_ && from.kernel_ == kernel_ && cube.kernel_ == kernel_);
  kernel_->run_many([&] {
    now_[0] = 0;
    for (std::size_t i = 0; i < width_; ++i)
      now_[1 + i] = cofactor(*kernel_, from.edge(id, places[i]), cube.edge_);
  });
  return intern();
}

CofactorTable::Id CofactorTable::make_step(Id id, bool value) {
  const std::uint32_t depth = vectors_[id][0];
  assert(depth < literals_.size());
  const Edge literal = literals_[depth][value ? 1 : 0].edge_;
  kernel_->run_many([&] {
    now_[0] = depth + 1;
    for (std::size_t i = 0; i < width_; ++i) now_[1 + i] = cofactor(*kernel_, edge(id, i), literal);
  });
  const Id next = intern();
  steps_[id].next[value ? 1 : 0] = next;
  return next;
}

CofactorTable::Id CofactorTable::intern() {
  const auto [id, added] = vectors_.number(std::span<const std::uint32_t>(now_));
  if (added) steps_.emplace_back();
  return id;
}

bool CofactorTable::evaluate(Id id, std::size_t place, const std::vector<bool>& assignment) const {
  Edge at = edge(id, place);
  while (at > 1) at = assignment[kernel_->variable(at) - 1] ? kernel_->high(at) : kernel_->low(at);
  return at == true_edge;
}

bool CofactorTable::literals(Id id, std::size_t place, std::vector<Literal>& into) const {
  into.clear();
  Edge at = edge(id, place);
  while (at > 1) {
    const Edge low = kernel_->low(at), high = kernel_->high(at);
    if (low != false_edge && high != false_edge) return false;
    into.push_back({kernel_->variable(at) - 1, low == false_edge});
    at = low == false_edge ? high : low;
  }
  return at == true_edge;
}

}  // namespace heed::bdd
