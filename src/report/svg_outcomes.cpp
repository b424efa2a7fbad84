#include <fmt/format.h>

#include <algorithm>

#include "format.h"
#include "html_parts.h"
#include "lookup.h"

namespace heed::report {

namespace {

// Bars lie on their side: names and figures then stand upright at any width, four controllers and five
// outcomes included.
constexpr double width = 380, left = 78, plot = 242, top = 8;
constexpr double bar_height = 13, bar_step = 17, group_gap = 15;
constexpr std::size_t longest_label = 11;

double x_of(double share) {
  return left + plot * std::clamp(share, 0.0, 1.0);
}

struct Placed {
  std::size_t chart;  ///< In RunResult::charts.
  std::size_t bar;
};

class Picture {
 public:
  Picture(Markup& page, const RunResult& result, const Profile& profile)
      : page_(page), result_(result), profile_(profile), labels_(bar_labels(result, profile.name)) {
    charts_.reserve(result.charts.size());
    for (std::size_t i = 0; i < result.charts.size(); ++i)
      if (result.charts[i].profile == profile.name) charts_.push_back(i);
  }

  void draw();

 private:
  [[nodiscard]] double group_height() const { return static_cast<double>(charts_.size()) * bar_step; }
  [[nodiscard]] double group_top(std::size_t group) const {
    return top + static_cast<double>(group) * (group_height() + group_gap);
  }
  [[nodiscard]] double bottom() const { return group_top(labels_.size()) - group_gap + 6; }

  void describe();
  void axis();
  void group(std::size_t index);
  void bar(Placed placed, double y);
  void sample(Placed placed, double y);

  Markup& page_;
  const RunResult& result_;
  const Profile& profile_;
  std::vector<std::string> labels_;
  std::vector<std::size_t> charts_;
};

void Picture::describe() {
  page_.element("title", fmt::format("Outcomes under {}", profile_.name));
  std::string words;
  for (const std::size_t index : charts_) {
    const Chart& chart = result_.charts[index];
    std::vector<std::string> figures;
    for (const Bar& one : chart.bars)
      figures.push_back(fmt::format("{} {}", one.label, percent(one.exact.value)));
    words += fmt::format("{}: {}. ", title_of(result_, chart.controller), join(figures, ", "));
  }
  page_.element("desc", words);
}

void Picture::axis() {
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const std::string x = coordinate(x_of(share));
    page_.leaf("line", {{"class", share == 0 ? "axis" : "grid"},
                        {"x1", x},
                        {"x2", x},
                        {"y1", "2"},
                        {"y2", coordinate(bottom())}});
    page_.element("text", share == 1 ? "100 %" : compact(100 * share, 0),
                  {{"class", "tick"}, {"x", x}, {"y", coordinate(bottom() + 16)}, {"text-anchor", "middle"}});
  }
}

void Picture::sample(Placed placed, double y) {
  const Chart& chart = result_.charts[placed.chart];
  if (chart.traces == 0) return;
  const Bar& one = chart.bars[placed.bar];
  const std::string path = fmt::format("/charts/{}/bars/{}/", placed.chart, placed.bar);
  const double frequency = static_cast<double>(one.sampled) / static_cast<double>(chart.traces);
  const std::string middle = coordinate(y + bar_height / 2);
  page_.leaf("line", {{"class", "whisker"},
                      {"x1", coordinate(x_of(one.low))},
                      {"x2", coordinate(x_of(one.high))},
                      {"y1", middle},
                      {"y2", middle}});
  const auto cap = [&](const char* name, double share) {
    const std::string x = coordinate(x_of(share));
    page_.leaf("line", with_data({{"class", "whisker cap"},
                                  {"x1", x},
                                  {"x2", x},
                                  {"y1", coordinate(y + 2.5)},
                                  {"y2", coordinate(y + bar_height - 2.5)}},
                                 path + name, share));
  };
  cap("low", one.low);
  cap("high", one.high);
  page_.leaf("circle",
             with_data({{"class", "dot"}, {"cx", coordinate(x_of(frequency))}, {"cy", middle}, {"r", "2.4"}},
                       path + "frequency", frequency));
}

void Picture::bar(Placed placed, double y) {
  const Chart& chart = result_.charts[placed.chart];
  const Bar& one = chart.bars[placed.bar];
  const double share = one.exact.value;
  const std::string path = fmt::format("/charts/{}/bars/{}/exact/value", placed.chart, placed.bar);
  const auto group = page_.scope("g", {{"class", colour_class(result_, chart.controller)}});
  page_.element("title",
                fmt::format("{}, {}: {}{}", title_of(result_, chart.controller), one.label,
                            one.exact.exact.empty() ? "" : one.exact.exact + " = ", shortest(share)));
  page_.leaf("rect", with_data({{"class", "bar"},
                                {"x", coordinate(left)},
                                {"y", coordinate(y)},
                                {"width", fmt::format("{:.4f}", x_of(share) - left)},
                                {"height", coordinate(bar_height)}},
                               path, share));
  // Nothing was drawn and nothing can be: a whisker around zero would only be noise.
  const bool never = share == 0 && one.sampled == 0;
  if (!never) sample(placed, y);
  const double end = never ? left : x_of(std::max(share, chart.traces > 0 ? one.high : share));
  page_.element("text", percent(share),
                with_data({{"class", never ? "value none" : "value"},
                           {"x", coordinate(end + 7)},
                           {"y", coordinate(y + bar_height - 2.4)}},
                          path, share));
}

void Picture::group(std::size_t index) {
  const double y = group_top(index);
  const std::string& label = labels_[index];
  page_.element("text", shorten(clean(label), longest_label),
                {{"x", coordinate(left - 10)},
                 {"y", coordinate(y + group_height() / 2 + 2.5)},
                 {"text-anchor", "end"}});
  for (std::size_t i = 0; i < charts_.size(); ++i) {
    const Chart& chart = result_.charts[charts_[i]];
    for (std::size_t b = 0; b < chart.bars.size(); ++b)
      if (chart.bars[b].label == label) bar({charts_[i], b}, y + static_cast<double>(i) * bar_step);
  }
}

void Picture::draw() {
  if (charts_.empty()) return;
  const auto svg =
      page_.scope("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                          {"class", "chart outcomes"},
                          {"role", "img"},
                          {"viewBox", fmt::format("0 0 {} {}", width, coordinate(bottom() + 22))}});
  describe();
  axis();
  for (std::size_t i = 0; i < labels_.size(); ++i) group(i);
}

}  // namespace

void draw_profile(Markup& page, const RunResult& result, const Profile& profile) {
  Picture(page, result, profile).draw();
}

}  // namespace heed::report
