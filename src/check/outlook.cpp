#include "outlook.h"

namespace heed::check {

Outlook::Outlook(const Rules& rules, const std::int64_t* kept, Foresight& foresight) {
  plan(kept ? rules.later : rules.first, kept, foresight);
  if (!kept || dead_) return;
  open_guarantees_.reserve(rules.sys_step.size());
  guarantees_.reserve(rules.sys_step.size());
  for (std::uint32_t i = 0; i < rules.sys_step.size(); ++i) {
    const Test test = append(rules.sys_step[i].program, kept, foresight);
    if (is(test, true)) continue;
    open_guarantees_.push_back(i);
    guarantees_.push_back(test);
  }
  for (const std::uint32_t j : rules.step_justices)
    justices_.push_back(append(*rules.justice_step[j], kept, foresight));
}

void Outlook::plan(const Enumeration& enumeration, const std::int64_t* kept, Foresight& foresight) {
  first_task_.reserve(enumeration.levels.size() + 1);
  checks_.reserve(enumeration.checks.size());
  tasks_.reserve(enumeration.checks.size());
  for (const auto& level : enumeration.levels) {
    first_task_.push_back(static_cast<std::uint32_t>(tasks_.size()));
    for (Task task : level) {
      if (task.kind == Task::Kind::Check) {
        const Test test = append(enumeration.checks[task.index].program, kept, foresight);
        if (is(test, true)) continue;
        dead_ = dead_ || is(test, false);
        task.index = static_cast<std::uint32_t>(checks_.size());
        checks_.push_back(test);
      }
      tasks_.push_back(task);
    }
  }
  first_task_.push_back(static_cast<std::uint32_t>(tasks_.size()));
}

Outlook::Test Outlook::append(const Program& program, const std::int64_t* kept, Foresight& foresight) {
  const auto begin = static_cast<std::uint32_t>(code_.size());
  foresight.append(program, kept, code_);
  const std::optional<Program::Table> table = foresight.table({code_.data() + begin, code_.size() - begin});
  if (!table) return {begin, static_cast<std::uint32_t>(code_.size()), {}};
  code_.resize(begin);
  return {begin, begin, *table};
}

const Outlook& Outlooks::first() {
  return outlooks_.try_emplace(before, rules_, nullptr, foresight_).first->second;
}

const Outlook& Outlooks::after(std::uint32_t number, const std::int64_t* values) {
  const auto found = outlooks_.find(number);
  if (found != outlooks_.end()) return found->second;
  if (size_ > most) {
    outlooks_.clear();
    size_ = 0;
  }
  const Outlook& made = outlooks_.try_emplace(number, rules_, values, foresight_).first->second;
  size_ += made.size();
  return made;
}

}  // namespace heed::check
