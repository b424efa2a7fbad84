#include <heed/report/write.h>

#include <fmt/format.h>

#include <algorithm>

#include "format.h"
#include "html_parts.h"

namespace heed::report {
namespace {

constexpr double plot_width = 130, plot_height = 70, step_x = 160, step_y = 140, left = 34, heading = 30;

void draw_feature(Markup& page, const std::string& name, const std::vector<double>& reported) {
  page.element("title", name);
  page.element("text", name, {{"class", "name"}, {"x", "0"}, {"y", "-8"}});
  for (const double share : {0.0, 0.5, 1.0}) {
    const std::string y = coordinate(plot_height * (1 - share));
    page.leaf("line", {{"class", share == 0 ? "axis" : "grid"},
                       {"x1", "0"},
                       {"x2", coordinate(plot_width)},
                       {"y1", y},
                       {"y2", y}});
  }
  const double each = plot_width / static_cast<double>(reported.size());
  for (std::size_t cell = 0; cell < reported.size(); ++cell)
    page.leaf("rect", {{"class", "bar"},
                       {"x", coordinate(each * (static_cast<double>(cell) + 0.12))},
                       {"y", coordinate(plot_height * (1 - reported[cell]))},
                       {"width", coordinate(each * 0.76)},
                       {"height", coordinate(plot_height * reported[cell])}});
  page.element("text", "0",
               {{"class", "tick"},
                {"x", coordinate(each / 2)},
                {"y", coordinate(plot_height + 15)},
                {"text-anchor", "middle"}});
  page.element("text", fmt::format("cell {}", reported.size() - 1),
               {{"class", "tick"},
                {"x", coordinate(plot_width)},
                {"y", coordinate(plot_height + 15)},
                {"text-anchor", "end"}});
}

void draw_row(Markup& page, const ProfilePicture& profile) {
  page.element("text", profile.title.empty() ? profile.name : profile.name + ": " + profile.title,
               {{"class", "tick"}, {"x", "10"}, {"y", "18"}});
  page.element("text", "1",
               {{"class", "tick"},
                {"x", coordinate(left - 7)},
                {"y", coordinate(heading + 18)},
                {"text-anchor", "end"}});
  page.element("text", "0",
               {{"class", "tick"},
                {"x", coordinate(left - 7)},
                {"y", coordinate(heading + 18 + plot_height)},
                {"text-anchor", "end"}});
  for (std::size_t f = 0; f < profile.features.size(); ++f) {
    const auto group = page.scope(
        "g",
        {{"class", "k0"},
         {"transform", fmt::format("translate({} {})", coordinate(left + step_x * static_cast<double>(f)),
                                   coordinate(heading + 14))}});
    draw_feature(page, profile.features[f].first, profile.features[f].second);
  }
}

}  // namespace

std::string to_svg(const std::vector<ProfilePicture>& profiles) {
  std::size_t most = 1;
  for (const ProfilePicture& profile : profiles) most = std::max(most, profile.features.size());
  const std::string width = coordinate(left + step_x * static_cast<double>(most));
  const std::string height = coordinate(step_y * static_cast<double>(profiles.size()));
  Markup page;
  {
    const auto svg = page.scope("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                                        {"role", "img"},
                                        {"width", width},
                                        {"height", height},
                                        {"viewBox", fmt::format("0 0 {} {}", width, height)}});
    page.element("title", "Probability that a feature is reported, per cell");
    page.raw("<style>" + picture_style() +
             "svg { font: 13px var(--sans); } .ground { fill: var(--paper); } .k0 { --swatch: var(--k0); "
             "}</style>");
    page.leaf("rect", {{"class", "ground"}, {"width", width}, {"height", height}});
    for (std::size_t p = 0; p < profiles.size(); ++p) {
      const auto row = page.scope(
          "g", {{"transform", fmt::format("translate(0 {})", coordinate(step_y * static_cast<double>(p)))}});
      draw_row(page, profiles[p]);
    }
  }
  return page.finish();
}

}  // namespace heed::report
