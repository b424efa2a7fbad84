#pragma once

#include <heed/sim/lumping.h>
#include <heed/util/hash.h>
#include <heed/util/limits.h>

#include <array>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "reactions.h"

namespace heed::sim {

/// Components with the same chain that the machine does not tell apart. What is seen is a letter's number.
struct LumpGroup {
  Chain chain;
  std::uint32_t count = 1;
};

/// A machine whose levels are the components, group by group.
struct LumpedModel {
  ReactionMachine machine;
  std::vector<LumpGroup> groups;
  std::uint32_t cells = 0;
  std::size_t categories = 0;
  std::uint32_t never = 0;
};

/// Values by four numbers, in the order in which they came.
template <typename Number>
class Tally {
 public:
  using Key = std::array<std::uint32_t, 4>;

  void add(const Key& key, const Number& value) {
    if (2 * (keys_.size() + 1) > table_.size()) grow();
    std::size_t at = slot(key);
    while (table_[at] != 0 && keys_[table_[at] - 1] != key) at = (at + 1) & (table_.size() - 1);
    if (table_[at] != 0) {
      values_[table_[at] - 1] += value;
      return;
    }
    keys_.push_back(key);
    values_.push_back(value);
    table_[at] = static_cast<std::uint32_t>(keys_.size());
  }
  void clear() { *this = {}; }
  [[nodiscard]] std::size_t size() const { return keys_.size(); }
  [[nodiscard]] const Key& key(std::size_t i) const { return keys_[i]; }
  [[nodiscard]] const Number& value(std::size_t i) const { return values_[i]; }

 private:
  [[nodiscard]] std::size_t slot(const Key& key) const {
    const std::uint64_t hash =
        util::mix(std::uint64_t{key[0]} << 32 | key[1], std::uint64_t{key[2]} << 32 | key[3]);
    return hash & (table_.size() - 1);
  }
  void grow() {
    table_.assign(table_.empty() ? 16 : 2 * table_.size(), 0);
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      std::size_t at = slot(keys_[i]);
      while (table_[at] != 0) at = (at + 1) & (table_.size() - 1);
      table_[at] = static_cast<std::uint32_t>(i + 1);
    }
  }

  std::vector<Key> keys_;
  std::vector<Number> values_;
  std::vector<std::uint32_t> table_;  ///< Open hashing: index into keys_ + 1, or 0.
};

/// How many components are in which state of their chain: multisets as numbers.
class Multisets {
 public:
  /// State and how many, ascending by state.
  using Content = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  static constexpr std::uint32_t empty = 0;

  Multisets() { (void)number({}); }
  std::uint32_t number(const Content& content);
  /// Without the components of the first state. \pre not empty
  std::uint32_t tail(std::uint32_t set);
  std::uint32_t sum(std::uint32_t a, std::uint32_t b);
  [[nodiscard]] const Content& content(std::uint32_t set) const { return contents_[set]; }

 private:
  std::map<Content, std::uint32_t> numbers_;
  std::vector<Content> contents_;
  std::vector<std::uint32_t> tails_;
  std::unordered_map<std::uint64_t, std::uint32_t> sums_;  ///< Only looked up.
};

/// States of all groups' chains in one row: those with fewer steps first within their group, since what
/// hardly branches is better dealt with before there is much to multiply.
struct StateRow {
  explicit StateRow(const std::vector<LumpGroup>& groups);
  struct Step {
    const Rational* probability;
    std::uint32_t next, letter;
  };
  std::vector<std::uint32_t> starts;     ///< Per group.
  std::vector<std::vector<Step>> steps;  ///< Per state.
};

/// The outcome with \p Number for probabilities: Rational or Counted.
/// \throws util::LimitExceeded
template <typename Number>
[[nodiscard]] LumpedOutcome run_lumped(const LumpedModel& model, const LumpOptions& options,
                                       util::Budget& budget);

}  // namespace heed::sim
