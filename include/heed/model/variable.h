#pragma once

#include <heed/util/source.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace heed::model {

/// The finite domain of a variable. Values are coded as `low ... high`: Boolean 0/1, an enumeration 0 ...
/// n-1.
struct Domain {
  enum class Kind : std::uint8_t { Boolean, Integer, Enumeration };
  Kind kind = Kind::Boolean;
  std::int32_t low = 0;
  std::int32_t high = 1;
  std::vector<std::string> values;  ///< Names of an enumeration's values, index = code.
  /// From these names to their codes, as enumeration() made it; nothing refers to it but read().
  std::shared_ptr<const std::unordered_map<std::string, std::int32_t>> codes{};

  static Domain boolean() { return {}; }
  static Domain integer(std::int32_t low, std::int32_t high) { return {Kind::Integer, low, high, {}, {}}; }
  static Domain enumeration(std::vector<std::string> names);

  [[nodiscard]] std::int64_t size() const { return std::int64_t{high} - low + 1; }
  /// "true", "-3", "red": as it stands in files. \pre low <= code <= high
  [[nodiscard]] std::string print(std::int32_t code) const;
  /// The code of a printed value; nothing when it is none of the domain's. O(1) where enumeration() made it.
  [[nodiscard]] std::optional<std::int32_t> read(const std::string& text) const;
  friend bool operator==(const Domain& a, const Domain& b) {
    return a.kind == b.kind && a.low == b.low && a.high == b.high && a.values == b.values;
  }
};

struct Variable {
  std::string name;
  Domain domain;
  std::string comment;  ///< What it means, for people; may be empty.
  util::Location location{};
};

/// One value per variable of a list, in its order.
using Valuation = std::vector<std::int32_t>;

}  // namespace heed::model
