#pragma once

#include <heed/logic/formula.h>
#include <heed/spec/gr1.h>
#include <heed/spec/symbols.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace heed::check {

/// Where the variables of one step stand in an array of values: inputs first, then outputs, memories,
/// definitions.
class Layout {
 public:
  explicit Layout(const spec::Gr1& spec);
  [[nodiscard]] std::uint32_t slot(const std::string& name) const { return slots_.at(name); }
  [[nodiscard]] const spec::Symbols& symbols() const { return symbols_; }
  [[nodiscard]] std::uint32_t inputs() const { return outputs_begin_; }
  [[nodiscard]] std::uint32_t output(std::uint32_t i) const { return outputs_begin_ + i; }
  [[nodiscard]] std::uint32_t memory(std::uint32_t i) const { return memories_begin_ + i; }
  [[nodiscard]] std::uint32_t definition(std::uint32_t i) const { return definitions_begin_ + i; }
  [[nodiscard]] std::uint32_t size() const { return size_; }
  /// Whether its values are 0 and 1.
  [[nodiscard]] bool is_bit(std::uint32_t slot) const { return bits_[slot]; }

 private:
  void add(const model::Variable& variable);

  spec::Symbols symbols_;
  std::unordered_map<std::string, std::uint32_t> slots_;
  std::uint32_t outputs_begin_, memories_begin_, definitions_begin_, size_ = 0;
  std::vector<bool> bits_;
};

/// What a formula is evaluated over: the values of a step, and what was kept of the step before it.
struct Values {
  const std::int32_t* step;
  const std::int64_t* kept = nullptr;
};

/// A formula as straight-line code: one register per distinct node, so that shared parts are computed once
/// and no depth of nesting matters.
class Program {
 public:
  enum class Code : std::uint8_t {
    Constant,
    Load,
    Kept,
    Not,
    And,
    Or,
    Implies,
    Iff,
    Eq,
    Ne,
    Lt,
    Le,
    Gt,
    Ge,
    Add,
    Sub,
    Mul
  };
  struct Instruction {
    Code code;
    std::uint32_t a = 0, b = 0;  ///< Registers; the slot of Load and Kept.
    std::int64_t constant = 0;
  };

  /// What code over few bits of the step comes to: much of what is left of a rule is such code, and is looked
  /// up rather than run.
  class Table {
   public:
    /// Bits that it may read.
    static constexpr std::size_t most = 6;
    /// The table of \p code: all its rows at once, a bit of a word each. Nothing where it reads more than
    /// \ref most slots, or does anything but connect bits. \param words  Scratch.
    [[nodiscard]] static std::optional<Table> of(std::span<const Instruction> code, const Layout& layout,
                                                 std::vector<std::uint64_t>& words);
    [[nodiscard]] bool at(const std::int32_t* step) const {
      unsigned row = 0;
      for (std::uint32_t i = 0; i < count_; ++i) row |= static_cast<unsigned>(step[slots_[i]] != 0) << i;
      return ((rows_ >> row) & 1U) != 0;
    }
    /// Whether it has this value in every row.
    [[nodiscard]] bool is(bool truth) const { return rows_ == (truth ? ~std::uint64_t{0} : 0); }

   private:
    [[nodiscard]] std::optional<std::uint64_t> word(const Instruction& in, const Layout& layout,
                                                    const std::vector<std::uint64_t>& words);
    [[nodiscard]] std::optional<std::uint64_t> load(std::uint32_t slot);

    std::array<std::uint32_t, most> slots_{};
    std::uint32_t count_ = 0;
    std::uint64_t rows_ = 0;
  };

  /// The value of the last of \p code, which is not empty. \param registers  Scratch, one for each.
  [[nodiscard]] static std::int64_t run(std::span<const Instruction> code, Values values,
                                        std::vector<std::int64_t>& registers);
  [[nodiscard]] std::int64_t run(Values values, std::vector<std::int64_t>& registers) const {
    return table_ ? std::int64_t{table_->at(values.step)} : run(code_, values, registers);
  }

  [[nodiscard]] const std::vector<Instruction>& code() const { return code_; }
  [[nodiscard]] std::size_t size() const { return code_.size(); }
  /// Slots of the step that it reads, ascending.
  [[nodiscard]] const std::vector<std::uint32_t>& loads() const { return loads_; }
  [[nodiscard]] bool reads_kept() const { return reads_kept_; }

  std::uint32_t emit(Instruction instruction);
  /// To be called once all is emitted.
  void tabulate(const Layout& layout);

 private:
  std::vector<Instruction> code_;
  std::optional<Table> table_;
  std::vector<std::uint32_t> loads_;
  bool reads_kept_ = false;
};

/// Evaluates programs as far as what was kept of the step before goes.
class Foresight {
 public:
  explicit Foresight(const Layout& layout) : layout_(layout) {}
  /// Appends to \p out code that has the value of \p program for these \p kept values, whatever the step is,
  /// and reads the step alone. A value that does not depend on the step is one Constant. Linear in the size
  /// of the program. \pre connectives have Boolean operands
  void append(const Program& program, const std::int64_t* kept, std::vector<Program::Instruction>& out);
  /// Of code that append() made, if it has one.
  [[nodiscard]] std::optional<Program::Table> table(std::span<const Program::Instruction> code) {
    return Program::Table::of(code, layout_, words_);
  }

 private:
  struct Register {
    bool known = false, needed = false;
    std::int64_t value = 0;      ///< If known.
    std::uint32_t same = 0;      ///< Otherwise: the register that has this value, itself or an earlier one,
    Program::Instruction now{};  ///< and, if itself, how it gets it.
    std::uint32_t place = 0;     ///< In the code that is appended.

    void be_known(std::int64_t is) {
      known = true;
      value = is;
    }
  };
  void evaluate(std::uint32_t i, const Program::Instruction& in, const std::int64_t* kept);
  static void connect(Register& here, const Register& a, const Register& b);
  [[nodiscard]] std::uint32_t source(std::uint32_t at) const {
    return registers_[at].known ? at : registers_[at].same;
  }

  const Layout& layout_;
  std::vector<Register> registers_;
  std::vector<std::uint64_t> words_;
};

/// What has to be remembered of a step to judge the next one: for each formula with Next, its largest parts
/// that speak of the present alone. Two steps that agree on these values have the same future, which keeps
/// the product small.
class Kept {
 public:
  /// The index of the value of \p term.
  std::uint32_t index(const logic::Formula& term);
  /// Keeps the value that \p cases give, or that of \p otherwise.
  std::uint32_t index_of_cases(std::vector<std::pair<logic::Formula, std::int32_t>> cases,
                               const logic::Formula& otherwise);

  struct Entry {
    std::vector<std::pair<logic::Formula, std::int32_t>> cases;
    logic::Formula term;
  };
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }

 private:
  std::unordered_map<logic::Formula, std::uint32_t, logic::FormulaHash> terms_;
  std::vector<Entry> entries_;
};

/// Code for a formula without Next over the values of one step.
[[nodiscard]] Program compile_present(const logic::Formula& formula, const Layout& layout);

/// Code for a formula with Next: primed names are read from the step, the present from \p kept, where it is
/// entered.
[[nodiscard]] Program compile_step(const logic::Formula& formula, const Layout& layout, Kept& kept);

}  // namespace heed::check
