#include <heed/spec/symbols.h>
#include <heed/util/diagnostic.h>

#include "nodes.h"

#include <algorithm>
#include <set>

namespace heed::spec {

using logic::Formula;
using logic::Op;

Symbols::Symbols(const Gr1& spec) {
  const auto add = [this](const std::string& name, Symbol symbol) {
    if (table_.emplace(name, std::move(symbol)).second) names_.push_back(name);
  };
  for (std::uint32_t i = 0; i < spec.inputs.size(); ++i)
    add(spec.inputs[i].name, {Symbol::Kind::Input, i, spec.inputs[i].domain});
  for (std::uint32_t i = 0; i < spec.outputs.size(); ++i)
    add(spec.outputs[i].variable.name, {Symbol::Kind::Output, i, spec.outputs[i].variable.domain});
  for (std::uint32_t i = 0; i < spec.memories.size(); ++i)
    add(spec.memories[i].variable.name, {Symbol::Kind::Memory, i, spec.memories[i].variable.domain});
  for (std::uint32_t i = 0; i < spec.definitions.size(); ++i)
    add(spec.definitions[i].name, {Symbol::Kind::Definition, i, model::Domain::boolean()});
}

const Symbol* Symbols::find(const std::string& name) const {
  const auto found = table_.find(name);
  return found == table_.end() ? nullptr : &found->second;
}

namespace {

/// The name at the end of a chain of Next, or nothing.
const Formula* bare_name(const Formula& term) {
  const Formula* at = &term;
  while (at->op() == Op::Next) at = &(*at)[0];
  return at->op() == Op::Name ? at : nullptr;
}

std::optional<std::int32_t> value_of(const Formula& value, const Formula& variable, const Symbols& symbols) {
  const Formula* variable_name = bare_name(variable);
  const Formula* value_name = bare_name(value);
  if (!variable_name || !value_name) return std::nullopt;
  const Symbol* symbol = symbols.find(variable_name->name());
  if (!symbol || symbol->domain.kind != model::Domain::Kind::Enumeration) return std::nullopt;
  return symbol->domain.read(value_name->name());
}

/// Depth-first order with an explicit stack; a definition on the stack met again closes a cycle.
class DefinitionOrder {
 public:
  explicit DefinitionOrder(const Gr1& spec)
      : spec_(spec), uses_(spec.definitions.size()), mark_(uses_.size()) {
    const Symbols symbols(spec);
    for (std::uint32_t i = 0; i < uses_.size(); ++i) {
      const Formula& root = spec.definitions[i].formula;
      use(i, root, symbols);
      for (const Formula& node : logic::postorder(root))
        for (std::size_t k = 0; k < node.operands().size(); ++k)
          // `red := light = red` uses the value and not itself.
          if (!is_comparison(node.op()) || !enumeration_value(node, k, symbols)) use(i, node[k], symbols);
    }
  }
  std::vector<std::uint32_t> sorted() {
    for (std::uint32_t i = 0; i < uses_.size(); ++i)
      if (mark_[i] == Mark::New) visit(i);
    return order_;
  }

 private:
  void use(std::uint32_t user, const Formula& node, const Symbols& symbols) {
    if (node.op() != Op::Name) return;
    const Symbol* symbol = symbols.find(node.name());
    if (symbol && symbol->kind == Symbol::Kind::Definition) uses_[user].push_back(symbol->index);
  }

  enum class Mark : std::uint8_t { New, Open, Done };
  void visit(std::uint32_t root) {
    std::vector<std::pair<std::uint32_t, std::size_t>> stack{{root, 0}};
    mark_[root] = Mark::Open;
    while (!stack.empty()) {
      auto& [at, next] = stack.back();
      if (next == uses_[at].size()) {
        mark_[at] = Mark::Done;
        order_.push_back(at);
        stack.pop_back();
        continue;
      }
      const std::uint32_t used = uses_[at][next++];
      if (mark_[used] == Mark::Open) refuse(stack, used);
      if (mark_[used] != Mark::New) continue;
      mark_[used] = Mark::Open;
      stack.emplace_back(used, 0);
    }
  }
  [[noreturn]] void refuse(const std::vector<std::pair<std::uint32_t, std::size_t>>& stack,
                           std::uint32_t closing) const {
    std::string cycle;
    bool inside = false;
    for (const auto& [at, next] : stack) {
      inside = inside || at == closing;
      if (inside) cycle += spec_.definitions[at].name + " -> ";
    }
    cycle += spec_.definitions[closing].name;
    throw util::InputError(spec_.definitions[closing].formula.location(), "definition-cycle",
                           "definitions use each other in a cycle: " + cycle,
                           "break the cycle, or keep one of them as a [memory]");
  }
  const Gr1& spec_;
  std::vector<std::vector<std::uint32_t>> uses_;
  std::vector<Mark> mark_;
  std::vector<std::uint32_t> order_;
};

}  // namespace

std::optional<std::int32_t> enumeration_value(const Formula& comparison, std::size_t operand,
                                              const Symbols& symbols) {
  if (const auto right = value_of(comparison[1], comparison[0], symbols))
    return operand == 1 ? right : std::nullopt;
  return operand == 0 ? value_of(comparison[0], comparison[1], symbols) : std::nullopt;
}

void sort_definitions(Gr1& spec) {
  std::vector<Definition> sorted;
  sorted.reserve(spec.definitions.size());
  for (const std::uint32_t i : DefinitionOrder(spec).sorted()) sorted.push_back(spec.definitions[i]);
  spec.definitions = std::move(sorted);
}

}  // namespace heed::spec
