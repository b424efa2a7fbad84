#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drive_svg.h"
#include "format.h"
#include "html_parts.h"

namespace heed::report {
namespace {

constexpr double width = 780, left = 176, right = 524, top = 102, row_height = 44;
constexpr double abstract_at = 540, driven_at = 650;

class Picture {
 public:
  Picture(Markup& page, const DriveResult& result, const std::vector<DriveOutcome>& rows)
      : page_(page), result_(result), rows_(rows) {
    for (const DriveOutcome& row : rows) {
      before_ = std::max(before_, row.distance);
      behind_ = std::max(behind_, row.halt.most);
    }
    before_ = std::max(before_, result.cell_metres);
    behind_ = std::ceil(behind_ + 2);
  }

  void draw() {
    const double bottom = top + row_height * static_cast<double>(rows_.size());
    write_label(page_, "abstract", {abstract_at, 82, "name"});
    write_label(page_, "driven", {driven_at, 82, "name"});
    write_label(page_, "m/s²", {abstract_at + 66, 82});
    write_label(page_, "m/s², halt", {driven_at + 54, 82});
    for (double metres = 0; metres <= before_ + 1e-9; metres += step()) {
      const double x = x_of(-metres);
      draw_line(page_, metres == 0 ? "line" : "grid", {x, top - 12, x, bottom});
      write_label(page_, metres == 0 ? "line" : compact(metres, 0) + " m",
                  {x, bottom + 18, "tick", "middle"});
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) row(rows_[i], top + row_height * static_cast<double>(i));
  }

 private:
  [[nodiscard]] double x_of(double metres) const {
    return left + (right - left) * (metres + before_) / (before_ + behind_);
  }
  [[nodiscard]] double step() const {
    return result_.cell_metres * std::max(1.0, std::ceil(before_ / result_.cell_metres / 8));
  }

  void row(const DriveOutcome& one, double y) {
    write_label(page_, shorten(clean(result_.outcomes[one.outcome]), 18), {left - 14, y + 10, "", "end"});
    write_label(page_, fmt::format("{}{}", one.cells_left ? "" : "never reacts, ", plural(one.roads, "road")),
                {left - 14, y + 26, "tick", "end"});
    if (one.distance > 0) {
      draw_box(page_, "outline", {x_of(-one.distance), y, x_of(0) - x_of(-one.distance), 10});
      write_label(page_, fixed(one.deceleration, 1), {abstract_at, y + 14, "value"});
    } else {
      write_label(page_, "no stop", {abstract_at, y + 14, "value none"});
    }
    driven(one, y);
  }

  void driven(const DriveOutcome& one, double y) {
    if (one.halt.count == 0) {
      draw_line(page_, "pass", {x_of(-before_), y + 16, x_of(behind_), y + 16});
      write_label(page_, "drives past", {driven_at, y + 14, "value none"});
      return;
    }
    const double from = x_of(-one.distance), to = x_of(one.halt.mean);
    draw_box(page_, fill_of(one.peak.mean), {from, y + 13, std::max(1.0, to - from), 10});
    if (one.halt.most - one.halt.least > 0.2)
      draw_line(page_, "whisker", {x_of(one.halt.least), y + 18, x_of(one.halt.most), y + 18});
    const std::string low = fixed(one.peak.least, 1), high = fixed(one.peak.most, 1);
    write_label(page_, low == high ? low : low + " – " + high, {driven_at, y + 14, "value"});
    write_label(page_, place(one.halt), {driven_at, y + 29, "tick"});
  }

  static std::string place(const DriveSpread& halt) {
    if (halt.most <= at_the_line) return "at the line";
    const std::string low = fixed(halt.least, 1), high = fixed(halt.most, 1);
    return (low == high ? high : low + " – " + high) + " m behind it";
  }

  Markup& page_;
  const DriveResult& result_;
  const std::vector<DriveOutcome>& rows_;
  double before_ = 0, behind_ = 0;
};

}  // namespace

std::string metres_svg(const DriveResult& result) {
  Markup page;
  const std::vector<DriveOutcome> rows = side_by_side(result);
  {
    const auto svg =
        open_picture(page, {width, top + row_height * static_cast<double>(rows.size()) + 34,
                            "The abstract outcome, and the metres that were driven",
                            "For each outcome the braking distance in the abstract, as an outline, and below "
                            "it where the car braked and halted, over all controllers and profiles."});
    write_braking_key(page, 20, 54);
    Picture(page, result, rows).draw();
  }
  return page.finish();
}

}  // namespace heed::report
