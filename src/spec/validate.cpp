#include <heed/spec/gr1.h>
#include <heed/spec/symbols.h>
#include <heed/util/diagnostic.h>

#include "typing.h"

#include <fmt/format.h>

#include <set>

namespace heed::spec {
namespace {

using model::Domain;
using model::OutputRole;

[[noreturn]] void fail(const util::Location& location, std::string code, std::string message,
                       std::string hint = {}) {
  throw util::InputError(location, std::move(code), std::move(message), std::move(hint));
}

void check_domain(const model::Variable& variable) {
  const Domain& domain = variable.domain;
  if (domain.low > domain.high)
    fail(variable.location, "empty-range",
         fmt::format("'{}' has the empty range {}..{}", variable.name, domain.low, domain.high));
  const bool bits = domain.low == 0 && domain.high == 1;
  if (domain.kind == Domain::Kind::Boolean && !bits)
    fail(variable.location, "type", fmt::format("the Boolean '{}' is coded 0 and 1", variable.name));
  if (domain.kind != Domain::Kind::Enumeration) return;
  std::set<std::string> seen;
  for (const std::string& value : domain.values)
    if (!seen.insert(value).second)
      fail(variable.location, "duplicate-value",
           fmt::format("'{}' has the value '{}' twice", variable.name, value));
  if (domain.low != 0 || domain.size() != static_cast<std::int64_t>(domain.values.size()))
    fail(variable.location, "type",
         fmt::format("the values of '{}' are coded 0, 1, ... in their order", variable.name));
}

class Names {
 public:
  void add(const std::string& name, const util::Location& location) {
    if (name.empty()) fail(location, "empty-name", "a variable without a name");
    if (!seen_.insert(name).second)
      fail(location, "duplicate-name", fmt::format("the name '{}' is declared twice", name),
           "every name stands for one thing");
  }

 private:
  std::set<std::string> seen_;
};

void check_declarations(const Gr1& spec) {
  Names names;
  const auto variable = [&names](const model::Variable& v) {
    names.add(v.name, v.location);
    check_domain(v);
  };
  for (const auto& input : spec.inputs) variable(input);
  for (const auto& output : spec.outputs) {
    variable(output.variable);
    if (output.role != OutputRole::Action && output.role != OutputRole::Output)
      fail(output.variable.location, "role",
           fmt::format("'{}' is chosen by the system: its role is action or output", output.variable.name));
  }
  for (const auto& memory : spec.memories) variable(memory.variable);
  for (const auto& definition : spec.definitions) names.add(definition.name, definition.formula.location());
}

void check_code(const Memory& memory, std::int32_t code) {
  const Domain& domain = memory.variable.domain;
  if (code < domain.low || code > domain.high)
    fail(memory.variable.location, "value",
         fmt::format("{} is no value of '{}'", code, memory.variable.name));
}

void check_memory(const Memory& memory, const Symbols& symbols) {
  const model::Variable& variable = memory.variable;
  if (memory.initial.empty())
    fail(variable.location, "no-initial-value", fmt::format("'{}' has no initial value", variable.name));
  if (memory.initial.size() > 1 && memory.role != OutputRole::Plant)
    fail(variable.location, "several-initial-values",
         fmt::format("'{}' has several initial values, and only a plant may", variable.name));
  for (const std::int32_t code : memory.initial) check_code(memory, code);
  Place place{fmt::format("the update of '{}'", variable.name)};
  place.next = Place::Next::Inputs;
  if (variable.domain.kind == Domain::Kind::Boolean) {
    if (!memory.cases.empty())
      fail(variable.location, "type",
           fmt::format("the Boolean memory '{}' has an update, no cases", variable.name));
    check_formula(memory.update, symbols, place);
  }
  for (const Memory::Case& c : memory.cases) {
    check_code(memory, c.value);
    check_formula(c.guard, symbols, place);
  }
}

void check_definitions(const Gr1& spec, const Symbols& symbols) {
  for (const Definition& definition : spec.definitions) {
    Place place{fmt::format("the definition of '{}'", definition.name)};
    check_formula(definition.formula, symbols, place);
  }
  Gr1 sorted = spec;
  sort_definitions(sorted);
  for (std::size_t i = 0; i < spec.definitions.size(); ++i)
    if (sorted.definitions[i].name != spec.definitions[i].name)
      fail(spec.definitions[i].formula.location(), "definition-order",
           fmt::format("'{}' uses '{}', which is defined later", spec.definitions[i].name,
                       sorted.definitions[i].name),
           "sort_definitions() orders them");
}

void check_clauses(const std::vector<Clause>& clauses, const Symbols& symbols, Place place) {
  for (const Clause& clause : clauses) {
    place.text = clause.text;
    check_formula(clause.formula, symbols, place);
  }
}

}  // namespace

void validate(const Gr1& spec) {
  check_declarations(spec);
  const Symbols symbols(spec);
  for (const Memory& memory : spec.memories) check_memory(memory, symbols);
  check_definitions(spec, symbols);
  using Next = Place::Next;
  check_clauses(spec.env_init, symbols, {"[env init]", true, Next::Never});
  check_clauses(spec.env_safety, symbols, {"[env safety]", false, Next::Inputs});
  check_clauses(spec.env_justice, symbols, {"[env justice]", false, Next::Everything});
  check_clauses(spec.sys_init, symbols, {"[sys init]", false, Next::Never});
  check_clauses(spec.sys_safety, symbols, {"[sys safety]", false, Next::Everything});
  check_clauses(spec.sys_justice, symbols, {"[sys justice]", false, Next::Everything});
}

std::vector<model::Output> controller_outputs(const Gr1& spec) {
  std::vector<model::Output> columns = spec.outputs;
  for (const Memory& memory : spec.memories) columns.push_back({memory.variable, memory.role});
  for (const Definition& definition : spec.definitions)
    columns.push_back(
        {{definition.name, model::Domain::boolean(), definition.comment, definition.formula.location()},
         definition.role});
  return columns;
}

}  // namespace heed::spec
