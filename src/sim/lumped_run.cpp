// Forward, one layer per cell, over (how many components are in which state, state of the machine, category).
// Within a cell the components of one state are taken together: `law` says how many of n go where and at
// which node of the machine's diagram they leave it. It is drawn from that of n - 1, so that a layer costs
// its states times the ways to split them, not the order in which components come.
#include "lumped_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>

#include "counted.h"

namespace heed::sim {

std::uint32_t Multisets::number(const Content& content) {
  const auto [found, added] = numbers_.try_emplace(content, static_cast<std::uint32_t>(contents_.size()));
  if (added) {
    contents_.push_back(content);
    tails_.push_back(UINT32_MAX);
  }
  return found->second;
}

std::uint32_t Multisets::tail(std::uint32_t set) {
  if (tails_[set] == UINT32_MAX) {
    const std::uint32_t rest = number(Content(contents_[set].begin() + 1, contents_[set].end()));
    tails_[set] = rest;
  }
  return tails_[set];
}

std::uint32_t Multisets::sum(std::uint32_t a, std::uint32_t b) {
  if (a == empty) return b;
  if (b == empty) return a;
  const auto key = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
  const auto known = sums_.find(key);
  if (known != sums_.end()) return known->second;
  Content content;
  const Content &x = contents_[a], &y = contents_[b];
  std::size_t i = 0, j = 0;
  while (i < x.size() || j < y.size()) {
    if (j == y.size() || (i < x.size() && x[i].first < y[j].first)) {
      content.push_back(x[i++]);
    } else if (i == x.size() || y[j].first < x[i].first) {
      content.push_back(y[j++]);
    } else {
      content.emplace_back(x[i].first, x[i].second + y[j].second);
      ++i, ++j;
    }
  }
  return sums_.emplace(key, number(content)).first->second;
}

StateRow::StateRow(const std::vector<LumpGroup>& groups) {
  for (const LumpGroup& group : groups) {
    const Chain& chain = group.chain;
    const auto count = [&](std::uint32_t state) { return chain.first[state + 1] - chain.first[state]; };
    std::vector<std::uint32_t> order(chain.state_count()), place(chain.state_count());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return count(a) < count(b); });
    const auto offset = static_cast<std::uint32_t>(steps.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = offset + i;
    starts.push_back(place[0]);
    for (const std::uint32_t state : order) {
      steps.emplace_back();
      for (std::uint32_t i = chain.first[state]; i < chain.first[state + 1]; ++i)
        steps.back().push_back({&chain.steps[i].probability, place[chain.steps[i].next],
                                static_cast<std::uint32_t>(chain.steps[i].seen)});
    }
  }
}

namespace {

template <typename Number>
class LumpedRun {
 public:
  LumpedRun(const LumpedModel& model, const LumpOptions& options, util::Budget& budget)
      : model_(model), options_(options), budget_(budget), row_(model.groups) {
    for (const auto& steps : row_.steps) {
      numbers_.emplace_back();
      for (const StateRow::Step& step : steps) numbers_.back().emplace_back(*step.probability);
    }
    for (std::uint32_t e = 0; e < model.machine.reactions.ending_count(); ++e) {
      const Ending& ending = model.machine.reactions.ending(e);
      watched_ |= ending.next == Ending::nowhere || ending.fallback;
    }
    watched_ |= model.machine.start.fallback;
    find_decided();
    category_.resize(model.categories, zero());
    at_.resize(model.cells + 1, zero());
  }

  LumpedOutcome run() {
    Multisets::Content all;
    for (std::size_t g = 0; g < model_.groups.size(); ++g)
      all.emplace_back(row_.starts[g], model_.groups[g].count);
    std::sort(all.begin(), all.end());
    arrive(model_.machine.start, now_.number(all), 0, Number(Rational(1)));
    for (cell_ = 1; cell_ <= model_.cells; ++cell_) pass_cell();
    for (std::size_t i = 0; i < layer_.size(); ++i) end_run(layer_.key(i)[2], layer_.value(i));
    return outcome();
  }

 private:
  using Map = Tally<Number>;
  struct Part {
    std::uint32_t gone, node;
    Number probability;
  };
  using Law = std::vector<Part>;

  static Number zero() { return Number(Rational(0)); }

  /// A node below which every ending has the same event stands for that event, `decided` and its category:
  /// where nothing is watched after an event, it does not matter who reports what from there on.
  void find_decided() {
    const Reactions& reactions = model_.machine.reactions;
    children_.resize(reactions.size());
    std::vector<std::uint32_t> below;
    for (std::uint32_t e = 0; e < reactions.ending_count(); ++e) {
      const std::uint32_t event = reactions.ending(e).event;
      below.push_back(!watched_ && event != Ending::nowhere ? decided | event : e);
    }
    for (std::size_t level = reactions.levels(); level-- > 0;) {
      std::vector<std::uint32_t> here(reactions.size());
      for (const std::uint32_t node : reactions.nodes(level)) {
        const std::uint32_t first = below[reactions.child(node, 0)];
        bool alike = first >= decided;
        for (std::uint32_t x = 0; x < reactions.letters(level); ++x) {
          children_[node + x] = below[reactions.child(node, x)];
          alike = alike && children_[node + x] == first;
        }
        here[node] = alike ? first : node;
      }
      below = std::move(here);
    }
    for (const std::uint32_t root : model_.machine.roots) roots_.push_back(below[root]);
  }

  void pass_cell() {
    buckets_.clear();
    laws_.clear();
    law_numbers_.clear();
    next_ = {};
    const Map before = std::exchange(layer_, {});
    for (std::size_t i = 0; i < before.size(); ++i) {
      const auto& [set, state, tag, unused] = before.key(i);
      put({set, Multisets::empty, roots_[state], tag}, before.value(i));
    }
    while (!buckets_.empty()) {
      const Map bucket = std::move(buckets_.begin()->second);
      buckets_.erase(buckets_.begin());
      if (bucket.size() > 0 && now_.content(bucket.key(0)[0]).empty())
        finish(bucket);
      else
        deal(bucket);
    }
    widest_ = std::max<std::uint64_t>(widest_, layer_.size());
    now_ = std::move(next_);
  }

  /// Into the bucket of the first state that is left; what has nothing left comes last.
  void put(const typename Map::Key& key, const Number& value) {
    if (key[2] >= decided) {
      at_[cell_] += value;
      return end_run(key[3] | 2 * (key[2] - decided + 1), value);
    }
    const auto& left = now_.content(key[0]);
    const std::uint32_t first = left.empty() ? UINT32_MAX : left.front().first;
    Map& bucket = buckets_[first];
    bucket.add(key, value);
    if (bucket.size() > options_.most_states) too_large();
  }

  void deal(const Map& bucket) {
    for (std::size_t i = 0; i < bucket.size(); ++i) {
      budget_.check();
      const auto [left, gone, node, tag] = bucket.key(i);
      const auto [state, count] = now_.content(left).front();
      const std::uint32_t rest = now_.tail(left);
      const Law& parts = law(node, state, count);
      steps_ += parts.size();
      for (const Part& part : parts)
        put({rest, next_.sum(gone, part.gone), part.node, tag}, bucket.value(i) * part.probability);
    }
  }

  void finish(const Map& bucket) {
    for (std::size_t i = 0; i < bucket.size(); ++i) {
      const auto& [left, gone, node, tag] = bucket.key(i);
      arrive(model_.machine.reactions.ending(node), gone, tag, bucket.value(i));
    }
  }

  /// How \p count components in \p state move on from \p node.
  const Law& law(std::uint32_t node, std::uint32_t state, std::uint32_t count) {
    std::uint32_t known = count;
    auto found = law_numbers_.end();
    for (;; --known) {
      found = law_numbers_.find({node, state, known});
      if (found != law_numbers_.end() || known == 0) break;
    }
    if (found == law_numbers_.end()) {
      laws_.push_back({{Multisets::empty, node, Number(Rational(1))}});
      found = law_numbers_.emplace(std::array{node, state, 0U}, &laws_.back()).first;
    }
    for (; known < count; ++known) {
      laws_.push_back(one_more(*found->second, state));
      found = law_numbers_.emplace(std::array{node, state, known + 1}, &laws_.back()).first;
    }
    return *found->second;
  }

  Law one_more(const Law& fewer, std::uint32_t state) {
    budget_.check();
    Map sums;
    for (const Part& part : fewer) {
      if (part.node >= decided) {
        sums.add({Multisets::empty, part.node, 0, 0}, part.probability);
        continue;
      }
      for (std::size_t i = 0; i < row_.steps[state].size(); ++i) {
        const StateRow::Step& step = row_.steps[state][i];
        const std::uint32_t node = children_[part.node + step.letter];
        const std::uint32_t gone =
            node >= decided ? Multisets::empty : next_.sum(part.gone, next_.number({{step.next, 1}}));
        sums.add({gone, node, 0, 0}, part.probability * numbers_[state][i]);
      }
    }
    steps_ += sums.size();
    if (sums.size() > options_.most_states) too_large();
    Law result;
    for (std::size_t i = 0; i < sums.size(); ++i)
      result.push_back({sums.key(i)[0], sums.key(i)[1], sums.value(i)});
    return result;
  }

  // A tag is the category + 1, 0 for none, doubled; plus 1 after a fallback.
  void arrive(const Ending& ending, std::uint32_t set, std::uint32_t tag, const Number& probability) {
    if (ending.next == Ending::nowhere) {
      missing_ += probability;
      if (tag < 2) undefined_ += probability;
      return end_run(tag < 2 ? unknown | (tag & 1) : tag, probability);
    }
    if (tag < 2 && ending.event != Ending::nowhere) {
      tag |= 2 * (ending.event + 1);
      at_[cell_] += probability;
      if (!watched_) return end_run(tag, probability);
    }
    layer_.add({set, ending.next, tag | (ending.fallback ? 1U : 0U), 0}, probability);
    if (layer_.size() > options_.most_states) too_large();
  }

  void end_run(std::uint32_t tag, const Number& probability) {
    if (tag & 1) fallback_ += probability;
    if (tag >= unknown) return;
    category_[tag < 2 ? model_.never : tag / 2 - 1] += probability;
  }

  /// Decimal digits of how many ways there are to be after a cell, at most: multisets of each group's states.
  [[nodiscard]] double state_digits() const {
    double most = 0;
    std::vector<double> digits(model_.cells + 1, 0);
    for (const LumpGroup& group : model_.groups) {
      std::vector<std::uint32_t> depth(group.chain.state_count(), 0), states(model_.cells + 1, 0);
      for (std::uint32_t s = 0; s < group.chain.state_count(); ++s) {
        ++states[depth[s]];
        for (std::uint32_t i = group.chain.first[s]; i < group.chain.first[s + 1]; ++i)
          depth[group.chain.steps[i].next] = depth[s] + 1;
      }
      for (std::size_t cell = 0; cell < digits.size(); ++cell) {
        for (double i = 1; i < states[cell]; ++i) digits[cell] += std::log10((group.count + i) / i);
        most = std::max(most, digits[cell]);
      }
    }
    return most;
  }

  [[noreturn]] void too_large() const {
    std::uint32_t largest = 0, components = 0;
    for (const LumpGroup& group : model_.groups)
      largest = std::max(largest, group.count), components += group.count;
    throw util::LimitExceeded(
        util::LimitExceeded::Kind::Size,
        fmt::format(
            "more than {} states in cell {}, and up to 10^{:.0f}: {} independent components in {} "
            "groups of exchangeable ones, the largest of {}; let more of them have the same rules, or "
            "depend less on chance",
            options_.most_states, cell_ - 1, std::ceil(state_digits()), components, model_.groups.size(),
            largest));
  }

  LumpedOutcome outcome() {
    LumpedOutcome result;
    for (const Number& p : category_) result.probability.push_back(figure(p));
    result.undefined = figure(undefined_);
    result.missing = figure(missing_);
    result.fallback = figure(fallback_);
    for (const Number& p : at_) result.event_at.push_back(figure(p));
    result.exact = result.undefined.exact.has_value();
    Lumps& lumps = result.lumps;
    lumps.groups = static_cast<std::uint32_t>(model_.groups.size());
    for (const LumpGroup& group : model_.groups) {
      lumps.components += group.count;
      lumps.largest_group = std::max(lumps.largest_group, group.count);
    }
    lumps.machine_states = model_.machine.roots.size();
    lumps.widest_layer = widest_;
    lumps.steps = steps_;
    return result;
  }

  static constexpr std::uint32_t unknown = UINT32_MAX - 1;
  static constexpr std::uint32_t decided = std::uint32_t{1} << 31;  ///< Above all nodes, see reaction_limit.

  const LumpedModel& model_;
  const LumpOptions& options_;
  util::Budget& budget_;
  StateRow row_;
  std::vector<std::vector<Number>> numbers_;     ///< Per state and step.
  std::vector<std::uint32_t> children_, roots_;  ///< Of the machine's nodes, what is decided marked.
  bool watched_ = false;  ///< A run may have a fallback, or end early: it goes on after its event.
  std::uint32_t cell_ = 0;
  Multisets now_, next_;
  Map layer_;                             ///< Multiset, state of the machine, tag.
  std::map<std::uint32_t, Map> buckets_;  ///< Left, gone, node, tag; by the first state that is left.
  std::deque<Law> laws_;
  std::map<std::array<std::uint32_t, 3>, const Law*> law_numbers_;
  std::vector<Number> category_, at_;
  Number undefined_ = zero(), missing_ = zero(), fallback_ = zero();
  std::uint64_t widest_ = 0, steps_ = 0;
};

}  // namespace

template <typename Number>
LumpedOutcome run_lumped(const LumpedModel& model, const LumpOptions& options, util::Budget& budget) {
  return LumpedRun<Number>(model, options, budget).run();
}

template LumpedOutcome run_lumped<Rational>(const LumpedModel&, const LumpOptions&, util::Budget&);
template LumpedOutcome run_lumped<Counted>(const LumpedModel&, const LumpOptions&, util::Budget&);

}  // namespace heed::sim
