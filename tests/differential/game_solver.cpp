#include "game_parity.h"
#include "game_reference.h"

#include <algorithm>
#include <tuple>

namespace heed::reference {
namespace {

constexpr std::uint32_t lost = 0;
constexpr std::uint32_t won = 1;

/// The parity game that can be reached from good first states. Whoever cannot move has lost.
class Explorer {
 public:
  explicit Explorer(const Rules& rules) : rules_(rules), moore_(rules.spec().timing == spec::Timing::Moore) {
    game_.positions.push_back({false, 1, {lost}});
    game_.positions.push_back({false, 2, {won}});
  }

  std::uint32_t position(const Values& state, const Counters& counters) {
    const auto [found, added] =
        numbers_.emplace(std::tuple(state, counters), static_cast<std::uint32_t>(game_.positions.size()));
    if (added) {
      game_.positions.push_back({moore_, counters.colour, {}});
      open_.push_back({found->second, state, counters});
    }
    return found->second;
  }

  ParityGame explore() {
    while (!open_.empty()) {
      const Open from = open_.back();
      open_.pop_back();
      std::vector<std::uint32_t> successors = moore_ ? moore(from) : mealy(from);
      game_.positions[from.number].successors = std::move(successors);
    }
    return std::move(game_);
  }

 private:
  struct Open {
    std::uint32_t number;
    Values state;
    Counters counters;
  };

  std::uint32_t add(bool system, std::vector<std::uint32_t> successors) {
    game_.positions.push_back({system, 0, std::move(successors)});
    return static_cast<std::uint32_t>(game_.positions.size() - 1);
  }

  std::uint32_t step(const Open& from, const Values& input, const Values& output) {
    const Values next = rules_.after(from.state, input, output);
    if (!rules_.good(from.state, next)) return lost;
    return position(next, advance(rules_, from.counters, from.state, next));
  }

  std::vector<std::uint32_t> mealy(const Open& from) {
    std::vector<std::uint32_t> moves;
    for (const Values& input : rules_.inputs()) {
      if (!rules_.legal(from.state, input)) continue;
      std::vector<std::uint32_t> answers;
      for (const Values& output : rules_.outputs()) answers.push_back(step(from, input, output));
      moves.push_back(add(true, std::move(answers)));
    }
    if (moves.empty()) moves.push_back(won);
    return moves;
  }

  std::vector<std::uint32_t> moore(const Open& from) {
    std::vector<std::uint32_t> answers;
    for (const Values& output : rules_.outputs()) {
      std::vector<std::uint32_t> moves;
      for (const Values& input : rules_.inputs())
        if (rules_.legal(from.state, input)) moves.push_back(step(from, input, output));
      if (moves.empty()) return {won};
      answers.push_back(add(false, std::move(moves)));
    }
    return answers;
  }

  const Rules& rules_;
  bool moore_;
  ParityGame game_;
  std::map<std::tuple<Values, Counters>, std::uint32_t> numbers_;
  std::vector<Open> open_;
};

struct First {
  bool good = false;
  std::uint32_t position = lost;
};

/// Rows: legal first inputs. Columns: outputs and initial memories.
using Firsts = std::vector<std::vector<First>>;

bool start_is_won(const Firsts& firsts, spec::InitialQuantifiers quantifiers, const std::vector<bool>& wins) {
  const auto row_wins = [&](const std::vector<First>& row) {
    return std::any_of(row.begin(), row.end(), [&](const First& f) { return f.good && wins[f.position]; });
  };
  switch (quantifiers) {
    case spec::InitialQuantifiers::ForallExists:
      return std::all_of(firsts.begin(), firsts.end(), row_wins);
    case spec::InitialQuantifiers::ExistsExists:
      return std::any_of(firsts.begin(), firsts.end(), row_wins);
    case spec::InitialQuantifiers::ForallForall:
      return std::all_of(firsts.begin(), firsts.end(), [&](const auto& row) {
        return row_wins(row) && std::all_of(row.begin(), row.end(),
                                            [&](const First& f) { return !f.good || wins[f.position]; });
      });
    default:
      break;
  }
  if (firsts.empty()) return true;
  for (std::size_t column = 0; column < firsts.front().size(); ++column)
    if (std::all_of(firsts.begin(), firsts.end(),
                    [&](const auto& row) { return row[column].good && wins[row[column].position]; }))
      return true;
  return false;
}

}  // namespace

bool realizable(const Rules& rules) {
  Explorer explorer(rules);
  Firsts firsts;
  for (const Values& input : rules.inputs()) {
    if (!rules.legal_first(input)) continue;
    firsts.emplace_back();
    for (const Values& output : rules.outputs())
      for (const Values& memory : rules.memories()) {
        Values state = input;
        state.insert(output.begin(), output.end());
        state.insert(memory.begin(), memory.end());
        const bool good = rules.good_first(state);
        firsts.back().push_back({good, good ? explorer.position(state, {}) : lost});
      }
  }
  return start_is_won(firsts, rules.spec().initial, winning(explorer.explore()));
}

}  // namespace heed::reference
