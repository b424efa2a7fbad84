#include "infix_write.h"

#include <fmt/format.h>

#include <algorithm>

namespace heed::spec {

using logic::Formula;
using logic::Op;

namespace {

std::string_view sign_of(Op op) {
  switch (op) {
    case Op::And:
      return " & ";
    case Op::Or:
      return " | ";
    case Op::Implies:
      return " -> ";
    case Op::Iff:
      return " <-> ";
    case Op::Eq:
      return " = ";
    case Op::Ne:
      return " != ";
    case Op::Lt:
      return " < ";
    case Op::Le:
      return " <= ";
    case Op::Gt:
      return " > ";
    case Op::Ge:
      return " >= ";
    default:
      return " + ";
  }
}

/// What is still to be written: a formula, or a piece of text.
struct Piece {
  Formula formula{};
  std::string_view text{};
  bool is_text = false;
  bool inside = false;  ///< An operand: compound ones need parentheses.
};

}  // namespace

std::string infix(const Formula& formula, const TargetNames& names, const char* truth,
                  const char* falsehood) {
  std::string out;
  std::vector<Piece> open{{formula}};
  while (!open.empty()) {
    const Piece piece = open.back();
    open.pop_back();
    if (piece.is_text) {
      out += piece.text;
      continue;
    }
    const Formula& node = piece.formula;
    if (node.op() == Op::Name) {
      out += names[node.name()];
    } else if (node.op() == Op::Next) {
      out += names[node[0].name()] + "'";
    } else if (node.op() == Op::Number) {
      out += std::to_string(node.number());
    } else if (node.operands().empty()) {
      out += node.is_true() ? truth : falsehood;
    } else if (node.op() == Op::Not) {
      out += "!";
      open.push_back({node[0], {}, false, true});
    } else {
      if (piece.inside) out += "(";
      if (piece.inside) open.push_back({{}, ")", true, false});
      for (std::size_t i = node.operands().size(); i-- > 0;) {
        open.push_back({node[i], {}, false, true});
        if (i > 0) open.push_back({{}, sign_of(node.op()), true, false});
      }
    }
  }
  return out;
}

bool all_comparisons(Portable& spec, const std::function<bool(const Formula&)>& fits) {
  for (const auto* list : formula_lists(spec))
    for (const Formula& formula : *list)
      for (const Formula& node : logic::postorder(formula))
        if (node.op() >= Op::Eq && node.op() <= Op::Ge && !fits(node)) return false;
  return true;
}

}  // namespace heed::spec
