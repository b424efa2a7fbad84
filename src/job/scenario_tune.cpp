#include "scenario_profile.h"

#include <heed/sim/rational.h>

#include <fmt/format.h>

namespace heed::job {
namespace {

sim::Rational probability(const TomlTable& table, const std::string& key, const util::SourceText& text) {
  sim::Rational value = sim::parse_rational(text);
  if (value < 0 || value > 1)
    table.fail(key, "probability-range", fmt::format("{} is no probability", sim::fraction(value)),
               "give a number from 0 to 1");
  return value;
}

}  // namespace

TunePart read_tune(TomlTable table) {
  TunePart part;
  if (table.has("false_braking"))
    part.most_needless = probability(table, "false_braking", table.scalar("false_braking"));
  if (table.has("noise")) {
    part.noise.clear();
    for (const util::SourceText& level : table.scalars("noise"))
      part.noise.push_back(probability(table, "noise", level));
    if (part.noise.empty())
      table.fail("noise", "missing-key", "'noise' names no level", "such as noise = [0, \"1/50\"]");
  }
  table.finish();
  return part;
}

}  // namespace heed::job
