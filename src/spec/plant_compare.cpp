#include <heed/spec/compose.h>
#include <heed/util/diagnostic.h>

#include "nodes.h"
#include "plant.h"

#include <fmt/format.h>

#include <map>

namespace heed::spec {
namespace {

using logic::Formula;
using logic::Op;

/// A comparison with plant values is split into cases: for each present value and each next value of the
/// plant's terms it becomes a comparison of what is left, mostly of two numbers. `location' < seen` over a
/// plant with locations 0 ... 4 is (X location = 0 and 0 < seen) or (X location = 1 and 1 < seen) or ...
class CaseSplit {
 public:
  CaseSplit(const Formula& comparison, const PlantTerms& terms)
      : nodes_(comparison), terms_(terms), steps_(nodes_.size()), value_(nodes_.size()) {
    mark();
  }

  Expanded run() const {
    const auto present = groups(false), coming = groups(true);
    if (!speaks_of(true) && !has_others_) return only_present(present);
    std::vector<Formula> cases;
    for (const Group& now : present) {
      StateSet reached(terms_.plant().states.size());
      std::vector<Formula> ways;
      for (const Group& then : coming) {
        const Formula left = instance(now.states.front(), then.states.front());
        if (left.is_true()) merge(reached, then);
        if (!left.is_true() && !left.is_false()) ways.push_back(terms_.next_inside(set_of(then)) && left);
      }
      ways.insert(ways.begin(), terms_.next_inside(reached));
      cases.push_back(terms_.inside(set_of(now)) && logic::any_of(std::move(ways)));
    }
    return {logic::any_of(std::move(cases)), std::nullopt};
  }

 private:
  static constexpr std::uint8_t present_step = 1, next_step = 2;

  /// States that agree on every term of one step, at least one; the first stands for all.
  struct Group {
    std::vector<std::uint32_t> states;
  };

  static void merge(StateSet& into, const Group& group) {
    for (const std::uint32_t state : group.states) into[state] = true;
  }

  [[nodiscard]] StateSet set_of(const Group& group) const {
    StateSet set(terms_.plant().states.size());
    merge(set, group);
    return set;
  }

  [[nodiscard]] bool is_plant(const Formula& node) const {
    return node.op() == Op::Name && (node.name() == plant_state || terms_.value(node.name()));
  }

  /// Finds which names are states' names (next to `state`), which are primed, and whether others take part.
  void mark() {
    const bool with_state = side_is_state(0) || side_is_state(1);
    const Op op = nodes_[nodes_.size() - 1].op();
    if (with_state && op != Op::Eq && op != Op::Ne)
      fail(nodes_.size() - 1, "type", "states have no order: only = and != compare them", "");
    steps_.back() = present_step;
    for (std::size_t i = nodes_.size(); i-- > 0;) {
      const Formula& node = nodes_[i];
      const bool next = node.op() == Op::Next;
      if (next && (steps_[i] & next_step) != 0)
        fail(i, "next-twice", "next inside next of a plant's term", "");
      for (const std::uint32_t k : nodes_.operands(i)) steps_[k] |= next ? next_step : steps_[i];
      if (node.op() != Op::Name || is_plant(node)) continue;
      value_[i] = with_state ? terms_.state(node.name()) : std::nullopt;
      if (with_state && !value_[i])
        fail(i, "unknown-name", fmt::format("'{}' is no state of the plant", node.name()),
             util::suggestion(node.name(), terms_.plant().states));
      has_others_ = has_others_ || !value_[i];
    }
  }

  [[nodiscard]] bool side_is_state(std::size_t side) const {
    const Formula* at = &nodes_[nodes_.size() - 1][side];
    while (at->op() == Op::Next) at = &(*at)[0];
    return at->op() == Op::Name && at->name() == plant_state;
  }

  /// Node \p i is a term of the plant that is read in the next step, or in the present one.
  [[nodiscard]] bool reads(std::size_t i, bool next) const {
    return is_plant(nodes_[i]) && (steps_[i] & (next ? next_step : present_step)) != 0;
  }

  [[nodiscard]] bool speaks_of(bool next) const {
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (reads(i, next)) return true;
    return false;
  }

  [[nodiscard]] std::int64_t term(std::size_t i, std::uint32_t state) const {
    const std::string& name = nodes_[i].name();
    return name == plant_state ? std::int64_t{state} : (*terms_.value(name))[state];
  }

  [[nodiscard]] std::vector<Group> groups(bool next) const {
    std::map<std::vector<std::int64_t>, std::size_t> index;
    std::vector<Group> out;
    for (std::uint32_t s = 0; s < terms_.plant().states.size(); ++s) {
      std::vector<std::int64_t> key;
      for (std::size_t i = 0; i < nodes_.size(); ++i)
        if (reads(i, next)) key.push_back(term(i, s));
      const auto [at, fresh] = index.emplace(std::move(key), out.size());
      if (fresh) out.emplace_back();
      out[at->second].states.push_back(s);
    }
    return out;
  }

  [[nodiscard]] Expanded only_present(const std::vector<Group>& present) const {
    StateSet states(terms_.plant().states.size());
    for (const Group& group : present)
      if (instance(group.states.front(), 0).is_true()) merge(states, group);
    return {terms_.inside(states), std::move(states)};
  }

  /// The comparison with the plant in \p now and next in \p then; `true` or `false` where nothing else takes
  /// part.
  [[nodiscard]] Formula instance(std::uint32_t now, std::uint32_t then) const {
    std::vector<std::pair<Formula, Formula>>
        built;  // Each node read in the present step, and in the next one.
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const Formula& node = nodes_[i];
      if (is_plant(node)) {
        built.emplace_back(logic::number(term(i, now)), logic::number(term(i, then)));
      } else if (value_[i]) {
        built.emplace_back(logic::number(*value_[i]), logic::number(*value_[i]));
      } else if (node.op() == Op::Next) {
        const Formula& operand = built[nodes_.operands(i)[0]].second;
        built.emplace_back(operand, operand);
      } else if (node.operands().empty()) {
        built.emplace_back(node, node.op() == Op::Name ? logic::next(node) : node);
      } else {
        const auto& operands = nodes_.operands(i);
        built.emplace_back(fold(node, built[operands[0]].first, built[operands[1]].first),
                           fold(node, built[operands[0]].second, built[operands[1]].second));
      }
    }
    return built.back().first;
  }

  static Formula fold(const Formula& node, const Formula& left, const Formula& right) {
    if (left.op() != Op::Number || right.op() != Op::Number)
      return Formula::make(node.op(), {left, right}, node.location());
    const std::int64_t a = left.number(), b = right.number();
    std::int64_t result = 0;
    bool overflow = false;
    switch (node.op()) {
      case Op::Add:
        overflow = __builtin_add_overflow(a, b, &result);
        break;
      case Op::Sub:
        overflow = __builtin_sub_overflow(a, b, &result);
        break;
      case Op::Mul:
        overflow = __builtin_mul_overflow(a, b, &result);
        break;
      case Op::Eq:
        return logic::truth(a == b);
      case Op::Ne:
        return logic::truth(a != b);
      case Op::Lt:
        return logic::truth(a < b);
      case Op::Le:
        return logic::truth(a <= b);
      case Op::Gt:
        return logic::truth(a > b);
      default:
        return logic::truth(a >= b);
    }
    if (overflow) throw util::InputError(node.location(), "number", "the arithmetic does not fit 64 bits");
    return logic::number(result);
  }

  [[noreturn]] void fail(std::size_t i, std::string code, std::string message, std::string hint) const {
    throw util::InputError(nodes_[i].location(), std::move(code), std::move(message), std::move(hint));
  }

  Nodes nodes_;
  const PlantTerms& terms_;
  std::vector<std::uint8_t> steps_;  ///< In which steps each node is read.
  std::vector<std::optional<std::uint32_t>> value_;
  bool has_others_ = false;
};

}  // namespace

Expanded expand_comparison(const Formula& comparison, const PlantTerms& terms) {
  return CaseSplit(comparison, terms).run();
}

bool mentions_plant(const Formula& comparison, const PlantTerms& terms) {
  for (const Formula& node : logic::postorder(comparison))
    if (node.op() == Op::Name && (node.name() == plant_state || terms.value(node.name()))) return true;
  return false;
}

}  // namespace heed::spec
