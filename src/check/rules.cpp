#include "rules.h"

#include <algorithm>

namespace heed::check {

using logic::Formula;
using model::Domain;

namespace {

/// `chosen`: known once the system has chosen where a plant starts. `never`: only with the machine's answer.
constexpr int never = 1 << 30, chosen = 1 << 29;

/// Finds for every slot after which input its value is known: 0 before any, k + 1 after input k, `never`
/// where it depends on the machine's answer.
class Levels {
 public:
  Levels(const Rules& rules, bool at_start) : level_(rules.layout.size(), never) {
    const spec::Gr1& spec = rules.spec;
    for (std::uint32_t i = 0; i < spec.inputs.size(); ++i) level_[i] = static_cast<int>(i) + 1;
    for (std::uint32_t i = 0; i < spec.memories.size(); ++i) {
      int& level = level_[rules.layout.memory(i)];
      if (at_start) {
        level = spec.memories[i].initial.size() == 1 ? 0 : chosen;
        continue;
      }
      level = of(rules.updates[i].otherwise);
      for (const auto& c : rules.updates[i].cases) level = std::max(level, of(c.guard));
    }
    for (std::uint32_t i = 0; i < spec.definitions.size(); ++i)
      level_[rules.layout.definition(i)] = of(rules.definitions[i]);
  }

  [[nodiscard]] int of(const Program& program) const {
    int level = 0;
    for (const std::uint32_t slot : program.loads()) level = std::max(level, level_[slot]);
    return level;
  }
  [[nodiscard]] int at(std::uint32_t slot) const { return level_[slot]; }

 private:
  std::vector<int> level_;
};

}  // namespace

Rules::Rules(const spec::Gr1& specification) : spec(specification), layout(specification) {
  compile_memories();
  compile_system();
  compile_justice();
  first = enumeration(true);
  later = enumeration(false);
  compile_kept();
}

void Rules::need(const Program& program) {
  registers = std::max(registers, program.size());
}

void Rules::compile_memories() {
  for (const auto& definition : spec.definitions)
    definitions.push_back(compile_present(definition.formula, layout));
  for (const spec::Memory& memory : spec.memories) {
    Update update;
    const Formula stay = logic::name(memory.variable.name);
    const bool ahead = std::any_of(memory.cases.begin(), memory.cases.end(),
                                   [](const auto& c) { return c.guard.has_next(); });
    if (memory.variable.domain.kind == Domain::Kind::Boolean) {
      update.otherwise = compile_step(memory.update, layout, kept);
    } else if (ahead) {
      for (const auto& c : memory.cases)
        update.cases.push_back({compile_step(c.guard, layout, kept), c.value});
      update.otherwise = compile_step(stay, layout, kept);
    } else {
      // The next value follows from the present step alone: it is all that has to be kept.
      std::vector<std::pair<Formula, std::int32_t>> cases;
      for (const auto& c : memory.cases) cases.emplace_back(c.guard, c.value);
      update.otherwise.emit({Program::Code::Kept, kept.index_of_cases(std::move(cases), stay)});
    }
    for (const auto& c : update.cases) need(c.guard);
    need(update.otherwise);
    updates.push_back(std::move(update));
  }
  for (const Program& program : definitions) need(program);
}

void Rules::compile_system() {
  for (const auto& clause : spec.sys_init)
    sys_init.push_back({&clause, compile_present(clause.formula, layout)});
  for (const auto& clause : spec.sys_safety) {
    if (!clause.formula.has_next()) {
      sys_present.push_back({&clause, compile_present(clause.formula, layout)});
      continue;
    }
    Program program = compile_step(clause.formula, layout, kept);
    auto& list = program.reads_kept() ? sys_step : sys_coming;
    list.push_back({&clause, std::move(program)});
  }
  for (const auto* list : {&sys_init, &sys_present, &sys_coming, &sys_step})
    for (const Rule& rule : *list) need(rule.program);
}

void Rules::compile_justice() {
  env_justices = spec.env_justice.size();
  sys_justices = spec.sys_justice.size();
  for (const auto* part : {&spec.env_justice, &spec.sys_justice})
    for (const auto& clause : *part) {
      const bool step = clause.formula.has_next();
      Program program =
          step ? compile_step(clause.formula, layout, kept) : compile_present(clause.formula, layout);
      need(program);
      if (step) step_justices.push_back(static_cast<std::uint32_t>(justice_step.size()));
      (step ? justice_step : justice_present).push_back(std::move(program));
      (step ? justice_present : justice_step).push_back(std::nullopt);
    }
}

Enumeration Rules::enumeration(bool at_start) {
  const Levels levels(*this, at_start);
  Enumeration out;
  out.levels.resize(spec.inputs.size() + 1);
  const auto schedule = [&out](int level, Task task) {
    out.levels[static_cast<std::size_t>(level)].push_back(task);
  };
  for (std::uint32_t i = 0; i < spec.memories.size(); ++i)
    if (levels.at(layout.memory(i)) < chosen) schedule(levels.at(layout.memory(i)), {Task::Kind::Memory, i});
  std::vector<bool> wanted(layout.size());
  const auto add = [&](const spec::Clause& clause, bool step) {
    Rule rule{&clause,
              step ? compile_step(clause.formula, layout, kept) : compile_present(clause.formula, layout)};
    need(rule.program);
    const int level = levels.of(rule.program);
    const bool known = level < chosen;
    for (const std::uint32_t slot : rule.program.loads()) wanted[slot] = wanted[slot] || known;
    (known ? out.checks : level == chosen ? out.start : out.after).push_back(std::move(rule));
  };
  if (at_start)
    for (const auto& clause : spec.env_init) add(clause, false);
  for (const auto& clause : spec.env_safety)
    if (const bool step = clause.formula.has_next(); !step || !at_start) add(clause, step);
  for (std::uint32_t i = static_cast<std::uint32_t>(definitions.size()); i-- > 0;)
    if (wanted[layout.definition(i)])
      for (const std::uint32_t slot : definitions[i].loads()) wanted[slot] = true;
  for (std::uint32_t i = 0; i < definitions.size(); ++i)
    if (wanted[layout.definition(i)]) schedule(levels.at(layout.definition(i)), {Task::Kind::Definition, i});
  for (std::uint32_t i = 0; i < out.checks.size(); ++i)
    schedule(levels.of(out.checks[i].program), {Task::Kind::Check, i});
  return out;
}

void Rules::compile_kept() {
  for (const Kept::Entry& entry : kept.entries()) {
    KeptProgram program{{}, compile_present(entry.term, layout)};
    for (const auto& [guard, value] : entry.cases)
      program.cases.emplace_back(compile_present(guard, layout), value);
    for (const auto& [guard, value] : program.cases) need(guard);
    need(program.term);
    kept_programs.push_back(std::move(program));
  }
}

}  // namespace heed::check
