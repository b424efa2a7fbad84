#include "vocabulary.h"

#include <heed/util/diagnostic.h>

#include <fmt/format.h>

#include <vector>

namespace heed::certify {
namespace {

using Variables = std::vector<const model::Variable*>;

void compare(const Variables& given, const Variables& wanted, const char* what) {
  if (given.size() != wanted.size())
    throw util::InputError({}, "columns",
                           fmt::format("the controller has {} {} where the specification has {}",
                                       given.size(), what, wanted.size()));
  for (std::size_t i = 0; i < given.size(); ++i)
    if (given[i]->name != wanted[i]->name || given[i]->domain != wanted[i]->domain)
      throw util::InputError(
          wanted[i]->location, "columns",
          fmt::format("'{}' stands where the specification declares '{}' among its {}, or has another type",
                      given[i]->name, wanted[i]->name, what));
}

Variables list(const std::vector<model::Variable>& variables) {
  Variables result;
  for (const auto& variable : variables) result.push_back(&variable);
  return result;
}

/// Of what has a `variable`: outputs, columns, memories.
template <typename T>
Variables list(const std::vector<T>& items) {
  Variables result;
  for (const auto& item : items) result.push_back(&item.variable);
  return result;
}

}  // namespace

void check_vocabulary(const model::Claim& claim, const spec::Gr1& spec) {
  compare(list(claim.inputs), list(spec.inputs), "inputs");
  compare(list(claim.outputs), list(spec.outputs), "outputs");
  compare(list(claim.memories), list(spec.memories), "memories");
}

void check_vocabulary(const model::SymbolicController& controller, const spec::Gr1& spec) {
  compare(list(controller.inputs), list(spec.inputs), "inputs");
  compare(list(controller.outputs), list(spec.outputs), "outputs");
  compare(list(controller.memories), list(spec.memories), "memories");
  std::vector<model::Variable> definitions;
  for (const auto& definition : spec.definitions)
    definitions.push_back({definition.name, model::Domain::boolean(), {}, definition.formula.location()});
  compare(list(controller.definitions), list(definitions), "definitions");
}

}  // namespace heed::certify
