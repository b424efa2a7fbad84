#include <heed/report/drive.h>

#include <fmt/format.h>

#include "format.h"
#include "html_parts.h"

namespace heed::report {
namespace {

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = word << 8 | (k < left ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) out += k <= left ? digits[word >> (18 - 6 * k) & 63U] : '=';
  }
  return out;
}

/// A document of its own, with its own style: what it calls things does not meet the names of the page.
void write_picture(Markup& page, const std::string& svg, const char* words) {
  const auto figure = page.scope("figure");
  const auto box = scroll_box(page, words);
  page.leaf("img",
            {{"class", "picture"}, {"alt", words}, {"src", "data:image/svg+xml;base64," + base64(svg)}});
}

std::string share(std::uint64_t number, std::uint64_t of) {
  return of == 0 ? "–" : percent(static_cast<double>(number) / static_cast<double>(of));
}

void write_row(Markup& page, const RunResult& result, const DriveRun& run) {
  const DriveResult& driving = *result.driving;
  const DriveSummary sum = summarise(run, driving.outcomes.size());
  const auto row = page.scope("tr");
  {
    const auto head = page.scope("th", {{"scope", "row"}});
    write_name(page, result, run.controller, title_of(result, run.controller));
  }
  const auto cell = [&](const std::string& text) { page.element("td", text, {{"class", "n"}}); };
  cell(share(sum.at_line, sum.roads));
  cell(share(sum.over_line, sum.roads));
  cell(share(sum.passed, sum.roads));
  cell(sum.overshoot.count == 0 ? "–" : fixed(sum.overshoot.most, 1));
  cell(sum.deceleration.count == 0 ? "–" : fixed(sum.deceleration.mean, 1));
  cell(sum.jerk.count == 0 ? "–" : fixed(sum.jerk.mean, 1));
  cell(fixed(sum.time_lost.mean, 1));
  cell(driving.followers == 0 ? "–" : share(sum.conflicts, sum.roads));
  cell(driving.followers == 0 ? "–" : share(sum.collisions, sum.roads));
}

void write_table(Markup& page, const RunResult& result, const DriveProfile& profile) {
  const std::string name = fmt::format("{}: {}", profile.name, profile.title);
  const auto box = scroll_box(page, "Driving under " + name);
  const auto table = page.scope("table");
  write_caption(page, name);
  {
    const auto head = page.scope("thead");
    const auto row = page.scope("tr");
    page.element("th", "Controller", {{"scope", "col"}});
    for (const char* column : {"At the line", "Over it", "Passes", "Worst, m", "m/s²", "m/s³", "Lost, s",
                               "Near behind", "Hit behind"})
      page.element("th", column, {{"scope", "col"}, {"class", "n"}});
  }
  const auto body = page.scope("tbody");
  for (const DriveRun& run : result.driving->runs)
    if (run.profile == profile.name) write_row(page, result, run);
}

void write_setting(Markup& page, const DriveResult& driving) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : driving.setting)
    keys.push_back(fmt::format("{} = {}", key, compact(value, 3)));
  page.element(
      "p",
      fmt::format("A straight lane; even braking with v² / (2 d), {} m/s² at most; cars behind of the "
                  "simulator's own kind, which never change what the car does. Not modelled: slopes, wet "
                  "roads, steering, crossing traffic, a perception that depends on speed. {}. Every road: "
                  "{}.",
                  compact(driving.most_deceleration, 2), join(keys, ", "), driving.command),
      {{"class", "because"}});
}

}  // namespace

void write_driving(Markup& page, const RunResult& result) {
  if (!result.driving) return;
  const DriveResult& driving = *result.driving;
  const auto part = section(
      page, "driving", "On the road",
      fmt::format(
          "The controllers in closed loop in a simulator of traffic: {} for each of them and each "
          "profile, {} at the line, {} km/h, seed {}. What is seen on a road is what that trace of the "
          "samples above sees.",
          plural(driving.roads, "road"), result.thing, compact(driving.speed_kmh, 1), driving.seed));
  {
    const auto list = page.scope("ul");
    for (const std::string& sentence : headline_of(driving)) page.element("li", sentence);
  }
  for (const DriveProfile& profile : driving.profiles) write_table(page, result, profile);
  page.element(
      "p",
      fmt::format("Worst: the farthest halt behind the line. m/s²: mean peak deceleration of those that "
                  "halt; m/s³: jerk. Near behind: a car comes within {} s of a collision.",
                  compact(driving.conflict_seconds, 2)),
      {{"class", "because"}});
  write_picture(page, metres_svg(driving), "The abstract outcome beside the metres that were driven");
  write_picture(page, braking_svg(driving), "How often each controller braked how hard");
  write_picture(page, speed_svg(driving), "Speed over distance, a road of each outcome");
  write_setting(page, driving);
}

}  // namespace heed::report
