#pragma once

#include <heed/logic/formula.h>
#include <heed/util/limits.h>
#include <heed/util/source.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace heed::model {

/// A labelled finite transition system: what the machine can do. Immutable after reading. States, actions,
/// labels and values keep the order in which the file names them.
struct Fts {
  struct Transition {
    std::uint32_t from, action, to;  ///< Indices into `states`, `actions`.
    util::Location location;
  };
  std::string name;  ///< File name or "inline".
  std::vector<std::string> states;
  std::vector<std::string> actions;
  std::vector<std::uint32_t> initial;  ///< At least one.
  std::vector<Transition> transitions;
  /// `label moving: M4 ...`: a proposition and the states where it holds (one flag per state).
  std::vector<std::pair<std::string, std::vector<bool>>> labels;
  /// `value location: M4=4 ...`: an integer per state (every state has one).
  std::vector<std::pair<std::string, std::vector<std::int32_t>>> values;

  /// Successors of (state, action), ascending; empty when the action is not enabled there.
  [[nodiscard]] std::vector<std::uint32_t> successors(std::uint32_t state, std::uint32_t action) const;
  [[nodiscard]] bool deterministic() const;
};

/// Reads `.fts` (docs/formats/fts.md). \throws util::InputError  syntax; a state that is not listed; a state
/// without outgoing transition ("dead end"); two `initial:` lines; a label or value for an unknown state; a
/// state without a value.
[[nodiscard]] Fts read_fts(const util::SourceText& source, const util::Limits& limits = {});

/// Writes what read_fts() reads back.
[[nodiscard]] std::string write_fts(const Fts& fts);

}  // namespace heed::model
