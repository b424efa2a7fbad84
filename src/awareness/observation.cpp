#include <heed/awareness/observation.h>

#include "horn.h"
#include "units.h"

#include <algorithm>

namespace heed::awareness {

class Judge::Impl {
 public:
  Impl(const Catalogue& catalogue, JudgeOptions options)
      : catalogue_(catalogue),
        options_(std::move(options)),
        base_(catalogue),
        units_(catalogue, options_.closed) {}

  [[nodiscard]] Judgement judge(const Observation& observation) const {
    Judgement result;
    result.something_seen = !observation.seen.empty() || !observation.whole.empty();
    const auto facts = facts_of(observation);
    const auto known = base_.closure(facts);
    result.conflict = known[base_.nothing()] != 0;
    for (std::size_t e = 0; e < catalogue_.entities.size(); ++e)
      if (known[base_.entity(e)] != 0) result.recognised.push_back(e);
    result.cautious = behaviours(known);
    const auto consequences = find_candidates(facts, result);
    result.unknown = result.something_seen && !result.conflict && result.candidates.empty();
    if (result.something_seen && !result.candidates.empty()) identify(result);
    act(consequences, result);
    return result;
  }

 private:
  using Closure = std::vector<char>;

  [[nodiscard]] std::vector<HornBase::Prop> facts_of(const Observation& observation) const {
    std::vector<HornBase::Prop> facts;
    for (const std::size_t f : observation.seen) facts.push_back(base_.feature(f));
    for (const std::size_t e : observation.whole) facts.push_back(base_.entity(e));
    for (const std::size_t f : observation.excluded) facts.push_back(base_.excluded(f));
    return facts;
  }

  [[nodiscard]] std::vector<std::size_t> behaviours(const Closure& known) const {
    std::vector<std::size_t> result;
    for (std::size_t b = 0; b < catalogue_.behaviours.size(); ++b)
      if (known[base_.behaviour(b)] != 0) result.push_back(b);
    return result;
  }

  /// What follows for each candidate, in their order.
  std::vector<Closure> find_candidates(const std::vector<HornBase::Prop>& facts, Judgement& result) const {
    std::vector<char> possible(catalogue_.entities.size(), 0);
    std::vector<std::pair<std::size_t, Closure>> found;
    for (const std::size_t e : units_.entities) {
      auto assumed = facts;
      assumed.push_back(base_.entity(e));
      auto closure = base_.closure(assumed);
      if (closure[base_.nothing()] != 0) continue;
      possible[e] = 1;
      const auto& below = units_.children[e];
      if (std::none_of(below.begin(), below.end(), [&](std::size_t c) { return possible[c] != 0; }))
        found.emplace_back(e, std::move(closure));
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Closure> consequences;
    for (auto& [e, closure] : found) {
      result.candidates.push_back(e);
      consequences.push_back(std::move(closure));
    }
    return consequences;
  }

  void identify(Judgement& result) const {
    for (std::size_t e = 0; e < catalogue_.entities.size(); ++e)
      if (std::all_of(result.candidates.begin(), result.candidates.end(),
                      [&](std::size_t d) { return within(catalogue_, d, e); }))
        result.identified.push_back(e);
  }

  void add_fallback(std::vector<std::size_t>& acts) const {
    for (const std::size_t b : options_.fallback) {
      acts.push_back(b);
      for (const Entailed& up : catalogue_.behaviours[b].general) acts.push_back(up.index);
    }
    std::sort(acts.begin(), acts.end());
    acts.erase(std::unique(acts.begin(), acts.end()), acts.end());
  }

  void act(const std::vector<Closure>& consequences, Judgement& result) const {
    if (!result.something_seen) return;
    if (consequences.empty()) {
      add_fallback(result.cautious);
      result.common = result.brave = result.cautious;
      return;
    }
    for (std::size_t b = 0; b < catalogue_.behaviours.size(); ++b) {
      const auto calls = [&](const Closure& closure) { return closure[base_.behaviour(b)] != 0; };
      if (std::all_of(consequences.begin(), consequences.end(), calls)) result.common.push_back(b);
      if (std::any_of(consequences.begin(), consequences.end(), calls)) result.brave.push_back(b);
    }
  }

  const Catalogue& catalogue_;
  JudgeOptions options_;
  HornBase base_;
  Units units_;
};

Judge::Judge(const Catalogue& catalogue, JudgeOptions options)
    : impl_(std::make_unique<Impl>(catalogue, std::move(options))) {}
Judge::~Judge() = default;
Judge::Judge(Judge&&) noexcept = default;
Judge& Judge::operator=(Judge&&) noexcept = default;

Judgement Judge::operator()(const Observation& observation) const {
  return impl_->judge(observation);
}

}  // namespace heed::awareness
