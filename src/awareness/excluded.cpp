#include <heed/awareness/explain.h>

#include <fmt/format.h>

#include <algorithm>

namespace heed::awareness {
namespace {

/// The smallest listed evidence that is all seen.
const Evidence* smallest_seen(const std::vector<Evidence>& list, const std::set<std::string>& seen) {
  const Evidence* best = nullptr;
  for (const Evidence& evidence : list) {
    const bool all = std::all_of(evidence.atoms.begin(), evidence.atoms.end(),
                                 [&](const std::string& atom) { return seen.contains(atom); });
    if (all && (best == nullptr || evidence.atoms.size() < best->atoms.size())) best = &evidence;
  }
  return best;
}

}  // namespace

std::optional<ExplanationStep> why_impossible(const Catalogue& catalogue, const Recognition& recognition,
                                              std::size_t entity, const std::set<std::string>& seen) {
  for (const Situation& situation : recognition.situations) {
    if (situation.kind != Situation::Kind::Possible || situation.entity != entity) continue;
    const Evidence* against = smallest_seen(situation.against, seen);
    if (against == nullptr) return std::nullopt;
    return ExplanationStep{fmt::format("It cannot be a '{}': '{}' rules that out.",
                                       catalogue.entities[entity].label, fmt::join(against->atoms, "', '")),
                           axiom_texts(catalogue, against->axioms)};
  }
  return std::nullopt;
}

Explanation explain_excluded(const Catalogue& catalogue, const Recognition& recognition,
                             const std::set<std::string>& seen) {
  Explanation result{"What it can no longer be", false, {}};
  for (const Situation& situation : recognition.situations)
    if (situation.kind == Situation::Kind::Possible)
      if (auto step = why_impossible(catalogue, recognition, *situation.entity, seen))
        result.steps.push_back(std::move(*step));
  result.holds = !result.steps.empty();
  if (!result.holds) result.subject = "Nothing is ruled out by what is seen";
  return result;
}

}  // namespace heed::awareness
