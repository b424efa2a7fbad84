#pragma once

#include <heed/model/variable.h>
#include <heed/util/limits.h>
#include <heed/util/source.h>
#include <heed/util/word_table.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace heed::model {

/// What an output column of a controller is: chosen, or computed along for whoever watches.
enum class OutputRole : std::uint8_t {
  Action,      ///< The plant's action; an exported step() returns it.
  Output,      ///< Any other variable that the system chooses.
  Plant,       ///< The state of a deterministic plant, tracked inside.
  Memory,      ///< A monitor's state before the step: tree levels, pending requests.
  Recognised,  ///< Derived: an entity is recognised now.
  Prescribed   ///< Derived: a behaviour is prescribed now, to hold from the next step on.
};

struct Output {
  Variable variable;
  OutputRole role = OutputRole::Output;
};

/// A deterministic Mealy machine with finite inputs: the controller. It starts in state 0 **before** the
/// first observation; step t reads the observation X(t), gives the outputs Y(t) and moves on. Letters are
/// interned valuations, so that a transition is three numbers. Immutable once built; every state's rows are
/// sorted by input letter.
struct Mealy {
  struct Transition {
    std::uint32_t input;    ///< Index into `input_letters`.
    std::uint32_t output;   ///< Index into `output_letters`.
    std::uint32_t next;     ///< State.
    bool fallback = false;  ///< The observation breaks an assumption; the answer is the stated fallback.
  };

  std::string name;  ///< The controller's name in the scenario, or of the specification.
  std::vector<Variable> inputs;
  std::vector<Output> outputs;
  std::vector<Valuation> input_letters;   ///< Over `inputs`; all different, ascending.
  std::vector<Valuation> output_letters;  ///< Over `outputs`; all different, ascending.
  std::vector<std::uint32_t>
      first;  ///< Rows of state s: transitions[first[s]] ... transitions[first[s+1]-1].
  std::vector<Transition> transitions;
  std::vector<std::string> assumptions;  ///< Assumptions on the environment that it relies on, as formulas.
  std::vector<std::string> notes;        ///< Such as "assumptions dropped: wins without them".

  [[nodiscard]] std::uint32_t state_count() const {
    return first.empty() ? 0 : static_cast<std::uint32_t>(first.size() - 1);
  }
  /// The row for (state, input letter); nullptr where none is defined. O(log rows).
  [[nodiscard]] const Transition* find(std::uint32_t state, std::uint32_t input) const;
  /// The index of a letter; nothing when the machine does not know it. O(log letters).
  [[nodiscard]] std::optional<std::uint32_t> input_letter(const Valuation& valuation) const;
  friend bool operator==(const Mealy& a, const Mealy& b);
};

/// Adds rows state by state, interns letters, and sorts everything at the end.
class MealyBuilder {
 public:
  MealyBuilder(std::string name, std::vector<Variable> inputs, std::vector<Output> outputs);
  std::uint32_t add_state();
  /// Room for \p count rows: up to there, adding moves none. Room that is not used takes addresses, not
  /// memory.
  void reserve(std::size_t count) { rows_.reserve(count); }
  /// Bytes that are taken at once on the way to \p more rows.
  [[nodiscard]] std::size_t bytes_to_grow(std::size_t more) const { return util::bytes_to_grow(rows_, more); }
  void add(std::uint32_t state, const Valuation& input, const Valuation& output, std::uint32_t next,
           bool fallback = false);
  /// The same with letters that were interned before: for rows whose letters repeat.
  void add(std::uint32_t state, const Mealy::Transition& row) {
    if (runs_.empty() || runs_.back().state != state) runs_.push_back({state, rows_.size()});
    rows_.push_back(row);
  }
  /// Numbers a letter, the same for equal valuations; valid for add() only.
  [[nodiscard]] std::uint32_t input_letter(const Valuation& letter);
  [[nodiscard]] std::uint32_t output_letter(const Valuation& letter);
  [[nodiscard]] Valuation input_valuation(std::uint32_t letter) const {
    return {input_letters_[letter].begin(), input_letters_[letter].end()};
  }
  void add_assumption(std::string formula) { machine_.assumptions.push_back(std::move(formula)); }
  void add_note(std::string note) { machine_.notes.push_back(std::move(note)); }
  /// About as many bytes as finish() takes besides those that it holds: letters become values of their own.
  [[nodiscard]] std::size_t bytes_to_finish() const;
  /// \pre no (state, input) was added twice. The builder is spent.
  [[nodiscard]] Mealy finish();

 private:
  /// Rows of one state that were added one after the other.
  struct Run {
    std::uint32_t state;
    std::size_t begin;
  };
  [[nodiscard]] std::vector<Mealy::Transition> rows_by_state();

  Mealy machine_;
  std::vector<Mealy::Transition> rows_;
  std::vector<Run> runs_;
  util::WordTable input_letters_, output_letters_;
  std::uint32_t states_ = 0;
};

/// The smallest machine with the same answers from state 0, by partition refinement; unreachable states go
/// first, states are renumbered in breadth-first order of first visit, so equal machines print equal. A
/// missing row is an answer of its own: it is never merged away, nor is a fallback. O(transitions * log
/// states). \cite hopcroft.71.tmc
[[nodiscard]] Mealy minimise(const Mealy& machine);

/// Controller files: JSON, one schema (docs/formats.md). Reading checks everything that write_mealy()
/// guarantees.
[[nodiscard]] std::string write_mealy(const Mealy& machine);
[[nodiscard]] Mealy read_mealy(const util::SourceText& source, const util::Limits& limits = {});

}  // namespace heed::model
