#include "policy_compiler.h"

#include <fmt/format.h>

#include <algorithm>

namespace heed::awareness {
namespace {

bool recognisable(const Entity& entity) {
  return entity.sufficiency == Sufficiency::Defined || entity.sufficiency == Sufficiency::Declared;
}

}  // namespace

Reason PolicyCompiler::reason(const Entailed& has) const {
  return {perception_.feature_atom[has.index], has.axioms};
}

/// Whether perception reports the whole description, so that the definition is checked and not only a part of
/// it.
bool PolicyCompiler::fully_perceivable(std::size_t entity) const {
  const auto described = catalogue_.described(entity);
  return std::all_of(described.begin(), described.end(),
                     [&](const Entailed& has) { return perception_.perceivable[has.index]; });
}

/// Another satisfiable entity, not one of its kind, that has every perceivable feature of \p entity.
std::optional<std::size_t> PolicyCompiler::impostor(std::size_t entity) const {
  const auto described = catalogue_.described(entity, perception_.perceivable);
  for (std::size_t other = 0; other < catalogue_.entities.size(); ++other) {
    if (other == entity || !catalogue_.entities[other].satisfiable || !catalogue_.entities[other].is_leaf())
      continue;
    if (catalogue_.is_below(other, entity) != nullptr) continue;
    const bool has_all = std::all_of(described.begin(), described.end(), [&](const Entailed& has) {
      return catalogue_.has_feature(other, has.index) != nullptr;
    });
    if (has_all) return other;
  }
  return std::nullopt;
}

std::vector<std::size_t> PolicyCompiler::default_targets() {
  std::vector<std::size_t> result;
  for (std::size_t e = 0; e < catalogue_.entities.size(); ++e) {
    if (options_.kind == PolicyOptions::Kind::Full) {
      if (!perception_.whole_atom[e].empty()) result.push_back(e);
    } else if (options_.kind == PolicyOptions::Kind::Identifying) {
      if (catalogue_.entities[e].satisfiable) result.push_back(e);
    } else if (recognisable(catalogue_.entities[e])) {
      result.push_back(e);
    }
  }
  return result;
}

std::vector<std::size_t> PolicyCompiler::targets() {
  if (options_.entities.empty()) return default_targets();
  std::vector<std::size_t> result;
  for (const Name& name : options_.entities) {
    const std::size_t e = catalogue_.entity(name);
    const Entity& entity = catalogue_.entities[e];
    if (std::find(result.begin(), result.end(), e) != result.end()) continue;
    result.push_back(e);
    if (!entity.satisfiable)
      note("unsatisfiable-entity",
           fmt::format("'{}' is to be recognised, but nothing can be one", entity.label));
    else if (!recognisable(entity) && options_.kind != PolicyOptions::Kind::Full &&
             options_.kind != PolicyOptions::Kind::Identifying)
      note(
          "not-defined",
          fmt::format("'{}' is to be recognised, but the ontology does not say that its description suffices",
                      entity.label),
          "define it with EquivalentTo or declare it sufficient");
  }
  return result;
}

Rule PolicyCompiler::whole_rule(std::size_t entity) const {
  if (perception_.whole_atom[entity].empty()) return {};
  return all_rule({{perception_.whole_atom[entity], {}}});
}

/// The whole description entails the entity: the axioms are those by which it does.
Rule PolicyCompiler::defined_rule(std::size_t entity, Rule rule) {
  if (!horn_) horn_.emplace(catalogue_);
  std::vector<HornBase::Prop> seen;
  for (const Entailed& has : catalogue_.described(entity)) seen.push_back(horn_->feature(has.index));
  if (auto why = horn_->why(seen, horn_->entity(entity)); why && !rule.evidence.empty())
    rule.evidence.front().axioms = *std::move(why);
  return rule;
}

Rule PolicyCompiler::definition_rule(std::size_t entity) {
  const Entity& it = catalogue_.entities[entity];
  if (!recognisable(it)) return {};
  std::vector<Reason> parts;
  for (const Entailed& has : catalogue_.described(entity, perception_.perceivable))
    parts.push_back(reason(has));
  if (fully_perceivable(entity)) return defined_rule(entity, all_rule(parts));
  const auto other = impostor(entity);
  if (options_.entities.empty() && (other || parts.empty())) {
    note("not-perceivable",
         fmt::format("'{}' is left out: what perception reports of it, {} shows as well", it.label,
                     other ? "'" + catalogue_.entities[*other].label + "'" : "anything"),
         "report more of its features");
    return {};
  }
  note("partly-perceivable",
       fmt::format(
           "'{}' is recognised from a part of its definition, since perception does not report the rest{}",
           it.label,
           other ? fmt::format("; '{}' shows that part as well", catalogue_.entities[*other].label) : ""));
  return all_rule(parts);
}

Rule PolicyCompiler::at_least_rule(std::size_t entity) {
  std::vector<Reason> parts;
  if (options_.over.empty())
    for (const Entailed& has : catalogue_.described(entity, perception_.perceivable))
      parts.push_back(reason(has));
  for (const Item& item : over_)
    for (const Entailed& has : select(entity, item)) {
      const Reason part = reason(has);
      const bool twice =
          std::any_of(parts.begin(), parts.end(), [&](const Reason& p) { return p.atom == part.atom; });
      if (!twice) parts.push_back(part);
    }
  if (parts.size() < options_.k)
    note("too-few-features",
         fmt::format("'{}' is never recognised by at-least {}: only {} of the features count for it",
                     catalogue_.entities[entity].label, options_.k, parts.size()),
         "lower k or let more features count");
  return threshold_rule(parts, options_.k);
}

Rule PolicyCompiler::rule_for(std::size_t entity) {
  using Kind = PolicyOptions::Kind;
  Rule rule;
  bool direct = true;
  switch (options_.kind) {
    case Kind::Full:
      break;
    case Kind::Tree:
      rule = tree_rule(entity);
      direct = false;
      break;
    case Kind::TreeOrFull:
      rule = tree_rule(entity);
      break;
    case Kind::Definition:
      rule = definition_rule(entity);
      direct = options_.direct.value_or(false);
      break;
    case Kind::AtLeast:
      rule = at_least_rule(entity);
      direct = options_.direct.value_or(true);
      break;
    case Kind::Identifying:
      rule = identifying_rule(entity);
      direct = options_.direct.value_or(true);
      break;
  }
  return direct ? either(rule, whole_rule(entity)) : rule;
}

void PolicyCompiler::note_words() {
  const auto listed = [](const std::vector<Item>& items, const char* separator) {
    std::vector<std::string> words;
    words.reserve(items.size());
    for (const Item& item : items) words.push_back(item.text);
    return fmt::format("{}", fmt::join(words, separator));
  };
  std::string words;
  switch (options_.kind) {
    case PolicyOptions::Kind::Full:
      words = "it is read whole";
      break;
    case PolicyOptions::Kind::Definition:
      words = "all its described features are seen now";
      break;
    case PolicyOptions::Kind::AtLeast:
      words = options_.over.empty() ? fmt::format("any {} of its described features are seen now", options_.k)
                                    : fmt::format("any {} of {} that describe it are seen now", options_.k,
                                                  listed(over_, ", "));
      break;
    case PolicyOptions::Kind::Identifying:
      words = fmt::format("what is seen entails it, or leaves nothing else in {}",
                          options_.closed ? "the catalogue, taken as complete" : "the catalogue");
      break;
    case PolicyOptions::Kind::Tree:
    case PolicyOptions::Kind::TreeOrFull:
      words = fmt::format("the tree {} has been walked, one level per step{}", listed(order_, " -> "),
                          options_.latch ? ", keeping levels once reached" : "");
      break;
  }
  if (options_.kind == PolicyOptions::Kind::TreeOrFull) words += ", or it is read whole";
  const bool adds_direct =
      options_.kind == PolicyOptions::Kind::AtLeast || options_.kind == PolicyOptions::Kind::Definition;
  const bool any_whole = std::any_of(perception_.whole_atom.begin(), perception_.whole_atom.end(),
                                     [](const std::string& atom) { return !atom.empty(); });
  if (adds_direct && any_whole && options_.direct.value_or(options_.kind == PolicyOptions::Kind::AtLeast))
    words += ", or it is read whole";
  result_.words = words;
}

}  // namespace heed::awareness
