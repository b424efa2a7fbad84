// Forward through the product of chain and machine, one layer per cell. Runs that have a category go on to
// the last cell, since fallbacks and missing rows are counted over the whole run.
#include <heed/sim/exact.h>

#include <compare>
#include <map>
#include <utility>

#include "letters.h"

namespace heed::sim {
namespace {

/// Where a run stands after a cell.
struct Standing {
  std::uint32_t chain = 0;
  std::uint32_t machine = 0;
  std::uint32_t category = Judge::none;
  bool fallback = false;
  friend auto operator<=>(const Standing&, const Standing&) = default;
};

using Layer = std::map<Standing, Rational>;

class ExactRun {
 public:
  ExactRun(const Run& run, util::Budget& budget) : run_(run), budget_(budget), letters_(run) {
    outcome_.probability.resize(run.judge.categories.size());
    outcome_.event_at.resize(run.chain.cells + 1);
  }

  ExactOutcome compute() {
    Layer layer;
    observe({}, run_.machine.input_letter(run_.binding.blank), 1, layer);
    for (observation_ = 1; observation_ <= run_.chain.cells; ++observation_) {
      const Layer before = std::exchange(layer, {});
      for (const auto& [standing, probability] : before) step(standing, probability, layer);
    }
    for (const auto& [standing, probability] : layer) {
      settle(standing.category == Judge::none ? run_.judge.never : standing.category, probability);
      if (standing.fallback) outcome_.fallback += probability;
    }
    return std::move(outcome_);
  }

 private:
  void step(const Standing& standing, const Rational& probability, Layer& next) {
    budget_.check();
    const Chain& chain = run_.chain;
    for (std::uint32_t i = chain.first[standing.chain]; i < chain.first[standing.chain + 1]; ++i) {
      const Chain::Step& drawn = chain.steps[i];
      Standing moved = standing;
      moved.chain = drawn.next;
      observe(moved, letters_.letter(drawn.seen), probability * drawn.probability, next);
    }
  }

  /// The machine reads a letter.
  void observe(Standing standing, std::optional<std::uint32_t> read, const Rational& probability,
               Layer& next) {
    const auto* row = read ? run_.machine.find(standing.machine, *read) : nullptr;
    if (!row) return stop(standing, probability);
    const auto index = static_cast<std::size_t>(row - run_.machine.transitions.data());
    if (standing.category == Judge::none) {
      standing.category = run_.judge.event[index];
      if (standing.category != Judge::none) outcome_.event_at[observation_] += probability;
    }
    standing.machine = row->next;
    standing.fallback |= row->fallback;
    next[standing] += probability;
  }

  void stop(const Standing& standing, const Rational& probability) {
    outcome_.missing += probability;
    if (standing.fallback) outcome_.fallback += probability;
    if (standing.category == Judge::none)
      outcome_.undefined += probability;
    else
      settle(standing.category, probability);
  }

  void settle(std::uint32_t category, const Rational& probability) {
    outcome_.probability[category] += probability;
  }

  const Run& run_;
  util::Budget& budget_;
  ExactOutcome outcome_;
  std::uint32_t observation_ = 0;  ///< Now: 0 the blank one, then cell + 1.
  LetterCache letters_;
};

}  // namespace

ExactOutcome exact_outcome(const Run& run, util::Budget& budget) {
  assert_fits(run);
  return ExactRun(run, budget).compute();
}

}  // namespace heed::sim
