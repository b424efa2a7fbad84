// Checks a profile and puts its draws into an order.
#include "profile_model.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <heed/util/diagnostic.h>

#include <algorithm>

namespace heed::sim {
namespace {

constexpr std::uint32_t most_cells = 10'000;
constexpr std::size_t most_features = 64;

[[noreturn]] void fail(const util::Location& location, const char* code, const std::string& message,
                       const std::string& hint = {}) {
  throw util::InputError(location, code, message, hint);
}

void check_probability(const Rational& value, const FeatureSpec& feature, const char* what) {
  if (value < 0 || value > 1)
    fail(feature.location, "probability-range",
         fmt::format("{} of '{}' is {}, which is no probability", what, feature.name, fraction(value)),
         "give a number from 0 to 1");
}

/// Checks the numbers of a rule, one overload per kind.
struct CheckRule {
  const FeatureSpec& feature;

  void operator()(const FixedOnset&) const {}
  void operator()(const UniformOnset&) const {}
  void operator()(const ShuffledOnset&) const {}
  void operator()(const GeometricOnset& rule) const { check_probability(rule.p, feature, "geometric"); }
  void operator()(const LinearOnset& rule) const {
    check_probability(rule.start, feature, "linear start");
    check_probability(rule.end, feature, "linear end");
    if (rule.start > rule.end)
      fail(feature.location, "probability-range",
           fmt::format("the probability to see '{}' falls from {} to {}", feature.name, fraction(rule.start),
                       fraction(rule.end)),
           "an onset only makes things visible; write the smaller number first");
  }
  void operator()(const TableOnset& rule) const {
    Rational sum = rule.never;
    check_probability(rule.never, feature, "never");
    for (const Rational& p : rule.p) {
      check_probability(p, feature, "table");
      sum += p;
    }
    if (sum == 1) return;
    const std::string hint = sum < 1 ? fmt::format("add the missing {}, for instance as never = \"{}\"",
                                                   fraction(1 - sum), fraction(rule.never + 1 - sum))
                                     : fmt::format("{} too much", fraction(sum - 1));
    fail(feature.location, "probability-sum",
         fmt::format("the table of '{}' adds up to {}, not 1", feature.name, fraction(sum)), hint);
  }
};

std::vector<OnsetExpression> parameters_of(const Onset& rule) {
  struct Visitor {
    std::vector<OnsetExpression> operator()(const FixedOnset& r) const { return {r.at}; }
    std::vector<OnsetExpression> operator()(const UniformOnset& r) const { return {r.from, r.to}; }
    std::vector<OnsetExpression> operator()(const GeometricOnset& r) const { return {r.from}; }
    std::vector<OnsetExpression> operator()(const TableOnset& r) const { return {r.from}; }
    std::vector<OnsetExpression> operator()(const LinearOnset&) const { return {}; }
    std::vector<OnsetExpression> operator()(const ShuffledOnset&) const { return {}; }
  };
  return std::visit(Visitor{}, rule);
}

void check_frame(const ProfileSpec& spec) {
  if (spec.cells == 0 || spec.cells > most_cells)
    fail(spec.location, "bad-cells", fmt::format("profile '{}' has {} cells", spec.name, spec.cells),
         fmt::format("1 ... {} are possible", most_cells));
  if (spec.everything_visible_in && *spec.everything_visible_in >= spec.cells)
    fail(spec.location, "bad-cells",
         fmt::format("everything_visible_in = {} lies beyond the last cell, which is {}",
                     *spec.everything_visible_in, spec.cells - 1),
         "cells count from 0");
  if (spec.features.size() > most_features)
    fail(spec.location, "too-many-features",
         fmt::format("profile '{}' has {} features", spec.name, spec.features.size()),
         fmt::format("at most {} are possible", most_features));
}

void check_features(const ProfileSpec& spec, std::vector<std::string>& names) {
  for (const FeatureSpec& feature : spec.features) {
    if (std::find(names.begin(), names.end(), feature.name) != names.end())
      fail(feature.location, "duplicate-feature", fmt::format("'{}' has two onset rules", feature.name),
           "a feature has one rule, or a place in one shuffle");
    names.push_back(feature.name);
    check_probability(feature.detection, feature, "detection");
    check_probability(feature.false_detection, feature, "false_detection");
    if (feature.detection_at_end) check_probability(*feature.detection_at_end, feature, "detection");
    if (feature.false_detection_at_end)
      check_probability(*feature.false_detection_at_end, feature, "false_detection");
    std::visit(CheckRule{feature}, feature.onset);
  }
}

/// The place of a feature that a misreading names.
std::uint32_t misread(const Misreading& misreading, const std::string& name,
                      const std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    fail(misreading.location, "unknown-feature", fmt::format("the profile has no feature '{}'", name),
         util::suggestion(name, names));
  return static_cast<std::uint32_t>(found - names.begin());
}

void check_misreading(const Misreading& misreading) {
  if (misreading.of == misreading.as)
    fail(misreading.location, "misread-as-itself", fmt::format("'{}' is misread as itself", misreading.of),
         "name what it is taken for");
  const Rational& end = misreading.probability_at_end.value_or(misreading.probability);
  for (const Rational* p : {&misreading.probability, &end})
    if (*p < 0 || *p > 1)
      fail(misreading.location, "probability-range",
           fmt::format("'{}' is misread with probability {}, which is none", misreading.of, fraction(*p)),
           "give a number from 0 to 1");
}

void check_single(const ProfileSpec& spec, const Misreading& misreading) {
  const auto same =
      std::count_if(spec.misreadings.begin(), spec.misreadings.end(), [&](const Misreading& other) {
        return other.of == misreading.of && other.as == misreading.as &&
               other.per_approach == misreading.per_approach;
      });
  if (same > 1)
    fail(misreading.location, "duplicate-feature",
         fmt::format("'{}' is misread as '{}' twice", misreading.of, misreading.as), "add the two up");
}

/// Between the two ends sums change linearly, too.
void check_sum(const std::vector<ReadAs>& all, const Misreading& last) {
  Rational begin = 0, end = 0;
  for (const ReadAs& one : all) {
    begin += one.probability;
    end += one.probability_at_end.value_or(one.probability);
  }
  const Rational& most = begin < end ? end : begin;
  if (most > 1)
    fail(last.location, "probability-sum",
         fmt::format("the misreadings of '{}' {} add up to {}", last.of,
                     last.per_approach ? "for the whole approach" : "in a cell", fraction(most)),
         fmt::format("{} too much: they are what may happen instead of each other", fraction(most - 1)));
}

void add_misreadings(ProfileModel& model) {
  model.misread_in_cell.resize(model.names.size());
  model.misread_for_good.resize(model.names.size());
  for (const Misreading& one : model.spec.misreadings) {
    const std::uint32_t of = misread(one, one.of, model.names), as = misread(one, one.as, model.names);
    check_misreading(one);
    check_single(model.spec, one);
    auto& all = (one.per_approach ? model.misread_for_good : model.misread_in_cell)[of];
    all.push_back({as, one.probability, one.probability_at_end});
    check_sum(all, one);
  }
}

DrawUnit make_unit(const std::vector<OnsetExpression>& parameters, const std::vector<std::string>& names) {
  DrawUnit unit;
  for (const OnsetExpression& parameter : parameters) {
    unit.parameters.push_back(resolve(parameter, names));
    const auto& mentioned = unit.parameters.back().features;
    unit.parents.insert(unit.parents.end(), mentioned.begin(), mentioned.end());
  }
  std::sort(unit.parents.begin(), unit.parents.end());
  unit.parents.erase(std::unique(unit.parents.begin(), unit.parents.end()), unit.parents.end());
  return unit;
}

DrawUnit make_shuffle(const ProfileSpec& spec, const ShuffleSpec& shuffle,
                      const std::vector<std::string>& names) {
  if (shuffle.features.empty() || shuffle.features.size() != shuffle.at.size())
    fail(shuffle.location, "bad-shuffle",
         fmt::format("{} features are dealt {} cells", shuffle.features.size(), shuffle.at.size()),
         "give as many cells as features; a cell may be 'never'");
  DrawUnit unit = make_unit(shuffle.at, names);
  unit.location = shuffle.location;
  for (const std::string& name : shuffle.features) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      fail(shuffle.location, "unknown-feature", fmt::format("the profile has no feature '{}'", name),
           util::suggestion(name, names));
    const auto index = static_cast<std::uint32_t>(found - names.begin());
    if (!std::holds_alternative<ShuffledOnset>(spec.features[index].onset))
      fail(shuffle.location, "duplicate-feature",
           fmt::format("'{}' has an onset rule and a place in a shuffle", name), "drop one of them");
    unit.features.push_back(index);
  }
  return unit;
}

std::vector<DrawUnit> make_units(const ProfileSpec& spec, const std::vector<std::string>& names) {
  std::vector<DrawUnit> units;
  for (std::uint32_t i = 0; i < spec.features.size(); ++i) {
    const FeatureSpec& feature = spec.features[i];
    if (std::holds_alternative<ShuffledOnset>(feature.onset)) continue;
    units.push_back(make_unit(parameters_of(feature.onset), names));
    units.back().features = {i};
    units.back().rule = &feature.onset;
    units.back().location = feature.location;
  }
  for (const ShuffleSpec& shuffle : spec.shuffles) units.push_back(make_shuffle(spec, shuffle, names));
  return units;
}

/// Which unit draws each feature. \throws util::InputError unless it is exactly one
std::vector<std::uint32_t> owners(const ProfileSpec& spec, const std::vector<DrawUnit>& units) {
  constexpr std::uint32_t nobody = UINT32_MAX;
  std::vector<std::uint32_t> result(spec.features.size(), nobody);
  for (std::uint32_t u = 0; u < units.size(); ++u) {
    for (const std::uint32_t f : units[u].features) {
      if (result[f] != nobody)
        fail(units[u].location, "bad-shuffle", fmt::format("'{}' is shuffled twice", spec.features[f].name),
             "name it once");
      result[f] = u;
    }
  }
  for (std::size_t f = 0; f < result.size(); ++f)
    if (result[f] == nobody)
      fail(spec.features[f].location, "bad-shuffle",
           fmt::format("'{}' has no onset rule and is in no shuffle", spec.features[f].name),
           "give it a rule such as fixed = 0");
  return result;
}

/// Follows references among the units that are left until one comes again. \pre each of them refers to
/// another of them
[[noreturn]] void fail_cyclic(const ProfileModel& model, const std::vector<DrawUnit>& units,
                              const std::vector<bool>& done) {
  std::vector<std::uint32_t> path;
  auto unit = static_cast<std::uint32_t>(std::find(done.begin(), done.end(), false) - done.begin());
  std::vector<std::string> names;
  while (std::find(path.begin(), path.end(), unit) == path.end()) {
    path.push_back(unit);
    for (const std::uint32_t parent : units[unit].parents) {
      if (done[model.unit_of[parent]]) continue;
      names.push_back(model.names[parent]);
      unit = model.unit_of[parent];
      break;
    }
  }
  const auto start = std::find(path.begin(), path.end(), unit) - path.begin();
  names.erase(names.begin(), names.begin() + start);
  names.insert(names.begin(), names.back());
  fail(units[unit].location, "cyclic-onsets",
       fmt::format("onsets refer to each other in a circle: {}", fmt::join(names, " -> ")),
       "an onset rule may refer to another only in one direction");
}

/// Units in the order given, each moved behind those it refers to.
std::vector<std::uint32_t> order_of(const ProfileModel& model, const std::vector<DrawUnit>& units) {
  std::vector<bool> done(units.size(), false);
  std::vector<std::uint32_t> order;
  while (order.size() < units.size()) {
    const std::size_t before = order.size();
    for (std::uint32_t u = 0; u < units.size(); ++u) {
      const auto& parents = units[u].parents;
      const bool ready = !done[u] && std::all_of(parents.begin(), parents.end(),
                                                 [&](std::uint32_t f) { return done[model.unit_of[f]]; });
      if (!ready) continue;
      done[u] = true;
      order.push_back(u);
    }
    if (order.size() == before) fail_cyclic(model, units, done);
  }
  return order;
}

}  // namespace

ProfileModel::ProfileModel(const ProfileSpec& profile) : spec(profile) {
  check_frame(spec);
  check_features(spec, names);
  const std::vector<DrawUnit> found = make_units(spec, names);
  unit_of = owners(spec, found);
  for (const std::uint32_t u : order_of(*this, found)) units.push_back(found[u]);
  unit_of = owners(spec, units);
  children.resize(names.size());
  for (std::uint32_t u = 0; u < units.size(); ++u)
    for (const std::uint32_t parent : units[u].parents) children[parent].push_back(u);
  add_misreadings(*this);
}

namespace {

/// The hazards, one overload per rule; the conditions that compile() has checked hold.
struct Hazard {
  const DrawUnit& unit;
  const std::vector<std::int64_t>& values;
  std::int64_t cell, cells;

  Rational operator()(const FixedOnset&) const { return values[0] == cell ? 1 : 0; }
  Rational operator()(const UniformOnset& rule) const {
    const std::int64_t from = values[0], to = values[1] == infinite ? cells : values[1];
    if (from >= cells || cell < from) return 0;
    if (to < from)
      fail(rule.from.location().line == 0 ? unit.location : rule.from.location(), "empty-range",
           fmt::format("there is no cell from {} to {}, which onsets drawn before can lead to", from, to),
           "let the range end at or after its beginning, for instance at 'never'");
    Rational p(1, to - cell + 1);
    return cell > to ? Rational(0) : p;
  }
  Rational operator()(const GeometricOnset& rule) const { return cell < values[0] ? Rational(0) : rule.p; }
  Rational operator()(const LinearOnset& rule) const {
    const Rational before = cell == 0 ? Rational(0) : visible(rule, cell - 1);
    return before == 1 ? Rational(0) : Rational((visible(rule, cell) - before) / (1 - before));
  }
  Rational operator()(const TableOnset& rule) const {
    if (cell < values[0]) return 0;
    const auto index = static_cast<std::size_t>(cell - values[0]);
    if (index >= rule.p.size()) return 0;
    Rational left = 1;
    for (std::size_t i = 0; i < index; ++i) left -= rule.p[i];
    return left == 0 ? Rational(0) : Rational(rule.p[index] / left);
  }
  Rational operator()(const ShuffledOnset&) const { return 0; }

  [[nodiscard]] Rational visible(const LinearOnset& rule, std::int64_t at) const {
    if (cells == 1) return rule.end;
    return rule.start + (rule.end - rule.start) * Rational(at) / Rational(cells - 1);
  }
};

}  // namespace

Rational hazard(const DrawUnit& unit, const std::vector<std::int64_t>& values, std::uint32_t cell,
                std::uint32_t cells) {
  return std::visit(Hazard{unit, values, cell, cells}, *unit.rule);
}

ProfileSpec without(ProfileSpec profile, const std::vector<std::string>& absent) {
  for (FeatureSpec& feature : profile.features)
    if (std::find(absent.begin(), absent.end(), feature.name) != absent.end()) feature.absent = true;
  return profile;
}

}  // namespace heed::sim
