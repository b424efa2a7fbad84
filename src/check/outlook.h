#pragma once

#include "rules.h"

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace heed::check {

/// What the rules of a step come to once the values kept of the step before are known.
class Outlook {
 public:
  /// \param kept  Null before the first step, of which guarantees and justices with Next say nothing.
  Outlook(const Rules& rules, const std::int64_t* kept, Foresight& foresight);

  /// An assumption on the inputs fails whatever they are.
  [[nodiscard]] bool dead() const { return dead_; }
  /// What is to be done at a level of the enumeration of inputs, without the checks that hold whatever the
  /// step is. A check's index is into checks here.
  [[nodiscard]] std::span<const Task> tasks(std::size_t level) const {
    return {tasks_.data() + first_task_[level], tasks_.data() + first_task_[level + 1]};
  }
  /// What is left of a rule: code, or where there is none, a table.
  struct Test {
    std::uint32_t begin, end;
    Program::Table table;
  };
  /// Whether it holds of a step. \param registers  Scratch.
  [[nodiscard]] bool holds(const Test& test, const std::int32_t* step,
                           std::vector<std::int64_t>& registers) const {
    if (test.begin == test.end) return test.table.at(step);
    return Program::run({code_.data() + test.begin, code_.data() + test.end}, {step}, registers) != 0;
  }
  [[nodiscard]] const Test& check(std::size_t i) const { return checks_[i]; }
  /// Guarantees on the step that may fail, as indices into `Rules::sys_step`, ascending.
  [[nodiscard]] const std::vector<std::uint32_t>& open_guarantees() const { return open_guarantees_; }
  /// What is left of them, in the same order.
  [[nodiscard]] const std::vector<Test>& guarantees() const { return guarantees_; }
  /// What is left of the justices of `Rules::step_justices`.
  [[nodiscard]] const std::vector<Test>& justices() const { return justices_; }
  /// A measure of its memory: about 24 bytes each.
  [[nodiscard]] std::size_t size() const {
    return code_.size() + tasks_.size() + first_task_.size() +
           2 * (checks_.size() + guarantees_.size() + justices_.size());
  }

 private:
  Test append(const Program& program, const std::int64_t* kept, Foresight& foresight);
  [[nodiscard]] static bool is(const Test& test, bool truth) {
    return test.begin == test.end && test.table.is(truth);
  }

  void plan(const Enumeration& enumeration, const std::int64_t* kept, Foresight& foresight);

  bool dead_ = false;
  std::vector<Program::Instruction> code_;
  std::vector<Task> tasks_;
  std::vector<std::uint32_t> first_task_;
  std::vector<Test> checks_, guarantees_, justices_;
  std::vector<std::uint32_t> open_guarantees_;
};

/// The outlooks from what was kept, made when first asked for. Many steps are kept as the same values.
class Outlooks {
 public:
  explicit Outlooks(const Rules& rules) : rules_(rules), foresight_(rules.layout) {}
  /// Before the first step.
  [[nodiscard]] const Outlook& first();
  /// Valid until the next is asked for. \param values  The kept values of that number.
  [[nodiscard]] const Outlook& after(std::uint32_t number, const std::int64_t* values);

 private:
  /// Some ten megabytes: then all are forgotten.
  static constexpr std::size_t most = 400'000;
  static constexpr std::uint32_t before = UINT32_MAX;

  const Rules& rules_;
  Foresight foresight_;
  std::unordered_map<std::uint32_t, Outlook> outlooks_;
  std::size_t size_ = 0;
};

}  // namespace heed::check
