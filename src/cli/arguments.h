#pragma once

#include "table.h"

#include <heed/sim/team.h>
#include <heed/util/limits.h>

#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace heed::cli {

/// Wrong usage: exit code 2.
class UsageError : public std::runtime_error {
 public:
  UsageError(const std::string& message, std::string hint)
      : std::runtime_error(message), hint_(std::move(hint)) {}
  [[nodiscard]] const std::string& hint() const { return hint_; }

 private:
  std::string hint_;
};

/// What the user gave for one command.
class Arguments {
 public:
  Arguments(std::vector<std::string> operands, std::map<std::string, std::vector<std::string>> options)
      : operands_(std::move(operands)), options_(std::move(options)) {}

  [[nodiscard]] const std::vector<std::string>& operands() const { return operands_; }
  [[nodiscard]] bool has(const std::string& option) const { return options_.contains(option); }
  [[nodiscard]] std::string text(const std::string& option, const std::string& otherwise = {}) const;
  [[nodiscard]] std::vector<std::string> texts(const std::string& option) const;
  /// \throws UsageError  not a number of the range
  [[nodiscard]] std::optional<std::uint64_t> number(const std::string& option, std::uint64_t low,
                                                    std::uint64_t high) const;
  [[nodiscard]] bool json() const { return has("--json"); }
  [[nodiscard]] util::Limits limits() const;
  /// The processes that share this command's work; nullptr where there is but this one.
  [[nodiscard]] sim::Team* team() const { return team_; }
  void set_team(sim::Team* team) { team_ = team; }
  /// Whether this is the process that writes.
  [[nodiscard]] bool writes() const { return team_ == nullptr || team_->rank() == 0; }

 private:
  std::vector<std::string> operands_;
  std::map<std::string, std::vector<std::string>> options_;
  sim::Team* team_ = nullptr;
};

/// Parses the words after the command's name. \throws UsageError
[[nodiscard]] Arguments parse_arguments(const Command& command, const std::vector<std::string>& words);

}  // namespace heed::cli
