#include "explore.h"

#include <heed/util/diagnostic.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace heed::check {

using Kind = Refutation::Kind;

Explorer::Explorer(const model::Mealy& machine, const Rules& rules, util::Budget& budget,
                   const Options& options)
    : machine_(machine),
      rules_(rules),
      budget_(budget),
      options_(options),
      letters_(machine, rules.spec),
      legal_(rules, letters_, budget),
      kept_(2 * std::max<std::size_t>(1, rules.kept_programs.size())),
      outlooks_(rules),
      before_(kept_.length() / 2),
      registers_(rules.registers + 1) {
  check_machine();
  map_columns();
  product_.words = (rules.env_justices + rules.sys_justices + 63) / 64;
  step_marks_.resize(product_.words);
}

void Explorer::map_columns() {
  const auto wanted = spec::controller_outputs(rules_.spec);
  std::vector<std::uint32_t> places;
  for (const model::Output& output : wanted) {
    std::uint32_t column = 0;
    while (column < machine_.outputs.size() && machine_.outputs[column].variable.name != output.variable.name)
      ++column;
    if (column == machine_.outputs.size() ||
        machine_.outputs[column].variable.domain != output.variable.domain)
      throw util::InputError(output.variable.location, "columns",
                             fmt::format("the controller has no column '{}' as the specification declares it",
                                         output.variable.name));
    places.push_back(column);
  }
  if (machine_.outputs.size() != wanted.size())
    throw util::InputError({}, "columns", "the controller has columns that the specification does not have");
  width_ = places.size();
  for (const auto& letter : machine_.output_letters)
    for (const std::uint32_t place : places) columns_.push_back(letter[place]);
}

void Explorer::check_machine() const {
  const auto broken = [](const char* what) {
    throw util::InputError({}, "controller", fmt::format("the controller is broken: {}", what));
  };
  if (machine_.state_count() == 0) broken("it has no state");
  for (const auto& row : machine_.transitions)
    if (row.input >= machine_.input_letters.size() || row.output >= machine_.output_letters.size() ||
        row.next >= machine_.state_count())
      broken("a row refers to nothing");
  for (const auto& letter : machine_.output_letters) {
    if (letter.size() != machine_.outputs.size()) broken("an output letter has the wrong length");
    for (std::size_t i = 0; i < letter.size(); ++i)
      if (letter[i] < machine_.outputs[i].variable.domain.low ||
          letter[i] > machine_.outputs[i].variable.domain.high)
        broken("an output letter has a value outside its type");
  }
}

bool Explorer::holds(const Program& program, const std::int32_t* values) const {
  return program.run({values}, registers_) != 0;
}

void Explorer::recall(std::uint32_t kept) {
  const auto halves = kept_[kept];
  for (std::size_t i = 0; i < before_.size(); ++i)
    before_[i] = static_cast<std::int64_t>(halves[2 * i] | std::uint64_t{halves[2 * i + 1]} << 32U);
}

TraceStep Explorer::step(std::uint32_t row) const {
  const auto& transition = machine_.transitions[row];
  return {machine_.input_letters[transition.input], machine_.output_letters[transition.output]};
}

std::vector<TraceStep> Explorer::trace(std::uint32_t node) const {
  std::vector<TraceStep> out;
  for (; node != 0; node = product_.nodes[node].parent) out.push_back(step(product_.nodes[node].row));
  std::reverse(out.begin(), out.end());
  return out;
}

bool Explorer::refuse(Refutation refutation, std::uint32_t node, const TraceStep& last) {
  refutation.trace = trace(node);
  refutation.trace.push_back(last);
  verdict_->refutations.push_back(std::move(refutation));
  refused_start_ = refused_start_ || node == 0;
  return verdict_->refutations.size() < options_.most;
}

bool Explorer::missing(std::uint32_t node, const std::int32_t* values) {
  if (node == 0 && rules_.spec.initial == spec::InitialQuantifiers::ExistsExists) return true;
  return refuse({Kind::MissingInput,
                 "every legal input has an answer",
                 "the controller has no row for a legal input",
                 {},
                 0},
                node, {letters_.valuation(values), {}});
}

void Explorer::run(Verdict& verdict) {
  verdict_ = &verdict;
  product_.nodes.push_back({0, none, none, none});
  places_.number(std::array{0U, none});
  product_.first.push_back(0);
  for (std::uint32_t node = 0; node < product_.nodes.size() && verdict.refutations.size() < options_.most;
       ++node) {
    expand(node);
    product_.first.push_back(product_.edges.size());
  }
  verdict.product_states = product_.nodes.size();
}

void Explorer::expand(std::uint32_t node) {
  Common common;
  common.start = node == 0;
  const auto initial = rules_.spec.initial;
  common.fixed = common.start ? initial == spec::InitialQuantifiers::ExistsForall
                              : rules_.spec.timing == spec::Timing::Moore;
  bool any = false;
  const std::uint32_t kept = product_.nodes[node].kept;
  if (!common.start) recall(kept);
  outlook_ = common.start ? &outlooks_.first() : &outlooks_.after(kept, before_.data());
  previous_edge_.clear();
  next_row_ = machine_.first[product_.nodes[node].state];
  legal_.each(common.start ? nullptr : before_.data(), *outlook_,
              [&](std::int32_t* values, std::uint32_t letter) {
                any = any || !common.start || can_start(values);
                return take(node, letter, values, common);
              });
  if (common.start && any && !answered_start_ && verdict_->refutations.empty())
    refuse({Kind::Initial,
            "some legal first input has an answer",
            "the controller answers no legal first input",
            {},
            0},
           node, {});
}

/// Some choice of initial states keeps the assumptions that speak of them: else the first input is not legal.
bool Explorer::can_start(const std::int32_t* values) const {
  if (rules_.first.start.empty()) return true;
  std::vector<std::int32_t> tried(values, values + rules_.layout.size());
  std::vector<std::size_t> choice(rules_.spec.memories.size());
  for (std::size_t at = 0; at < choice.size();) {
    for (std::uint32_t i = 0; i < choice.size(); ++i)
      tried[rules_.layout.memory(i)] = rules_.spec.memories[i].initial[choice[i]];
    for (std::uint32_t i = 0; i < rules_.definitions.size(); ++i)
      tried[rules_.layout.definition(i)] =
          static_cast<std::int32_t>(rules_.definitions[i].run({tried.data()}, registers_));
    if (std::all_of(rules_.first.start.begin(), rules_.first.start.end(),
                    [&](const Rule& rule) { return holds(rule.program, tried.data()); }))
      return true;
    for (at = 0; at < choice.size() && ++choice[at] == rules_.spec.memories[at].initial.size(); ++at)
      choice[at] = 0;
  }
  return false;
}

bool Explorer::take(std::uint32_t node, std::uint32_t letter, std::int32_t* values, Common& common) {
  if (common.start && !can_start(values)) return true;
  ++verdict_->product_edges;
  if ((verdict_->product_edges & 0xff) == 0) budget_.check();
  if (letter == LetterIndex::unknown) return missing(node, values);
  const std::uint32_t row = row_of(product_.nodes[node].state, letter);
  if (row == none) return missing(node, values);
  answered_start_ = true;
  return answer({node, row}, values, common);
}

/// The machine's row, or none. Letters mostly come in the order of the rows.
std::uint32_t Explorer::row_of(std::uint32_t state, std::uint32_t letter) {
  if (next_row_ == machine_.first[state + 1] || machine_.transitions[next_row_].input != letter) {
    const auto* found = machine_.find(state, letter);
    if (!found) return none;
    next_row_ = static_cast<std::uint32_t>(found - machine_.transitions.data());
  }
  return next_row_++;
}

bool Explorer::answer(Answer at, std::int32_t* values, Common& common) {
  if (!(common.start ? starts_well(at, values) : memories_agree(at, values)))
    return verdict_->refutations.size() < options_.most;
  if (common.fixed && !shares(at, common)) return verdict_->refutations.size() < options_.most;
  std::copy_n(columns(at.row), width_, values + rules_.layout.inputs());
  const RowFacts& row = facts(at.row, values);
  if (row.violated && row.wrong_column) return refuse_row(at, row);
  if (common.start)
    for (const Rule& rule : rules_.sys_init)
      if (!holds(rule.program, values))
        return refuse({Kind::Initial,
                       rule.clause->text,
                       "the first step breaks a guarantee on how the system starts",
                       {},
                       0},
                      at.node, step(at.row));
  if (common.start)
    for (const Rule& rule : rules_.first.start)
      if (!holds(rule.program, values))
        return refuse(
            {Kind::Initial, rule.clause->text, "the chosen initial state makes an assumption fail", {}, 0},
            at.node, step(at.row));
  if (row.violated) return refuse_row(at, row);
  if (common.start && start_broken(values)) return true;
  if (!common.start && !keeps_step(at, row, values)) return verdict_->refutations.size() < options_.most;
  if (!row.environment_broken) connect(at, row, values);
  return true;
}

bool Explorer::refuse_row(Answer at, const RowFacts& row) {
  const char* message = row.wrong_column ? "a derived column is not what its definition says"
                                         : "a guarantee that holds at every step is broken";
  return refuse({row.wrong_column ? Kind::WrongColumn : Kind::Safety, *row.violated, message, {}, 0}, at.node,
                step(at.row));
}

bool Explorer::starts_well(Answer at, const std::int32_t*) {
  for (std::uint32_t i = 0; i < rules_.spec.memories.size(); ++i) {
    const spec::Memory& memory = rules_.spec.memories[i];
    const std::int32_t code = column(at.row, rules_.layout.memory(i));
    if (std::find(memory.initial.begin(), memory.initial.end(), code) != memory.initial.end()) continue;
    refuse({memory.role == model::OutputRole::Plant ? Kind::Initial : Kind::WrongColumn,
            memory.variable.name,
            fmt::format("'{}' starts with {}, which is no initial value", memory.variable.name,
                        memory.variable.domain.print(code)),
            {},
            0},
           at.node, step(at.row));
    return false;
  }
  return true;
}

bool Explorer::memories_agree(Answer at, const std::int32_t* values) {
  if (rules_.spec.memories.empty()) return true;
  for (std::uint32_t i = 0; i < rules_.spec.memories.size(); ++i) {
    const std::uint32_t slot = rules_.layout.memory(i);
    if (column(at.row, slot) == values[slot]) continue;
    const model::Variable& variable = rules_.spec.memories[i].variable;
    refuse({Kind::WrongColumn,
            variable.name,
            fmt::format("'{}' should be {} and is {}", variable.name, variable.domain.print(values[slot]),
                        variable.domain.print(column(at.row, slot))),
            {},
            0},
           at.node, step(at.row));
    return false;
  }
  return true;
}

bool Explorer::shares(Answer at, Common& common) {
  if (common.row == none) common.row = at.row;
  const auto differs = [&](std::uint32_t slot) { return column(at.row, slot) != column(common.row, slot); };
  bool same = true;
  for (std::uint32_t i = 0; i < rules_.spec.outputs.size(); ++i)
    same = same && !differs(rules_.layout.output(i));
  for (std::uint32_t i = 0; i < rules_.spec.memories.size() && common.start; ++i)
    same = same && !differs(rules_.layout.memory(i));
  if (!same)
    refuse({common.start ? Kind::Initial : Kind::Safety,
            common.start ? "initial exists-forall" : "timing moore",
            common.start ? "the first answer depends on the first input"
                         : "the answer depends on the input of the same step",
            {},
            0},
           at.node, step(at.row));
  return same;
}

bool Explorer::keeps_step(Answer at, const RowFacts& row, const std::int32_t* values) {
  const std::string* broken = row.violated_after_start;
  const auto& open = outlook_->guarantees();
  for (std::size_t i = 0; i < open.size() && !broken; ++i)
    if (!outlook_->holds(open[i], values, registers_))
      broken = &rules_.sys_step[outlook_->open_guarantees()[i]].clause->text;
  if (broken)
    refuse({Kind::Safety, *broken, "a guarantee on the step is broken", {}, 0}, at.node, step(at.row));
  return !broken;
}

bool Explorer::start_broken(const std::int32_t* values) {
  return std::any_of(rules_.first.after.begin(), rules_.first.after.end(),
                     [&](const Rule& rule) { return !holds(rule.program, values); });
}

const Explorer::RowFacts& Explorer::facts(std::uint32_t row, const std::int32_t* values) {
  const auto& transition = machine_.transitions[row];
  const auto [number, fresh] = pairs_.number(std::array{transition.input, transition.output});
  if (!fresh) return facts_[number];
  RowFacts& out = facts_.emplace_back();
  for (std::uint32_t i = 0; i < rules_.definitions.size() && !out.violated; ++i)
    if (rules_.definitions[i].run({values}, registers_) != values[rules_.layout.definition(i)]) {
      out.violated = &rules_.spec.definitions[i].name;
      out.wrong_column = true;
    }
  for (const Rule& rule : rules_.sys_present)
    if (!out.violated && !holds(rule.program, values)) out.violated = &rule.clause->text;
  for (const Rule& rule : rules_.sys_coming)
    if (!out.violated_after_start && !holds(rule.program, values))
      out.violated_after_start = &rule.clause->text;
  for (const Rule& rule : rules_.later.after)
    out.environment_broken = out.environment_broken || !holds(rule.program, values);
  out.marks = static_cast<std::uint32_t>(row_marks_.size());
  row_marks_.resize(row_marks_.size() + product_.words);
  for (std::size_t j = 0; j < rules_.justice_present.size(); ++j)
    if (rules_.justice_present[j] && holds(*rules_.justice_present[j], values))
      row_marks_[out.marks + j / 64] |= std::uint64_t{1} << (j % 64);
  out.kept = intern_kept(values);
  return out;
}

std::uint32_t Explorer::intern_kept(const std::int32_t* values) {
  halves_.clear();
  for (const auto& program : rules_.kept_programs) {
    const auto hit = std::find_if(program.cases.begin(), program.cases.end(),
                                  [&](const auto& c) { return holds(c.first, values); });
    const auto value = static_cast<std::uint64_t>(
        hit != program.cases.end() ? hit->second : program.term.run({values}, registers_));
    halves_.push_back(static_cast<std::uint32_t>(value));
    halves_.push_back(static_cast<std::uint32_t>(value >> 32U));
  }
  halves_.resize(kept_.length());
  return kept_.number(std::span<const std::uint32_t>(halves_)).first;
}

void Explorer::connect(Answer at, const RowFacts& row, const std::int32_t* values) {
  const std::uint32_t state = machine_.transitions[at.row].next;
  const auto [target, fresh] = places_.number(std::array{state, row.kept});
  if (fresh) product_.nodes.push_back({state, row.kept, at.node, at.row});
  if (rules_.sys_justices == 0) return;
  for (std::size_t w = 0; w < product_.words; ++w) step_marks_[w] = row_marks_[row.marks + w];
  for (std::size_t i = 0; at.node != 0 && i < rules_.step_justices.size(); ++i) {
    const std::uint32_t j = rules_.step_justices[i];
    if (outlook_->holds(outlook_->justices()[i], values, registers_))
      step_marks_[j / 64] |= std::uint64_t{1} << (j % 64);
  }
  if (last_edge_.size() <= target) last_edge_.resize(product_.nodes.size());
  if (has_edge(target)) return;
  product_.edges.push_back({target, at.row});
  for (const std::uint64_t word : step_marks_) product_.marks.push_back(word);
  previous_edge_.push_back(last_edge_[target]);
  last_edge_[target] = product_.edges.size();
}

/// An edge from the expanded node with these justices: letters that do the same are one edge. Not all are
/// looked at, so that letters stay linear: one that is there twice does no harm.
bool Explorer::has_edge(std::uint32_t target) const {
  constexpr int most = 32;
  const std::size_t first = product_.first.back(), words = product_.words;
  std::size_t edge = last_edge_[target];
  for (int looked = 0; edge > first && looked < most; ++looked, edge = previous_edge_[edge - 1 - first]) {
    std::size_t same = 0;
    while (same < words && step_marks_[same] == product_.marks[(edge - 1) * words + same]) ++same;
    if (same == words) return true;
  }
  return false;
}

}  // namespace heed::check
