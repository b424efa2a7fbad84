#include "defeat.h"

#include <heed/logic/parse.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace heed::job {
namespace {

std::string clause_words(const spec::Clause& clause) {
  return clause.text.empty() ? logic::to_string(clause.formula) : clause.text;
}

/// What is true, and what has another value than "not known".
std::vector<std::string> shown(const game::Values& values) {
  std::vector<std::string> words;
  for (const auto& [name, value] : values) {
    if (name == spec::plant_state || value == "false" || value == "unknown") continue;
    words.push_back(value == "true" ? name : fmt::format("{} = {}", name, value));
  }
  return words;
}

/// "go (to M0) or slow_down (to S0)": the actions that the plant has in \p state.
std::string ways_out(const model::Fts& plant, const std::string& state) {
  constexpr std::size_t most = 6;
  const auto found = std::find(plant.states.begin(), plant.states.end(), state);
  if (found == plant.states.end()) return {};
  std::vector<std::string> ways;
  for (std::uint32_t a = 0; a < plant.actions.size(); ++a) {
    std::vector<std::string> to;
    for (const std::uint32_t next :
         plant.successors(static_cast<std::uint32_t>(found - plant.states.begin()), a))
      to.push_back(plant.states[next]);
    if (!to.empty()) ways.push_back(fmt::format("{} (to {})", plant.actions[a], fmt::join(to, ", ")));
  }
  if (ways.size() > most) {
    ways.resize(most);
    ways.emplace_back("...");
  }
  return fmt::format("{}", fmt::join(ways, " or "));
}

std::string quoted(const std::vector<std::string>& texts) {
  std::string out;
  for (const std::string& text : texts) out += fmt::format("{}'{}'", out.empty() ? "" : " and ", text);
  return out;
}

std::string without_answer(const World& world, const strategy::CounterPlay& counter) {
  const game::Turn& last = counter.turns.back();
  const std::string state = state_of(last);
  std::vector<std::string> broken;
  for (const spec::Clause& clause : counter.broken)
    if (clause.origin != spec::Origin::Plant) broken.push_back(clause_words(clause));
  std::string out =
      state.empty() ? std::string("There is no way out") : fmt::format("In {} there is no way out", state);
  out += fmt::format(" with {} in view: no action keeps {}", seen_words(last.observation),
                     broken.empty() ? "to what the plant can do" : quoted(broken));
  const std::string ways = ways_out(world.plant, state);
  if (!ways.empty()) out += fmt::format("; all the plant can do in {} is {}", state, ways);
  return out;
}

std::string out_of_reach(const strategy::CounterPlay& counter) {
  const std::string goal = clause_words(*counter.goal);
  const std::string state = state_of(counter.turns.back());
  std::vector<std::string> others;
  for (const std::string& reason : counter.reasons)
    if (reason != goal) others.push_back(reason);
  std::string out = fmt::format("'{}' can be kept from ever happening again", goal);
  if (!state.empty()) out += fmt::format(", from {} on", state);
  out += ", by what is perceived";
  if (!others.empty()) out += fmt::format(", while {} must be kept", quoted(others));
  return out;
}

/// "M4 sees nothing: go; M3 sees sign: slow_down", the whole play on one line.
std::string way_there(const strategy::CounterPlay& counter) {
  std::string out;
  for (const game::Turn& turn : counter.turns) {
    std::vector<std::string> where = shown(turn.memory);
    if (const std::string state = state_of(turn); !state.empty()) where.insert(where.begin(), state);
    std::vector<std::string> answer;
    for (const auto& [name, value] : turn.answer)
      answer.push_back(name == spec::plant_action ? value : fmt::format("{} = {}", name, value));
    out += fmt::format("{}{}{}sees {}: {}", out.empty() ? "" : "; ", fmt::join(where, ", "),
                       where.empty() ? "" : " ", seen_words(turn.observation),
                       answer.empty() ? "no answer" : fmt::format("{}", fmt::join(answer, ", ")));
  }
  return out;
}

}  // namespace

std::string seen_words(const game::Values& observation) {
  const std::vector<std::string> words = shown(observation);
  return words.empty() ? "nothing" : fmt::format("{}", fmt::join(words, ", "));
}

std::string state_of(const game::Turn& turn) {
  for (const auto* values : {&turn.memory, &turn.observation})
    for (const auto& [name, value] : *values)
      if (name == spec::plant_state) return value;
  return {};
}

std::vector<std::string> describe_defeat(const World& world, const strategy::CounterPlay& counter) {
  std::vector<std::string> sentences;
  if (!counter.turns.empty() && counter.goal)
    sentences.push_back(out_of_reach(counter));
  else if (!counter.turns.empty() && counter.turns.back().answer.empty())
    sentences.push_back(without_answer(world, counter));
  else
    sentences.push_back("The environment wins from: " + counter.losing_initial);
  if (counter.turns.size() > 1) sentences.push_back("How it comes to that: " + way_there(counter));
  if (!counter.reasons.empty())
    sentences.push_back("What cannot be kept together: " + quoted(counter.reasons));
  return sentences;
}

}  // namespace heed::job
