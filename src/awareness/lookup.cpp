#include "lookup.h"

#include <fmt/format.h>

#include <algorithm>

namespace heed::awareness {
namespace {

bool is_one_of(const owl::Ontology& ontology, owl::Iri iri, const std::vector<owl::EntityKind>& kinds) {
  return std::any_of(kinds.begin(), kinds.end(),
                     [&](owl::EntityKind kind) { return ontology.is(kind, iri); });
}

std::string noun_of(const std::vector<owl::EntityKind>& kinds) {
  switch (kinds.front()) {
    case owl::EntityKind::ObjectProperty:
      return "object property";
    default:
      return "class or individual";
  }
}

std::vector<std::string> known_names(const owl::Ontology& ontology,
                                     const std::vector<owl::EntityKind>& kinds) {
  std::vector<std::string> names;
  for (const owl::EntityKind kind : kinds)
    for (const owl::Iri iri : ontology.entities(kind)) names.emplace_back(ontology.local_name(iri));
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

[[noreturn]] void refuse_ambiguous(const Name& name, const std::vector<std::string>& meanings) {
  throw util::InputError(name.location, "ambiguous-name",
                         fmt::format("'{}' may mean {}", name.text, fmt::join(meanings, " or ")),
                         "give the full IRI or the prefixed name");
}

}  // namespace

owl::Iri find_in_ontology(const owl::Ontology& ontology, const Name& name,
                          const std::vector<owl::EntityKind>& kinds, const std::string& code) {
  std::vector<owl::Iri> found;
  for (const owl::Iri iri : ontology.lookup(name.text))
    if (is_one_of(ontology, iri, kinds)) found.push_back(iri);
  const bool exact = std::any_of(found.begin(), found.end(),
                                 [&](owl::Iri iri) { return ontology.local_name(iri) == name.text; });
  if (exact) std::erase_if(found, [&](owl::Iri iri) { return ontology.local_name(iri) != name.text; });
  // A user's own Thing goes before owl:Thing.
  if (found.size() > 1)
    std::erase_if(found, [&](owl::Iri iri) {
      return ontology.text(iri).starts_with("http://www.w3.org/2002/07/owl#");
    });
  if (found.size() == 1) return found.front();
  if (found.empty())
    throw util::InputError(name.location, code,
                           fmt::format("the ontology has no {} '{}'", noun_of(kinds), name.text),
                           util::suggestion(name.text, known_names(ontology, kinds)));
  std::vector<std::string> meanings;
  meanings.reserve(found.size());
  for (const owl::Iri iri : found) meanings.push_back(fmt::format("<{}>", ontology.text(iri)));
  refuse_ambiguous(name, meanings);
}

std::size_t find_callable(const std::vector<Callable>& things, const Name& name, const std::string& noun) {
  std::size_t ranks = 0;
  for (const Callable& thing : things) ranks = std::max(ranks, thing.words.size());
  for (std::size_t rank = 0; rank < ranks; ++rank) {
    std::vector<const Callable*> found;
    for (const Callable& thing : things)
      if (rank < thing.words.size() && thing.words[rank] == name.text) found.push_back(&thing);
    if (found.size() == 1) return found.front()->index;
    if (found.size() > 1) {
      std::vector<std::string> meanings;
      meanings.reserve(found.size());
      for (const Callable* thing : found) meanings.push_back("'" + thing->words.front() + "'");
      refuse_ambiguous(name, meanings);
    }
  }
  std::vector<std::string> known;
  for (const Callable& thing : things) known.insert(known.end(), thing.words.begin(), thing.words.end());
  std::sort(known.begin(), known.end());
  known.erase(std::unique(known.begin(), known.end()), known.end());
  const std::string near = util::nearest(name.text, known);
  std::vector<std::string> atoms;
  atoms.reserve(things.size());
  for (const Callable& thing : things) atoms.push_back(thing.words.front());
  throw util::InputError(name.location, "unknown-" + noun,
                         fmt::format("the catalogue has no {} '{}'", noun, name.text),
                         util::suggestion(name.text, near.empty() ? atoms : known));
}

}  // namespace heed::awareness
