#include "chain_join.h"

#include <algorithm>
#include <map>
#include <utility>

namespace heed::sim {
namespace {

using StateSteps = std::vector<std::vector<Chain::Step>>;

/// Any total order on canonical fractions; cheaper than comparing values.
int compare(const Rational& a, const Rational& b) {
  const int by_numerator = cmp(a.get_num(), b.get_num());
  return by_numerator != 0 ? by_numerator : cmp(a.get_den(), b.get_den());
}

struct StepsLess {
  bool operator()(const std::vector<Chain::Step>* a, const std::vector<Chain::Step>* b) const {
    if (a->size() != b->size()) return a->size() < b->size();
    for (std::size_t i = 0; i < a->size(); ++i) {
      const Chain::Step &x = (*a)[i], &y = (*b)[i];
      if (x.seen != y.seen) return x.seen < y.seen;
      if (x.next != y.next) return x.next < y.next;
      if (const int order = compare(x.probability, y.probability); order != 0) return order < 0;
    }
    return false;
  }
};

/// Redirects steps to the joined states, and adds up those that become equal.
void redirect(std::vector<Chain::Step>& steps, const std::vector<std::uint32_t>& joined) {
  std::map<std::pair<std::uint64_t, std::uint32_t>, Rational> sums;
  for (const Chain::Step& step : steps) sums[{step.seen, joined[step.next]}] += step.probability;
  steps.clear();
  for (auto& [key, probability] : sums) steps.push_back({std::move(probability), key.second, key.first});
}

/// Lets every step lead to the first state found with the same future.
void join(StateSteps& states, util::Budget& budget) {
  std::vector<std::uint32_t> joined(states.size());
  std::map<const std::vector<Chain::Step>*, std::uint32_t, StepsLess> known;
  for (std::size_t i = states.size(); i-- > 0;) {
    budget.check();
    redirect(states[i], joined);
    joined[i] = known.emplace(&states[i], static_cast<std::uint32_t>(i)).first->second;
  }
}

/// Numbers the states in the order of a breadth-first walk.
Chain number(const StateSteps& states, Chain chain) {
  constexpr std::uint32_t unseen = UINT32_MAX;
  chain.first = {0};
  chain.steps.clear();
  std::vector<std::uint32_t> numbers(states.size(), unseen), order{0};
  numbers[0] = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (const Chain::Step& step : states[order[i]]) {
      std::uint32_t& target = numbers[step.next];
      if (target == unseen) {
        target = static_cast<std::uint32_t>(order.size());
        order.push_back(step.next);
      }
      chain.steps.push_back({step.probability, target, step.seen});
    }
    std::sort(chain.steps.begin() + chain.first.back(), chain.steps.end(),
              [](const Chain::Step& a, const Chain::Step& b) {
                return std::pair(a.seen, a.next) < std::pair(b.seen, b.next);
              });
    chain.first.push_back(static_cast<std::uint32_t>(chain.steps.size()));
  }
  return chain;
}

}  // namespace

Chain join_states(StateSteps steps, Chain frame, util::Budget& budget) {
  join(steps, budget);
  return number(steps, std::move(frame));
}

}  // namespace heed::sim
