#include <heed/logic/formula.h>
#include <heed/util/hash.h>

#include <atomic>
#include <cassert>
#include <cstdint>
#include <set>
#include <utility>

namespace heed::logic {

// A null pointer stands for `true`: default-constructed and moved-from formulas are valid values without a
// global node.
struct Formula::Node {
  Op op = Op::True;
  bool has_next = false;
  std::uint64_t hash = 0;
  std::int64_t number = 0;
  std::string name;
  std::vector<Formula> operands;
  util::Location location;

  Node() = default;
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;
  ~Node();
};

// Takes the operands of every part that nobody else holds before it goes, so that a chain of any length is
// released by this loop and never by nested destructors.
Formula::Node::~Node() {
  if (operands.empty()) return;
  std::vector<Formula> released = std::move(operands);
  while (!released.empty()) {
    Formula last = std::move(released.back());
    released.pop_back();
    if (!last.node_ || last.node_.use_count() != 1) continue;
    // Pairs with the release in other threads' decrements: whatever they read of the node was read before.
    std::atomic_thread_fence(std::memory_order_acquire);
    auto& parts = const_cast<Node&>(*last.node_).operands;
    for (Formula& part : parts) released.push_back(std::move(part));
    parts.clear();
  }
}

namespace {

constexpr std::uint64_t hash_seed = 0x68656564;  // "heed"

std::uint64_t hash_of(Op op) {
  return util::mix(hash_seed, static_cast<std::uint64_t>(op));
}

std::uint64_t hash_of(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return hash;
}

[[maybe_unused]] bool arity_fits(Op op, std::size_t count) {
  switch (op) {
    case Op::True:
    case Op::False:
    case Op::Name:
    case Op::Number:
      return count == 0;
    case Op::And:
    case Op::Or:
      return count >= 2;
    case Op::Not:
    case Op::Next:
    case Op::Always:
    case Op::Eventually:
    case Op::Previous:
    case Op::Once:
    case Op::Historically:
      return count == 1;
    default:
      return count == 2;
  }
}

}  // namespace

Formula::Formula() = default;

Op Formula::op() const {
  return node_ ? node_->op : Op::True;
}

const std::string& Formula::name() const {
  assert(op() == Op::Name);
  return node_->name;
}

std::int64_t Formula::number() const {
  assert(op() == Op::Number);
  return node_->number;
}

std::span<const Formula> Formula::operands() const {
  if (!node_) return {};
  return node_->operands;
}

std::uint64_t Formula::hash() const {
  return node_ ? node_->hash : hash_of(Op::True);
}

bool Formula::has_next() const {
  return node_ && node_->has_next;
}

const util::Location& Formula::location() const {
  static const util::Location nowhere;
  return node_ ? node_->location : nowhere;
}

Formula Formula::make(Op op, std::vector<Formula> operands, util::Location location) {
  assert(op != Op::Name && op != Op::Number);
  assert(arity_fits(op, operands.size()));
  auto node = std::make_shared<Node>();
  node->op = op;
  node->hash = hash_of(op);
  node->has_next = op == Op::Next;
  for (const Formula& operand : operands) {
    node->hash = util::mix(node->hash, operand.hash());
    node->has_next = node->has_next || operand.has_next();
  }
  node->operands = std::move(operands);
  node->location = std::move(location);
  return Formula(std::move(node));
}

Formula Formula::make_name(std::string name, util::Location location) {
  auto node = std::make_shared<Node>();
  node->op = Op::Name;
  node->hash = util::mix(hash_of(Op::Name), hash_of(name));
  node->name = std::move(name);
  node->location = std::move(location);
  return Formula(std::move(node));
}

Formula Formula::make_number(std::int64_t number, util::Location location) {
  auto node = std::make_shared<Node>();
  node->op = Op::Number;
  node->hash = util::mix(hash_of(Op::Number), static_cast<std::uint64_t>(number));
  node->number = number;
  node->location = std::move(location);
  return Formula(std::move(node));
}

namespace {

bool same_head(const Formula& a, const Formula& b) {
  if (a.hash() != b.hash() || a.op() != b.op() || a.operands().size() != b.operands().size()) return false;
  if (a.op() == Op::Name) return a.name() == b.name();
  if (a.op() == Op::Number) return a.number() == b.number();
  return true;
}

}  // namespace

// Equal formulas with different nodes are rare and mostly small. Pairs are remembered only once the
// comparison has become long, so that shared parts cannot make it exponential.
bool operator==(const Formula& a, const Formula& b) {
  constexpr std::size_t short_comparison = 64;
  if (a.identity() == b.identity()) return true;
  std::vector<std::pair<const Formula*, const Formula*>> open{{&a, &b}};
  std::set<std::pair<const void*, const void*>> compared;
  for (std::size_t steps = 0; !open.empty(); ++steps) {
    const auto [left, right] = open.back();
    open.pop_back();
    if (left->identity() == right->identity()) continue;
    if (!same_head(*left, *right)) return false;
    if (steps > short_comparison && !compared.emplace(left->identity(), right->identity()).second) continue;
    for (std::size_t i = 0; i < left->operands().size(); ++i) open.emplace_back(&(*left)[i], &(*right)[i]);
  }
  return true;
}

Formula truth(bool value) {
  return value ? Formula() : Formula::make(Op::False, {});
}

Formula name(std::string name) {
  return Formula::make_name(std::move(name));
}

Formula number(std::int64_t value) {
  return Formula::make_number(value);
}

Formula operator!(const Formula& a) {
  if (a.is_true()) return truth(false);
  if (a.is_false()) return truth(true);
  if (a.op() == Op::Not) return a[0];
  return Formula::make(Op::Not, {a});
}

namespace {

/// And / Or of \p parts: `unit` disappears, `zero` decides, nested ones of the same kind are spliced in.
Formula combine(Op op, std::vector<Formula>&& parts, Op unit, Op zero) {
  std::vector<Formula> flat;
  const auto add = [&flat](Formula part) {
    if (flat.empty() || !(flat.back() == part)) flat.push_back(std::move(part));
  };
  for (Formula& part : parts) {
    if (part.op() == zero) return part;
    if (part.op() == unit) continue;
    if (part.op() == op)
      for (const Formula& inner : part.operands()) add(inner);
    else
      add(std::move(part));
  }
  if (flat.empty()) return truth(unit == Op::True);
  if (flat.size() == 1) return flat.front();
  return Formula::make(op, std::move(flat));
}

}  // namespace

Formula all_of(std::vector<Formula> parts) {
  return combine(Op::And, std::move(parts), Op::True, Op::False);
}

Formula any_of(std::vector<Formula> parts) {
  return combine(Op::Or, std::move(parts), Op::False, Op::True);
}

Formula operator&&(const Formula& a, const Formula& b) {
  return all_of({a, b});
}

Formula operator||(const Formula& a, const Formula& b) {
  return any_of({a, b});
}

Formula implies(const Formula& a, const Formula& b) {
  if (a.is_true()) return b;
  if (a.is_false() || b.is_true()) return truth(true);
  if (b.is_false()) return !a;
  return Formula::make(Op::Implies, {a, b});
}

Formula iff(const Formula& a, const Formula& b) {
  if (a.is_true()) return b;
  if (b.is_true()) return a;
  if (a.is_false()) return !b;
  if (b.is_false()) return !a;
  return Formula::make(Op::Iff, {a, b});
}

namespace {

bool holds(Op comparison, std::int64_t left, std::int64_t right) {
  switch (comparison) {
    case Op::Eq:
      return left == right;
    case Op::Ne:
      return left != right;
    case Op::Lt:
      return left < right;
    case Op::Le:
      return left <= right;
    case Op::Gt:
      return left > right;
    default:
      return left >= right;
  }
}

}  // namespace

Formula compare(Op comparison, const Formula& left, const Formula& right) {
  assert(comparison >= Op::Eq && comparison <= Op::Ge);
  if (left.op() == Op::Number && right.op() == Op::Number)
    return truth(holds(comparison, left.number(), right.number()));
  return Formula::make(comparison, {left, right});
}

Formula next(const Formula& a) {
  if (a.is_true() || a.is_false() || a.op() == Op::Number) return a;
  return Formula::make(Op::Next, {a});
}

Formula always(const Formula& a) {
  if (a.is_true() || a.is_false()) return a;
  return Formula::make(Op::Always, {a});
}

Formula eventually(const Formula& a) {
  if (a.is_true() || a.is_false()) return a;
  return Formula::make(Op::Eventually, {a});
}

}  // namespace heed::logic
