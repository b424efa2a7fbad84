#include "core.h"

#include "names.h"

#include <heed/game/solve.h>

#include <algorithm>

namespace heed::game {
namespace {

/// One clause of the system: which part it stands in, and where.
struct Candidate {
  std::vector<bool> Selection::*part;
  std::size_t index;
  const spec::Clause* clause;
};

std::vector<Candidate> candidates(const spec::Gr1& spec) {
  std::vector<Candidate> result;
  for (std::size_t i = 0; i < spec.sys_init.size(); ++i)
    result.push_back({&Selection::init, i, &spec.sys_init[i]});
  for (std::size_t i = 0; i < spec.sys_safety.size(); ++i)
    result.push_back({&Selection::safety, i, &spec.sys_safety[i]});
  for (std::size_t i = 0; i < spec.sys_justice.size(); ++i)
    result.push_back({&Selection::justice, i, &spec.sys_justice[i]});
  return result;
}

/// Tries to lose clauses, many at first, and keeps what stays unrealizable. \cite zeller.02.tse
class Deletion {
 public:
  Deletion(const Game& game, util::Budget& budget, std::uint64_t steps)
      : game_(game), budget_(budget), steps_(steps), candidates_(candidates(*game.spec)) {
    selection_.init.assign(game.spec->sys_init.size(), true);
    selection_.safety.assign(game.spec->sys_safety.size(), true);
    selection_.justice.assign(game.spec->sys_justice.size(), true);
  }

  std::vector<std::string> run() {
    std::size_t chunk = 1;
    while (chunk * 2 <= candidates_.size()) chunk *= 2;
    for (; chunk > 0; chunk /= 2)
      for (std::size_t end = candidates_.size(); end > 0; end -= std::min(chunk, end))
        drop(end - std::min(chunk, end), end);
    std::vector<std::string> texts;
    for (const Candidate& candidate : candidates_)
      if ((selection_.*candidate.part)[candidate.index])
        texts.push_back(candidate.part == &Selection::justice ? goal_text(*candidate.clause)
                                                              : clause_text(*candidate.clause));
    return texts;
  }

 private:
  void drop(std::size_t begin, std::size_t end) {
    Selection smaller = selection_;
    for (std::size_t i = begin; i < end; ++i) (smaller.*candidates_[i].part)[candidates_[i].index] = false;
    if (smaller.init == selection_.init && smaller.safety == selection_.safety &&
        smaller.justice == selection_.justice)
      return;
    if (steps_ == 0) return;
    SolveOptions options;
    options.stop_early = true;
    options.max_steps = steps_;
    const Region region = solve(select(game_, smaller), budget_, options);
    steps_ -= std::min(steps_, std::max<std::uint64_t>(region.steps, 1));
    if (region.complete && !region.realizable) selection_ = std::move(smaller);
  }

  const Game& game_;
  util::Budget& budget_;
  std::uint64_t steps_;
  std::vector<Candidate> candidates_;
  Selection selection_;
};

}  // namespace

std::vector<std::string> unrealizable_core(const Game& game, util::Budget& budget, std::uint64_t steps) {
  return Deletion(game, budget, steps).run();
}

}  // namespace heed::game
