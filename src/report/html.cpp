#include <heed/report/write.h>

#include <fmt/format.h>

#include "format.h"
#include "html_parts.h"
#include "lookup.h"

namespace heed::report {

namespace {

constexpr std::size_t colours = 5;

void write_head(Markup& page, const RunResult& result) {
  const auto head = page.scope("head");
  page.leaf("meta", {{"charset", "utf-8"}});
  page.leaf("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}});
  page.leaf("meta", {{"name", "color-scheme"}, {"content", "light dark"}});
  page.leaf("meta", {{"name", "generator"}, {"content", "heed"}});
  // A page without an icon makes browsers ask the server for one.
  page.leaf("link", {{"rel", "icon"}, {"href", "data:,"}});
  page.element("title", result.scenario.empty() ? "heed run" : result.scenario + " · heed run");
  page.raw("\n<style>");
  page.raw(style_sheet());
  page.raw("</style>");
}

void write_contents(Markup& page, const RunResult& result) {
  const auto nav = page.scope("nav", {{"class", "contents"}, {"aria-label", "Contents"}});
  const auto list = page.scope("ul");
  const auto link = [&](bool there, const char* id, const std::string& words) {
    if (!there) return;
    const auto item = page.scope("li");
    page.element("a", words, {{"href", fmt::format("#{}", id)}});
  };
  link(!result.warnings.empty(), "warnings", "Warnings");
  link(true, "ontology", "Ontology");
  link(!result.knowledge.empty(), "knowledge", "What follows from it");
  link(!result.specification.empty(), "specification", "Specification");
  link(!result.controllers.empty(), "controllers", "Controllers");
  link(!result.charts.empty(), "outcomes", "Outcomes");
  link(!result.speed.curves.empty() && !result.charts.empty(), "speed", "Braking");
  link(has_errors(result), "catalogue", "Every " + result.kind);
  link(!result.tuning.figures.empty(), "policies", "Policies");
  link(!result.roads.empty(), "roads", "Roads");
  link(result.driving.has_value(), "driving", "Driving");
  link(true, "method", "Method");
  link(true, "timings", "Timings");
}

void write_body(Markup& page, const RunResult& result) {
  const auto body = page.scope("body");
  write_answer(page, result);
  write_contents(page, result);
  {
    const auto main = page.scope("main");
    write_warnings(page, result);
    write_ontology(page, result);
    write_knowledge(page, result);
    write_specification(page, result);
    write_controllers(page, result);
    write_outcomes(page, result);
    write_speed(page, result);
    write_catalogue(page, result);
    write_policies(page, result);
    write_roads(page, result);
    write_driving(page, result);
    write_method(page, result);
    write_timings(page, result);
  }
  const auto footer = page.scope("footer");
  page.text(
      "Guarantees hold relative to the stated assumptions. heed does not train perception, plan continuous "
      "trajectories or certify a vehicle.");
}

}  // namespace

Markup::Scope section(Markup& page, std::string_view id, std::string_view heading,
                      std::string_view introduction) {
  auto scope =
      page.scope("section", {{"id", std::string(id)}, {"aria-labelledby", fmt::format("{}-heading", id)}});
  page.element("h2", heading, {{"id", fmt::format("{}-heading", id)}});
  if (!introduction.empty()) page.element("p", introduction, {{"class", "intro"}});
  return scope;
}

Markup::Scope scroll_box(Markup& page, std::string_view label) {
  return page.scope(
      "div",
      {{"class", "scroll"}, {"role", "region"}, {"tabindex", "0"}, {"aria-label", std::string(label)}});
}

void write_caption(Markup& page, std::string_view words) {
  const auto caption = page.scope("caption");
  page.element("span", words);
}

void write_name(Markup& page, const RunResult& result, std::string_view controller, std::string_view words) {
  const auto name = page.scope("span", {{"class", "who"}});
  page.element("span", "", {{"class", "swatch " + colour_class(result, controller)}});
  page.element("span", words);
}

std::string colour_class(const RunResult& result, std::string_view controller) {
  const auto subject = subject_of(result);
  std::size_t next = subject ? 1 : 0;
  for (std::size_t i = 0; i < result.controllers.size(); ++i) {
    const bool is_subject = subject && *subject == i;
    if (result.controllers[i].name == controller) return fmt::format("k{}", is_subject ? 0 : next);
    if (is_subject) continue;
    // Past the last colour they repeat, the subject's own left out.
    next = next + 1 == colours ? 1 : next + 1;
  }
  return "k1";
}

std::string title_of(const RunResult& result, std::string_view controller) {
  for (const Controller& one : result.controllers)
    if (one.name == controller) return title_of(one);
  return std::string(controller);
}

std::string short_place(const util::Location& location) {
  if (!location.file) return {};
  std::string_view name = location.file_name();
  if (const auto slash = name.rfind('/'); slash != std::string_view::npos) name.remove_prefix(slash + 1);
  return location.line == 0 ? std::string(name) : fmt::format("{}:{}", name, location.line);
}

std::string to_html(const RunResult& result) {
  Markup page;
  page.raw("<!DOCTYPE html>");
  {
    const auto html = page.scope("html", {{"xmlns", "http://www.w3.org/1999/xhtml"}, {"lang", "en"}});
    write_head(page, result);
    write_body(page, result);
  }
  return page.finish();
}

}  // namespace heed::report
