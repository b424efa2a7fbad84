#include "labels.h"

#include <heed/util/limits.h>

#include <algorithm>
#include <deque>
#include <iterator>

namespace heed::awareness {
namespace {

constexpr std::size_t work_limit = 20'000'000;

bool within(const Environment& small, const Environment& large) {
  return std::includes(large.begin(), large.end(), small.begin(), small.end());
}

Environment joined(const Environment& a, const Environment& b) {
  Environment result;
  result.reserve(a.size() + b.size());
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

/// Keeps the label an antichain; false when something at least as small is there.
bool insert_minimal(std::vector<Environment>& label, Environment environment) {
  if (std::any_of(label.begin(), label.end(), [&](const Environment& e) { return within(e, environment); }))
    return false;
  std::erase_if(label, [&](const Environment& e) { return within(environment, e); });
  label.push_back(std::move(environment));
  return true;
}

}  // namespace

Labels::Labels(const HornBase& base, std::vector<char> observable,
               const std::vector<std::pair<HornBase::Prop, HornBase::Prop>>& never)
    : base_(base), labels_(base.size()), nogoods_by_first_(base.size()) {
  // Sets that cannot be observed are left out like contradictions, without being any.
  for (const auto& [a, b] : never)
    nogoods_by_first_[std::min(a, b)].push_back({std::min(a, b), std::max(a, b)});
  std::vector<HornBase::Prop> start;
  for (HornBase::Prop p = 0; p < base.nothing(); ++p) {
    labels_[p].emplace();
    if (observable[p] == 0) continue;
    labels_[p]->push_back({p});
    start.push_back(p);
  }
  labels_[base.nothing()].emplace();
  propagate(start);
}

Labels::Labels(const Labels& general, std::size_t entity)
    : base_(general.base_), general_(&general), labels_(base_.size()), nogoods_by_first_(base_.size()) {
  const auto known = base_.closure({base_.entity(entity)});
  std::vector<HornBase::Prop> start;
  for (HornBase::Prop p = 0; p < base_.nothing(); ++p)
    if (known[p] != 0) {
      labels_[p] = Label{{}};
      start.push_back(p);
    }
  propagate(start);
}

const Labels::Label& Labels::label(HornBase::Prop prop) const {
  return labels_[prop] ? *labels_[prop] : general_->label(prop);
}

std::vector<Environment> Labels::of(HornBase::Prop prop) const {
  Label result = label(prop);
  std::erase_if(result, [&](const Environment& e) { return contradictory(e); });
  std::sort(result.begin(), result.end(), [](const Environment& a, const Environment& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  });
  return result;
}

bool Labels::contradictory(const Environment& environment) const {
  for (const HornBase::Prop p : environment)
    for (const Environment& nogood : nogoods_by_first_[p])
      if (within(nogood, environment)) return true;
  return general_ != nullptr && general_->contradictory(environment);
}

/// That one observation alone contradicts what is known here: rules that need it are not worth a look.
bool Labels::excluded_here(HornBase::Prop prop) const {
  const auto& nogoods = nogoods_by_first_[prop];
  return std::any_of(nogoods.begin(), nogoods.end(), [](const Environment& e) { return e.size() == 1; });
}

/// Only larger sets can be needless for a new one, so most of the time nothing has to be looked through.
bool Labels::add_contradiction(Environment environment) {
  if (contradictory(environment)) return false;
  if (environment.size() < largest_) {
    const auto needless = [&](const Environment& e) { return within(environment, e); };
    std::erase_if(own_nogoods_, needless);
    for (auto& nogoods : nogoods_by_first_)
      if (!nogoods.empty()) std::erase_if(nogoods, needless);
  }
  largest_ = std::max(largest_, environment.size());
  nogoods_by_first_[environment.front()].push_back(environment);
  own_nogoods_.push_back(std::move(environment));
  return true;
}

bool Labels::insert(HornBase::Prop prop, Environment environment) {
  if (prop == base_.nothing()) return add_contradiction(std::move(environment));
  auto& own = labels_[prop];
  if (!own) own = general_->label(prop);
  return insert_minimal(*own, std::move(environment));
}

/// Every way to meet the conditions of \p rule.
Labels::Label Labels::combine(const HornBase::Rule& rule) {
  Label result{{}};
  for (const HornBase::Prop p : rule.body) {
    Label next;
    for (const Environment& left : result)
      for (const Environment& right : label(p)) {
        if (++work_ > work_limit)
          throw util::LimitExceeded(util::LimitExceeded::Kind::Size,
                                    "the catalogue leaves too many ways to tell its entities apart");
        Environment both = joined(left, right);
        if (!both.empty() && contradictory(both)) continue;
        insert_minimal(next, std::move(both));
      }
    result = std::move(next);
    if (result.empty()) break;
  }
  return result;
}

bool Labels::fire(const HornBase::Rule& rule) {
  for (const HornBase::Prop p : rule.body)
    if (label(p).empty() || (label(p).size() == 1 && label(p).front() == Environment{p} && excluded_here(p)))
      return false;
  if (rule.head != base_.nothing()) {
    const Label& known = label(rule.head);
    if (known.size() == 1 && known.front().empty()) return false;
  }
  bool changed = false;
  for (Environment& environment : combine(rule))
    if (!environment.empty() || rule.head != base_.nothing())
      changed = insert(rule.head, std::move(environment)) || changed;
  return changed;
}

/// Rules that lead to contradictions go first: what they find keeps the other labels short.
void Labels::propagate(const std::vector<HornBase::Prop>& start) {
  std::deque<HornBase::Prop> queue;
  std::vector<char> waiting(base_.size(), 0);
  const auto refuse = [&](HornBase::Prop p) {
    for (const std::uint32_t r : base_.rules_with(p)) {
      if (base_.rules()[r].head != base_.nothing()) break;
      (void)fire(base_.rules()[r]);
    }
  };
  const auto enqueue = [&](HornBase::Prop p) {
    if (waiting[p] == 0) queue.push_back(p);
    waiting[p] = 1;
  };
  for (const HornBase::Prop p : start) refuse(p);
  for (const HornBase::Prop p : start) enqueue(p);
  while (!queue.empty()) {
    const HornBase::Prop p = queue.front();
    queue.pop_front();
    waiting[p] = 0;
    for (const std::uint32_t r : base_.rules_with(p)) {
      const HornBase::Rule& rule = base_.rules()[r];
      if (!fire(rule) || rule.head == base_.nothing()) continue;
      refuse(rule.head);
      enqueue(rule.head);
    }
  }
}

}  // namespace heed::awareness
