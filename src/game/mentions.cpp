#include "mentions.h"

namespace heed::game {

std::set<std::string> mentioned(const logic::Formula& formula, const spec::Symbols& symbols) {
  std::set<std::string> names;
  const auto note = [&](const logic::Formula& node) {
    if (node.op() == logic::Op::Name && symbols.find(node.name()) != nullptr) names.insert(node.name());
  };
  note(formula);
  for (const logic::Formula& node : logic::postorder(formula)) {
    const bool comparison = node.op() >= logic::Op::Eq && node.op() <= logic::Op::Ge;
    for (std::size_t i = 0; i < node.operands().size(); ++i)
      if (!comparison || !spec::enumeration_value(node, i, symbols)) note(node[i]);
  }
  return names;
}

}  // namespace heed::game
