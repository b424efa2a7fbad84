#pragma once

#include <heed/spec/compose.h>
#include <heed/spec/gr1.h>

#include <vector>

namespace heed::spec {

/// General LTL on its way into a specification.
struct Requirements {
  std::vector<Requirement> assumptions, guarantees;
  Origin origin = Origin::Task;
};

/// Lowers \p requirements to GR(1) and adds what comes out to \p spec: clauses, and the memories and
/// definitions of monitors with names that are not taken. \throws util::InputError  what is outside GR(1),
/// with the subformula
void add_requirements(Gr1& spec, const Requirements& requirements);

}  // namespace heed::spec
