#include <fmt/format.h>

#include "format.h"
#include "html_parts.h"
#include "lookup.h"

namespace heed::report {

namespace {

void write_miss_row(Markup& page, const RunResult& result, const Controller& controller, bool is_subject) {
  const auto row = page.scope("tr", {{"class", is_subject ? "subject" : ""}});
  {
    const auto head = page.scope("th", {{"scope", "row"}});
    write_name(page, result, controller.name, title_of(controller));
  }
  for (const Profile& profile : result.profiles) {
    const auto chart = find_chart(result, profile.name, controller.name);
    const auto bar = chart ? miss_bar(result, result.charts[*chart]) : std::nullopt;
    if (!bar) {
      page.element("td", "–");
      continue;
    }
    const double miss = result.charts[*chart].bars[*bar].exact.value;
    page.element("td", percent(miss),
                 with_data({}, fmt::format("/charts/{}/bars/{}/exact/value", *chart, *bar), miss));
  }
}

void write_misses(Markup& page, const RunResult& result) {
  const auto subject = subject_of(result);
  if (!subject) return;
  const auto box = scroll_box(page, "Misses per controller and profile");
  const auto table = page.scope("table", {{"class", "misses"}});
  write_caption(page, fmt::format("How often {} is missed, exactly computed", result.thing));
  {
    const auto head = page.scope("thead");
    const auto row = page.scope("tr");
    page.element("th", "Controller", {{"scope", "col"}});
    for (const Profile& profile : result.profiles) page.element("th", profile.name, {{"scope", "col"}});
  }
  const auto body = page.scope("tbody");
  for (std::size_t i = 0; i < result.controllers.size(); ++i)
    if (result.controllers[i].verdict != Verdict::Unrealizable)
      write_miss_row(page, result, result.controllers[i], i == *subject);
}

}  // namespace

void write_answer(Markup& page, const RunResult& result) {
  const auto header = page.scope("header", {{"class", "hero"}});
  page.element("p", "heed run · " + result.scenario, {{"class", "eyebrow"}});
  page.element("h1", result.headline.empty() ? result.scenario : unbroken(result.headline.front()));
  if (!result.description.empty()) page.element("p", result.description, {{"class", "lede"}});
  const auto answer = page.scope("div", {{"class", "answer"}});
  if (result.headline.size() > 1) {
    const auto list = page.scope("ul");
    for (std::size_t i = 1; i < result.headline.size(); ++i)
      page.element("li", unbroken(result.headline[i]) + ".");
  }
  write_misses(page, result);
}

void write_warnings(Markup& page, const RunResult& result) {
  if (result.warnings.empty()) return;
  const auto part = section(page, "warnings", "Warnings",
                            "What a safety engineer should read before relying on the figures.");
  for (const util::Diagnostic& warning : result.warnings) {
    const auto box = page.scope("div", {{"class", "warning"}});
    {
      const auto paragraph = page.scope("p");
      page.text(warning.message + ". ");
      page.element("span", fmt::format("{} {}", short_place(warning.location), warning.code),
                   {{"class", "place"}});
    }
    if (!warning.hint.empty()) page.element("p", warning.hint, {{"class", "because"}});
  }
}

void write_method(Markup& page, const RunResult& result) {
  const auto part = section(page, "method", "Method");
  const auto pairs = page.scope("div", {{"class", "pairs"}});
  {
    const auto list = page.scope("ul");
    for (const std::string& sentence : result.method) page.element("li", sentence);
  }
  const auto right = page.scope("div");
  const auto table = page.scope("table");
  write_caption(page, "To repeat this run");
  const auto body = page.scope("tbody");
  const auto row = [&](std::string_view name, std::string_view value) {
    if (value.empty()) return;
    const auto line = page.scope("tr");
    page.element("th", name, {{"scope", "row"}});
    const auto cell = page.scope("td");
    page.element("code", value);
  };
  row("command", result.command);
  row("seed", std::to_string(result.seed));
  for (const InputFile& file : result.inputs)
    row(file.role, file.digest.empty() ? file.path : fmt::format("{} ({})", file.path, file.digest));
  for (const Version& version : result.versions) row(version.name, version.version);
}

void write_timings(Markup& page, const RunResult& result) {
  const auto part =
      section(page, "timings", "Timings", "The one part of this page that differs between two runs.");
  const Timings& timings = result.timings;
  {
    const auto list = page.scope("dl", {{"class", "facts"}});
    const auto fact = [&](const char* name, const std::string& value) {
      const auto pair = page.scope("div");
      page.element("dt", name);
      page.element("dd", value);
    };
    if (timings.cpu_seconds > 0) fact("CPU", seconds(timings.cpu_seconds));
    if (timings.wall_seconds > 0) fact("wall clock", seconds(timings.wall_seconds));
    if (timings.peak_bytes > 0) fact("memory at most", bytes(timings.peak_bytes));
  }
  if (timings.stages.empty()) return;
  const auto table = page.scope("table");
  const auto body = page.scope("tbody");
  for (const Timings::Stage& stage : timings.stages) {
    const auto row = page.scope("tr");
    page.element("th", stage.name, {{"scope", "row"}});
    page.element("td", seconds(stage.seconds), {{"class", "n"}});
  }
}

}  // namespace heed::report
