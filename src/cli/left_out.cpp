#include "left_out.h"

#include <heed/awareness/explain.h>
#include <heed/owl/print.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace heed::cli {

std::vector<std::string> LeftOut::touched(const dl::Dropped& dropped) const {
  const owl::Ontology& ontology = knowledge_.ontology;
  std::vector<std::string> names;
  for (const owl::Iri iri : dropped.signature)
    if (ontology.is(owl::EntityKind::Class, iri) || ontology.is(owl::EntityKind::NamedIndividual, iri))
      names.push_back(ontology.name(iri, knowledge_.catalogue.language));
  return names;
}

std::vector<owl::AxiomId> LeftOut::touching(std::size_t entity) const {
  const awareness::Catalogue& catalogue = knowledge_.catalogue;
  std::set<owl::Iri> above{catalogue.entities[entity].iri};
  for (const awareness::Entailed& up : catalogue.entities[entity].ancestors)
    above.insert(catalogue.entities[up.index].iri);
  std::vector<owl::AxiomId> axioms;
  for (const dl::Dropped& dropped : knowledge_.reasoner->incomplete()) {
    const bool speaks_of_it = std::any_of(dropped.signature.begin(), dropped.signature.end(),
                                          [&](owl::Iri iri) { return above.contains(iri); });
    if (speaks_of_it && (axioms.empty() || axioms.back() != dropped.axiom)) axioms.push_back(dropped.axiom);
  }
  return axioms;
}

std::string LeftOut::text() const {
  const auto& all = knowledge_.reasoner->incomplete();
  if (all.empty()) return "";
  std::set<owl::AxiomId> different;
  for (const dl::Dropped& dropped : all) different.insert(dropped.axiom);
  std::string out = fmt::format("\nLeft out: {} axioms are not used in full\n", different.size());
  for (const dl::Dropped& dropped : all) {
    constexpr std::size_t most = 8;
    auto names = touched(dropped);
    const std::size_t more = names.size() - std::min(names.size(), most);
    names.resize(names.size() - more);
    const owl::Axiom& axiom = knowledge_.ontology.axiom(dropped.axiom);
    out += fmt::format("- {} ({}): {}; it touches {}{}\n", owl::to_string(dropped.axiom),
                       util::to_string(axiom.location), dropped.why,
                       names.empty() ? "no class" : fmt::format("{}", fmt::join(names, ", ")),
                       more == 0 ? "" : fmt::format(" and {} more", more));
  }
  std::string entities;
  for (std::size_t e = 0; e < knowledge_.catalogue.entities.size(); ++e) {
    std::string ids;
    for (const owl::AxiomId id : touching(e)) ids += (ids.empty() ? "" : ", ") + owl::to_string(id);
    if (!ids.empty()) entities += fmt::format("  {}: {}\n", knowledge_.catalogue.entities[e].label, ids);
  }
  if (!entities.empty()) out += "Entities of which more may be true than is found\n" + entities;
  return out;
}

Json LeftOut::json() const {
  Json out = Json::array();
  for (const dl::Dropped& dropped : knowledge_.reasoner->incomplete()) {
    const owl::Axiom& axiom = knowledge_.ontology.axiom(dropped.axiom);
    Json one;
    one["axiom"] = owl::to_string(dropped.axiom);
    one["text"] = owl::to_text(axiom, knowledge_.ontology);
    one["location"] = to_json(axiom.location);
    one["why"] = dropped.why;
    one["touches"] = touched(dropped);
    out.push_back(std::move(one));
  }
  return out;
}

Json LeftOut::json(std::size_t entity) const {
  Json out = Json::array();
  for (const owl::AxiomId id : touching(entity)) out.push_back(owl::to_string(id));
  return out;
}

}  // namespace heed::cli
