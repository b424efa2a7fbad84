#pragma once

#include <heed/awareness/catalogue.h>
#include <heed/dl/reasoner.h>
#include <heed/job/scenario.h>
#include <heed/owl/ontology.h>
#include <heed/util/diagnostic.h>
#include <heed/util/limits.h>

#include <memory>
#include <string>

namespace heed::job {

/// An ontology, understood: read, classified, and cut to its catalogue.
struct Knowledge {
  owl::Ontology ontology;
  std::shared_ptr<const dl::Reasoner> reasoner;
  awareness::Catalogue catalogue;
  util::Diagnostics diagnostics;  ///< Of reading, classification and catalogue, in this order.
};

/// Loads the ontology with its imports, classifies it and builds the catalogue. \throws util::InputError,
/// LimitExceeded
[[nodiscard]] Knowledge load_knowledge(const KnowledgePart& part, const util::Limits& limits,
                                       util::Budget& budget);

/// Adds to the catalogue's warnings what is to be said of how a scenario uses it: symbols that exclude less
/// than they could, behaviours that are prescribed and bound to nothing. What of the scenario does not fit
/// the catalogue is said in \p notes instead.
void judge_scenario(const Scenario& scenario, Knowledge& knowledge, util::Diagnostics& notes);

/// The part for an ontology that comes without a scenario: roots and roles are read off its structure (a role
/// named after actions or behaviours binds what is prescribed, every other role that describes the same
/// classes binds features; where nothing but individuals is described, these are the things). Says in \p
/// notes what it took. \param known  names the ontology, and may name the action roles and the subclass role.
/// \throws util::InputError  nothing fits: the message says what to choose from.
[[nodiscard]] KnowledgePart guess_knowledge(const KnowledgePart& known, const util::Limits& limits,
                                            util::Budget& budget, util::Diagnostics& notes);

/// \throws util::InputError "unsatisfiable-entity" when an entity can have no instance, saying which and why.
void refuse_unsatisfiable(const Knowledge& knowledge, const KnowledgePart& part);

/// \throws util::InputError when reading had to leave an axiom out, with the code and the place of the first.
void refuse_left_out(const Knowledge& knowledge, const KnowledgePart& part);

}  // namespace heed::job
