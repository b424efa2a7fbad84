#pragma once

#include <heed/model/variable.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace heed::exporter {

/// What one line of JSON says (docs/formats/exec.md).
struct LineReading {
  enum class Kind : std::uint8_t { Observation, Reset, Error };
  Kind kind = Kind::Error;
  model::Valuation observation;
  std::string error, hint;
};

/// Reads observations: flat objects from input names to values. Never throws for bad input; an object inside
/// an object ends the reading, so that depth costs nothing.
class ObservationReader {
 public:
  /// \throws InputError  two inputs of one name, or one called "$reset"
  explicit ObservationReader(const std::vector<model::Variable>& inputs);
  [[nodiscard]] LineReading read(std::string_view json) const;

 private:
  friend class ObservationEvents;
  std::vector<model::Variable> inputs_;
  std::map<std::string, std::size_t, std::less<>> index_;
  std::vector<std::string> names_;
  model::Valuation blank_;  ///< What is not mentioned.
};

}  // namespace heed::exporter
