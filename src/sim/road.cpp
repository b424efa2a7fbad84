#include <heed/sim/road.h>

#include <compare>
#include <tuple>

#include "letters.h"
#include "long_run.h"

namespace heed::sim {
namespace {

/// Where an approach stands after a cell.
struct Point {
  std::uint32_t chain = 0, machine = 0, category = Judge::none;
  bool conflict = false;
  friend auto operator<=>(const Point&, const Point&) = default;
};

/// \p part times \p share, added to \p sum.
void add(RoadOutcome& sum, const RoadOutcome& part, const Rational& share) {
  for (std::size_t k = 0; k < sum.expected.size(); ++k)
    for (std::size_t c = 0; c < sum.expected[k].size(); ++c)
      sum.expected[k][c] += share * part.expected[k][c];
  sum.conflicts += share * part.conflicts;
}

}  // namespace

std::optional<std::uint32_t> RoadAnalysis::start() const {
  const auto letter = run_.machine.input_letter(run_.kinds.front().binding->blank);
  const auto* row = letter ? run_.machine.find(0, *letter) : nullptr;
  return row ? std::optional(row->next) : std::nullopt;
}

RoadOutcome RoadAnalysis::none() const {
  RoadOutcome outcome;
  outcome.expected.assign(run_.kinds.size(), std::vector<Rational>(run_.judge.categories.size(), 0));
  return outcome;
}

const std::vector<RoadAnalysis::End>& RoadAnalysis::approach(std::uint32_t state, std::size_t kind) {
  const auto [found, added] = approaches_.try_emplace({state, kind});
  if (added) found->second = drive(state, run_.kinds[kind]);
  return found->second;
}

std::vector<RoadAnalysis::End> RoadAnalysis::drive(std::uint32_t state, const Passage& passage) {
  const Chain& chain = *passage.chain;
  const Run one{chain, run_.machine, *passage.binding, run_.judge};
  LetterCache letters(one);
  std::vector<End> ends;
  std::map<Point, Rational> layer{{{0, state, Judge::none, false}, 1}};
  for (std::uint32_t cell = 0; cell < chain.cells; ++cell) {
    std::map<Point, Rational> next;
    for (const auto& [point, probability] : layer) {
      budget_.check();
      for (std::uint32_t i = chain.first[point.chain]; i < chain.first[point.chain + 1]; ++i) {
        const Chain::Step& step = chain.steps[i];
        const auto letter = letters.letter(step.seen);
        const auto* row = letter ? run_.machine.find(point.machine, *letter) : nullptr;
        if (row == nullptr) {
          const auto category = point.category == Judge::none ? std::nullopt : std::optional(point.category);
          ends.push_back({0, category, true, point.conflict, probability * step.probability});
          continue;
        }
        const auto index = static_cast<std::size_t>(row - run_.machine.transitions.data());
        Point moved{step.next, row->next, point.category, point.conflict};
        if (moved.category == Judge::none) moved.category = run_.judge.event[index];
        moved.conflict = moved.conflict || (!run_.conflict.empty() && run_.conflict[index]);
        next[moved] += probability * step.probability;
      }
    }
    layer = std::move(next);
  }
  for (const auto& [point, probability] : layer)
    ends.push_back({point.machine, point.category == Judge::none ? run_.judge.never : point.category, false,
                    point.conflict, probability});
  return ends;
}

RoadAnalysis::Standing RoadAnalysis::pass(const Standing& before, const Draw& draw, RoadOutcome& outcome) {
  Standing after;
  for (const auto& [standing, probability] : before)
    for (std::size_t kind = 0; kind < draw.size(); ++kind) {
      if (draw[kind] == 0) continue;
      for (const End& end : approach(standing.first, kind)) {
        const Rational p = probability * draw[kind] * end.probability;
        if (end.category) outcome.expected[kind][*end.category] += p;
        if (end.conflict) outcome.conflicts += p;
        if (end.conflict && !standing.second) outcome.conflict += p;
        if (end.missing)
          outcome.missing += p;
        else
          after[{end.next, standing.second || end.conflict}] += p;
      }
    }
  return after;
}

RoadOutcome RoadAnalysis::over(const std::vector<Draw>& places) {
  RoadOutcome outcome = none();
  const auto first = start();
  if (!first) {
    outcome.missing = 1;
    return outcome;
  }
  Standing standing{{{*first, false}, 1}};
  for (const Draw& draw : places) standing = pass(standing, draw, outcome);
  return outcome;
}

// States of the chain from cycle to cycle: those of the machine, and one for a drive that has ended.
std::optional<RoadOutcome> RoadAnalysis::in_the_long_run(const std::vector<Draw>& places, std::size_t most) {
  RoadOutcome result = none();
  const auto first = start();
  std::vector<std::uint32_t> states;
  std::map<std::uint32_t, std::size_t> numbers;
  const auto number = [&](std::uint32_t state) {
    if (numbers.try_emplace(state, states.size()).second) states.push_back(state);
    return numbers.at(state);
  };
  if (first) (void)number(*first);
  std::vector<RoadOutcome> rewards;
  std::vector<std::map<std::size_t, Rational>> rows;
  for (std::size_t s = 0; s < states.size(); ++s) {
    if (states.size() > most) return std::nullopt;
    rewards.push_back(none());
    Standing standing{{{states[s], false}, 1}};
    for (const Draw& draw : places) standing = pass(standing, draw, rewards.back());
    rows.emplace_back();
    for (const auto& [end, probability] : standing) rows.back()[number(end.first)] += probability;
  }
  const std::size_t ended = states.size();
  TransitionMatrix matrix(ended + 1, std::vector<Rational>(ended + 1, 0));
  matrix[ended][ended] = 1;
  for (std::size_t s = 0; s < ended; ++s) {
    for (const auto& [next, probability] : rows[s]) matrix[s][next] = probability;
    matrix[s][ended] = rewards[s].missing;
  }
  const std::vector<Rational> shares = long_run_shares(std::move(matrix), budget_);
  for (std::size_t s = 0; s < ended; ++s) add(result, rewards[s], shares[s]);
  result.missing = shares[ended];
  return result;
}

}  // namespace heed::sim
