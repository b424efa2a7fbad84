#pragma once

#include <heed/model/mealy.h>
#include <heed/spec/gr1.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

/// A second opinion on games, for tests only: plain numbers and vectors, a recursive evaluator, and
/// Zielonka's algorithm on the explicit parity game. It shares nothing with the rooms game and strategy.
namespace heed::reference {

using Values = std::map<std::string, std::int64_t>;

/// Evaluates clauses under explicit values. Definitions are evaluated where they stand.
class Evaluator {
 public:
  explicit Evaluator(const spec::Gr1& spec);
  [[nodiscard]] bool holds(const logic::Formula& formula, const Values& now, const Values& next = {}) const;
  [[nodiscard]] bool holds(const std::vector<spec::Clause>& clauses, const Values& now,
                           const Values& next = {}) const;
  /// The next values of all memories.
  [[nodiscard]] Values memories(const Values& now, const Values& next_inputs) const;
  [[nodiscard]] const model::Domain* domain(const std::string& name) const;

 private:
  [[nodiscard]] std::int64_t term(const logic::Formula& node, const Values& now, const Values& next,
                                  const model::Domain* other) const;
  [[nodiscard]] bool compare(const logic::Formula& node, const Values& now, const Values& next) const;
  [[nodiscard]] const model::Domain* enumeration_of(const logic::Formula& node) const;

  const spec::Gr1& spec_;
  std::map<std::string, const model::Domain*> domains_;
  std::map<std::string, const logic::Formula*> definitions_;
};

/// What both the solver and the verifier of machines need to know about the rules of the game.
class Rules {
 public:
  explicit Rules(const spec::Gr1& spec);
  [[nodiscard]] const spec::Gr1& spec() const { return spec_; }
  [[nodiscard]] const Evaluator& evaluator() const { return evaluator_; }
  [[nodiscard]] const std::vector<Values>& inputs() const { return inputs_; }  ///< All, in ascending order.
  [[nodiscard]] const std::vector<Values>& outputs() const { return outputs_; }
  [[nodiscard]] const std::vector<Values>& memories() const { return memories_; }  ///< Initial ones.

  [[nodiscard]] bool legal_first(const Values& input) const;
  [[nodiscard]] bool good_first(const Values& state) const;
  [[nodiscard]] bool legal(const Values& state, const Values& input) const;
  /// The state after a step.
  [[nodiscard]] Values after(const Values& state, const Values& input, const Values& output) const;
  [[nodiscard]] bool good(const Values& state, const Values& next) const;

 private:
  [[nodiscard]] bool environment_keeps(const Values& state) const;
  [[nodiscard]] bool mentions_outputs(const logic::Formula& formula) const;

  const spec::Gr1& spec_;
  Evaluator evaluator_;
  std::vector<Values> inputs_, outputs_, memories_;
  std::vector<spec::Clause> always_;  ///< Assumptions without Next that outputs cannot break.
  std::vector<spec::Clause> steps_;   ///< The other ones.
};

/// Counters for both lists of justices: colour 2 when the system's is through, else 1 when the environment's
/// is, else 0.
struct Counters {
  std::size_t env = 0, sys = 0;
  int colour = 0;
  auto operator<=>(const Counters&) const = default;
};
[[nodiscard]] Counters advance(const Rules& rules, Counters counters, const Values& state,
                               const Values& next);

/// Whether the system wins.
[[nodiscard]] bool realizable(const Rules& rules);

/// Empty when \p machine keeps the specification, else what it breaks. Rows marked as fallback are left out.
[[nodiscard]] std::string fault(const model::Mealy& machine, const Rules& rules);

}  // namespace heed::reference
