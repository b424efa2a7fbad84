#include <bdd.h>
#include <benchmark/benchmark.h>
#include <heed/bdd/bdd.h>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <map>
#include <string>
#include <vector>

/// heed's decision diagrams beside BuDDy's on the usual workloads, in one process, with a table of ratios.
/// Both are given a fixed order, a million nodes, a quarter as many places for results, which grow along, and
/// start from nothing in each iteration; CPU time, with the set-up left out (BuDDy's tables take tens of
/// milliseconds to clear; heed's nodes are touched when they are used). BuDDy also gets unbounded growth, and
/// has a cache for each kind of operation. Where an engine does in one operation what another does in two,
/// each does what it can.
namespace {

struct Outcome {
  double figure;   ///< The same for both engines.
  double seconds;  ///< CPU time since the engine was set up.
};

class Watch {
 public:
  Watch() : start_(std::clock()) {}
  [[nodiscard]] Outcome outcome(double figure) const {
    return {figure, static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC};
  }

 private:
  std::clock_t start_;
};

class Heed {
 public:
  using Function = heed::bdd::Bdd;
  static constexpr const char* name = "heed";

  /// \param pairs  Adjacent variables 2i, 2i + 1 become current and next.
  Heed(int variables, bool pairs) : manager_(options()) {
    if (pairs) {
      for (int i = 0; i < variables / 2; ++i) manager_.new_pair();
    } else {
      for (int i = 0; i < variables; ++i) manager_.new_variable();
    }
  }
  Function constant(bool value) { return manager_.constant(value); }
  Function variable(int i) { return manager_.variable(static_cast<heed::bdd::Var>(i)); }
  Function cube(const std::vector<int>& variables) {
    const std::vector<heed::bdd::Var> chosen(variables.begin(), variables.end());
    return manager_.cube(chosen);
  }
  Function ite(const Function& f, const Function& g, const Function& h) { return f.ite(g, h); }
  Function and_exists(const Function& f, const Function& g, const Function& cube) {
    return f.and_exists(g, cube);
  }
  Function and_exists_next(const Function& f, const Function& g, const Function& cube) {
    return f.and_exists_next(g, cube);
  }
  Function to_current(const Function& f) { return f.current(); }
  double count(const Function& f) { return f.count(manager_.variable_count()); }

 private:
  static heed::bdd::ManagerOptions options() {
    heed::bdd::ManagerOptions fixed;
    fixed.automatic_reordering = false;
    fixed.initial_nodes = 1'000'000;
    fixed.initial_cache_bytes = 250'000 * 16;
    return fixed;
  }
  heed::bdd::Manager manager_;
};

class Buddy {
 public:
  using Function = ::bdd;
  static constexpr const char* name = "BuDDy";

  Buddy(int variables, bool pairs) {
    bdd_init(1'000'000, 250'000);
    bdd_setcacheratio(4);
    bdd_setmaxincrease(50'000'000);
    bdd_gbc_hook(nullptr);
    bdd_setvarnum(variables);
    if (!pairs) return;
    to_current_ = bdd_newpair();
    to_next_ = bdd_newpair();
    for (int i = 0; i < variables; i += 2) {
      bdd_setpair(to_current_, i + 1, i);
      bdd_setpair(to_next_, i, i + 1);
    }
  }
  ~Buddy() { bdd_done(); }
  Function constant(bool value) { return value ? bddtrue : bddfalse; }
  Function variable(int i) { return bdd_ithvar(i); }
  Function cube(std::vector<int> variables) {
    return bdd_makeset(variables.data(), static_cast<int>(variables.size()));
  }
  Function ite(const Function& f, const Function& g, const Function& h) { return bdd_ite(f, g, h); }
  Function and_exists(const Function& f, const Function& g, const Function& cube) {
    return bdd_appex(f, g, bddop_and, cube);
  }
  Function and_exists_next(const Function& f, const Function& g, const Function& cube) {
    return bdd_appex(f, bdd_replace(g, to_next_), bddop_and, cube);
  }
  Function to_current(const Function& f) { return bdd_replace(f, to_current_); }
  double count(const Function& f) { return bdd_satcount(f); }

 private:
  bddPair* to_current_ = nullptr;
  bddPair* to_next_ = nullptr;
};

template <typename Engine>
typename Engine::Function majority(const typename Engine::Function& a, const typename Engine::Function& b,
                                   const typename Engine::Function& c) {
  return (a & b) | (a & c) | (b & c);
}

template <typename Engine>
Outcome queens(int n) {
  Engine engine(n * n, false);
  const Watch watch;
  auto all = engine.constant(true);
  for (int row = 0; row < n; ++row) {
    auto some = engine.constant(false);
    for (int column = 0; column < n; ++column) some |= engine.variable(row * n + column);
    all &= some;
  }
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      auto alone = engine.constant(true);
      for (int r = 0; r < n; ++r) {
        for (int c = 0; c < n; ++c) {
          const bool same = r == row && c == column;
          if (!same && (r == row || c == column || r + c == row + column || r - c == row - column))
            alone &= !engine.variable(r * n + c);
        }
      }
      all &= (!engine.variable(row * n + column)) | alone;
    }
  }
  return watch.outcome(engine.count(all));
}

/// All sums of a ripple-carry adder whose operands stand one after the other in the order (the exponential
/// case).
template <typename Engine>
Outcome adder(int n) {
  Engine engine(2 * n, false);
  const Watch watch;
  auto carry = engine.constant(false);
  double total = 0;
  for (int i = 0; i < n; ++i) {
    const auto a = engine.variable(n - 1 - i), b = engine.variable(2 * n - 1 - i);
    total += engine.count(a ^ b ^ carry);
    carry = majority<Engine>(a, b, carry);
  }
  return watch.outcome(total + engine.count(carry));
}

/// All products of an array multiplier, operands interleaved.
template <typename Engine>
Outcome multiplier(int n) {
  Engine engine(2 * n, false);
  const Watch watch;
  std::vector<typename Engine::Function> sum(2 * n, engine.constant(false));
  for (int i = 0; i < n; ++i) {
    auto carry = engine.constant(false);
    for (int j = 0; j < n; ++j) {
      const auto partial = engine.variable(2 * i) & engine.variable(2 * j + 1);
      const auto old = sum[i + j];
      sum[i + j] = old ^ partial ^ carry;
      carry = majority<Engine>(old, partial, carry);
    }
    sum[i + n] = carry;
  }
  double total = 0;
  for (const auto& f : sum) total += engine.count(f);
  return watch.outcome(total);
}

/// x[w] where w is the number of true variables; false where w = 0.
template <typename Engine>
Outcome hidden_weighted_bit(int n) {
  Engine engine(n, false);
  const Watch watch;
  std::vector<typename Engine::Function> weight(n + 1, engine.constant(false));
  weight[0] = engine.constant(true);
  for (int i = 0; i < n; ++i) {
    for (int w = i + 1; w >= 0; --w)
      weight[w] = engine.ite(engine.variable(i), w > 0 ? weight[w - 1] : engine.constant(false), weight[w]);
  }
  auto f = engine.constant(false);
  for (int w = 1; w <= n; ++w) f |= weight[w] & engine.variable(w - 1);
  return watch.outcome(engine.count(f));
}

template <typename Engine>
struct System {
  typename Engine::Function initial, relation;
};

template <typename Engine>
double reachable(Engine& engine, const System<Engine>& system, int bits) {
  std::vector<int> current;
  for (int i = 0; i < bits; ++i) current.push_back(2 * i);
  const auto cube = engine.cube(current);
  auto reached = system.initial;
  for (;;) {
    auto grown = reached | engine.to_current(engine.and_exists(system.relation, reached, cube));
    if (grown == reached) return engine.count(reached);
    reached = grown;
  }
}

/// A counter of \p bits with a reset, one step at a time.
template <typename Engine>
Outcome counter(int bits) {
  Engine engine(2 * bits, true);
  const Watch watch;
  auto increment = engine.constant(true), carry = engine.constant(true), zero = engine.constant(true);
  auto start = engine.constant(true);
  for (int i = bits; i-- > 0;) {
    const auto now = engine.variable(2 * i), then = engine.variable(2 * i + 1);
    increment &= !(then ^ now ^ carry);
    carry &= now;
    zero &= !then;
    start &= !now;
  }
  return watch.outcome(reachable<Engine>(engine, {start, increment | zero}, bits));
}

/// Stations in a ring, each with a phase of two bits and the token: idle, waiting, working; one moves at a
/// time.
template <typename Engine>
Outcome token_ring(int stations) {
  using Function = typename Engine::Function;
  const int bits = 3 * stations;
  Engine engine(2 * bits, true);
  const Watch watch;
  const auto now = [&](int station, int bit) { return engine.variable(2 * (3 * station + bit)); };
  const auto then = [&](int station, int bit) { return engine.variable(2 * (3 * station + bit) + 1); };
  const auto kept = [&](int station, int bit) { return !(now(station, bit) ^ then(station, bit)); };
  Function start = engine.constant(true), relation = engine.constant(false);
  for (int s = 0; s < stations; ++s) {
    const int after = (s + 1) % stations;
    start &= (!now(s, 0)) & !now(s, 1) & (s == 0 ? now(s, 2) : !now(s, 2));
    Function frame = engine.constant(true);
    for (int other = 0; other < stations; ++other) {
      if (other == s) continue;
      frame &= kept(other, 0) & kept(other, 1);
      if (other != after) frame &= kept(other, 2);
    }
    const Function still = kept(s, 2) & kept(after, 2);
    const Function wait = then(s, 0) & !then(s, 1) & !now(s, 0) & !now(s, 1) & still;
    const Function work = now(s, 0) & !now(s, 1) & now(s, 2) & !then(s, 0) & then(s, 1) & still;
    const Function pass =
        now(s, 2) & !now(after, 2) & !now(s, 0) & !then(s, 0) & !then(s, 1) & !then(s, 2) & then(after, 2);
    relation |= frame & (wait | work | pass);
  }
  return watch.outcome(reachable<Engine>(engine, {start, relation}, bits));
}

/// A game on a square of 2^bits x 2^bits cells: the pursuer moves one cell, the fugitive answers with one;
/// the cells from which the fugitive can be kept from his corner. The relational products are those of a
/// GR(1) game's inner fixpoint.
template <typename Engine>
Outcome pursuit(int bits) {
  using Function = typename Engine::Function;
  Engine engine(8 * bits, true);
  const Watch watch;
  // Coordinates 0, 1: the pursuer's; 2, 3: the fugitive's. Bits of the four are interleaved.
  const auto now = [&](int coordinate, int bit) { return engine.variable(2 * (4 * bit + coordinate)); };
  const auto then = [&](int coordinate, int bit) { return engine.variable(2 * (4 * bit + coordinate) + 1); };
  const auto moved = [&](int coordinate) {
    Function same = engine.constant(true), up = engine.constant(true), down = engine.constant(true);
    Function carry = engine.constant(true), borrow = engine.constant(true);
    for (int b = bits; b-- > 0;) {
      const Function x = now(coordinate, b), y = then(coordinate, b);
      same &= !(x ^ y);
      up &= !(y ^ x ^ carry);
      carry &= x;
      down &= !(y ^ x ^ borrow);
      borrow &= !x;
    }
    return same | (up & !carry) | (down & !borrow);
  };
  const auto equal = [&](int a, int b, bool next) {
    Function same = engine.constant(true);
    for (int i = 0; i < bits; ++i) same &= !(next ? then(a, i) ^ then(b, i) : now(a, i) ^ now(b, i));
    return same;
  };
  std::vector<int> mine, theirs;
  for (int b = 0; b < bits; ++b) {
    for (int c = 0; c < 4; ++c) (c < 2 ? theirs : mine).push_back(2 * (4 * b + c) + 1);
  }
  const Function their_cube = engine.cube(theirs), my_cube = engine.cube(mine);
  const Function their_moves = moved(0) & moved(1);
  const Function my_moves = moved(2) & moved(3) & !(equal(0, 2, true) & equal(1, 3, true));
  Function corner = engine.constant(true);
  for (int b = 0; b < bits; ++b) corner &= now(2, b) & now(3, b);
  Function winning = corner & !(equal(0, 2, false) & equal(1, 3, false));
  for (;;) {
    const Function answer = engine.and_exists_next(my_moves, winning, my_cube);
    const Function grown = winning | !engine.and_exists(their_moves, !answer, their_cube);
    if (grown == winning) return watch.outcome(engine.count(winning));
    winning = grown;
  }
}

struct Workload {
  const char* name;
  Outcome (*heed)(int);
  Outcome (*buddy)(int);
  std::vector<int> sizes;
};

const std::vector<Workload>& workloads() {
  static const std::vector<Workload> all = {
      {"queens", queens<Heed>, queens<Buddy>, {9, 10, 11}},
      {"adder", adder<Heed>, adder<Buddy>, {14, 17}},
      {"multiplier", multiplier<Heed>, multiplier<Buddy>, {9, 10, 11}},
      {"hidden_weighted_bit", hidden_weighted_bit<Heed>, hidden_weighted_bit<Buddy>, {24, 28}},
      {"counter", counter<Heed>, counter<Buddy>, {14, 16}},
      {"token_ring", token_ring<Heed>, token_ring<Buddy>, {24, 40}},
      {"pursuit", pursuit<Heed>, pursuit<Buddy>, {5, 7}},
  };
  return all;
}

void run(benchmark::State& state, Outcome (*workload)(int), int size) {
  for (auto _ : state) state.SetIterationTime(workload(size).seconds);
}

/// Prints as usual and keeps the medians for the table of ratios.
class Ratios : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      const std::string whole = run.run_name.function_name;
      const bool median = run.aggregate_name == "median";
      if (run.error_occurred || (!median && run.repetitions > 1)) continue;
      const std::size_t slash = whole.find('/');
      seconds_[whole.substr(slash + 1)][whole.substr(0, slash)] = run.GetAdjustedRealTime() / 1e3;
    }
  }
  void print() const {
    std::printf("\n%-24s %10s %10s %8s\n", "workload", "heed s", "BuDDy s", "ratio");
    double logarithms = 0;
    int rows = 0;
    for (const auto& [name, by_engine] : seconds_) {
      if (by_engine.size() != 2) continue;
      const double ratio = by_engine.at("BuDDy") / by_engine.at("heed");
      std::printf("%-24s %10.4f %10.4f %8.2f\n", name.c_str(), by_engine.at("heed"), by_engine.at("BuDDy"),
                  ratio);
      logarithms += std::log(ratio);
      ++rows;
    }
    if (rows > 0)
      std::printf("%-24s %10s %10s %8.2f\n", "geometric mean", "", "", std::exp(logarithms / rows));
  }

 private:
  std::map<std::string, std::map<std::string, double>> seconds_;
};

/// \returns whether both give the same figure everywhere
bool agree() {
  for (const Workload& workload : workloads()) {
    const int size = workload.sizes.front();
    if (workload.heed(size).figure != workload.buddy(size).figure) {
      std::fprintf(stderr, "%s %d: the two disagree\n", workload.name, size);
      return false;
    }
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (!agree()) return 1;
  for (const Workload& workload : workloads()) {
    for (const int size : workload.sizes) {
      const std::string name = std::string("/") + workload.name + "_" + std::to_string(size);
      benchmark::RegisterBenchmark(("heed" + name).c_str(), run, workload.heed, size)
          ->Unit(benchmark::kMillisecond)
          ->UseManualTime();
      benchmark::RegisterBenchmark(("BuDDy" + name).c_str(), run, workload.buddy, size)
          ->Unit(benchmark::kMillisecond)
          ->UseManualTime();
    }
  }
  Ratios reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  reporter.print();
}
