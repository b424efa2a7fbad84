#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drive_svg.h"
#include "format.h"
#include "html_parts.h"

namespace heed::report {
namespace {

constexpr double left = 152, panel_width = 232, panel_height = 122, top = 98;
constexpr double plot_width = 204, plot_height = 78, none_width = 16;
constexpr double bin = 0.5;  ///< m/s^2.

/// How many roads braked how hard at most; those that did not halt apart.
struct Histogram {
  std::vector<std::uint64_t> bins;
  std::uint64_t passed = 0, roads = 0;
};

Histogram count(const DriveRun& run, std::size_t bins) {
  Histogram result{std::vector<std::uint64_t>(bins), 0, run.roads.size()};
  for (const DriveRoad& road : run.roads) {
    if (!road.overshoot) {
      ++result.passed;
      continue;
    }
    // A bin holds its upper bound: what the brakes can do at most belongs to the last one.
    const auto place =
        static_cast<std::size_t>(std::max(0.0, std::ceil(road.peak_deceleration / bin - 1e-6) - 1));
    ++result.bins[std::min(place, bins - 1)];
  }
  return result;
}

class Panel {
 public:
  Panel(Markup& page, double most, double x, double y)
      : page_(page), bins_(static_cast<std::size_t>(std::ceil(most / bin))), x_(x), y_(y) {}

  void draw(const DriveRun& run, bool last) {
    const Histogram histogram = count(run, bins_);
    const double step = (plot_width - none_width - 8) / static_cast<double>(bins_);
    draw_line(page_, "axis", {x_, y_ + plot_height, x_ + plot_width, y_ + plot_height});
    bar(histogram.passed, histogram.roads, "fill-none", {x_, 0, none_width, 0});
    for (std::size_t i = 0; i < bins_; ++i)
      bar(histogram.bins[i], histogram.roads, fill_of((static_cast<double>(i) + 0.5) * bin),
          {x_of(static_cast<double>(i) * bin) + 0.5, 0, step - 1, 0});
    if (!last) return;
    for (double value = 0; value <= static_cast<double>(bins_) * bin + 1e-9; value += 3)
      write_label(page_, compact(value, 0), {x_of(value), y_ + plot_height + 16, "tick", "middle"});
  }

 private:
  [[nodiscard]] double x_of(double deceleration) const {
    return x_ + none_width + 8 +
           (plot_width - none_width - 8) * deceleration / (static_cast<double>(bins_) * bin);
  }

  void bar(std::uint64_t number, std::uint64_t of, const std::string& style, Box box) {
    if (number == 0 || of == 0) return;
    const double share = static_cast<double>(number) / static_cast<double>(of);
    box.height = std::max(1.0, plot_height * share);
    box.y = y_ + plot_height - box.height;
    draw_box(page_, style, box);
    if (share >= 0.03)
      write_label(page_, compact(100 * share, 0), {box.x + box.width / 2, box.y - 3, "tick", "middle"});
  }

  Markup& page_;
  std::size_t bins_;
  double x_, y_;
};

}  // namespace

std::string braking_svg(const DriveResult& result) {
  Markup page;
  double most = std::max(9.0, std::ceil(result.most_deceleration));
  const auto columns = static_cast<double>(result.profiles.size());
  const auto rows = static_cast<double>(result.controllers.size());
  {
    const auto svg = open_picture(
        page, {std::max(640.0, left + panel_width * columns + 10), top + panel_height * rows + 34,
               "How hard the car brakes: peak deceleration, per cent of the roads",
               "One histogram for each controller (rows) and profile (columns); the bar on the left is the "
               "roads on which the car does not halt."});
    write_braking_key(page, 20, 54);
    for (std::size_t p = 0; p < result.profiles.size(); ++p)
      write_label(page, shorten(clean(result.profiles[p].name + ": " + result.profiles[p].title), 34),
                  {left + panel_width * static_cast<double>(p), 82, "name"});
    for (std::size_t c = 0; c < result.controllers.size(); ++c) {
      const double y = top + 14 + panel_height * static_cast<double>(c);
      write_label(page, shorten(clean(result.controllers[c].title), 19),
                  {left - 12, y + plot_height - 4, "", "end"});
      for (std::size_t p = 0; p < result.profiles.size(); ++p)
        for (const DriveRun& run : result.runs)
          if (run.profile == result.profiles[p].name && run.controller == result.controllers[c].name)
            Panel(page, most, left + panel_width * static_cast<double>(p), y)
                .draw(run, c + 1 == result.controllers.size());
    }
    write_label(page, "m/s²", {left - 12, top + panel_height * rows - 14, "tick", "end"});
  }
  return page.finish();
}

}  // namespace heed::report
