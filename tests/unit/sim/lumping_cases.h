#pragma once

// Random profiles of independent features and random machines, for the tests of lumping.

#include <fmt/format.h>
#include <heed/model/symbolic.h>
#include <heed/sim/lumping.h>
#include <heed/util/random.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "unit/sim/case_study.h"

namespace heed::sim::lumping_cases {

/// Everything that one analysis reads.
struct Case {
  ProfileSpec profile;
  model::Mealy machine;
  Binding wiring;
  Judge judgement;
};

class Maker {
 public:
  explicit Maker(std::uint64_t seed) : random_(seed, 0) {}

  Case make() {
    made_.profile.name = "random";
    made_.profile.cells = static_cast<std::uint32_t>(1 + pick(4));
    made_.profile.persistent = pick(2) == 0;
    if (pick(4) == 0) made_.profile.everything_visible_in = made_.profile.cells - 1;
    features_ = 1 + pick(4);
    make_features();
    wire();
    make_machine();
    return std::move(made_);
  }

 private:
  int pick(int bound) { return static_cast<int>(random_.below(static_cast<std::uint32_t>(bound))); }

  // Few different rules: some features are alike.
  void make_features() {
    for (int f = 0; f < features_; ++f) {
      FeatureSpec feature{fmt::format("f{}", f), FixedOnset{1}};
      const std::string before = f > 0 && pick(3) == 0 ? fmt::format("f{} + 1", f - 1) : "0";
      const int rule = pick(4);
      if (rule == 0) feature.onset = GeometricOnset{case_study::q("1/3"), case_study::at(before)};
      if (rule == 1) feature.onset = UniformOnset{case_study::at(before), case_study::at("never")};
      if (rule == 2) feature.onset = LinearOnset{case_study::q("1/4"), case_study::q("3/4")};
      if (f > 0 && pick(2) == 0) {
        feature = made_.profile.features.front();
        feature.name = fmt::format("f{}", f);
        made_.profile.features.push_back(feature);
        continue;
      }
      if (pick(2) == 0) feature.detection = case_study::q("2/3");
      if (pick(2) == 0) feature.false_detection = case_study::q("1/5");
      feature.absent = pick(8) == 0;
      made_.profile.features.push_back(feature);
    }
  }

  /// Each feature its own input; now and then two share one, or one has none.
  void wire() {
    for (int f = 0; f < features_; ++f) {
      inputs_.push_back({fmt::format("i{}", f), model::Domain::integer(0, 2), {}, {}});
      made_.wiring.blank.push_back(0);
      if (pick(8) == 0) continue;
      const int input = f > 0 && pick(5) == 0 ? f - 1 : f;
      made_.wiring.wires.push_back(
          {static_cast<std::uint32_t>(f), static_cast<std::uint32_t>(input), 1 + (input != f ? 1 : 0)});
    }
  }

  /// A machine that counts (and so treats all alike), one that reads some inputs only, or a wild one; half of
  /// them have holes and fallbacks.
  void make_machine() {
    const int kind = pick(3), states = 1 + pick(3);
    const bool holes = pick(2) == 0;
    const auto read = static_cast<std::size_t>(pick(features_ + 1));
    made_.judgement.categories = {"rest", "a", "b"};
    made_.judgement.never = static_cast<std::uint32_t>(pick(3));
    model::MealyBuilder builder("random", inputs_, {});
    for (int s = 0; s < states; ++s) builder.add_state();
    std::vector<model::Valuation> letters{{}};
    for (int f = 0; f < features_; ++f) letters = longer(letters);
    for (int s = 0; s < states; ++s) {
      std::vector<std::optional<Answer>> table(1000);
      for (const model::Valuation& letter : letters) {
        auto& answer = table[what_counts(letter, kind, read)];
        if (!answer) answer = Answer{pick(states), pick(6), holes ? pick(8) : 7};
        if (answer->hole == 0) continue;
        builder.add(static_cast<std::uint32_t>(s), letter, {}, static_cast<std::uint32_t>(answer->next),
                    answer->hole == 1);
        events_.push_back(answer->event < 3 ? static_cast<std::uint32_t>(answer->event) : Judge::none);
      }
    }
    made_.machine = builder.finish();
    made_.judgement.event = events_;
  }

  struct Answer {
    int next, event, hole;
  };

  static std::vector<model::Valuation> longer(const std::vector<model::Valuation>& letters) {
    std::vector<model::Valuation> result;
    for (const model::Valuation& letter : letters)
      for (std::int32_t value = 0; value <= 2; ++value) {
        result.push_back(letter);
        result.back().push_back(value);
      }
    return result;
  }

  static std::size_t what_counts(const model::Valuation& letter, int kind, std::size_t read) {
    std::size_t result = 0;
    for (std::size_t i = 0; i < letter.size(); ++i) {
      const auto value = static_cast<std::size_t>(letter[i]);
      if (kind == 0) result += value;
      if (kind == 1 && i < read) result = 3 * result + value;
      if (kind == 2) result = 3 * result + value;
    }
    return result;
  }

  util::CounterRandom random_;
  int features_ = 0;
  Case made_;
  std::vector<model::Variable> inputs_;
  std::vector<std::uint32_t> events_;
};

/// The same machine by functions: its state, and the event of the step, are memories; nothing is minimised.
class SymbolicTwin {
 public:
  explicit SymbolicTwin(const Case& made) : made_(made) {
    out_.name = "twin";
    out_.inputs = made.machine.inputs;
    const auto last = static_cast<std::int32_t>(made.machine.state_count() - 1);
    out_.memories = {{{"state", model::Domain::integer(0, last), {}, {}}, model::OutputRole::Memory},
                     {{"event", model::Domain::integer(0, 3), {}, {}}, model::OutputRole::Memory}};
    for (const model::Variable& input : out_.inputs) widths_.push_back(model::bit_width(input.domain));
    for (const std::size_t width : widths_) positions_ += width;
    state_bits_ = model::bit_width(out_.memories[0].variable.domain);
  }

  model::SymbolicController make() {
    const std::size_t all = positions_ + state_bits_ + 2;
    for (std::size_t bit = 2 * all; bit-- > 0;)
      out_.diagrams.order.push_back(static_cast<std::uint32_t>(bit));
    for (std::size_t m = 0; m < state_bits_ + 2; ++m) {
      out_.start.memories.push_back(function(false, m));
      out_.updates.push_back(function(true, m));
    }
    out_.start.answered = function(false, answered);
    out_.legal = {function(true, answered)};
    out_.goals = {{{}, model::function_true, {{model::function_true, std::nullopt}}}};
    return std::move(out_);
  }

 private:
  static constexpr std::size_t answered = SIZE_MAX;

  /// A memory's next bit (or whether there is a row), as a function of the state's bits and of the input's.
  model::Function function(bool later, std::size_t wanted) {
    std::vector<std::uint32_t> bits;
    for (std::size_t p = 0; p < positions_; ++p) bits.push_back(static_cast<std::uint32_t>(2 * p + later));
    for (std::size_t p = 0; later && p < state_bits_; ++p)
      bits.push_back(static_cast<std::uint32_t>(2 * (positions_ + p)));
    std::sort(bits.begin(), bits.end(), std::greater<>());
    std::map<std::uint32_t, bool> values;
    return build(bits, 0, values, wanted);
  }

  model::Function build(const std::vector<std::uint32_t>& bits, std::size_t level,
                        std::map<std::uint32_t, bool>& values, std::size_t wanted) {
    if (level == bits.size()) return value(values, wanted) ? model::function_true : model::function_false;
    values[bits[level]] = false;
    model::Function low = build(bits, level + 1, values, wanted);
    values[bits[level]] = true;
    model::Function high = build(bits, level + 1, values, wanted);
    if (low == high) return low;
    const std::uint32_t complement = high & 1;
    out_.diagrams.nodes.push_back({bits[level], low ^ complement, high ^ complement});
    return static_cast<model::Function>(2 * out_.diagrams.nodes.size()) | complement;
  }

  bool value(const std::map<std::uint32_t, bool>& values, std::size_t wanted) const {
    const auto bit = [&](std::size_t position) {
      for (const std::size_t later : {0U, 1U})
        if (const auto found = values.find(static_cast<std::uint32_t>(2 * position + later));
            found != values.end())
          return found->second;
      return false;
    };
    model::Valuation letter;
    std::size_t position = 0;
    const auto spell = [&](std::size_t width) {
      std::uint32_t number = 0;
      for (std::size_t i = 0; i < width; ++i) number = 2 * number + (bit(position++) ? 1 : 0);
      return number;
    };
    for (const std::size_t width : widths_) letter.push_back(static_cast<std::int32_t>(spell(width)));
    const std::uint32_t state = spell(state_bits_);
    const auto known = made_.machine.input_letter(letter);
    const auto* row =
        known && state < made_.machine.state_count() ? made_.machine.find(state, *known) : nullptr;
    if (wanted == answered) return row != nullptr;
    if (row == nullptr) return false;
    const std::uint32_t event =
        made_.judgement.event[static_cast<std::size_t>(row - made_.machine.transitions.data())];
    if (wanted < state_bits_) return (row->next >> (state_bits_ - 1 - wanted) & 1) != 0;
    return ((event == Judge::none ? 3 : event) >> (state_bits_ + 1 - wanted) & 1) != 0;
  }

  const Case& made_;
  model::SymbolicController out_;
  std::vector<std::size_t> widths_;
  std::size_t positions_ = 0, state_bits_ = 0;
};

}  // namespace heed::sim::lumping_cases
