// A readable condition for a set of observations. First a disjoint cover: for one input after the other, join
// what differs in that input alone. Then, while that is cheap, widen each cube as long as it holds nothing
// but the wanted observations (which can be counted, since they are all different), and drop what the others
// cover. Exact minimisation would be shorter now and then; nobody reads a label that long.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>

#include "cubes.h"

namespace heed::exporter {
namespace {

using Letters = std::vector<const model::Valuation*>;

constexpr std::uint64_t widening_effort = 2'000'000;

/// Joins the cubes that agree in all inputs but \p input.
std::vector<Cube> join(const std::vector<Cube>& cubes, std::size_t input) {
  std::map<Cube, std::vector<std::int32_t>> joined;
  for (const Cube& cube : cubes) {
    Cube rest = cube;
    rest[input].clear();
    auto& values = joined[std::move(rest)];
    values.insert(values.end(), cube[input].begin(), cube[input].end());
  }
  std::vector<Cube> result;
  for (auto& [rest, values] : joined) {
    result.push_back(rest);
    std::sort(values.begin(), values.end());
    result.back()[input] = std::move(values);
  }
  return result;
}

bool contains(const Cube& cube, const model::Valuation& letter) {
  for (std::size_t i = 0; i < cube.size(); ++i)
    if (!std::binary_search(cube[i].begin(), cube[i].end(), letter[i])) return false;
  return true;
}

/// Whether every observation in the cube is one of the letters.
bool within(const Cube& cube, const Letters& letters) {
  std::uint64_t volume = 1;
  for (const auto& values : cube) {
    volume *= values.size();
    if (volume > letters.size()) return false;
  }
  const auto inside = std::count_if(letters.begin(), letters.end(),
                                    [&](const auto* letter) { return contains(cube, *letter); });
  return static_cast<std::uint64_t>(inside) == volume;
}

std::vector<std::int32_t> all_values(const model::Domain& domain) {
  std::vector<std::int32_t> values(static_cast<std::size_t>(domain.size()));
  std::iota(values.begin(), values.end(), domain.low);
  return values;
}

void widen(std::vector<Cube>& cubes, const std::vector<model::Variable>& inputs, const Letters& letters) {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (static_cast<std::uint64_t>(inputs[i].domain.size()) > letters.size()) continue;
    const std::vector<std::int32_t> all = all_values(inputs[i].domain);
    for (Cube& cube : cubes) {
      if (cube[i].size() == all.size()) continue;
      Cube wider = cube;
      wider[i] = all;
      if (within(wider, letters)) cube = std::move(wider);
    }
  }
}

/// Drops cubes, the last ones first, whose letters all stand in others.
void drop_covered(std::vector<Cube>& cubes, const Letters& letters) {
  std::vector<std::uint32_t> times(letters.size(), 0);
  const auto count = [&](const Cube& cube, std::uint32_t change) {
    for (std::size_t i = 0; i < letters.size(); ++i)
      if (contains(cube, *letters[i])) times[i] += change;
  };
  const auto needed = [&](const Cube& cube) {
    for (std::size_t i = 0; i < letters.size(); ++i)
      if (times[i] == 1 && contains(cube, *letters[i])) return true;
    return false;
  };
  for (const Cube& cube : cubes) count(cube, 1);
  for (std::size_t k = cubes.size(); k-- > 0;)
    if (!needed(cubes[k])) {
      count(cubes[k], UINT32_MAX);  // one less, modulo 2^32
      cubes.erase(cubes.begin() + static_cast<std::ptrdiff_t>(k));
    }
}

std::string print_values(const model::Variable& input, const std::vector<std::int32_t>& values,
                         std::string (*quote)(std::string_view)) {
  const model::Domain& domain = input.domain;
  const std::string name = quote(input.name);
  if (domain.kind == model::Domain::Kind::Boolean) return (values.front() != 0 ? "" : "!") + name;
  const auto text = [&](std::int32_t value) { return quote(domain.print(value)); };
  if (values.size() == 1) return fmt::format("{} = {}", name, text(values.front()));
  if (static_cast<std::int64_t>(values.size()) + 1 == domain.size()) {
    std::int32_t missing = domain.low;
    for (const std::int32_t value : values) missing += value == missing ? 1 : 0;
    return fmt::format("{} != {}", name, text(missing));
  }
  const bool run =
      std::int64_t{values.back()} - values.front() + 1 == static_cast<std::int64_t>(values.size());
  if (run && domain.kind == model::Domain::Kind::Integer)
    return fmt::format("{} in {} ... {}", name, values.front(), values.back());
  std::string list;
  for (const std::int32_t value : values) list += (list.empty() ? "" : ", ") + text(value);
  return fmt::format("{} in {{{}}}", name, list);
}

}  // namespace

std::vector<Cube> cover(const std::vector<model::Variable>& inputs,
                        const std::vector<const model::Valuation*>& letters) {
  std::vector<Cube> cubes;
  for (const model::Valuation* letter : letters) {
    cubes.emplace_back();
    for (const std::int32_t value : *letter) cubes.back().push_back({value});
  }
  for (std::size_t before = SIZE_MAX; cubes.size() < before;) {
    before = cubes.size();
    for (std::size_t i = 0; i < inputs.size(); ++i) cubes = join(cubes, i);
  }
  if (cubes.size() * std::uint64_t{letters.size()} * inputs.size() <= widening_effort) {
    widen(cubes, inputs, letters);
    drop_covered(cubes, letters);
  }
  return cubes;
}

std::string print_cube(const std::vector<model::Variable>& inputs, const Cube& cube,
                       std::string (*quote)(std::string_view)) {
  std::string out;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (static_cast<std::int64_t>(cube[i].size()) == inputs[i].domain.size()) continue;
    if (!out.empty()) out += " & ";
    out += print_values(inputs[i], cube[i], quote);
  }
  return out.empty() ? "true" : out;
}

}  // namespace heed::exporter
