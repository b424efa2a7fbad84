#include <heed/report/write.h>

#include <nlohmann/json.hpp>

#include "lookup.h"

namespace heed::report {

namespace {

using Json = nlohmann::ordered_json;

/// One overload per struct; a class, so that lists see the overloads that stand below them.
struct Document {
  static Json to_value(const Number& number) {
    Json value;
    value["exact"] = number.exact.empty() ? Json(nullptr) : Json(number.exact);
    value["value"] = number.value;
    value["error"] = number.error;
    return value;
  }

  static Json to_value(const std::optional<Number>& number) {
    return number ? to_value(*number) : Json(nullptr);
  }

  static Json to_value(const util::Location& location) {
    if (!location.file) return nullptr;
    return {{"file", *location.file}, {"line", location.line}, {"column", location.column}};
  }

  static Json to_value(const Axiom& axiom) {
    return {{"id", axiom.id}, {"text", axiom.text}, {"location", to_value(axiom.location)}};
  }

  template <typename T>
  static Json to_list(const std::vector<T>& items) {
    Json list = Json::array();
    for (const T& item : items) list.push_back(to_value(item));
    return list;
  }

  static Json to_value(const InputFile& file) {
    return {{"role", file.role}, {"path", file.path}, {"digest", file.digest}};
  }

  static Json to_value(const Ontology& ontology) {
    return {{"iri", ontology.iri},
            {"file", ontology.file},
            {"axioms", ontology.axioms},
            {"classes", ontology.classes},
            {"properties", ontology.properties},
            {"individuals", ontology.individuals},
            {"entities", ontology.entities},
            {"features", ontology.features},
            {"behaviours", ontology.behaviours},
            {"excerpt", to_list(ontology.excerpt)}};
  }

  static Json to_value(const KnowledgeFormula& formula) {
    return {{"id", formula.id},
            {"kind", formula.kind},
            {"text", formula.text},
            {"sentence", formula.sentence},
            {"axioms", to_list(formula.axioms)}};
  }

  static Json to_value(const SpecificationClause& clause) {
    return {{"text", clause.text}, {"origin", clause.origin}, {"axioms", clause.axioms}};
  }

  static Json to_value(const SpecificationSection& section) {
    return {{"name", section.name}, {"title", section.title}, {"clauses", to_list(section.clauses)}};
  }

  static Json to_value(const EvidenceRule& rule) {
    return {{"evidence", rule.evidence}, {"recognises", rule.recognises}, {"axioms", rule.axioms}};
  }

  static const char* name_of(Verdict verdict) {
    switch (verdict) {
      case Verdict::Verified:
        return "verified";
      case Verdict::Refuted:
        return "refuted";
      case Verdict::Unrealizable:
        break;
    }
    return "unrealizable";
  }

  static Json to_value(const Controller& controller) {
    return {{"name", controller.name},
            {"title", controller.title},
            {"policy", controller.policy},
            {"beside", controller.beside},
            {"verdict", name_of(controller.verdict)},
            {"states", controller.states},
            {"transitions", controller.transitions},
            {"states_before_minimisation", controller.states_before_minimisation},
            {"product_states", controller.product_states},
            {"product_edges", controller.product_edges},
            {"relies_on_broken_justice", controller.relies_on_broken_justice},
            {"assumptions", controller.assumptions},
            {"notes", controller.notes},
            {"reasons", controller.reasons},
            {"file", controller.file},
            {"evidence", to_list(controller.evidence)}};
  }

  static Json to_value(const Profile& profile) {
    return {{"name", profile.name}, {"title", profile.title}, {"description", profile.description}};
  }

  static Json to_value(const Chart& chart) {
    Json bars = Json::array();
    for (const Bar& bar : chart.bars) {
      Json value = {{"label", bar.label}, {"exact", to_value(bar.exact)}};
      if (chart.traces > 0) {
        value["sampled"] = bar.sampled;
        value["frequency"] = static_cast<double>(bar.sampled) / static_cast<double>(chart.traces);
        value["low"] = bar.low;
        value["high"] = bar.high;
      }
      bars.push_back(std::move(value));
    }
    Json value = {{"profile", chart.profile}, {"controller", chart.controller}, {"traces", chart.traces}};
    value["bars"] = std::move(bars);
    if (chart.reaction)
      value["reaction"] = {{"mean", to_value(chart.reaction)},
                           {"when_it_reacts", to_value(chart.reaction_when_it_reacts)}};
    if (chart.conflict) value["conflict"] = to_value(chart.conflict);
    if (chart.broken) value["assumptions_broken"] = to_value(chart.broken);
    if (chart.traces > 0)
      value["chi_square"] = {{"statistic", chart.chi_square},
                             {"degrees_of_freedom", chart.degrees_of_freedom},
                             {"p_value", chart.p_value}};
    return value;
  }

  static Json to_value(const Encounter& encounter) {
    return {{"profile", encounter.profile},
            {"controller", encounter.controller},
            {"stop", to_value(encounter.stop)},
            {"miss", to_value(encounter.miss)},
            {"needless", to_value(encounter.needless)}};
  }

  static Json to_value(const Drive& drive) {
    return {{"profile", drive.profile},
            {"controller", drive.controller},
            {"needless", to_value(drive.needless)},
            {"misses", to_value(drive.misses)},
            {"conflict", to_value(drive.conflict)},
            {"no_answer", to_value(drive.no_answer)},
            {"long_run",
             {{"needless", to_value(drive.long_needless)},
              {"misses", to_value(drive.long_misses)},
              {"conflicts", to_value(drive.long_conflicts)}}}};
  }

  static Json to_value(const Road& road) {
    return {{"name", road.name},
            {"title", road.title},
            {"description", road.description},
            {"length", road.length},
            {"drives", to_list(road.drives)}};
  }

  static Json to_value(const CatalogueEntry& entry) {
    return {{"name", entry.name.empty() ? Json(nullptr) : Json(entry.name)},
            {"label", entry.label},
            {"group", entry.group},
            {"features", entry.features},
            {"behaviours", entry.behaviours},
            {"prescribes_halt", entry.prescribes_halt},
            {"prescribes_give_way", entry.prescribes_give_way},
            {"encounters", to_list(entry.encounters)}};
  }

  static Json to_value(const SpeedCurve& curve) {
    Json points = Json::array();
    for (const SpeedCurve::Point& point : curve.points)
      points.push_back({{"metres_to_sign", point.metres_to_sign}, {"kmh", point.kmh}});
    return {{"label", curve.label},
            {"cells", curve.cells},
            {"deceleration", curve.deceleration},
            {"states", curve.states},
            {"points", std::move(points)}};
  }

  static Json to_value(const SpeedPicture& picture) {
    return {{"cell_metres", picture.cell_metres},
            {"speed_kmh", picture.speed_kmh},
            {"horizon_cells", picture.horizon_cells},
            {"curves", to_list(picture.curves)}};
  }

  static Json to_value(const util::Diagnostic& diagnostic) {
    const char* severity = diagnostic.severity == util::Severity::Error     ? "error"
                           : diagnostic.severity == util::Severity::Warning ? "warning"
                                                                            : "note";
    return {{"severity", severity},
            {"code", diagnostic.code},
            {"message", diagnostic.message},
            {"hint", diagnostic.hint},
            {"location", to_value(diagnostic.location)}};
  }

  static Json to_value(const TunedPolicy& one) {
    return {{"policy", one.policy},
            {"profile", one.profile},
            {"noise", one.noise},
            {"controller", one.controller.empty() ? Json(nullptr) : Json(one.controller)},
            {"miss", to_value(one.miss)},
            {"needless", to_value(one.needless)},
            {"cells_left", to_value(one.distance)},
            {"braking", to_value(one.braking)},
            {"hardest_braking", to_value(one.hardest)},
            {"on_front", one.on_front}};
  }

  static Json to_value(const Tuning& tuning) {
    if (tuning.figures.empty()) return nullptr;
    return {{"bound", tuning.bound.empty() ? Json(nullptr) : Json(tuning.bound)},
            {"best", tuning.best.empty() ? Json(nullptr) : Json(tuning.best)},
            {"things", tuning.things},
            {"whole", tuning.whole},
            {"left_out", tuning.left_out},
            {"figures", to_list(tuning.figures)}};
  }

  static Json to_value(const Version& version) {
    return {{"name", version.name}, {"version", version.version}};
  }

  static Json to_value(const Timings::Stage& stage) {
    return {{"name", stage.name}, {"seconds", stage.seconds}};
  }

  static Json to_value(const Timings& timings) {
    return {{"stages", to_list(timings.stages)},
            {"cpu_seconds", timings.cpu_seconds},
            {"wall_seconds", timings.wall_seconds},
            {"peak_bytes", timings.peak_bytes}};
  }

  static Json to_value(const RunResult& result) {
    Json value;
    value["format"] = "heed-run/1";
    value["scenario"] = result.scenario;
    value["description"] = result.description;
    value["command"] = result.command;
    value["headline"] = result.headline;
    const auto subject = subject_of(result);
    value["subject"] = subject ? Json(result.controllers[*subject].name) : Json(nullptr);
    value["miss_label"] = result.miss_label;
    value["thing"] = result.thing;
    value["kind"] = result.kind;
    value["inputs"] = to_list(result.inputs);
    value["ontology"] = to_value(result.ontology);
    value["knowledge"] = to_list(result.knowledge);
    value["specification"] = to_list(result.specification);
    value["warnings"] = to_list(result.warnings);
    value["controllers"] = to_list(result.controllers);
    value["profiles"] = to_list(result.profiles);
    value["charts"] = to_list(result.charts);
    value["catalogue"] = to_list(result.catalogue);
    value["roads"] = to_list(result.roads);
    value["road"] = result.road;
    value["speed"] = to_value(result.speed);
    value["tuning"] = to_value(result.tuning);
    value["driving"] = result.driving ? Json::parse(to_json(*result.driving)) : Json(nullptr);
    value["seed"] = result.seed;
    value["confidence"] = result.confidence;
    value["interval"] = result.interval;
    value["method"] = result.method;
    value["versions"] = to_list(result.versions);
    value["timings"] = to_value(result.timings);
    return value;
  }
};

}  // namespace

std::string to_json(const RunResult& result) {
  return Document::to_value(result).dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace heed::report
