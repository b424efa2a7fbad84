#include "schedule.h"

#include <algorithm>
#include <map>
#include <numeric>

/// In which order conjuncts meet a set and when variables go. The order that was written is often a good one,
/// since neighbours speak of the same things: it decides where nothing else does, and conjuncts are put
/// together only where they share variables.
namespace heed::game {
namespace {

using bdd::Bdd;
using Variables = std::vector<bdd::Var>;

bool overlap(const Variables& a, const Variables& b) {
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
    if (*i == *j) return true;
    *i < *j ? ++i : ++j;
  }
  return false;
}

/// Neighbours in the list conjoined where that costs nothing, or where they share variables and the result
/// stays small: every conjunct less is a pass less through the large diagrams that meet them.
std::vector<Bdd> clustered(const std::vector<Bdd>& parts, std::size_t most_nodes) {
  std::vector<Bdd> clusters;
  for (const Bdd& part : parts) {
    if (part.is_true()) continue;
    if (!clusters.empty() && most_nodes != 0) {
      Bdd& last = clusters.back();
      const Bdd joined = last & part;
      const bool related = overlap(last.support_variables(), part.support_variables());
      const std::size_t apart = last.node_count() + part.node_count();
      if (joined.node_count() <= (related ? std::max(apart, most_nodes) : apart)) {
        last = joined;
        continue;
      }
    }
    clusters.push_back(part);
  }
  return clusters;
}

/// Which variables of a cube each part has, and which of them no other part that is left has.
class Greedy {
 public:
  Greedy(const std::vector<Bdd>& parts, const Variables& variables)
      : supports_(parts.size()), own_(parts.size(), 0), taken_(parts.size(), false) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      for (const bdd::Var variable : parts[i].support_variables()) {
        if (!std::binary_search(variables.begin(), variables.end(), variable)) continue;
        supports_[i].push_back(variable);
        users_[variable].push_back(i);
      }
    }
    for (auto& [variable, users] : users_) {
      left_[variable] = users.size();
      if (users.size() == 1) ++own_[users.front()];
    }
  }

  /// Most variables to quantify at once; among equals, fewest to keep.
  [[nodiscard]] bool better(std::size_t a, std::size_t b) const {
    if (own_[a] != own_[b]) return own_[a] > own_[b];
    return supports_[a].size() < supports_[b].size();
  }

  void take(std::size_t part) {
    taken_[part] = true;
    for (const bdd::Var variable : supports_[part]) {
      if (--left_[variable] != 1) continue;
      for (const std::size_t user : users_[variable]) own_[user] += taken_[user] ? 0 : 1;
    }
  }

 private:
  std::vector<Variables> supports_;
  std::vector<std::size_t> own_;
  std::vector<bool> taken_;
  std::map<bdd::Var, std::vector<std::size_t>> users_;
  std::map<bdd::Var, std::size_t> left_;
};

/// The conjunct with most variables that no other one has comes first, and so on. \cite firman.20.acta
std::vector<Bdd> by_private_variables(const std::vector<Bdd>& parts, const Variables& variables) {
  Greedy greedy(parts, variables);
  std::vector<std::size_t> left(parts.size());
  std::iota(left.begin(), left.end(), std::size_t{0});
  std::vector<Bdd> order;
  while (!left.empty()) {
    const auto best = std::min_element(left.begin(), left.end(),
                                       [&](std::size_t a, std::size_t b) { return greedy.better(a, b); });
    greedy.take(*best);
    order.push_back(parts[*best]);
    left.erase(best);
  }
  return order;
}

}  // namespace

std::vector<Stage> schedule(std::vector<Bdd> parts, const Bdd& cube, const Techniques& techniques) {
  std::vector<Stage> stages;
  if (techniques.greedy_schedule) parts = by_private_variables(parts, cube.support_variables());
  parts = clustered(parts, techniques.cluster_nodes);
  Variables open = cube.support_variables();
  bdd::Manager& manager = cube.manager();
  for (std::size_t i = parts.size(); i-- > 0;) {
    const Variables support = parts[i].support_variables();
    Variables here;
    Variables earlier;
    for (const bdd::Var variable : open) {
      const bool mentioned = i == 0 || std::binary_search(support.begin(), support.end(), variable);
      (mentioned ? here : earlier).push_back(variable);
    }
    stages.push_back({parts[i], manager.cube(here)});
    open = std::move(earlier);
  }
  if (parts.empty()) stages.push_back({manager.constant(true), cube});
  std::reverse(stages.begin(), stages.end());
  return stages;
}

std::vector<Bdd> without_unread(std::vector<Bdd> parts, const Bdd& cube) {
  std::map<bdd::Var, std::vector<std::size_t>> users;
  for (const bdd::Var variable : cube.support_variables()) users[variable] = {};
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (const bdd::Var variable : parts[i].support_variables())
      if (const auto found = users.find(variable); found != users.end()) found->second.push_back(i);
  std::vector<Variables> own(parts.size());
  for (const auto& [variable, list] : users)
    if (list.size() == 1) own[list.front()].push_back(variable);
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (!own[i].empty()) parts[i] = parts[i].exists(cube.manager().cube(own[i]));
  std::erase_if(parts, [](const Bdd& part) { return part.is_true(); });
  return parts;
}

}  // namespace heed::game
