// Diagrams out of the functions of a symbolic controller. With the current bits above the next ones, a state
// of the machine is what its functions become below: two valuations with the same functions there have the
// same future, so a machine that reads a threshold of thirty inputs has as many states as the threshold has
// answers. A step walks down two lists of functions at once: those of the state, over the bits that come, and
// those of every state, for which the same bits will be the current ones.
#include <heed/bdd/bdd.h>

#include <algorithm>
#include <map>
#include <optional>

#include "reaction_sources.h"

namespace heed::sim {
namespace {

using bdd::Bdd;
using model::Function;
using List = std::vector<Bdd>;

/// Lists of functions as numbers.
class Lists {
 public:
  std::uint32_t number(const List& list) {
    std::vector<std::uint32_t> key;
    for (const Bdd& f : list) key.push_back(f.id());
    const auto [found, added] =
        numbers_.try_emplace(std::move(key), static_cast<std::uint32_t>(lists_.size()));
    if (added) lists_.push_back(list);
    return found->second;
  }
  [[nodiscard]] const List& operator[](std::uint32_t number) const { return lists_[number]; }
  [[nodiscard]] std::size_t size() const { return lists_.size(); }

 private:
  std::map<std::vector<std::uint32_t>, std::uint32_t> numbers_;
  std::vector<List> lists_;
};

class SymbolicReactions : public ReactionSource {
 public:
  SymbolicReactions(const model::SymbolicController& machine, const Binding& binding,
                    const SymbolicJudge& judge, const std::vector<Component>& components,
                    util::Budget& budget)
      : machine_(machine),
        binding_(binding),
        judge_(judge),
        components_(components),
        manager_({.automatic_reordering = false}, &budget),
        budget_(budget) {
    place_columns();
    order_bits();
    import();
    list_functions();
  }

  Ending start() override {
    std::vector<bool> bits(2 * position_count_);
    set_inputs(binding_.blank, [&](std::size_t position, bool value) { bits[2 * position] = value; });
    const auto value = [&](Function f) { return model::evaluate(machine_.diagrams, f, bits); };
    if (!value(machine_.start.answered)) return {};
    Step step{binding_.blank, {}, {}};
    for (std::size_t i = 0; i < machine_.start.memories.size(); ++i)
      step.memories.push_back(bits[2 * (memory_ + i)] = value(machine_.start.memories[i]));
    for (std::size_t i = 0; i < machine_.start.outputs.size(); ++i)
      step.outputs.push_back(bits[2 * (output_ + i)] = value(machine_.start.outputs[i]));
    List all = all_;
    for (std::size_t p = 0; p < output_; ++p)
      for (Bdd& f : all) f = f.cofactor(variable_[2 * p], bits[2 * p]);
    return arrive(all, step, 0);
  }

  std::uint32_t expand(std::uint32_t state, Reactions& reactions) override {
    reactions_ = &reactions;
    nodes_.clear();
    goal_ = states_[state].goal;
    return walk(0, {own_.number(states_[state].functions), everyone_.number(all_), {}});
  }

 private:
  /// A state: the functions below its current bits.
  struct State {
    std::uint32_t goal = 0;
    List functions;
  };
  struct Step {
    model::Valuation inputs;
    std::vector<bool> outputs, memories;
  };
  /// Half-way through a step.
  struct Way {
    std::uint32_t own = 0;            ///< What the state's functions have become.
    std::uint32_t everyone = 0;       ///< What all functions have become.
    std::vector<std::int32_t> reads;  ///< Values of inputs that the judge reads, as far as shown.
    friend auto operator<=>(const Way&, const Way&) = default;
  };

  void place_columns() {
    for (const model::Variable& input : machine_.inputs) {
      input_.push_back(position_count_);
      position_count_ += model::bit_width(input.domain);
    }
    output_ = position_count_;
    for (const model::Output& column : machine_.outputs)
      position_count_ += model::bit_width(column.variable.domain);
    memory_ = position_count_;
    for (const model::Output& column : machine_.memories)
      position_count_ += model::bit_width(column.variable.domain);
  }

  /// Current bits, then next ones: inputs by component, memories, outputs.
  void order_bits() {
    std::vector<std::size_t> order;
    std::vector<bool> placed(position_count_, false);
    const auto place = [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p)
        if (!placed[p]) order.push_back(p), placed[p] = true;
    };
    for (const Component& component : components_)
      for (const std::uint32_t input : component.inputs) place(input_[input], input_end(input));
    shown_ = placed;
    place(0, output_);
    place(memory_, position_count_);
    place(output_, memory_);
    variable_.resize(2 * position_count_);
    for (const std::size_t later : {0U, 1U})
      for (const std::size_t p : order) variable_[2 * p + later] = manager_.new_variable();
  }

  void import() {
    imported_.push_back(manager_.constant(true));
    for (const model::Diagrams::Node& node : machine_.diagrams.nodes) {
      budget_.check();
      imported_.push_back(
          manager_.variable(variable_[node.bit]).ite(function(node.high), function(node.low)));
    }
  }

  [[nodiscard]] Bdd function(Function f) const { return f % 2 == 0 ? imported_[f / 2] : !imported_[f / 2]; }

  /// legal, updates, definitions; then for each goal its answers and when it is met.
  void list_functions() {
    Bdd legal = manager_.constant(true);
    for (const Function f : machine_.legal) legal &= function(f);
    all_.push_back(legal);
    for (const Function f : machine_.updates) all_.push_back(function(f));
    for (const Function f : machine_.derived) all_.push_back(function(f));
    for (const auto& goal : machine_.goals) {
      for (const Function f : goal.answers) all_.push_back(function(f));
      all_.push_back(function(goal.met));
    }
    imported_.clear();
    put_unshown();
  }

  [[nodiscard]] std::size_t input_end(std::size_t input) const {
    return input_[input] + model::bit_width(machine_.inputs[input].domain);
  }

  /// Puts a value for a bit above which nothing is left.
  void put_top(List& list, std::size_t bit, bool value) {
    for (Bdd& f : list)
      if (!f.is_constant() && f.top() == variable_[bit]) f = value ? f.high() : f.low();
  }

  template <typename Put>
  void set_input(std::size_t input, std::int32_t value, const Put& put_bit) const {
    const model::Domain& domain = machine_.inputs[input].domain;
    const std::int64_t distance = std::int64_t{value} - domain.low;
    std::size_t position = input_[input];
    for (std::size_t weight = model::bit_width(domain); weight-- > 0; ++position)
      put_bit(position, ((distance >> weight) & 1) != 0);
  }
  template <typename Put>
  void set_inputs(const model::Valuation& values, const Put& put_bit) const {
    for (std::size_t i = 0; i < values.size(); ++i) set_input(i, values[i], put_bit);
  }

  /// What no component shows is blank.
  void put_unshown() {
    set_inputs(binding_.blank, [&](std::size_t position, bool value) {
      if (shown_[position]) return;
      for (const std::size_t later : {0U, 1U})
        for (Bdd& f : all_) f = f.cofactor(variable_[2 * position + later], value);
    });
  }

  // As deep as there are components, of which a profile has 64 at most.
  std::uint32_t walk(std::size_t level, const Way& way) {
    if (level == components_.size()) return finish(way);
    const auto known = nodes_.find({level, way});
    if (known != nodes_.end()) return known->second;
    budget_.check();
    std::vector<std::uint32_t> children;
    for (const std::uint64_t letter : components_[level].letters) {
      model::Valuation values = binding_.blank;
      show(components_[level], binding_, letter, values);
      children.push_back(within_domains(level, values) ? walk(level + 1, shown(level, way, values))
                                                       : unanswered(level + 1));
    }
    const std::uint32_t node = reactions_->add_node(level, children);
    nodes_.emplace(std::pair(level, way), node);
    return node;
  }

  [[nodiscard]] bool within_domains(std::size_t level, const model::Valuation& values) const {
    return std::all_of(components_[level].inputs.begin(), components_[level].inputs.end(),
                       [&](std::uint32_t input) {
                         const model::Domain& domain = machine_.inputs[input].domain;
                         return values[input] >= domain.low && values[input] <= domain.high;
                       });
  }

  std::uint32_t unanswered(std::size_t level) {
    std::uint32_t node = reactions_->add_ending({});
    for (std::size_t l = components_.size(); l-- > level;)
      node = reactions_->add_node(l, std::vector<std::uint32_t>(components_[l].letters.size(), node));
    return node;
  }

  /// The way goes on with what a component shows.
  Way shown(std::size_t level, const Way& way, const model::Valuation& values) {
    List own = own_[way.own], everyone = everyone_[way.everyone];
    Way result;
    result.reads = way.reads;
    for (const std::uint32_t input : components_[level].inputs) {
      set_input(input, values[input], [&](std::size_t position, bool value) {
        put_top(own, 2 * position + 1, value);
        put_top(everyone, 2 * position, value);
      });
      if (std::find(judge_.reads.begin(), judge_.reads.end(), input) != judge_.reads.end())
        result.reads.push_back(values[input]);
    }
    result.own = own_.number(own);
    result.everyone = everyone_.number(everyone);
    return result;
  }

  std::uint32_t finish(const Way& way) {
    List own = own_[way.own];
    Step step{binding_.blank, {}, {}};
    std::size_t read = 0;
    for (const Component& component : components_)
      for (const std::uint32_t input : component.inputs)
        if (std::find(judge_.reads.begin(), judge_.reads.end(), input) != judge_.reads.end())
          step.inputs[input] = way.reads[read++];
    for (std::size_t i = 0; i < machine_.updates.size(); ++i) step.memories.push_back(own[1 + i].is_true());
    for (std::size_t i = 0; i < step.memories.size(); ++i)
      put_top(own, 2 * (memory_ + i) + 1, step.memories[i]);
    if (!own.front().is_true()) return reactions_->add_ending({});
    const std::size_t answers = 1 + machine_.updates.size();
    for (std::size_t i = 0; i < memory_ - output_; ++i) {
      step.outputs.push_back(own[answers + i].is_true());
      put_top(own, 2 * (output_ + i) + 1, step.outputs[i]);
    }
    const auto goals = static_cast<std::uint32_t>(machine_.goals.size());
    const std::uint32_t goal = own.back().is_true() ? (goal_ + 1) % goals : goal_;
    return reactions_->add_ending(arrive(everyone_[way.everyone], step, goal));
  }

  /// The state after \p step. \param all  all functions, the current inputs put in
  Ending arrive(List all, const Step& step, std::uint32_t goal) {
    for (std::size_t i = 0; i < step.memories.size(); ++i) put_top(all, 2 * (memory_ + i), step.memories[i]);
    for (std::size_t i = 0; i < step.outputs.size(); ++i) put_top(all, 2 * (output_ + i), step.outputs[i]);
    const std::size_t answers = 1 + machine_.updates.size() + machine_.derived.size();
    State state;
    state.goal = goal;
    const auto copy = [&](std::size_t from, std::size_t count) {
      for (std::size_t i = 0; i < count; ++i) state.functions.push_back(all[from + i]);
    };
    copy(0, 1 + machine_.updates.size());
    const std::size_t one = memory_ - output_ + 1;
    copy(answers + goal * one, one);
    Ending ending;
    ending.next = number(std::move(state));
    ending.event = judge_.event(step.inputs, columns(step, all));
    return ending;
  }

  [[nodiscard]] model::Valuation columns(const Step& step, const List& all) const {
    model::Valuation values;
    const auto read = [&](const std::vector<model::Output>& list, const std::vector<bool>& bits) {
      std::size_t position = 0;
      for (const model::Output& column : list) {
        std::int64_t value = 0;
        for (std::size_t i = model::bit_width(column.variable.domain); i > 0; --i)
          value = 2 * value + (bits[position++] ? 1 : 0);
        values.push_back(static_cast<std::int32_t>(value + column.variable.domain.low));
      }
    };
    read(machine_.outputs, step.outputs);
    read(machine_.memories, step.memories);
    for (std::size_t i = 0; i < machine_.derived.size(); ++i)
      values.push_back(all[1 + machine_.updates.size() + i].is_true() ? 1 : 0);
    return values;
  }

  std::uint32_t number(State state) {
    std::vector<std::uint32_t> key{state.goal};
    for (const Bdd& f : state.functions) key.push_back(f.id());
    const auto [found, added] =
        state_numbers_.try_emplace(std::move(key), static_cast<std::uint32_t>(states_.size()));
    if (added) states_.push_back(std::move(state));
    return found->second;
  }

  const model::SymbolicController& machine_;
  const Binding& binding_;
  const SymbolicJudge& judge_;
  const std::vector<Component>& components_;
  bdd::Manager manager_;
  util::Budget& budget_;
  std::vector<std::size_t> input_;  ///< Position of each input's first bit.
  std::size_t output_ = 0, memory_ = 0, position_count_ = 0;
  std::vector<bool> shown_;         ///< Per position: a component shows it.
  std::vector<bdd::Var> variable_;  ///< Per bit.
  std::vector<Bdd> imported_;
  List all_;
  Lists own_, everyone_;
  std::map<std::vector<std::uint32_t>, std::uint32_t> state_numbers_;
  std::vector<State> states_;
  std::map<std::pair<std::size_t, Way>, std::uint32_t> nodes_;  ///< Of the state that is expanded.
  Reactions* reactions_ = nullptr;
  std::uint32_t goal_ = 0;
};

}  // namespace

std::unique_ptr<ReactionSource> reactions_of(const model::SymbolicController& machine, const Binding& binding,
                                             const SymbolicJudge& judge,
                                             const std::vector<Component>& components, util::Budget& budget) {
  return std::make_unique<SymbolicReactions>(machine, binding, judge, components, budget);
}

}  // namespace heed::sim
