#include "components.h"

#include <algorithm>
#include <numeric>

#include "chain_join.h"
#include "profile_model.h"

namespace heed::sim {
namespace {

/// Which features hang together: sets that grow.
class Sets {
 public:
  explicit Sets(std::size_t size) : above_(size) { std::iota(above_.begin(), above_.end(), 0U); }
  std::uint32_t find(std::uint32_t one) {
    while (above_[one] != one) one = above_[one] = above_[above_[one]];
    return one;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a), b = find(b);
    above_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> above_;
};

Sets together(const ProfileModel& model, const Binding& binding) {
  Sets sets(model.names.size());
  for (const DrawUnit& unit : model.units) {
    for (const std::uint32_t f : unit.features) sets.join(unit.features.front(), f);
    for (const std::uint32_t f : unit.parents) sets.join(unit.features.front(), f);
  }
  for (const auto* kind : {&model.misread_in_cell, &model.misread_for_good})
    for (std::uint32_t f = 0; f < kind->size(); ++f)
      for (const ReadAs& one : (*kind)[f]) sets.join(f, one.feature);
  for (const Binding::Wire& a : binding.wires)
    for (const Binding::Wire& b : binding.wires)
      if (a.input == b.input) sets.join(a.feature, b.feature);
  return sets;
}

/// The profile with only the component's features. Rules of the others are none of theirs.
ProfileSpec only(const ProfileSpec& profile, const std::vector<std::uint32_t>& features) {
  ProfileSpec part = profile;
  part.features.clear();
  for (const std::uint32_t f : features) part.features.push_back(profile.features[f]);
  std::erase_if(part.shuffles, [&](const ShuffleSpec& shuffle) {
    return std::none_of(part.features.begin(), part.features.end(),
                        [&](const FeatureSpec& f) { return f.name == shuffle.features.front(); });
  });
  std::erase_if(part.misreadings, [&](const Misreading& misreading) {
    return std::none_of(part.features.begin(), part.features.end(),
                        [&](const FeatureSpec& f) { return f.name == misreading.of; });
  });
  return part;
}

std::vector<std::uint64_t> letters_of(const Chain& chain) {
  std::vector<std::uint64_t> letters;
  for (const Chain::Step& step : chain.steps) letters.push_back(step.seen);
  std::sort(letters.begin(), letters.end());
  letters.erase(std::unique(letters.begin(), letters.end()), letters.end());
  return letters;
}

/// Moves each component behind the last one with the same chain.
void put_side_by_side(std::vector<Component>& components) {
  std::vector<Component> sorted;
  for (Component& component : components) {
    const auto same = std::find_if(sorted.rbegin(), sorted.rend(), [&](const Component& other) {
      return same_chain(other.chain, component.chain);
    });
    sorted.insert(same == sorted.rend() ? sorted.end() : same.base(), std::move(component));
  }
  components = std::move(sorted);
}

}  // namespace

bool same_chain(const Chain& a, const Chain& b) {
  return a.first == b.first && std::equal(a.steps.begin(), a.steps.end(), b.steps.begin(), b.steps.end(),
                                          [](const Chain::Step& x, const Chain::Step& y) {
                                            return x.next == y.next && x.seen == y.seen &&
                                                   x.probability == y.probability;
                                          });
}

std::vector<Component> compile_components(const ProfileSpec& profile, const Binding& binding,
                                          util::Budget& budget) {
  const ProfileModel model(profile);
  Sets sets = together(model, binding);
  std::vector<Component> components;
  for (std::uint32_t root = 0; root < model.names.size(); ++root) {
    if (sets.find(root) != root) continue;
    Component component;
    for (std::uint32_t f = root; f < model.names.size(); ++f)
      if (sets.find(f) == root) component.features.push_back(f);
    for (const Binding::Wire& wire : binding.wires)
      if (sets.find(wire.feature) == root) component.inputs.push_back(wire.input);
    std::sort(component.inputs.begin(), component.inputs.end());
    component.inputs.erase(std::unique(component.inputs.begin(), component.inputs.end()),
                           component.inputs.end());
    component.chain = compile(only(profile, component.features), budget);
    component.letters = letters_of(component.chain);
    if (component.letters.size() > 1 || component.letters.front() != 0)
      components.push_back(std::move(component));
  }
  put_side_by_side(components);
  return components;
}

void show(const Component& component, const Binding& binding, std::uint64_t letter,
          model::Valuation& values) {
  for (const Binding::Wire& wire : binding.wires) {
    const auto place = std::lower_bound(component.features.begin(), component.features.end(), wire.feature);
    if (place == component.features.end() || *place != wire.feature) continue;
    if (letter >> (place - component.features.begin()) & 1) values[wire.input] = wire.value;
  }
}

}  // namespace heed::sim
