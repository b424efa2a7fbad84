#pragma once

#include <gmpxx.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

/// The approaches of the case study as its prose tells them, enumerated trace by trace with plain fractions.
/// Shares nothing with the program.
namespace case_study {

/// What can be seen, one bit each. `Colour`, `Shape` and `Whole` are those of the thing on the road, whatever
/// they are.
enum Part : unsigned { Sign = 1, Colour = 2, Shape = 4, Whole = 8, Text = 16 };

constexpr std::size_t cells = 5;

struct Trace {
  mpq_class probability;
  std::array<unsigned, cells> seen{};
};
using Traces = std::vector<Trace>;

/// P1: visibility grows linearly. \p parts: besides sign and whole. A bit that is not in \p has never comes.
[[nodiscard]] Traces linear_growth(const std::vector<unsigned>& parts, unsigned has);
/// P2: closely consecutive: \p parts in random order in the cells after the sign's.
[[nodiscard]] Traces closely_consecutive(const std::vector<unsigned>& parts);
/// P3: loosely consecutive: sign, shape, colour, then each of \p last, all from the colour's onset on.
[[nodiscard]] Traces loosely_consecutive(const std::vector<unsigned>& last);

/// The three, for the parts colour and shape.
[[nodiscard]] Traces traces_of(const std::string& profile);

/// Whether the controller knows now, from what is seen now and what was seen a step before.
using Detects = std::function<bool(unsigned now, unsigned before)>;

/// P(first detection in location i) for i = 0 ... 4, then P(never). \p reported: the bits that reach the
/// inputs.
[[nodiscard]] std::array<mpq_class, 6> detection(const Traces& traces, unsigned reported,
                                                 const Detects& detects);
/// [infeasible, stop in 1, ..., stop in 4], as the charts have it.
[[nodiscard]] std::vector<std::string> row(const Traces& traces, unsigned reported, const Detects& detects);

[[nodiscard]] bool base_detects(unsigned now, unsigned before);
[[nodiscard]] bool tree_detects(unsigned now, unsigned before);
[[nodiscard]] bool tree_or_full_detects(unsigned now, unsigned before);
/// Two of \p counted.
[[nodiscard]] Detects two_of(unsigned counted);

}  // namespace case_study
