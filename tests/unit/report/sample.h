#pragma once

#include <heed/report/result.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

/// A result with the exact figures of the stop-sign case study, written by hand: what the writers are held
/// against.
namespace heed::report::sample {

inline util::Location at(const char* file, std::uint32_t line) {
  return {std::make_shared<const std::string>(file), line, 5};
}

/// "131/288" or "1" and its double.
inline Number rational(const std::string& text) {
  const auto slash = text.find('/');
  const double top = std::stod(text.substr(0, slash));
  const double bottom = slash == std::string::npos ? 1 : std::stod(text.substr(slash + 1));
  return {text, top / bottom, 0};
}

/// Wilson's interval at 95 %.
inline std::pair<double, double> wilson(double hits, double traces) {
  const double z = 1.959963984540054, p = hits / traces, d = 1 + z * z / traces;
  const double middle = (p + z * z / (2 * traces)) / d;
  const double half = z / d * std::sqrt(p * (1 - p) / traces + z * z / (4 * traces * traces));
  return {std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

/// Counts that stray from their expectation by a little, up and down in turn, and add up to 10,000.
inline Chart chart(const char* profile, const char* controller, const std::vector<std::string>& exact) {
  constexpr double traces = 10'000;
  const std::vector<std::string> labels{"infeasible", "stop in 1", "stop in 2", "stop in 3", "stop in 4"};
  Chart result{profile, controller, {}, 10'000, 0, 0, 1};
  std::uint64_t left = result.traces;
  std::size_t last = 0;
  for (std::size_t i = 0; i < exact.size(); ++i)
    if (exact[i] != "0") last = i;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    Bar bar{labels[i], rational(exact[i]), 0, 0, 0};
    const double expected = bar.exact.value * traces;
    const double stray = (i % 2 == 0 ? 0.6 : -0.7) * std::sqrt(expected * (1 - bar.exact.value));
    bar.sampled = i == last ? left : static_cast<std::uint64_t>(std::lround(expected + stray));
    left -= bar.sampled;
    std::tie(bar.low, bar.high) = wilson(static_cast<double>(bar.sampled), traces);
    if (expected > 0) {
      result.chi_square += std::pow(static_cast<double>(bar.sampled) - expected, 2) / expected;
      ++result.degrees_of_freedom;
    }
    result.bars.push_back(bar);
  }
  if (result.degrees_of_freedom > 0) --result.degrees_of_freedom;
  result.p_value = std::exp(-result.chi_square / 2);
  return result;
}

inline std::vector<Chart> charts() {
  return {
      chart("P1", "base", {"5/8", "3/16", "3/16", "0", "0"}),
      chart("P1", "tree", {"13/32", "5/32", "3/16", "1/4", "0"}),
      chart("P1", "awareness", {"19/64", "9/64", "3/16", "3/8", "0"}),
      chart("P2", "base", {"2/3", "1/3", "0", "0", "0"}),
      chart("P2", "tree", {"1/6", "1/3", "1/3", "1/6", "0"}),
      chart("P2", "awareness", {"0", "1/3", "1/3", "1/3", "0"}),
      chart("P3", "base", {"129691/144000", "20111/288000", "19153/864000", "671/108000", "1/864"}),
      chart("P3", "tree", {"631/800", "157/1200", "419/7200", "1/45", "0"}),
      chart("P3", "awareness", {"19/40", "19/80", "37/240", "11/120", "1/24"}),
  };
}

inline Axiom axiom(const char* id, const char* text, std::uint32_t line) {
  return {id, text, at("traffic-signs.owl", line)};
}

inline Ontology ontology() {
  return {
      "https://example.org/traffic-signs",
      "examples/stop-sign/traffic-signs.owl",
      412,
      96,
      11,
      0,
      36,
      27,
      9,
      {axiom(
           "a1",
           "StopSign EquivalentTo: Sign and Octagon and (hasMainColour some Red) and (hasText some StopText)",
           812),
       axiom("a2", "StopSign SubClassOf: prescribes some Halt", 826),
       axiom("a3", "StopSign SubClassOf: prescribes some GiveWay", 833),
       axiom("a4", "Sign SubClassOf: prescribes some SlowDown", 790),
       axiom("a5", "DisjointClasses: Red, Blue, Yellow, White", 1204)}};
}

inline std::vector<KnowledgeFormula> knowledge() {
  const Ontology o = ontology();
  return {
      {"k1", "subclass", "G(stop_sign -> sign)", "What is a stop sign is a sign.", {o.excerpt[0]}},
      {"k2",
       "recognition",
       "G(sign & red -> stop_sign_recognised)",
       "Sign and red together are taken for the stop sign.",
       {o.excerpt[0]}},
      {"k3",
       "recognition",
       "G(sign & octagon -> stop_sign_recognised)",
       "Sign and octagon together are taken for the stop sign.",
       {o.excerpt[0]}},
      {"k4",
       "recognition",
       "G(red & octagon -> stop_sign_recognised)",
       "Red and octagon together are taken for the stop sign.",
       {o.excerpt[0]}},
      {"k5",
       "prescription",
       "G(stop_sign_recognised -> X halt)",
       "A recognised stop sign prescribes halting.",
       {o.excerpt[1]}},
      {"k6", "prescription", "G(sign -> X slow_down)", "Every sign prescribes slowing down.", {o.excerpt[3]}},
      {"k7", "disjointness", "G(!(red & blue))", "Nothing is red and blue.", {o.excerpt[4]}},
  };
}

inline std::vector<SpecificationSection> specification() {
  return {
      {"env_init",
       "What holds at the first step",
       {{"!sign & !red & !octagon & !stop_sign", "perception", {}}}},
      {"env_safety",
       "What perception is assumed to keep",
       {{"G(location != 0 & sign -> X sign)", "perception", {}},
        {"G(location != 0 & red -> X red)", "perception", {}},
        {"G(red | octagon -> sign)", "perception", {}},
        {"G(stop_sign -> red | octagon)", "perception", {}}}},
      {"sys_safety",
       "What the controller must keep",
       {{"G(detected <-> X stopping)", "binding", {"a2"}},
        {"G(M1 & action = hard_stop -> X S0)", "plant", {}}}},
      {"sys_justice",
       "What it must reach again and again",
       {{"G F location = 0", "task", {}}, {"G F location != 0", "task", {}}}},
  };
}

inline std::vector<Controller> controllers() {
  Controller base{"base", "Base", "the whole stop sign is read"};
  base.states = 21, base.transitions = 189, base.states_before_minimisation = 97;
  base.product_states = 412, base.product_edges = 3'708;
  base.assumptions = {"G(location != 0 & sign -> X sign)", "G(stop_sign -> red | octagon)"};
  base.file = "out/base.json";
  base.evidence = {{{"stop_sign"}, "stop sign", {}}};
  Controller tree = base;
  tree.name = "tree", tree.title = "Perception tree", tree.states = 34, tree.transitions = 306;
  tree.policy = "the tree sign → red is walked one level a step";
  tree.file = "out/tree.json";
  tree.evidence = {{{"sign one step before", "red"}, "stop sign", {"a1"}}};
  Controller awareness = base;
  awareness.name = "awareness", awareness.title = "Awareness";
  awareness.policy = "any two of sign, red, octagon are seen now";
  awareness.assumptions.clear();
  awareness.notes = {"keeps its guarantees without the perception assumptions"};
  awareness.file = "out/awareness.json";
  awareness.evidence = {{{"sign", "red"}, "stop sign", {"a1"}},
                        {{"sign", "octagon"}, "stop sign", {"a1"}},
                        {{"red", "octagon"}, "stop sign", {"a1"}}};
  return {base, tree, awareness};
}

inline std::vector<Profile> profiles() {
  return {
      {"P1",
       "visibility grows linearly",
       {"One draw decides in which cell the sign comes into view: 1/2, 5/8, 3/4, 7/8, 1.",
        "Red and octagon follow with probability 1/2 per cell, independently.",
        "The whole sign is read with probability 1/2 per cell once a part was seen."}},
      {"P2",
       "closely consecutive",
       {"The sign appears in cell 0, 1 or 2; its parts in random order in the next two cells."}},
      {"P3",
       "loosely consecutive",
       {"The sign appears in cell 0 … 3; octagon, red and the whole sign after it, uniformly."}},
  };
}

/// Who stops for what, as probabilities per policy; the shape of the table is real, its figures are made up.
inline CatalogueEntry entry(const char* label, const char* group, std::vector<std::string> features,
                            std::vector<std::string> behaviours, int shared) {
  CatalogueEntry result{label, label, group, std::move(features), std::move(behaviours), false, false, {}};
  for (const std::string& behaviour : result.behaviours) {
    result.prescribes_halt = result.prescribes_halt || behaviour == "halt";
    result.prescribes_give_way = result.prescribes_give_way || behaviour == "give way";
  }
  for (const Chart& one : charts()) {
    const double miss = one.bars[0].exact.value;
    Encounter encounter{one.profile, one.controller, {}, {}, {}};
    const bool takes = shared >= 3 || (shared == 2 && one.controller != "base") ||
                       (shared == 1 && one.controller == "awareness");
    encounter.stop = result.prescribes_halt ? Number{"", 1 - miss, 1e-15}
                     : takes                ? Number{"", (1 - miss) / 2, 1e-15}
                                            : Number{"0", 0, 0};
    if (result.prescribes_halt) encounter.miss = one.bars[0].exact;
    if (!result.prescribes_halt && !result.prescribes_give_way) encounter.needless = encounter.stop;
    result.encounters.push_back(std::move(encounter));
  }
  return result;
}

inline std::vector<CatalogueEntry> catalogue() {
  CatalogueEntry open_road = entry("no sign", "", {}, {}, 0);
  open_road.name.clear();
  return {
      open_road,
      entry("Stop", "priority", {"octagon", "red", "text STOP"}, {"halt", "give way", "slow down"}, 3),
      entry("Give way", "priority", {"inverted triangle", "red border", "white ground"},
            {"give way", "slow down"}, 0),
      entry("Priority road", "priority", {"lozenge", "yellow"}, {"proceed", "slow down"}, 0),
      entry("No entry", "prohibitory", {"circle", "red"}, {"slow down", "turn back"}, 2),
      entry("Maximum speed", "prohibitory", {"circle", "red border", "white ground"}, {"slow down"}, 0),
      entry("No overtaking", "prohibitory", {"circle", "red border"}, {"slow down"}, 0),
      entry("Customs post", "prohibitory", {"octagon", "white ground"}, {"slow down"}, 1),
      entry("Roundabout", "mandatory", {"circle", "blue"}, {"slow down"}, 0),
      entry("Children", "danger warning", {"triangle", "red border"}, {"slow down"}, 0),
      entry("Hospital", "information", {"square", "blue"}, {"slow down"}, 0),
  };
}

/// Two drives along one road; only one of the controllers can tell a conflict, and has a long run.
inline std::vector<Road> roads() {
  Road road{"town", "through town", "nothing with probability 9/10, stop with probability 1/10", 20};
  road.drives.resize(2);
  for (Drive& drive : road.drives) drive.profile = "P1";
  road.drives[0].controller = "base";
  road.drives[0].needless = rational("0");
  road.drives[0].misses = rational("5/4");
  road.drives[0].no_answer = rational("0");
  road.drives[1] = road.drives[0];
  road.drives[1].controller = "awareness";
  road.drives[1].needless = rational("7/3");
  road.drives[1].conflict = rational("1/8");
  road.drives[1].long_needless = rational("7/60");
  road.drives[1].long_misses = rational("1/16");
  road.drives[1].long_conflicts = rational("1/160");
  return {road};
}

/// Three policies with the figures of the case study, the last one no controller of the run.
inline Tuning tuning() {
  struct Row {
    const char *policy, *controller, *miss, *needless, *distance, *braking;
    bool on_front;
  };
  const auto figures = [](const char* profile, const std::vector<Row>& rows, Tuning& out) {
    for (const Row& row : rows) {
      TunedPolicy one{row.policy,
                      profile,
                      "0",
                      row.controller,
                      rational(row.miss),
                      rational(row.needless),
                      rational(row.distance)};
      one.braking = rational(row.braking);
      one.hardest = Number{"", 9.645, 1e-3};
      one.on_front = row.on_front;
      out.figures.push_back(std::move(one));
    }
  };
  Tuning out;
  figures("P1",
          {{"at least 2", "awareness", "19/64", "22/43", "105/64", "5", true},
           {"tree-or-full", "", "47/128", "0", "173/128", "11/2", true},
           {"read whole", "base", "5/8", "0", "9/16", "7", false}},
          out);
  figures("P2",
          {{"at least 2", "awareness", "0", "22/43", "2", "6", true},
           {"tree-or-full", "", "1/6", "0", "3/2", "13/2", true},
           {"read whole", "base", "2/3", "0", "1/3", "19/2", false}},
          out);
  out.bound = "1/10";
  out.best = "tree-or-full";
  out.things = 43;
  out.left_out = {"definition: nothing describes it"};
  return out;
}

inline RunResult result() {
  RunResult r;
  r.scenario = "stop-sign";
  r.description = "A car approaches a place where a stop sign may stand and must halt in front of it.";
  r.command = "heed run examples/stop-sign/stop-sign.toml";
  r.subject = "awareness";
  r.inputs = {{"scenario", "examples/stop-sign/stop-sign.toml", "8f14e45fceea167a"},
              {"ontology", "examples/stop-sign/traffic-signs.owl", "c9f0f895fb98ab91"},
              {"plant", "examples/stop-sign/car.fts", "45c48cce2e2d7fbd"}};
  r.ontology = ontology();
  r.knowledge = knowledge();
  r.specification = specification();
  r.warnings = {{util::Severity::Warning, at("traffic-signs.owl", 640), "unbound-behaviour",
                 "slowing down is prescribed by 36 signs and bound to nothing in the plant",
                 "bind it under [bind]", ""}};
  r.controllers = controllers();
  r.profiles = profiles();
  r.charts = charts();
  r.catalogue = catalogue();
  for (Chart& chart : r.charts) {
    chart.reaction = rational("105/64");
    chart.reaction_when_it_reacts = rational("7/3");
  }
  r.charts[0].conflict = rational("1/9");
  r.charts[1].broken = rational("1/16");
  r.charts[0].reaction_when_it_reacts.reset();
  r.roads = roads();
  r.road = {"M0", "M4", "M3", "M2", "M1", "M0"};
  r.speed = speed_picture(10, 50, 4);
  r.tuning = tuning();
  r.speed.curves[0].states = {"M0", "M4", "M3", "M2", "M1", "S0"};
  r.speed.curves[1].states = {"M0", "M4", "M3", "M2", "S1", "S0"};
  r.speed.curves[2].states = {"M0", "M4", "M3", "S2", "S1", "S0"};
  r.speed.curves[3].states = {"M0", "M4", "S3", "S2", "S1", "S0"};
  r.seed = 2024;
  r.method = {"Perception is persistent and flawless within one approach.",
              "Each bar is computed exactly as a rational from the controller read back from disk.",
              "Samples draw what is seen cell by cell and step the machine; trace i is the same on any "
              "number of threads."};
  r.versions = {{"heed", "0.1.0"}, {"pugixml", "1.13"}};
  r.timings = {{{"knowledge", 0.031},
                {"synthesis", 0.114},
                {"verification", 0.027},
                {"evaluation", 0.062},
                {"report", 0.004}},
               0.238,
               0.241,
               31'400'000};
  r.headline = headline_of(r);
  return r;
}

/// One controller, one chart: short enough for the documentation.
inline RunResult small() {
  RunResult r;
  r.scenario = "stop-sign";
  r.command = "heed run stop-sign.toml";
  r.inputs = {{"scenario", "stop-sign.toml", ""}};
  r.ontology.file = "traffic-signs.owl";
  r.ontology.axioms = 412;
  r.ontology.excerpt = {axiom("a2", "StopSign SubClassOf: prescribes some Halt", 826)};
  r.knowledge = {knowledge()[4]};
  r.specification = {
      {"sys_justice", "What it must reach again and again", {{"G F location = 0", "task", {}}}}};
  r.controllers = {controllers()[2]};
  r.profiles = {profiles()[1]};
  r.charts = {charts()[5]};
  r.charts[0].bars.resize(2);
  r.catalogue = {entry("No entry", "prohibitory", {"circle", "red"}, {"slow down"}, 2)};
  r.catalogue[0].encounters = {r.catalogue[0].encounters[5]};
  r.speed.curves = {{"stop in 4", 4, 2.411265, {"M0", "M4", "S3", "S2", "S1", "S0"}, {{40, 50}, {0, 0}}}};
  r.seed = 2024;
  r.versions = {{"heed", "0.1.0"}};
  r.headline = headline_of(r);
  return r;
}

}  // namespace heed::report::sample
