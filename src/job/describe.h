#pragma once

#include <heed/job/controller.h>
#include <heed/job/tune.h>
#include <heed/report/result.h>
#include <heed/sim/lumping.h>

namespace heed::job {

/// From the pipeline's values to the report's plain structs.
[[nodiscard]] report::Ontology describe_ontology(const Scenario& scenario, const World& world,
                                                 const std::vector<const Design*>& designs);
[[nodiscard]] std::vector<report::KnowledgeFormula> describe_sigma(const World& world, const Design& design);
[[nodiscard]] std::vector<report::SpecificationSection> describe_specification(const spec::Gr1& spec);
[[nodiscard]] report::Controller describe_controller(const World& world, const ControllerPart& part,
                                                     const Design& design, const Synthesized& synthesized);
/// "stop 1/10, nothing 9/10", or in order "stop, nothing".
[[nodiscard]] std::string describe_road(const World& world, const RoadPart& road);
[[nodiscard]] report::CatalogueEntry describe_entity(const Scenario& scenario, const World& world,
                                                     std::size_t entity);
/// Everything that the figures rest on, sentence by sentence. \param traces  Per chart. \param seed  Of them.
[[nodiscard]] std::vector<std::string> describe_method(const Scenario& scenario, const World& world,
                                                       std::uint64_t traces, std::uint64_t seed);
[[nodiscard]] report::Number number(const sim::Rational& value);
/// A fraction too long to be read is left out.
[[nodiscard]] report::Number number(const sim::Figure& figure);

}  // namespace heed::job
