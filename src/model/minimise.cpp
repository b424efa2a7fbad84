// Partition refinement on the reachable part. States start together when their rows agree in input letters,
// output letters and fallback marks; a block is split while its states lead to different blocks. Signatures
// are re-hashed per round (Moore's scheme): O(rows) a round and few rounds on controllers, where Hopcroft's
// worklist would need the reversed rows in memory.

#include <heed/model/mealy.h>
#include <heed/util/hash.h>

#include <algorithm>
#include <numeric>

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

std::uint64_t signature(const Mealy& machine, std::uint32_t state, const Blocks& block) {
  std::uint64_t h = block[state];
  for (std::uint32_t t = machine.first[state]; t < machine.first[state + 1]; ++t) {
    const Mealy::Transition& row = machine.transitions[t];
    h = util::mix(
        h, (std::uint64_t{row.input} << 33) | (std::uint64_t{row.output} << 1) | (row.fallback ? 1U : 0U));
    h = util::mix(h, block[row.next]);
  }
  return h;
}

/// Equal answers and equal successor blocks; decides where hashes agree.
bool same_rows(const Mealy& machine, std::uint32_t a, std::uint32_t b, const Blocks& block) {
  const std::uint32_t count = machine.first[a + 1] - machine.first[a];
  if (block[a] != block[b] || count != machine.first[b + 1] - machine.first[b]) return false;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Mealy::Transition& x = machine.transitions[machine.first[a] + i];
    const Mealy::Transition& y = machine.transitions[machine.first[b] + i];
    if (x.input != y.input || x.output != y.output || x.fallback != y.fallback ||
        block[x.next] != block[y.next])
      return false;
  }
  return true;
}

/// One round: states with the same rows get the same new block, numbered in order of \p order. \returns
/// number of blocks
std::uint32_t refine(const Mealy& machine, const std::vector<std::uint32_t>& order, Blocks& block) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keyed;  // (signature, position in order)
  keyed.reserve(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) keyed.emplace_back(signature(machine, order[i], block), i);
  std::sort(keyed.begin(), keyed.end());
  std::vector<std::uint32_t> leader(order.size());
  for (std::size_t begin = 0; begin < keyed.size();) {
    std::size_t end = begin;
    std::vector<std::uint32_t> leaders;  // more than one only when hashes collide
    for (; end < keyed.size() && keyed[end].first == keyed[begin].first; ++end) {
      const std::uint32_t position = keyed[end].second;
      const auto same = std::find_if(leaders.begin(), leaders.end(), [&](std::uint32_t l) {
        return same_rows(machine, order[l], order[position], block);
      });
      leader[position] = same == leaders.end() ? position : *same;
      if (leader[position] == position) leaders.push_back(position);
    }
    begin = end;
  }
  std::uint32_t count = 0;
  Blocks refined(block.size(), UINT32_MAX);
  for (std::uint32_t i = 0; i < order.size(); ++i)
    refined[order[i]] = leader[i] == i ? count++ : refined[order[leader[i]]];
  block = std::move(refined);
  return count;
}

/// Where each letter goes when those that no row uses any more are dropped from \p letters; the order stays.
std::vector<std::uint32_t> drop_unused(std::vector<Valuation>& letters, const std::vector<bool>& used) {
  std::vector<std::uint32_t> place(letters.size(), UINT32_MAX);
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < letters.size(); ++i) {
    if (!used[i]) continue;
    if (kept != i) letters[kept] = std::move(letters[i]);
    place[i] = kept++;
  }
  letters.resize(kept);
  return place;
}

/// Keeps of each block its first state in \p order; drops letters that no row uses any more. Letters keep
/// their numbers' order, so that rows stay sorted and nothing is looked up.
Mealy quotient(const Mealy& machine, const std::vector<std::uint32_t>& order, const Blocks& block) {
  Mealy result;
  result.name = machine.name;
  result.inputs = machine.inputs;
  result.outputs = machine.outputs;
  result.input_letters = machine.input_letters;
  result.output_letters = machine.output_letters;
  result.assumptions = machine.assumptions;
  result.notes = machine.notes;
  std::vector<bool> used_inputs(machine.input_letters.size()), used_outputs(machine.output_letters.size());
  result.first.push_back(0);
  for (const std::uint32_t state : order) {
    if (block[state] + 1 != result.first.size()) continue;
    for (std::uint32_t t = machine.first[state]; t < machine.first[state + 1]; ++t) {
      Mealy::Transition row = machine.transitions[t];
      used_inputs[row.input] = used_outputs[row.output] = true;
      row.next = block[row.next];
      result.transitions.push_back(row);
    }
    result.first.push_back(static_cast<std::uint32_t>(result.transitions.size()));
  }
  const auto input_place = drop_unused(result.input_letters, used_inputs);
  const auto output_place = drop_unused(result.output_letters, used_outputs);
  for (Mealy::Transition& row : result.transitions) {
    row.input = input_place[row.input];
    row.output = output_place[row.output];
  }
  return result;
}

/// Numbers the blocks by first visit in the quotient, so that equal behaviour prints equal.
void number_by_visit(const Mealy& machine, const std::vector<std::uint32_t>& order, Blocks& block,
                     std::uint32_t count) {
  std::vector<std::uint32_t> representative(count, UINT32_MAX), number(count, UINT32_MAX);
  for (const std::uint32_t state : order)
    if (representative[block[state]] == UINT32_MAX) representative[block[state]] = state;
  std::vector<std::uint32_t> queue{block[0]};
  number[block[0]] = 0;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const std::uint32_t state = representative[queue[i]];
    for (std::uint32_t t = machine.first[state]; t < machine.first[state + 1]; ++t) {
      const std::uint32_t next = block[machine.transitions[t].next];
      if (number[next] != UINT32_MAX) continue;
      number[next] = static_cast<std::uint32_t>(queue.size());
      queue.push_back(next);
    }
  }
  for (const std::uint32_t state : order) block[state] = number[block[state]];
}

}  // namespace

Mealy minimise(const Mealy& machine) {
  const std::vector<std::uint32_t> order = reachable_order(machine);
  if (order.empty()) return machine;
  Blocks block(machine.state_count(), 0);
  std::uint32_t count = 1;
  for (;;) {
    const std::uint32_t refined = refine(machine, order, block);
    if (refined == count) break;
    count = refined;
  }
  number_by_visit(machine, order, block, count);
  std::vector<std::uint32_t> by_number(order);
  std::stable_sort(by_number.begin(), by_number.end(), [&](auto a, auto b) { return block[a] < block[b]; });
  return quotient(machine, by_number, block);
}

}  // namespace heed::model
