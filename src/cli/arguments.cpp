#include "arguments.h"

#include <heed/util/diagnostic.h>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <charconv>

namespace heed::cli {
namespace {

/// A size such as "512M", "512MiB" or "4G" (powers of 1024), or a plain number of bytes.
std::uint64_t read_size(const std::string& option, const std::string& text) {
  std::uint64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  std::string unit(rest, end);
  if (unit.size() == 3 && unit.ends_with("iB")) unit.resize(1);
  const int shift = unit.empty() ? 0 : unit == "K" ? 10 : unit == "M" ? 20 : unit == "G" ? 30 : -1;
  if (error != std::errc{} || shift < 0 || (value << shift >> shift) != value)
    throw UsageError(fmt::format("{}: '{}' is no size", option, text),
                     "write bytes, or a number with K, M or G: 512M");
  return value << shift;
}

double read_seconds(const std::string& text) {
  double value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || rest != text.data() + text.size() || !(value > 0) || value > 1e9)
    throw UsageError(fmt::format("--timeout: '{}' is no number of seconds", text), "such as --timeout 30");
  return value;
}

std::vector<std::string> option_names(const Command& command) {
  std::vector<std::string> names{"--help"};
  for (const Option& option : command.options) names.emplace_back(option.name);
  for (const Option& option : common_options()) names.emplace_back(option.name);
  return names;
}

void check_operands(const Command& command, const std::vector<std::string>& operands) {
  std::size_t least = 0;
  bool many = false;
  for (const Operand& operand : command.operands) {
    if (operand.required && operands.size() <= least)
      throw UsageError(fmt::format("{} needs {}: {}", command.name, operand.name, operand.help),
                       fmt::format("such as: {}", command.example));
    if (operand.required) ++least;
    many = many || operand.many;
  }
  if (!many && operands.size() > command.operands.size())
    throw UsageError(
        fmt::format("{}: '{}' is one operand too many", command.name, operands[command.operands.size()]),
        fmt::format("see heed {} --help", command.name));
}

}  // namespace

std::string Arguments::text(const std::string& option, const std::string& otherwise) const {
  const auto found = options_.find(option);
  return found == options_.end() || found->second.empty() ? otherwise : found->second.back();
}

std::vector<std::string> Arguments::texts(const std::string& option) const {
  const auto found = options_.find(option);
  return found == options_.end() ? std::vector<std::string>{} : found->second;
}

std::optional<std::uint64_t> Arguments::number(const std::string& option, std::uint64_t low,
                                               std::uint64_t high) const {
  if (!has(option)) return std::nullopt;
  const std::string text = this->text(option);
  std::uint64_t value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || rest != text.data() + text.size() || value < low || value > high)
    throw UsageError(fmt::format("{}: '{}' is no whole number in {} ... {}", option, text, low, high), "");
  return value;
}

util::Limits Arguments::limits() const {
  util::Limits limits;
  if (has("--timeout")) limits.seconds = read_seconds(text("--timeout"));
  if (has("--memory")) limits.memory_bytes = read_size("--memory", text("--memory"));
  if (has("--max-input")) limits.input_bytes = read_size("--max-input", text("--max-input"));
  return limits;
}

Arguments parse_arguments(const Command& command, const std::vector<std::string>& words) {
  CLI::App app;
  app.set_help_flag();
  app.allow_extras();
  std::map<std::string, std::vector<std::string>> values;
  std::map<std::string, bool> switches;
  std::vector<std::string> operands;
  for (const auto* options : {&command.options, &common_options()})
    for (const Option& option : *options) {
      const std::string name(option.name);
      const std::string spelled = name == "--output" ? "-o,--output" : name;
      if (option.value.empty())
        app.add_flag(spelled, switches[name]);
      else if (option.value.starts_with('['))  // "[=N]": left out, it is what the table says
        app.add_flag(fmt::format("{}{{{}}}", spelled, option.otherwise), values[name]);
      else
        app.add_option(spelled, values[name])->expected(1)->take_all()->allow_extra_args(false);
    }
  app.add_option("operands", operands);
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::ParseError& error) {
    throw UsageError(fmt::format("{}: {}", command.name, error.what()),
                     fmt::format("see heed {} --help", command.name));
  }
  if (const auto extras = app.remaining(); !extras.empty()) {
    const std::string word = extras.front().substr(0, extras.front().find('='));
    throw UsageError(fmt::format("{}: unknown option '{}'", command.name, word),
                     util::suggestion(word, option_names(command), 20));
  }
  std::map<std::string, std::vector<std::string>> given;
  for (auto& [name, list] : values)
    if (!list.empty()) given[name] = std::move(list);
  for (const auto& [name, on] : switches)
    if (on) given[name] = {};
  check_operands(command, operands);
  return {std::move(operands), std::move(given)};
}

}  // namespace heed::cli
