#include <fmt/format.h>

#include <algorithm>

#include "format.h"
#include "html_parts.h"

namespace heed::report {
namespace {

void write_number(Markup& page, const Number& number, const std::string& path) {
  const auto cell = page.scope("td", with_data({{"class", "n"}}, path + "/value", number.value));
  page.text(fixed(number.value, 4));
  constexpr std::size_t most = 9;
  if (number.exact.find('/') != std::string::npos && number.exact.size() <= most)
    page.element("span", number.exact, {{"class", "exact"}});
}

void write_braking(Markup& page, const TunedPolicy& one, const std::string& path) {
  if (!one.braking) {
    page.element("td", "–", {{"class", "n"}});
    return;
  }
  const auto cell =
      page.scope("td", with_data({{"class", "n"}}, path + "/braking/value", one.braking->value));
  page.text(fixed(one.braking->value, 1));
  page.element("span", "up to " + fixed(one.hardest->value, 1), {{"class", "exact"}});
}

void write_row(Markup& page, const RunResult& result, const TunedPolicy& one, std::size_t number,
               std::size_t index) {
  const std::string path = fmt::format("/tuning/figures/{}", index);
  const auto row = page.scope("tr");
  page.element("td", number > 0 ? std::to_string(number) : "", {{"class", "n"}});
  {
    const auto cell = page.scope("th", {{"scope", "row"}, {"class", "rule"}});
    if (one.controller.empty())
      page.text(one.policy);
    else
      write_name(page, result, one.controller, one.policy);
  }
  write_number(page, one.miss, path + "/miss");
  write_number(page, one.needless, path + "/needless");
  write_number(page, one.distance, path + "/cells_left");
  if (one.braking || std::any_of(result.tuning.figures.begin(), result.tuning.figures.end(),
                                 [](const TunedPolicy& other) { return other.braking.has_value(); }))
    write_braking(page, one, path);
}

void write_head(Markup& page, const Tuning& tuning) {
  const auto head = page.scope("thead");
  const auto row = page.scope("tr");
  page.element("th", "", {{"scope", "col"}});
  page.element("th", "Policy", {{"scope", "col"}});
  for (const char* name : {"Misses", "Needless", "Cells left"})
    page.element("th", name, {{"scope", "col"}, {"class", "n"}});
  if (std::any_of(tuning.figures.begin(), tuning.figures.end(),
                  [](const TunedPolicy& one) { return one.braking.has_value(); }))
    page.element("th", "Braking, m/s²", {{"scope", "col"}, {"class", "n"}});
}

void write_panel(Markup& page, const RunResult& result, const std::vector<const TunedPolicy*>& figures) {
  const TunedPolicy& first = *figures.front();
  const std::string name =
      first.noise == "0" ? first.profile : fmt::format("{}, noise {}", first.profile, first.noise);
  const auto pair = page.scope("div", {{"class", "pairs"}});
  {
    const auto figure = page.scope("figure");
    {
      const auto caption = page.scope("figcaption");
      page.element("strong", name);
    }
    draw_front(page, figures,
               [&](const std::string& controller) { return colour_class(result, controller); });
  }
  const auto box = scroll_box(page, "Policies under " + name);
  const auto table = page.scope("table");
  write_head(page, result.tuning);
  const auto body = page.scope("tbody");
  const std::vector<std::size_t> numbers = front_numbers(figures);
  for (std::size_t i = 0; i < figures.size(); ++i)
    if (numbers[i] > 0 || !figures[i]->controller.empty())
      write_row(page, result, *figures[i], numbers[i],
                static_cast<std::size_t>(figures[i] - result.tuning.figures.data()));
}

}  // namespace

void write_policies(Markup& page, const RunResult& result) {
  const Tuning& tuning = result.tuning;
  if (tuning.figures.empty()) return;
  const auto part =
      section(page, "policies", "Which policy to take",
              fmt::format("Each point is a way to say when {} counts as recognised, synthesized and verified "
                          "like the controllers above. The "
                          "nearer to the lower left corner, the better. “Needless”: the probability to react "
                          "past something that asks for no "
                          "reaction, when {} are equally likely. Numbered: no other one is better in misses, "
                          "needless reactions or distance "
                          "without being worse in another. In colour: the controllers of this page.",
                          result.thing, plural(tuning.things, "thing")));
  for (const auto& panel : panels_of(tuning)) write_panel(page, result, panel);
  std::string words = "All figures are exact. ";
  if (std::any_of(tuning.figures.begin(), tuning.figures.end(),
                  [](const TunedPolicy& one) { return one.braking.has_value(); }))
    words +=
        "Braking is the deceleration to rest at the thing from where the controller reacts, v² / 2d: its "
        "mean over the approaches "
        "in which there is a way left, and the largest that can come. ";
  if (!tuning.whole) words += "heed tune compares more policies, at levels of noise as well.";
  page.element("p", words, {{"class", "because"}});
}

}  // namespace heed::report
