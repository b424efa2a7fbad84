// Profile to chain: unfold layer by layer, then join states with the same future from the last layer back.
// Joining afterwards is what makes the chain small (an onset that no longer changes anything disappears);
// joining alone would have to build everything first, hence forgetting while unfolding as well
// (chain_builder.cpp).
#include <heed/util/diagnostic.h>

#include <algorithm>
#include <map>
#include <utility>

#include "chain_builder.h"

namespace heed::sim {
namespace {

struct Unfolded {
  std::vector<std::vector<Chain::Step>> steps;  ///< Per state; state 0 is the start.
  std::size_t count = 0;
};

using Layer = std::map<Knowledge, std::uint32_t>;

/// Adds the branches as steps of \p state, with new states in \p next.
void add_steps(Unfolded& result, std::uint32_t state, std::vector<Branch> branches, Layer& next) {
  for (Branch& branch : branches) {
    const auto [target, added] =
        next.emplace(std::move(branch.knowledge), static_cast<std::uint32_t>(result.steps.size()));
    if (added) result.steps.emplace_back();
    result.steps[state].push_back({std::move(branch.probability), target->second, branch.seen});
    ++result.count;
  }
}

void check_size(const Unfolded& result, const ProfileSpec& profile) {
  if (result.count > chain_step_limit)
    throw util::LimitExceeded(util::LimitExceeded::Kind::Size,
                              "the chain of profile '" + profile.name + "' has more than 2^20 transitions");
}

/// All cells. Incomplete when the unfolder came to want something drawn ahead.
Unfolded unfold(CellUnfolder& unfolder, const ProfileSpec& profile, util::Budget& budget) {
  Unfolded result;
  result.steps.emplace_back();
  Layer next;
  for (const Branch& hidden : unfolder.start()) {
    std::vector<Branch> branches = unfolder.unfold(hidden.knowledge, 0);
    for (Branch& branch : branches) branch.probability *= hidden.probability;
    add_steps(result, 0, std::move(branches), next);
    check_size(result, profile);
  }
  for (std::uint32_t cell = 1; cell < profile.cells && !unfolder.wanted_ahead(); ++cell) {
    const Layer layer = std::exchange(next, {});
    for (const auto& [knowledge, state] : layer) {
      budget.check();
      add_steps(result, state, unfolder.unfold(knowledge, cell), next);
      check_size(result, profile);
      if (unfolder.wanted_ahead()) break;
    }
  }
  return result;
}

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

/// For each state the first one found with the same future. States come layer by layer, so every step leads
/// to a higher one.
std::vector<std::uint32_t> join(Unfolded& unfolded, util::Budget& budget) {
  std::vector<std::uint32_t> joined(unfolded.steps.size());
  std::map<const std::vector<Chain::Step>*, std::uint32_t, StepsLess> known;
  for (std::size_t i = unfolded.steps.size(); i-- > 0;) {
    budget.check();
    redirect(unfolded.steps[i], joined);
    joined[i] = known.emplace(&unfolded.steps[i], static_cast<std::uint32_t>(i)).first->second;
  }
  return joined;
}

/// Numbers the states in the order of a breadth-first walk.
Chain number(const Unfolded& unfolded, const ProfileModel& model) {
  constexpr std::uint32_t unseen = UINT32_MAX;
  Chain chain{model.spec.name, model.names, model.spec.cells, {0}, {}};
  std::vector<std::uint32_t> numbers(unfolded.steps.size(), unseen), order{0};
  numbers[0] = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (const Chain::Step& step : unfolded.steps[order[i]]) {
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

Chain compile(const ProfileSpec& profile, util::Budget& budget) {
  const ProfileModel model(profile);
  std::vector<bool> ahead(model.units.size(), false);
  for (;;) {
    CellUnfolder unfolder(model, ahead, budget);
    Unfolded unfolded = unfold(unfolder, profile, budget);
    if (unfolder.wanted_ahead()) {
      ahead = *unfolder.wanted_ahead();
      continue;
    }
    (void)join(unfolded, budget);
    return number(unfolded, model);
  }
}

}  // namespace heed::sim
