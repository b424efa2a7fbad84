#include "parts_scenario.h"

#include <fmt/format.h>
#include <heed/util/file.h>

#include <filesystem>

namespace heed::bench {
namespace {

/// "part_1<separator>part_2 ...", each inside \p form.
std::string each_part(unsigned parts, const std::string& form, const std::string& separator) {
  std::string out;
  for (unsigned i = 1; i <= parts; ++i) out += (i == 1 ? "" : separator) + fmt::format(fmt::runtime(form), i);
  return out;
}

std::string states(unsigned cells, char kind) {
  std::string out;
  for (unsigned location = cells; location-- > 0;) out += fmt::format(" {}{}", kind, location);
  return out;
}

}  // namespace

std::string ontology_text(const PartsScenario& wanted) {
  std::string out =
      "@prefix : <http://example.org/heed/parts#> .\n"
      "@prefix owl: <http://www.w3.org/2002/07/owl#> .\n"
      "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n\n"
      "<http://example.org/heed/parts> a owl:Ontology .\n"
      ":hasPart a owl:ObjectProperty .\n"
      ":hasAction a owl:ObjectProperty .\n"
      ":Sign a owl:Class .\n"
      ":Part a owl:Class .\n"
      ":Behaviour a owl:Class .\n"
      ":Halt a owl:Class ; rdfs:subClassOf :Behaviour .\n";
  for (unsigned i = 1; i <= wanted.parts; ++i)
    out += fmt::format(":Part{} a owl:Class ; rdfs:subClassOf :Part .\n", i);
  out +=
      ":StopSign a owl:Class ;\n"
      "  rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :hasAction ; owl:someValuesFrom :Halt ] ;\n"
      "  owl:equivalentClass [ a owl:Class ; owl:intersectionOf ( :Sign\n";
  for (unsigned i = 1; i <= wanted.parts; ++i)
    out +=
        fmt::format("    [ a owl:Restriction ; owl:onProperty :hasPart ; owl:someValuesFrom :Part{} ]\n", i);
  return out + "  ) ] .\n";
}

std::string plant_text(const PartsScenario& wanted) {
  const unsigned last = wanted.cells - 1;
  std::string out = fmt::format("states:{}{}\ninitial: M0\n\nlabel moving:{}\nlabel stopping:{}\n",
                                states(wanted.cells, 'M'), states(wanted.cells, 'S'),
                                states(wanted.cells, 'M'), states(wanted.cells, 'S'));
  out += "value location:";
  for (const char kind : {'M', 'S'})
    for (unsigned location = 0; location <= last; ++location)
      out += fmt::format(" {0}{1}={1}", kind, location);
  out += '\n';
  for (unsigned location = 0; location <= last; ++location) {
    const unsigned next = location == 0 ? last : location - 1;
    out += fmt::format("\nM{0} -go-> M{1}\nS{0} -go-> M{1}\nS{0} -slow_down-> S{1}\nM{0} -{2}-> S{1}\n",
                       location, next, location == 1 ? "hard_stop" : "slow_down");
  }
  return out;
}

std::string scenario_text(const PartsScenario& wanted) {
  const std::string any_part = each_part(wanted.parts, "part_{}", " | ");
  return fmt::format(
      "name = \"{0} parts, {1} cells\"\n\n"
      "[knowledge]\nontology = \"parts.ttl\"\n"
      "entities = [\"Sign\"]\nfeatures = [\"Part\"]\nbehaviours = [\"Behaviour\"]\n"
      "feature_roles = [\"hasPart\"]\naction_roles = [\"hasAction\"]\n\n"
      "[perception]\ninputs = [\n  {{ name = \"sign\", what = \"Sign\" }},\n{2}"
      "  {{ name = \"stop_sign\", what = \"StopSign\", whole = true }},\n]\n"
      "persistent = \"location != 0\"\n"
      "assume = [\"G({3} -> sign)\", \"G(stop_sign -> {3})\"]\n"
      "on_violation = \"{4}\"\n\n"
      "[plant]\nfts = \"car.fts\"\ninitial = [\"M0\"]\n\n"
      "[task]\nguarantees = [\"GF location = 0\", \"GF location != 0\"]\n\n"
      "[bind]\nonly_when_prescribed = true\nHalt = \"stopping\"\n\n"
      "[[controller]]\nname = \"awareness\"\npolicy = \"at-least\"\nk = 2\n"
      "over = [\"sign\", {5}]\nentities = [\"StopSign\"]\n",
      wanted.parts, wanted.cells,
      each_part(wanted.parts, "  {{ name = \"part_{0}\", what = \"Part{0}\" }},\n", ""), any_part,
      wanted.on_violation, each_part(wanted.parts, "\"part_{}\"", ", "));
}

std::string write_scenario(const PartsScenario& wanted, const std::string& folder) {
  std::filesystem::create_directories(folder);
  util::write_file(folder + "/parts.ttl", ontology_text(wanted));
  util::write_file(folder + "/car.fts", plant_text(wanted));
  util::write_file(folder + "/scenario.toml", scenario_text(wanted));
  return folder + "/scenario.toml";
}

}  // namespace heed::bench
