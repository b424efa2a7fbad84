#pragma once

#include <heed/logic/formula.h>
#include <heed/util/limits.h>
#include <heed/util/source.h>

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace heed::spec {

/// A subformula with where its text begins, and whether it speaks of the next step.
struct Read {
  logic::Formula formula;
  std::size_t begin = 0;
  bool primed = false;
};

/// Reads formulas in slugs' prefix notation. From left to right with a stack of the operators that still wait
/// for operands. Chains of one associative operator, `& & & a b c d`, are one frame, so depth counts
/// alternations and not length. What `? i` recalls is the formula itself: parts stay shared.
class PrefixReader {
 public:
  /// The variable that a word names, or an InputError.
  using Resolve = std::function<Read(std::string_view word, std::size_t begin)>;

  PrefixReader(const util::SourceText& source, const util::Limits& limits, Resolve resolve)
      : source_(source), limits_(limits), resolve_(std::move(resolve)) {}

  /// Reads the text between two offsets of the source, all of it. \throws util::InputError
  [[nodiscard]] Read read(std::size_t begin, std::size_t end);
  /// The operands of the `&` at the top of what was read last, each with its end; empty when there is none.
  [[nodiscard]] const std::vector<std::pair<Read, std::size_t>>& conjuncts() const { return conjuncts_; }

 private:
  /// An operator that waits for operands; Op::Name stands for a block, Op::Iff for exclusive or.
  struct Frame {
    logic::Op op;
    std::size_t waiting;
    std::size_t begin;  ///< Offset of its text.
    std::size_t base;   ///< Its operands are the values from here on.
  };

  [[nodiscard]] std::string_view token();
  void skip_blanks();
  void read_token();
  void open(logic::Op op, std::size_t operands, std::size_t begin);
  void open_block(std::size_t begin);
  [[nodiscard]] std::size_t number(const char* what);
  [[nodiscard]] Read recall(std::size_t begin);
  void operand(Read value);
  [[nodiscard]] Read close();
  [[noreturn]] void fail(std::size_t offset, std::string code, std::string message,
                         std::string hint = {}) const;

  const util::SourceText& source_;
  const util::Limits& limits_;
  Resolve resolve_;
  std::size_t at_ = 0, end_ = 0;
  std::vector<Frame> frames_;
  std::vector<Read> values_;
  std::vector<std::size_t> blocks_;  ///< Indices of frames.
  std::vector<std::pair<Read, std::size_t>> conjuncts_;
};

}  // namespace heed::spec
