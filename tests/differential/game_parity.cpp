#include "game_parity.h"

#include <algorithm>

namespace heed::reference {
namespace {

using Set = std::vector<bool>;

class Zielonka {
 public:
  explicit Zielonka(const ParityGame& game) : game_(game), predecessors_(game.positions.size()) {
    for (std::uint32_t v = 0; v < game.positions.size(); ++v)
      for (const std::uint32_t w : game.positions[v].successors) predecessors_[w].push_back(v);
  }

  /// The system's part of the subgame \p in.
  Set solve(const Set& in) {
    int top = -1;
    for (std::uint32_t v = 0; v < in.size(); ++v)
      if (in[v]) top = std::max(top, game_.positions[v].colour);
    if (top < 0) return Set(in.size());
    const bool system = top % 2 == 0;
    Set tops(in.size());
    for (std::uint32_t v = 0; v < in.size(); ++v) tops[v] = in[v] && game_.positions[v].colour == top;
    const Set inner = minus(in, attractor(in, tops, system));
    const Set other = of_other(inner, solve(inner), system);
    if (empty(other)) return system ? in : Set(in.size());
    const Set lost = attractor(in, other, !system);
    const Set rest = minus(in, lost);
    const Set won = solve(rest);
    if (system) return won;
    Set all = won;
    for (std::size_t v = 0; v < all.size(); ++v) all[v] = all[v] || lost[v];
    return all;
  }

 private:
  static Set minus(const Set& a, const Set& b) {
    Set result(a.size());
    for (std::size_t v = 0; v < a.size(); ++v) result[v] = a[v] && !b[v];
    return result;
  }

  static bool empty(const Set& set) { return std::find(set.begin(), set.end(), true) == set.end(); }

  static Set of_other(const Set& in, const Set& systems, bool system) {
    return system ? minus(in, systems) : systems;
  }

  Set attractor(const Set& in, const Set& target, bool system) const {
    Set result = target;
    std::vector<std::uint32_t> queue;
    std::vector<std::size_t> open(in.size());
    for (std::uint32_t v = 0; v < in.size(); ++v) {
      if (result[v]) queue.push_back(v);
      for (const std::uint32_t w : game_.positions[v].successors) open[v] += in[w] ? 1 : 0;
    }
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (const std::uint32_t v : predecessors_[queue[i]]) {
        if (!in[v] || result[v]) continue;
        if (game_.positions[v].system != system && --open[v] > 0) continue;
        result[v] = true;
        queue.push_back(v);
      }
    return result;
  }

  const ParityGame& game_;
  std::vector<std::vector<std::uint32_t>> predecessors_;
};

}  // namespace

std::vector<bool> winning(const ParityGame& game) {
  return Zielonka(game).solve(Set(game.positions.size(), true));
}

}  // namespace heed::reference
