// Random profiles against a second implementation that knows nothing of chains: enumerate every vector of
// onsets with the product of the rules' laws, then every vector of reports.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <heed/util/random.h>

#include <algorithm>
#include <compare>
#include <functional>
#include <numeric>
#include <optional>

#include "unit/sim/case_study.h"
#include "unit/sim/paths.h"

namespace heed::sim {
namespace {

using namespace case_study;

constexpr int never = 1'000'000;
using Onsets = std::vector<int>;                     ///< Per feature; `never`.
using Law = std::map<int, Rational>;                 ///< Onset to probability.
using Cell = std::function<int(const Onsets&)>;      ///< An expression's meaning.
using OnsetLaw = std::function<Law(const Onsets&)>;  ///< A rule's meaning.

struct RandomProfile {
  ProfileSpec spec;
  std::vector<OnsetLaw> laws;  ///< Feature i refers to earlier ones only; empty for a shuffled one.
  std::vector<Cell> slots;     ///< Of the last features, if they are shuffled.
};

class Maker {
 public:
  Maker(std::uint64_t seed, std::uint32_t cells) : random_(seed, 0), cells_(static_cast<int>(cells)) {
    made_.spec.cells = cells;
  }

  RandomProfile make(int features, bool shuffle) {
    const int shuffled = shuffle ? 2 : 0;
    for (int i = 0; i < features; ++i) {
      FeatureSpec feature{fmt::format("f{}", i), ShuffledOnset{}};
      feature.absent = pick(6) == 0;
      feature.replaced = pick(6) == 0;
      if (pick(3) == 0) feature.detection = Rational(pick(4), 3);
      if (pick(3) == 0) feature.false_detection = Rational(pick(3), 4);
      if (pick(4) == 0) feature.detection_at_end = Rational(pick(5), 4);
      if (pick(4) == 0) feature.false_detection_at_end = Rational(pick(3), 3);
      if (pick(3) == 0) feature.persistent = pick(2) == 0;
      if (feature.detection_at_end) feature.detection_at_end->canonicalize();
      if (feature.false_detection_at_end) feature.false_detection_at_end->canonicalize();
      feature.detection.canonicalize();
      feature.false_detection.canonicalize();
      known_ = i < features - shuffled ? i : features - shuffled;
      if (i < features - shuffled) feature.onset = onset();
      made_.spec.features.push_back(feature);
    }
    if (shuffle) deal(features);
    misread(features);
    made_.spec.persistent = pick(2) == 0;
    if (pick(3) == 0) made_.spec.everything_visible_in = static_cast<std::uint32_t>(pick(cells_));
    return std::move(made_);
  }

 private:
  int pick(int bound) { return static_cast<int>(random_.below(static_cast<std::uint32_t>(bound))); }

  struct Expression {
    std::string text;
    Cell meaning;
  };
  Expression expression(int depth) {
    const int kind = pick(depth > 0 ? 6 : 3);
    if (kind == 0 || (kind < 3 && known_ == 0)) {
      const int n = pick(cells_ + 1);
      return {std::to_string(n), [n](const Onsets&) { return n; }};
    }
    if (kind < 3) {
      const auto f = static_cast<std::size_t>(pick(known_));
      return {fmt::format("f{}", f), [f](const Onsets& onsets) { return onsets[f]; }};
    }
    const Expression a = expression(depth - 1);
    if (kind == 3) {
      const int n = pick(4) - 1;
      return {fmt::format("({}) {} {}", a.text, n < 0 ? '-' : '+', std::abs(n)),
              [n, m = a.meaning](const Onsets& o) { return m(o) > never / 2 ? never : m(o) + n; }};
    }
    const Expression b = expression(depth - 1);
    const bool min = kind == 4;
    return {fmt::format("{}({}, {})", min ? "min" : "max", a.text, b.text),
            [min, x = a.meaning, y = b.meaning](const Onsets& o) {
              return min ? std::min(x(o), y(o)) : std::max(x(o), y(o));
            }};
  }
  /// Values below 0 act as 0.
  static Cell clamped(const Cell& cell) {
    return [cell](const Onsets& onsets) { return std::max(0, cell(onsets)); };
  }

  Onset onset() {
    const Expression first = expression(2);
    const Cell from = clamped(first.meaning);
    switch (pick(5)) {
      case 0:
        made_.laws.push_back([from](const Onsets& o) { return Law{{from(o), 1}}; });
        return FixedOnset{at(first.text)};
      case 1:
        return uniform(first);
      case 2:
        return geometric(first);
      case 3:
        return linear();
      default:
        return table(first);
    }
  }
  // from ... max(from + 1, other): never empty.
  Onset uniform(const Expression& first) {
    const Expression last = expression(1);
    made_.laws.push_back([from = clamped(first.meaning), to = last.meaning, cells = cells_](const Onsets& o) {
      const int low = from(o),
                high = std::min(std::max(low > never / 2 ? never : first_number(low), to(o)), never);
      if (low >= cells) return Law{{never, 1}};
      const int end = high == never ? cells : high;
      Law law;
      for (int i = low; i <= end; ++i) law[i] += Rational(1, end - low + 1);
      return law;
    });
    return UniformOnset{at(first.text), at(fmt::format("max(({}) + 1, max(0, {}) + 1, {})", first.text,
                                                       first.text, last.text))};
  }
  static int first_number(int low) { return low + 1; }
  Onset geometric(const Expression& first) {
    const Rational p = Rational(1, 1 + pick(3));
    made_.laws.push_back([from = clamped(first.meaning), p, cells = cells_](const Onsets& o) {
      Law law;
      Rational left = 1;
      for (int i = from(o); i < cells; ++i, left *= 1 - p) law[i] = left * p;
      law[never] = left;
      return law;
    });
    return GeometricOnset{p, at(first.text)};
  }
  Onset linear() {
    Rational start(pick(3), 4), end(2 + pick(3), 4);
    start.canonicalize();
    end.canonicalize();
    made_.laws.push_back([start, end, cells = cells_](const Onsets&) {
      Law law;
      for (int i = 0; i < cells; ++i)
        law[i] = i == 0 ? (cells == 1 ? end : start) : Rational((end - start) / (cells - 1));
      law[never] = 1 - end;
      return law;
    });
    return LinearOnset{start, end};
  }
  Onset table(const Expression& first) {
    const Rational a = Rational(1, 2 + pick(3)), b = Rational(1, 3), rest = 1 - a - b;
    made_.laws.push_back([from = clamped(first.meaning), a, b, rest](const Onsets& o) {
      const int i = from(o);
      return i > never / 2 ? Law{{never, 1}} : Law{{i, a}, {i + 1, b}, {never, rest}};
    });
    return TableOnset{{a, b}, rest, at(first.text)};
  }
  /// Of some features, as others, in one way or both.
  void misread(int features) {
    if (pick(2) == 0) return;
    for (const bool per_approach : {false, true}) {
      const int of = pick(features);
      for (int as = 0; as < features; ++as) {
        if (as == of || pick(2) == 0) continue;
        Misreading one{fmt::format("f{}", of), fmt::format("f{}", as), Rational(pick(3), 6)};
        one.probability.canonicalize();
        one.per_approach = per_approach;
        if (!per_approach && pick(2) == 0) one.probability_at_end = Rational(1, 3 + pick(3));
        made_.spec.misreadings.push_back(one);
      }
    }
  }
  void deal(int features) {
    ShuffleSpec shuffle;
    for (int i = features - 2; i < features; ++i) {
      const Expression slot = expression(2);
      shuffle.features.push_back(fmt::format("f{}", i));
      shuffle.at.push_back(at(slot.text));
      made_.slots.push_back(clamped(slot.meaning));
    }
    made_.spec.shuffles.push_back(shuffle);
  }

  util::CounterRandom random_;
  int cells_, known_ = 0;
  RandomProfile made_;
};

/// How near the last cell is: 0 at the horizon, 1 there.
Rational nearness(const ProfileSpec& spec, std::uint32_t cell) {
  if (spec.cells == 1) return 1;
  Rational near(cell, spec.cells - 1);
  near.canonicalize();
  return near;
}

Rational between(const Rational& begin, const std::optional<Rational>& end, const Rational& near) {
  return end ? Rational(begin * (1 - near) + *end * near) : begin;
}

/// What shows where \p feature is rightly reported, by one kind of misreading; itself last.
std::vector<std::pair<std::size_t, Rational>> readings(const ProfileSpec& spec, std::size_t feature,
                                                       bool per_approach, const Rational& near) {
  std::vector<std::pair<std::size_t, Rational>> all;
  Rational left = 1;
  for (const Misreading& one : spec.misreadings) {
    if (one.of != spec.features[feature].name || one.per_approach != per_approach) continue;
    const Rational p = between(one.probability, one.probability_at_end, near);
    all.emplace_back(std::stoul(one.as.substr(1)), p);
    left -= p;
  }
  all.emplace_back(feature, left);
  return all;
}

struct Shown {
  std::vector<std::uint64_t> cells;
  bool stays = false;
  friend auto operator<=>(const Shown&, const Shown&) = default;
};

/// What one feature with this onset shows, cell by cell, when it is read as \p good for the whole approach.
std::map<Shown, Rational> shows(const ProfileSpec& spec, std::size_t f, int onset, std::size_t good) {
  const FeatureSpec& feature = spec.features[f];
  std::map<Shown, Rational> layer{{{}, 1}};
  for (std::uint32_t cell = 0; cell < spec.cells; ++cell) {
    std::map<Shown, Rational> next;
    const Rational near = nearness(spec, cell);
    const bool there = !feature.replaced && onset <= static_cast<int>(cell);
    const auto add = [&](Shown past, std::uint64_t bits, bool stays, const Rational& weight) {
      past.cells.push_back(bits);
      past.stays |= stays && feature.persistent.value_or(spec.persistent);
      if (weight != 0) next[past] += weight;
    };
    for (const auto& [past, weight] : layer) {
      const Rational p = past.stays ? Rational(1)
                         : there    ? between(feature.detection, feature.detection_at_end, near)
                                    : between(feature.false_detection, feature.false_detection_at_end, near);
      add(past, 0, false, weight * (1 - p));
      if (!there || good != f || past.stays) {
        add(past, std::uint64_t{1} << (there ? good : f), there, weight * p);
        continue;
      }
      for (const auto& [as, q] : readings(spec, f, false, near))
        add(past, std::uint64_t{1} << as, as == f, weight * p * q);
    }
    layer = std::move(next);
  }
  return layer;
}

/// Reports of one feature with this onset, cell by cell.
SequenceLaw reports(const ProfileSpec& spec, std::size_t f, int onset) {
  SequenceLaw law;
  for (const auto& [good, weight] : readings(spec, f, true, 0))
    for (const auto& [shown, p] : shows(spec, f, onset, good)) law[shown.cells] += p * weight;
  return law;
}

void add_reports(const ProfileSpec& spec, const Onsets& onsets, const Rational& weight, SequenceLaw& law) {
  SequenceLaw all{{std::vector<std::uint64_t>(spec.cells), weight}};
  for (std::size_t f = 0; f < onsets.size(); ++f) {
    SequenceLaw next;
    for (const auto& [bits, p] : reports(spec, f, onsets[f]))
      for (const auto& [sequence, q] : all) {
        auto longer = sequence;
        for (std::size_t cell = 0; cell < bits.size(); ++cell) longer[cell] |= bits[cell];
        if (p != 0) next[longer] += p * q;
      }
    all = std::move(next);
  }
  for (const auto& [sequence, p] : all) law[sequence] += p;
}

/// Brings onsets forward where everything becomes visible; absent features stay away.
Onsets effective(const ProfileSpec& spec, Onsets onsets) {
  for (std::size_t f = 0; f < onsets.size(); ++f)
    if (spec.everything_visible_in && !spec.features[f].absent)
      onsets[f] = std::min(onsets[f], static_cast<int>(*spec.everything_visible_in));
  return onsets;
}

using Weighted = std::vector<std::pair<Onsets, Rational>>;

/// All onset vectors; what a rule reads is the rule's own onset, `never` when at T or later.
Weighted onset_vectors(const RandomProfile& made) {
  const int cells = static_cast<int>(made.spec.cells);
  Weighted all{{{}, 1}};
  for (std::size_t f = 0; f < made.laws.size(); ++f) {
    Weighted next;
    for (const auto& [onsets, weight] : all)
      for (const auto& [onset, p] : made.laws[f](onsets)) {
        Onsets longer = onsets;
        longer.push_back(made.spec.features[f].absent || onset >= cells ? never : onset);
        if (p != 0) next.emplace_back(longer, weight * p);
      }
    all = std::move(next);
  }
  if (made.slots.empty()) return all;
  Weighted dealt;
  for (const auto& [onsets, weight] : all)
    for (std::size_t order = 0; order < 2; ++order) {
      Onsets longer = onsets;
      for (std::size_t i = 0; i < 2; ++i) {
        const bool absent = made.spec.features[onsets.size() + i].absent;
        longer.push_back(absent ? never : made.slots[i ^ order](onsets));
      }
      dealt.emplace_back(longer, weight / 2);
    }
  return dealt;
}

TEST(RandomProfiles, ChainsEqualTheEnumeration) {
  int sequences_seen = 0;
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    const RandomProfile made = Maker(seed, static_cast<std::uint32_t>(1 + seed % 4))
                                   .make(2 + static_cast<int>(seed % 3), seed % 5 == 4);
    SequenceLaw law;
    for (const auto& [onsets, weight] : onset_vectors(made))
      add_reports(made.spec, effective(made.spec, onsets), weight, law);
    util::Budget budget;
    ASSERT_EQ(sequences(compile(made.spec, budget)), law) << "seed " << seed;
    sequences_seen += static_cast<int>(law.size());
  }
  EXPECT_GT(sequences_seen, 10'000);
}

}  // namespace
}  // namespace heed::sim
