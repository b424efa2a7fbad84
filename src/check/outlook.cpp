#include "outlook.h"

namespace heed::check {

Outlook::Outlook(const Rules& rules, const std::int64_t* kept, Foresight& foresight) {
  plan(kept ? rules.later : rules.first, kept, foresight);
  if (!kept || dead_) return;
  for (std::uint32_t i = 0; i < rules.sys_step.size(); ++i) {
    const Range range = append(rules.sys_step[i].program, kept, foresight);
    if (is(range, true)) continue;
    open_guarantees_.push_back(i);
    guarantees_.push_back(range);
  }
  for (const std::uint32_t j : rules.step_justices)
    justices_.push_back(append(*rules.justice_step[j], kept, foresight));
}

void Outlook::plan(const Enumeration& enumeration, const std::int64_t* kept, Foresight& foresight) {
  for (const auto& level : enumeration.levels) {
    first_task_.push_back(static_cast<std::uint32_t>(tasks_.size()));
    for (Task task : level) {
      if (task.kind == Task::Kind::Check) {
        const Range range = append(enumeration.checks[task.index].program, kept, foresight);
        if (is(range, true)) continue;
        dead_ = dead_ || is(range, false);
        task.index = static_cast<std::uint32_t>(checks_.size());
        checks_.push_back(range);
      }
      tasks_.push_back(task);
    }
  }
  first_task_.push_back(static_cast<std::uint32_t>(tasks_.size()));
}

Outlook::Range Outlook::append(const Program& program, const std::int64_t* kept, Foresight& foresight) {
  const auto begin = static_cast<std::uint32_t>(code_.size());
  foresight.append(program, kept, code_);
  return {begin, static_cast<std::uint32_t>(code_.size())};
}

bool Outlook::is(Range range, bool truth) const {
  return range.end == range.begin + 1 && code_[range.begin].code == Program::Code::Constant &&
         (code_[range.begin].constant != 0) == truth;
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
