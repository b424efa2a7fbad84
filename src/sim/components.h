#pragma once

#include <heed/sim/profile.h>
#include <heed/sim/run.h>
#include <heed/util/limits.h>

#include <cstdint>
#include <vector>

namespace heed::sim {

/// Features whose onsets depend on each other, or that show on the same input of the machine: what different
/// components report is independent. Together the components draw what compile() draws at once.
struct Component {
  std::vector<std::uint32_t> features;  ///< Of the profile, ascending.
  std::vector<std::uint32_t> inputs;    ///< Of the machine, that these features show on; ascending.
  Chain chain;                          ///< Over `features`: bit i of what is seen is features[i].
  std::vector<std::uint64_t> letters;   ///< What the chain can show; ascending.
};

/// The components of \p profile that ever show anything; those with the same chain stand side by side.
/// \throws as compile() does, for each component
[[nodiscard]] std::vector<Component> compile_components(const ProfileSpec& profile, const Binding& binding,
                                                        util::Budget& budget);

/// Whether the two report the same with the same probabilities.
[[nodiscard]] bool same_chain(const Chain& a, const Chain& b);

/// What \p letter of the component brings to the inputs of \p binding. \pre one value per input in \p values
void show(const Component& component, const Binding& binding, std::uint64_t letter, model::Valuation& values);

}  // namespace heed::sim
