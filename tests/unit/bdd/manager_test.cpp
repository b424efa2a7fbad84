#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <heed/util/diagnostic.h>

#include <thread>

#include "truth.h"

namespace heed::bdd {
namespace {

using ::testing::ElementsAre;

/// Queens on an n x n board, one variable per square: a diagram with many nodes and a known count.
Bdd queens(Manager& manager, int n) {
  std::vector<Bdd> x;
  for (int i = 0; i < n * n; ++i) x.push_back(manager.variable(static_cast<Var>(i)));
  const auto attacks = [&](int a, int b) {
    const int ra = a / n, ca = a % n, rb = b / n, cb = b % n;
    return a != b && (ra == rb || ca == cb || ra + ca == rb + cb || ra - ca == rb - cb);
  };
  Bdd all = manager.constant(true);
  for (int row = 0; row < n; ++row) {
    Bdd some = manager.constant(false);
    for (int c = 0; c < n; ++c) {
      const int here = row * n + c;
      some |= x[here];
      Bdd alone = manager.constant(true);
      for (int other = 0; other < n * n; ++other) {
        if (attacks(here, other)) alone &= !x[other];
      }
      all &= x[here].implies(alone);
    }
    all &= some;
  }
  return all;
}

void add_variables(Manager& manager, int count) {
  for (int i = 0; i < count; ++i) manager.new_variable();
}

TEST(Handle, CopiesMovesAndEmpty) {
  Manager manager;
  add_variables(manager, 2);
  Bdd empty;
  EXPECT_FALSE(empty.valid());
  EXPECT_FALSE(empty.is_true() || empty.is_false() || empty.is_constant());
  Bdd x = manager.variable(0);
  const Bdd copy = x;
  Bdd moved = std::move(x);
  EXPECT_FALSE(x.valid());
  EXPECT_EQ(moved, copy);
  Bdd& alias = moved;
  moved = alias;
  EXPECT_EQ(moved, copy);
  empty = moved;
  EXPECT_EQ(empty, copy);
  EXPECT_NE(empty, Bdd());
  EXPECT_EQ(copy.id() ^ 1U, (!copy).id());
  EXPECT_EQ(&copy.manager(), &manager);
}

TEST(Handle, KeepsItsNodesThroughCollectionAndNothingElse) {
  Manager manager;
  add_variables(manager, 36);
  Bdd kept = queens(manager, 6);
  const std::size_t size = kept.node_count();
  manager.collect_garbage();
  EXPECT_EQ(manager.statistics().live_nodes, size - 1);
  EXPECT_EQ(kept.count(36), 4);
  const Bdd complement = !kept;
  kept = Bdd();
  manager.collect_garbage();
  EXPECT_EQ((!complement).count(36), 4);
  EXPECT_TRUE(manager.consistent());
}

TEST(Manager, CountsQueens) {
  Manager manager;
  add_variables(manager, 64);
  const Bdd all = queens(manager, 8);
  EXPECT_EQ(all.count(64), 92);
  EXPECT_EQ(all.count_decimal(64), "92");
  std::vector<Var> squares;
  for (Var v = 0; v < 64; ++v) squares.push_back(v);
  int listed = 0;
  for (Assignments each(all, squares); each.next();) ++listed;
  EXPECT_EQ(listed, 92);
}

TEST(Manager, CountsBeyondWordsAndDoubles) {
  Manager manager;
  add_variables(manager, 2);
  const Bdd either = manager.variable(0) | manager.variable(1);
  EXPECT_EQ(either.count_decimal(130), "1020847100762815390390123822295304634368");
  EXPECT_EQ(either.count_words(130), (std::vector<std::uint64_t>{0, 0, 3}));
  EXPECT_TRUE(manager.constant(false).count_words(5).empty());
  EXPECT_EQ(manager.constant(false).count_decimal(5), "0");
  EXPECT_EQ(manager.constant(true).count_decimal(0), "1");

  Manager wide;
  std::vector<Var> all;
  for (int i = 0; i < 3000; ++i) all.push_back(wide.new_variable());
  std::vector<Literal> none;
  for (const Var v : all) none.push_back({v, false});
  const Bdd one = wide.cube(none);
  EXPECT_EQ(one.count(3000), 1);
  EXPECT_EQ((one | wide.cube(all)).count_decimal(3000), "2");
  EXPECT_EQ((!one).exists(wide.cube(all)), wide.constant(true));
}

// Up to some hundreds of variables densities are doubles, above that they have exponents of their own.
TEST(Manager, CountsAlikeHoweverManyVariablesThereAre) {
  for (const int variables : {40, 899, 900, 901, 1100}) {
    Manager manager;
    add_variables(manager, variables);
    const Bdd all = queens(manager, 6);
    EXPECT_EQ(all.count(40), 64) << variables;
    EXPECT_EQ((!all).count(40), std::ldexp(1, 40) - 64) << variables;
    EXPECT_EQ(all.count(36 + 64), std::ldexp(4, 64)) << variables;
  }
}

// Reading writes into the nodes' links for its time.
TEST(Manager, IsAsBeforeOnceADiagramIsRead) {
  Manager manager;
  add_variables(manager, 36);
  const Bdd all = queens(manager, 6), some = all | manager.variable(7), none = manager.constant(false);
  const Bdd several[] = {!some, all, none, all};
  EXPECT_EQ(manager.node_count(several), manager.node_count(several));
  EXPECT_EQ(none.node_count(), 1U);
  EXPECT_TRUE(none.support_variables().empty());
  EXPECT_EQ(all.support_variables().size(), 36U);
  EXPECT_EQ(some.count_decimal(36), "34359738372");  // 2^35, and four solutions without that square
  EXPECT_EQ(serialise(several), serialise(several));
  EXPECT_TRUE(manager.consistent());
  EXPECT_EQ(queens(manager, 6), all);
  manager.collect_garbage();
  EXPECT_TRUE(manager.consistent());
  EXPECT_EQ(all | manager.variable(7), some);
}

TEST(Manager, TheFirstCacheIsWithinItsBounds) {
  ManagerOptions options;
  options.initial_cache_bytes = std::size_t{1} << 24;
  options.max_cache_bytes = std::size_t{1} << 14;
  Manager small(options);
  EXPECT_LT(small.statistics().memory_bytes, std::size_t{3} << 20);
  options.initial_cache_bytes = 0;
  Manager none(options);
  for (Manager* manager : {&small, &none}) {
    add_variables(*manager, 36);
    EXPECT_EQ(queens(*manager, 6).count(36), 4);
  }
}

TEST(Manager, PairsStandTogether) {
  Manager manager;
  const Var single = manager.new_variable();
  const Pair pair = manager.new_pair();
  EXPECT_FALSE(manager.is_paired(single));
  EXPECT_TRUE(manager.is_paired(pair.current) && manager.is_paired(pair.next));
  EXPECT_EQ(manager.partner(pair.current), pair.next);
  EXPECT_EQ(manager.partner(pair.next), pair.current);
  EXPECT_EQ(manager.variable(single).next(), manager.variable(single));
  const Var order[] = {pair.current, pair.next, single};
  manager.set_order(order);
  EXPECT_THAT(manager.order(), ElementsAre(pair.current, pair.next, single));
  EXPECT_EQ(manager.level(single), 2U);
}

TEST(Manager, CubesAndConjunctions) {
  Manager manager;
  add_variables(manager, 4);
  const Var unordered[] = {2, 0, 2};
  EXPECT_EQ(manager.cube(unordered), manager.variable(0) & manager.variable(2));
  const Literal contradicting[] = {{1, true}, {0, true}, {1, false}};
  EXPECT_TRUE(manager.cube(contradicting).is_false());
  EXPECT_TRUE(manager.cube(std::span<const Var>{}).is_true());
  std::vector<Bdd> parts;
  for (Var v = 0; v < 3; ++v) parts.push_back(manager.variable(v) | manager.variable(v + 1));
  const Bdd product = parts[0] & parts[1] & parts[2];
  EXPECT_EQ(manager.conjunction(parts), product);
  EXPECT_EQ(manager.disjunction(parts), parts[0] | parts[1] | parts[2]);
  EXPECT_TRUE(manager.conjunction({}).is_true());
  EXPECT_TRUE(manager.disjunction({}).is_false());
  for (unsigned set = 0; set < 16; ++set) {
    std::vector<Var> chosen;
    for (Var v = 0; v < 4; ++v) {
      if (((set >> v) & 1U) != 0) chosen.push_back(v);
    }
    const Bdd cube = manager.cube(chosen);
    EXPECT_EQ(manager.conjunction_exists(parts, cube), product.exists(cube));
  }
}

/// (x0 & x1) | (x2 & x3) | ... with the operands far apart: exponential in the first order, linear in the
/// best.
Bdd far_pairs(Manager& manager, Var n) {
  Bdd f = manager.constant(false);
  for (Var i = 0; i < n; ++i) f |= manager.variable(i) & manager.variable(i + n);
  return f;
}

TEST(Reordering, SiftingFindsTheLinearOrder) {
  ManagerOptions options;
  options.automatic_reordering = false;
  Manager manager(options);
  add_variables(manager, 24);
  const Bdd f = far_pairs(manager, 12);
  EXPECT_GT(f.node_count(), 4096U);
  const std::string before = f.count_decimal(24);
  manager.sift({.max_growth = 2, .until_no_gain = true});
  EXPECT_EQ(f.node_count(), 25U);
  EXPECT_EQ(f.count_decimal(24), before);
  EXPECT_TRUE(manager.consistent());
  EXPECT_GT(manager.statistics().node_swaps, 0U);
}

// Blocks of two levels that pass each other make up to six nodes of each: the tables, started as small as can
// be, have to keep pace on the way to an order that doubles the diagram with every pair.
TEST(Reordering, TablesKeepPaceWithADiagramThatGrows) {
  for (std::size_t half = 2; half <= 9; ++half) {
    ManagerOptions options;
    options.initial_nodes = 16;
    options.automatic_reordering = false;
    Manager manager(options);
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < 2 * half; ++i) pairs.push_back(manager.new_pair());
    Bdd equal = manager.constant(true);
    for (std::size_t i = 0; i < half; ++i) {
      const Bdd here = manager.variable(pairs[2 * i].current) ^ manager.variable(pairs[2 * i].next);
      const Bdd there = manager.variable(pairs[2 * i + 1].current) | manager.variable(pairs[2 * i + 1].next);
      equal &= here.iff(there);
    }
    const std::string count = equal.count_decimal(4 * half);
    std::vector<Var> apart;
    for (const std::size_t first : {0, 1})
      for (std::size_t i = first; i < 2 * half; i += 2)
        apart.insert(apart.end(), {pairs[i].current, pairs[i].next});
    manager.set_order(apart);
    EXPECT_TRUE(manager.consistent()) << half;
    EXPECT_EQ(equal.count_decimal(4 * half), count);
    manager.sift();
    EXPECT_TRUE(manager.consistent()) << half;
    EXPECT_EQ(equal.count_decimal(4 * half), count);
  }
}

TEST(Reordering, HappensByItselfInsideAnOperationThatOutgrowsTheOrder) {
  ManagerOptions options;
  options.initial_nodes = 64;
  options.first_reordering = 200;
  Manager manager(options);
  add_variables(manager, 40);
  const Bdd f = far_pairs(manager, 20);
  EXPECT_GT(manager.statistics().reorderings, 0U);
  EXPECT_LT(manager.statistics().peak_nodes, 20'000U);
  EXPECT_LT(f.node_count(), 1000U);
  manager.set_automatic_reordering(false);
  EXPECT_FALSE(manager.automatic_reordering());
  EXPECT_TRUE(manager.consistent());
}

// The diagram is too small to be reordered for its size, but much is done with it.
TEST(Reordering, HappensByItselfWhereMuchIsDone) {
  for (const std::uint32_t steps : {0U, 5U}) {
    ManagerOptions options;
    options.first_reordering = 1'000'000;
    options.steps_per_reordering = steps;
    Manager manager(options);
    add_variables(manager, 24);
    const Bdd f = far_pairs(manager, 12);
    for (Var v = 0; v < 24; ++v) {
      const Bdd without = f.exists(manager.variable(v)).minus(f);
      EXPECT_EQ(without, f.cofactor(v, true).minus(f));
    }
    EXPECT_EQ(manager.statistics().reorderings > 0, steps > 0);
    EXPECT_EQ(f.node_count() < 4096, steps > 0);
    EXPECT_EQ(f.count_decimal(24), "16245775");
    EXPECT_TRUE(manager.consistent());
  }
}

TEST(Reordering, IsTheSameEveryTime) {
  std::vector<std::vector<Var>> orders;
  std::vector<std::uint64_t> swaps;
  for (int run = 0; run < 2; ++run) {
    ManagerOptions options;
    options.first_reordering = 500;
    Manager manager(options);
    add_variables(manager, 49);
    const Bdd f = queens(manager, 7);
    orders.push_back(manager.order());
    swaps.push_back(manager.statistics().node_swaps);
    EXPECT_EQ(f.count(49), 40);
  }
  EXPECT_EQ(orders[0], orders[1]);
  EXPECT_EQ(swaps[0], swaps[1]);
  EXPECT_GT(swaps[0], 0U);
}

TEST(Reordering, StopsAtItsBound) {
  ManagerOptions options;
  options.automatic_reordering = false;
  Manager manager(options);
  add_variables(manager, 24);
  const Bdd f = far_pairs(manager, 12);
  manager.sift({.max_node_swaps = 1});
  const std::uint64_t bounded = manager.statistics().node_swaps;
  manager.sift({.max_groups = 24});
  EXPECT_LT(bounded * 4, manager.statistics().node_swaps);
  EXPECT_EQ(f.count(24), far_pairs(manager, 12).count(24));
}

TEST(Limits, StoppedAnywhereEverythingStaysValid) {
  for (std::size_t steps = 1; steps < 400; steps += 7) {
    ManagerOptions options;
    options.max_nodes = 40 + steps * 20;
    options.initial_nodes = 16;
    options.first_reordering = 100 + steps;
    Manager manager(options);
    add_variables(manager, 36);
    const Bdd first = manager.variable(0) ^ manager.variable(35);
    bool stopped = false;
    try {
      const Bdd all = queens(manager, 6);
      EXPECT_EQ(all.count(36), 4);
    } catch (const util::LimitExceeded& limit) {
      EXPECT_EQ(limit.kind(), util::LimitExceeded::Kind::Memory);
      stopped = true;
    }
    EXPECT_TRUE(stopped || steps > 20);
    EXPECT_TRUE(manager.consistent());
    EXPECT_EQ(first.count(36), std::ldexp(1, 35));
    EXPECT_EQ(first, manager.variable(0) ^ manager.variable(35));
  }
}

TEST(Limits, CancelFromAnotherThreadEndsALongOperation) {
  util::Budget budget;
  Manager manager({}, &budget);
  add_variables(manager, 400);
  const Bdd kept = manager.variable(3) & !manager.variable(7);
  std::thread canceller([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    budget.cancel();
  });
  EXPECT_THROW(queens(manager, 20), util::LimitExceeded);
  canceller.join();
  EXPECT_TRUE(manager.consistent());
  manager.set_budget(nullptr);
  EXPECT_EQ(kept, manager.variable(3) & !manager.variable(7));
  EXPECT_EQ(kept.count(2), 1);
}

TEST(Limits, MemoryIsAskedForBeforeItIsTaken) {
  util::Limits limits;
  limits.memory_bytes = util::resident_bytes() + (std::size_t{24} << 20);
  util::Budget budget(limits);
  ManagerOptions options;
  options.automatic_reordering = false;
  Manager manager(options, &budget);
  add_variables(manager, 400);
  EXPECT_THROW(queens(manager, 20), util::LimitExceeded);
  EXPECT_LE(util::resident_bytes(), limits.memory_bytes + (std::size_t{4} << 20));
  EXPECT_TRUE(manager.consistent());
}

TEST(Manager, ManyInManyThreads) {
  std::vector<std::string> counts(4);
  std::vector<std::thread> threads;
  for (std::string& count : counts) {
    threads.emplace_back([&count] {
      Manager manager;
      add_variables(manager, 49);
      count = queens(manager, 7).count_decimal(49);
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_THAT(counts, ::testing::Each("40"));
}

TEST(Serialise, RoundTripAcrossOrdersAndRenaming) {
  Manager here;
  add_variables(here, 36);
  const Bdd all = queens(here, 6);
  const std::vector<Bdd> both = {all, !all, here.constant(false)};
  const Serialised data = serialise(both);
  EXPECT_EQ(data.order.size(), 36U);
  EXPECT_EQ(data, serialise(both));

  Manager there;
  add_variables(there, 40);
  std::vector<Var> map;
  for (Var v = 0; v < 36; ++v) map.push_back(39 - v);
  const std::vector<Bdd> back = deserialise(there, data, map);
  ASSERT_EQ(back.size(), 3U);
  EXPECT_EQ(back[1], !back[0]);
  EXPECT_TRUE(back[2].is_false());
  EXPECT_EQ(back[0].count(36), 4);
  std::vector<Var> inverse(40, 0);
  for (Var v = 0; v < 36; ++v) inverse[map[v]] = v;
  EXPECT_EQ(here.transfer(back[0], inverse), all);
}

TEST(Serialise, RefusesWhatIsNoDiagram) {
  Manager manager;
  add_variables(manager, 2);
  const std::vector<Serialised> broken = {
      {.order = {0}, .nodes = {{0, 4, 0}}, .roots = {2}},
      {.order = {0}, .nodes = {{7, 1, 0}}, .roots = {2}},
      {.order = {0}, .nodes = {{0, 1, 0}}, .roots = {99}},
  };
  for (const Serialised& data : broken)
    EXPECT_THROW(static_cast<void>(deserialise(manager, data)), util::InputError);
}

}  // namespace
}  // namespace heed::bdd
