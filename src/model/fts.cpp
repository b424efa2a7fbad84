#include <fmt/format.h>
#include <heed/model/fts.h>

#include <algorithm>
#include <set>

namespace heed::model {

std::vector<std::uint32_t> Fts::successors(std::uint32_t state, std::uint32_t action) const {
  std::vector<std::uint32_t> found;
  for (const Transition& transition : transitions)
    if (transition.from == state && transition.action == action) found.push_back(transition.to);
  std::sort(found.begin(), found.end());
  return found;
}

bool Fts::deterministic() const {
  std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
  return std::all_of(transitions.begin(), transitions.end(),
                     [&](const Transition& t) { return seen.emplace(t.from, t.action).second; });
}

std::string write_fts(const Fts& fts) {
  std::string out = "states:";
  for (const std::string& state : fts.states) out += ' ' + state;
  out += "\ninitial:";
  for (const std::uint32_t state : fts.initial) out += ' ' + fts.states[state];
  out += '\n';
  for (const auto& [label, holds] : fts.labels) {
    out += fmt::format("label {}:", label);
    for (std::size_t i = 0; i < holds.size(); ++i)
      if (holds[i]) out += ' ' + fts.states[i];
    out += '\n';
  }
  for (const auto& [value, numbers] : fts.values) {
    out += fmt::format("value {}:", value);
    for (std::size_t i = 0; i < numbers.size(); ++i) out += fmt::format(" {}={}", fts.states[i], numbers[i]);
    out += '\n';
  }
  for (const Fts::Transition& t : fts.transitions)
    out += fmt::format("{} -{}-> {}\n", fts.states[t.from], fts.actions[t.action], fts.states[t.to]);
  return out;
}

}  // namespace heed::model
