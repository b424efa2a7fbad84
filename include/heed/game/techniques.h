#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace heed::game {

/// How a game is built and solved. None of these changes a verdict, a winning region or a rank; each can be
/// switched off to see what it gains (bench/RESULTS.md).
struct Techniques {
  /// Order variables by the clauses that they share, not as they were declared. \cite aloul.03.glsvlsi
  bool structure_order = true;
  /// Outputs that the clauses of every step define by the other variables are put in, not played.
  bool functional_outputs = true;
  /// What holds in every state bounds the sets of states; the step relation then need not say it again.
  bool state_invariants = true;
  /// The environment's steps stay apart, and each next input is quantified as early as they let.
  bool partition_environment = true;
  /// Variables that nothing reads one step later are quantified before the game.
  bool unread_variables = true;
  /// Conjuncts by what they let quantify, not as they were written: neighbours in the text speak of the same
  /// things, which is worth more on most inputs. \cite firman.20.acta
  bool greedy_schedule = false;
  /// Follow only what a set has lost or won since the step before; the rest is decided.
  bool frontier_sets = true;
  /// Sift also when much was done since the last time, not only on growth.
  bool work_reordering = true;
  /// Neighbours that share variables are put together while the result has at most this many nodes; 0: never.
  std::uint32_t cluster_nodes = 4000;
};

/// The names of Techniques, in the order of its members.
[[nodiscard]] std::vector<std::string> technique_names();

/// Sets the technique called \p name: "on" or "off", or a number from 0 to 1000000000 where it is one.
/// \throws std::invalid_argument  with a sentence: no such name, no such value
void set_technique(Techniques& techniques, std::string_view name, std::string_view value);

}  // namespace heed::game
