#include "play_parts.h"

#include <heed/awareness/observation.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace heed::job {
namespace {

using awareness::Catalogue;
using awareness::Feature;
using awareness::PerceptionInput;

constexpr std::size_t candidate_letter_limit = 20'000, candidate_pair_limit = 1'000'000;

std::string with_blanks(std::string atom) {
  std::replace(atom.begin(), atom.end(), '_', ' ');
  return atom;
}

report::PlayFeature describe_feature(const Catalogue& catalogue, const Feature& feature) {
  report::PlayFeature out;
  out.label = feature.label;
  out.value = catalogue.ontology.name(feature.filler, catalogue.language);
  if (feature.kind != Feature::Kind::Class) out.aspect = with_blanks(feature.role_atom);
  return out;
}

std::string words_for(const report::PlayFeature& feature) {
  return feature.aspect.empty() ? feature.label : feature.aspect + " " + feature.value;
}

std::optional<std::size_t> leaf_index(const std::vector<std::size_t>& leaves, std::size_t entity) {
  const auto found = std::find(leaves.begin(), leaves.end(), entity);
  if (found == leaves.end()) return std::nullopt;
  return static_cast<std::size_t>(found - leaves.begin());
}

/// What a feature is called and drawn by: `hasFeature some Octagon` is a shape where that is the one way to
/// have an octagon.
std::size_t shown_feature(const Catalogue& catalogue, std::size_t feature) {
  std::optional<std::size_t> special;
  for (std::size_t f = 0; f < catalogue.features.size(); ++f) {
    if (f == feature || catalogue.features[f].filler != catalogue.features[feature].filler ||
        catalogue.implies(f, feature) == nullptr)
      continue;
    if (special) return feature;
    special = f;
  }
  return special.value_or(feature);
}

/// What a meaning is called, and which kind it is.
void describe_meaning(report::PlaySymbol& symbol, const PerceptionInput::Meaning& meaning,
                      const report::Play& play, const Catalogue& catalogue,
                      const std::vector<std::size_t>& leaves) {
  if (meaning.feature) {
    const Feature& feature = catalogue.features[*meaning.feature];
    symbol.kind = feature.entity ? "group" : "feature";
    symbol.feature = shown_feature(catalogue, *meaning.feature);
    symbol.label = words_for(play.features[*symbol.feature]);
    if (feature.entity) symbol.entity = leaf_index(leaves, *feature.entity);
  } else if (meaning.excluded) {
    symbol.kind = "missing";
    symbol.feature = shown_feature(catalogue, *meaning.excluded);
    symbol.label = "no " + words_for(play.features[*symbol.feature]);
  } else if (meaning.whole) {
    symbol.kind = "whole";
    symbol.label = fmt::format("the whole ‘{}’", catalogue.entities[*meaning.whole].label);
    symbol.entity = leaf_index(leaves, *meaning.whole);
  } else {
    symbol.kind = "view";
    symbol.label = "all there is to see";
  }
}

/// Meanings of the perception, in the order of the page's symbols.
std::vector<const PerceptionInput::Meaning*> meanings_of(const awareness::Perception& perception) {
  std::vector<const PerceptionInput::Meaning*> all;
  for (const PerceptionInput& input : perception.inputs)
    for (const PerceptionInput::Meaning& meaning : input.meanings) all.push_back(&meaning);
  return all;
}

void fill_symbols(report::Play& play, const World& world, const std::vector<std::size_t>& leaves) {
  for (const PerceptionInput& input : world.perception.inputs) {
    const auto column = std::find_if(play.inputs.begin(), play.inputs.end(),
                                     [&](const auto& variable) { return variable.name == input.name; });
    for (const PerceptionInput::Meaning& meaning : input.meanings) {
      report::PlaySymbol symbol{meaning.atom,
                                {},
                                {},
                                static_cast<std::size_t>(column - play.inputs.begin()),
                                static_cast<std::int32_t>(meaning.value)};
      describe_meaning(symbol, meaning, play, world.knowledge.catalogue, leaves);
      play.symbols.push_back(std::move(symbol));
    }
  }
}

/// Whether it can rightly be seen of \p entity.
bool shows(const Catalogue& catalogue, std::size_t entity, const PerceptionInput::Meaning& meaning) {
  if (meaning.feature) return catalogue.has_feature(entity, *meaning.feature) != nullptr;
  if (meaning.excluded) return catalogue.has_feature(entity, *meaning.excluded) == nullptr;
  if (!meaning.whole) return true;
  return entity == *meaning.whole || catalogue.is_below(entity, *meaning.whole) != nullptr;
}

bool prescribes_any(const Catalogue& catalogue, std::size_t entity, const std::vector<Word>& behaviours) {
  return std::any_of(behaviours.begin(), behaviours.end(), [&](const Word& word) {
    return catalogue.prescribes(entity, catalogue.behaviour(awareness::Name(word.text, word.location))) !=
           nullptr;
  });
}

report::PlayEntity describe_leaf(const Scenario& scenario, const World& world, std::size_t index) {
  const Catalogue& catalogue = world.knowledge.catalogue;
  const awareness::Entity& entity = catalogue.entities[index];
  report::PlayEntity out{entity.atom, entity.label, {}};
  if (!entity.parents.empty()) out.group = catalogue.entities[entity.parents.front().index].label;
  for (const awareness::Entailed& feature : catalogue.described(index)) out.features.push_back(feature.index);
  for (const awareness::Entailed& behaviour : entity.behaviours)
    out.prescribes.push_back(catalogue.behaviours[behaviour.index].label);
  if (scenario.evaluate && prescribes_any(catalogue, index, scenario.evaluate->must_react))
    out.react = "must";
  else if (scenario.evaluate && prescribes_any(catalogue, index, scenario.evaluate->may_react))
    out.react = "may";
  const auto meanings = meanings_of(world.perception);
  for (std::size_t s = 0; s < meanings.size(); ++s)
    if (shows(catalogue, index, *meanings[s])) out.shows.push_back(s);
  return out;
}

/// A letter of the inputs as an observation of the catalogue.
awareness::Observation observation_of(const report::Play& play, const World& world,
                                      const std::vector<std::int32_t>& letter) {
  const auto meanings = meanings_of(world.perception);
  awareness::Observation seen;
  bool all_in_view = false;
  for (std::size_t s = 0; s < meanings.size(); ++s) {
    if (letter[play.symbols[s].input] != play.symbols[s].value) continue;
    if (meanings[s]->feature)
      seen.seen.push_back(*meanings[s]->feature);
    else if (meanings[s]->whole)
      seen.whole.push_back(*meanings[s]->whole);
    else if (meanings[s]->excluded)
      seen.excluded.push_back(*meanings[s]->excluded);
    else
      all_in_view = true;
  }
  if (!all_in_view) return seen;
  for (const auto* meaning : meanings)
    if (meaning->feature &&
        std::find(seen.seen.begin(), seen.seen.end(), *meaning->feature) == seen.seen.end())
      seen.excluded.push_back(*meaning->feature);
  return seen;
}

}  // namespace

std::vector<std::size_t> play_leaves(const Catalogue& catalogue) {
  std::vector<std::size_t> leaves;
  for (std::size_t e = 0; e < catalogue.entities.size(); ++e)
    if (catalogue.entities[e].is_leaf() && catalogue.entities[e].satisfiable) leaves.push_back(e);
  return leaves;
}

void fill_play_catalogue(report::Play& play, const Scenario& scenario, const World& world) {
  const Catalogue& catalogue = world.knowledge.catalogue;
  const std::vector<std::size_t> leaves = play_leaves(catalogue);
  for (const Feature& feature : catalogue.features)
    play.features.push_back(describe_feature(catalogue, feature));
  fill_symbols(play, world, leaves);
  for (const std::size_t leaf : leaves) play.entities.push_back(describe_leaf(scenario, world, leaf));
}

void fill_play_candidates(report::Play& play, const World& world, util::Budget& budget) {
  const std::vector<std::size_t> leaves = play_leaves(world.knowledge.catalogue);
  if (play.observations.size() > candidate_letter_limit ||
      play.observations.size() * leaves.size() > candidate_pair_limit)
    return;
  const awareness::Judge judge(world.knowledge.catalogue, {true, {}});
  std::map<std::vector<std::size_t>, std::size_t> known;
  report::PlayCandidates candidates;
  for (const auto& letter : play.observations) {
    budget.check();
    std::vector<std::size_t> set;
    for (const std::size_t entity : judge(observation_of(play, world, letter)).candidates)
      if (const auto leaf = leaf_index(leaves, entity)) set.push_back(*leaf);
    const auto [at, fresh] = known.emplace(set, candidates.sets.size());
    if (fresh) candidates.sets.push_back(set);
    candidates.of.push_back(at->second);
  }
  play.candidates = std::move(candidates);
}

}  // namespace heed::job
