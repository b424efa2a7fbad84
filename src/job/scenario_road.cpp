#include "scenario_profile.h"

#include <heed/sim/rational.h>

#include <fmt/format.h>

namespace heed::job {
namespace {

constexpr std::int64_t longest_road = 10'000;

std::vector<RoadShare> read_draw(TomlTable& table) {
  std::vector<RoadShare> shares;
  sim::Rational sum = 0;
  for (TomlTable& entry : table.tables("draw")) {
    RoadShare share{entry.word("thing"), sim::parse_rational(entry.scalar("probability"))};
    entry.finish();
    if (share.probability > 1)
      entry.fail("probability", "probability-range",
                 fmt::format("{} is no probability", sim::fraction(share.probability)),
                 "give a number from 0 to 1");
    sum += share.probability;
    shares.push_back(std::move(share));
  }
  if (sum != 1)
    table.fail("draw", "probability-sum",
               fmt::format("the things of the road add up to {}, not 1", sim::fraction(sum)),
               sum < 1 ? fmt::format("add the missing {}, for instance for \"none\"", sim::fraction(1 - sum))
                       : fmt::format("{} too much", sim::fraction(sum - 1)));
  return shares;
}

}  // namespace

RoadPart read_road(TomlTable& table) {
  RoadPart part;
  part.name = table.word("name");
  part.title = table.text("title", part.name.text);
  const bool draw = table.has("draw");
  if (draw == table.has("things"))
    table.fail(draw ? "things" : "name", draw ? "two-rules" : "missing-key",
               fmt::format("the road '{}' needs either 'things' or 'draw'", part.name.text),
               "things = [\"StopSign\", \"none\"] are passed in that order, draw = [...] by chance");
  if (draw)
    part.places.push_back(read_draw(table));
  else
    for (const Word& thing : table.words("things")) part.places.push_back({{thing, 1}});
  if (part.places.empty())
    table.fail("things", "empty-road", fmt::format("nothing is passed on the road '{}'", part.name.text),
               "name at least one thing, or \"none\"");
  const auto usual = draw ? std::int64_t{10} : static_cast<std::int64_t>(part.places.size());
  part.length = static_cast<std::uint32_t>(table.integer("length", usual, 1, longest_road));
  table.finish();
  return part;
}

}  // namespace heed::job
