#pragma once

#include "board.h"

#include <heed/certify/certify.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace heed::certify {

/// Looks at one implication after the other and keeps the first that fails.
class Findings {
 public:
  explicit Findings(const Board& board) : board_(board) {}

  /// \p bad is empty. \returns whether; otherwise \p what is the fault, with an example.
  bool none(const bdd::Bdd& bad, const std::string& what);
  bool require(bool holds, const std::string& what);
  [[nodiscard]] bool sound() const { return verdict_.fault.empty(); }
  [[nodiscard]] Verdict verdict() const;

 private:
  const Board& board_;
  Verdict verdict_;
};

/// What is claimed for one goal.
struct Ranking {
  struct Rank {
    bdd::Bdd states;
    std::optional<std::uint32_t> assumption;
  };
  Justice met;
  std::vector<Rank> ranks;
};

/// States of the first argument from which the environment can avoid every step of the second that the
/// system would make.
using Escapes = std::function<bdd::Bdd(const bdd::Bdd& from, const bdd::Bdd& target)>;

/// Whether \p functions speak of states only.
[[nodiscard]] bool of_states(const Board& board, const std::vector<bdd::Bdd>& functions);

/// From each state of \p winning the system can go on until the goal is met, without leaving it. With U[k]
/// the states of rank k and below, i the assumption of rank k, a step from U[k] - U[k-1] may
///
///     meet:  met & winning'        approach:  U[k-1]'        wait:  !J_env[i] & U[k]'
///
/// \pre winning & escapes(winning, winning') is empty, which is looked at by the caller once for all goals
void check_ranking(const Board& board, const bdd::Bdd& winning, const Ranking& ranking,
                   const std::string& name, const Escapes& escapes, Findings& findings);

}  // namespace heed::certify
