#include "toml_table.h"

#include "scenario_drive.h"
#include "scenario_profile.h"

#include <heed/awareness/policy.h>
#include <heed/job/scenario.h>
#include <heed/logic/parse.h>
#include <heed/util/diagnostic.h>
#include <heed/util/file.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace heed::job {
namespace {

WrittenFormula read_formula(const util::SourceText& source, const util::Limits& limits) {
  return {logic::parse(source, limits), source.text()};
}

std::vector<WrittenFormula> read_formulas(TomlTable& table, const std::string& key,
                                          const util::Limits& limits) {
  std::vector<WrittenFormula> formulas;
  for (const util::SourceText& source : table.sources(key)) formulas.push_back(read_formula(source, limits));
  return formulas;
}

std::vector<Word> required_words(TomlTable& table, const std::string& key) {
  auto words = table.words(key);
  if (words.empty()) (void)table.word(key);  // the message for a missing key
  return words;
}

KnowledgePart read_knowledge(TomlTable table, const std::string& base) {
  KnowledgePart part;
  part.ontology = table.word("ontology");
  part.ontology.text = util::resolve_path(base, part.ontology.text);
  part.entities = required_words(table, "entities");
  part.features = required_words(table, "features");
  part.behaviours = required_words(table, "behaviours");
  part.feature_roles = required_words(table, "feature_roles");
  part.action_roles = required_words(table, "action_roles");
  part.subclass_role = table.optional_word("subclass_role");
  if (table.has("sufficient")) {
    if (!table.is_flag("sufficient"))
      part.sufficient_entities = table.words("sufficient");
    else
      part.sufficient = table.flag("sufficient", false);
  }
  part.language = table.text("language", "en");
  if (table.has("imports")) {
    TomlTable imports = table.table("imports");
    for (const std::string& iri : imports.keys())
      part.imports.emplace_back(iri, util::resolve_path(base, imports.word(iri).text));
  }
  part.allow_missing_imports = table.flag("allow_missing_imports", false);
  part.allow_unsatisfiable = table.flag("allow_unsatisfiable", false);
  part.allow_left_out = table.flag("allow_left_out", false);
  table.finish();
  return part;
}

Violation read_violation(TomlTable& table) {
  const std::string word = table.text("on_violation", "drop");
  if (word == "drop") return Violation::Drop;
  if (word == "latch") return Violation::Latch;
  if (word == "undefined") return Violation::Undefined;
  table.fail("on_violation", "unknown-word", fmt::format("unknown answer '{}' to a violation", word),
             util::suggestion(word, {"drop", "latch", "undefined"}));
}

PerceptionPart read_perception(TomlTable table, const util::Limits& limits) {
  PerceptionPart part;
  for (TomlTable& input : table.tables("inputs")) {
    part.inputs.push_back({input.word("what"), input.text("name", ""), input.flag("whole", false),
                           input.flag("excluded", false)});
    input.finish();
  }
  part.enumerate = table.flag("enumerate", true);
  if (table.has("persistent")) part.persistent = read_formula(table.source("persistent"), limits);
  part.assume = read_formulas(table, "assume", limits);
  part.blank_first = table.flag("blank_first", true);
  part.full_view = table.text("full_view", "");
  part.on_violation = read_violation(table);
  table.finish();
  return part;
}

PlantPart read_plant(TomlTable table, const std::string& base) {
  PlantPart part;
  const bool inline_text = table.has("text");
  if (inline_text == table.has("fts"))
    throw util::InputError(table.location(), "missing-key",
                           "[plant] needs exactly one of 'fts' (a file) and 'text'",
                           "such as fts = \"car.fts\" (docs/formats/fts.md)");
  if (inline_text) {
    part.text = table.source("text");
  } else {
    part.path = table.word("fts");
    part.path.text = util::resolve_path(base, part.path.text);
  }
  part.initial = table.words("initial");
  table.finish();
  return part;
}

void read_bindings(TomlTable table, Scenario& scenario, const util::Limits& limits) {
  scenario.only_when_prescribed = table.flag("only_when_prescribed", false);
  scenario.priority = table.words("priority");
  for (const std::string& key : table.keys()) {
    if (key == "only_when_prescribed" || key == "priority") continue;
    const util::Location where = table.location_of(key);
    scenario.bindings.push_back({{key, where}, read_formula(table.source(key), limits)});
  }
}

void check_file_name(const Word& name) {
  const bool fine = !name.text.empty() &&
                    std::all_of(name.text.begin(), name.text.end(),
                                [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; });
  if (!fine)
    throw util::InputError(name.location, "bad-name", fmt::format("'{}' cannot name a controller", name.text),
                           "use letters, digits, '-' and '_': the name becomes a file name");
}

void check_policy(const ControllerPart& part) {
  if (!awareness::read_policy(part.policy.text))
    throw util::InputError(
        part.policy.location, "unknown-word", fmt::format("unknown policy '{}'", part.policy.text),
        util::suggestion(part.policy.text,
                         {"full", "tree", "tree-or-full", "definition", "at-least", "identifying"}));
  if (part.behaviours && !awareness::read_acting(part.behaviours->text))
    throw util::InputError(part.behaviours->location, "unknown-word",
                           fmt::format("unknown choice of behaviours '{}'", part.behaviours->text),
                           util::suggestion(part.behaviours->text, {"cautious", "common", "brave"}));
}

ControllerPart read_controller(TomlTable& table) {
  ControllerPart part;
  part.name = table.word("name");
  check_file_name(part.name);
  part.title = table.text("title", part.name.text);
  part.policy = table.word("policy");
  part.entities = table.words("entities");
  part.over = table.words("over");
  part.order = table.words("order");
  const bool counted = part.policy.text == "at-least";
  if (counted && !table.has("k")) (void)table.word("k");
  part.k = static_cast<std::size_t>(table.integer("k", 2, 1, 1'000'000));
  part.latch = table.flag("latch", false);
  part.beside = table.flag("beside", false);
  if (table.has("direct")) part.direct = table.flag("direct", false);
  part.behaviours = table.optional_word("behaviours");
  part.closed = table.flag("closed", false);
  part.fallback = table.words("fallback");
  table.finish();
  check_policy(part);
  return part;
}

std::vector<OutcomePart> read_outcomes(TomlTable& table, const util::Limits& limits) {
  std::vector<OutcomePart> outcomes;
  for (TomlTable& item : table.tables("outcomes")) {
    OutcomePart outcome{item.word("label").text, std::nullopt};
    if (item.has("when")) outcome.when = read_formula(item.source("when"), limits);
    item.finish();
    if (std::any_of(outcomes.begin(), outcomes.end(),
                    [&](const auto& o) { return o.label == outcome.label; }))
      item.fail("label", "duplicate-name", fmt::format("two outcomes are called '{}'", outcome.label),
                "join the two with '|', or give one another label");
    outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

/// The one outcome without a condition.
std::size_t rest_of(const TomlTable& table, const std::vector<OutcomePart>& outcomes) {
  const auto rest = std::count_if(outcomes.begin(), outcomes.end(), [](const auto& o) { return !o.when; });
  if (rest != 1)
    table.fail(
        "outcomes", "bad-outcomes",
        fmt::format("exactly one outcome must lack 'when' (it is for the rest and for \"never\"), found {}",
                    rest),
        "such as { label = \"missed\" }");
  return static_cast<std::size_t>(
      std::find_if(outcomes.begin(), outcomes.end(), [](const auto& o) { return !o.when; }) -
      outcomes.begin());
}

EvaluatePart read_evaluate(TomlTable table, const util::Limits& limits) {
  EvaluatePart part;
  part.event = read_formula(table.source("event"), limits);
  part.outcomes = read_outcomes(table, limits);
  part.rest = part.miss = rest_of(table, part.outcomes);
  if (const auto miss = table.optional_word("miss")) {
    const auto found = std::find_if(part.outcomes.begin(), part.outcomes.end(),
                                    [&](const OutcomePart& o) { return o.label == miss->text; });
    std::vector<std::string> labels;
    for (const OutcomePart& o : part.outcomes) labels.push_back(o.label);
    if (found == part.outcomes.end())
      table.fail("miss", "unknown-word", fmt::format("no outcome is called '{}'", miss->text),
                 util::suggestion(miss->text, labels));
    part.miss = static_cast<std::size_t>(found - part.outcomes.begin());
  }
  if (table.has("conflict")) part.conflict = read_formula(table.source("conflict"), limits);
  part.thing = table.text("thing", part.thing);
  part.kind = table.text("kind", part.kind);
  part.approached = table.optional_word("approached");
  part.traces = static_cast<std::uint64_t>(table.integer("traces", 10'000, 0, 1'000'000'000'000));
  part.seed = static_cast<std::uint64_t>(table.integer("seed", 1, 0, INT64_MAX));
  part.confidence = table.real("confidence", 0.95, 0, 1);
  part.must_react = table.words("must_react");
  part.may_react = table.words("may_react");
  part.speed_wanted = table.has("cell_metres") || table.has("speed_kmh");
  part.cell_metres = table.real("cell_metres", 10, 0, 1e6);
  part.speed_kmh = table.real("speed_kmh", 50, 0, 1e4);
  table.finish();
  return part;
}

template <class Part>
void refuse_twice(const std::vector<Part>& parts, const Part& next, const Word& (*name)(const Part&)) {
  for (const Part& part : parts)
    if (name(part).text == name(next).text)
      throw util::InputError(name(next).location, "duplicate-name",
                             fmt::format("'{}' is already used by the one in line {}", name(next).text,
                                         name(part).location.line));
}

}  // namespace

Scenario read_scenario(const util::SourceText& source, const util::Limits& limits) {
  const toml::table parsed = parse_toml(source);
  TomlTable root(parsed, std::make_shared<const std::string>(source.name()), "");
  root.allow({"name", "description", "knowledge", "perception", "plant", "task", "bind", "controller",
              "profile", "evaluate", "road", "tune", "drive"});
  Scenario scenario;
  scenario.path = source.name();
  scenario.name = root.text("name", std::filesystem::path(source.name()).stem().string());
  scenario.description = root.text("description", "");
  scenario.knowledge = read_knowledge(root.table("knowledge"), source.name());
  if (root.has("perception")) scenario.perception = read_perception(root.table("perception"), limits);
  scenario.plant = read_plant(root.table("plant"), source.name());
  if (root.has("task")) {
    TomlTable task = root.table("task");
    scenario.assumptions = read_formulas(task, "assumptions", limits);
    scenario.guarantees = read_formulas(task, "guarantees", limits);
    task.finish();
  }
  if (root.has("bind")) read_bindings(root.table("bind"), scenario, limits);
  for (TomlTable& table : root.tables("controller")) {
    ControllerPart part = read_controller(table);
    refuse_twice<ControllerPart>(scenario.controllers, part,
                                 [](const ControllerPart& p) -> const Word& { return p.name; });
    scenario.controllers.push_back(std::move(part));
  }
  if (scenario.controllers.empty())
    throw util::InputError(root.location(), "missing-key", "the scenario has no [[controller]]",
                           "docs/formats/scenario.md lists every key");
  for (TomlTable& table : root.tables("profile")) scenario.profiles.push_back(read_profile(table, limits));
  if (root.has("evaluate"))
    scenario.evaluate = read_evaluate(root.table("evaluate"), limits);
  else if (!scenario.profiles.empty())
    throw util::InputError(scenario.profiles.front().spec.location, "missing-key",
                           "a [[profile]] needs [evaluate] to say what counts",
                           "add [evaluate] with event and outcomes");
  for (TomlTable& table : root.tables("road")) {
    RoadPart part = read_road(table);
    refuse_twice<RoadPart>(scenario.roads, part, [](const RoadPart& p) -> const Word& { return p.name; });
    scenario.roads.push_back(std::move(part));
  }
  if (!scenario.roads.empty() && scenario.profiles.empty())
    throw util::InputError(scenario.roads.front().name.location, "missing-key",
                           "a [[road]] needs a [[profile]] to say what is seen along it",
                           "add [[profile]] and [evaluate]");
  if (root.has("tune")) scenario.tune = read_tune(root.table("tune"));
  scenario.drive = read_drive(root, scenario.evaluate, limits);
  root.finish();
  return scenario;
}

}  // namespace heed::job
