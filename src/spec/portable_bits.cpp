#include "peer.h"
#include "portable.h"

#include <algorithm>
#include <map>
#include <unordered_map>

// Integers as words of bits in two's complement, least significant first, each exactly as wide as its value
// needs: sums never wrap around.

namespace heed::spec {
namespace {

using logic::Formula;
using logic::Op;
using Word = std::vector<Formula>;

Formula both(const Formula& a, const Formula& b) {
  return joined_flat(Op::And, {a, b});
}
Formula either(const Formula& a, const Formula& b) {
  return joined_flat(Op::Or, {a, b});
}
Formula differ(const Formula& a, const Formula& b) {
  return !logic::iff(a, b);
}

Word widened(Word word, std::size_t width) {
  while (word.size() < width) word.push_back(word.back());
  return word;
}

Word constant(std::int64_t value) {
  Word word;
  for (; value != 0 && value != -1; value >>= 1) word.push_back(logic::truth((value & 1) != 0));
  word.push_back(logic::truth(value == -1));
  return word;
}

/// a + b, or a - b.
Word sum(const Word& a, const Word& b, bool minus) {
  const std::size_t width = std::max(a.size(), b.size()) + 1;
  const Word left = widened(a, width);
  Word right = widened(b, width), out;
  Formula carry = logic::truth(minus);
  for (std::size_t i = 0; i < width; ++i) {
    const Formula other = minus ? !right[i] : right[i];
    const Formula half = differ(left[i], other);
    out.push_back(differ(half, carry));
    carry = either(both(left[i], other), both(half, carry));
  }
  return out;
}

Word product(const Word& a, const Word& b) {
  const std::size_t width = a.size() + b.size();
  Word out = constant(0);
  for (std::size_t i = 0; i < b.size(); ++i) {
    Word shifted(i, logic::truth(false));
    for (const Formula& bit : a) shifted.push_back(both(bit, b[i]));
    out = sum(out, shifted, i + 1 == b.size());
    if (out.size() > width) out.resize(width);
  }
  return out;
}

Formula equal(const Word& a, const Word& b) {
  const std::size_t width = std::max(a.size(), b.size());
  const Word left = widened(a, width), right = widened(b, width);
  std::vector<Formula> same;
  for (std::size_t i = 0; i < width; ++i) same.push_back(logic::iff(left[i], right[i]));
  return joined_flat(Op::And, std::move(same));
}

Formula compared(Op op, const Word& a, const Word& b) {
  switch (op) {
    case Op::Eq:
      return equal(a, b);
    case Op::Ne:
      return !equal(a, b);
    case Op::Lt:
      return sum(a, b, true).back();
    case Op::Gt:
      return sum(b, a, true).back();
    case Op::Le:
      return !sum(b, a, true).back();
    default:
      return !sum(a, b, true).back();
  }
}

class Encoder {
 public:
  explicit Encoder(const std::function<std::string(const model::Variable&, std::size_t)>& bit_name)
      : bit_name_(bit_name) {}

  /// Declares the bits of \p variable; which of their values are meant goes to the constraints.
  void declare(const model::Variable& variable, std::vector<model::Variable>& out, std::vector<Formula>& init,
               std::vector<Formula>& steps) {
    if (variable.domain.kind == model::Domain::Kind::Boolean) {
      out.push_back(variable);
      return;
    }
    Word& bits = bits_[variable.name];
    lows_[variable.name] = variable.domain.low;
    const std::int64_t last = variable.domain.size() - 1;
    for (std::size_t i = 0; (last >> i) != 0; ++i) {
      std::string name = bit_name_(variable, i);
      bits.push_back(logic::name(name));
      out.push_back({std::move(name), model::Domain::boolean(), {}, variable.location});
    }
    if ((last & (last + 1)) == 0) return;
    Formula below;
    for (std::size_t i = 0; i < bits.size(); ++i)
      below = ((last >> i) & 1) != 0 ? either(!bits[i], below) : both(!bits[i], below);
    init.push_back(below);
    steps.push_back(one_step_later(below));
  }

  [[nodiscard]] Formula encode(const Formula& formula) const {
    struct Meaning {
      Formula truth;
      Word word;
    };
    std::unordered_map<const void*, Meaning> done;
    for (const Formula& node : logic::postorder(formula)) {
      Meaning meaning;
      const Op op = node.op();
      if (op == Op::Name || op == Op::Next || op == Op::Number) {
        meaning = {node, word_of(node)};
      } else if (op >= Op::Eq && op <= Op::Mul) {
        const Word &a = done.at(node[0].identity()).word, &b = done.at(node[1].identity()).word;
        if (op <= Op::Ge)
          meaning.truth = compared(op, a, b);
        else
          meaning.word = op == Op::Mul ? product(a, b) : sum(a, b, op == Op::Sub);
      } else {
        meaning.truth = connective(node, [&](const Formula& part) { return done.at(part.identity()).truth; });
      }
      done.emplace(node.identity(), std::move(meaning));
    }
    return done.at(formula.identity()).truth;
  }

 private:
  template <typename Find>
  static Formula connective(const Formula& node, Find find) {
    std::vector<Formula> parts;
    for (const Formula& part : node.operands()) parts.push_back(find(part));
    if (node.op() == Op::Not) return !parts[0];
    if (node.op() == Op::Implies) return logic::implies(parts[0], parts[1]);
    if (node.op() == Op::Iff) return logic::iff(parts[0], parts[1]);
    if (parts.empty()) return node;
    return joined_flat(node.op(), std::move(parts));
  }

  /// The value of a name, a name below Next, or a number; nothing for Booleans.
  [[nodiscard]] Word word_of(const Formula& leaf) const {
    if (leaf.op() == Op::Number) return constant(leaf.number());
    const bool next = leaf.op() == Op::Next;
    const auto found = bits_.find(next ? leaf[0].name() : leaf.name());
    if (found == bits_.end()) return {};
    Word word = found->second;
    if (next)
      for (Formula& bit : word) bit = logic::next(bit);
    word.push_back(logic::truth(false));
    const std::int32_t low = lows_.at(found->first);
    return low == 0 ? word : sum(word, constant(low), false);
  }

  const std::function<std::string(const model::Variable&, std::size_t)>& bit_name_;
  std::map<std::string, Word> bits_;
  std::map<std::string, std::int32_t> lows_;
};

}  // namespace

Portable in_bits(const Portable& spec,
                 const std::function<std::string(const model::Variable&, std::size_t)>& bit_name) {
  Encoder encoder(bit_name);
  Portable ranges;
  for (const auto& input : spec.inputs)
    encoder.declare(input, ranges.inputs, ranges.env_init, ranges.env_steps);
  for (const auto& output : spec.outputs)
    encoder.declare(output, ranges.outputs, ranges.sys_init, ranges.sys_steps);
  Portable out = spec;
  out.inputs = ranges.inputs;
  out.outputs = ranges.outputs;
  const auto lists = formula_lists(out), extra = formula_lists(ranges);
  for (std::size_t i = 0; i < lists.size(); ++i) {
    for (Formula& formula : *lists[i]) formula = encoder.encode(formula);
    lists[i]->insert(lists[i]->begin(), extra[i]->begin(), extra[i]->end());
  }
  return out;
}

}  // namespace heed::spec
