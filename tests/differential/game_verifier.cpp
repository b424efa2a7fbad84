#include "game_reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>

namespace heed::reference {
namespace {

/// Runs a machine against every play of the environment and looks at the graph of what can happen.
class Verifier {
 public:
  Verifier(const model::Mealy& machine, const Rules& rules) : machine_(machine), rules_(rules) {}

  std::string run() {
    first_steps();
    for (std::size_t i = 0; fault_.empty() && i < nodes_.size(); ++i) later_steps(i);
    if (fault_.empty()) bad_cycle();
    return fault_;
  }

 private:
  struct Node {
    std::uint32_t state;
    Values values;
    Counters counters;
    auto operator<=>(const Node&) const = default;
  };

  void fail(std::string message) {
    if (fault_.empty()) fault_ = std::move(message);
  }

  [[nodiscard]] const model::Mealy::Transition* row(std::uint32_t state, const Values& input) const {
    model::Valuation letter;
    for (const auto& v : machine_.inputs) letter.push_back(static_cast<std::int32_t>(input.at(v.name)));
    const auto index = machine_.input_letter(letter);
    const auto* found = index ? machine_.find(state, *index) : nullptr;
    return found != nullptr && found->fallback ? nullptr : found;
  }

  /// The step's values as the machine shows them; definitions are checked and left out.
  Values shown(const model::Mealy::Transition& row, const Values& input) {
    Values all = input;
    const model::Valuation& letter = machine_.output_letters[row.output];
    for (std::size_t i = 0; i < letter.size(); ++i) {
      const auto& variable = machine_.outputs[i].variable;
      if (rules_.evaluator().domain(variable.name) != nullptr) all[variable.name] = letter[i];
    }
    for (std::size_t i = 0; i < letter.size(); ++i) {
      const auto& variable = machine_.outputs[i].variable;
      if (rules_.evaluator().domain(variable.name) != nullptr) continue;
      if (rules_.evaluator().holds(logic::name(variable.name), all) != (letter[i] != 0))
        fail(fmt::format("wrong column {}", variable.name));
    }
    return all;
  }

  std::uint32_t node(Node node) {
    const auto [found, added] = numbers_.emplace(node, static_cast<std::uint32_t>(nodes_.size()));
    if (added) {
      nodes_.push_back(std::move(node));
      edges_.emplace_back();
    }
    return found->second;
  }

  void first_steps() {
    const auto quantifiers = rules_.spec().initial;
    bool some = false;
    std::set<Values> answers;
    for (const Values& input : rules_.inputs()) {
      const auto* answer = row(0, input);
      const bool legal = rules_.legal_first(input);
      if (answer == nullptr && legal && quantifiers != spec::InitialQuantifiers::ExistsExists)
        fail("no first answer");
      if (answer != nullptr && !legal) fail("a first answer to an illegal input");
      if (answer == nullptr) continue;
      some = true;
      const Values values = shown(*answer, input);
      if (!rules_.good_first(values)) fail("bad first answer");
      Values chosen = values;
      for (const auto& [name, value] : input) chosen.erase(name);
      answers.insert(chosen);
      node({answer->next, values, {}});
    }
    if (quantifiers == spec::InitialQuantifiers::ExistsExists && !some) fail("no first answer at all");
    if (quantifiers == spec::InitialQuantifiers::ExistsForall && answers.size() > 1)
      fail("the first answer changes");
  }

  void later_steps(std::size_t i) {
    const Node from = nodes_[i];
    std::set<Values> outputs;
    for (const Values& input : rules_.inputs()) {
      const auto* answer = row(from.state, input);
      const bool legal = rules_.legal(from.values, input);
      if (answer == nullptr && legal) fail("an input without answer");
      if (answer == nullptr || !legal) continue;
      const Values values = shown(*answer, input);
      Values output;
      for (const auto& o : rules_.spec().outputs) output[o.variable.name] = values.at(o.variable.name);
      outputs.insert(output);
      if (rules_.after(from.values, input, output) != values) fail("a memory is wrong");
      if (!rules_.good(from.values, values)) fail("a step is not allowed");
      const std::uint32_t to =
          node({answer->next, values, advance(rules_, from.counters, from.values, values)});
      edges_[i].push_back(to);
    }
    if (rules_.spec().timing == spec::Timing::Moore && outputs.size() > 1)
      fail("the answer follows the input");
  }

  /// A node of colour 1 that comes back to itself past colours 0 and 1 only.
  void bad_cycle() {
    for (std::uint32_t start = 0; start < nodes_.size(); ++start) {
      if (nodes_[start].counters.colour != 1) continue;
      std::vector<bool> seen(nodes_.size());
      std::vector<std::uint32_t> open{start};
      while (!open.empty()) {
        const std::uint32_t v = open.back();
        open.pop_back();
        for (const std::uint32_t w : edges_[v]) {
          if (w == start) return fail("assumptions are met for ever and goals are not");
          if (seen[w] || nodes_[w].counters.colour == 2) continue;
          seen[w] = true;
          open.push_back(w);
        }
      }
    }
  }

  const model::Mealy& machine_;
  const Rules& rules_;
  std::string fault_;
  std::map<Node, std::uint32_t> numbers_;
  std::vector<Node> nodes_;
  std::vector<std::vector<std::uint32_t>> edges_;
};

}  // namespace

std::string fault(const model::Mealy& machine, const Rules& rules) {
  return Verifier(machine, rules).run();
}

}  // namespace heed::reference
