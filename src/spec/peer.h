#pragma once

#include <heed/spec/gr1.h>
#include <heed/util/limits.h>
#include <heed/util/source.h>

#include "prefix.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace heed::spec {

/// One section of slugs' two formats: where its lines go, and what they may speak of.
struct SlugsSection {
  std::string_view word;                        ///< "INPUT"
  std::vector<Clause> Gr1::*clauses = nullptr;  ///< Null: it declares variables.
  bool input = false;                           ///< Declares inputs.
  bool step = false;                            ///< Its constraints are about steps.
  bool justice = false;
};

/// The section that \p line names, such as "[INPUT]". \throws util::InputError  code "unknown-section"
[[nodiscard]] const SlugsSection* find_section(const util::SourceText& source, std::size_t offset,
                                               std::string_view line);

/// Refuses names where slugs does: ENV_INIT knows inputs, no init knows primes, ENV_TRANS knows no primed
/// output. \throws util::InputError  code "not-allowed-here"
void check_place(const util::SourceText& source, std::size_t offset, const SlugsSection& section,
                 std::string_view name, bool input, bool primed);

/// \p formula about the present as a statement about steps: what holds of a state that is left. `X true`
/// marks it: heed would else read it as something that holds at every state.
[[nodiscard]] logic::Formula on_steps(const logic::Formula& formula, util::Location location);

/// And / Or without its units; nested ones stay as they are, so that shared parts stay shared.
[[nodiscard]] logic::Formula joined_flat(logic::Op op, std::vector<logic::Formula> parts);

/// Calls \p visit with the begin and end of every line that is neither empty nor a comment (`#` at its
/// beginning), without the blanks around it.
void for_each_line(const util::SourceText& source,
                   const std::function<void(std::size_t begin, std::size_t end)>& visit);

void add_variable(Gr1& spec, bool input, model::Variable variable);

/// Adds what a line of \p section says: one clause, or one for each of \p conjuncts, where an init or a step
/// is concerned. `true` adds nothing there.
void add_clauses(Gr1& spec, const util::SourceText& source, const SlugsSection& section, const Read& line,
                 std::size_t end, const std::vector<std::pair<Read, std::size_t>>& conjuncts);

/// \throws util::InputError  code "too-large"
void check_size(const util::SourceText& source, const util::Limits& limits);

[[nodiscard]] inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// "arbiter_2" of "corpus/arbiter_2.slugsin".
[[nodiscard]] std::string stem_of(const std::string& path);

}  // namespace heed::spec
