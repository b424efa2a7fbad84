#include <heed/awareness/perception.h>
#include <heed/logic/rewrite.h>

#include "atoms.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace heed::awareness {
namespace {

struct Symbol {
  std::string atom;
  std::optional<std::size_t> feature{}, whole{};
  util::Location location{};
  bool excluded = false;  ///< Its absence is reported as well.
};

/// The index that \p find returns, or nothing where the catalogue has no such thing; ambiguity stays an
/// error.
template <class Find>
std::optional<std::size_t> attempt(const Find& find) {
  try {
    return find();
  } catch (const util::InputError& error) {
    if (error.diagnostic().code.starts_with("unknown-")) return std::nullopt;
    throw;
  }
}

[[noreturn]] void refuse_unknown(const Catalogue& catalogue, const Name& name) {
  std::vector<std::string> known;
  for (const Feature& feature : catalogue.features) {
    known.push_back(feature.atom);
    known.emplace_back(catalogue.ontology.local_name(feature.filler));
  }
  for (const Entity& entity : catalogue.entities) {
    known.push_back(entity.atom);
    known.emplace_back(catalogue.ontology.local_name(entity.iri));
  }
  throw util::InputError(
      name.location, "unknown-symbol",
      fmt::format("perception cannot report '{}': it is neither a feature nor an entity of the catalogue",
                  name.text),
      util::suggestion(name.text, known));
}

std::optional<std::size_t> feature_of_entity(const Catalogue& catalogue, std::size_t entity) {
  for (std::size_t f = 0; f < catalogue.features.size(); ++f)
    if (catalogue.features[f].entity == entity) return f;
  return std::nullopt;
}

Symbol resolve(const Catalogue& catalogue, const Reported& reported) {
  Symbol symbol;
  symbol.location = reported.what.location;
  symbol.excluded = reported.excluded;
  const auto entity = attempt([&] { return catalogue.entity(reported.what); });
  const auto feature = attempt([&] { return catalogue.feature(reported.what); });
  const bool proper = feature && catalogue.features[*feature].kind != Feature::Kind::Class;
  if (!entity && !feature) refuse_unknown(catalogue, reported.what);
  if (proper && reported.reading != Reported::Reading::Whole) {
    symbol.feature = feature;
  } else if (entity) {
    const bool group = !catalogue.entities[*entity].is_leaf();
    const bool as_feature = reported.reading == Reported::Reading::Feature ||
                            (reported.reading == Reported::Reading::Automatic && group);
    (as_feature ? symbol.feature : symbol.whole) =
        as_feature ? feature_of_entity(catalogue, *entity) : entity;
  }
  if (!symbol.feature && !symbol.whole)
    throw util::InputError(reported.what.location, "wrong-reading",
                           fmt::format("'{}' cannot be reported this way", reported.what.text),
                           "features are reported as features, entities without subentities as a whole");
  if (symbol.excluded && !symbol.feature)
    throw util::InputError(reported.what.location, "wrong-reading",
                           fmt::format("'{}' is read whole; only features are excluded", reported.what.text),
                           "exclude one of its features");
  const std::string own =
      symbol.feature ? catalogue.features[*symbol.feature].atom : catalogue.entities[*symbol.whole].atom;
  symbol.atom = reported.atom.empty() ? own : reported.atom;
  return symbol;
}

std::vector<Symbol> all_symbols(const Catalogue& catalogue) {
  std::set<std::size_t> features;
  for (std::size_t e = 0; e < catalogue.entities.size(); ++e)
    for (const Entailed& has : catalogue.described(e)) features.insert(has.index);
  std::vector<Symbol> symbols;
  symbols.reserve(features.size());
  for (const std::size_t f : features) symbols.push_back({catalogue.features[f].atom, f, {}, {}});
  for (std::size_t e = 0; e < catalogue.entities.size(); ++e) {
    const Entity& entity = catalogue.entities[e];
    const bool is_feature = feature_of_entity(catalogue, e).has_value();
    if (entity.is_leaf() && entity.satisfiable && !is_feature) symbols.push_back({entity.atom, {}, e, {}});
  }
  return symbols;
}

void check_distinct(const std::vector<Symbol>& symbols) {
  std::set<std::string> atoms;
  std::set<std::pair<bool, std::size_t>> things;
  for (const Symbol& symbol : symbols) {
    if (!atoms.insert(symbol.atom).second)
      throw util::InputError(symbol.location, "duplicate-symbol",
                             fmt::format("two symbols are called '{}'", symbol.atom),
                             "give one of them another name");
    if (!things.insert({symbol.feature.has_value(), symbol.feature.value_or(symbol.whole.value_or(0))})
             .second)
      throw util::InputError(symbol.location, "duplicate-symbol",
                             fmt::format("'{}' reports what another symbol reports already", symbol.atom));
  }
}

/// Roles whose reported features become one enumerated input.
std::set<std::uint32_t> enumerated_roles(const Catalogue& catalogue, const std::vector<Symbol>& symbols,
                                         util::Diagnostics& notes) {
  std::map<std::uint32_t, std::vector<std::size_t>> by_role;
  for (const Symbol& symbol : symbols)
    if (symbol.feature && !catalogue.features[*symbol.feature].functional.empty())
      by_role[catalogue.features[*symbol.feature].role.id].push_back(*symbol.feature);
  std::set<std::uint32_t> result;
  for (const auto& [role, members] : by_role) {
    bool exclusive = true;
    for (const std::size_t f : members)
      for (const std::size_t g : members)
        if (f < g && !catalogue.exclusive.contains({f, g})) exclusive = false;
    if (members.size() > 1 && exclusive) result.insert(role);
    if (members.size() > 1 && !exclusive)
      notes.push_back(
          {util::Severity::Note,
           {},
           "not-enumerated",
           fmt::format("the values of '{}' stay single inputs, because some of them may be seen together",
                       catalogue.features[members.front()].role_atom),
           "declare them disjoint",
           ""});
  }
  return result;
}

/// Builds the inputs in the order reported; an enumerated one stands where its first value was.
class InputList {
 public:
  InputList(const Catalogue& catalogue, const std::vector<Symbol>& reported) : catalogue_(catalogue) {
    for (const Symbol& symbol : reported) (void)names_.claim(symbol.atom);
  }

  void add_boolean(const Symbol& symbol) {
    inputs.push_back({symbol.atom, {}, {{1, symbol.atom, symbol.feature, symbol.whole, {}}}});
    symbols.emplace_back(symbol.atom, logic::name(symbol.atom));
  }

  void add_value(const Symbol& symbol) {
    const Feature& feature = catalogue_.features[*symbol.feature];
    const auto [place, fresh] = by_role_.emplace(feature.role.id, inputs.size());
    if (fresh) inputs.push_back({names_.claim(feature.role_atom), {"unknown"}, {}});
    PerceptionInput& input = inputs[place->second];
    input.meanings.push_back({input.values.size(), symbol.atom, symbol.feature, {}, {}});
    input.values.push_back(symbol.atom);
    symbols.emplace_back(symbol.atom,
                         logic::compare(logic::Op::Eq, logic::name(input.name), logic::name(symbol.atom)));
  }

  /// \returns the name of the input that reports the absence.
  std::string add_exclusion(const Symbol& symbol) {
    std::string name = names_.claim("no_" + symbol.atom);
    inputs.push_back({name, {}, {{1, name, {}, {}, symbol.feature}}});
    symbols.emplace_back(name, logic::name(name));
    return name;
  }

  /// Absence of each of \p reported under a full view.
  std::vector<std::pair<std::string, logic::Formula>> add_full_view(const std::string& wanted) {
    const std::string view = names_.claim(wanted);
    std::vector<std::pair<std::string, logic::Formula>> absences;
    for (const auto& [atom, meaning] : symbols)
      absences.emplace_back(names_.claim("no_" + atom), logic::name(view) && !meaning);
    inputs.push_back({view, {}, {{1, view, {}, {}, {}}}});
    symbols.emplace_back(view, logic::name(view));
    return absences;
  }

  std::vector<PerceptionInput> inputs{};
  std::vector<std::pair<std::string, logic::Formula>> symbols{};

 private:
  const Catalogue& catalogue_;
  AtomTable names_{};
  std::map<std::uint32_t, std::size_t> by_role_{};
};

/// Inputs for what is seen to be missing: one each where asked for, or one for all.
void add_absences(const std::vector<Symbol>& symbols, const std::string& full_view, InputList& list,
                  Perception& perception) {
  for (const Symbol& symbol : symbols) {
    if (!symbol.excluded) continue;
    if (!full_view.empty())
      throw util::InputError(symbol.location, "double-exclusion",
                             fmt::format("'{}' is excluded by the full view already", symbol.atom),
                             "use either 'full_view' or 'excluded'");
    perception.excluded_atom[*symbol.feature] = list.add_exclusion(symbol);
  }
  if (full_view.empty()) return;
  const auto absences = list.add_full_view(full_view);
  for (std::size_t i = 0; i < symbols.size(); ++i)
    if (symbols[i].feature) {
      perception.excluded_atom[*symbols[i].feature] = absences[i].first;
      perception.absences.push_back(absences[i]);
    }
}

}  // namespace

Perception resolve_perception(const Catalogue& catalogue, const PerceptionOptions& options) {
  std::vector<Symbol> symbols;
  symbols.reserve(options.reported.size());
  for (const Reported& reported : options.reported) symbols.push_back(resolve(catalogue, reported));
  if (options.reported.empty()) symbols = all_symbols(catalogue);
  check_distinct(symbols);

  Perception perception;
  perception.perceivable.assign(catalogue.features.size(), false);
  perception.feature_atom.resize(catalogue.features.size());
  perception.excluded_atom.resize(catalogue.features.size());
  perception.feature_location.resize(catalogue.features.size());
  perception.whole_atom.resize(catalogue.entities.size());
  const auto roles =
      options.enumerate ? enumerated_roles(catalogue, symbols, perception.notes) : std::set<std::uint32_t>{};
  InputList list(catalogue, symbols);
  for (const Symbol& symbol : symbols) {
    if (symbol.whole) perception.whole_atom[*symbol.whole] = symbol.atom;
    if (symbol.feature) {
      perception.perceivable[*symbol.feature] = true;
      perception.feature_atom[*symbol.feature] = symbol.atom;
      perception.feature_location[*symbol.feature] = symbol.location;
    }
    const bool enumerated = symbol.feature &&
                            catalogue.features[*symbol.feature].kind != Feature::Kind::Class &&
                            roles.contains(catalogue.features[*symbol.feature].role.id);
    enumerated ? list.add_value(symbol) : list.add_boolean(symbol);
  }
  add_absences(symbols, options.full_view, list, perception);
  perception.inputs = std::move(list.inputs);
  perception.symbols = std::move(list.symbols);
  return perception;
}

logic::Formula Perception::over_inputs(const logic::Formula& formula) const {
  std::map<std::string, logic::Formula> table;
  for (const auto& [atom, meaning] : symbols)
    if (meaning.op() != logic::Op::Name) table.emplace(atom, meaning);
  for (const auto& [atom, meaning] : absences) table.emplace(atom, meaning);
  if (table.empty()) return formula;
  return logic::substitute(formula, [&](const std::string& name) -> std::optional<logic::Formula> {
    const auto found = table.find(name);
    if (found == table.end()) return std::nullopt;
    return found->second;
  });
}

}  // namespace heed::awareness
