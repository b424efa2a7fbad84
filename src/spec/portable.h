#pragma once

#include <heed/spec/gr1.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace heed::spec {

/// A specification in the words that every peer has: inputs and outputs, what holds at the start, what holds
/// of each step, and justices. Enumerations are integers; Next stands on names only; no name is a value.
struct Portable {
  std::string name;
  std::vector<model::Variable> inputs, outputs;
  std::vector<logic::Formula> env_init, env_steps, env_justice;
  std::vector<logic::Formula> sys_init, sys_steps, sys_justice;
};

/// Lowers \p spec, keeping its verdict: memories and definitions become outputs with defining constraints, a
/// clause that holds at every step becomes one for the start and one for the next values. \throws
/// util::InputError  code "not-expressible": what \p target ("slugsin") has no words for
[[nodiscard]] Portable portable(const Gr1& spec, std::string_view target);

/// Encodes integers in bits; \p bit_name gives the name of bit i, least significant first.
[[nodiscard]] Portable in_bits(
    const Portable& spec, const std::function<std::string(const model::Variable&, std::size_t)>& bit_name);

/// All formulas of \p spec, to be changed or looked at.
[[nodiscard]] std::vector<std::vector<logic::Formula>*> formula_lists(Portable& spec);

/// Rebuilds a formula bottom-up, each shared part once: \p leaf gives what stands for a name, a name below
/// Next, or a number.
[[nodiscard]] logic::Formula rebuilt(const logic::Formula& formula,
                                     const std::function<logic::Formula(const logic::Formula&)>& leaf);

/// Next on every name.
[[nodiscard]] logic::Formula one_step_later(const logic::Formula& formula);

/// Nodes of \p formula when nothing is shared, at most \p most.
[[nodiscard]] std::size_t unfolded_size(const logic::Formula& formula, std::size_t most);

/// Refuses formulas that would become huge in a language without shared parts. \throws util::InputError  code
/// "not-expressible"
void insist_on_small(const std::vector<logic::Formula>& formulas, std::string_view target);

/// Names for a target: what \p fits refuses becomes `_`, and every name is used once. Keeps names that fit.
class TargetNames {
 public:
  TargetNames(const Portable& spec, const std::function<bool(char)>& fits,
              const std::vector<std::string_view>& reserved);
  [[nodiscard]] const std::string& operator[](const std::string& name) const;
  /// A name that nothing has, like \p wish.
  [[nodiscard]] std::string fresh(const std::string& wish);

 private:
  std::vector<std::pair<std::string, std::string>> names_;  ///< Sorted.
  std::vector<std::string> taken_;
};

}  // namespace heed::spec
