#include <heed/spec/slugsin.h>

#include "portable.h"

#include <fmt/format.h>

#include <unordered_map>

namespace heed::spec {
namespace {

using logic::Formula;
using logic::Op;

/// One line in prefix notation. Parts that are used more than once come first in a block, and are recalled.
class Line {
 public:
  Line(const Formula& formula, const TargetNames& names) : names_(names) {
    std::unordered_map<const void*, std::size_t> uses;
    std::vector<Formula> shared;
    for (const Formula& node : logic::postorder(formula)) {
      for (const Formula& operand : node.operands()) ++uses[operand.identity()];
    }
    for (const Formula& node : logic::postorder(formula))
      if (!is_leaf(node) && uses[node.identity()] > 1) shared.push_back(node);
    if (!shared.empty()) text_ = fmt::format("$ {} ", shared.size() + 1);
    for (const Formula& part : shared) {
      write(part);
      known_.emplace(part.identity(), known_.size());
    }
    write(formula);
    text_.pop_back();
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  static bool is_leaf(const Formula& node) { return node.operands().empty() || node.op() == Op::Next; }

  void write(const Formula& root) {
    std::vector<Formula> open{root};
    while (!open.empty()) {
      const Formula node = open.back();
      open.pop_back();
      if (const auto found = known_.find(node.identity()); found != known_.end() && !is_leaf(node)) {
        text_ += fmt::format("? {} ", found->second);
        continue;
      }
      write_head(node);
      if (!is_leaf(node))
        for (std::size_t i = node.operands().size(); i-- > 0;) open.push_back(node[i]);
    }
  }

  void write_head(const Formula& node) {
    const std::size_t operands = node.operands().size();
    switch (node.op()) {
      case Op::True:
        text_ += "1 ";
        break;
      case Op::False:
        text_ += "0 ";
        break;
      case Op::Name:
        text_ += names_[node.name()] + " ";
        break;
      case Op::Next:
        text_ += names_[node[0].name()] + "' ";
        break;
      case Op::Not:
        text_ += "! ";
        break;
      case Op::Implies:
        text_ += "| ! ";
        break;
      case Op::Iff:
        text_ += "! ^ ";
        break;
      default:
        for (std::size_t i = 1; i < operands; ++i) text_ += node.op() == Op::And ? "& " : "| ";
    }
  }

  const TargetNames& names_;
  std::string text_;
  std::unordered_map<const void*, std::size_t> known_;
};

bool fits(char c) {
  const bool letter =
      (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
  return letter || (c >= '0' && c <= '9') || c == '_' || c == '.' || c == '@' || c == '-' || c == ':';
}

}  // namespace

std::string write_slugsin(const Gr1& spec) {
  const auto bit = [](const model::Variable& variable, std::size_t i) {
    const std::string range = i == 0 ? fmt::format(".{}.{}", variable.domain.low, variable.domain.high) : "";
    return fmt::format("{}@{}{}", variable.name, i, range);
  };
  Portable plain = in_bits(portable(spec, "slugsin"), bit);
  const TargetNames names(plain, fits, {});
  std::string out = "[INPUT]\n";
  for (const auto& input : plain.inputs) out += names[input.name] + "\n";
  out += "\n[OUTPUT]\n";
  for (const auto& output : plain.outputs) out += names[output.name] + "\n";
  constexpr const char* sections[] = {"ENV_INIT", "ENV_TRANS", "ENV_LIVENESS",
                                      "SYS_INIT", "SYS_TRANS", "SYS_LIVENESS"};
  const auto lists = formula_lists(plain);
  for (std::size_t i = 0; i < lists.size(); ++i) {
    if (!lists[i]->empty()) out += fmt::format("\n[{}]\n", sections[i]);
    for (const Formula& formula : *lists[i]) out += Line(formula, names).text() + "\n";
  }
  return out;
}

}  // namespace heed::spec
