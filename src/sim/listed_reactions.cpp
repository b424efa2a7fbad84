// Diagrams out of the rows of a listed machine: rows are dealt out component by component.
#include <algorithm>
#include <map>

#include "reaction_sources.h"

namespace heed::sim {
namespace {

class ListedReactions : public ReactionSource {
 public:
  ListedReactions(const model::Mealy& machine, const Binding& binding, const Judge& judge,
                  const std::vector<Component>& components)
      : machine_(machine), binding_(binding), judge_(judge) {
    for (const Component& component : components) add_level(component);
    find_usable(components);
  }

  Ending start() override {
    const auto letter = machine_.input_letter(binding_.blank);
    return ending(letter ? machine_.find(0, *letter) : nullptr);
  }

  std::uint32_t expand(std::uint32_t state, Reactions& reactions) override {
    if (nothing_.empty()) add_nothing(reactions);
    std::vector<std::uint32_t> rows;
    for (std::uint32_t t = machine_.first[state]; t < machine_.first[state + 1]; ++t)
      if (usable_[machine_.transitions[t].input]) rows.push_back(t);
    return deal(0, rows, reactions);
  }

 private:
  static constexpr std::uint32_t none = UINT32_MAX;

  struct Level {
    /// Per letter of the component: letters that show the same have the same number.
    std::vector<std::uint32_t> look;
    std::uint32_t looks = 0;
    std::vector<std::uint32_t> of_letter;  ///< Per input letter of the machine: its look, or none.
  };

  void add_level(const Component& component) {
    Level level;
    std::map<model::Valuation, std::uint32_t> looks;
    const auto look = [&](const model::Valuation& values) {
      model::Valuation shown;
      for (const std::uint32_t input : component.inputs) shown.push_back(values[input]);
      return shown;
    };
    for (const std::uint64_t letter : component.letters) {
      model::Valuation values = binding_.blank;
      show(component, binding_, letter, values);
      level.look.push_back(
          looks.try_emplace(look(values), static_cast<std::uint32_t>(looks.size())).first->second);
    }
    level.looks = static_cast<std::uint32_t>(looks.size());
    for (const model::Valuation& letter : machine_.input_letters) {
      const auto found = looks.find(look(letter));
      level.of_letter.push_back(found == looks.end() ? none : found->second);
    }
    levels_.push_back(std::move(level));
  }

  /// Inputs that no component shows are blank.
  void find_usable(const std::vector<Component>& components) {
    std::vector<bool> shown(machine_.inputs.size(), false);
    for (const Component& component : components)
      for (const std::uint32_t input : component.inputs) shown[input] = true;
    for (const model::Valuation& letter : machine_.input_letters) {
      bool usable = true;
      for (std::size_t i = 0; i < letter.size(); ++i)
        usable = usable && (shown[i] || letter[i] == binding_.blank[i]);
      usable_.push_back(usable);
    }
  }

  [[nodiscard]] Ending ending(const model::Mealy::Transition* row) const {
    if (row == nullptr) return {};
    const auto index = static_cast<std::size_t>(row - machine_.transitions.data());
    return {row->next, judge_.event[index], row->fallback};
  }

  /// Per level the node from which no row is left.
  void add_nothing(Reactions& reactions) {
    nothing_.assign(levels_.size() + 1, 0);
    nothing_.back() = reactions.add_ending({});
    for (std::size_t level = levels_.size(); level-- > 0;)
      nothing_[level] = reactions.add_node(
          level, std::vector<std::uint32_t>(levels_[level].look.size(), nothing_[level + 1]));
  }

  // As deep as there are components, of which a profile has 64 at most.
  std::uint32_t deal(std::size_t level, const std::vector<std::uint32_t>& rows, Reactions& reactions) {
    if (rows.empty()) return nothing_[level];
    if (level == levels_.size()) return reactions.add_ending(ending(&machine_.transitions[rows.front()]));
    const Level& here = levels_[level];
    std::vector<std::vector<std::uint32_t>> hands(here.looks);
    for (const std::uint32_t row : rows)
      if (const std::uint32_t look = here.of_letter[machine_.transitions[row].input]; look != none)
        hands[look].push_back(row);
    std::vector<std::uint32_t> nodes, children;
    for (const auto& hand : hands) nodes.push_back(deal(level + 1, hand, reactions));
    for (const std::uint32_t look : here.look) children.push_back(nodes[look]);
    return reactions.add_node(level, children);
  }

  const model::Mealy& machine_;
  const Binding& binding_;
  const Judge& judge_;
  std::vector<Level> levels_;
  std::vector<bool> usable_;
  std::vector<std::uint32_t> nothing_;
};

}  // namespace

std::unique_ptr<ReactionSource> reactions_of(const model::Mealy& machine, const Binding& binding,
                                             const Judge& judge, const std::vector<Component>& components) {
  return std::make_unique<ListedReactions>(machine, binding, judge, components);
}

}  // namespace heed::sim
