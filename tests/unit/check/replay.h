#pragma once

#include <heed/check/verify.h>

#include "unit/check/naive.h"

#include <gtest/gtest.h>

namespace naive {

inline Step step_of(const heed::spec::Gr1& spec, const heed::check::TraceStep& step) {
  Step out;
  for (std::size_t i = 0; i < spec.inputs.size(); ++i) out[spec.inputs[i].name] = step.input.at(i);
  const auto columns = heed::spec::controller_outputs(spec);
  for (std::size_t i = 0; i < step.output.size(); ++i) out[columns[i].variable.name] = step.output.at(i);
  return out;
}

/// Whether the formula speaks of the next step.
inline bool steps(const heed::logic::Formula& f) {
  return f.op() == heed::logic::Op::Next ||
         std::any_of(f.operands().begin(), f.operands().end(), [](const auto& g) { return steps(g); });
}

/// The loop meets every assumption and never the guarantee.
inline void expect_unfair_loop(const heed::spec::Gr1& spec, const heed::check::Refutation& refutation) {
  const Evaluator holds(spec);
  const auto& trace = refutation.trace;
  const auto met = [&](const heed::spec::Clause& clause) {
    for (std::size_t t = refutation.loop_start; t < trace.size(); ++t) {
      const std::size_t before = t > refutation.loop_start ? t - 1 : trace.size() - 1;
      const bool step = steps(clause.formula);
      const Step now = step_of(spec, trace[step ? before : t]), next = step_of(spec, trace[t]);
      if (holds(clause.formula, now, next) != 0) return true;
    }
    return false;
  };
  for (const auto& clause : spec.env_justice) EXPECT_TRUE(met(clause)) << clause.text;
  bool some_missed = false;
  for (const auto& clause : spec.sys_justice)
    if (clause.text == refutation.clause) some_missed = some_missed || !met(clause);
  EXPECT_TRUE(some_missed) << refutation.clause;
}

/// Runs the trace through the machine: every row is there as told, the inputs are legal, and the end is as
/// the kind says.
inline void replay(const heed::model::Mealy& machine, const heed::spec::Gr1& spec,
                   const heed::check::Refutation& refutation) {
  using Kind = heed::check::Refutation::Kind;
  const Evaluator holds(spec);
  std::uint32_t state = 0, loop_state = 0;
  ASSERT_FALSE(refutation.trace.empty());
  for (std::size_t t = 0; t < refutation.trace.size(); ++t) {
    if (t == refutation.loop_start) loop_state = state;
    const auto& step = refutation.trace[t];
    const auto letter = machine.input_letter(step.input);
    const auto* row = letter ? machine.find(state, *letter) : nullptr;
    if (!row) {
      EXPECT_EQ(refutation.kind, Kind::MissingInput);
      EXPECT_EQ(t + 1, refutation.trace.size());
      return;
    }
    EXPECT_EQ(machine.output_letters[row->output], step.output);
    const Step now = step_of(spec, step);
    for (const auto& clause : spec.env_init) {
      EXPECT_TRUE(t > 0 || holds(clause.formula, now, now) != 0) << clause.text;
    }
    for (const auto& clause : spec.env_safety) {
      EXPECT_TRUE(t == 0 || holds(clause.formula, step_of(spec, refutation.trace[t - 1]), now) != 0)
          << clause.text;
    }
    state = row->next;
  }
  EXPECT_NE(refutation.kind, Kind::MissingInput);
  if (refutation.kind != Kind::Justice) return;
  EXPECT_EQ(state, loop_state);
  expect_unfair_loop(spec, refutation);
}

}  // namespace naive
