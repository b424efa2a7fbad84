#include <heed/awareness/glimpse.h>

#include <heed/awareness/observation.h>

#include "evidence.h"
#include "horn.h"
#include "units.h"

#include <algorithm>

namespace heed::awareness {
namespace {

std::vector<Approach::Glimpse> glimpses(const Catalogue& catalogue, const Judge& judge,
                                        const std::vector<std::size_t>& features) {
  std::vector<Approach::Glimpse> result;
  for (const std::size_t f : features) {
    Judgement found = judge({{f}, {}, {}});
    result.push_back({f, std::move(found.candidates), std::move(found.common)});
    // What a behaviour entails is not said again.
    auto& common = result.back().common;
    const auto all = common;
    std::erase_if(common, [&](std::size_t b) {
      return std::any_of(all.begin(), all.end(), [&](std::size_t c) {
        const auto& up = catalogue.behaviours[c].general;
        return c != b && std::any_of(up.begin(), up.end(), [&](const Entailed& g) { return g.index == b; });
      });
    });
  }
  return result;
}

Approach::Confusion confusion(const HornBase& base, const std::vector<std::size_t>& features,
                              std::size_t other) {
  Approach::Confusion result{other, {}, false};
  std::vector<HornBase::Prop> all{base.entity(other)};
  for (const std::size_t f : features) {
    if (base.closure({base.entity(other), base.feature(f)})[base.nothing()] != 0) result.until.push_back(f);
    all.push_back(base.feature(f));
  }
  result.ever = !result.until.empty() || base.closure(all)[base.nothing()] != 0;
  return result;
}

}  // namespace

std::vector<Approach> approaches(const Catalogue& catalogue, const Perception& perception,
                                 const Recognition& recognition, bool closed) {
  const HornBase base(catalogue);
  const Judge judge(catalogue, {closed, {}});
  const Units leaves(catalogue, true);
  std::vector<Approach> result;
  for (std::size_t e = 0; e < catalogue.entities.size(); ++e) {
    if (!catalogue.entities[e].satisfiable) continue;
    Approach approach{e, {}, true};
    if (const RecognisedEntity* rule = recognition.find_entity(e)) {
      approach.evidence = rule->evidence;
      approach.evidence_complete = rule->evidence_complete;
    }
    std::vector<std::size_t> features;
    for (const Entailed& has : catalogue.described(e, perception.perceivable)) features.push_back(has.index);
    approach.glimpses = glimpses(catalogue, judge, features);
    if (!features.empty())
      for (const std::size_t other : leaves.entities) {
        if (within(catalogue, other, e) || within(catalogue, e, other)) continue;
        auto found = confusion(base, features, other);
        if (found.until.size() < features.size()) approach.confusions.push_back(std::move(found));
      }
    result.push_back(std::move(approach));
  }
  return result;
}

std::vector<std::size_t> prescribed_under(const Recognition& recognition, const std::set<std::string>& seen) {
  const auto values = derived_values(recognition, seen);
  std::vector<std::size_t> result;
  for (const PrescribedBehaviour& prescribed : recognition.behaviours)
    if (values.at(prescribed.name)) result.push_back(prescribed.behaviour);
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace heed::awareness
