#include <bdd.h>
#include <gtest/gtest.h>
#include <heed/bdd/bdd.h>
#include <heed/util/random.h>

#include <cmath>
#include <cstdlib>
#include <set>
#include <vector>

/// heed's diagrams beside BuDDy's: the same random operations on both, over more variables than a truth table
/// holds. Compared are the number of satisfying assignments, the support, equality between results, and
/// values at random points.
namespace {

using heed::bdd::Bdd;
using heed::bdd::Manager;
using heed::bdd::Var;
using heed::util::CounterRandom;

constexpr int variables = 28;
constexpr unsigned slots = 16;

class Buddy {
 public:
  Buddy() {
    bdd_init(100'000, 20'000);
    bdd_setmaxincrease(10'000'000);
    bdd_gbc_hook(nullptr);
    bdd_setvarnum(variables);
    to_next = bdd_newpair();
    for (int i = 0; i < variables; i += 2) bdd_setpair(to_next, i, i + 1);
  }
  ~Buddy() {
    bdd_freepair(to_next);
    bdd_done();
  }
  bddPair* to_next;
};

struct Both {
  Bdd ours;
  ::bdd theirs;
};

class Duel {
 public:
  explicit Duel(std::uint64_t seed) : random_(4711, seed), manager_(options()) {
    for (int i = 0; i < variables / 2; ++i) manager_.new_pair();
    for (unsigned i = 0; i < slots; ++i) values_.push_back(literal());
  }

  void step() {
    const Both f = any(), g = any(), h = any();
    const Both cube = some_cube();
    Both& target = values_[random_.below(slots)];
    switch (random_.below(14)) {
      case 0:
        target = {f.ours & g.ours, f.theirs & g.theirs};
        break;
      case 1:
        target = {f.ours | g.ours, f.theirs | g.theirs};
        break;
      case 2:
        target = {f.ours ^ g.ours, f.theirs ^ g.theirs};
        break;
      case 3:
        target = {f.ours.implies(g.ours), f.theirs >> g.theirs};
        break;
      case 4:
        target = {f.ours.ite(g.ours, h.ours), bdd_ite(f.theirs, g.theirs, h.theirs)};
        break;
      case 5:
        target = {f.ours.exists(cube.ours), bdd_exist(f.theirs, cube.theirs)};
        break;
      case 6:
        target = {f.ours.forall(cube.ours), bdd_forall(f.theirs, cube.theirs)};
        break;
      case 7:
        target = {f.ours.and_exists(g.ours, cube.ours),
                  bdd_appex(f.theirs, g.theirs, bddop_and, cube.theirs)};
        break;
      case 8:
        target = {f.ours.implies_forall(g.ours, cube.ours),
                  bdd_appall(f.theirs, g.theirs, bddop_imp, cube.theirs)};
        break;
      case 9:
        target = {f.ours.cofactor(cube.ours), bdd_restrict(f.theirs, cube.theirs)};
        break;
      case 10:
        compose(target, f, g);
        break;
      case 11:
        shifted_product(target, f, g, cube);
        break;
      case 12:
        target = {!f.ours, !f.theirs};
        break;
      default:
        target = literal();
    }
    if (target.ours.node_count() > 3000) target = literal();
  }

  void compare() {
    for (const Both& value : values_) {
      EXPECT_DOUBLE_EQ(value.ours.count(variables), bdd_satcount(value.theirs));
      EXPECT_EQ(value.ours.support_variables(), their_support(value.theirs));
      for (const Both& other : values_) EXPECT_EQ(value.ours == other.ours, value.theirs == other.theirs);
      for (int i = 0; i < 16; ++i) compare_at_a_point(value);
    }
    EXPECT_TRUE(manager_.consistent());
  }

 private:
  static heed::bdd::ManagerOptions options() {
    heed::bdd::ManagerOptions small;
    small.initial_nodes = 1000;
    small.first_reordering = 2000;
    return small;
  }
  Both any() { return values_[random_.below(slots)]; }
  Both literal() {
    const int i = static_cast<int>(random_.below(variables));
    return {manager_.variable(static_cast<Var>(i)), bdd_ithvar(i)};
  }
  Both some_cube() {
    std::vector<Var> ours;
    std::vector<int> theirs;
    for (int i = 0; i < variables; ++i) {
      if (random_.below(5) != 0) continue;
      ours.push_back(static_cast<Var>(i));
      theirs.push_back(i);
    }
    return {manager_.cube(ours), bdd_makeset(theirs.data(), static_cast<int>(theirs.size()))};
  }
  void compose(Both& target, const Both& f, const Both& g) {
    const int i = static_cast<int>(random_.below(variables));
    target = {f.ours.compose(static_cast<Var>(i), g.ours), bdd_compose(f.theirs, g.theirs, i)};
  }
  /// exists cube . f & (exists next . g)[next for current]
  void shifted_product(Both& target, const Both& f, const Both& g, const Both& cube) {
    std::vector<Var> ours;
    std::vector<int> theirs;
    for (int i = 1; i < variables; i += 2) {
      ours.push_back(static_cast<Var>(i));
      theirs.push_back(i);
    }
    const ::bdd their_next = bdd_makeset(theirs.data(), static_cast<int>(theirs.size()));
    const ::bdd moved = bdd_replace(bdd_exist(g.theirs, their_next), buddy_.to_next);
    target = {f.ours.and_exists_next(g.ours.exists(manager_.cube(ours)), cube.ours),
              bdd_appex(f.theirs, moved, bddop_and, cube.theirs)};
  }
  /// Walked here: BuDDy's own bdd_support keeps a static table that does not survive a second bdd_init.
  static std::vector<Var> their_support(const ::bdd& f) {
    std::set<int> seen;
    std::set<Var> found;
    std::vector<::bdd> open = {f};
    while (!open.empty()) {
      const ::bdd here = open.back();
      open.pop_back();
      if (here == bddtrue || here == bddfalse || !seen.insert(here.id()).second) continue;
      found.insert(static_cast<Var>(bdd_var(here)));
      open.push_back(bdd_low(here));
      open.push_back(bdd_high(here));
    }
    return {found.begin(), found.end()};
  }
  void compare_at_a_point(const Both& value) {
    std::vector<bool> point;
    for (int i = 0; i < variables; ++i) point.push_back(random_.below(2) != 0);
    ::bdd rest = value.theirs;
    while (rest != bddtrue && rest != bddfalse) rest = point[bdd_var(rest)] ? bdd_high(rest) : bdd_low(rest);
    EXPECT_EQ(value.ours.evaluate(point), rest == bddtrue);
  }

  CounterRandom random_;
  Buddy buddy_;
  Manager manager_;
  std::vector<Both> values_;
};

TEST(BddBuddy, RandomOperations) {
  const std::uint64_t duels = std::getenv("HEED_SLOW") != nullptr ? 500 : 20;
  for (std::uint64_t seed = 0; seed < duels; ++seed) {
    SCOPED_TRACE(seed);
    Duel duel(seed);
    for (int round = 0; round < 6; ++round) {
      for (int i = 0; i < 50; ++i) duel.step();
      duel.compare();
      if (::testing::Test::HasFailure()) return;
    }
  }
}

/// The queens of one board in both, square by square, compared by node counts through a common order: with
/// complement edges heed never needs more nodes.
TEST(BddBuddy, Queens) {
  constexpr int n = 5;
  Buddy buddy;
  bdd_extvarnum(n * n);
  heed::bdd::ManagerOptions fixed;
  fixed.automatic_reordering = false;
  Manager manager(fixed);
  for (int i = 0; i < n * n; ++i) manager.new_variable();
  Both all{manager.constant(true), bddtrue};
  const auto forbid = [&](int a, int b) {
    all.ours &= !(manager.variable(static_cast<Var>(a)) & manager.variable(static_cast<Var>(b)));
    all.theirs &= !(bdd_ithvar(a) & bdd_ithvar(b));
  };
  for (int a = 0; a < n * n; ++a) {
    for (int b = 0; b < a; ++b) {
      const int dr = a / n - b / n, dc = a % n - b % n;
      if (dr == 0 || dc == 0 || dr == dc || dr == -dc) forbid(a, b);
    }
  }
  for (int row = 0; row < n; ++row) {
    Both some{manager.constant(false), bddfalse};
    for (int c = 0; c < n; ++c) {
      some.ours |= manager.variable(static_cast<Var>(row * n + c));
      some.theirs |= bdd_ithvar(row * n + c);
    }
    all.ours &= some.ours;
    all.theirs &= some.theirs;
  }
  EXPECT_EQ(all.ours.count(n * n), 10);
  EXPECT_EQ(bdd_satcount(all.theirs), 10 * std::ldexp(1, bdd_varnum() - n * n));
  EXPECT_LE(all.ours.node_count(), static_cast<std::size_t>(bdd_nodecount(all.theirs)) + 1);
}

}  // namespace
