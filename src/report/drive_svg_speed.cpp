#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drive_svg.h"
#include "format.h"
#include "html_parts.h"

namespace heed::report {
namespace {

constexpr double width = 780, panel_width = 370, panel_height = 218, top = 76;
constexpr double plot_left = 46, plot_right = 352, plot_top = 30, plot_bottom = 166;
constexpr double behind = 15;  ///< Metres behind the line that are shown.

class Panel {
 public:
  Panel(Markup& page, const DriveResult& result, double x, double y)
      : page_(page), result_(result), x_(x), y_(y), before_(result.cell_metres * result.cells) {}

  void draw(const DriveController& controller) {
    write_label(page_, shorten(clean(controller.title), 40), {x_ + plot_left, y_ + 14, "name"});
    ground();
    for (const DriveTrace& trace : result_.traces)
      if (trace.controller == controller.name) way(trace);
  }

 private:
  [[nodiscard]] double x_of(double metres) const {
    const double share = (std::clamp(metres, -before_, behind) + before_) / (before_ + behind);
    return x_ + plot_left + (plot_right - plot_left) * share;
  }
  [[nodiscard]] double y_of(double kmh) const {
    return y_ + plot_bottom - (plot_bottom - plot_top) * std::clamp(kmh / result_.speed_kmh, 0.0, 1.0);
  }

  void ground() {
    for (std::uint32_t cell = 0; cell < result_.cells; ++cell) {
      const double from = x_of(-(cell + 1.0) * result_.cell_metres), to = x_of(-cell * result_.cell_metres);
      if (cell % 2 == 0) draw_box(page_, "band", {from, y_ + plot_top, to - from, plot_bottom - plot_top});
    }
    const std::uint32_t every = std::max<std::uint32_t>(1, (result_.cells + 4) / 5);
    for (std::uint32_t cell = 0; cell <= result_.cells; cell += every)
      write_label(page_, cell == 0 ? "line" : compact(cell * result_.cell_metres, 1) + " m",
                  {x_of(-(cell * result_.cell_metres)), y_ + plot_bottom + 17, "tick", "middle"});
    for (const double share : {0.0, 0.5, 1.0}) {
      const double kmh = result_.speed_kmh * share;
      draw_line(page_, share == 0 ? "axis" : "grid", {x_ + plot_left, y_of(kmh), x_ + plot_right, y_of(kmh)});
      write_label(page_, compact(kmh, 0), {x_ + plot_left - 6, y_of(kmh) + 4, "tick", "end"});
    }
    draw_line(page_, "line", {x_of(0), y_ + plot_top - 6, x_of(0), y_ + plot_bottom});
  }

  /// What all cars share, before any slows down, is drawn in no car's colour.
  void way(const DriveTrace& trace) {
    std::string before, after;
    for (const DrivePoint& point : trace.points) {
      if (point.metres < -before_ || point.metres > behind) continue;
      const std::string words =
          fmt::format("{},{} ", coordinate(x_of(point.metres)), coordinate(y_of(point.kmh)));
      const bool free = after.empty() && point.kmh > result_.speed_kmh - 0.05;
      if (after.empty()) before += words;
      if (!free) after += words;
    }
    const DrivePoint& end = trace.points.back();
    const bool halts = end.kmh < 0.01;
    const auto group = page_.scope("g");
    page_.element("title", fmt::format("{}, road {} of {}", result_.outcomes[trace.outcome], trace.road,
                                       trace.profile));
    if (halts)
      curve("free", before);
    else
      after = before + after;
    curve(halts ? "curve " + std::string(braking_class(peak(trace))) : "pass", after);
    if (halts)
      page_.leaf("circle", {{"class", "dot"},
                            {"cx", coordinate(x_of(end.metres))},
                            {"cy", coordinate(y_of(0))},
                            {"r", "3.4"}});
  }

  void curve(const std::string& style, std::string points) {
    if (points.empty()) return;
    points.pop_back();
    page_.leaf("polyline", {{"class", style}, {"points", points}});
  }

  /// Of the whole road, as the table has it.
  [[nodiscard]] double peak(const DriveTrace& trace) const {
    for (const DriveRun& run : result_.runs)
      if (run.profile == trace.profile && run.controller == trace.controller)
        return run.roads[trace.road].peak_deceleration;
    return 0;
  }

  Markup& page_;
  const DriveResult& result_;
  double x_, y_, before_;
};

}  // namespace

std::string speed_svg(const DriveResult& result) {
  Markup page;
  const auto rows = (result.controllers.size() + 1) / 2;
  {
    const auto svg = open_picture(
        page,
        {width, top + panel_height * static_cast<double>(rows) + 8,
         "Speed in km/h over the distance to the line: one road of each outcome",
         "Each curve is one car on one road; the circle is where it halts, the upright line is the line "
         "at the sign."});
    write_braking_key(page, 20, 54);
    for (std::size_t i = 0; i < result.controllers.size(); ++i)
      Panel(page, result, 14 + static_cast<double>(i % 2) * (panel_width + 14),
            top + panel_height * std::floor(static_cast<double>(i) / 2))
          .draw(result.controllers[i]);
  }
  return page.finish();
}

}  // namespace heed::report
