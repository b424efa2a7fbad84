#include <gtest/gtest.h>
#include <heed/util/random.h>

#include <bit>
#include <cstdlib>

#include "truth.h"

/// Every operation against bit arithmetic: unary ones on all 65,536 functions of four variables, binary ones
/// on all pairs of three and on seeded pairs of four, ternary ones on seeded triples of three, or on all
/// 256^3 of them with HEED_SLOW=1.
namespace heed::bdd {
namespace {

using truth::Space;
using truth::Table;
using truth::Universe;

bool slow() {
  return std::getenv("HEED_SLOW") != nullptr;
}

Universe& four() {
  static Universe universe(4);
  return universe;
}

TEST(Exhaustive, EveryFunctionOfFourReadsBack) {
  Universe& u = four();
  for (Table f = 0; f < u.functions.size(); ++f) ASSERT_EQ(read(u.functions[f], u.space, u.map), f);
  ASSERT_TRUE(u.manager.consistent());
}

TEST(Exhaustive, EqualFunctionsAreEqualHandles) {
  Universe& u = four();
  std::vector<bool> seen(2 * u.functions.size() + 1000, false);
  for (const Bdd& f : u.functions) {
    if (f.id() >= seen.size()) seen.resize(2 * f.id());
    ASSERT_FALSE(seen[f.id()]);
    seen[f.id()] = true;
  }
}

TEST(Exhaustive, UnaryOperations) {
  Universe& u = four();
  const Space s = u.space;
  for (Table f = 0; f < u.functions.size(); ++f) {
    const Bdd& bdd = u.functions[f];
    ASSERT_EQ(!bdd, u.functions[s.complement(f)]);
    ASSERT_EQ(bdd.count(4), std::popcount(f));
    ASSERT_EQ(bdd.count_decimal(5), std::to_string(2 * std::popcount(f)));
    for (unsigned i = 0; i < 4; ++i) {
      ASSERT_EQ(bdd.cofactor(u.map[i], true), u.functions[s.cofactor(f, i, true)]);
      ASSERT_EQ(bdd.cofactor(u.map[i], false), u.functions[s.cofactor(f, i, false)]);
    }
    std::vector<Var> support;
    for (unsigned i = 0; i < 4; ++i) {
      if (s.depends(f, i)) support.push_back(u.map[i]);
    }
    ASSERT_EQ(bdd.support_variables(), support);
  }
}

TEST(Exhaustive, QuantificationOverEverySet) {
  Universe& u = four();
  for (unsigned set = 0; set < 16; ++set) {
    const Bdd cube = u.cube(set);
    for (Table f = 0; f < u.functions.size(); ++f) {
      ASSERT_EQ(u.functions[f].exists(cube), u.functions[u.space.exists(f, set)]) << f << ' ' << set;
      ASSERT_EQ(u.functions[f].forall(cube), u.functions[u.space.forall(f, set)]) << f << ' ' << set;
    }
  }
}

TEST(Exhaustive, CofactorByEveryCube) {
  Universe& u = four();
  for (unsigned code = 0; code < 81; ++code) {
    std::vector<Literal> literals;
    std::vector<unsigned> digits;
    for (unsigned i = 0, rest = code; i < 4; ++i, rest /= 3) {
      digits.push_back(rest % 3);
      if (rest % 3 != 2) literals.push_back({u.map[i], rest % 3 == 1});
    }
    const Bdd cube = u.manager.cube(literals);
    for (Table f = 0; f < u.functions.size(); f += 7) {
      Table expected = f;
      for (unsigned i = 0; i < 4; ++i) {
        if (digits[i] != 2) expected = u.space.cofactor(expected, i, digits[i] == 1);
      }
      ASSERT_EQ(u.functions[f].cofactor(cube), u.functions[expected]) << f << ' ' << code;
    }
  }
}

TEST(Exhaustive, AssignmentsAscend) {
  Universe& u = four();
  const std::vector<Var> reversed(u.map.rbegin(), u.map.rend());
  for (Table f = 0; f < u.functions.size(); f += 3) {
    Table seen = 0;
    int last = -1;
    for (Assignments all(u.functions[f], reversed); all.next();) {
      int row = 0;
      for (const std::uint8_t bit : all.values()) row = row * 2 + bit;
      ASSERT_GT(row, last);
      last = row;
      seen |= Table{1} << row;
    }
    ASSERT_EQ(seen, f);
    if (f == 0) continue;
    int least = 0;
    for (const bool bit : u.functions[f].pick(reversed)) least = least * 2 + (bit ? 1 : 0);
    ASSERT_EQ(least, std::countr_zero(f));
    ASSERT_TRUE(u.manager.cube(u.functions[f].pick_path()).entails(u.functions[f]));
  }
}

/// Agrees with f on care, and is smaller in the sense of the operation: no variable that neither operand has.
void check_generalised_cofactors(Universe& u, Table f, Table care) {
  const Bdd restricted = u.functions[f].restrict(u.functions[care]);
  const Bdd constrained = u.functions[f].constrain(u.functions[care]);
  if (care == 0) {
    ASSERT_TRUE(restricted.is_false());
    ASSERT_TRUE(constrained.is_false());
    return;
  }
  const Table r = read(restricted, u.space, u.map), c = read(constrained, u.space, u.map);
  ASSERT_EQ(r & care, f & care);
  ASSERT_EQ(c & care, f & care);
  for (unsigned i = 0; i < u.space.variables; ++i) {
    if (!u.space.depends(f, i)) {
      ASSERT_FALSE(u.space.depends(r, i)) << f << ' ' << care;
    }
  }
  if ((care & ~f) == 0) {
    ASSERT_EQ(r, u.space.all());
    ASSERT_EQ(c, u.space.all());
  }
  ASSERT_LE(u.functions[f].minimise(u.functions[care]).node_count(), u.functions[f].node_count());
}

void check_binary(Universe& u, Table f, Table g) {
  const Space s = u.space;
  const Bdd &a = u.functions[f], &b = u.functions[g];
  ASSERT_EQ(a & b, u.functions[f & g]);
  ASSERT_EQ(a | b, u.functions[f | g]);
  ASSERT_EQ(a ^ b, u.functions[f ^ g]);
  ASSERT_EQ(a.iff(b), u.functions[s.complement(f ^ g)]);
  ASSERT_EQ(a.implies(b), u.functions[s.complement(f) | g]);
  ASSERT_EQ(a.minus(b), u.functions[f & ~g]);
  ASSERT_EQ(a.entails(b), (f & ~g) == 0);
  ASSERT_EQ(a.intersects(b), (f & g) != 0);
}

void check_relational(Universe& u, Table f, Table g) {
  const Space s = u.space;
  for (unsigned set = 0; set < 1U << s.variables; ++set) {
    const Bdd cube = u.cube(set);
    const Bdd &a = u.functions[f], &b = u.functions[g];
    ASSERT_EQ(a.and_exists(b, cube), u.functions[s.exists(f & g, set)]);
    ASSERT_EQ(a.and_forall(b, cube), u.functions[s.forall(f & g, set)]);
    ASSERT_EQ(a.or_forall(b, cube), u.functions[s.forall(f | g, set)]);
    ASSERT_EQ(a.implies_forall(b, cube), u.functions[s.forall(s.complement(f) | g, set)]);
  }
}

TEST(Exhaustive, BinaryOperationsOnPairsOfThree) {
  Universe u(3);
  for (Table f = 0; f < 256; ++f) {
    for (Table g = 0; g < 256; ++g) {
      check_binary(u, f, g);
      check_relational(u, f, g);
      check_generalised_cofactors(u, f, g);
      for (unsigned i = 0; i < 3; ++i) {
        const Table expected = u.space.ite(g, u.space.cofactor(f, i, true), u.space.cofactor(f, i, false));
        ASSERT_EQ(u.functions[f].compose(u.map[i], u.functions[g]), u.functions[expected]);
      }
      if (HasFatalFailure()) return;
    }
  }
  ASSERT_TRUE(u.manager.consistent());
}

TEST(Exhaustive, BinaryOperationsOnSeededPairsOfFour) {
  Universe& u = four();
  util::CounterRandom random(20260101, 4);
  const int pairs = slow() ? 1'000'000 : 200'000;
  for (int i = 0; i < pairs; ++i) {
    const Table f = random.below(65536), g = random.below(65536);
    check_binary(u, f, g);
    if (i % 50 == 0) {
      check_relational(u, f, g);
      check_generalised_cofactors(u, f, g);
    }
    if (HasFatalFailure()) return;
  }
}

void check_ternary(Universe& u, Table f, Table g, Table h) {
  ASSERT_EQ(u.functions[f].ite(u.functions[g], u.functions[h]), u.functions[u.space.ite(f, g, h)]);
  const std::pair<Var, Bdd> swap[] = {{u.map[0], u.functions[g]}, {u.map[2], u.functions[h]}};
  ASSERT_EQ(u.functions[f].compose(swap), u.functions[u.space.compose(f, {g, u.space.variable(1), h})]);
}

TEST(Exhaustive, TernaryOperationsOnTriplesOfThree) {
  Universe u(3);
  if (slow()) {
    for (Table f = 0; f < 256; ++f) {
      for (Table gh = 0; gh < 65536 && !HasFatalFailure(); ++gh) check_ternary(u, f, gh & 255U, gh >> 8);
    }
    return;
  }
  util::CounterRandom random(20260101, 3);
  for (int i = 0; i < 100'000 && !HasFatalFailure(); ++i)
    check_ternary(u, random.below(256), random.below(256), random.below(256));
}

/// Two pairs (a, a'), (b, b') as variables 0 ... 3 of the tables.
struct Pairs {
  Manager manager;
  Space space{4};
  std::vector<Var> map;
  Pairs() {
    for (int i = 0; i < 2; ++i) {
      const Pair pair = manager.new_pair();
      map.insert(map.end(), {pair.current, pair.next});
    }
  }
  /// Row r of a function of two variables as a function of the current (or next) ones.
  [[nodiscard]] Table lift(Table small, bool next) const {
    Table result = 0;
    for (unsigned a = 0; a < 16; ++a) {
      const unsigned b = next ? a >> 1 : a;
      result |= ((small >> ((b & 1U) | ((b >> 1) & 2U))) & 1U) << a;
    }
    return result;
  }
};

TEST(Exhaustive, ShiftsAloneAndInsideProducts) {
  Pairs p;
  for (Table g = 0; g < 16; ++g) {
    const Bdd now = build(p.manager, p.space, p.lift(g, false), p.map);
    const Bdd then = build(p.manager, p.space, p.lift(g, true), p.map);
    ASSERT_EQ(now.next(), then);
    ASSERT_EQ(then.current(), now);
    for (Table f = 0; f < 65536; f += 5) {
      const Bdd relation = build(p.manager, p.space, f, p.map);
      ASSERT_EQ(relation.and_next(now), relation & then);
      for (unsigned set = 0; set < 16; ++set) {
        std::vector<Var> chosen;
        for (unsigned i = 0; i < 4; ++i) {
          if (((set >> i) & 1U) != 0) chosen.push_back(p.map[i]);
        }
        const Bdd cube = p.manager.cube(chosen);
        ASSERT_EQ(relation.and_exists_next(now, cube), relation.and_exists(then, cube))
            << f << ' ' << g << ' ' << set;
        ASSERT_EQ(relation.implies_forall_next(now, cube), relation.implies_forall(then, cube));
      }
    }
  }
}

}  // namespace
}  // namespace heed::bdd
