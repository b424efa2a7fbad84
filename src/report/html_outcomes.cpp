#include <fmt/format.h>

#include <algorithm>

#include "format.h"
#include "html_parts.h"
#include "lookup.h"

namespace heed::report {

namespace {

void write_legend(Markup& page, const RunResult& result) {
  const auto list = page.scope("ul", {{"class", "legend"}});
  for (const Controller& controller : result.controllers) {
    if (controller.verdict == Verdict::Unrealizable) continue;
    const auto item = page.scope("li");
    write_name(page, result, controller.name, title_of(controller));
  }
  const bool sampled =
      std::any_of(result.charts.begin(), result.charts.end(), [](const Chart& c) { return c.traces > 0; });
  if (!sampled) return;
  const auto item = page.scope("li");
  {
    const auto svg = page.scope(
        "svg", {{"xmlns", "http://www.w3.org/2000/svg"}, {"viewBox", "0 0 36 15"}, {"aria-hidden", "true"}});
    page.leaf("path", {{"class", "whisker"}, {"d", "M3 3v9M33 3v9M3 7.5h30"}});
    page.leaf("circle", {{"class", "dot"}, {"cx", "18"}, {"cy", "7.5"}, {"r", "3"}});
  }
  page.text(fmt::format("sampled, with {} interval at {}", result.interval, percent(result.confidence)));
}

void write_figure(Markup& page, const RunResult& result, const Profile& profile) {
  const auto figure = page.scope("figure");
  {
    const auto caption = page.scope("figcaption");
    page.element("strong", profile.title.empty() ? profile.name : profile.name + " · " + profile.title);
  }
  draw_profile(page, result, profile);
  for (const std::string& line : profile.description) page.element("p", line, {{"class", "because"}});
}

void write_cell(Markup& page, const Chart& chart, std::size_t index, const std::string& label) {
  for (std::size_t b = 0; b < chart.bars.size(); ++b) {
    const Bar& bar = chart.bars[b];
    if (bar.label != label) continue;
    const auto cell =
        page.scope("td", with_data({{"class", "n"}}, fmt::format("/charts/{}/bars/{}/exact/value", index, b),
                                   bar.exact.value));
    page.text(percent(bar.exact.value));
    if (!bar.exact.exact.empty() && bar.exact.exact != "0")
      page.element("span", bar.exact.exact, {{"class", "exact"}});
    return;
  }
  page.element("td", "–", {{"class", "n"}});
}

/// How many cells are left on average when the controller reacts.
void write_reaction(Markup& page, const Chart& chart, std::size_t index) {
  if (!chart.reaction) return;
  const auto cell =
      page.scope("td", with_data({{"class", "n"}}, fmt::format("/charts/{}/reaction/mean/value", index),
                                 chart.reaction->value));
  page.text(fixed(chart.reaction->value, 2));
  if (chart.reaction->exact.find('/') != std::string::npos)
    page.element("span", chart.reaction->exact, {{"class", "exact"}});
}

/// The profile's name stands once, over all its controllers.
void write_profile_name(Markup& page, const RunResult& result, std::size_t index) {
  const std::string& profile = result.charts[index].profile;
  if (index > 0 && result.charts[index - 1].profile == profile) return;
  std::size_t end = index + 1;
  while (end < result.charts.size() && result.charts[end].profile == profile) ++end;
  page.element("th", profile, {{"scope", "rowgroup"}, {"rowspan", std::to_string(end - index)}});
}

void write_row(Markup& page, const RunResult& result, std::size_t index,
               const std::vector<std::string>& labels) {
  const Chart& chart = result.charts[index];
  const auto row = page.scope("tr");
  write_profile_name(page, result, index);
  {
    const auto cell = page.scope("td");
    write_name(page, result, chart.controller, title_of(result, chart.controller));
  }
  for (const std::string& label : labels) write_cell(page, chart, index, label);
  write_reaction(page, chart, index);
  if (chart.traces == 0) {
    page.element("td", "not sampled", {{"class", "n"}});
    return;
  }
  const std::string path = fmt::format("/charts/{}/chi_square/p_value", index);
  page.element("td", fmt::format("{:.2g}", chart.p_value), with_data({{"class", "n"}}, path, chart.p_value));
}

/// Such as "; 10,000 traces per chart"; empty where the charts differ or none was sampled.
std::string traces_per_chart(const RunResult& result) {
  const std::uint64_t traces = result.charts.front().traces;
  for (const Chart& chart : result.charts)
    if (chart.traces != traces) return {};
  return traces == 0 ? std::string() : fmt::format("; {} per chart", plural(traces, "trace"));
}

}  // namespace

void write_outcomes(Markup& page, const RunResult& result) {
  if (result.charts.empty()) return;
  const auto part =
      section(page, "outcomes", "How the approaches end",
              "Bars are exact probabilities. “Stop in n”: the sign is known with n cells left "
              "to brake in; infeasible: too late or never. “Cells left” is the expected distance of "
              "the reaction, counting 0 where there is none: the more, the more gently the car brakes.");
  write_legend(page, result);
  {
    const auto charts = page.scope("div", {{"class", "charts"}});
    for (const Profile& profile : result.profiles)
      if (!bar_labels(result, profile.name).empty()) write_figure(page, result, profile);
  }
  const auto box = scroll_box(page, "Exact probabilities");
  const auto table = page.scope("table");
  write_caption(
      page, fmt::format("The same, exactly. p: chi-square test of the samples against the exact figures{}",
                        traces_per_chart(result)));
  const std::vector<std::string> labels = bar_labels(result);
  {
    const auto head = page.scope("thead");
    const auto row = page.scope("tr");
    page.element("th", "Profile", {{"scope", "col"}});
    page.element("th", "Controller", {{"scope", "col"}});
    for (const std::string& label : labels) page.element("th", label, {{"scope", "col"}, {"class", "n"}});
    if (result.charts.front().reaction) page.element("th", "Cells left", {{"scope", "col"}, {"class", "n"}});
    page.element("th", "p", {{"scope", "col"}, {"class", "n"}});
  }
  const auto body = page.scope("tbody");
  for (std::size_t i = 0; i < result.charts.size(); ++i) write_row(page, result, i, labels);
}

void write_speed(Markup& page, const RunResult& result) {
  const SpeedPicture& picture = result.speed;
  if (picture.curves.empty() || result.charts.empty()) return;
  const auto part = section(
      page, "speed", "What “stop in n” feels like",
      fmt::format(
          "From {} km/h, each cell {} m long: the later the sign is known, the harder the car must brake. "
          "Up to 3 m/s² is gentle, up to 6 firm; beyond, an emergency.",
          compact(picture.speed_kmh, 1), compact(picture.cell_metres, 1)));
  const auto pairs = page.scope("div", {{"class", "pairs"}});
  {
    const auto figure = page.scope("figure");
    draw_speed(page, picture);
  }
  const auto box = scroll_box(page, "Deceleration per outcome");
  const auto table = page.scope("table");
  {
    const auto head = page.scope("thead");
    const auto row = page.scope("tr");
    for (const char* name : {"Outcome", "Distance", "Deceleration", "The car’s way"})
      page.element("th", name, {{"scope", "col"}});
  }
  const auto body = page.scope("tbody");
  for (std::size_t i = 0; i < picture.curves.size(); ++i) {
    const SpeedCurve& curve = picture.curves[i];
    const auto row = page.scope("tr");
    page.element("th", curve.label, {{"scope", "row"}});
    page.element("td", compact(curve.cells * picture.cell_metres, 1) + " m", {{"class", "n"}});
    page.element("td", fmt::format("{:.1f} m/s², {}", curve.deceleration, braking_class(curve.deceleration)),
                 with_data({}, fmt::format("/speed/curves/{}/deceleration", i), curve.deceleration));
    const auto cell = page.scope("td");
    page.element("code", join(curve.states, " "));
  }
  if (result.road.empty()) return;
  const auto row = page.scope("tr");
  page.element("th", result.miss_label, {{"scope", "row"}});
  page.element("td", "–", {{"class", "n"}});
  page.element("td", "drives past");
  const auto cell = page.scope("td");
  page.element("code", join(result.road, " "));
}

}  // namespace heed::report
