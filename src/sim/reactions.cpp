#include "reactions.h"

#include <heed/util/hash.h>

#include <algorithm>
#include <map>

namespace heed::sim {
namespace {

constexpr std::uint32_t unknown = UINT32_MAX;

/// Copies diagrams of one machine into another, level by level from below.
class Copier {
 public:
  /// \param letters  Per level of \p from: those that stay; empty: all. Levels where one stays are left out.
  Copier(const Reactions& from, Reactions& into, const std::vector<std::vector<std::uint32_t>>& letters,
         util::Budget& budget)
      : from_(from), into_(into), letters_(letters), budget_(budget) {}

  /// \param ending  The new one for each old one.
  std::vector<std::uint32_t> copy(const std::vector<std::uint32_t>& roots,
                                  const std::function<Ending(const Ending&)>& ending) {
    std::vector<std::uint32_t> below;
    for (std::uint32_t e = 0; e < from_.ending_count(); ++e)
      below.push_back(into_.add_ending(ending(from_.ending(e))));
    std::size_t level = into_.levels();
    for (std::size_t old = from_.levels(); old-- > 0;) {
      const bool kept = letters_.empty() || letters_[old].size() > 1;
      if (kept) --level;
      below = lift(old, kept ? level : unknown, below);
    }
    std::vector<std::uint32_t> result;
    result.reserve(roots.size());
    for (const std::uint32_t root : roots) result.push_back(below[root]);
    return result;
  }

 private:
  /// What the nodes of \p old become, when \p below says it of their children.
  std::vector<std::uint32_t> lift(std::size_t old, std::size_t level,
                                  const std::vector<std::uint32_t>& below) {
    std::vector<std::uint32_t> result(from_.size(), unknown), children;
    for (const std::uint32_t node : from_.nodes(old)) {
      budget_.check();
      if (level == unknown) {
        result[node] = below[from_.child(node, letters_[old].front())];
        continue;
      }
      children.clear();
      const std::uint32_t count =
          letters_.empty() ? from_.letters(old) : static_cast<std::uint32_t>(letters_[old].size());
      for (std::uint32_t i = 0; i < count; ++i)
        children.push_back(below[from_.child(node, letters_.empty() ? i : letters_[old][i])]);
      result[node] = into_.add_node(level, children);
    }
    return result;
  }

  const Reactions& from_;
  Reactions& into_;
  const std::vector<std::vector<std::uint32_t>>& letters_;
  util::Budget& budget_;
};

std::vector<std::uint32_t> letter_counts(const Reactions& reactions) {
  std::vector<std::uint32_t> counts;
  for (std::size_t level = 0; level < reactions.levels(); ++level) counts.push_back(reactions.letters(level));
  return counts;
}

/// Classes by what was found for each state, numbered in the order in which they come.
std::uint32_t classify(const std::vector<std::uint32_t>& roots, std::vector<std::uint32_t>& classes) {
  std::map<std::uint32_t, std::uint32_t> numbers;
  for (std::size_t s = 0; s < roots.size(); ++s)
    classes[s] = numbers.try_emplace(roots[s], static_cast<std::uint32_t>(numbers.size())).first->second;
  return static_cast<std::uint32_t>(numbers.size());
}

}  // namespace

std::uint32_t Reactions::add_ending(const Ending& ending) {
  const auto [found, added] = numbers_.try_emplace(ending, static_cast<std::uint32_t>(endings_.size()));
  if (added) endings_.push_back(ending);
  return found->second;
}

std::uint32_t Reactions::add_node(std::size_t level, std::span<const std::uint32_t> children) {
  std::uint64_t hash = level;
  for (const std::uint32_t c : children) hash = util::mix(hash, c);
  const auto [begin, end] = known_.equal_range(hash);
  for (auto at = begin; at != end; ++at)
    if (std::equal(children.begin(), children.end(), children_.begin() + at->second) &&
        std::binary_search(nodes_[level].begin(), nodes_[level].end(), at->second))
      return at->second;
  if (children_.size() + children.size() > reaction_limit)
    throw util::LimitExceeded(util::LimitExceeded::Kind::Size,
                              "the controller's answers as decision diagrams have more than 2^25 edges");
  const auto node = static_cast<std::uint32_t>(children_.size());
  children_.insert(children_.end(), children.begin(), children.end());
  nodes_[level].push_back(node);
  known_.emplace(hash, node);
  return node;
}

ReactionMachine explore(ReactionSource& source, std::vector<std::uint32_t> letters, util::Budget& budget) {
  ReactionMachine machine{source.start(), {}, Reactions(std::move(letters))};
  std::map<std::uint32_t, std::uint32_t> numbers;
  std::vector<std::uint32_t> states;
  const auto meet = [&](std::uint32_t state) {
    if (state == Ending::nowhere) return;
    if (numbers.try_emplace(state, static_cast<std::uint32_t>(states.size())).second) states.push_back(state);
  };
  meet(machine.start.next);
  std::size_t seen = 0;
  for (std::size_t s = 0; s < states.size(); ++s) {
    budget.check();
    machine.roots.push_back(source.expand(states[s], machine.reactions));
    for (; seen < machine.reactions.ending_count(); ++seen)
      meet(machine.reactions.ending(static_cast<std::uint32_t>(seen)).next);
  }
  Reactions numbered(letter_counts(machine.reactions));
  const auto renamed = [&](Ending ending) {
    if (ending.next != Ending::nowhere) ending.next = numbers.at(ending.next);
    return ending;
  };
  machine.roots = Copier(machine.reactions, numbered, {}, budget).copy(machine.roots, renamed);
  machine.start = renamed(machine.start);
  machine.reactions = std::move(numbered);
  return machine;
}

ReactionMachine merged(const ReactionMachine& machine, util::Budget& budget) {
  std::vector<std::uint32_t> classes(machine.roots.size(), 0);
  std::uint32_t count = 1;
  const auto by_class = [&](Ending ending) {
    if (ending.next != Ending::nowhere) ending.next = classes[ending.next];
    return ending;
  };
  for (;;) {
    Reactions reactions(letter_counts(machine.reactions));
    std::vector<std::uint32_t> roots =
        Copier(machine.reactions, reactions, {}, budget).copy(machine.roots, by_class);
    const Ending start = by_class(machine.start);
    const std::uint32_t before = count;
    count = classify(roots, classes);
    if (count != before) continue;
    ReactionMachine result{start, std::vector<std::uint32_t>(machine.roots.empty() ? 0 : count),
                           std::move(reactions)};
    for (std::size_t s = 0; s < roots.size(); ++s) result.roots[classes[s]] = roots[s];
    return result;
  }
}

std::vector<std::vector<std::uint32_t>> same_letters(const Reactions& reactions) {
  std::vector<std::vector<std::uint32_t>> result(reactions.levels());
  for (std::size_t level = 0; level < reactions.levels(); ++level)
    for (std::uint32_t x = 0; x < reactions.letters(level); ++x) {
      std::uint32_t first = 0;
      const auto same = [&](std::uint32_t node) {
        return reactions.child(node, first) == reactions.child(node, x);
      };
      while (first < x && !std::all_of(reactions.nodes(level).begin(), reactions.nodes(level).end(), same))
        ++first;
      result[level].push_back(first);
    }
  return result;
}

bool exchangeable(const Reactions& reactions, std::size_t level) {
  const auto symmetric = [&](std::uint32_t node) {
    for (std::uint32_t x = 0; x < reactions.letters(level); ++x)
      for (std::uint32_t y = 0; y < x; ++y)
        if (reactions.child(reactions.child(node, x), y) != reactions.child(reactions.child(node, y), x))
          return false;
    return true;
  };
  return std::all_of(reactions.nodes(level).begin(), reactions.nodes(level).end(), symmetric);
}

ReactionMachine narrowed(const ReactionMachine& machine,
                         const std::vector<std::vector<std::uint32_t>>& letters, util::Budget& budget) {
  std::vector<std::uint32_t> counts;
  for (const auto& staying : letters)
    if (staying.size() > 1) counts.push_back(static_cast<std::uint32_t>(staying.size()));
  ReactionMachine result{machine.start, {}, Reactions(counts)};
  result.roots = Copier(machine.reactions, result.reactions, letters, budget)
                     .copy(machine.roots, [](const Ending& ending) { return ending; });
  return result;
}

}  // namespace heed::sim
