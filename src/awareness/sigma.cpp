#include <heed/awareness/sigma.h>

#include "concepts.h"
#include "told.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace heed::awareness {
namespace {

class SigmaBuilder {
 public:
  SigmaBuilder(const Catalogue& catalogue, const Perception& perception, const Recognition& recognition)
      : catalogue_(catalogue), perception_(perception), recognition_(recognition) {
    for (const RecognisedEntity& r : recognition.entities) entities_.insert(r.entity);
    for (const PrescribedBehaviour& p : recognition.behaviours) behaviours_.insert(p.behaviour);
  }

  void add_subclasses();
  void add_recognitions();
  void add_prescriptions(bool inherited);
  void add_disjointness();
  std::vector<SigmaFormula> take() { return std::move(formulas_); }

 private:
  SigmaFormula& add(SigmaKind kind, const logic::Formula& body, Axioms axioms, std::string sentence);
  /// The things that \p atoms are seen of are an \p entity.
  [[nodiscard]] std::vector<Inclusion> recognition(const std::vector<std::string>& atoms,
                                                   std::size_t entity) const;
  /// Why the prescription follows from other formulas; empty when it does not.
  [[nodiscard]] std::string inherited_from(std::size_t entity, std::size_t behaviour) const;
  [[nodiscard]] std::string words_for(const std::string& atom) const;
  [[nodiscard]] logic::Formula entity_atom(std::size_t e) const {
    return logic::name(catalogue_.entities[e].atom);
  }
  [[nodiscard]] logic::Formula behaviour_atom(std::size_t b) const {
    return logic::name(catalogue_.behaviours[b].atom);
  }

  const Catalogue& catalogue_;
  const Perception& perception_;
  const Recognition& recognition_;
  std::set<std::size_t> entities_, behaviours_;
  std::vector<SigmaFormula> formulas_;
};

SigmaFormula& SigmaBuilder::add(SigmaKind kind, const logic::Formula& body, Axioms axioms,
                                std::string sentence) {
  formulas_.push_back({fmt::format("k{}", formulas_.size() + 1), logic::always(body), kind, std::move(axioms),
                       std::move(sentence)});
  return formulas_.back();
}

std::vector<Inclusion> SigmaBuilder::recognition(const std::vector<std::string>& atoms,
                                                 std::size_t entity) const {
  std::vector<owl::ClassExpression> parts;
  for (std::size_t f = 0; f < catalogue_.features.size(); ++f)
    if (std::binary_search(atoms.begin(), atoms.end(), perception_.feature_atom[f]))
      parts.push_back(concept_of(catalogue_.features[f]));
  for (std::size_t e = 0; e < catalogue_.entities.size(); ++e)
    if (std::binary_search(atoms.begin(), atoms.end(), perception_.whole_atom[e]))
      parts.push_back(concept_of(catalogue_.entities[e]));
  if (parts.size() != atoms.size()) return {};  // levels of a tree, things that are missing
  return {{owl::ClassExpression::intersection(std::move(parts)), concept_of(catalogue_.entities[entity])}};
}

std::string SigmaBuilder::words_for(const std::string& atom) const {
  for (std::size_t f = 0; f < catalogue_.features.size(); ++f)
    if (perception_.feature_atom[f] == atom) return fmt::format("'{}' is seen", catalogue_.features[f].label);
  for (std::size_t e = 0; e < catalogue_.entities.size(); ++e)
    if (perception_.whole_atom[e] == atom)
      return fmt::format("'{}' is read whole", catalogue_.entities[e].label);
  for (const LevelMemory& memory : recognition_.memories)
    if (memory.name == atom) return memory.comment;
  return atom;
}

void SigmaBuilder::add_subclasses() {
  for (const std::size_t e : entities_)
    for (const Entailed& up : catalogue_.entities[e].parents)
      if (entities_.contains(up.index))
        add(SigmaKind::Subclass, logic::implies(entity_atom(e), entity_atom(up.index)), up.axioms,
            fmt::format("Every '{}' is a '{}'.", catalogue_.entities[e].label,
                        catalogue_.entities[up.index].label))
            .entailed = inclusions_below(catalogue_, e, up.index);
  for (const std::size_t b : behaviours_)
    for (const Entailed& up : catalogue_.behaviours[b].parents)
      if (behaviours_.contains(up.index))
        add(SigmaKind::Subclass, logic::implies(behaviour_atom(b), behaviour_atom(up.index)), up.axioms,
            fmt::format("To '{}' is to '{}' at the same time.", catalogue_.behaviours[b].label,
                        catalogue_.behaviours[up.index].label))
            .entailed = inclusions_special(catalogue_, b, up.index);
}

void SigmaBuilder::add_recognitions() {
  for (const RecognisedEntity& recognised : recognition_.entities) {
    const Entity& entity = catalogue_.entities[recognised.entity];
    for (const Evidence& evidence : recognised.own) {
      if (evidence.atoms == std::vector<std::string>{entity.atom}) continue;
      std::vector<logic::Formula> atoms;
      std::vector<std::string> words;
      // Features in the order of the catalogue read better than sorted names: sign, red, octagon.
      for (const auto& [symbol, meaning] : perception_.symbols)
        if (std::binary_search(evidence.atoms.begin(), evidence.atoms.end(), symbol)) {
          atoms.push_back(logic::name(symbol));
          words.push_back(words_for(symbol));
        }
      for (const LevelMemory& memory : recognition_.memories)
        if (std::binary_search(evidence.atoms.begin(), evidence.atoms.end(), memory.name)) {
          atoms.push_back(logic::name(memory.name));
          words.push_back(words_for(memory.name));
        }
      add(SigmaKind::Recognition,
          logic::implies(logic::all_of(std::move(atoms)), entity_atom(recognised.entity)), evidence.axioms,
          fmt::format("It counts as '{}' when {}.", entity.label, fmt::join(words, " and ")))
          .entailed = recognition(evidence.atoms, recognised.entity);
    }
  }
}

std::string SigmaBuilder::inherited_from(std::size_t entity, std::size_t behaviour) const {
  for (const Entailed& up : catalogue_.entities[entity].ancestors) {
    const bool equivalent = catalogue_.is_below(up.index, entity) != nullptr;
    if ((!equivalent || up.index < entity) && entities_.contains(up.index) &&
        catalogue_.prescribes(up.index, behaviour))
      return fmt::format("every '{}' is a '{}'", catalogue_.entities[entity].label,
                         catalogue_.entities[up.index].label);
  }
  for (const Entailed& act : catalogue_.entities[entity].behaviours)
    for (const Entailed& up : catalogue_.behaviours[act.index].general)
      if (up.index == behaviour && act.index != behaviour && behaviours_.contains(act.index))
        return fmt::format("it prescribes '{}', which is to '{}'", catalogue_.behaviours[act.index].label,
                           catalogue_.behaviours[behaviour].label);
  return "";
}

void SigmaBuilder::add_prescriptions(bool inherited) {
  for (const std::size_t e : entities_)
    for (const Entailed& act : catalogue_.entities[e].behaviours) {
      const std::string from = inherited_from(e, act.index);
      if (from.empty() == inherited || !behaviours_.contains(act.index)) continue;
      std::string sentence = fmt::format("A '{}' prescribes to '{}' next", catalogue_.entities[e].label,
                                         catalogue_.behaviours[act.index].label);
      if (inherited) sentence += fmt::format(", inherited: {}", from);
      SigmaFormula& formula =
          add(SigmaKind::Prescription, logic::implies(entity_atom(e), logic::next(behaviour_atom(act.index))),
              act.axioms, sentence + ".");
      formula.inherited = inherited;
      formula.entailed = inclusions_prescribes(catalogue_, e, act.index);
    }
}

void SigmaBuilder::add_disjointness() {
  for (const auto& [pair, why] : catalogue_.exclusive) {
    if (!perception_.perceivable[pair.first] || !perception_.perceivable[pair.second]) continue;
    const auto atom = [&](std::size_t f) { return logic::name(perception_.feature_atom[f]); };
    add(SigmaKind::Disjointness, !(atom(pair.first) && atom(pair.second)), why,
        fmt::format("Nothing has both '{}' and '{}'.", catalogue_.features[pair.first].label,
                    catalogue_.features[pair.second].label))
        .entailed = {{owl::ClassExpression::intersection({concept_of(catalogue_.features[pair.first]),
                                                          concept_of(catalogue_.features[pair.second])}),
                      owl::ClassExpression::nothing()}};
  }
}

}  // namespace

std::string_view to_string(SigmaKind kind) {
  constexpr std::array<std::string_view, 4> words{"subclass", "recognition", "prescription", "disjointness"};
  return words[static_cast<std::size_t>(kind)];
}

std::vector<SigmaFormula> build_sigma(const Catalogue& catalogue, const Perception& perception,
                                      const Recognition& recognition, const SigmaOptions& options) {
  SigmaBuilder builder(catalogue, perception, recognition);
  builder.add_recognitions();
  builder.add_prescriptions(false);
  builder.add_subclasses();
  if (options.disjointness) builder.add_disjointness();
  builder.add_prescriptions(true);
  return builder.take();
}

}  // namespace heed::awareness
