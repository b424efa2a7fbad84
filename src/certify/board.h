#pragma once

#include "encoding.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace heed::certify {

/// exists V . start & part_1 & ... & part_n, each variable of V quantified with the last part that has it.
class Product {
 public:
  Product(bdd::Manager& manager, const std::vector<bdd::Bdd>& parts, const std::vector<bdd::Var>& quantified);
  [[nodiscard]] bdd::Bdd operator()(bdd::Bdd start) const;

 private:
  std::vector<std::pair<bdd::Bdd, bdd::Bdd>> stages_;  ///< Part, and what is quantified with it.
};

struct Justice {
  bdd::Bdd relation;
  bool step = false;  ///< Speaks of two successive states.
  std::string text;
};

/// The rules of the game that a specification is (docs/semantics.md), and what can be forced in one step.
class Board {
  const spec::Gr1& spec_;
  Encoding encoding_;  ///< Before all diagrams: its manager outlives them.

 public:
  Board(const spec::Gr1& spec, const std::vector<std::uint32_t>& order, util::Budget& budget);

  [[nodiscard]] const spec::Gr1& spec() const { return spec_; }
  [[nodiscard]] const Encoding& encoding() const { return encoding_; }
  [[nodiscard]] bool moore() const { return spec_.timing == spec::Timing::Moore; }

  bdd::Bdd first_inputs;            ///< X: legal at the first step.
  bdd::Bdd first_answers;           ///< X, Y, M: what the system may answer there.
  bdd::Bdd states;                  ///< X, Y, M: codes of values.
  std::vector<bdd::Bdd> env_steps;  ///< Conjuncts of rho_e.
  std::vector<bdd::Bdd> sys_steps;  ///< Conjuncts of rho_s.
  std::vector<std::string> sys_texts;
  std::vector<bdd::Bdd> updates;                  ///< X, Y, M, X': next bits of the memories.
  std::vector<Justice> env_justice, sys_justice;  ///< Never empty.

  /// Whether the start is won when \p winning is, by the specification's quantifiers.
  [[nodiscard]] bool wins_start(const bdd::Bdd& winning) const;
  /// States of \p from at which the environment can see to it that no answer makes a step of \p target.
  /// \param target  Over current and next values.
  [[nodiscard]] bdd::Bdd escapes(const bdd::Bdd& from, const bdd::Bdd& target) const;
  /// exists X', M' . \p steps & rho_e & M' = update
  [[nodiscard]] bdd::Bdd forced(const bdd::Bdd& steps) const { return moves_(steps); }
  /// The same without quantifiers.
  [[nodiscard]] bdd::Bdd legal(const bdd::Bdd& steps) const { return plain_moves_(steps); }
  /// "X = 1, Y = 2" of some state or step in \p steps. \pre not false
  [[nodiscard]] std::string example(const bdd::Bdd& steps) const {
    return encoding_.values(steps.pick_path());
  }

 private:
  [[nodiscard]] bool judged_by_answers(const logic::Formula& formula) const;
  void start();
  void environment();
  void system();
  void memories(util::Budget& budget);
  [[nodiscard]] std::vector<Justice> justices(const std::vector<spec::Clause>& clauses) const;
  [[nodiscard]] bool mentions(const bdd::Bdd& function, bool next_outputs) const;
  [[nodiscard]] std::vector<bdd::Bdd> moves() const;
  [[nodiscard]] std::vector<bdd::Bdd> answering() const;
  [[nodiscard]] bdd::Bdd doomed() const;

  bdd::Bdd always_env_;  ///< Current; what the environment keeps at every step whatever is answered.
  bdd::Bdd always_sys_;  ///< Current; what the system keeps at every step.
  Product moves_{encoding_.manager(), {}, {}}, plain_moves_{moves_}, answers_{moves_};
  bdd::Bdd doomed_;  ///< X, Y, M: states at which the environment can break rho_s, whatever is answered.
};

/// Text of a clause for messages.
[[nodiscard]] std::string text_of(const spec::Clause& clause);

}  // namespace heed::certify
