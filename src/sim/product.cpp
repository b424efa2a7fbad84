// Breadth-first over (chain state, controller state, category, fallback). A chain's state implies its cell,
// so that layers need not be kept apart.
#include <heed/sim/product.h>

#include <compare>
#include <map>

#include "letters.h"

namespace heed::sim {
namespace {

/// A state to be: where a run stands, or how it ended.
struct Key {
  std::uint32_t chain = 0, machine = 0;
  std::uint32_t category = Judge::none;
  bool fallback = false;
  std::optional<Product::End> end;
  friend auto operator<=>(const Key&, const Key&) = default;
};

class Lister {
 public:
  Lister(const Run& run, util::Budget& budget) : run_(run), budget_(budget), letters_(run) {
    product_.controller = run.machine.name;
    product_.profile = run.chain.profile;
    product_.categories = run.judge.categories;
  }

  Product list() {
    (void)number(observe({}, run_.machine.input_letter(run_.binding.blank)), 0);
    for (std::size_t s = 0; s < keys_.size(); ++s) {
      product_.first.push_back(static_cast<std::uint32_t>(product_.steps.size()));
      if (!keys_[s].end) expand(s);
    }
    product_.first.push_back(static_cast<std::uint32_t>(product_.steps.size()));
    return std::move(product_);
  }

 private:
  void expand(std::size_t state) {
    budget_.check();
    const Key from = keys_[state];
    const std::uint32_t cells = product_.states[state].cells + 1;
    const Chain& chain = run_.chain;
    std::map<std::uint32_t, Rational> row;
    for (std::uint32_t i = chain.first[from.chain]; i < chain.first[from.chain + 1]; ++i) {
      Key moved = from;
      moved.chain = chain.steps[i].next;
      row[number(observe(moved, letters_.letter(chain.steps[i].seen)), cells)] += chain.steps[i].probability;
    }
    for (auto& [next, probability] : row) product_.steps.push_back({probability, next});
  }

  /// Where the machine stands once it has read a letter.
  [[nodiscard]] Key observe(Key at, std::optional<std::uint32_t> read) const {
    const auto* row = read ? run_.machine.find(at.machine, *read) : nullptr;
    if (!row) return ended({known(at.category), true, at.fallback});
    const auto index = static_cast<std::size_t>(row - run_.machine.transitions.data());
    if (at.category == Judge::none) at.category = run_.judge.event[index];
    at.machine = row->next;
    at.fallback |= row->fallback;
    if (run_.chain.first[at.chain] != run_.chain.first[at.chain + 1]) return at;
    return ended({known(at.category).value_or(run_.judge.never), false, at.fallback});
  }

  static Key ended(const Product::End& end) {
    Key key;
    key.end = end;
    return key;
  }

  static std::optional<std::uint32_t> known(std::uint32_t category) {
    return category == Judge::none ? std::nullopt : std::optional(category);
  }

  std::uint32_t number(const Key& key, std::uint32_t cells) {
    const auto [found, added] = numbers_.try_emplace(key, static_cast<std::uint32_t>(keys_.size()));
    if (!added) return found->second;
    if (keys_.size() >= product_state_limit)
      throw util::LimitExceeded(util::LimitExceeded::Kind::Size,
                                "the chain of controller and profile has more than 2^22 states");
    keys_.push_back(key);
    product_.states.push_back({cells, key.machine, key.end});
    return found->second;
  }

  const Run& run_;
  util::Budget& budget_;
  Product product_;
  std::map<Key, std::uint32_t> numbers_;
  std::vector<Key> keys_;
  LetterCache letters_;
};

}  // namespace

Product product(const Run& run, util::Budget& budget) {
  assert_fits(run);
  return Lister(run, budget).list();
}

}  // namespace heed::sim
