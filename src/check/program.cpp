#include "program.h"

#include <heed/logic/nodes.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>

namespace heed::check {

using logic::Formula;
using logic::Op;
using Code = Program::Code;

Layout::Layout(const spec::Gr1& spec) : symbols_(spec) {
  for (const auto& input : spec.inputs) add(input);
  outputs_begin_ = size_;
  for (const auto& output : spec.outputs) add(output.variable);
  memories_begin_ = size_;
  for (const auto& memory : spec.memories) add(memory.variable);
  definitions_begin_ = size_;
  for (const auto& definition : spec.definitions) add({definition.name, model::Domain::boolean(), {}});
}

void Layout::add(const model::Variable& variable) {
  slots_.emplace(variable.name, size_++);
  bits_.push_back(variable.domain.low == 0 && variable.domain.high == 1);
}

namespace {

/// What \p in puts into its register.
inline std::int64_t value_of(const Program::Instruction& in, Values values, const std::int64_t* registers) {
  const auto a = [&] { return registers[in.a]; };
  const auto b = [&] { return registers[in.b]; };
  // Two's complement wrap-around: overflow has no meaning in a specification, and none here.
  const auto word = [](std::int64_t value) { return static_cast<std::uint64_t>(value); };
  switch (in.code) {
    case Code::Constant:
      return in.constant;
    case Code::Load:
      return values.step[in.a];
    case Code::Kept:
      return values.kept[in.a];
    case Code::Not:
      return a() == 0 ? 1 : 0;
    case Code::And:
      return (a() != 0 && b() != 0) ? 1 : 0;
    case Code::Or:
      return (a() != 0 || b() != 0) ? 1 : 0;
    case Code::Implies:
      return (a() == 0 || b() != 0) ? 1 : 0;
    case Code::Iff:
      return ((a() != 0) == (b() != 0)) ? 1 : 0;
    case Code::Eq:
      return a() == b() ? 1 : 0;
    case Code::Ne:
      return a() != b() ? 1 : 0;
    case Code::Lt:
      return a() < b() ? 1 : 0;
    case Code::Le:
      return a() <= b() ? 1 : 0;
    case Code::Gt:
      return a() > b() ? 1 : 0;
    case Code::Ge:
      return a() >= b() ? 1 : 0;
    case Code::Add:
      return static_cast<std::int64_t>(word(a()) + word(b()));
    case Code::Sub:
      return static_cast<std::int64_t>(word(a()) - word(b()));
    case Code::Mul:
      return static_cast<std::int64_t>(word(a()) * word(b()));
  }
  return 0;
}

std::int64_t apply(Code code, std::int64_t a, std::int64_t b) {
  const std::array<std::int64_t, 2> operands{a, b};
  return value_of({code, 0, 1}, {nullptr}, operands.data());
}

Code code_of(Op op) {
  switch (op) {
    case Op::Not:
      return Code::Not;
    case Op::And:
      return Code::And;
    case Op::Or:
      return Code::Or;
    case Op::Implies:
      return Code::Implies;
    case Op::Iff:
      return Code::Iff;
    case Op::Eq:
      return Code::Eq;
    case Op::Ne:
      return Code::Ne;
    case Op::Lt:
      return Code::Lt;
    case Op::Le:
      return Code::Le;
    case Op::Gt:
      return Code::Gt;
    case Op::Ge:
      return Code::Ge;
    case Op::Add:
      return Code::Add;
    case Op::Sub:
      return Code::Sub;
    default:
      return Code::Mul;
  }
}

}  // namespace

std::uint32_t Program::emit(Instruction instruction) {
  if (instruction.code == Code::Load) {
    const auto at = std::lower_bound(loads_.begin(), loads_.end(), instruction.a);
    if (at == loads_.end() || *at != instruction.a) loads_.insert(at, instruction.a);
  }
  reads_kept_ = reads_kept_ || instruction.code == Code::Kept;
  code_.push_back(instruction);
  return static_cast<std::uint32_t>(code_.size() - 1);
}

std::int64_t Program::run(std::span<const Instruction> code, Values values,
                          std::vector<std::int64_t>& registers) {
  std::int64_t* next = registers.data();
  for (const Instruction& in : code) *next++ = value_of(in, values, registers.data());
  return next[-1];
}

std::optional<Program::Table> Program::Table::of(std::span<const Instruction> code, const Layout& layout,
                                                 std::vector<std::uint64_t>& words) {
  Table table;
  words.clear();
  for (const Instruction& in : code) {
    const std::optional<std::uint64_t> word = table.word(in, layout, words);
    if (!word) return std::nullopt;
    words.push_back(*word);
  }
  table.rows_ = words.back();
  return table;
}

std::optional<std::uint64_t> Program::Table::word(const Instruction& in, const Layout& layout,
                                                  const std::vector<std::uint64_t>& words) {
  switch (in.code) {
    case Code::Constant:
      if (in.constant != 0 && in.constant != 1) return std::nullopt;
      return in.constant == 0 ? 0 : ~std::uint64_t{0};
    case Code::Load:
      return layout.is_bit(in.a) ? load(in.a) : std::nullopt;
    case Code::Not:
      return ~words[in.a];
    case Code::And:
      return words[in.a] & words[in.b];
    case Code::Or:
      return words[in.a] | words[in.b];
    case Code::Implies:
      return ~words[in.a] | words[in.b];
    case Code::Iff:
    case Code::Eq:
      return ~(words[in.a] ^ words[in.b]);
    case Code::Ne:
      return words[in.a] ^ words[in.b];
    default:
      return std::nullopt;
  }
}

/// Bit i of a row's number is the value of the i-th slot there.
std::optional<std::uint64_t> Program::Table::load(std::uint32_t slot) {
  constexpr std::array<std::uint64_t, most> rows{0xaaaaaaaaaaaaaaaa, 0xcccccccccccccccc, 0xf0f0f0f0f0f0f0f0,
                                                 0xff00ff00ff00ff00, 0xffff0000ffff0000, 0xffffffff00000000};
  std::uint32_t i = 0;
  while (i < count_ && slots_[i] != slot) ++i;
  if (i == most) return std::nullopt;
  if (i == count_) slots_[count_++] = slot;
  return rows[i];
}

void Program::tabulate(const Layout& layout) {
  std::vector<std::uint64_t> words;
  table_ = Table::of(code_, layout, words);
}

void Foresight::append(const Program& program, const std::int64_t* kept,
                       std::vector<Program::Instruction>& out) {
  registers_.resize(program.size());
  for (std::uint32_t i = 0; i < registers_.size(); ++i) evaluate(i, program.code()[i], kept);
  registers_[source(static_cast<std::uint32_t>(registers_.size() - 1))].needed = true;
  for (std::size_t i = registers_.size(); i-- > 0;) {
    const Register& at = registers_[i];
    if (!at.needed || at.known || at.now.code == Code::Load) continue;
    registers_[at.now.a].needed = registers_[at.now.b].needed = true;
  }
  std::uint32_t next = 0;
  for (Register& at : registers_) {
    if (!at.needed) continue;
    at.place = next++;
    if (at.known)
      out.push_back({Code::Constant, 0, 0, at.value});
    else if (at.now.code == Code::Load)
      out.push_back(at.now);
    else
      out.push_back({at.now.code, registers_[at.now.a].place, registers_[at.now.b].place});
  }
}

void Foresight::evaluate(std::uint32_t i, const Program::Instruction& in, const std::int64_t* kept) {
  Register& here = registers_[i];
  here.known = here.needed = false;
  here.same = i;
  here.now = in;
  if (in.code == Code::Constant) return here.be_known(in.constant);
  if (in.code == Code::Kept) return here.be_known(kept[in.a]);
  if (in.code == Code::Load) return;
  const Register &a = registers_[in.a], &b = registers_[in.b];
  if (a.known && b.known) return here.be_known(apply(in.code, a.value, b.value));
  here.now = {in.code, source(in.a), source(in.b)};
  if (a.known || b.known) connect(here, a, b);
}

/// An operation with one operand that depends on the step.
void Foresight::connect(Register& here, const Register& a, const Register& b) {
  const bool truth = (a.known ? a.value : b.value) != 0;
  const std::uint32_t open = a.known ? here.now.b : here.now.a;
  const auto be_negated = [&] { here.now = {Code::Not, open, open}; };
  switch (here.now.code) {
    case Code::And:
      return truth ? void(here.same = open) : here.be_known(0);
    case Code::Or:
      return truth ? here.be_known(1) : void(here.same = open);
    case Code::Implies:
      if (truth != a.known) return here.be_known(1);
      return a.known ? void(here.same = open) : be_negated();
    case Code::Iff:
      return truth ? void(here.same = open) : be_negated();
    default:
      return;
  }
}

std::uint32_t Kept::index(const Formula& term) {
  const auto [at, fresh] = terms_.emplace(term, static_cast<std::uint32_t>(entries_.size()));
  if (fresh) entries_.push_back({{}, term});
  return at->second;
}

std::uint32_t Kept::index_of_cases(std::vector<std::pair<Formula, std::int32_t>> cases,
                                   const Formula& otherwise) {
  entries_.push_back({std::move(cases), otherwise});
  return static_cast<std::uint32_t>(entries_.size() - 1);
}

namespace {

/// Emits code bottom up for those (node, step) pairs that the root needs: a node is read in the present step,
/// where parts without Next are kept values, or in the coming one.
class Compiler {
 public:
  Compiler(const Formula& root, const Layout& layout, Kept* kept)
      : order_(root), layout_(layout), kept_(kept), nodes_(order_.size()) {}

  Program run() {
    (kept_ ? nodes_.back().present : nodes_.back().coming) = true;
    for (std::size_t i = nodes_.size(); i-- > 0;) spread(i);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (nodes_[i].coming) nodes_[i].coming_register = node(i, true);
      if (nodes_[i].present)
        nodes_[i].present_register = order_[i].op() == Op::Next ? operand(i, 0, true) : node(i, false);
    }
    finish();
    program_.tabulate(layout_);
    return std::move(program_);
  }

 private:
  struct Node {
    bool present = false, coming = false;
    std::uint32_t present_register = 0, coming_register = 0;
  };

  [[nodiscard]] bool is_comparison(std::size_t i) const {
    return order_[i].op() >= Op::Eq && order_[i].op() <= Op::Ge;
  }

  [[nodiscard]] std::optional<std::int32_t> value(std::size_t i, std::size_t k) const {
    return is_comparison(i) ? spec::enumeration_value(order_[i], k, layout_.symbols()) : std::nullopt;
  }

  void spread(std::size_t i) {
    const Node& from = nodes_[i];
    for (std::size_t k = 0; k < order_[i].operands().size(); ++k) {
      if (value(i, k)) continue;
      Node& to = nodes_[order_.operands(i)[k]];
      const bool step = order_[i].op() == Op::Next;
      if (from.coming || (from.present && step)) to.coming = true;
      if (from.present && order_[i].has_next() && !step) to.present = true;
    }
  }

  std::uint32_t operand(std::size_t i, std::size_t k, bool coming) {
    if (const auto code = value(i, k)) return program_.emit({Code::Constant, 0, 0, *code});
    const Node& at = nodes_[order_.operands(i)[k]];
    return coming ? at.coming_register : at.present_register;
  }

  std::uint32_t node(std::size_t i, bool coming) {
    const Formula& formula = order_[i];
    switch (formula.op()) {
      case Op::True:
        return program_.emit({Code::Constant, 0, 0, 1});
      case Op::False:
        return program_.emit({Code::Constant, 0, 0, 0});
      case Op::Number:
        return program_.emit({Code::Constant, 0, 0, formula.number()});
      default:
        break;
    }
    if (!coming && !formula.has_next()) return program_.emit({Code::Kept, kept_->index(formula)});
    if (formula.op() == Op::Name) return program_.emit({Code::Load, layout_.slot(formula.name())});
    assert(formula.op() < Op::Next);
    const Code code = code_of(formula.op());
    std::uint32_t result = operand(i, 0, coming);
    if (formula.op() == Op::Not) return program_.emit({code, result, result});
    for (std::size_t k = 1; k < formula.operands().size(); ++k) {
      const std::uint32_t right = operand(i, k, coming);
      result = program_.emit({code, result, right});
    }
    return result;
  }

  /// The last instruction has to be the result.
  void finish() {
    const std::uint32_t result = kept_ ? nodes_.back().present_register : nodes_.back().coming_register;
    if (result + 1 == program_.size()) return;
    const std::uint32_t zero = program_.emit({Code::Constant, 0, 0, 0});
    program_.emit({Code::Add, result, zero});
  }

  logic::Nodes order_;
  const Layout& layout_;
  Kept* kept_;
  std::vector<Node> nodes_;
  Program program_;
};

}  // namespace

Program compile_present(const Formula& formula, const Layout& layout) {
  return Compiler(formula, layout, nullptr).run();
}

Program compile_step(const Formula& formula, const Layout& layout, Kept& kept) {
  return Compiler(formula, layout, &kept).run();
}

}  // namespace heed::check
