// From profile and machine to what is counted: components, the machine's answers as diagrams over what they
// report, letters and components that it does not tell apart, groups that it treats alike.
#include <heed/sim/lumping.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "chain_join.h"
#include "components.h"
#include "counted.h"
#include "lumped_run.h"
#include "reaction_sources.h"

namespace heed::sim {

Figure known(Rational value) {
  double rounded = to_double(value);  // cut off; the next one may be nearer
  const double above = std::nextafter(rounded, std::numeric_limits<double>::infinity());
  if (Rational(above) - value < value - Rational(rounded)) rounded = above;
  const double error = Rational(rounded) == value ? 0 : rounded * 0x1p-52;
  return {std::move(value), rounded, error};
}

Figure operator+(const Figure& a, const Figure& b) {
  if (a.exact && b.exact) return known(*a.exact + *b.exact);
  const double sum = a.value + b.value;
  return {std::nullopt, sum, a.error + b.error + 0x1p-52 * sum};
}

Figure complement(const Figure& a) {
  if (a.exact) return known(1 - *a.exact);
  return {std::nullopt, 1 - a.value, a.error + 0x1p-52};
}

Figure scaled(const Figure& a, unsigned factor) {
  if (a.exact) return known(*a.exact * factor);
  return {std::nullopt, a.value * factor, a.error * factor + 0x1p-52 * a.value * factor};
}

// With a' within da of a and b' within db of b: |a/b - a'/b'| <= (da + (a'/b') db) / (b' - db).
Figure ratio(const Figure& a, const Figure& b) {
  if (a.exact && b.exact) return known(*a.exact / *b.exact);
  const double quotient = a.value / b.value;
  const double error = (a.error + quotient * b.error) / (b.value - b.error);
  return {std::nullopt, quotient, error * (1 + 0x1p-40) + 0x1p-50 * quotient};
}

ReactionDistance reaction_distance(const LumpedOutcome& outcome) {
  ReactionDistance distance{known(0), known(0), std::nullopt};
  const auto cells = static_cast<unsigned>(outcome.event_at.size() - 1);
  for (unsigned i = 0; i <= cells; ++i) {
    distance.mean = distance.mean + scaled(outcome.event_at[i], cells - i);
    distance.reacts = distance.reacts + outcome.event_at[i];
  }
  const Figure& reacts = distance.reacts;
  if (reacts.exact ? *reacts.exact > 0 : reacts.value > 2 * reacts.error)
    distance.when_it_reacts = ratio(distance.mean, reacts);
  return distance;
}

namespace {

std::vector<std::uint32_t> letter_counts(const std::vector<Component>& components) {
  std::vector<std::uint32_t> counts;
  for (const Component& component : components)
    counts.push_back(static_cast<std::uint32_t>(component.letters.size()));
  return counts;
}

/// The chain with letters that have the same effect made one; what is seen is the place among \p staying.
Chain renamed(const Component& component, const std::vector<std::uint32_t>& same,
              const std::vector<std::uint32_t>& staying, util::Budget& budget) {
  const Chain& chain = component.chain;
  std::vector<std::vector<Chain::Step>> steps(chain.state_count());
  for (std::uint32_t s = 0; s < chain.state_count(); ++s)
    for (std::uint32_t i = chain.first[s]; i < chain.first[s + 1]; ++i) {
      Chain::Step step = chain.steps[i];
      const auto letter = std::lower_bound(component.letters.begin(), component.letters.end(), step.seen) -
                          component.letters.begin();
      const auto place =
          std::lower_bound(staying.begin(), staying.end(), same[static_cast<std::size_t>(letter)]);
      step.seen = static_cast<std::uint64_t>(place - staying.begin());
      steps[s].push_back(std::move(step));
    }
  return join_states(std::move(steps), {chain.profile, chain.features, chain.cells, {}, {}}, budget);
}

/// Drops what the machine never reads, and puts into groups what it treats alike.
void lump(const std::vector<Component>& components, LumpedModel& model, util::Budget& budget) {
  const auto same = same_letters(model.machine.reactions);
  std::vector<std::vector<std::uint32_t>> staying(same.size());
  for (std::size_t level = 0; level < same.size(); ++level)
    for (std::uint32_t x = 0; x < same[level].size(); ++x)
      if (same[level][x] == x) staying[level].push_back(x);
  model.machine = narrowed(model.machine, staying, budget);
  std::size_t level = 0;
  for (std::size_t c = 0; c < components.size(); ++c) {
    if (staying[c].size() == 1) continue;
    Chain chain = renamed(components[c], same[c], staying[c], budget);
    if (!model.groups.empty() && same_chain(model.groups.back().chain, chain) &&
        exchangeable(model.machine.reactions, level - 1))
      ++model.groups.back().count;
    else
      model.groups.push_back({std::move(chain), 1});
    ++level;
  }
}

/// Bits that the denominators of one run's probability may have together: per cell the least common multiple.
double denominator_bits(const LumpedModel& model) {
  double bits = 0;
  for (const LumpGroup& group : model.groups) {
    const Chain& chain = group.chain;
    std::vector<std::uint32_t> depth(chain.state_count(), 0);
    std::vector<mpz_class> common(chain.cells + 1, 1);
    for (std::uint32_t s = 0; s < chain.state_count(); ++s)
      for (std::uint32_t i = chain.first[s]; i < chain.first[s + 1]; ++i) {
        depth[chain.steps[i].next] = depth[s] + 1;
        mpz_class& at = common[depth[s]];
        mpz_lcm(at.get_mpz_t(), at.get_mpz_t(), chain.steps[i].probability.get_den_mpz_t());
      }
    for (const mpz_class& multiple : common)
      bits += group.count * (static_cast<double>(mpz_sizeinbase(multiple.get_mpz_t(), 2)) - 1);
  }
  return bits;
}

/// Doubles first: they tell what fractions would cost.
LumpedOutcome analyse(const LumpedModel& model, const LumpOptions& options, util::Budget& budget) {
  LumpedOutcome outcome = run_lumped<Counted>(model, options, budget);
  const double words = 8 + denominator_bits(model) / 64;
  if (static_cast<double>(outcome.lumps.steps) * words >= options.exact_work) return outcome;
  return run_lumped<Rational>(model, options, budget);
}

LumpedModel make_model(const ProfileSpec& profile, const std::vector<Component>& components,
                       ReactionSource& source, util::Budget& budget) {
  LumpedModel model{
      merged(explore(source, letter_counts(components), budget), budget), {}, profile.cells, 0, 0};
  lump(components, model, budget);
  return model;
}

}  // namespace

LumpedOutcome lumped_outcome(const ProfileSpec& profile, const model::Mealy& machine, const Binding& binding,
                             const Judge& judge, const LumpOptions& options, util::Budget& budget) {
  const auto components = compile_components(profile, binding, budget);
  const auto source = reactions_of(machine, binding, judge, components);
  LumpedModel model = make_model(profile, components, *source, budget);
  model.categories = judge.categories.size();
  model.never = judge.never;
  return analyse(model, options, budget);
}

LumpedOutcome lumped_outcome(const ProfileSpec& profile, const model::SymbolicController& machine,
                             const Binding& binding, const SymbolicJudge& judge, const LumpOptions& options,
                             util::Budget& budget) {
  const auto components = compile_components(profile, binding, budget);
  const auto source = reactions_of(machine, binding, judge, components, budget);
  LumpedModel model = make_model(profile, components, *source, budget);
  model.categories = judge.categories.size();
  model.never = judge.never;
  return analyse(model, options, budget);
}

}  // namespace heed::sim
