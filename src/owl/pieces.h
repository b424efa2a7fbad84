#pragma once

#include <heed/owl/ontology.h>

#include <string>
#include <variant>
#include <vector>

namespace heed::owl {

/// A part of a text that is still to be written. Expressions turn into more pieces when they are met, so that
/// writing never recurses over their depth.
struct Nested {
  const ClassExpression* expression;
  bool bracketed;
};
using Piece = std::variant<std::string, Nested>;

/// Writes \p first and all that it leads to. \param expand  Turns an expression into pieces, in reading
/// order.
template <class Expand>
std::string write_pieces(std::vector<Piece> first, Expand expand) {
  std::string out;
  std::vector<Piece> pending(std::make_move_iterator(first.rbegin()), std::make_move_iterator(first.rend()));
  while (!pending.empty()) {
    const Piece piece = std::move(pending.back());
    pending.pop_back();
    if (const auto* text = std::get_if<std::string>(&piece)) {
      out += *text;
      continue;
    }
    std::vector<Piece> more = expand(std::get<Nested>(piece));
    pending.insert(pending.end(), std::make_move_iterator(more.rbegin()),
                   std::make_move_iterator(more.rend()));
  }
  return out;
}

/// The lexical form between quotes, with '"' and '\' escaped.
[[nodiscard]] std::string quoted(const std::string& text);

}  // namespace heed::owl
