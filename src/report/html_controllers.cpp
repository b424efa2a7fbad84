#include <fmt/format.h>

#include "format.h"
#include "html_parts.h"
#include "lookup.h"

namespace heed::report {

namespace {

void write_list(Markup& page, const char* heading, const std::vector<std::string>& items, bool code) {
  if (items.empty()) return;
  page.element("h4", heading);
  const auto list = page.scope("ul");
  for (const std::string& item : items) {
    const auto line = page.scope("li");
    if (code)
      page.element("code", item);
    else
      page.text(item);
  }
}

void write_verdict(Markup& page, const Controller& controller) {
  const auto paragraph = page.scope("p");
  switch (controller.verdict) {
    case Verdict::Verified:
      page.element("span", "Verified", {{"class", "verdict"}});
      page.text(fmt::format(" independently, over {} and {} of the product.",
                            plural(controller.product_states, "state"),
                            plural(controller.product_edges, "edge")));
      break;
    case Verdict::Refuted:
      page.element("span", "Refuted", {{"class", "verdict bad"}});
      page.text(" by the independent check.");
      break;
    case Verdict::Unrealizable:
      page.element("span", "Unrealizable", {{"class", "verdict bad"}});
      page.text(": no controller exists.");
      break;
  }
}

void write_sizes(Markup& page, const Controller& controller) {
  const auto list = page.scope("dl", {{"class", "facts"}});
  const auto fact = [&](const char* name, std::uint64_t value) {
    const auto pair = page.scope("div");
    page.element("dt", name);
    page.element("dd", grouped(value));
  };
  fact("states", controller.states);
  fact("transitions", controller.transitions);
  fact("minimised from", controller.states_before_minimisation);
}

void write_evidence(Markup& page, const Controller& controller) {
  if (controller.evidence.empty()) return;
  page.element("h4", "Evidence that suffices");
  const auto list = page.scope("ul");
  for (const EvidenceRule& rule : controller.evidence) {
    const auto item = page.scope("li");
    page.text(fmt::format("{} → {}", join(rule.evidence, " + "), rule.recognises));
    if (!rule.axioms.empty())
      page.element("span", fmt::format(" {}", join(rule.axioms, ", ")), {{"class", "place"}});
  }
}

void write_card(Markup& page, const RunResult& result, const Controller& controller) {
  const auto card = page.scope("article", {{"class", "card " + colour_class(result, controller.name)}});
  page.element("h3", title_of(controller));
  if (!controller.policy.empty()) page.element("p", "Recognises when " + controller.policy + ".");
  write_verdict(page, controller);
  if (controller.verdict != Verdict::Unrealizable) write_sizes(page, controller);
  write_list(page, "Why", controller.reasons, false);
  write_evidence(page, controller);
  if (controller.verdict != Verdict::Unrealizable && controller.assumptions.empty())
    page.element("p", "Relies on no assumption about the environment.", {{"class", "because"}});
  write_list(page, "Relies on", controller.assumptions, true);
  write_list(page, "Notes", controller.notes, false);
  if (controller.relies_on_broken_justice)
    page.element("p", "Somewhere it wins only because the environment would have to break an assumption.",
                 {{"class", "because"}});
  if (controller.beside) page.element("p", "Shown beside the comparison.", {{"class", "because"}});
  if (!controller.file.empty()) {
    page.element("h4", "Written to");
    page.element("code", controller.file);
  }
}

}  // namespace

void write_controllers(Markup& page, const RunResult& result) {
  if (result.controllers.empty()) return;
  const auto part =
      section(page, "controllers", "The controllers",
              "Same ontology, same car, same task: only when a thing counts as recognised differs.");
  const auto cards = page.scope("div", {{"class", "cards"}});
  for (const Controller& controller : result.controllers) write_card(page, result, controller);
}

}  // namespace heed::report
