#pragma once

#include <heed/util/limits.h>

#include <compare>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <unordered_map>
#include <vector>

namespace heed::sim {

/// What a step of the machine leads to.
struct Ending {
  static constexpr std::uint32_t nowhere = UINT32_MAX;
  std::uint32_t next = nowhere;   ///< State; `nowhere`: the machine has no answer.
  std::uint32_t event = nowhere;  ///< As in Judge::event.
  bool fallback = false;
  friend auto operator<=>(const Ending&, const Ending&) = default;
};

/// A machine's answers as decision diagrams: a node of level i has one child for each letter of component i,
/// the children of the last level are endings. No level is left out, so that the level of a node is known
/// from the way to it. Equal diagrams are one node.
class Reactions {
 public:
  /// \param letters  Per level: how many.
  explicit Reactions(std::vector<std::uint32_t> letters) : letters_(std::move(letters)) {}

  [[nodiscard]] std::size_t levels() const { return letters_.size(); }
  [[nodiscard]] std::uint32_t letters(std::size_t level) const { return letters_[level]; }
  [[nodiscard]] std::uint32_t child(std::uint32_t node, std::uint32_t letter) const {
    return children_[node + letter];
  }
  [[nodiscard]] const Ending& ending(std::uint32_t number) const { return endings_[number]; }
  [[nodiscard]] std::size_t ending_count() const { return endings_.size(); }
  [[nodiscard]] const std::vector<std::uint32_t>& nodes(std::size_t level) const { return nodes_[level]; }
  [[nodiscard]] std::size_t size() const { return children_.size(); }

  std::uint32_t add_ending(const Ending& ending);
  /// \pre as many children as letters, of the level below. \throws util::LimitExceeded  Size
  std::uint32_t add_node(std::size_t level, std::span<const std::uint32_t> children);

 private:
  std::vector<std::uint32_t> letters_;
  std::vector<std::uint32_t> children_;  ///< A node's number is where its children begin.
  std::vector<std::vector<std::uint32_t>> nodes_{std::vector<std::vector<std::uint32_t>>(letters_.size())};
  std::unordered_multimap<std::uint64_t, std::uint32_t> known_;  ///< By hash; only looked up.
  std::vector<Ending> endings_;
  std::map<Ending, std::uint32_t> numbers_;
};

/// Most children of all nodes together.
inline constexpr std::size_t reaction_limit = std::size_t{1} << 25;

/// A machine that can be asked for its answers state by state.
class ReactionSource {
 public:
  ReactionSource() = default;
  ReactionSource(const ReactionSource&) = delete;
  ReactionSource& operator=(const ReactionSource&) = delete;
  virtual ~ReactionSource() = default;
  /// The blank observation before the first cell.
  [[nodiscard]] virtual Ending start() = 0;
  /// The node of level 0 (an ending where there is no level) for \p state.
  [[nodiscard]] virtual std::uint32_t expand(std::uint32_t state, Reactions& reactions) = 0;
};

/// All that can be reached, with states numbered anew.
struct ReactionMachine {
  Ending start;
  std::vector<std::uint32_t> roots;  ///< Per state.
  Reactions reactions;
};

/// Every state that some sequence of letters reaches. \throws util::LimitExceeded
[[nodiscard]] ReactionMachine explore(ReactionSource& source, std::vector<std::uint32_t> letters,
                                      util::Budget& budget);

/// States with the same events, fallbacks and missing answers for ever become one: partition refinement, a
/// pass over all nodes for each round. \cite hopcroft.71.tmc
[[nodiscard]] ReactionMachine merged(const ReactionMachine& machine, util::Budget& budget);

/// Per level: the first letter with the same effect everywhere as each one.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> same_letters(const Reactions& reactions);

/// Whether it never matters which of the components \p level and `level + 1` shows which letter. \pre as many
/// letters
[[nodiscard]] bool exchangeable(const Reactions& reactions, std::size_t level);

/// The machine over fewer letters: \p letters has, per level, those of \p machine that stay, in their new
/// order; levels where one stays are left out.
[[nodiscard]] ReactionMachine narrowed(const ReactionMachine& machine,
                                       const std::vector<std::vector<std::uint32_t>>& letters,
                                       util::Budget& budget);

}  // namespace heed::sim
