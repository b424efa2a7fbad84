#include "letters.h"

#include <heed/job/evaluate.h>
#include <heed/job/road.h>
#include <heed/logic/parse.h>
#include <heed/spec/compose.h>
#include <heed/util/diagnostic.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>

namespace heed::job {
namespace {

using awareness::PerceptionInput;

/// A feature of a profile, as perception knows it: one value of one input, or an enumerated input as a whole.
struct Wired {
  std::size_t input;
  const PerceptionInput::Meaning* meaning;  ///< nullptr: the input as a whole.
};

Wired find_wired(const sim::FeatureSpec& feature, const awareness::Perception& perception) {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < perception.inputs.size(); ++i) {
    const PerceptionInput& input = perception.inputs[i];
    for (const PerceptionInput::Meaning& meaning : input.meanings) {
      if (meaning.atom == feature.name) return {i, &meaning};
      known.push_back(meaning.atom);
    }
    if (input.name == feature.name) return {i, nullptr};
    known.push_back(input.name);
  }
  throw util::InputError(feature.location, "unknown-feature",
                         fmt::format("perception reports nothing called '{}'", feature.name),
                         util::suggestion(feature.name, known));
}

bool present(const PerceptionInput::Meaning& meaning, const awareness::Catalogue& catalogue,
             std::size_t entity) {
  if (meaning.feature) return catalogue.has_feature(entity, *meaning.feature) != nullptr;
  if (meaning.excluded) return catalogue.has_feature(entity, *meaning.excluded) == nullptr;
  if (!meaning.whole) return true;  // the full view
  return entity == *meaning.whole || catalogue.is_below(entity, *meaning.whole) != nullptr;
}

/// Whether \p entity has something in the place of \p meaning: a shape where that is the octagon, a whole
/// where that is the whole stop sign.
bool has_place(const PerceptionInput::Meaning& meaning, const awareness::Catalogue& catalogue,
               std::size_t entity) {
  if (!meaning.feature) return meaning.whole.has_value();
  const awareness::Feature& feature = catalogue.features[*meaning.feature];
  if (feature.kind == awareness::Feature::Kind::Class) return false;
  const auto& own = catalogue.entities[entity].features;
  return std::any_of(own.begin(), own.end(), [&](const awareness::Entailed& entailed) {
    const awareness::Feature& other = catalogue.features[entailed.index];
    return other.kind != awareness::Feature::Kind::Class && other.role == feature.role;
  });
}

/// The value that \p thing shows on a feature of a profile; nothing when it does not have it.
std::optional<std::int32_t> value_of(const Wired& wired, const World& world, Thing thing) {
  if (!thing) return std::nullopt;
  const awareness::Catalogue& catalogue = world.knowledge.catalogue;
  if (wired.meaning != nullptr) {
    if (!present(*wired.meaning, catalogue, *thing)) return std::nullopt;
    return static_cast<std::int32_t>(wired.meaning->value);
  }
  for (const auto& described : catalogue.described(*thing, world.perception.perceivable))
    for (const PerceptionInput::Meaning& meaning : world.perception.inputs[wired.input].meanings)
      if (meaning.feature == described.index) return static_cast<std::int32_t>(meaning.value);
  return std::nullopt;
}

/// The thing does not show the feature, but something else takes its place in the order of things seen.
bool is_replaced(const Wired& wired, const World& world, Thing thing) {
  if (!thing || value_of(wired, world, thing)) return false;
  const auto& meanings = world.perception.inputs[wired.input].meanings;
  const auto place = [&](const PerceptionInput::Meaning& meaning) {
    return has_place(meaning, world.knowledge.catalogue, *thing);
  };
  return wired.meaning != nullptr ? place(*wired.meaning)
                                  : std::any_of(meanings.begin(), meanings.end(), place);
}

std::uint32_t machine_input(const std::vector<model::Variable>& inputs, const std::string& controller,
                            const std::string& name) {
  for (std::uint32_t i = 0; i < inputs.size(); ++i)
    if (inputs[i].name == name) return i;
  throw util::InputError(util::Location{}, "foreign-controller",
                         fmt::format("the controller '{}' has no input '{}'", controller, name),
                         "it was synthesized for another scenario");
}

/// What the plant brings into formulas beside `state` and `action`.
std::vector<std::string> plant_names(const model::Fts& plant) {
  std::vector<std::string> names;
  for (const auto& [name, states] : plant.labels) names.push_back(name);
  for (const auto& [name, values] : plant.values) names.push_back(name);
  return names;
}

/// The event, then the condition of each outcome, as the scenario has them.
std::vector<logic::Formula> judged(const EvaluatePart& part) {
  std::vector<logic::Formula> formulas{part.event.formula};
  for (const OutcomePart& outcome : part.outcomes)
    formulas.push_back(outcome.when ? outcome.when->formula : logic::truth(true));
  return formulas;
}

/// Told in the user's words, before the plant's labels are replaced by what they mean.
void refuse_temporal(const logic::Formula& formula) {
  for (const logic::Formula& node : logic::postorder(formula))
    if (node.op() > logic::Op::Next)
      throw util::InputError(
          node.location(), "temporal",
          fmt::format("'{}' cannot be decided in one step", logic::to_string(node)),
          "events and outcomes speak of one step; X may stand before what holds of the plant");
}

/// The formulas of judged(), over the machine's columns.
std::vector<logic::Formula> judged_over_columns(const EvaluatePart& part, const World& world) {
  std::vector<logic::Formula> formulas = judged(part);
  for (logic::Formula& formula : formulas)
    formula = spec::expand_plant(world.perception.over_inputs(formula), world.plant);
  return formulas;
}

/// The category of a step where \p holds says which formulas of judged() hold.
template <typename Holds>
std::uint32_t category_of(const EvaluatePart& part, const Holds& holds) {
  if (!holds(0)) return sim::Judge::none;
  for (std::size_t o = 0; o < part.outcomes.size(); ++o)
    if (part.outcomes[o].when && holds(o + 1)) return static_cast<std::uint32_t>(o);
  return static_cast<std::uint32_t>(part.rest);
}

/// A Judge or a SymbolicJudge.
template <typename Judging>
void name_categories(const EvaluatePart& part, bool never_apart, Judging& judge) {
  for (const OutcomePart& outcome : part.outcomes) judge.categories.push_back(outcome.label);
  judge.never = static_cast<std::uint32_t>(part.rest);
  if (!never_apart) return;
  judge.never = static_cast<std::uint32_t>(judge.categories.size());
  judge.categories.emplace_back("never");
}

/// A machine without rows, which has the columns of \p controller.
model::Mealy shell_of(const model::SymbolicController& controller) {
  model::Mealy shell;
  shell.name = controller.name;
  shell.inputs = controller.inputs;
  for (const auto* columns : {&controller.outputs, &controller.memories, &controller.definitions})
    shell.outputs.insert(shell.outputs.end(), columns->begin(), columns->end());
  return shell;
}

}  // namespace

void check_evaluate(const Scenario& scenario, const World& world, const Design& design) {
  if (!scenario.evaluate) return;
  model::Mealy shell;
  shell.name = design.composed.spec.name;
  shell.inputs = design.composed.spec.inputs;
  shell.outputs = spec::controller_outputs(design.composed.spec);
  for (const logic::Formula& formula : judged(*scenario.evaluate)) refuse_temporal(formula);
  (void)make_judge(scenario, world, shell, false);
  if (scenario.evaluate->conflict) refuse_temporal(scenario.evaluate->conflict->formula);
  (void)conflicts_of(scenario, world, shell);
}

sim::Judge make_judge(const Scenario& scenario, const World& world, const model::Mealy& machine,
                      bool never_apart) {
  const EvaluatePart& part = *scenario.evaluate;
  const auto holds = hold_at_transitions(judged_over_columns(part, world), machine, plant_names(world.plant));
  sim::Judge judge;
  name_categories(part, never_apart, judge);
  for (std::size_t t = 0; t < machine.transitions.size(); ++t)
    judge.event.push_back(category_of(part, [&](std::size_t formula) { return bool(holds[formula][t]); }));
  return judge;
}

sim::SymbolicJudge make_judge(const Scenario& scenario, const World& world,
                              const model::SymbolicController& machine, bool never_apart) {
  struct Judging {
    model::Mealy shell;
    std::optional<LetterFormulas> formulas;
    std::map<std::pair<model::Valuation, model::Valuation>, std::uint32_t> known;
  };
  const EvaluatePart& part = *scenario.evaluate;
  const auto judging = std::make_shared<Judging>();
  judging->shell = shell_of(machine);
  const auto formulas = judged_over_columns(part, world);
  judging->formulas.emplace(formulas, judging->shell, plant_names(world.plant));
  sim::SymbolicJudge judge;
  name_categories(part, never_apart, judge);
  for (std::uint32_t i = 0; i < machine.inputs.size(); ++i) {
    const auto reads = [&](const logic::Formula& node) {
      return node.op() == logic::Op::Name && node.name() == machine.inputs[i].name;
    };
    const auto somewhere = [&](const logic::Formula& formula) {
      const auto nodes = logic::postorder(formula);
      return std::any_of(nodes.begin(), nodes.end(), reads);
    };
    if (std::any_of(formulas.begin(), formulas.end(), somewhere)) judge.reads.push_back(i);
  }
  judge.event = [judging, &part](const model::Valuation& inputs, const model::Valuation& columns) {
    const auto [found, added] = judging->known.try_emplace({inputs, columns});
    if (added)
      found->second = category_of(
          part, [&](std::size_t formula) { return judging->formulas->holds(formula, inputs, columns); });
    return found->second;
  };
  return judge;
}

PlannedApproach plan_approach(const ProfilePart& profile, const World& world,
                              const std::vector<model::Variable>& inputs, const std::string& controller,
                              Thing thing) {
  PlannedApproach made{profile.spec, {}};
  made.binding.blank.assign(inputs.size(), 0);
  for (std::uint32_t f = 0; f < profile.spec.features.size(); ++f) {
    const sim::FeatureSpec& feature = profile.spec.features[f];
    const Wired wired = find_wired(feature, world.perception);
    const auto value = value_of(wired, world, thing);
    made.profile.features[f].replaced = is_replaced(wired, world, thing);
    made.profile.features[f].absent = feature.absent || (!value && !made.profile.features[f].replaced);
    const std::uint32_t input = machine_input(inputs, controller, world.perception.inputs[wired.input].name);
    // A false detection of what is not there shows the symbol's own value, or the first value of an input as
    // a whole.
    const std::int32_t false_value =
        wired.meaning != nullptr ? static_cast<std::int32_t>(wired.meaning->value) : 1;
    made.binding.wires.push_back({f, input, value.value_or(false_value)});
  }
  return made;
}

Approach approach(const ProfilePart& profile, const World& world, const model::Mealy& machine, Thing thing,
                  util::Budget& budget) {
  PlannedApproach plan = plan_approach(profile, world, machine.inputs, machine.name, thing);
  return {sim::compile(plan.profile, budget), std::move(plan.binding)};
}

std::string appearance(const ProfilePart& profile, const World& world, Thing thing) {
  std::string text;
  for (const sim::FeatureSpec& feature : profile.spec.features) {
    const Wired wired = find_wired(feature, world.perception);
    const auto value = value_of(wired, world, thing);
    text += value ? std::to_string(*value) : is_replaced(wired, world, thing) ? "other" : "-";
    text += ' ';
  }
  return text;
}

namespace {

/// A chain that is cheaper walked as it is than lumped first.
constexpr sim::ChainLimits small_chain{std::size_t{1} << 14, std::size_t{1} << 14};

/// The whole chain, where it has no more than that.
std::optional<sim::Chain> chain_within(const sim::ProfileSpec& profile, const sim::ChainLimits& limits,
                                       util::Budget& budget) {
  try {
    return sim::compile(profile, budget, limits);
  } catch (const util::LimitExceeded& limit) {
    if (limit.kind() != util::LimitExceeded::Kind::Size) throw;
    return std::nullopt;
  }
}

sim::LumpedOutcome as_figures(const sim::ExactOutcome& exact) {
  sim::LumpedOutcome figures;
  for (const sim::Rational& p : exact.probability) figures.probability.push_back(sim::known(p));
  figures.undefined = sim::known(exact.undefined);
  figures.missing = sim::known(exact.missing);
  figures.fallback = sim::known(exact.fallback);
  for (const sim::Rational& p : exact.event_at) figures.event_at.push_back(sim::known(p));
  figures.exact = true;
  return figures;
}

sim::ExactOutcome as_fractions(const sim::LumpedOutcome& figures) {
  if (!figures.exact) return {};
  sim::ExactOutcome exact;
  for (const sim::Figure& p : figures.probability) exact.probability.push_back(*p.exact);
  exact.undefined = *figures.undefined.exact;
  exact.missing = *figures.missing.exact;
  exact.fallback = *figures.fallback.exact;
  for (const sim::Figure& p : figures.event_at) exact.event_at.push_back(*p.exact);
  return exact;
}

/// What lumps, else the whole chain if that is not too large, either.
sim::LumpedOutcome large_figures(const PlannedApproach& plan, const model::Mealy& machine,
                                 const sim::Judge& judge, util::Budget& budget) {
  try {
    return sim::lumped_outcome(plan.profile, machine, plan.binding, judge, {}, budget);
  } catch (const util::LimitExceeded& limit) {
    if (limit.kind() != util::LimitExceeded::Kind::Size) throw;
    const auto chain = chain_within(plan.profile, {}, budget);
    if (!chain) throw;
    return as_figures(sim::exact_outcome({*chain, machine, plan.binding, judge}, budget));
  }
}

void draw_samples(const sim::Run& run, const EvaluateOptions& options, Evaluation& evaluation,
                  util::Budget& budget) {
  sim::SampleOptions sampling;
  sampling.traces = options.traces;
  sampling.seed = options.seed;
  sampling.threads = options.threads;
  sampling.team = options.team;
  const sim::Sampler sampler(run, budget);
  if (options.width <= 0) {
    evaluation.sampled = sampler.sample(sampling, budget);
    return;
  }
  sim::WidthOutcome found =
      sim::sample_to_width(sampler, {options.width, evaluation.confidence, options.traces}, sampling, budget);
  evaluation.sampled = std::move(found.outcome);
  evaluation.confidence = found.confidence;
  evaluation.width_reached = found.reached;
}

}  // namespace

ReadyApproach ready_approach(const ProfilePart& profile, const World& world,
                             const std::vector<model::Variable>& inputs, const std::string& controller,
                             Thing thing, util::Budget& budget) {
  ReadyApproach ready{plan_approach(profile, world, inputs, controller, thing), std::nullopt};
  ready.chain = chain_within(ready.plan.profile, small_chain, budget);
  return ready;
}

const ReadyApproach& Approaches::ready(const ProfilePart& profile, const model::Mealy& machine, Thing thing) {
  std::string key = profile.spec.name + '\n' + appearance(profile, world_, thing);
  for (const model::Variable& input : machine.inputs) key += '\n' + input.name;
  const auto found = known_.find(key);
  if (found != known_.end()) return found->second;
  return known_
      .emplace(std::move(key), ready_approach(profile, world_, machine.inputs, machine.name, thing, budget_))
      .first->second;
}

sim::LumpedOutcome exact_figures(const ReadyApproach& approach, const model::Mealy& machine,
                                 const sim::Judge& judge, util::Budget& budget) {
  if (!approach.chain) return large_figures(approach.plan, machine, judge, budget);
  return as_figures(sim::exact_outcome({*approach.chain, machine, approach.plan.binding, judge}, budget));
}

Evaluation evaluate(const Scenario& scenario, const World& world, const ProfilePart& profile,
                    const model::Mealy& machine, Thing thing, const EvaluateOptions& options,
                    util::Budget& budget) {
  ReadyApproach ready = ready_approach(profile, world, machine.inputs, machine.name, thing, budget);
  const sim::Judge judge = make_judge(scenario, world, machine, options.never_apart);
  Evaluation evaluation;
  evaluation.categories = judge.categories;
  evaluation.confidence = scenario.evaluate->confidence;
  evaluation.figures = exact_figures(ready, machine, judge, budget);
  evaluation.exact = as_fractions(evaluation.figures);
  if (options.traces == 0) return evaluation;
  if (!ready.chain) ready.chain = chain_within(ready.plan.profile, {}, budget);
  if (ready.chain)
    draw_samples({*ready.chain, machine, ready.plan.binding, judge}, options, evaluation, budget);
  return evaluation;
}

Evaluation evaluate(const Scenario& scenario, const World& world, const ProfilePart& profile,
                    const model::SymbolicController& machine, Thing thing, const EvaluateOptions& options,
                    util::Budget& budget) {
  const PlannedApproach plan = plan_approach(profile, world, machine.inputs, machine.name, thing);
  const sim::SymbolicJudge judge = make_judge(scenario, world, machine, options.never_apart);
  Evaluation evaluation;
  evaluation.categories = judge.categories;
  evaluation.confidence = scenario.evaluate->confidence;
  evaluation.figures = sim::lumped_outcome(plan.profile, machine, plan.binding, judge, {}, budget);
  evaluation.exact = as_fractions(evaluation.figures);
  return evaluation;
}

std::vector<std::string> states_on_the_way(const World& world, const ProfilePart& profile,
                                           const model::Mealy& machine, Thing thing, std::uint32_t cell) {
  const auto column = std::find_if(machine.outputs.begin(), machine.outputs.end(),
                                   [](const model::Output& o) { return o.role == model::OutputRole::Plant; });
  if (column == machine.outputs.end()) return {};
  const auto index = static_cast<std::size_t>(column - machine.outputs.begin());
  const model::Valuation blank(machine.inputs.size(), 0);
  model::Valuation full = blank;
  for (const sim::FeatureSpec& feature : profile.spec.features) {
    const Wired wired = find_wired(feature, world.perception);
    if (feature.absent) continue;
    if (const auto value = value_of(wired, world, thing))
      full[machine_input(machine.inputs, machine.name, world.perception.inputs[wired.input].name)] = *value;
  }
  std::vector<std::string> states;
  std::uint32_t state = 0;
  for (std::uint32_t step = 0; step <= profile.spec.cells; ++step) {
    const auto letter =
        machine.input_letter(step > cell ? full : blank);  // step 0 is the blank one before cell 0
    const auto* row = letter ? machine.find(state, *letter) : nullptr;
    if (row == nullptr) return {};
    states.push_back(column->variable.domain.print(machine.output_letters[row->output][index]));
    state = row->next;
  }
  return states;
}

}  // namespace heed::job
