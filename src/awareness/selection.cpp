#include "policy_compiler.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace heed::awareness {
namespace {

/// The role of some feature that \p name means: local name, label or atom.
std::optional<std::string> find_role(const Catalogue& catalogue, const std::string& name) {
  for (const Feature& feature : catalogue.features) {
    if (feature.kind == Feature::Kind::Class) continue;
    if (name == feature.role_atom || name == catalogue.ontology.local_name(feature.role) ||
        name == catalogue.ontology.name(feature.role, catalogue.language) ||
        name == catalogue.ontology.text(feature.role))
      return feature.role_atom;
  }
  return std::nullopt;
}

/// A symbol of perception goes before a name of the catalogue.
std::optional<std::size_t> find_reported(const Perception& perception, const std::string& name) {
  const auto& atoms = perception.feature_atom;
  const auto place = std::find(atoms.begin(), atoms.end(), name);
  if (name.empty() || place == atoms.end()) return std::nullopt;
  return static_cast<std::size_t>(place - atoms.begin());
}

/// "sign, red, octagon", cut short where there are many.
std::string reported_symbols(const Perception& perception) {
  constexpr std::size_t most = 12;
  std::string out;
  const std::size_t all = perception.symbols.size();
  for (std::size_t i = 0; i < std::min(all, most); ++i)
    out += (i == 0 ? "" : ", ") + perception.symbols[i].first;
  return all > most ? fmt::format("{} and {} more", out, all - most) : out;
}

}  // namespace

std::vector<PolicyCompiler::Item> PolicyCompiler::resolve_items(const std::vector<Name>& names) const {
  std::vector<Item> items;
  std::set<std::size_t> seen;
  for (const Name& name : names) {
    if (const auto role = find_role(catalogue_, name.text)) {
      items.push_back({true, 0, *role, name.text});
      continue;
    }
    const auto reported = find_reported(perception_, name.text);
    const std::size_t feature = reported ? *reported : catalogue_.feature(name);
    if (!perception_.perceivable[feature])
      throw util::InputError(
          name.location, "not-perceived", fmt::format("perception does not report '{}'", name.text),
          fmt::format("add it to [perception] inputs; what is reported: {}", reported_symbols(perception_)));
    if (!seen.insert(feature).second)
      throw util::InputError(name.location, "duplicate-feature",
                             fmt::format("'{}' is named twice", name.text));
    items.push_back({false, feature, "", name.text});
  }
  return items;
}

std::vector<Entailed> PolicyCompiler::select(std::size_t entity, const Item& item) const {
  std::vector<Entailed> result;
  if (!item.is_role) {
    if (const Entailed* has = catalogue_.has_feature(entity, item.feature)) result.push_back(*has);
    return result;
  }
  for (const Entailed& has : catalogue_.described(entity, perception_.perceivable))
    if (catalogue_.features[has.index].role_atom == item.role) result.push_back(has);
  return result;
}

void PolicyCompiler::check_options() const {
  using Kind = PolicyOptions::Kind;
  const auto refuse = [&](const char* code, const std::string& message, const char* hint) {
    throw util::InputError(options_.location, code, message, hint);
  };
  const bool tree = options_.kind == Kind::Tree || options_.kind == Kind::TreeOrFull;
  const bool any_whole = std::any_of(perception_.whole_atom.begin(), perception_.whole_atom.end(),
                                     [](const std::string& atom) { return !atom.empty(); });
  if (options_.kind == Kind::AtLeast && options_.k == 0)
    refuse("k-out-of-range", "at-least 0 would recognise everything always", "k counts from 1");
  if (tree && options_.order.empty())
    refuse("tree-without-order", "a tree needs the order of its levels", "order = [...]");
  if (!tree && !options_.order.empty())
    refuse("order-without-tree", "only a tree has an order", "policy = \"tree\"");
  if (options_.kind != Kind::AtLeast && !options_.over.empty())
    refuse("over-without-at-least", "only at-least narrows descriptions", "policy = \"at-least\"");
  if (options_.kind == Kind::Full && !any_whole)
    refuse("nothing-read-whole",
           "perception reports no entity as a whole, so the policy full recognises nothing",
           "report an entity such as StopSign itself");
  if (options_.kind == Kind::Tree && options_.direct.value_or(false))
    refuse("direct-tree", "a tree does not use the whole reading", "policy = \"tree-or-full\"");
}

}  // namespace heed::awareness
