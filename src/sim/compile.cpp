// Profile to chain: unfold layer by layer, then join states with the same future from the last layer back.
// Joining afterwards is what makes the chain small (an onset that no longer changes anything disappears);
// joining alone would have to build everything first, hence forgetting while unfolding as well
// (chain_builder.cpp).
#include <fmt/format.h>
#include <heed/util/diagnostic.h>

#include <map>
#include <utility>

#include "chain_builder.h"
#include "chain_join.h"

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

void check_size(const Unfolded& result, const ProfileSpec& profile, const ChainLimits& limits) {
  if (result.count > limits.steps)
    throw util::LimitExceeded(
        util::LimitExceeded::Kind::Size,
        fmt::format("the chain of profile '{}' has more than {} transitions", profile.name, limits.steps));
}

/// All cells. Incomplete when the unfolder came to want something drawn ahead.
Unfolded unfold(CellUnfolder& unfolder, const ProfileSpec& profile, const ChainLimits& limits,
                util::Budget& budget) {
  Unfolded result;
  result.steps.emplace_back();
  Layer next;
  for (const Branch& hidden : unfolder.start()) {
    std::vector<Branch> branches = unfolder.unfold(hidden.knowledge, 0);
    for (Branch& branch : branches) branch.probability *= hidden.probability;
    add_steps(result, 0, std::move(branches), next);
    check_size(result, profile, limits);
  }
  for (std::uint32_t cell = 1; cell < profile.cells && !unfolder.wanted_ahead(); ++cell) {
    const Layer layer = std::exchange(next, {});
    for (const auto& [knowledge, state] : layer) {
      budget.check();
      add_steps(result, state, unfolder.unfold(knowledge, cell), next);
      check_size(result, profile, limits);
      if (unfolder.wanted_ahead()) break;
    }
  }
  return result;
}

}  // namespace

Chain compile(const ProfileSpec& profile, util::Budget& budget, const ChainLimits& limits) {
  const ProfileModel model(profile);
  std::vector<bool> ahead(model.units.size(), false);
  for (;;) {
    CellUnfolder unfolder(model, ahead, limits.branches, budget);
    Unfolded unfolded = unfold(unfolder, profile, limits, budget);
    if (unfolder.wanted_ahead()) {
      ahead = *unfolder.wanted_ahead();
      continue;
    }
    return join_states(std::move(unfolded.steps), {model.spec.name, model.names, model.spec.cells, {}, {}},
                       budget);
  }
}

}  // namespace heed::sim
