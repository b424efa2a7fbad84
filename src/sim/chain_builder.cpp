// One cell of a profile, drawn unit by unit. The idea: an onset need not be drawn before its cell comes. In
// each cell a unit that may start now turns on with its hazard, P(onset = cell | onset >= cell), so that all
// a state has to remember are onsets that a rule still needs; a geometric rule needs none. Enumerating whole
// onset vectors first and projecting them would be simpler, but costs (T+1)^n before anything is forgotten.
// The price: a rule whose parameters depend on an onset that is still to come cannot be drawn this way; then
// (and only then) what it refers to is drawn ahead and kept in the state.
#include "chain_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <iterator>

namespace heed::sim {
namespace {

constexpr std::size_t most_shuffled = 18;

std::uint64_t bit(std::size_t feature) {
  return std::uint64_t{1} << feature;
}

Rational choose(std::size_t n, std::size_t k) {
  mpz_class result;
  mpz_bin_uiui(result.get_mpz_t(), n, k);
  return Rational(result);
}

/// Adds up branches that know and show the same.
void merge(std::vector<Branch>& branches) {
  std::sort(branches.begin(), branches.end(), [](const Branch& a, const Branch& b) {
    return a.seen != b.seen ? a.seen < b.seen : a.knowledge < b.knowledge;
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < branches.size(); ++i) {
    const bool same = kept > 0 && branches[kept - 1].seen == branches[i].seen &&
                      branches[kept - 1].knowledge == branches[i].knowledge;
    if (same)
      branches[kept - 1].probability += branches[i].probability;
    else if (kept++ != i)
      branches[kept - 1] = std::move(branches[i]);
  }
  branches.resize(kept);
}

[[noreturn]] void too_large(const std::string& profile, std::size_t most) {
  throw util::LimitExceeded(
      util::LimitExceeded::Kind::Size,
      fmt::format(
          "in one cell of profile '{}' more than {} things may happen; let features depend less on chance",
          profile, most));
}

}  // namespace

CellUnfolder::CellUnfolder(const ProfileModel& model, std::vector<bool> ahead, std::size_t most,
                           util::Budget& budget)
    : model_(model), ahead_(std::move(ahead)), most_(most), budget_(budget), cells_(model.spec.cells) {}

std::vector<Branch> CellUnfolder::start() {
  Knowledge nothing;
  for (const FeatureSpec& feature : model_.spec.features)
    nothing.onset.push_back(feature.absent ? static_cast<std::int32_t>(cells_) : Knowledge::later);
  const auto decided = [](const std::vector<ReadAs>& all) { return !all.empty(); };
  if (std::any_of(model_.misread_for_good.begin(), model_.misread_for_good.end(), decided))
    nothing.reading.resize(model_.names.size(), Knowledge::undecided);
  std::vector<Branch> branches{{1, nothing, 0}};
  for (std::size_t u = 0; u < model_.units.size(); ++u) {
    if (!ahead_[u]) continue;
    const DrawUnit& unit = model_.units[u];
    unit.rule ? draw_feature_ahead(unit, branches) : draw_shuffle_ahead(unit, branches);
    merge(branches);
  }
  return branches;
}

std::vector<Branch> CellUnfolder::unfold(const Knowledge& before, std::uint32_t cell) {
  std::vector<Branch> branches{{1, before, 0}};
  for (const DrawUnit& unit : model_.units) draw(unit, cell, branches);
  report(cell, branches);
  for (Branch& branch : branches) forget(cell, branch.knowledge);
  merge(branches);
  return branches;
}

void CellUnfolder::draw(const DrawUnit& unit, std::uint32_t cell, std::vector<Branch>& branches) {
  if (model_.spec.everything_visible_in == cell) {
    for (Branch& branch : branches)
      for (const std::uint32_t f : unit.features)
        if (branch.knowledge.onset[f] == Knowledge::later)
          branch.knowledge.onset[f] = static_cast<std::int32_t>(cell);
    return;
  }
  unit.rule ? draw_feature(unit, cell, branches) : draw_shuffle(unit, cell, branches);
}

void CellUnfolder::draw_feature(const DrawUnit& unit, std::uint32_t cell, std::vector<Branch>& branches) {
  const std::uint32_t f = unit.features.front();
  std::vector<Branch> result;
  for (Branch& branch : branches) {
    const auto drawn = open(unit, branch.knowledge) ? values(unit, branch.knowledge, cell) : std::nullopt;
    const Rational p = drawn ? hazard(unit, *drawn, cell, cells_) : Rational(0);
    if (p != 0) {
      Branch on{branch.probability * p, branch.knowledge, 0};
      on.knowledge.onset[f] = static_cast<std::int32_t>(cell);
      grow(result, std::move(on));
    }
    if (p == 1) continue;
    branch.probability *= 1 - p;
    grow(result, std::move(branch));
  }
  branches = std::move(result);
}

// Dealing one after the other would order the features; instead the set that gets this cell is drawn at once.
// Of the cards not dealt yet, `hidden` belong to absent features, which only count.
void CellUnfolder::draw_shuffle(const DrawUnit& unit, std::uint32_t cell, std::vector<Branch>& branches) {
  std::vector<Branch> result;
  for (Branch& branch : branches) {
    const auto slots = open(unit, branch.knowledge) ? values(unit, branch.knowledge, cell) : std::nullopt;
    if (!slots) {
      grow(result, std::move(branch));
      continue;
    }
    std::vector<std::uint32_t> waiting;
    for (const std::uint32_t f : unit.features)
      if (branch.knowledge.onset[f] == Knowledge::later) waiting.push_back(f);
    if (waiting.size() > most_shuffled) too_large(model_.spec.name, most_);
    const auto dealt = static_cast<std::size_t>(
        std::count_if(slots->begin(), slots->end(), [&](std::int64_t at) { return at < cell; }));
    const auto now = static_cast<std::size_t>(std::count(slots->begin(), slots->end(), cell));
    const std::size_t left = slots->size() - dealt, hidden = left - waiting.size();
    for (std::uint64_t set = 0; set < bit(waiting.size()); ++set) {
      const auto size = static_cast<std::size_t>(std::popcount(set));
      if (size > now || now - size > hidden) continue;
      Branch dealt_now{branch.probability * choose(hidden, now - size) / choose(left, now), branch.knowledge,
                       0};
      for (std::size_t i = 0; i < waiting.size(); ++i)
        if (set & bit(i)) dealt_now.knowledge.onset[waiting[i]] = static_cast<std::int32_t>(cell);
      grow(result, std::move(dealt_now));
    }
  }
  branches = std::move(result);
}

void CellUnfolder::draw_feature_ahead(const DrawUnit& unit, std::vector<Branch>& branches) {
  const std::uint32_t f = unit.features.front();
  if (model_.spec.features[f].absent) return;
  std::vector<Branch> result;
  for (Branch& branch : branches) {
    const auto drawn = values(unit, branch.knowledge, cells_);
    for (std::uint32_t cell = 0; cell < cells_ && branch.probability != 0; ++cell) {
      const Rational p = drawn ? hazard(unit, *drawn, cell, cells_) : Rational(0);
      if (p == 0) continue;
      Branch on{branch.probability * p, branch.knowledge, 0};
      on.knowledge.onset[f] = static_cast<std::int32_t>(cell);
      grow(result, std::move(on));
      branch.probability *= 1 - p;
    }
    branch.knowledge.onset[f] = static_cast<std::int32_t>(cells_);
    if (branch.probability != 0) grow(result, std::move(branch));
  }
  branches = std::move(result);
}

void CellUnfolder::draw_shuffle_ahead(const DrawUnit& unit, std::vector<Branch>& branches) {
  struct Hand {
    Branch branch;
    std::vector<std::int32_t> slots;  ///< Not dealt yet.
  };
  std::vector<Branch> result;
  for (Branch& branch : branches) {
    std::vector<std::int32_t> slots;
    const auto drawn = values(unit, branch.knowledge, cells_);
    for (std::size_t i = 0; i < unit.parameters.size(); ++i)
      slots.push_back(
          static_cast<std::int32_t>(std::min<std::int64_t>(drawn ? (*drawn)[i] : cells_, cells_)));
    std::vector<Hand> hands{{std::move(branch), slots}};
    for (const std::uint32_t f : unit.features) {
      if (model_.spec.features[f].absent) continue;
      std::vector<Hand> next;
      for (const Hand& hand : hands) {
        for (std::size_t i = 0; i < hand.slots.size(); ++i) {
          Hand given = hand;
          given.branch.probability /= static_cast<unsigned long>(hand.slots.size());
          given.branch.knowledge.onset[f] = hand.slots[i];
          given.slots.erase(given.slots.begin() + static_cast<std::ptrdiff_t>(i));
          next.push_back(std::move(given));
        }
        if (next.size() > most_) too_large(model_.spec.name, most_);
      }
      hands = std::move(next);
    }
    for (Hand& hand : hands) grow(result, std::move(hand.branch));
  }
  branches = std::move(result);
}

Rational CellUnfolder::rate(const Rational& begin, const std::optional<Rational>& end,
                            std::uint32_t cell) const {
  if (!end) return begin;
  if (cells_ == 1) return *end;
  return begin + (*end - begin) * Rational(cell) / Rational(cells_ - 1);
}

/// Splits the branches by what perception reports of the things that are visible, or not.
void CellUnfolder::report(std::uint32_t cell, std::vector<Branch>& branches) {
  for (std::uint32_t f = 0; f < model_.names.size(); ++f) {
    const FeatureSpec& feature = model_.spec.features[f];
    const bool always = feature.detection == 1 && feature.detection_at_end.value_or(1) == 1 &&
                        model_.misread_in_cell[f].empty();
    const Rates rates{rate(feature.detection, feature.detection_at_end, cell),
                      rate(feature.false_detection, feature.false_detection_at_end, cell),
                      feature.persistent.value_or(model_.spec.persistent) && !always};
    report_feature(f, cell, rates, branches);
  }
}

void CellUnfolder::report_feature(std::uint32_t f, std::uint32_t cell, const Rates& rates,
                                  std::vector<Branch>& branches) {
  const bool misread = !model_.misread_in_cell[f].empty() || !model_.misread_for_good[f].empty();
  std::vector<Branch> more;
  for (Branch& branch : branches) {
    const bool there = !model_.spec.features[f].replaced && visible(branch.knowledge, f, cell);
    const bool sure = (branch.knowledge.reported & bit(f)) != 0;
    const Rational p = sure ? Rational(1) : there ? rates.detection : rates.false_detection;
    if (p == 0) continue;
    if (p != 1) {
      more.push_back(branch);
      more.back().probability *= 1 - p;
      branch.probability *= p;
    }
    if (there && misread) {
      std::vector<Branch> read_as = read(f, cell, rates.tracked, branch);
      branch = std::move(read_as.back());
      read_as.pop_back();
      std::move(read_as.begin(), read_as.end(), std::back_inserter(more));
      continue;
    }
    branch.seen |= bit(f);
    if (there && rates.tracked) branch.knowledge.reported |= bit(f);
  }
  for (Branch& branch : more) grow(branches, std::move(branch));
}

// What it is read as for good is drawn when it is first reported: until then it makes no difference.
std::vector<Branch> CellUnfolder::read(std::uint32_t f, std::uint32_t cell, bool tracked,
                                       Branch branch) const {
  std::vector<Branch> result;
  const auto shown = [&](std::uint32_t as, bool stays) {
    branch.seen |= bit(as);
    if (stays && tracked) branch.knowledge.reported |= bit(f);
    result.push_back(branch);
  };
  const auto& for_good = model_.misread_for_good[f];
  std::uint8_t decided = for_good.empty() ? Knowledge::right : branch.knowledge.reading[f];
  if (decided == Knowledge::undecided) {
    const Branch before = branch;
    Rational left = 1;
    for (std::size_t i = 0; i < for_good.size(); ++i) {
      branch = before;
      branch.probability *= for_good[i].probability;
      branch.knowledge.reading[f] = static_cast<std::uint8_t>(2 + i);
      left -= for_good[i].probability;
      if (branch.probability != 0) shown(for_good[i].feature, true);
    }
    branch = before;
    branch.probability *= left;
    branch.knowledge.reading[f] = decided = Knowledge::right;
    if (left == 0) return result;
  }
  if (decided != Knowledge::right || (branch.knowledge.reported & bit(f)) != 0) {
    shown(decided != Knowledge::right ? for_good[decided - 2U].feature : f, true);
    return result;
  }
  const Branch before = branch;
  Rational left = 1;
  for (const ReadAs& one : model_.misread_in_cell[f]) {
    const Rational p = rate(one.probability, one.probability_at_end, cell);
    branch = before;
    branch.probability *= p;
    left -= p;
    if (p != 0) shown(one.feature, false);
  }
  branch = before;
  branch.probability *= left;
  if (left != 0) shown(f, true);
  return result;
}

/// An onset that has passed and that no open rule refers to says nothing about the future.
void CellUnfolder::forget(std::uint32_t cell, Knowledge& knowledge) const {
  for (std::size_t f = 0; f < model_.names.size(); ++f) {
    if (!visible(knowledge, f, cell)) continue;
    const auto& children = model_.children[f];
    const bool needed = std::any_of(children.begin(), children.end(),
                                    [&](std::uint32_t u) { return open(model_.units[u], knowledge); });
    if (!needed) knowledge.onset[f] = 0;
  }
}

void CellUnfolder::grow(std::vector<Branch>& branches, Branch branch) {
  if (branches.size() >= most_) too_large(model_.spec.name, most_);
  if (branches.size() % 256 == 0) budget_.check();
  branches.push_back(std::move(branch));
}

bool CellUnfolder::visible(const Knowledge& knowledge, std::size_t feature, std::uint32_t cell) const {
  const std::int32_t onset = knowledge.onset[feature];
  if (onset == Knowledge::later) return false;
  if (onset <= static_cast<std::int32_t>(cell)) return true;
  const auto everything = model_.spec.everything_visible_in;
  return everything && *everything <= cell && !model_.spec.features[feature].absent;
}

bool CellUnfolder::open(const DrawUnit& unit, const Knowledge& knowledge) const {
  return std::any_of(unit.features.begin(), unit.features.end(),
                     [&](std::uint32_t f) { return knowledge.onset[f] == Knowledge::later; });
}

std::vector<OnsetRange> CellUnfolder::ranges(const Knowledge& knowledge, std::uint32_t cell) const {
  std::vector<OnsetRange> result;
  for (const std::int32_t onset : knowledge.onset) {
    if (onset == Knowledge::later)
      result.push_back({std::int64_t{cell} + 1, infinite});
    else if (onset >= static_cast<std::int32_t>(cells_))
      result.push_back({infinite, infinite});
    else
      result.push_back({onset, onset});
  }
  return result;
}

/// The parameters of a unit that may start by \p cell, each at least 0; what lies ahead counts as `infinite`.
/// Nothing when the unit cannot start yet, or asks for what is still to come.
std::optional<std::vector<std::int64_t>> CellUnfolder::values(const DrawUnit& unit,
                                                              const Knowledge& knowledge,
                                                              std::uint32_t cell) {
  const std::vector<OnsetRange> known = ranges(knowledge, cell);
  std::vector<std::int64_t> result;
  for (const ResolvedExpression& parameter : unit.parameters) {
    const OnsetRange range = parameter.evaluate(known);
    const bool ahead = range.low > cell;
    if (ahead && unit.rule && result.empty()) return std::nullopt;
    if (!range.known() && !(ahead && !unit.rule)) {
      want_ahead(parameter.features);
      return std::nullopt;
    }
    result.push_back(range.known() ? std::max<std::int64_t>(range.low, 0) : infinite);
  }
  return result;
}

void CellUnfolder::want_ahead(const std::vector<std::uint32_t>& features) {
  if (!wanted_ahead_) wanted_ahead_ = ahead_;
  std::vector<std::uint32_t> todo(features.begin(), features.end());
  while (!todo.empty()) {
    const std::uint32_t unit = model_.unit_of[todo.back()];
    todo.pop_back();
    if ((*wanted_ahead_)[unit]) continue;
    (*wanted_ahead_)[unit] = true;
    const auto& parents = model_.units[unit].parents;
    todo.insert(todo.end(), parents.begin(), parents.end());
  }
}

}  // namespace heed::sim
