#include <heed/report/write.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "format.h"
#include "html_parts.h"

namespace heed::report {
namespace {

constexpr double left = 46, top = 26, plot_width = 300, plot_height = 220, width = 372, height = 288;

struct Point {
  double x, y;
};

Point place(const TunedPolicy& one) {
  return {left + plot_width * one.needless.value, top + plot_height * (1 - one.miss.value)};
}

void axes(Markup& page) {
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const double x = left + plot_width * share, y = top + plot_height * (1 - share);
    const char* const style = share == 0 ? "axis" : "grid";
    page.leaf("line", {{"class", style},
                       {"x1", coordinate(x)},
                       {"x2", coordinate(x)},
                       {"y1", coordinate(top)},
                       {"y2", coordinate(top + plot_height)}});
    page.leaf("line", {{"class", style},
                       {"x1", coordinate(left)},
                       {"x2", coordinate(left + plot_width)},
                       {"y1", coordinate(y)},
                       {"y2", coordinate(y)}});
    const std::string words = compact(100 * share, 0);
    page.element("text", words,
                 {{"class", "tick"},
                  {"x", coordinate(x)},
                  {"y", coordinate(top + plot_height + 17)},
                  {"text-anchor", "middle"}});
    page.element(
        "text", words,
        {{"class", "tick"}, {"x", coordinate(left - 7)}, {"y", coordinate(y + 4)}, {"text-anchor", "end"}});
  }
  page.element("text", "needless reactions, %",
               {{"class", "tick"},
                {"x", coordinate(left + plot_width / 2)},
                {"y", coordinate(top + plot_height + 35)},
                {"text-anchor", "middle"}});
  page.element("text", "misses, %", {{"class", "tick"}, {"x", "0"}, {"y", "12"}});
}

/// Through the policies that no other one beats in both errors, as a stair: between two of them one has
/// neither's misses nor the other's needless reactions.
void stair(Markup& page, std::vector<const TunedPolicy*> figures) {
  std::stable_sort(figures.begin(), figures.end(), [](const TunedPolicy* a, const TunedPolicy* b) {
    if (a->needless.value != b->needless.value) return a->needless.value < b->needless.value;
    return a->miss.value < b->miss.value;
  });
  std::string path;
  double fewest = 2;
  for (const TunedPolicy* one : figures) {
    if (one->miss.value >= fewest) continue;
    const Point at = place(*one);
    path += path.empty() ? fmt::format("M{} {}", coordinate(at.x), coordinate(top))
                         : fmt::format("H{}", coordinate(at.x));
    path += fmt::format("V{}", coordinate(at.y));
    fewest = one->miss.value;
  }
  if (!path.empty())
    page.leaf("path", {{"class", "front"}, {"d", path + fmt::format("H{}", coordinate(left + plot_width))}});
}

std::string described(const TunedPolicy& one) {
  return fmt::format("{}: misses {}, needless {}, {} cells left", one.policy, percent(one.miss.value),
                     percent(one.needless.value), compact(one.distance.value, 2));
}

void point(Markup& page, const TunedPolicy& one,
           const std::function<std::string(const std::string&)>& colour) {
  const Point at = place(one);
  const bool own = !one.controller.empty();
  const auto group = page.scope("g", {{"class", own ? colour(one.controller) : ""}});
  page.element("title", described(one));
  page.leaf("circle", {{"class", own            ? "policy own"
                                 : one.on_front ? "policy best"
                                                : "policy"},
                       {"cx", coordinate(at.x)},
                       {"cy", coordinate(at.y)},
                       {"r", own ? "5" : "3.6"}});
}

/// Numbers of the front beside their points; what falls on one place shares a label.
void labels(Markup& page, const std::vector<const TunedPolicy*>& figures) {
  const std::vector<std::size_t> numbers = front_numbers(figures);
  std::map<std::pair<long, long>, std::pair<Point, std::string>> places;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    if (numbers[i] == 0) continue;
    const Point at = place(*figures[i]);
    auto& [where, words] =
        places.try_emplace({std::lround(at.x / 9), std::lround(at.y / 9)}, at, "").first->second;
    words += (words.empty() ? "" : ", ") + std::to_string(numbers[i]);
  }
  for (const auto& [key, label] : places) {
    const bool right = label.first.x > left + plot_width - 40;
    page.element("text", label.second,
                 {{"class", "number"},
                  {"x", coordinate(label.first.x + (right ? -8 : 8))},
                  {"y", coordinate(label.first.y - 6)},
                  {"text-anchor", right ? "end" : "start"}});
  }
}

void draw(Markup& page, const std::vector<const TunedPolicy*>& figures,
          const std::function<std::string(const std::string&)>& colour) {
  axes(page);
  stair(page, figures);
  for (const bool own : {false, true})
    for (const TunedPolicy* one : figures)
      if (one->controller.empty() != own) point(page, *one, colour);
  labels(page, figures);
}

}  // namespace

std::vector<std::size_t> front_numbers(const std::vector<const TunedPolicy*>& figures) {
  std::vector<std::size_t> numbers;
  std::size_t next = 1;
  for (const TunedPolicy* one : figures) numbers.push_back(one->on_front ? next++ : 0);
  return numbers;
}

std::vector<std::vector<const TunedPolicy*>> panels_of(const Tuning& tuning) {
  std::vector<std::vector<const TunedPolicy*>> panels;
  for (const TunedPolicy& one : tuning.figures) {
    const bool same = !panels.empty() && panels.back().front()->profile == one.profile &&
                      panels.back().front()->noise == one.noise;
    if (!same) panels.emplace_back();
    panels.back().push_back(&one);
  }
  return panels;
}

void draw_front(Markup& page, const std::vector<const TunedPolicy*>& figures,
                const std::function<std::string(const std::string&)>& colour) {
  const auto svg = page.scope("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                                      {"class", "chart policies"},
                                      {"role", "img"},
                                      {"viewBox", fmt::format("0 0 {} {}", width, height)}});
  page.element("title", fmt::format("Misses over needless reactions under {}", figures.front()->profile));
  std::string words;
  for (const TunedPolicy* one : figures)
    if (one->on_front) words += described(*one) + ". ";
  page.element("desc", words);
  draw(page, figures, colour);
}

std::string to_svg(const Tuning& tuning) {
  constexpr double heading = 30, legend_step = 18;
  const auto panels = panels_of(tuning);
  double total = 0;
  std::vector<double> tops;
  for (const auto& panel : panels) {
    tops.push_back(total);
    const auto on_front =
        std::count_if(panel.begin(), panel.end(), [](const TunedPolicy* one) { return one->on_front; });
    total += heading + height + legend_step * static_cast<double>(on_front) + 20;
  }
  Markup page;
  {
    const auto svg = page.scope("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                                        {"role", "img"},
                                        {"width", "560"},
                                        {"height", coordinate(total)},
                                        {"viewBox", fmt::format("-10 0 560 {}", coordinate(total))}});
    page.element("title", "Misses over needless reactions, per policy");
    page.raw("<style>" + picture_style() +
             "svg { font: 13px var(--sans); } .ground { fill: var(--paper); } .k0 { --swatch: var(--k0); "
             "}</style>");
    page.leaf(
        "rect",
        {{"class", "ground"}, {"x", "-10"}, {"y", "0"}, {"width", "560"}, {"height", coordinate(total)}});
    for (std::size_t p = 0; p < panels.size(); ++p) {
      const auto group =
          page.scope("g", {{"transform", fmt::format("translate(0 {})", coordinate(tops[p]))}});
      page.element("text", fmt::format("{}, noise {}", panels[p].front()->profile, panels[p].front()->noise),
                   {{"class", "name"}, {"x", "0"}, {"y", "20"}});
      {
        const auto picture =
            page.scope("g", {{"transform", fmt::format("translate(0 {})", coordinate(heading))}});
        draw(page, panels[p], [](const std::string&) { return std::string("k0"); });
      }
      const std::vector<std::size_t> numbers = front_numbers(panels[p]);
      for (std::size_t i = 0; i < panels[p].size(); ++i)
        if (numbers[i] > 0)
          page.element(
              "text",
              fmt::format("{}  {}{}", numbers[i], described(*panels[p][i]),
                          panels[p][i]->controller.empty() ? "" : " (" + panels[p][i]->controller + ")"),
              {{"class", "tick"},
               {"x", "0"},
               {"y", coordinate(heading + height + legend_step * static_cast<double>(numbers[i]))}});
    }
  }
  return page.finish();
}

}  // namespace heed::report
