#include <heed/report/drive.h>

#include <fmt/format.h>

#include <algorithm>

#include "format.h"
#include "text_table.h"

namespace heed::report {
namespace {

using Align = TextTable::Align;

const DriveRun* run_of(const DriveResult& result, const DriveProfile& profile,
                       const DriveController& controller) {
  for (const DriveRun& run : result.runs)
    if (run.profile == profile.name && run.controller == controller.name) return &run;
  return nullptr;
}

std::string range(const DriveSpread& spread, int decimals) {
  if (spread.count == 0) return "-";
  const std::string low = fixed(spread.least + 0.0, decimals), high = fixed(spread.most, decimals);
  return low == high ? low : low + "–" + high;
}

std::string count(std::uint64_t number, std::uint64_t of) {
  return of == 0 ? "-" : percent(static_cast<double>(number) / static_cast<double>(of));
}

std::string some(const DriveSpread& spread, double value, int decimals) {
  return spread.count == 0 ? "-" : fixed(value, decimals);
}

std::string profile_table(const DriveResult& result, const DriveProfile& profile, std::size_t width) {
  TextTable table({{"controller", Align::Left, 22},
                   {"at line", Align::Right},
                   {"over", Align::Right},
                   {"passes", Align::Right},
                   {"worst", Align::Right},
                   {"m/s²", Align::Right},
                   {"most", Align::Right},
                   {"m/s³", Align::Right},
                   {"s lost", Align::Right},
                   {"near", Align::Right},
                   {"hits", Align::Right}});
  for (const DriveController& controller : result.controllers) {
    const DriveRun* run = run_of(result, profile, controller);
    if (run == nullptr) continue;
    const DriveSummary sum = summarise(*run, result.outcomes.size());
    table.add({controller.title, count(sum.at_line, sum.roads), count(sum.over_line, sum.roads),
               count(sum.passed, sum.roads), some(sum.overshoot, sum.overshoot.most, 1),
               some(sum.deceleration, sum.deceleration.mean, 2),
               some(sum.deceleration, sum.deceleration.most, 2), some(sum.jerk, sum.jerk.mean, 1),
               fixed(sum.time_lost.mean, 1), result.followers == 0 ? "-" : count(sum.conflicts, sum.roads),
               result.followers == 0 ? "-" : count(sum.collisions, sum.roads)});
  }
  return fmt::format("{}: {}\n{}\n", profile.name, profile.title, table.render(width));
}

/// What \p counted comes to over all runs of \p controller, in per cent.
std::string share_of(const DriveResult& result, const DriveController& controller,
                     std::uint64_t DriveSummary::*counted) {
  std::uint64_t number = 0, roads = 0;
  for (const DriveRun& run : result.runs) {
    if (run.controller != controller.name) continue;
    const DriveSummary sum = summarise(run, result.outcomes.size());
    number += sum.*counted;
    roads += sum.roads;
  }
  return count(number, roads);
}

/// "50.4 % (Base 7.4 %, Perception tree 33.4 %)".
std::string beside_the_others(const DriveResult& result, const DriveController& subject,
                              std::uint64_t DriveSummary::*counted) {
  std::vector<std::string> others;
  for (const DriveController& other : result.controllers)
    if (other.name != subject.name)
      others.push_back(clean(other.title) + ' ' + share_of(result, other, counted));
  const std::string own = share_of(result, subject, counted);
  return others.empty() ? own : fmt::format("{} ({})", own, join(others, ", "));
}

std::string metres_table(const DriveResult& result, std::size_t width) {
  TextTable table({{"outcome", Align::Left, 24},
                   {"cells left", Align::Right},
                   {"abstract m", Align::Right},
                   {"m/s²", Align::Right},
                   {"roads", Align::Right},
                   {"driven m/s²", Align::Right},
                   {"halts at m", Align::Right},
                   {"conflicts", Align::Right},
                   {"collisions", Align::Right}});
  for (const DriveOutcome& row : side_by_side(result)) {
    const bool braking = row.distance > 0;
    table.add({result.outcomes[row.outcome], row.cells_left ? std::to_string(*row.cells_left) : "never",
               braking ? compact(row.distance, 1) : "-", braking ? fixed(row.deceleration, 2) : "-",
               grouped(row.roads), range(row.peak, 2), range(row.halt, 2), count(row.conflicts, row.roads),
               count(row.collisions, row.roads)});
  }
  return "What the abstract outcome became in metres, over all controllers and profiles\n" +
         table.render(width);
}

}  // namespace

std::vector<std::string> headline_of(const DriveResult& result) {
  const DriveController* subject = nullptr;
  for (const DriveController& controller : result.controllers)
    if (!controller.beside || subject == nullptr) subject = &controller;
  if (subject == nullptr) return {};
  const auto told = [&](std::uint64_t DriveSummary::*counted) {
    return beside_the_others(result, *subject, counted);
  };
  std::vector<std::string> sentences{
      fmt::format("Of all roads {} halts at the line on {}", clean(subject->title),
                  told(&DriveSummary::at_line)),
      fmt::format("It drives past without a halt on {}", told(&DriveSummary::passed)),
      fmt::format("It brakes harder than {} m/s² on {}", compact(emergency_braking, 1),
                  told(&DriveSummary::emergencies))};
  if (result.followers > 0)
    sentences.push_back(fmt::format("A car behind comes within {} s of a collision on {}",
                                    compact(result.conflict_seconds, 2), told(&DriveSummary::conflicts)));
  return sentences;
}

std::string to_text(const DriveResult& result, std::size_t width) {
  std::string out = wrap(
      fmt::format("{}: {} for each controller and profile, {} km/h, cells of {} m, {} at the line, seed {}",
                  clean(result.scenario), plural(result.roads, "road"), compact(result.speed_kmh, 1),
                  compact(result.cell_metres, 1), clean(result.thing), result.seed),
      width);
  for (const std::string& sentence : headline_of(result)) out += wrap(sentence, width, "  - ");
  out += '\n';
  for (const DriveProfile& profile : result.profiles) out += profile_table(result, profile, width);
  out += metres_table(result, width);
  out += wrap(
      fmt::format(
          "halts at m: behind the line. at line, over, passes: roads on which the car halts at the line (to "
          "{} m), behind it, or not at "
          "all; worst: the farthest halt behind it, in metres. m/s²: peak deceleration of those that halt, "
          "mean and most; m/s³: jerk, mean of the peaks. s lost: against driving past freely, mean of all. "
          "near: a car behind comes within {} s of a collision, or collides; hits: it does.",
          compact(at_the_line, 2), compact(result.conflict_seconds, 2)),
      width, "  ");
  return out;
}

}  // namespace heed::report
