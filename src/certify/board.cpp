#include "board.h"

#include <heed/logic/parse.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace heed::certify {

using bdd::Bdd;
using logic::Formula;
using logic::Op;

namespace {

bool comparison(const Formula& node) {
  return node.op() >= Op::Eq && node.op() <= Op::Ge;
}

/// What \p formula is the conjunction of.
std::vector<Formula> conjuncts(const Formula& formula) {
  std::vector<Formula> open{formula}, result;
  std::set<const void*> seen;
  while (!open.empty()) {
    const Formula part = std::move(open.back());
    open.pop_back();
    if (!seen.insert(part.identity()).second) continue;
    if (part.op() == Op::And)
      open.insert(open.end(), part.operands().rbegin(), part.operands().rend());
    else
      result.push_back(part);
  }
  return result;
}

/// Small neighbours in one part: fewer passes over what they are conjoined with.
std::vector<Bdd> joined(const std::vector<Bdd>& parts) {
  constexpr std::size_t most_nodes = 1000;
  std::vector<Bdd> result;
  for (const Bdd& part : parts) {
    if (part.is_true()) continue;
    const Bdd together = result.empty() ? Bdd() : result.back() & part;
    if (together.valid() && together.node_count() <= most_nodes)
      result.back() = together;
    else
      result.push_back(part);
  }
  return result;
}

}  // namespace

std::string text_of(const spec::Clause& clause) {
  return clause.text.empty() ? logic::to_string(clause.formula) : clause.text;
}

namespace {

/// The variables of \p quantified that each part has.
std::vector<std::vector<std::size_t>> uses(const std::vector<Bdd>& parts,
                                           const std::vector<bdd::Var>& quantified) {
  std::vector<std::vector<std::size_t>> result(parts.size());
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (std::size_t v = 0; v < quantified.size(); ++v)
      if (parts[p].depends_on(quantified[v])) result[p].push_back(v);
  return result;
}

/// Always next the part that has fewest variables which a later part needs too; among equals the first.
std::vector<std::size_t> order_of(const std::vector<std::vector<std::size_t>>& uses, std::size_t variables) {
  std::vector<std::size_t> left(uses.size()), users(variables, 0), order;
  std::iota(left.begin(), left.end(), std::size_t{0});
  for (const auto& part : uses)
    for (const std::size_t v : part) ++users[v];
  const auto shared = [&](std::size_t part) {
    return std::count_if(uses[part].begin(), uses[part].end(), [&](std::size_t v) { return users[v] > 1; });
  };
  while (!left.empty()) {
    const auto best = std::min_element(left.begin(), left.end(),
                                       [&](std::size_t a, std::size_t b) { return shared(a) < shared(b); });
    for (const std::size_t v : uses[*best]) --users[v];
    order.push_back(*best);
    left.erase(best);
  }
  return order;
}

}  // namespace

Product::Product(bdd::Manager& manager, const std::vector<Bdd>& given,
                 const std::vector<bdd::Var>& quantified) {
  std::vector<Bdd> parts;
  for (const std::size_t p : order_of(uses(given, quantified), quantified.size())) parts.push_back(given[p]);
  parts = joined(parts);
  std::vector<std::vector<bdd::Var>> last(parts.size() + 1);
  const auto used = uses(parts, quantified);
  std::vector<std::size_t> user(quantified.size(), 0);
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (const std::size_t v : used[p]) user[v] = p + 1;
  for (std::size_t v = 0; v < quantified.size(); ++v) last[user[v]].push_back(quantified[v]);
  stages_.emplace_back(manager.constant(true), manager.cube(last[0]));
  for (std::size_t i = 0; i < parts.size(); ++i) stages_.emplace_back(parts[i], manager.cube(last[i + 1]));
}

Bdd Product::operator()(Bdd start) const {
  for (const auto& [part, cube] : stages_) start = start.and_exists(part, cube);
  return start;
}

Board::Board(const spec::Gr1& spec, const std::vector<std::uint32_t>& order, util::Budget& budget)
    : spec_(spec), encoding_(spec, order, budget) {
  bdd::Manager& manager = encoding_.manager();
  states = encoding_.in_range(Owner::Input) & encoding_.in_range(Owner::Output) &
           encoding_.in_range(Owner::Memory);
  memories(budget);
  environment();
  system();
  start();
  env_justice = justices(spec.env_justice);
  sys_justice = justices(spec.sys_justice);
  std::vector<bdd::Var> chosen = encoding_.bits(Owner::Input, true);
  for (const bdd::Var variable : encoding_.bits(Owner::Memory, true)) chosen.push_back(variable);
  moves_ = Product(manager, moves(), chosen);
  plain_moves_ = Product(manager, moves(), {});
  answers_ =
      Product(manager, answering(), moore() ? std::vector<bdd::Var>{} : encoding_.bits(Owner::Output, true));
  doomed_ = doomed();
}

/// By what is written, not by what it comes to: so says docs/semantics.md.
bool Board::judged_by_answers(const Formula& formula) const {
  std::vector<Formula> open{formula};
  std::vector<bool> seen(spec_.definitions.size(), false);
  const auto look = [&](const Formula& node) {
    if (node.op() != Op::Name) return false;
    const spec::Symbol* symbol = encoding_.symbols().find(node.name());
    if (symbol == nullptr) return false;
    if (symbol->kind == spec::Symbol::Kind::Definition && !seen[symbol->index]) {
      seen[symbol->index] = true;
      open.push_back(spec_.definitions[symbol->index].formula);
    }
    return symbol->kind == spec::Symbol::Kind::Output;
  };
  while (!open.empty()) {
    const Formula root = std::move(open.back());
    open.pop_back();
    if (look(root)) return true;
    for (const Formula& node : logic::postorder(root))
      for (std::size_t k = 0; k < node.operands().size(); ++k) {
        if (comparison(node) && spec::enumeration_value(node, k, encoding_.symbols())) continue;
        if (look(node[k])) return true;
      }
  }
  return false;
}

void Board::environment() {
  always_env_ = encoding_.in_range(Owner::Input);
  env_steps.push_back(encoding_.in_range(Owner::Input).next());
  for (const auto& clause : spec_.env_safety) {
    const bool step = clause.formula.has_next() || judged_by_answers(clause.formula);
    for (const Formula& part : conjuncts(clause.formula)) {
      const Bdd holds = encoding_.holds(part);
      env_steps.push_back(step ? holds : holds.next());
      if (!step) always_env_ &= holds;
    }
  }
}

void Board::system() {
  always_sys_ = encoding_.constant(true);
  sys_steps.push_back(encoding_.in_range(Owner::Output).next());
  sys_texts.emplace_back("the values that its outputs may have");
  for (const auto& clause : spec_.sys_safety) {
    const bool step = clause.formula.has_next();
    for (const Formula& part : conjuncts(clause.formula)) {
      const Bdd holds = encoding_.holds(part);
      sys_steps.push_back(step ? holds : holds.next());
      sys_texts.push_back(text_of(clause));
      if (!step) always_sys_ &= holds;
    }
  }
}

void Board::start() {
  Bdd memory = encoding_.constant(true);
  std::size_t at = spec_.inputs.size() + spec_.outputs.size();
  for (const auto& declared : spec_.memories) {
    Bdd any = encoding_.constant(false);
    for (const std::int32_t code : declared.initial)
      any |= encoding_.has_code(encoding_.variables()[at], code);
    memory &= any;
    ++at;
  }
  Bdd environment = always_env_;
  for (const auto& clause : spec_.env_init) environment &= encoding_.holds(clause.formula);
  first_inputs = (environment & memory).exists(encoding_.cube(Owner::Memory, false));
  first_answers = environment & memory & encoding_.in_range(Owner::Output);
  for (const auto& clause : spec_.sys_init) first_answers &= encoding_.holds(clause.formula);
  first_answers &= always_sys_;
}

namespace {

/// What a list of guarded values comes to: where some guard holds, and the bits of the first one's value.
struct Guarded {
  Bdd any;
  std::vector<Bdd> bits;
};

/// Halves first, so that long lists of cases cost no more than their parts.
Guarded merged(const std::vector<Guarded>& cases, std::size_t begin, std::size_t end) {
  if (end - begin == 1) return cases[begin];
  const std::size_t middle = begin + (end - begin) / 2;
  Guarded first = merged(cases, begin, middle);
  const Guarded second = merged(cases, middle, end);
  for (std::size_t i = 0; i < first.bits.size(); ++i) first.bits[i] |= second.bits[i].minus(first.any);
  first.any |= second.any;
  return first;
}

}  // namespace

void Board::memories(util::Budget& budget) {
  for (std::size_t m = 0; m < spec_.memories.size(); ++m) {
    const spec::Memory& memory = spec_.memories[m];
    const Coded& coded = encoding_.variables()[spec_.inputs.size() + spec_.outputs.size() + m];
    if (coded.variable->domain.kind == model::Domain::Kind::Boolean) {
      updates.push_back(encoding_.holds(memory.update));
      continue;
    }
    const std::size_t width = coded.bits.size();
    std::vector<Guarded> cases;
    for (const auto& guarded : memory.cases) {
      budget.check();
      const Bdd guard = encoding_.holds(guarded.guard);
      const std::int64_t distance = std::int64_t{guarded.value} - coded.variable->domain.low;
      Guarded one{guard, {}};
      for (std::size_t weight = width; weight-- > 0;)
        one.bits.push_back(((distance >> weight) & 1) != 0 ? guard : encoding_.constant(false));
      cases.push_back(std::move(one));
    }
    Guarded stay{encoding_.constant(true), {}};
    for (const bdd::Pair& pair : coded.bits) stay.bits.push_back(encoding_.manager().variable(pair.current));
    cases.push_back(std::move(stay));
    const Guarded all = merged(cases, 0, cases.size());
    updates.insert(updates.end(), all.bits.begin(), all.bits.end());
  }
}

std::vector<Justice> Board::justices(const std::vector<spec::Clause>& clauses) const {
  std::vector<Justice> result;
  for (const auto& clause : clauses) {
    Justice justice{encoding_.holds(clause.formula), false, text_of(clause)};
    for (const Owner owner : {Owner::Input, Owner::Output, Owner::Memory})
      for (const bdd::Var variable : encoding_.bits(owner, true))
        justice.step = justice.step || justice.relation.depends_on(variable);
    result.push_back(std::move(justice));
  }
  if (result.empty()) result.push_back({encoding_.constant(true), false, "true"});
  return result;
}

bool Board::mentions(const Bdd& function, bool next_outputs) const {
  const std::vector<bdd::Var> bits = encoding_.bits(Owner::Output, next_outputs);
  return std::any_of(bits.begin(), bits.end(),
                     [&](const bdd::Var variable) { return function.depends_on(variable); });
}

std::vector<Bdd> Board::moves() const {
  std::vector<Bdd> parts = env_steps;
  const std::vector<bdd::Var> next = encoding_.bits(Owner::Memory, true);
  for (std::size_t i = 0; i < next.size(); ++i)
    parts.push_back(encoding_.manager().variable(next[i]).iff(updates[i]));
  return parts;
}

std::vector<Bdd> Board::answering() const {
  std::vector<Bdd> parts;
  for (const Bdd& part : sys_steps)
    if (mentions(part, true)) parts.push_back(part);
  return parts;
}

Bdd Board::doomed() const {
  Bdd result = encoding_.constant(false);
  for (const Bdd& part : sys_steps)
    if (!part.is_true() && !mentions(part, true)) result |= moves_(!part);
  return result;
}

Bdd Board::escapes(const Bdd& from, const Bdd& target) const {
  const Bdd avoided = from & moves_(!answers_(target));
  if (!moore()) return avoided | (from & doomed_);
  // No answer, given before the next observation is known, is safe from all of them.
  const Bdd safe = from.minus(avoided | doomed_);
  return from.minus(safe.exists(encoding_.cube(Owner::Output, true)));
}

bool Board::wins_start(const Bdd& winning) const {
  const Bdd answer = encoding_.cube(Owner::Output, false) & encoding_.cube(Owner::Memory, false);
  const Bdd good = first_answers & winning;
  switch (spec_.initial) {
    case spec::InitialQuantifiers::ForallExists:
      return first_inputs.minus(good.exists(answer)).is_false();
    case spec::InitialQuantifiers::ExistsForall:
      return !((!first_inputs) | good).forall(encoding_.cube(Owner::Input, false)).is_false();
    case spec::InitialQuantifiers::ForallForall:
      return first_inputs.minus(first_answers.exists(answer)).is_false() &&
             (first_inputs & first_answers).minus(winning).is_false();
    case spec::InitialQuantifiers::ExistsExists:
      return !(first_inputs & good).is_false();
  }
  return false;
}

}  // namespace heed::certify
