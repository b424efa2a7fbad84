#include <heed/logic/nodes.h>
#include <heed/util/word_table.h>

#include <array>

namespace heed::logic {

Nodes::Nodes(const Formula& root) {
  struct Frame {
    const Formula* formula;
    std::uint32_t number;
    std::uint32_t next;
  };
  constexpr std::size_t usual = 16;
  // Nodes are numbered as they are entered; what was entered of the open ones' operands waits for its place.
  util::WordTable entered(2);
  std::vector<std::uint32_t> place, waiting;
  std::vector<Frame> open;
  for (auto* list : {&place, &waiting, &operands_, &end_}) list->reserve(usual);
  open.reserve(usual);
  nodes_.reserve(usual);
  const auto enter = [&](const Formula& formula) {
    const auto identity = static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(formula.identity()));
    const auto [number, fresh] = entered.number(
        std::array{static_cast<std::uint32_t>(identity), static_cast<std::uint32_t>(identity >> 32)});
    if (!fresh) return number;
    open.push_back({&formula, number, 0});
    place.push_back(0);
    return number;
  };
  enter(root);
  while (!open.empty()) {
    Frame& frame = open.back();
    const std::span<const Formula> operands = frame.formula->operands();
    if (frame.next < operands.size()) {
      waiting.push_back(enter(operands[frame.next++]));
      continue;
    }
    const std::size_t first = waiting.size() - operands.size();
    for (std::size_t i = first; i < waiting.size(); ++i) operands_.push_back(place[waiting[i]]);
    waiting.resize(first);
    place[frame.number] = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back(*frame.formula);
    end_.push_back(static_cast<std::uint32_t>(operands_.size()));
    open.pop_back();
  }
}

std::vector<Formula> postorder(const Formula& root) {
  return Nodes(root).formulas();
}

}  // namespace heed::logic
