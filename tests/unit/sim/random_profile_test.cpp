// Random profiles against a second implementation that knows nothing of chains: enumerate every vector of
// onsets with the product of the rules' laws, then every vector of reports.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <heed/util/random.h>

#include <algorithm>
#include <functional>
#include <numeric>

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

/// Reports of one feature with this onset, cell by cell.
std::map<std::vector<bool>, Rational> reports(const ProfileSpec& spec, const FeatureSpec& feature,
                                              int onset) {
  std::map<std::pair<std::vector<bool>, bool>, Rational> layer{{{{}, false}, 1}};
  const int cells = static_cast<int>(spec.cells);
  for (int cell = 0; cell < cells; ++cell) {
    std::map<std::pair<std::vector<bool>, bool>, Rational> next;
    for (const auto& [past, probability] : layer) {
      const bool there = !feature.replaced && onset <= cell;
      const bool sure = past.second && feature.persistent.value_or(spec.persistent);
      const auto& end = there ? feature.detection_at_end : feature.false_detection_at_end;
      const Rational begin = there ? feature.detection : feature.false_detection;
      const Rational far = cells == 1 ? Rational(0) : Rational(cells - 1 - cell) / (cells - 1);
      const Rational p = sure ? Rational(1) : end ? Rational(begin * far + *end * (1 - far)) : begin;
      for (const bool yes : {false, true}) {
        auto bits = past.first;
        bits.push_back(yes);
        if (const Rational q = yes ? p : Rational(1 - p); q != 0)
          next[{bits, past.second || (there && yes)}] += probability * q;
      }
    }
    layer = std::move(next);
  }
  std::map<std::vector<bool>, Rational> result;
  for (const auto& [past, probability] : layer) result[past.first] += probability;
  return result;
}

void add_reports(const ProfileSpec& spec, const Onsets& onsets, const Rational& weight, SequenceLaw& law) {
  SequenceLaw all{{std::vector<std::uint64_t>(spec.cells), weight}};
  for (std::size_t f = 0; f < onsets.size(); ++f) {
    SequenceLaw next;
    for (const auto& [bits, p] : reports(spec, spec.features[f], onsets[f]))
      for (const auto& [sequence, q] : all) {
        auto longer = sequence;
        for (std::size_t cell = 0; cell < bits.size(); ++cell) longer[cell] |= std::uint64_t{bits[cell]} << f;
        next[longer] += p * q;
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
