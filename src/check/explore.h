#pragma once

#include <heed/check/verify.h>
#include <heed/util/word_table.h>

#include "letters.h"
#include "rules.h"

#include <cstdint>
#include <string>
#include <vector>

namespace heed::check {

constexpr std::uint32_t none = UINT32_MAX;

/// The reachable product of a machine and its specification. A node stands after a step: the machine's state
/// and what was kept of the step. Node 0 stands before the first.
struct Product {
  struct Node {
    std::uint32_t state;   ///< Of the machine.
    std::uint32_t kept;    ///< Index of the kept values; none for node 0.
    std::uint32_t parent;  ///< On a shortest path from node 0.
    std::uint32_t row;     ///< The machine's transition that led here from the parent.
  };
  struct Edge {
    std::uint32_t target, row;
  };
  std::vector<Node> nodes;
  std::vector<std::size_t> first;  ///< Edges of node n: first[n] ... first[n + 1] - 1.
  std::vector<Edge>
      edges;  ///< Hardly a (target, justices) is repeated. Empty if no system justice asks for them.
  std::vector<std::uint64_t>
      marks;  ///< Per edge `words` words: bit i = justice i is met, environment's first.
  std::size_t words = 0;

  [[nodiscard]] bool meets(std::size_t edge, std::size_t justice) const {
    return ((marks[edge * words + justice / 64] >> (justice % 64)) & 1U) != 0;
  }
};

/// Builds the product breadth first and refuses, on the way, what a single step can show.
class Explorer {
 public:
  Explorer(const model::Mealy& machine, const Rules& rules, util::Budget& budget, const Options& options);

  void run(Verdict& verdict);
  [[nodiscard]] const Product& product() const { return product_; }
  /// The steps from the start to \p node.
  [[nodiscard]] std::vector<TraceStep> trace(std::uint32_t node) const;
  [[nodiscard]] TraceStep step(std::uint32_t row) const;

 private:
  /// What depends on the letters of a row alone, computed when a legal step first has them. Machines repeat
  /// few pairs of letters in many rows.
  struct RowFacts {
    bool environment_broken =
        false;  ///< An assumption over outputs fails in this step: no obligation follows it.
    std::uint32_t kept = none;
    std::uint32_t marks = 0;  ///< Present justices, in `row_marks_`.
    const std::string* violated = nullptr;
    bool wrong_column = false;
    const std::string* violated_after_start = nullptr;  ///< Only at the start may the letters be these.
  };
  struct Answer {
    std::uint32_t node, row;
  };
  /// What the rows taken at one node have to share where an answer may not depend on the input.
  struct Common {
    bool start = false, fixed = false;
    std::uint32_t row = none;
  };

  void map_columns();
  void check_machine() const;
  void expand(std::uint32_t node);
  bool take(std::uint32_t node, std::uint32_t letter, std::int32_t* values, Common& common);
  std::uint32_t row_of(std::uint32_t state, std::uint32_t letter);
  bool answer(Answer at, std::int32_t* values, Common& common);
  [[nodiscard]] bool can_start(const std::int32_t* values) const;
  bool refuse_row(Answer at, const RowFacts& row);
  bool starts_well(Answer at, const std::int32_t* values);
  bool memories_agree(Answer at, const std::int32_t* values);
  bool shares(Answer at, Common& common);
  bool keeps_step(Answer at, const RowFacts& row, const std::int32_t* values);
  const RowFacts& facts(std::uint32_t row, const std::int32_t* values);
  bool start_broken(const std::int32_t* values);
  void connect(Answer at, const RowFacts& row, const std::int32_t* values);
  [[nodiscard]] bool has_edge(std::uint32_t target) const;
  std::uint32_t intern_kept(const std::int32_t* values);
  /// The machine's values of the slots from the outputs on.
  [[nodiscard]] const std::int32_t* columns(std::uint32_t row) const {
    return columns_.data() + std::size_t{machine_.transitions[row].output} * width_;
  }
  [[nodiscard]] std::int32_t column(std::uint32_t row, std::uint32_t slot) const {
    return columns(row)[slot - rules_.layout.inputs()];
  }
  [[nodiscard]] bool holds(const Program& program, const std::int32_t* values) const;
  void recall(std::uint32_t kept);
  bool refuse(Refutation refutation, std::uint32_t node, const TraceStep& last);
  bool missing(std::uint32_t node, const std::int32_t* values);

  const model::Mealy& machine_;
  const Rules& rules_;
  util::Budget& budget_;
  const Options& options_;
  Verdict* verdict_ = nullptr;
  LetterIndex letters_;
  LegalInputs legal_;
  Product product_;
  std::size_t width_ = 0;              ///< Slots from the outputs on.
  std::vector<std::int32_t> columns_;  ///< Their values, per output letter.
  util::WordTable pairs_{2};           ///< Of input and output letters.
  std::vector<RowFacts> facts_;        ///< Per pair.
  std::vector<std::uint64_t> row_marks_;
  util::WordTable kept_;  ///< The halves of the values.
  Outlooks outlooks_;
  const Outlook* outlook_ = nullptr;        ///< From the node that is expanded,
  std::vector<std::int64_t> before_;        ///< and the values kept there.
  std::uint32_t next_row_ = 0;              ///< Of its state: after the one that was found last.
  util::WordTable places_{2};               ///< Machine state and kept values of every node.
  std::vector<std::size_t> last_edge_;      ///< Per node: the last edge that reached it, plus one.
  std::vector<std::size_t> previous_edge_;  ///< Per edge of the node: the one before with its target.
  std::vector<std::uint64_t> step_marks_;
  std::vector<std::uint32_t> halves_;
  mutable std::vector<std::int64_t> registers_;
  bool answered_start_ = false, refused_start_ = false;
};

}  // namespace heed::check
