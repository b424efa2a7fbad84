#include <gtest/gtest.h>
#include <heed/util/random.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "truth.h"

/// Random traces of operations over six variables (three pairs), with collections, reorderings and new orders
/// at random points, compared after each step with bit arithmetic. A failing trace is shrunk to one from
/// which nothing can be left out.
namespace heed::bdd {
namespace {

using truth::Space;
using truth::Table;

enum class Op {
  And,
  Or,
  Xor,
  Ite,
  Exists,
  Forall,
  AndExists,
  ImpliesForall,
  Cofactor,
  Restrict,
  Constrain,
  Compose,
  Next,
  AndExistsNext,
  Copy,
  Forget,
  Transfer,
  Collect,
  Sift,
  Order
};
constexpr unsigned op_count = static_cast<unsigned>(Op::Order) + 1;
constexpr unsigned registers = 12;

struct Step {
  Op op;
  unsigned target, a, b, c;
};

std::string print(const std::vector<Step>& trace) {
  std::ostringstream out;
  for (const Step& s : trace)
    out << static_cast<int>(s.op) << ": r" << s.target << " <- " << s.a << ' ' << s.b << ' ' << s.c << '\n';
  return out.str();
}

class Machine {
 public:
  /// \param sabotage  Test of the test: this operation is modelled wrongly.
  explicit Machine(int sabotage = -1) : manager_(options()), sabotage_(sabotage) {
    for (int i = 0; i < 3; ++i) {
      const Pair pair = manager_.new_pair();
      map_.insert(map_.end(), {pair.current, pair.next});
    }
    for (unsigned i = 0; i < registers; ++i) {
      tables_.push_back(i < 6 ? space_.variable(i) : 0);
      diagrams_.push_back(i < 6 ? manager_.variable(map_[i]) : manager_.constant(false));
    }
  }

  /// \returns whether everything agrees after the step
  bool run(const Step& step) {
    if (static_cast<int>(step.op) <= static_cast<int>(Op::Forall)) {
      boolean(step);
    } else if (static_cast<int>(step.op) <= static_cast<int>(Op::AndExistsNext)) {
      relational(step);
    } else {
      manage(step);
    }
    if (static_cast<int>(step.op) == sabotage_) tables_[step.target] ^= 1U;
    return read(diagrams_[step.target], space_, map_) == tables_[step.target];
  }

  bool check_all() {
    for (unsigned i = 0; i < registers; ++i) {
      if (read(diagrams_[i], space_, map_) != tables_[i]) return false;
      for (unsigned j = 0; j < i; ++j) {
        if ((diagrams_[i] == diagrams_[j]) != (tables_[i] == tables_[j])) return false;
      }
    }
    return manager_.consistent();
  }

 private:
  static ManagerOptions options() {
    ManagerOptions small;
    small.initial_nodes = 16;
    small.first_reordering = 24;
    small.steps_per_reordering = 1;
    return small;
  }
  Bdd cube(unsigned set) {
    std::vector<Var> chosen;
    for (unsigned i = 0; i < 6; ++i) {
      if (((set >> i) & 1U) != 0) chosen.push_back(map_[i]);
    }
    return manager_.cube(chosen);
  }
  void set(const Step& s, Table table, Bdd diagram) {
    tables_[s.target] = table;
    diagrams_[s.target] = std::move(diagram);
  }

  void boolean(const Step& s) {
    const Table f = tables_[s.a % registers], g = tables_[s.b % registers], h = tables_[s.c % registers];
    const Bdd a = diagrams_[s.a % registers], b = diagrams_[s.b % registers], c = diagrams_[s.c % registers];
    const unsigned quantified = s.b % 64;
    if (s.op == Op::And) set(s, f & g, a & b);
    if (s.op == Op::Or) set(s, f | g, a | b);
    if (s.op == Op::Xor) set(s, f ^ g, a ^ !b ^ b ^ !b);
    if (s.op == Op::Ite) set(s, space_.ite(f, g, h), a.ite(b, c));
    if (s.op == Op::Exists) set(s, space_.exists(f, quantified), a.exists(cube(quantified)));
    if (s.op == Op::Forall) set(s, space_.forall(f, quantified), a.forall(cube(quantified)));
  }

  void relational(const Step& s) {
    const Table f = tables_[s.a % registers], g = tables_[s.b % registers];
    const Bdd a = diagrams_[s.a % registers], b = diagrams_[s.b % registers];
    const unsigned quantified = s.c % 64, variable = s.c % 6;
    if (s.op == Op::AndExists) set(s, space_.exists(f & g, quantified), a.and_exists(b, cube(quantified)));
    if (s.op == Op::ImpliesForall)
      set(s, space_.forall(space_.complement(f) | g, quantified), a.implies_forall(b, cube(quantified)));
    if (s.op == Op::Cofactor)
      set(s, space_.cofactor(f, variable, s.b % 2 != 0), a.cofactor(map_[variable], s.b % 2 != 0));
    // What these do outside the care set is theirs to choose; inside it is compared.
    if (s.op == Op::Restrict) set(s, f & g, a.restrict(b) & b);
    if (s.op == Op::Constrain) set(s, f & g, a.constrain(b) & b);
    if (s.op == Op::Compose) compose(s);
    if (s.op == Op::Next) set(s, shifted(f), a.exists(cube(0b101010)).next());
    if (s.op == Op::AndExistsNext)
      set(s, space_.exists(g & shifted(f), quantified),
          b.and_exists_next(a.exists(cube(0b101010)), cube(quantified)));
  }

  [[nodiscard]] Table shifted(Table f) const {
    std::vector<Table> functions;
    for (unsigned i = 0; i < 6; ++i) functions.push_back(space_.variable(i | 1U));
    return space_.compose(space_.exists(f, 0b101010), functions);
  }

  void compose(const Step& s) {
    std::vector<Table> functions;
    std::vector<std::pair<Var, Bdd>> substitution;
    for (unsigned i = 0; i < 6; ++i) {
      const unsigned from = (s.b + i * s.c) % registers;
      const bool replaced = (s.c >> i) % 2 != 0;
      functions.push_back(replaced ? tables_[from] : space_.variable(i));
      if (replaced) substitution.emplace_back(map_[i], diagrams_[from]);
    }
    const Table table = space_.compose(tables_[s.a % registers], functions);
    set(s, table, diagrams_[s.a % registers].compose(substitution));
  }

  void manage(const Step& s) {
    if (s.op == Op::Copy) set(s, tables_[s.a % registers], diagrams_[s.a % registers]);
    if (s.op == Op::Forget) set(s, space_.variable(s.a % 6), manager_.variable(map_[s.a % 6]));
    if (s.op == Op::Collect) manager_.collect_garbage();
    if (s.op == Op::Sift) manager_.sift({.max_growth = 1.0 + 0.1 * (s.a % 5), .until_no_gain = s.b % 2 != 0});
    if (s.op == Op::Order) {
      std::vector<unsigned> pairs = {0, 1, 2};
      for (unsigned i = 0; i < s.a % 6; ++i) std::next_permutation(pairs.begin(), pairs.end());
      std::vector<Var> order;
      for (const unsigned p : pairs) order.insert(order.end(), {map_[2 * p], map_[2 * p + 1]});
      manager_.set_order(order);
    }
    if (s.op == Op::Transfer) {
      Manager other;
      for (int i = 0; i < 3; ++i) other.new_pair();
      set(s, tables_[s.a % registers], manager_.transfer(other.transfer(diagrams_[s.a % registers])));
    }
  }

  Space space_{6};
  Manager manager_;
  std::vector<Var> map_;
  std::vector<Table> tables_;
  std::vector<Bdd> diagrams_;
  int sabotage_;
};

bool passes(const std::vector<Step>& trace, int sabotage = -1) {
  Machine machine(sabotage);
  for (const Step& step : trace) {
    if (!machine.run(step)) return false;
  }
  return machine.check_all();
}

std::vector<Step> shrink(std::vector<Step> trace, int sabotage = -1) {
  for (std::size_t chunk = trace.size() / 2; chunk > 0;) {
    bool shorter = false;
    for (std::size_t at = 0; at + chunk <= trace.size();) {
      std::vector<Step> candidate = trace;
      candidate.erase(candidate.begin() + at, candidate.begin() + at + chunk);
      if (passes(candidate, sabotage)) {
        at += chunk;
      } else {
        trace = std::move(candidate);
        shorter = true;
      }
    }
    if (!shorter || chunk > trace.size()) chunk /= 2;
  }
  return trace;
}

std::vector<Step> random_trace(std::uint64_t seed, std::size_t length) {
  util::CounterRandom random(977, seed);
  std::vector<Step> trace;
  for (std::size_t i = 0; i < length; ++i) {
    // The last three cost more than the others and need not come as often.
    const unsigned op = random.below(op_count - (random.below(4) == 0 ? 0 : 3));
    trace.push_back(
        {static_cast<Op>(op), random.below(registers), random.below(64), random.below(64), random.below(64)});
  }
  return trace;
}

TEST(Trace, RandomOperationsAgreeWithTruthTables) {
  const std::uint64_t traces = std::getenv("HEED_SLOW") != nullptr ? 20'000 : 500;
  for (std::uint64_t seed = 0; seed < traces; ++seed) {
    const std::vector<Step> trace = random_trace(seed, 200);
    if (!passes(trace)) FAIL() << "seed " << seed << " shrunk to\n" << print(shrink(trace));
  }
}

TEST(Trace, ShrinkingFindsTheOneWrongStep) {
  const int wrong = static_cast<int>(Op::Constrain);
  const std::vector<Step> trace = random_trace(1, 200);
  ASSERT_FALSE(passes(trace, wrong));
  const std::vector<Step> small = shrink(trace, wrong);
  ASSERT_EQ(small.size(), 1U) << print(small);
  EXPECT_EQ(small.front().op, Op::Constrain);
}

}  // namespace
}  // namespace heed::bdd
