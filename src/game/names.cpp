#include "names.h"

#include <heed/logic/parse.h>

#include <fmt/format.h>

namespace heed::game {

std::string clause_text(const spec::Clause& clause) {
  return clause.text.empty() ? logic::to_string(clause.formula) : clause.text;
}

std::string goal_text(const spec::Clause& clause) {
  if (!clause.text.empty()) return clause.text;
  return logic::to_string(logic::always(logic::eventually(clause.formula)));
}

Values values_of(const Game& game, Owner owner, const std::vector<bool>& assignment) {
  Values values;
  for (const Encoded& variable : game.variables) {
    if (variable.owner != owner) continue;
    std::int64_t offset = 0;
    for (const bdd::Pair& pair : variable.bits) offset = 2 * offset + (assignment[pair.current] ? 1 : 0);
    const model::Domain& domain = variable.variable.domain;
    values.emplace_back(variable.variable.name, domain.print(static_cast<std::int32_t>(domain.low + offset)));
  }
  return values;
}

std::string values_text(const Game& game, Owner owner, const std::vector<bool>& assignment) {
  std::string text;
  for (const auto& [name, value] : values_of(game, owner, assignment))
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", name, value);
  return text.empty() ? "nothing" : text;
}

}  // namespace heed::game
