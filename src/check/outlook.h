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
  /// What is left of a check.
  [[nodiscard]] std::span<const Program::Instruction> check(std::size_t i) const { return code(checks_[i]); }
  /// Guarantees on the step that may fail, as indices into `Rules::sys_step`, ascending.
  [[nodiscard]] const std::vector<std::uint32_t>& open_guarantees() const { return open_guarantees_; }
  /// What is left of the \p i th of them.
  [[nodiscard]] std::span<const Program::Instruction> guarantee(std::size_t i) const {
    return code(guarantees_[i]);
  }
  /// What is left of the \p i th justice of `Rules::step_justices`.
  [[nodiscard]] std::span<const Program::Instruction> justice(std::size_t i) const {
    return code(justices_[i]);
  }
  /// Instructions and rules that it holds.
  [[nodiscard]] std::size_t size() const {
    return code_.size() + tasks_.size() + first_task_.size() + guarantees_.size() + justices_.size();
  }

 private:
  struct Range {
    std::uint32_t begin = 0, end = 0;
  };
  [[nodiscard]] std::span<const Program::Instruction> code(Range range) const {
    return {code_.data() + range.begin, code_.data() + range.end};
  }
  Range append(const Program& program, const std::int64_t* kept, Foresight& foresight);
  [[nodiscard]] bool is(Range range, bool truth) const;

  void plan(const Enumeration& enumeration, const std::int64_t* kept, Foresight& foresight);

  bool dead_ = false;
  std::vector<Program::Instruction> code_;
  std::vector<Task> tasks_;
  std::vector<std::uint32_t> first_task_;
  std::vector<Range> checks_, guarantees_, justices_;
  std::vector<std::uint32_t> open_guarantees_;
};

/// The outlooks from what was kept, made when first asked for. Many steps are kept as the same values.
class Outlooks {
 public:
  explicit Outlooks(const Rules& rules) : rules_(rules) {}
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
