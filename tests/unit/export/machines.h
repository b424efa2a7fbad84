#pragma once

// Machines for the tests of this room, and what a machine does according to its definition, by maps instead
// of tables.

#include <heed/model/mealy.h>
#include <heed/util/random.h>

#include <algorithm>
#include <deque>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace heed::exporter::testing {

using model::Domain;
using model::Mealy;
using model::OutputRole;
using model::Valuation;
using model::Variable;

inline Variable boolean(const std::string& name, const std::string& comment = {}) {
  return {name, Domain::boolean(), comment, {}};
}
inline Variable integer(const std::string& name, std::int32_t low, std::int32_t high) {
  return {name, Domain::integer(low, high), {}, {}};
}
inline Variable enumeration(const std::string& name, std::vector<std::string> values) {
  return {name, Domain::enumeration(std::move(values)), {}, {}};
}
inline std::vector<std::string> numbered(const std::string& stem, std::size_t count) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count; ++i) names.push_back(stem + std::to_string(i));
  return names;
}

inline Valuation random_letter(const std::vector<Variable>& variables, util::CounterRandom& random) {
  Valuation letter;
  for (const Variable& variable : variables)
    letter.push_back(variable.domain.low + static_cast<std::int32_t>(random.below(
                                               static_cast<std::uint32_t>(variable.domain.size()))));
  return letter;
}

/// Every valuation of the variables' domains. \pre they are few
inline std::vector<Valuation> all_letters(const std::vector<Variable>& variables) {
  std::vector<Valuation> letters{{}};
  for (const Variable& variable : variables) {
    std::vector<Valuation> longer;
    for (const Valuation& letter : letters)
      for (std::int32_t value = variable.domain.low; value <= variable.domain.high; ++value) {
        longer.push_back(letter);
        longer.back().push_back(value);
      }
    letters = std::move(longer);
  }
  return letters;
}

struct Shape {
  std::string name;
  std::vector<Variable> inputs;
  std::vector<model::Output> outputs;
  std::uint32_t states = 1;
  std::size_t letters = 0;      ///< Drawn at random; 0: all of the domain.
  std::uint32_t missing = 0;    ///< Of 16 rows.
  std::uint32_t fallbacks = 0;  ///< Of 16 rows.
};

inline Mealy random_machine(const Shape& shape, std::uint64_t seed) {
  util::CounterRandom random(seed, 0);
  std::vector<Valuation> letters;
  if (shape.letters == 0) letters = all_letters(shape.inputs);
  for (std::size_t i = 0; i < shape.letters; ++i) letters.push_back(random_letter(shape.inputs, random));
  std::sort(letters.begin(), letters.end());
  letters.erase(std::unique(letters.begin(), letters.end()), letters.end());
  std::vector<Variable> columns;
  for (const model::Output& output : shape.outputs) columns.push_back(output.variable);
  model::MealyBuilder builder(shape.name, shape.inputs, shape.outputs);
  for (std::uint32_t s = 0; s < shape.states; ++s) builder.add_state();
  for (std::uint32_t s = 0; s < shape.states; ++s)
    for (const Valuation& letter : letters)
      if (random.below(16) >= shape.missing)
        builder.add(s, letter, random_letter(columns, random), random.below(shape.states),
                    random.below(16) < shape.fallbacks);
  return builder.finish();
}

/// A machine by its definition.
class Reference {
 public:
  struct Row {
    Valuation output;
    std::uint32_t next;
    bool fallback;
  };
  explicit Reference(const Mealy& machine) {
    for (std::uint32_t s = 0; s < machine.state_count(); ++s)
      for (std::uint32_t t = machine.first[s]; t < machine.first[s + 1]; ++t) {
        const Mealy::Transition& row = machine.transitions[t];
        rows_[{s, machine.input_letters[row.input]}] = {machine.output_letters[row.output], row.next,
                                                        row.fallback};
      }
  }
  [[nodiscard]] const Row* find(std::uint32_t state, const Valuation& observation) const {
    const auto found = rows_.find({state, observation});
    return found == rows_.end() ? nullptr : &found->second;
  }
  /// For each reachable state the observations that lead to it.
  [[nodiscard]] std::map<std::uint32_t, std::vector<Valuation>> words() const {
    std::map<std::uint32_t, std::vector<Valuation>> words{{0, {}}};
    for (std::deque<std::uint32_t> todo{0}; !todo.empty(); todo.pop_front())
      for (auto it = rows_.lower_bound({todo.front(), {}}); it != rows_.end(); ++it) {
        if (it->first.first != todo.front()) break;
        const auto [place, added] = words.emplace(it->second.next, words[todo.front()]);
        if (!added) continue;
        place->second.push_back(it->first.second);
        todo.push_back(it->second.next);
      }
    return words;
  }

 private:
  std::map<std::pair<std::uint32_t, Valuation>, Row> rows_;
};

}  // namespace heed::exporter::testing
