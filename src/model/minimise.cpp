// Partition refinement on the reachable part. States start together when their rows agree in input letters,
// output letters and fallback marks; a block is split while its states lead to different blocks. Signatures
// are hashed anew in each round (Moore's scheme) for states that are not alone in their block: O(rows) a
// round, few rounds and few such states on controllers, where Hopcroft's worklist would need the reversed
// rows in memory.

#include <heed/model/mealy.h>
#include <heed/util/hash.h>

#include <algorithm>
#include <bit>
#include <span>

namespace heed::model {
namespace {

using Blocks = std::vector<std::uint32_t>;

/// Reachable states in breadth-first order, rows in order of input letter.
std::vector<std::uint32_t> reachable_order(const Mealy& machine) {
  std::vector<bool> seen(machine.state_count(), false);
  std::vector<std::uint32_t> order;
  if (machine.state_count() == 0) return order;
  order.push_back(0);
  seen[0] = true;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::uint32_t t = machine.first[order[i]]; t < machine.first[order[i] + 1]; ++t) {
      const std::uint32_t next = machine.transitions[t].next;
      if (seen[next]) continue;
      seen[next] = true;
      order.push_back(next);
    }
  return order;
}

/// What the states of a block have in common at first: their rows but for where these lead.
struct Letters {
  const Mealy& machine;

  [[nodiscard]] std::uint64_t operator()(const Mealy::Transition& row) const {
    return (std::uint64_t{row.input} << 33) | (std::uint64_t{row.output} << 1) | (row.fallback ? 1U : 0U);
  }
};

/// And then: where the rows lead. Their letters are equal since the first round.
struct Successors {
  const Mealy& machine;
  const Blocks& block;

  [[nodiscard]] std::uint64_t operator()(const Mealy::Transition& row) const { return block[row.next]; }
};

/// States of one block by what \p Feature says of each of their rows, row by row.
template <typename Feature>
class Signatures {
 public:
  explicit Signatures(Feature feature, std::size_t states)
      : feature_(feature), places_(std::bit_ceil(2 * states + 2)) {}

  /// The first state that was asked for with the block and the features of \p state.
  std::uint32_t leader(std::uint32_t state, const Blocks& block) {
    std::uint64_t hash = block[state];
    for (const Mealy::Transition& row : rows(state)) hash = util::absorb(hash, feature_(row));
    for (std::size_t place = hash & (places_.size() - 1);; place = (place + 1) & (places_.size() - 1)) {
      Place& here = places_[place];
      if (here.leader == UINT32_MAX) {
        here = {hash, state};
        return state;
      }
      if (here.hash == hash && block[here.leader] == block[state] && same(here.leader, state))
        return here.leader;
    }
  }

 private:
  struct Place {
    std::uint64_t hash = 0;
    std::uint32_t leader = UINT32_MAX;
  };

  [[nodiscard]] std::span<const Mealy::Transition> rows(std::uint32_t state) const {
    const Mealy& machine = feature_.machine;
    return {machine.transitions.data() + machine.first[state],
            machine.first[state + 1] - machine.first[state]};
  }
  [[nodiscard]] bool same(std::uint32_t a, std::uint32_t b) const {
    return std::ranges::equal(rows(a), rows(b), {}, feature_, feature_);
  }

  Feature feature_;
  std::vector<Place> places_;  ///< Open addressing, at most half full.
};

/// One round: states with the same features get the same new block, numbered in order of \p order.
/// \returns number of blocks
template <typename Feature>
std::uint32_t refine(const std::vector<std::uint32_t>& order, Blocks& block, std::uint32_t blocks,
                     Feature feature) {
  std::vector<std::uint32_t> size(blocks, 0);
  for (const std::uint32_t state : order) ++size[block[state]];
  const auto shared = static_cast<std::size_t>(
      std::ranges::count_if(order, [&](std::uint32_t state) { return size[block[state]] > 1; }));
  Signatures signatures(feature, shared);
  std::uint32_t count = 0;
  Blocks refined(block.size(), UINT32_MAX);
  for (const std::uint32_t state : order) {
    const std::uint32_t leader = size[block[state]] == 1 ? state : signatures.leader(state, block);
    refined[state] = leader == state ? count++ : refined[leader];
  }
  block = std::move(refined);
  return count;
}

/// A byte each: rows mark faster than bits would let them.
using Marks = std::vector<std::uint8_t>;

/// Where each letter goes when those that no row uses any more are dropped from \p letters; the order stays.
std::vector<std::uint32_t> drop_unused(std::vector<Valuation>& letters, const Marks& used) {
  std::vector<std::uint32_t> place(letters.size(), UINT32_MAX);
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < letters.size(); ++i) {
    if (used[i] == 0) continue;
    if (kept != i) letters[kept] = std::move(letters[i]);
    place[i] = kept++;
  }
  letters.resize(kept);
  return place;
}

/// The machine of the blocks, of each its state in \p representative; drops letters that no row uses any
/// more. Letters keep their numbers' order, so that rows stay sorted and nothing is looked up.
Mealy quotient(const Mealy& machine, const std::vector<std::uint32_t>& representative, const Blocks& block) {
  Mealy result;
  result.name = machine.name;
  result.inputs = machine.inputs;
  result.outputs = machine.outputs;
  result.input_letters = machine.input_letters;
  result.output_letters = machine.output_letters;
  result.assumptions = machine.assumptions;
  result.notes = machine.notes;
  result.first.reserve(representative.size() + 1);
  result.first.push_back(0);
  result.transitions.reserve(machine.transitions.size());
  const auto rows = machine.transitions.begin();
  for (const std::uint32_t state : representative) {
    result.transitions.insert(result.transitions.end(), rows + machine.first[state],
                              rows + machine.first[state + 1]);
    result.first.push_back(static_cast<std::uint32_t>(result.transitions.size()));
  }
  Marks used_inputs(machine.input_letters.size()), used_outputs(machine.output_letters.size());
  for (Mealy::Transition& row : result.transitions) {
    used_inputs[row.input] = used_outputs[row.output] = 1;
    row.next = block[row.next];
  }
  const auto input_place = drop_unused(result.input_letters, used_inputs);
  const auto output_place = drop_unused(result.output_letters, used_outputs);
  for (Mealy::Transition& row : result.transitions) {
    row.input = input_place[row.input];
    row.output = output_place[row.output];
  }
  return result;
}

/// Of each block its first state in \p order. A round numbers the blocks in that order too. It is
/// breadth-first, and the first state of a block was found from the first state of another: so the numbers
/// are those of a visit of the quotient itself, and equal behaviour prints equal.
std::vector<std::uint32_t> first_of_each(const std::vector<std::uint32_t>& order, const Blocks& block,
                                         std::uint32_t count) {
  std::vector<std::uint32_t> first;
  first.reserve(count);
  for (const std::uint32_t state : order)
    if (block[state] == first.size()) first.push_back(state);
  return first;
}

}  // namespace

Mealy minimise(const Mealy& machine) {
  const std::vector<std::uint32_t> order = reachable_order(machine);
  if (order.empty()) return machine;
  Blocks block(machine.state_count(), 0);
  std::uint32_t count = refine(order, block, 1, Letters{machine});
  for (std::uint32_t before = 0; before != count;) {
    before = count;
    count = refine(order, block, count, Successors{machine, block});
  }
  return quotient(machine, first_of_each(order, block, count), block);
}

}  // namespace heed::model
