// Random small specifications, machines made for them and mutations of those machines, judged by
// check::verify() and by a naive enumeration of the whole product with full valuations. The two must agree on
// every machine.
#include <heed/check/verify.h>
#include <heed/logic/parse.h>
#include <heed/spec/text.h>
#include <heed/util/random.h>

#include "unit/check/replay.h"

#include <gtest/gtest.h>

#include <optional>
#include <set>

namespace heed::check {
namespace {

using logic::Formula;
using naive::Evaluator;
using naive::Step;
using Random = util::CounterRandom;

std::string pick(Random& random, const std::vector<std::string>& from) {
  return from[random.below(static_cast<std::uint32_t>(from.size()))];
}

std::string formula(Random& random, const std::vector<std::string>& atoms, unsigned depth) {
  if (depth == 0) return (random.below(3) == 0 ? "!(" : "(") + pick(random, atoms) + ")";
  const std::string left = formula(random, atoms, depth - 1), right = formula(random, atoms, depth - 1);
  return "(" + left + pick(random, {" & ", " | ", " | ", " -> ", " <-> "}) + right + ")";
}

std::string random_spec(Random& random) {
  const std::vector<std::string> inputs{"a", "b = 0", "b > 1", "b != 1"};
  std::vector<std::string> early = inputs, now, env_step, sys_step;
  early.insert(early.end(), {"m", "k = y1", "e"});
  now = early;
  now.insert(now.end(), {"y = s", "y != t", "d"});
  env_step = now;
  env_step.insert(env_step.end(), {"a'", "b' = 0", "b' < b", "b' = b", "X (a | b = 1)"});
  sys_step = env_step;
  sys_step.insert(sys_step.end(), {"y' = s", "y' = y", "m'", "d'", "X (k != y1)"});
  std::string out = random.below(4) == 0
                        ? "[options]\ninitial = " + pick(random, {"exists-exists", "exists-forall"}) + "\n"
                        : "";
  out += "[input]\na : boolean\nb : 0..2\n[output]\ny : {s, t}\n[memory]\n";
  out += "m : boolean = " + pick(random, {"true", "false"}) + "\nm' = " + formula(random, env_step, 1) + "\n";
  out += random.below(3) == 0 ? "@plant k : {y0, y1} = y0, y1\n" : "k : {y0, y1} = y0\n";
  out += "k' = y1 when " + formula(random, random.below(2) == 0 ? now : env_step, 1) + "\n";
  out += "k' = y0 when " + formula(random, now, 0) + "\n";
  out += "[define]\ne := " + formula(random, {"a", "b = 0", "m"}, 1) +
         "\nd := " + formula(random, {"a", "y = s", "e", "k = y0"}, 1) + "\n";
  const auto section = [&](const char* name, const std::vector<std::string>& atoms, unsigned most,
                           unsigned depth) {
    out += std::string("[") + name + "]\n";
    for (unsigned i = random.below(most + 1); i > 0; --i) out += formula(random, atoms, depth) + "\n";
  };
  section("env init", inputs, 1, 1);
  section("env safety", random.below(4) == 0 ? now : early, 1, 1);
  section("env safety", env_step, 1, 2);
  section("env justice", env_step, 2, 1);
  section("sys init", now, 1, 1);
  section("sys safety", sys_step, 2, 2);
  section("sys justice", sys_step, 2, 1);
  return out;
}

/// The game as the definitions say it, nothing compiled and nothing shared with the code under test.
class Game {
 public:
  explicit Game(const spec::Gr1& spec) : spec_(spec), holds_(spec) {
    for (const auto& d : spec.definitions)
      if (mentions(d.formula, chosen_)) chosen_.insert(d.name);
  }

  [[nodiscard]] const spec::Gr1& spec() const { return spec_; }
  [[nodiscard]] bool holds(const Formula& f, const Step& now, const Step& next) const {
    return holds_(f, now, next) != 0;
  }

  static bool mentions(const Formula& f, const std::set<std::string>& names) {
    if (f.op() == logic::Op::Name) return names.count(f.name()) != 0;
    return std::any_of(f.operands().begin(), f.operands().end(),
                       [&](const auto& g) { return mentions(g, names); });
  }
  /// Memories and definitions, as far as the given values of the step determine them.
  void derive(const Step* last, Step& step, std::optional<std::int64_t> start) const {
    for (const auto& m : spec_.memories) {
      std::int64_t& value = step[m.variable.name];
      if (!last) {
        value = m.initial.size() > 1 ? start.value_or(m.initial[0]) : m.initial[0];
      } else if (m.cases.empty()) {
        value = holds(m.update, *last, step) ? 1 : 0;
      } else {
        const auto c = std::find_if(m.cases.begin(), m.cases.end(),
                                    [&](const auto& each) { return holds(each.guard, *last, step); });
        value = c != m.cases.end() ? c->value : last->at(m.variable.name);
      }
    }
    for (const auto& d : spec_.definitions) step[d.name] = holds(d.formula, step, step) ? 1 : 0;
  }

  /// Whether the environment may give these inputs; clauses over what the system chooses in this step are not
  /// asked.
  [[nodiscard]] bool legal(const Step* last, Step step) const {
    step["y"] = 0;
    derive(last, step, std::nullopt);
    for (const auto& c : spec_.env_init)
      if (!last && !holds(c.formula, step, step)) return false;
    for (const auto& c : spec_.env_safety)
      if (naive::steps(c.formula) && last && !holds(c.formula, *last, step)) return false;
    if (last) return assumed(step);
    const auto& starts = spec_.memories[1].initial;
    return std::any_of(starts.begin(), starts.end(), [&](std::int32_t start) {
      derive(last, step, start);
      return assumed(step);
    });
  }
  /// The assumptions on one step that the system's outputs have no part in.
  [[nodiscard]] bool assumed(const Step& step) const {
    return std::all_of(spec_.env_safety.begin(), spec_.env_safety.end(), [&](const auto& c) {
      return naive::steps(c.formula) || late(c.formula) || holds(c.formula, step, step);
    });
  }
  [[nodiscard]] bool late(const Formula& f) const { return mentions(f, chosen_); }

  /// The system keeps its part in this step.
  [[nodiscard]] bool kept(const Step* last, const Step& step) const {
    for (const auto& c : spec_.sys_init)
      if (!last && !holds(c.formula, step, step)) return false;
    for (const auto& c : spec_.sys_safety)
      if (naive::steps(c.formula) ? last && !holds(c.formula, *last, step) : !holds(c.formula, step, step))
        return false;
    return true;
  }
  /// The system's answer made an assumption fail.
  [[nodiscard]] bool over(const Step& step) const {
    for (const auto& c : spec_.env_safety)
      if (!naive::steps(c.formula) && late(c.formula) && !holds(c.formula, step, step)) return true;
    return false;
  }

 private:
  const spec::Gr1& spec_;
  Evaluator holds_;
  std::set<std::string> chosen_{"y"};  ///< What depends on the system's outputs.
};

const std::vector<Step>& letters() {
  static const std::vector<Step> all = [] {
    std::vector<Step> out;
    for (std::int64_t a = 0; a < 2; ++a)
      for (std::int64_t b = 0; b < 3; ++b) out.push_back({{"a", a}, {"b", b}});
    return out;
  }();
  return all;
}

/// A machine under mutation: rows as plain values.
struct Rows {
  struct Row {
    Step step;
    std::uint32_t next = 0;
  };
  std::vector<std::map<std::size_t, Row>> states;  ///< By index into letters().
};

/// Remembers the whole last step and answers at random, but keeps the system's safety where it can: often
/// right.
Rows greedy(const Game& game, Random& random) {
  Rows out;
  std::map<Step, std::uint32_t> index;
  std::vector<Step> seen{{}};
  out.states.emplace_back();
  const std::int64_t y = random.below(2), start = random.below(2);
  for (std::uint32_t s = 0; s < seen.size(); ++s)
    for (std::size_t l = 0; l < letters().size(); ++l) {
      const Step last = seen[s];
      const Step* before = s == 0 ? nullptr : &last;
      std::vector<Step> good, all;
      for (std::int64_t choice = 0; choice < 2; ++choice) {
        Step step = letters()[l];
        step["y"] = s == 0 ? y : choice;
        game.derive(before, step, start);
        all.push_back(step);
        if (game.kept(before, step)) good.push_back(step);
      }
      const auto& from = good.empty() ? all : good;
      const Step step = from[random.below(static_cast<std::uint32_t>(from.size()))];
      const auto [at, fresh] = index.emplace(step, static_cast<std::uint32_t>(seen.size()));
      if (fresh) {
        seen.push_back(step);
        out.states.emplace_back();
      }
      out.states[s][l] = {step, at->second};
    }
  return out;
}

void mutate(Rows& rows, Random& random) {
  const std::uint32_t s = random.below(static_cast<std::uint32_t>(rows.states.size()));
  if (rows.states[s].empty()) return;
  auto at = rows.states[s].begin();
  std::advance(at, random.below(static_cast<std::uint32_t>(rows.states[s].size())));
  const std::vector<std::string> columns{"y", "y", "m", "k", "d", "e"};
  switch (random.below(4)) {
    case 0:
      rows.states[s].erase(at);
      break;
    case 1:
      at->second.next = random.below(static_cast<std::uint32_t>(rows.states.size()));
      break;
    default:
      at->second.step[pick(random, columns)] ^= 1;
  }
}

/// The truth, by enumeration of (machine state, last step).
class Judge {
 public:
  Judge(const Game& game, const Rows& rows) : game_(game), rows_(rows) {}

  bool right() {
    nodes_.push_back({0, {}});
    index_[{0, {}}] = 0;
    for (std::size_t n = 0; n < nodes_.size(); ++n)
      if (!expand(n)) return false;
    for (const auto& justice : game_.spec().sys_justice)
      if (unfair(justice.formula)) return false;
    return true;
  }

 private:
  using Node = std::pair<std::uint32_t, Step>;
  struct Edge {
    std::size_t from, to;
  };

  bool expand(std::size_t n) {
    const Node node = nodes_[n];
    const Step* last = n == 0 ? nullptr : &node.second;
    const bool free_start = n == 0 && game_.spec().initial == spec::InitialQuantifiers::ExistsExists;
    bool any = false, answered = false;
    std::set<std::pair<std::int64_t, std::int64_t>> answers;
    for (std::size_t l = 0; l < letters().size(); ++l) {
      if (!game_.legal(last, letters()[l])) continue;
      any = true;
      const auto row = rows_.states[node.first].find(l);
      if (row == rows_.states[node.first].end() && !free_start) return false;
      if (row == rows_.states[node.first].end()) continue;
      answered = true;
      const Step& step = row->second.step;
      answers.insert({step.at("y"), step.at("k")});
      if (!columns_right(last, step) || !game_.kept(last, step)) return false;
      if (n == 0 && !game_.assumed(step)) return false;
      if (!game_.over(step)) connect(n, {row->second.next, step});
    }
    if (n == 0 && game_.spec().initial == spec::InitialQuantifiers::ExistsForall && answers.size() > 1)
      return false;
    return answered || !any;
  }

  [[nodiscard]] bool columns_right(const Step* last, const Step& step) const {
    Step derived = step;
    game_.derive(last, derived, step.at("k"));
    return derived == step && step.at("k") >= 0 && step.at("k") <= 1;
  }

  void connect(std::size_t from, const Node& to) {
    const auto [at, fresh] = index_.emplace(to, nodes_.size());
    if (fresh) nodes_.push_back(to);
    edges_.push_back({from, at->second});
  }

  [[nodiscard]] bool met(const Formula& justice, const Edge& edge) const {
    const Step& now = nodes_[edge.from].second;
    const Step& next = nodes_[edge.to].second;
    if (naive::steps(justice)) return edge.from != 0 && game_.holds(justice, now, next);
    return game_.holds(justice, next, next);
  }

  /// Transitive closure of the edges without the justice, then every mutually reachable set by itself.
  [[nodiscard]] bool unfair(const Formula& justice) const {
    std::vector<Edge> left;
    for (const Edge& edge : edges_)
      if (!met(justice, edge)) left.push_back(edge);
    const std::size_t n = nodes_.size();
    std::vector<std::vector<bool>> reach(n, std::vector<bool>(n));
    for (const Edge& edge : left) reach[edge.from][edge.to] = true;
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; reach[i][k] && j < n; ++j) reach[i][j] = reach[i][j] || reach[k][j];
    for (std::size_t u = 0; u < n; ++u) {
      if (!reach[u][u]) continue;
      const auto within = [&](std::size_t v) { return reach[u][v] && reach[v][u]; };
      const auto assumed = [&](const spec::Clause& c) {
        return std::any_of(left.begin(), left.end(), [&](const Edge& e) {
          return within(e.from) && within(e.to) && met(c.formula, e);
        });
      };
      const auto& assumptions = game_.spec().env_justice;
      if (std::all_of(assumptions.begin(), assumptions.end(), assumed)) return true;
    }
    return false;
  }

  const Game& game_;
  const Rows& rows_;
  std::vector<Node> nodes_;
  std::map<Node, std::size_t> index_;
  std::vector<Edge> edges_;
};

model::Mealy build(const spec::Gr1& spec, const Rows& rows) {
  const auto columns = spec::controller_outputs(spec);
  model::MealyBuilder builder("random", spec.inputs, columns);
  for (std::size_t s = 0; s < rows.states.size(); ++s) builder.add_state();
  for (std::uint32_t s = 0; s < rows.states.size(); ++s)
    for (const auto& [letter, row] : rows.states[s]) {
      model::Valuation output;
      for (const auto& column : columns)
        output.push_back(static_cast<std::int32_t>(row.step.at(column.variable.name)));
      const Step& input = letters()[letter];
      builder.add(s, {static_cast<std::int32_t>(input.at("a")), static_cast<std::int32_t>(input.at("b"))},
                  output, row.next);
    }
  return builder.finish();
}

struct Count {
  std::uint64_t right = 0, wrong = 0;
  std::map<Refutation::Kind, std::uint64_t> kinds;
};

void compare(const Game& game, const Rows& rows, Count& count) {
  const model::Mealy machine = build(game.spec(), rows);
  util::Budget budget;
  const Verdict verdict = verify(machine, game.spec(), budget);
  const bool right = Judge(game, rows).right();
  ASSERT_EQ(verdict.verified, right) << (right ? verdict.refutations[0].message + ": " +
                                                     verdict.refutations[0].clause
                                               : "a wrong machine passed");
  ++(right ? count.right : count.wrong);
  if (right) return;
  const Refutation& refutation = verdict.refutations.at(0);
  ++count.kinds[refutation.kind];
  if (!refutation.trace.empty() && !refutation.trace[0].input.empty())
    naive::replay(machine, game.spec(), refutation);
}

TEST(Random, verdicts_agree_with_enumeration) {
  Count count;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Random random(2024, seed);
    const std::string text = random_spec(random);
    SCOPED_TRACE(text);
    const spec::Gr1 spec = spec::read_gr1(util::SourceText("random.gr1", text));
    const Game game(spec);
    const Rows rows = greedy(game, random);
    ASSERT_NO_FATAL_FAILURE(compare(game, rows, count));
    for (int i = 0; i < 5; ++i) {
      Rows mutant = rows;
      for (unsigned k = random.below(2) + 1; k > 0; --k) mutate(mutant, random);
      ASSERT_NO_FATAL_FAILURE(compare(game, mutant, count));
      if (testing::Test::HasFailure()) return;
    }
  }
  RecordProperty("right", static_cast<int>(count.right));
  RecordProperty("wrong", static_cast<int>(count.wrong));
  std::cout << "right " << count.right << ", wrong " << count.wrong << '\n';
  EXPECT_GT(count.right, 300U);
  EXPECT_GT(count.wrong, 300U);
  EXPECT_EQ(count.kinds.size(), 5U);
}

}  // namespace
}  // namespace heed::check
