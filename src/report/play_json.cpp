#include <heed/report/play.h>

#include <nlohmann/json.hpp>

namespace heed::report {

namespace {

using Json = nlohmann::ordered_json;

/// One overload per struct; a class, so that lists see the overloads that stand below them.
struct Document {
  template <typename T>
  static Json to_list(const std::vector<T>& items) {
    Json list = Json::array();
    for (const T& item : items) list.push_back(to_value(item));
    return list;
  }

  static Json to_value(const PlayVariable& variable) {
    Json value;
    value["name"] = variable.name;
    if (!variable.values.empty())
      value["type"] = variable.values;
    else if (variable.boolean)
      value["type"] = "boolean";
    else
      value["type"] = Json::array({variable.low, variable.high});
    if (!variable.comment.empty()) value["comment"] = variable.comment;
    return value;
  }

  static Json to_value(const PlayColumn& column) {
    Json value = to_value(column.variable);
    value["role"] = column.role;
    return value;
  }

  static Json to_value(const PlaySymbol& symbol) {
    Json value{{"name", symbol.name},
               {"label", symbol.label},
               {"kind", symbol.kind},
               {"input", symbol.input},
               {"value", symbol.value}};
    if (symbol.feature) value["feature"] = *symbol.feature;
    if (symbol.entity) value["entity"] = *symbol.entity;
    return value;
  }

  static Json to_value(const PlayFeature& feature) {
    return {{"label", feature.label}, {"aspect", feature.aspect}, {"value", feature.value}};
  }

  static Json to_value(const PlayEntity& entity) {
    return {{"name", entity.name},         {"label", entity.label},           {"group", entity.group},
            {"features", entity.features}, {"prescribes", entity.prescribes}, {"react", entity.react},
            {"shows", entity.shows}};
  }

  static Json to_value(const PlayPlant& plant) {
    Json labels = Json::object(), values = Json::object();
    for (const auto& [name, states] : plant.labels) labels[name] = states;
    for (const auto& [name, codes] : plant.values) values[name] = codes;
    return {{"states", plant.states}, {"labels", labels}, {"values", values}, {"way", plant.way}};
  }

  static Json to_value(const PlayDraw& draw) { return Json::array({draw.probability, draw.next, draw.seen}); }

  static Json to_value(const std::vector<PlayDraw>& draws) { return to_list(draws); }

  static Json to_value(const PlayChain& chain) { return to_list(chain); }

  static Json to_value(const PlayApproach& approach) {
    return {{"chain", approach.chain}, {"symbols", approach.symbols}, {"sampled", approach.sampled}};
  }

  static Json to_value(const PlayProfile& profile) {
    return {{"name", profile.name},
            {"title", profile.title},
            {"cells", profile.cells},
            {"lines", profile.lines},
            {"chains", to_list(profile.chains)},
            {"approaches", to_list(profile.approaches)},
            {"of", profile.of}};
  }

  static Json to_value(const PlayEvidence& evidence) {
    return {{"atoms", evidence.atoms}, {"axioms", evidence.axioms}, {"sigma", evidence.sigma}};
  }

  static Json to_value(const PlayRecognised& recognised) {
    return {{"column", recognised.column},
            {"label", recognised.label},
            {"evidence", to_list(recognised.evidence)}};
  }

  static Json to_value(const PlayCause& cause) {
    return {{"column", cause.column}, {"axioms", cause.axioms}, {"sigma", cause.sigma}};
  }

  static Json to_value(const PlayPrescribed& prescribed) {
    return {{"column", prescribed.column},
            {"label", prescribed.label},
            {"effect", prescribed.effect},
            {"because", to_list(prescribed.because)}};
  }

  static Json to_value(const PlaySigma& formula) {
    return {{"id", formula.id},
            {"kind", formula.kind},
            {"text", formula.text},
            {"sentence", formula.sentence},
            {"axioms", formula.axioms}};
  }

  static Json to_value(const PlayRow& row) {
    Json value = Json::array({row.observation, row.reaction, row.next});
    if (row.outcome)
      value.push_back(*row.outcome);
    else if (row.fallback)
      value.push_back(-1);
    if (row.fallback) value.push_back(1);
    return value;
  }

  static Json to_value(const std::vector<PlayRow>& rows) { return to_list(rows); }

  /// Columns are mostly 0: only the others are written, as pairs of column and value.
  static Json reactions(const std::vector<std::vector<std::int32_t>>& letters) {
    Json all = Json::array();
    for (const auto& letter : letters) {
      Json pairs = Json::array();
      for (std::size_t column = 0; column < letter.size(); ++column) {
        if (letter[column] == 0) continue;
        pairs.push_back(column);
        pairs.push_back(letter[column]);
      }
      all.push_back(std::move(pairs));
    }
    return all;
  }

  static Json to_value(const PlayController& controller) {
    return {{"name", controller.name},
            {"title", controller.title},
            {"policy", controller.policy},
            {"beside", controller.beside},
            {"assumptions", controller.assumptions},
            {"notes", controller.notes},
            {"outputs", to_list(controller.outputs)},
            {"reactions", reactions(controller.reactions)},
            {"states", to_list(controller.states)},
            {"recognises", to_list(controller.recognises)},
            {"prescribes", to_list(controller.prescribes)},
            {"sigma", to_list(controller.sigma)}};
  }

  static Json axioms(const std::vector<PlayAxiom>& list) {
    Json all = Json::object();
    for (const PlayAxiom& axiom : list)
      all[axiom.id] = {{"text", axiom.text}, {"file", axiom.file}, {"line", axiom.line}};
    return all;
  }

  static Json versions(const std::vector<std::pair<std::string, std::string>>& list) {
    Json all = Json::array();
    for (const auto& [name, version] : list) all.push_back({{"name", name}, {"version", version}});
    return all;
  }
};

/// What is there once, in the order of docs/formats/play.md.
void write_frame(Json& out, const Play& play) {
  out["heed"] = "play";
  out["version"] = 1;
  out["scenario"] = play.scenario;
  out["description"] = play.description;
  out["thing"] = play.thing;
  out["kind"] = play.kind;
  out["approached"] = play.approached ? Json(*play.approached) : Json(-1);
  out["seed"] = play.seed;
  out["cells"] = play.cells;
  out["subject"] = play.subject;
}

}  // namespace

std::string to_json(const Play& play) {
  Json out;
  write_frame(out, play);
  out["inputs"] = Document::to_list(play.inputs);
  out["symbols"] = Document::to_list(play.symbols);
  out["features"] = Document::to_list(play.features);
  out["entities"] = Document::to_list(play.entities);
  out["plant"] = Document::to_value(play.plant);
  out["speed"] = nullptr;
  if (play.speed) out["speed"] = {{"cell_metres", play.speed->cell_metres}, {"kmh", play.speed->kmh}};
  out["event"] = play.event;
  out["outcomes"] = play.outcomes;
  out["rest"] = play.rest;
  out["miss"] = play.miss;
  out["profiles"] = Document::to_list(play.profiles);
  out["observations"] = play.observations;
  out["candidates"] = nullptr;
  if (play.candidates) out["candidates"] = {{"sets", play.candidates->sets}, {"of", play.candidates->of}};
  out["axioms"] = Document::axioms(play.axioms);
  out["controllers"] = Document::to_list(play.controllers);
  out["versions"] = Document::versions(play.versions);
  return out.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace heed::report
