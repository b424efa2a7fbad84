#pragma once

#include <heed/model/mealy.h>
#include <heed/spec/gr1.h>
#include <heed/util/limits.h>

#include <cstdint>
#include <string>
#include <vector>

namespace heed::check {

/// One step of a counterexample: the letters read and given.
struct TraceStep {
  model::Valuation input;
  model::Valuation output;  ///< Empty where the machine had no answer.
};

/// Why a machine is refused, in the specification's names.
struct Refutation {
  enum class Kind : std::uint8_t { Initial, Safety, MissingInput, Justice, WrongColumn };
  Kind kind;
  std::string clause;            ///< Text of the violated clause.
  std::string message;           ///< One sentence.
  std::vector<TraceStep> trace;  ///< From the first step to the violation.
  std::size_t loop_start = 0;    ///< Justice: the trace repeats from here for ever.
};

struct Verdict {
  bool verified = false;
  std::vector<Refutation> refutations;  ///< Empty when verified; at most `Options::most`.
  std::uint64_t product_states = 0;     ///< Reachable (machine state, step valuation) pairs looked at.
  std::uint64_t product_edges = 0;
  /// The machine wins some loop only because the environment never meets an assumption infinitely often.
  bool relies_on_broken_justice = false;
};

struct Options {
  std::size_t most = 1;  ///< How many refutations to look for.
};

/// Decides whether \p machine keeps \p spec: explicit, with its own evaluator, sharing nothing with the
/// solver. All legal inputs are enumerated from the specification, not taken from the machine. Columns of
/// memories, definitions and plant must equal what the specification says. Strict semantics: obligations end
/// when the environment breaks θe or ρe. Time O(product edges * size of spec). \throws util::LimitExceeded,
/// util::InputError (columns that do not fit the spec)
[[nodiscard]] Verdict verify(const model::Mealy& machine, const spec::Gr1& spec, util::Budget& budget,
                             const Options& options = {});

}  // namespace heed::check
