#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "format.h"
#include "html_parts.h"

namespace heed::report {

namespace {

constexpr double width = 480, height = 312, left = 48, right = 440, top = 76, bottom = 262;

class Picture {
 public:
  Picture(Markup& page, const SpeedPicture& picture)
      : page_(page),
        picture_(picture),
        horizon_(std::max(picture.cell_metres * picture.horizon_cells, 1e-9)) {}

  void draw();

 private:
  [[nodiscard]] double x_of(double metres) const { return right - (right - left) * metres / horizon_; }
  [[nodiscard]] double y_of(double kmh) const {
    return bottom - (bottom - top) * kmh / std::max(picture_.speed_kmh, 1e-9);
  }

  void describe();
  void road();
  void sign();
  void curve(std::size_t index);

  Markup& page_;
  const SpeedPicture& picture_;
  double horizon_;
};

void Picture::describe() {
  page_.element("title", "Speed over the distance to the sign");
  std::string words = "Before braking the car keeps its speed; past the sign it was missed. ";
  for (const SpeedCurve& one : picture_.curves)
    words += fmt::format("{}: {:.1f} metres per second squared over {} metres. ", one.label, one.deceleration,
                         compact(one.cells * picture_.cell_metres, 1));
  page_.element("desc", words);
}

void Picture::road() {
  for (unsigned cell = 0; cell < picture_.horizon_cells; ++cell) {
    const double from = x_of((cell + 1) * picture_.cell_metres), to = x_of(cell * picture_.cell_metres);
    if (cell % 2 == 0)
      page_.leaf("rect", {{"class", "band"},
                          {"x", coordinate(from)},
                          {"y", coordinate(top)},
                          {"width", coordinate(to - from)},
                          {"height", coordinate(bottom - top)}});
  }
  for (unsigned cell = 0; cell <= picture_.horizon_cells; ++cell) {
    const double metres = cell * picture_.cell_metres;
    page_.element("text", cell == 0 ? "0" : compact(metres, 1) + " m",
                  {{"class", "tick"},
                   {"x", coordinate(x_of(metres))},
                   {"y", coordinate(bottom + 20)},
                   {"text-anchor", "middle"}});
  }
  for (const double share : {0.0, 0.5, 1.0}) {
    const double kmh = picture_.speed_kmh * share;
    const std::string y = coordinate(y_of(kmh));
    page_.leaf("line", {{"class", share == 0 ? "axis" : "grid"},
                        {"x1", coordinate(left)},
                        {"x2", coordinate(right)},
                        {"y1", y},
                        {"y2", y}});
    page_.element("text", compact(kmh, 1),
                  {{"class", "tick"},
                   {"x", coordinate(left - 8)},
                   {"y", coordinate(y_of(kmh) + 4)},
                   {"text-anchor", "end"}});
  }
  page_.element(
      "text", "km/h",
      {{"class", "tick"}, {"x", coordinate(left - 8)}, {"y", coordinate(top - 14)}, {"text-anchor", "end"}});
  page_.element("text", "distance to the sign",
                {{"class", "tick"},
                 {"x", coordinate((left + right) / 2)},
                 {"y", coordinate(bottom + 40)},
                 {"text-anchor", "middle"}});
}

void Picture::sign() {
  constexpr double radius = 13;
  const double x = x_of(0) + 14, y = top - 44;
  std::string points;
  for (int corner = 0; corner < 8; ++corner) {
    const double angle = (corner + 0.5) * std::numbers::pi / 4;
    points += fmt::format("{}{},{}", corner == 0 ? "" : " ", coordinate(x + radius * std::cos(angle)),
                          coordinate(y + radius * std::sin(angle)));
  }
  const std::string pole = coordinate(x);
  page_.leaf(
      "line",
      {{"class", "axis"}, {"x1", pole}, {"x2", pole}, {"y1", coordinate(y)}, {"y2", coordinate(bottom)}});
  page_.leaf("polygon", {{"class", "sign"}, {"points", points}});
  const std::string speed = coordinate(y_of(picture_.speed_kmh));
  page_.leaf("line", {{"class", "pass"},
                      {"x1", coordinate(right)},
                      {"x2", coordinate(width)},
                      {"y1", speed},
                      {"y2", speed}});
}

void Picture::curve(std::size_t index) {
  const SpeedCurve& one = picture_.curves[index];
  const std::string hardness(braking_class(one.deceleration));
  std::string points;
  for (const SpeedCurve::Point& point : one.points)
    points += fmt::format("{}{},{}", points.empty() ? "" : " ", coordinate(x_of(point.metres_to_sign)),
                          coordinate(y_of(point.kmh)));
  page_.leaf("polyline", {{"class", "curve " + hardness},
                          {"points", points},
                          {"data-points", fmt::format("/speed/curves/{}/points", index)}});
  const double x = x_of(one.cells * picture_.cell_metres);
  page_.leaf("circle", {{"class", "dot"}, {"cx", coordinate(x)}, {"cy", coordinate(top)}, {"r", "3.4"}});
  page_.element("text", shorten(clean(one.label), 12),
                {{"class", "name"}, {"x", coordinate(x)}, {"y", coordinate(top - 32)}});
  page_.element("text", fmt::format("{:.1f} m/s²", one.deceleration),
                with_data({{"class", "tick"}, {"x", coordinate(x)}, {"y", coordinate(top - 14)}},
                          fmt::format("/speed/curves/{}/deceleration", index), one.deceleration));
}

void Picture::draw() {
  const auto svg = page_.scope("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                                       {"class", "chart speed"},
                                       {"role", "img"},
                                       {"viewBox", fmt::format("0 0 {} {}", width, height)}});
  describe();
  road();
  sign();
  for (std::size_t i = 0; i < picture_.curves.size(); ++i) curve(i);
}

}  // namespace

std::string_view braking_class(double deceleration) {
  return deceleration <= 3 ? "gentle" : deceleration <= 6 ? "firm" : "emergency";
}

void draw_speed(Markup& page, const SpeedPicture& picture) {
  Picture(page, picture).draw();
}

}  // namespace heed::report
