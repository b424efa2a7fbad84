#include <heed/game/techniques.h>

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>
#include <variant>

namespace heed::game {
namespace {

struct Technique {
  std::string_view name;
  std::variant<bool Techniques::*, std::uint32_t Techniques::*> member;
};

const std::vector<Technique>& table() {
  static const std::vector<Technique> all = {
      {"structure-order", &Techniques::structure_order},
      {"functional-outputs", &Techniques::functional_outputs},
      {"state-invariants", &Techniques::state_invariants},
      {"partition-environment", &Techniques::partition_environment},
      {"unread-variables", &Techniques::unread_variables},
      {"greedy-schedule", &Techniques::greedy_schedule},
      {"frontier-sets", &Techniques::frontier_sets},
      {"work-reordering", &Techniques::work_reordering},
      {"cluster-nodes", &Techniques::cluster_nodes},
  };
  return all;
}

bool read_switch(std::string_view name, std::string_view value) {
  if (value != "on" && value != "off")
    throw std::invalid_argument(fmt::format("'{}' is 'on' or 'off', not '{}'", name, value));
  return value == "on";
}

std::uint32_t read_number(std::string_view name, std::string_view value) {
  constexpr std::uint32_t most = 1'000'000'000;
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  if (value.empty() || error != std::errc() || end != value.data() + value.size() || number > most)
    throw std::invalid_argument(fmt::format("'{}' is a number from 0 to {}, not '{}'", name, most, value));
  return number;
}

}  // namespace

std::vector<std::string> technique_names() {
  std::vector<std::string> names;
  for (const Technique& technique : table()) names.emplace_back(technique.name);
  return names;
}

void set_technique(Techniques& techniques, std::string_view name, std::string_view value) {
  for (const Technique& technique : table()) {
    if (technique.name != name) continue;
    if (const auto* flag = std::get_if<bool Techniques::*>(&technique.member))
      techniques.*(*flag) = read_switch(name, value);
    else
      techniques.*std::get<std::uint32_t Techniques::*>(technique.member) = read_number(name, value);
    return;
  }
  throw std::invalid_argument(fmt::format("no solver option is called '{}'", name));
}

}  // namespace heed::game
