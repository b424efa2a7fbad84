#include <heed/logic/parse.h>
#include <heed/spec/print.h>

#include "words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace heed::spec {

using model::Domain;
using model::OutputRole;

std::string quoted_name(const std::string& name) {
  return logic::to_string(logic::name(name));
}

std::string quoted_string(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (c == '\n')
      out += "\\n";
    else
      out += c;
  }
  return out + '"';
}

std::string value_text(const Domain& domain, std::int32_t code) {
  const std::string text = domain.print(code);
  return domain.kind == Domain::Kind::Enumeration ? quoted_name(text) : text;
}

std::string to_string(Origin origin) {
  return word_of(origin_words, origin);
}

std::string to_string(Timing timing) {
  return word_of(timing_words, timing);
}

std::string to_string(InitialQuantifiers quantifiers) {
  return word_of(initial_words, quantifiers);
}

std::string to_string(const Domain& domain) {
  switch (domain.kind) {
    case Domain::Kind::Boolean:
      return "boolean";
    case Domain::Kind::Integer:
      return fmt::format("{}..{}", domain.low, domain.high);
    case Domain::Kind::Enumeration:
      break;
  }
  std::vector<std::string> values;
  for (const std::string& value : domain.values) values.push_back(quoted_name(value));
  return fmt::format("{{{}}}", fmt::join(values, ", "));
}

namespace {

/// Two columns: what is said, and where it comes from.
class Listing {
 public:
  void heading(std::string_view text) { out_ += fmt::format("{}{}\n", out_.empty() ? "" : "\n", text); }
  void line(std::string_view left, const std::string& right) {
    out_ += right.empty() ? fmt::format("  {}\n", left) : fmt::format("  {:<56}  # {}\n", left, right);
  }
  [[nodiscard]] std::string take() { return std::move(out_); }

 private:
  std::string out_;
};

std::string from(const std::string& source, const std::vector<std::string>& axioms) {
  return axioms.empty() ? source : fmt::format("{}: {}", source, fmt::join(axioms, ", "));
}

std::string described(OutputRole role, const std::string& comment) {
  const std::string word = word_of(role_words, role);
  return comment.empty() ? word : fmt::format("{}; {}", word, comment);
}

void list_memory(Listing& out, const Memory& memory) {
  const std::string name = quoted_name(memory.variable.name);
  const Domain& domain = memory.variable.domain;
  std::vector<std::string> initial;
  for (const std::int32_t code : memory.initial) initial.push_back(value_text(domain, code));
  out.line(fmt::format("{} : {}, at first {}", name, to_string(domain), fmt::join(initial, " or ")),
           described(memory.role, memory.comment));
  if (domain.kind == Domain::Kind::Boolean)
    out.line(fmt::format("  {}' = {}", name, logic::to_string(memory.update)), "");
  for (const Memory::Case& c : memory.cases)
    out.line(fmt::format("  {}' = {} when {}", name, value_text(domain, c.value), logic::to_string(c.guard)),
             "");
}

void list_declarations(Listing& out, const Gr1& spec) {
  if (!spec.inputs.empty()) out.heading("inputs (chosen by the environment)");
  for (const auto& input : spec.inputs)
    out.line(fmt::format("{} : {}", quoted_name(input.name), to_string(input.domain)), input.comment);
  if (!spec.outputs.empty()) out.heading("outputs (chosen by the system)");
  for (const auto& output : spec.outputs)
    out.line(fmt::format("{} : {}", quoted_name(output.variable.name), to_string(output.variable.domain)),
             described(output.role, output.variable.comment));
  if (!spec.memories.empty()) out.heading("memory (follows from what happens)");
  for (const Memory& memory : spec.memories) list_memory(out, memory);
  if (!spec.definitions.empty()) out.heading("definitions (true exactly when)");
  for (const Definition& definition : spec.definitions)
    out.line(fmt::format("{} := {}", quoted_name(definition.name), logic::to_string(definition.formula)),
             from(described(definition.role, definition.comment), definition.axioms));
}

void list_part(Listing& out, std::string_view heading, const std::vector<Clause>& clauses) {
  if (!clauses.empty()) out.heading(heading);
  for (const Clause& clause : clauses)
    out.line(logic::to_string(clause.formula), from(to_string(clause.origin), clause.axioms));
}

}  // namespace

std::string listing(const Gr1& spec) {
  Listing out;
  out.heading(fmt::format("specification {}({}, initial {})", spec.name.empty() ? "" : spec.name + " ",
                          to_string(spec.timing), to_string(spec.initial)));
  list_declarations(out, spec);
  list_part(out, "the environment starts with", spec.env_init);
  list_part(out, "the environment always keeps", spec.env_safety);
  list_part(out, "the environment does infinitely often", spec.env_justice);
  list_part(out, "the system starts with", spec.sys_init);
  list_part(out, "the system always keeps", spec.sys_safety);
  list_part(out, "the system does infinitely often", spec.sys_justice);
  return out.take();
}

}  // namespace heed::spec
