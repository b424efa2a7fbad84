#include <fmt/format.h>

#include "format.h"
#include "html_parts.h"
#include "lookup.h"

namespace heed::report {
namespace {

void write_number(Markup& page, const std::optional<Number>& number, const std::string& path) {
  if (!number) {
    page.element("td", "–", {{"class", "n"}});
    return;
  }
  const auto cell = page.scope("td", with_data({{"class", "n"}}, path + "/value", number->value));
  page.text(fixed(number->value, 4));
  constexpr std::size_t most = 24;
  if (number->exact.find('/') != std::string::npos && number->exact.size() <= most)
    page.element("span", number->exact, {{"class", "exact"}});
}

void write_drive(Markup& page, const RunResult& result, const Drive& drive, const std::string& path,
                 bool conflicts) {
  const auto row = page.scope("tr");
  page.element("th", drive.profile, {{"scope", "row"}});
  {
    const auto cell = page.scope("td");
    write_name(page, result, drive.controller, title_of(result, drive.controller));
  }
  write_number(page, drive.needless, path + "/needless");
  write_number(page, drive.misses, path + "/misses");
  write_number(page, drive.long_needless, path + "/long_run/needless");
  write_number(page, drive.long_misses, path + "/long_run/misses");
  if (conflicts) write_number(page, drive.conflict, path + "/conflict");
}

void write_road(Markup& page, const RunResult& result, std::size_t index) {
  const Road& road = result.roads[index];
  const bool conflicts = sees_conflicts(road);
  const auto box = scroll_box(page, road.title);
  const auto table = page.scope("table");
  write_caption(page, fmt::format("{}: {}", road.title, road_explained(road)));
  {
    const auto head = page.scope("thead");
    const auto row = page.scope("tr");
    for (const char* name : {"Profile", "Controller"}) page.element("th", name, {{"scope", "col"}});
    for (const char* name : {"Needless", "Misses", "Needless a thing", "Misses a thing"})
      page.element("th", name, {{"scope", "col"}, {"class", "n"}});
    if (conflicts) page.element("th", "P(conflict)", {{"scope", "col"}, {"class", "n"}});
  }
  const auto body = page.scope("tbody");
  for (std::size_t i = 0; i < road.drives.size(); ++i)
    write_drive(page, result, road.drives[i], fmt::format("/roads/{}/drives/{}", index, i), conflicts);
}

}  // namespace

void write_roads(Markup& page, const RunResult& result) {
  if (result.roads.empty()) return;
  const auto part = section(
      page, "roads", "Along a road",
      "What is to be expected when one thing comes after another and the controller keeps its state: how "
      "often it reacts needlessly and how often it misses, on the whole road and, in the long run, for "
      "each thing that is passed. A conflict: what is seen contradicts itself. All figures are exact.");
  for (std::size_t i = 0; i < result.roads.size(); ++i) write_road(page, result, i);
}

}  // namespace heed::report
