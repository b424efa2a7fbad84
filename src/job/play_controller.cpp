#include "describe.h"
#include "play_parts.h"

#include <heed/logic/formula.h>
#include <heed/owl/axiom.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace heed::job {
namespace {

std::string_view role_word(model::OutputRole role) {
  constexpr std::array<std::string_view, 6> words{"action", "output",     "plant",
                                                  "memory", "recognised", "prescribed"};
  return words[static_cast<std::size_t>(role)];
}

report::PlayVariable describe_variable(const model::Variable& variable) {
  report::PlayVariable out{variable.name};
  out.boolean = variable.domain.kind == model::Domain::Kind::Boolean;
  out.low = variable.domain.low;
  out.high = variable.domain.high;
  out.values = variable.domain.values;
  out.comment = variable.comment;
  return out;
}

/// Names that occur in \p formula, ascending.
std::set<std::string> names_in(const logic::Formula& formula) {
  std::set<std::string> names;
  for (const logic::Formula& node : logic::postorder(formula))
    if (node.op() == logic::Op::Name) names.insert(node.name());
  return names;
}

class ControllerWriter {
 public:
  ControllerWriter(const report::Play& play, const Scenario& scenario, const World& world,
                   const Player& player, std::set<owl::AxiomId>& axioms)
      : play_(play), scenario_(scenario), world_(world), player_(player), axioms_(axioms) {}

  report::PlayController write() {
    const model::Mealy& machine = player_.machine;
    out_.name = player_.part->name.text;
    out_.title = player_.part->title;
    out_.policy = player_.design.recognition.words;
    out_.beside = player_.part->beside;
    out_.assumptions = machine.assumptions;
    out_.notes = machine.notes;
    for (const model::Output& output : machine.outputs) {
      out_.outputs.push_back({describe_variable(output.variable), std::string(role_word(output.role))});
      // `recognises` says the same with more, and a catalogue has a hundred of them.
      if (output.role == model::OutputRole::Recognised) out_.outputs.back().variable.comment.clear();
    }
    out_.reactions = machine.output_letters;
    write_rows();
    write_sigma();
    for (const auto& entity : player_.design.recognition.entities) write_recognised(entity);
    for (const auto& behaviour : player_.design.recognition.behaviours) write_prescribed(behaviour);
    return std::move(out_);
  }

 private:
  void write_rows() {
    const model::Mealy& machine = player_.machine;
    std::vector<std::size_t> observation;
    for (const model::Valuation& letter : machine.input_letters) {
      const auto at = std::lower_bound(play_.observations.begin(), play_.observations.end(), letter);
      observation.push_back(static_cast<std::size_t>(at - play_.observations.begin()));
    }
    const sim::Judge judge = scenario_.evaluate ? make_judge(scenario_, world_, machine, true) : sim::Judge{};
    out_.states.resize(machine.state_count());
    for (std::uint32_t s = 0; s < machine.state_count(); ++s)
      for (std::uint32_t t = machine.first[s]; t < machine.first[s + 1]; ++t) {
        const model::Mealy::Transition& row = machine.transitions[t];
        report::PlayRow written{observation[row.input], row.output, row.next, std::nullopt, row.fallback};
        if (scenario_.evaluate && judge.event[t] != sim::Judge::none) written.outcome = judge.event[t];
        out_.states[s].push_back(written);
      }
  }

  void write_sigma() {
    for (const report::KnowledgeFormula& formula : describe_sigma(world_, player_.design)) {
      report::PlaySigma written{formula.id, formula.kind, formula.text, formula.sentence};
      for (const report::Axiom& axiom : formula.axioms) written.axioms.push_back(axiom.id);
      out_.sigma.push_back(std::move(written));
    }
    for (const awareness::SigmaFormula& formula : player_.design.sigma)
      axioms_.insert(formula.axioms.begin(), formula.axioms.end());
  }

  /// The formula of σ of that kind that leads from exactly these names to \p to; empty: none does.
  [[nodiscard]] std::string find_sigma(awareness::SigmaKind kind, const std::set<std::string>& from,
                                       const std::string& to) const {
    for (const awareness::SigmaFormula& formula : player_.design.sigma) {
      if (formula.kind != kind || formula.formula.op() != logic::Op::Always) continue;
      const logic::Formula& body = formula.formula[0];
      if (body.op() == logic::Op::Implies && names_in(body[0]) == from &&
          names_in(body[1]) == std::set<std::string>{to})
        return formula.id;
    }
    return {};
  }

  std::vector<std::string> note_axioms(const std::vector<owl::AxiomId>& ids) {
    axioms_.insert(ids.begin(), ids.end());
    std::vector<std::string> names;
    for (const owl::AxiomId id : ids) names.push_back(owl::to_string(id));
    return names;
  }

  [[nodiscard]] std::optional<std::size_t> column(const std::string& name) const {
    for (std::size_t i = 0; i < player_.machine.outputs.size(); ++i)
      if (player_.machine.outputs[i].variable.name == name) return i;
    return std::nullopt;
  }

  void write_recognised(const awareness::RecognisedEntity& entity) {
    const auto at = column(entity.name);
    if (!at) return;
    const awareness::Entity& described = world_.knowledge.catalogue.entities[entity.entity];
    report::PlayRecognised written{*at, described.label};
    for (const awareness::Evidence& evidence : entity.evidence)
      written.evidence.push_back(
          {evidence.atoms, note_axioms(evidence.axioms),
           find_sigma(awareness::SigmaKind::Recognition, {evidence.atoms.begin(), evidence.atoms.end()},
                      described.atom)});
    out_.recognises.push_back(std::move(written));
  }

  void write_prescribed(const awareness::PrescribedBehaviour& behaviour) {
    const auto at = column(behaviour.name);
    if (!at) return;
    const awareness::Catalogue& catalogue = world_.knowledge.catalogue;
    const awareness::Behaviour& described = catalogue.behaviours[behaviour.behaviour];
    report::PlayPrescribed written{*at, described.label, {}};
    for (const BindingPart& binding : scenario_.bindings)
      if (catalogue.behaviour(awareness::Name(binding.behaviour.text, binding.behaviour.location)) ==
          behaviour.behaviour)
        written.effect = binding.effect.text;
    for (const std::size_t entity : behaviour.because) {
      const auto* recognised = player_.design.recognition.find_entity(entity);
      const auto cause = recognised != nullptr ? column(recognised->name) : std::nullopt;
      const awareness::Entailed* why = catalogue.prescribes(entity, behaviour.behaviour);
      if (!cause || why == nullptr) continue;
      written.because.push_back({*cause, note_axioms(why->axioms),
                                 find_sigma(awareness::SigmaKind::Prescription,
                                            {catalogue.entities[entity].atom}, described.atom)});
    }
    out_.prescribes.push_back(std::move(written));
  }

  const report::Play& play_;
  const Scenario& scenario_;
  const World& world_;
  const Player& player_;
  std::set<owl::AxiomId>& axioms_;
  report::PlayController out_;
};

}  // namespace

report::PlayController play_controller(const report::Play& play, const Scenario& scenario, const World& world,
                                       const Player& player, std::set<owl::AxiomId>& axioms) {
  return ControllerWriter(play, scenario, world, player, axioms).write();
}

}  // namespace heed::job
