#pragma once

#include <string>
#include <vector>

namespace heed::bench {

/// Games of any size, as specifications in slugs' structured format (docs/formats/structuredslugs.md).

/// \p lines request lines, each served by its grant; never two grants at once, and every request is answered
/// where no line asks for ever while it is served. Realizable. \pre lines > 1
[[nodiscard]] std::string arbiter_text(unsigned lines);

/// A lift between \p floors floors with a button each: it comes wherever a button is pressed, goes up only
/// while one is, and returns to the first floor. Realizable. \pre floors > 1
[[nodiscard]] std::string lift_text(unsigned floors);

/// A robot evades an obstacle of two by two cells in a field of \p size by \p size cells. Both move by at
/// most one cell along each axis; the obstacle may move two steps in a row \p glitches times. Unrealizable
/// from some number of glitches on, about 0.45 for each cell of the edge. \pre size > 2
struct MovingObstacle {
  unsigned size = 8;
  unsigned glitches = 0;
};
[[nodiscard]] std::string moving_obstacle_text(const MovingObstacle& wanted);

/// An assembly line of \p places places, on each of which \p tasks tasks can be done by one of two arms,
/// which must not pass each other. Parts move on every \p period steps, with all their tasks done at the end;
/// one with nothing left to do may come in \p errors times.
struct Factory {
  unsigned places = 3;
  unsigned tasks = 3;
  unsigned period = 1;
  unsigned errors = 0;
};
[[nodiscard]] std::string factory_text(const Factory& wanted);

/// \p buckets buckets in a circle, which hold \p capacity. The stepmother pours \p amount into them, in any
/// parts; then Cinderella empties \p reach neighbours. None may ever overflow.
struct Cinderella {
  unsigned buckets = 4;
  unsigned reach = 1;
  unsigned capacity = 4;
  unsigned amount = 2;
};
[[nodiscard]] std::string cinderella_text(const Cinderella& wanted);

/// The specification that a name such as "arbiter 30", "moving_obstacle 48 19", "factory 5 5 2 1" or
/// "cinderella 6 1 14 5" stands for, in words. \throws std::invalid_argument  with what is known
[[nodiscard]] std::string game_text(const std::vector<std::string>& words);

}  // namespace heed::bench
