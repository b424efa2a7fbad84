#include "game_families.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <map>
#include <stdexcept>

namespace heed::bench {
namespace {

using Line = std::function<std::string(unsigned)>;

/// line(first) ... line(last - 1), one a line.
std::string lines(unsigned first, unsigned last, const Line& line) {
  std::string out;
  for (unsigned i = first; i < last; ++i) out += line(i) + "\n";
  return out;
}

std::string joined(unsigned first, unsigned last, const char* between, const Line& item) {
  std::string out;
  for (unsigned i = first; i < last; ++i) out += (i == first ? "" : between) + item(i);
  return out;
}

/// A line for each two of \p count things.
std::string pairs(unsigned count, const std::function<std::string(unsigned, unsigned)>& line) {
  return joined(0, count, "",
                [&](unsigned i) { return lines(i + 1, count, [&](unsigned k) { return line(i, k); }); });
}

/// Prints fmt with the index at every place.
Line with_index(const char* format) {
  return [format](unsigned i) {
    return fmt::format(fmt::runtime(format), fmt::arg("i", i), fmt::arg("n", i + 1));
  };
}

}  // namespace

std::string arbiter_text(unsigned count) {
  const auto each = [&](const char* format) { return lines(1, count + 1, with_index(format)); };
  return "[INPUT]\n" + each("r{i}") + "\n[OUTPUT]\n" + each("g{i}") + "\n[ENV_INIT]\n" + each("! r{i}") +
         "\n[SYS_INIT]\n" + each("! g{i}") + "\n[ENV_TRANS]\n" + each("(r{i} <-> g{i}) | (r{i}' <-> r{i})") +
         "\n[ENV_LIVENESS]\n" + each("! r{i} | ! g{i}") + "\n[SYS_TRANS]\n" +
         pairs(count, [](unsigned i, unsigned k) { return fmt::format("! g{}' | ! g{}'", i + 1, k + 1); }) +
         each("(r{i} <-> g{i}) -> (g{i}' <-> g{i})") + "\n[SYS_LIVENESS]\n" + each("r{i} <-> g{i}");
}

std::string lift_text(unsigned floors) {
  const auto each = [&](const char* format) { return lines(1, floors + 1, with_index(format)); };
  const std::string pressed = joined(1, floors + 1, " | ", with_index("b{i}"));
  const std::string up = joined(1, floors, " | ", with_index("f{i} & f{n}'"));
  const auto near = [&](unsigned i) {
    const unsigned low = std::max(i, 2U) - 1, high = std::min(i + 1, floors);
    return fmt::format("f{} -> {}", i, joined(low, high + 1, " | ", with_index("f{i}'")));
  };
  return "[INPUT]\n" + each("b{i}") + "\n[OUTPUT]\n" + each("f{i}") + "\n[ENV_INIT]\n" + each("! b{i}") +
         "\n[SYS_INIT]\nf1\n" + lines(2, floors + 1, with_index("! f{i}")) + "\n[ENV_TRANS]\n" +
         each("b{i} & f{i} -> ! b{i}'") + each("b{i} & ! f{i} -> b{i}'") +
         fmt::format("\n[SYS_TRANS]\n({}) -> ({})\n", up, pressed) +
         pairs(floors, [](unsigned i, unsigned k) { return fmt::format("! f{} | ! f{}", i + 1, k + 1); }) +
         lines(1, floors + 1, near) + fmt::format("\n[SYS_LIVENESS]\nf1 | {}\n", pressed) +
         each("b{i} -> f{i}");
}

std::string moving_obstacle_text(const MovingObstacle& wanted) {
  const unsigned edge = wanted.size - 1, obstacle_edge = wanted.size - 2;
  std::string out = fmt::format(
      "[INPUT]\nobsx: 0...{1}\nobsy: 0...{1}\nrobx: 0...{0}\nroby: 0...{0}\nglitches: 0...{2}\n\n"
      "[OUTPUT]\nmovx: 0...2\nmovy: 0...2\nobsmove\n\n"
      "[ENV_INIT]\nrobx = 0\nroby = 0\nobsx = {1}\nobsy = {1}\nglitches = 0\n\n[ENV_TRANS]\n",
      edge, obstacle_edge, wanted.glitches);
  for (const char* who : {"obsx", "obsy", "robx", "roby"})
    out += fmt::format("{0}' <= {0} + 1\n{0} <= {0}' + 1\n", who);
  // mov = 0, 1, 2: back, stay, on; at the edge what leads out of the field stays.
  for (const char* axis : {"x", "y"})
    out += fmt::format(
        "rob{0} = 0 & rob{0}' = 0 & mov{0} <= 1 | rob{0}' + 1 <= rob{0} + mov{0}\n"
        "rob{0} = {1} & rob{0}' = {1} & mov{0} >= 1 | rob{0}' + 1 >= rob{0} + mov{0}\n",
        axis, edge);
  return out +
         "glitches' >= glitches\n"
         "(obsmove | obsx = obsx') & (obsmove | obsy = obsy') | glitches' >= glitches + 1\n\n"
         "[SYS_INIT]\n! obsmove\n\n[SYS_TRANS]\n"
         "robx < obsx | robx >= obsx + 2 | roby < obsy | roby >= obsy + 2\n"
         "obsmove' -> obsx = obsx' & obsy = obsy'\n"
         "! obsmove' -> ! (obsx = obsx' & obsy = obsy')\n";
}

namespace {

/// The conditions that a bound of 1 or 0 makes constant.
struct FactoryWords {
  std::string moves, error;

  explicit FactoryWords(const Factory& wanted)
      : moves(wanted.period > 1 ? "movingcounter' = 0" : "TRUE"),
        error(wanted.errors > 0 ? " | errorCount' > errorCount" : "") {}
};

std::string factory_steps(const Factory& wanted) {
  const FactoryWords words(wanted);
  std::string out = fmt::format("({}) -> ({}{})\n", words.moves,
                                joined(0, wanted.tasks, " | ", with_index("p0_{i}'")), words.error);
  if (wanted.errors > 0) out += "errorCount' >= errorCount\n";
  for (unsigned place = 0; place < wanted.places; ++place) {
    for (unsigned task = 0; task < wanted.tasks; ++task) {
      const std::string done =
          fmt::format("p{0}_{1} & ! ({2}) | arm1 = {0} & arm1op = {1} | arm2 = {0} & arm2op = {1}", place,
                      task, words.moves);
      out += place == 0 ? fmt::format("! ({2}) -> (p{0}_{1}' <-> ({3}))\n", place, task, words.moves, done)
                        : fmt::format("p{0}_{1}' <-> ({3} | p{4}_{1} & ({2}))\n", place, task, words.moves,
                                      done, place - 1);
    }
  }
  if (wanted.period > 1)
    out += fmt::format(
        "movingcounter < {0} -> movingcounter' = movingcounter + 1\nmovingcounter = {0} -> movingcounter' = "
        "0\n",
        wanted.period - 1);
  return out;
}

}  // namespace

std::string factory_text(const Factory& wanted) {
  const FactoryWords words(wanted);
  std::string out = "[INPUT]\n";
  if (wanted.period > 1) out += fmt::format("movingcounter: 0...{}\n", wanted.period - 1);
  const auto tasks = [&](unsigned place) {
    return joined(0, wanted.tasks, "\n", [&](unsigned task) { return fmt::format("p{}_{}", place, task); });
  };
  const std::string all = lines(0, wanted.places, tasks);
  out += all;
  if (wanted.errors > 0) out += fmt::format("errorCount: 0...{}\n", wanted.errors);
  out += fmt::format(
      "\n[OUTPUT]\narm1: 0...{0}\narm2: 0...{0}\narm1op: 0...{1}\narm2op: 0...{1}\n\n[ENV_INIT]\n",
      wanted.places - 1, wanted.tasks - 1);
  if (wanted.period > 1) out += "movingcounter = 0\n";
  out += all + "\n[ENV_TRANS]\n" + factory_steps(wanted);
  out += "\n[SYS_INIT]\narm1 = 0\narm2 = 2\narm1op = 0\narm2op = 0\n\n[SYS_TRANS]\narm1' < arm2'\n";
  for (const char* arm : {"arm1", "arm2"}) out += fmt::format("{0}' <= {0} + 1\n{0} <= {0}' + 1\n", arm);
  return out + lines(0, wanted.tasks, [&](unsigned task) {
           return fmt::format("p{}_{} | ! ({})", wanted.places - 1, task, words.moves);
         });
}

std::string cinderella_text(const Cinderella& wanted) {
  const auto each = [&](const std::string& format) {
    return lines(0, wanted.buckets, with_index(format.c_str()));
  };
  std::string out = "[INPUT]\n" + each(fmt::format("x{{i}}: 0...{}", wanted.amount)) + "\n[OUTPUT]\n" +
                    each(fmt::format("y{{i}}: 0...{}", wanted.capacity)) +
                    fmt::format("e: 0...{}\n", wanted.buckets - 1) + "\n[ENV_INIT]\n" + each("x{i} = 0") +
                    fmt::format("\n[ENV_TRANS]\n{} <= {}\n",
                                joined(0, wanted.buckets, " + ", with_index("x{i}'")), wanted.amount) +
                    "\n[SYS_INIT]\n" + each("y{i} = 0") + "\n[SYS_TRANS]\n";
  for (unsigned i = 0; i < wanted.buckets; ++i) {
    // Emptied at the step before: the reach neighbours from e on, around the circle.
    const std::string emptied =
        fmt::format("e <= {0} & {0} < e + {1} | {2} < e + {1}", i, wanted.reach, i + wanted.buckets);
    out += fmt::format("! ({1}) -> y{0}' = y{0} + x{0}'\n({1}) -> y{0}' = x{0}'\n", i, emptied);
  }
  return out;
}

namespace {

unsigned number(const std::string& word, unsigned low) {
  unsigned value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || value < low || value > 10'000)
    throw std::invalid_argument(fmt::format("'{}' is no number from {} to 10000", word, low));
  return value;
}

struct Family {
  std::vector<unsigned> low;  ///< Least value of each parameter.
  std::function<std::string(const std::vector<unsigned>&)> text;
};

const std::map<std::string, Family>& families() {
  using Values = std::vector<unsigned>;
  static const std::map<std::string, Family> all = {
      {"arbiter", {{2}, [](const Values& v) { return arbiter_text(v[0]); }}},
      {"lift", {{2}, [](const Values& v) { return lift_text(v[0]); }}},
      {"moving_obstacle",
       {{3, 0},
        [](const Values& v) {
          return moving_obstacle_text({v[0], v[1]});
        }}},
      {"factory",
       {{3, 1, 1, 0},
        [](const Values& v) {
          return factory_text({v[0], v[1], v[2], v[3]});
        }}},
      {"cinderella",
       {{2, 1, 1, 1},
        [](const Values& v) {
          return cinderella_text({v[0], v[1], v[2], v[3]});
        }}},
  };
  return all;
}

}  // namespace

std::string game_text(const std::vector<std::string>& words) {
  const auto family = words.empty() ? families().end() : families().find(words.front());
  if (family == families().end() || words.size() != family->second.low.size() + 1)
    throw std::invalid_argument(
        "known: arbiter LINES, lift FLOORS, moving_obstacle SIZE GLITCHES, factory PLACES TASKS PERIOD "
        "ERRORS, "
        "cinderella BUCKETS REACH CAPACITY AMOUNT");
  std::vector<unsigned> values;
  for (std::size_t i = 1; i < words.size(); ++i)
    values.push_back(number(words[i], family->second.low[i - 1]));
  return family->second.text(values);
}

}  // namespace heed::bench
