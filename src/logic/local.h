#pragma once

#include <heed/logic/lower.h>

#include <cstddef>
#include <string>
#include <unordered_map>

namespace heed::logic {

// Past operators with the simplifications that keep monitors few.
[[nodiscard]] Formula previous(const Formula& a);
[[nodiscard]] Formula once(const Formula& a);
[[nodiscard]] Formula historically(const Formula& a);
[[nodiscard]] Formula since(const Formula& a, const Formula& b);
/// True at the first step only: `!Y true`.
[[nodiscard]] Formula first_step();

/// Whether a formula is local: free of G, F, U, W, R, so that its value is known a fixed number of steps
/// later.
class Locality {
 public:
  [[nodiscard]] bool is_local(const Formula& formula);

 private:
  std::unordered_map<Formula, bool, FormulaHash> known_;
};

/// How many steps later the value of a local formula is known. Comparisons count as in normal_terms().
[[nodiscard]] std::size_t lookahead(const Formula& local);

/// Turns local formulas into GR(1) parts, and gathers the monitors that these need.
class LocalCompiler {
 public:
  explicit LocalCompiler(std::string prefix) : prefix_(std::move(prefix)) {}

  void add_initial(const Formula& local);
  void add_safety(const Formula& local);
  void add_justice(const Formula& local);
  [[nodiscard]] Lowered finish() { return std::move(result_); }

 private:
  [[nodiscard]] Formula now(const Formula& past);
  [[nodiscard]] Formula next_step(const Formula& past);
  [[nodiscard]] Formula now_of(const Formula& node);
  [[nodiscard]] Formula next_of(const Formula& node);
  [[nodiscard]] std::size_t monitor(const Formula& past, bool initial);

  std::string prefix_;
  Lowered result_;
  std::unordered_map<Formula, Formula, FormulaHash> now_, next_;
  std::unordered_map<Formula, std::size_t, FormulaHash> monitors_[2];  ///< By initial value.
};

}  // namespace heed::logic
