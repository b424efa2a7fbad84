#pragma once

#include <heed/bdd/bdd.h>

#include <cstdint>
#include <vector>

/// Boolean functions of up to six variables as words, for comparison: bit a of the word is the value where
/// variable i has bit i of a. Nothing here uses the diagrams except build() and read().
namespace heed::bdd::truth {

using Table = std::uint64_t;

struct Space {
  unsigned variables;

  [[nodiscard]] unsigned rows() const { return 1U << variables; }
  [[nodiscard]] Table all() const { return rows() == 64 ? ~Table{0} : (Table{1} << rows()) - 1; }
  [[nodiscard]] Table variable(unsigned i) const {
    Table table = 0;
    for (unsigned a = 0; a < rows(); ++a) table |= Table{(a >> i) & 1U} << a;
    return table;
  }
  [[nodiscard]] Table complement(Table f) const { return ~f & all(); }
  [[nodiscard]] Table cofactor(Table f, unsigned i, bool value) const {
    const Table on = variable(i), half = value ? f & on : f & complement(on);
    return value ? half | (half >> (1U << i)) : half | (half << (1U << i));
  }
  [[nodiscard]] bool depends(Table f, unsigned i) const {
    return cofactor(f, i, false) != cofactor(f, i, true);
  }
  /// \param set  Bit i: variable i is quantified.
  [[nodiscard]] Table exists(Table f, unsigned set) const {
    for (unsigned i = 0; i < variables; ++i) {
      if (((set >> i) & 1U) != 0) f = cofactor(f, i, false) | cofactor(f, i, true);
    }
    return f;
  }
  [[nodiscard]] Table forall(Table f, unsigned set) const { return complement(exists(complement(f), set)); }
  [[nodiscard]] Table ite(Table f, Table g, Table h) const { return (f & g) | (complement(f) & h); }
  /// Row a of the result is row b of f, where bit i of b is the value of functions[i] in row a.
  [[nodiscard]] Table compose(Table f, const std::vector<Table>& functions) const {
    Table result = 0;
    for (unsigned a = 0; a < rows(); ++a) {
      unsigned b = 0;
      for (unsigned i = 0; i < variables; ++i) b |= static_cast<unsigned>((functions[i] >> a) & 1U) << i;
      result |= ((f >> b) & 1U) << a;
    }
    return result;
  }
};

/// \param map  The manager's variable for each variable of the table.
inline Bdd build(Manager& manager, const Space& space, Table f, const std::vector<Var>& map,
                 unsigned from = 0) {
  if (f == 0 || f == space.all()) return manager.constant(f != 0);
  const Bdd low = build(manager, space, space.cofactor(f, from, false), map, from + 1);
  const Bdd high = build(manager, space, space.cofactor(f, from, true), map, from + 1);
  return manager.variable(map[from]).ite(high, low);
}

inline Table read(const Bdd& f, const Space& space, const std::vector<Var>& map) {
  std::vector<bool> assignment(f.manager().variable_count(), false);
  Table table = 0;
  for (unsigned a = 0; a < space.rows(); ++a) {
    for (unsigned i = 0; i < space.variables; ++i) assignment[map[i]] = ((a >> i) & 1U) != 0;
    table |= Table{f.evaluate(assignment) ? 1U : 0U} << a;
  }
  return table;
}

/// A manager with all functions of its variables, each read back once: equality of handles then decides
/// correctness.
class Universe {
 public:
  explicit Universe(unsigned variables) : space{variables} {
    for (unsigned i = 0; i < variables; ++i) map.push_back(manager.new_variable());
    for (std::uint64_t f = 0; f < std::uint64_t{1} << space.rows(); ++f)
      functions.push_back(build(manager, space, f, map));
  }
  [[nodiscard]] Bdd cube(unsigned set) {
    std::vector<Var> chosen;
    for (unsigned i = 0; i < space.variables; ++i) {
      if (((set >> i) & 1U) != 0) chosen.push_back(map[i]);
    }
    return manager.cube(chosen);
  }

  Space space;
  Manager manager;
  std::vector<Var> map;
  std::vector<Bdd> functions;
};

}  // namespace heed::bdd::truth
