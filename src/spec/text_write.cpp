#include <heed/logic/parse.h>
#include <heed/spec/print.h>
#include <heed/spec/text.h>

#include "words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace heed::spec {
namespace {

std::string attribute(const std::string& word, const std::vector<std::string>& arguments) {
  if (arguments.empty()) return fmt::format("@{} ", word);
  std::vector<std::string> quoted;
  for (const std::string& argument : arguments) quoted.push_back(quoted_string(argument));
  return fmt::format("@{}({}) ", word, fmt::join(quoted, ", "));
}

std::string note(const std::string& comment) {
  return comment.empty() ? std::string() : attribute("note", {comment});
}

/// The role with its axioms, unless it is the section's default and there are none.
std::string role(model::OutputRole role, model::OutputRole usual,
                 const std::vector<std::string>& axioms = {}) {
  return role == usual && axioms.empty() ? std::string() : attribute(word_of(role_words, role), axioms);
}

std::string declaration(const model::Variable& variable) {
  return fmt::format("{} : {}", quoted_name(variable.name), to_string(variable.domain));
}

void write_options(std::string& out, const Gr1& spec) {
  out += "[options]\n";
  if (!spec.name.empty()) out += fmt::format("name = {}\n", quoted_string(spec.name));
  out += fmt::format("timing = {}\ninitial = {}\n", to_string(spec.timing), to_string(spec.initial));
}

void write_memory(std::string& out, const Memory& memory) {
  const model::Domain& domain = memory.variable.domain;
  const std::string name = quoted_name(memory.variable.name);
  std::vector<std::string> initial;
  for (const std::int32_t code : memory.initial) initial.push_back(value_text(domain, code));
  out += fmt::format("{}{}{} = {}\n", role(memory.role, model::OutputRole::Memory),
                     note(memory.comment.empty() ? memory.variable.comment : memory.comment),
                     declaration(memory.variable), fmt::join(initial, ", "));
  if (domain.kind == model::Domain::Kind::Boolean)
    out += fmt::format("{}' = {}\n", name, logic::to_string(memory.update));
  for (const Memory::Case& c : memory.cases)
    out += fmt::format("{}' = {} when {}\n", name, value_text(domain, c.value), logic::to_string(c.guard));
}

void write_declarations(std::string& out, const Gr1& spec) {
  if (!spec.inputs.empty()) out += "\n[input]\n";
  for (const auto& input : spec.inputs) out += fmt::format("{}{}\n", note(input.comment), declaration(input));
  if (!spec.outputs.empty()) out += "\n[output]\n";
  for (const auto& output : spec.outputs)
    out += fmt::format("{}{}{}\n", role(output.role, model::OutputRole::Output),
                       note(output.variable.comment), declaration(output.variable));
  if (!spec.memories.empty()) out += "\n[memory]\n";
  for (const Memory& memory : spec.memories) write_memory(out, memory);
  if (!spec.definitions.empty()) out += "\n[define]\n";
  for (const Definition& d : spec.definitions)
    out += fmt::format("{}{}{} := {}\n", role(d.role, model::OutputRole::Recognised, d.axioms),
                       note(d.comment), quoted_name(d.name), logic::to_string(d.formula));
}

}  // namespace

std::string write_gr1(const Gr1& spec) {
  std::string out;
  write_options(out, spec);
  write_declarations(out, spec);
  for (const Part& part : parts) {
    const std::vector<Clause>& clauses = spec.*part.clauses;
    if (!clauses.empty()) out += fmt::format("\n[{}]\n", part.section);
    for (const Clause& clause : clauses) {
      const bool plain = clause.origin == Origin::Task && clause.axioms.empty();
      out += plain ? "" : attribute(to_string(clause.origin), clause.axioms);
      out += logic::to_string(clause.formula) + "\n";
    }
  }
  return out;
}

}  // namespace heed::spec
