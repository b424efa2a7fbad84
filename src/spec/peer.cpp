#include "peer.h"

#include <heed/util/diagnostic.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace heed::spec {
namespace {

using logic::Formula;
using logic::Op;

constexpr std::array<SlugsSection, 8> slugs_sections{
    {{"INPUT", nullptr, true, false, false},
     {"OUTPUT", nullptr, false, false, false},
     {"ENV_INIT", &Gr1::env_init, false, false, false},
     {"SYS_INIT", &Gr1::sys_init, false, false, false},
     {"ENV_TRANS", &Gr1::env_safety, false, true, false},
     {"SYS_TRANS", &Gr1::sys_safety, false, true, false},
     {"ENV_LIVENESS", &Gr1::env_justice, false, false, true},
     {"SYS_LIVENESS", &Gr1::sys_justice, false, false, true}}};

void add_clause(Gr1& spec, const util::SourceText& source, const SlugsSection& section, const Read& read,
                std::size_t end) {
  if (read.formula.is_true() && !section.justice) return;
  Clause clause;
  clause.formula =
      section.step && !read.primed ? on_steps(read.formula, source.at(read.begin)) : read.formula;
  clause.text = source.text().substr(read.begin, end - read.begin);
  (spec.*section.clauses).push_back(std::move(clause));
}

}  // namespace

void for_each_line(const util::SourceText& source,
                   const std::function<void(std::size_t begin, std::size_t end)>& visit) {
  const std::string& text = source.text();
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t stop = std::min(text.find('\n', begin), text.size());
    std::size_t end = stop;
    while (begin < end && is_blank(text[begin])) ++begin;
    while (end > begin && is_blank(text[end - 1])) --end;
    if (begin < end && text[begin] != '#') visit(begin, end);
    begin = stop + 1;
  }
}

void add_variable(Gr1& spec, bool input, model::Variable variable) {
  if (input)
    spec.inputs.push_back(std::move(variable));
  else
    spec.outputs.push_back({std::move(variable), model::OutputRole::Output});
}

void add_clauses(Gr1& spec, const util::SourceText& source, const SlugsSection& section, const Read& line,
                 std::size_t end, const std::vector<std::pair<Read, std::size_t>>& conjuncts) {
  if (section.justice || conjuncts.empty()) return add_clause(spec, source, section, line, end);
  for (const auto& [read, stop] : conjuncts) add_clause(spec, source, section, read, stop);
}

const SlugsSection* find_section(const util::SourceText& source, std::size_t offset, std::string_view line) {
  std::vector<std::string> known;
  for (const SlugsSection& section : slugs_sections) {
    known.push_back(fmt::format("[{}]", section.word));
    if (known.back() == line) return &section;
  }
  throw util::InputError(source, offset, "unknown-section", fmt::format("unknown section '{}'", line),
                         util::suggestion(line, known));
}

void check_place(const util::SourceText& source, std::size_t offset, const SlugsSection& section,
                 std::string_view name, bool input, bool primed) {
  const auto refuse = [&](const char* why) {
    throw util::InputError(source, offset, "not-allowed-here",
                           fmt::format("'{}' may not stand in [{}]", name, section.word), why);
  };
  if (section.word == "ENV_INIT" && !input) refuse("the environment's start speaks of inputs only");
  if (primed && section.word.ends_with("_INIT")) refuse("a start has no next values");
  if (primed && !input && section.word == "ENV_TRANS")
    refuse("the environment moves before the system answers");
}

Formula on_steps(const Formula& formula, util::Location location) {
  return Formula::make(Op::And, {formula, Formula::make(Op::Next, {Formula()})}, std::move(location));
}

Formula joined_flat(Op op, std::vector<Formula> parts) {
  const Op unit = op == Op::And ? Op::True : Op::False;
  const Op zero = op == Op::And ? Op::False : Op::True;
  std::erase_if(parts, [unit](const Formula& part) { return part.op() == unit; });
  for (const Formula& part : parts)
    if (part.op() == zero) return part;
  if (parts.empty()) return logic::truth(op == Op::And);
  if (parts.size() == 1) return parts[0];
  return Formula::make(op, std::move(parts));
}

void check_size(const util::SourceText& source, const util::Limits& limits) {
  if (limits.input_bytes != 0 && source.text().size() > limits.input_bytes)
    throw util::InputError(source, 0, "too-large", "the file is larger than the limit");
}

std::string stem_of(const std::string& path) {
  const std::size_t slash = path.find_last_of('/');
  const std::size_t begin = slash == std::string::npos ? 0 : slash + 1;
  const std::size_t dot = path.find_last_of('.');
  return path.substr(begin, dot == std::string::npos || dot <= begin ? std::string::npos : dot - begin);
}

}  // namespace heed::spec
