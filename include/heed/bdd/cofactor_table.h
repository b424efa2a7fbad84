#pragma once

#include <heed/bdd/bdd.h>
#include <heed/util/word_table.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace heed::bdd {

/// Vectors of functions and what is left of them as variables get their values, one after the other in a
/// fixed order. A vector is a number: equal vectors at the same depth are equal numbers, and each step is
/// computed once, so that thousands of assignments with common beginnings, or with equal rests, share their
/// work. The functions are held without a handle each. The manager must outlive the table (asserted).
class CofactorTable {
 public:
  using Id = std::uint32_t;
  static constexpr Id none = util::WordTable::none;

  /// \param order  The variables in the order in which they get their values.
  /// \param width  How many functions a vector has.
  CofactorTable(Manager& manager, std::span<const Var> order, std::size_t width);
  CofactorTable(const CofactorTable&) = delete;
  CofactorTable& operator=(const CofactorTable&) = delete;
  ~CofactorTable();

  /// The number of \p functions before any variable has its value. \pre width many, of the manager
  Id root(std::span<const Bdd> functions);
  /// The same of those functions of a vector of \p from that stand at \p places, with the literals of \p cube
  /// put in. \pre width many places; the same manager
  Id root(const CofactorTable& from, Id id, std::span<const std::uint32_t> places, const Bdd& cube);
  /// What is left when the next variable gets \p value. \pre depth of \p id < number of variables
  Id step(Id id, bool value) {
    const Id known = steps_[id].next[value ? 1 : 0];
    return known != none ? known : make_step(id, value);
  }

  [[nodiscard]] std::size_t width() const { return width_; }
  /// Bytes that are taken at once on the way to \p more vectors.
  [[nodiscard]] std::size_t bytes_to_grow(std::size_t more) const {
    return vectors_.bytes_to_grow(more) + util::bytes_to_grow(steps_, more);
  }
  [[nodiscard]] bool is_true(Id id, std::size_t place) const { return edge(id, place) == 0; }
  [[nodiscard]] bool is_false(Id id, std::size_t place) const { return edge(id, place) == 1; }
  [[nodiscard]] Bdd function(Id id, std::size_t place) const { return {kernel_, edge(id, place)}; }
  /// The value under an assignment indexed by variable number. \pre covers the support
  [[nodiscard]] bool evaluate(Id id, std::size_t place, const std::vector<bool>& assignment) const;
  /// Whether it is a conjunction of literals; these are then in \p into, by level.
  bool literals(Id id, std::size_t place, std::vector<Literal>& into) const;

 private:
  struct Steps {
    std::array<Id, 2> next{none, none};
  };

  [[nodiscard]] std::uint32_t edge(Id id, std::size_t place) const { return vectors_[id][1 + place]; }
  Id make_step(Id id, bool value);
  Id intern();

  Kernel* kernel_;
  std::vector<std::array<Bdd, 2>> literals_;  ///< By depth and value.
  std::size_t width_;
  util::WordTable vectors_;         ///< The depth, then edges.
  std::vector<Steps> steps_;        ///< By vector.
  std::vector<std::uint32_t> now_;  ///< The vector that is being made.
};

}  // namespace heed::bdd
