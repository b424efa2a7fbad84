#include <heed/util/diagnostic.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>

#include "observation.h"

namespace heed::exporter {
namespace {

using Json = nlohmann::json;

constexpr std::string_view shape_hint = "one JSON object a line, such as {\"red\": true}";

/// At most 60 bytes of \p text, which is valid UTF-8, cut between characters.
std::string shortened(std::string_view text) {
  constexpr std::size_t most = 60;
  if (text.size() <= most) return std::string(text);
  std::size_t end = most;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return std::string(text.substr(0, end)) + "...";
}

std::string values_of(const model::Domain& domain) {
  switch (domain.kind) {
    case model::Domain::Kind::Boolean:
      return "true or false";
    case model::Domain::Kind::Integer:
      return fmt::format("an integer in {} ... {}", domain.low, domain.high);
    case model::Domain::Kind::Enumeration:
      return "one of its names as a string";
  }
  return {};
}

}  // namespace

/// The parser's events. Every one returns whether to go on; the first fault ends the line.
class ObservationEvents {
 public:
  explicit ObservationEvents(const ObservationReader& reader)
      : reader_(reader), given_(reader.inputs_.size(), false) {
    reading_.observation = reader.blank_;
  }

  bool null() { return found("null"); }
  bool boolean(bool value) {
    if (at_reset_) return value || fault("'reset' takes nothing but true", "leave the line out");
    if (domain(model::Domain::Kind::Boolean)) return set(value ? 1 : 0);
    return found(value ? "true" : "false");
  }
  bool number_integer(std::int64_t value) {
    const model::Domain* type = domain(model::Domain::Kind::Integer);
    if (type == nullptr || value < type->low || value > type->high) return found(std::to_string(value));
    return set(static_cast<std::int32_t>(value));
  }
  bool number_unsigned(std::uint64_t value) {
    if (value > INT64_MAX) return found(std::to_string(value));
    return number_integer(static_cast<std::int64_t>(value));
  }
  bool number_float(double, const std::string& text) { return found(shortened(text)); }
  bool string(const std::string& text) {
    const model::Domain* type = domain(model::Domain::Kind::Enumeration);
    if (type == nullptr) return found(fmt::format("\"{}\"", shortened(text)));
    const std::optional<std::int32_t> code = type->read(text);
    if (code) return set(*code);
    return fault(fmt::format("input '{}' has no value '{}'", input().name, shortened(text)),
                 util::suggestion(text, type->values));
  }
  bool binary(Json::binary_t&) { return found("binary"); }
  bool start_object(std::size_t) { return ++depth_ == 1 || found("an object"); }
  bool end_object() { return true; }
  bool start_array(std::size_t) { return found("an array"); }
  bool end_array() { return true; }

  bool key(const std::string& name) {
    const auto known = reader_.index_.find(name);
    at_reset_ = name == "$reset" || (name == "reset" && known == reader_.index_.end());
    if (at_reset_) {
      if (reset_) return fault(fmt::format("'{}' is given twice", name), "give it once");
      return reset_ = true;
    }
    if (known == reader_.index_.end())
      return fault(fmt::format("unknown input '{}'", shortened(name)),
                   util::suggestion(name, reader_.names_));
    at_ = known->second;
    if (given_[at_])
      return fault(fmt::format("input '{}' is given twice", input().name), "give each input once");
    return given_[at_] = true;
  }

  bool parse_error(std::size_t byte, const std::string&, const Json::exception& cause) {
    const std::string_view what = cause.what();
    const bool number = what.find("number overflow") != std::string_view::npos;
    const bool bytes = what.find("UTF-8") != std::string_view::npos;
    return fault(fmt::format("not JSON: {} at byte {}",
                             number  ? "a number too large"
                             : bytes ? "invalid UTF-8"
                                     : "unexpected text",
                             byte),
                 std::string(shape_hint));
  }

  /// \param complete  The parser reached the end of the line.
  LineReading finish(bool complete) {
    const bool any = std::find(given_.begin(), given_.end(), true) != given_.end();
    if (complete && reset_ && any)
      fault("'reset' stands beside other keys", "send the reset in a line of its own");
    else if (complete)
      reading_.kind = reset_ ? LineReading::Kind::Reset : LineReading::Kind::Observation;
    return std::move(reading_);
  }

 private:
  [[nodiscard]] const model::Variable& input() const { return reader_.inputs_[at_]; }

  /// The domain of the input whose value comes now, if it is of this kind.
  [[nodiscard]] const model::Domain* domain(model::Domain::Kind kind) const {
    if (depth_ != 1 || at_reset_ || input().domain.kind != kind) return nullptr;
    return &input().domain;
  }
  bool set(std::int32_t value) {
    reading_.observation[at_] = value;
    return true;
  }
  bool fault(std::string error, std::string hint) {
    reading_ = {LineReading::Kind::Error, {}, std::move(error), std::move(hint)};
    return false;
  }
  /// Something that cannot stand here.
  bool found(std::string_view what) {
    if (depth_ == 0) return fault(fmt::format("expected an object, found {}", what), std::string(shape_hint));
    if (at_reset_) return fault("'reset' takes nothing but true", "leave the line out");
    return fault(fmt::format("input '{}' cannot be {}", input().name, what),
                 fmt::format("it takes {}", values_of(input().domain)));
  }

  const ObservationReader& reader_;
  LineReading reading_;
  std::vector<bool> given_;
  std::size_t depth_ = 0;  ///< Objects opened; the second is a fault.
  std::size_t at_ = 0;
  bool at_reset_ = false;
  bool reset_ = false;
};

ObservationReader::ObservationReader(const std::vector<model::Variable>& inputs) : inputs_(inputs) {
  for (const model::Variable& input : inputs_) {
    if (!index_.emplace(input.name, names_.size()).second)
      throw util::InputError(input.location, "duplicate-input",
                             fmt::format("two inputs are called '{}'", input.name),
                             "a line could not say which it means");
    if (input.name == "$reset")
      throw util::InputError(input.location, "reserved-name", "an input is called '$reset'",
                             "rename it; a line with that key resets the machine");
    names_.push_back(input.name);
    blank_.push_back(input.domain.low);
  }
}

LineReading ObservationReader::read(std::string_view json) const {
  const auto error = [](std::string what) {
    return LineReading{LineReading::Kind::Error, {}, std::move(what), std::string(shape_hint)};
  };
  if (json.find_first_not_of(" \t\r\n") == std::string_view::npos) return error("the line is empty");
  // The JSON library takes a NUL for the end of its input and would ignore what follows.
  if (const std::size_t nul = json.find('\0'); nul != std::string_view::npos)
    return error(fmt::format("not JSON: a NUL byte at byte {}", nul + 1));
  ObservationEvents events(*this);
  const bool complete = Json::sax_parse(json.begin(), json.end(), &events);
  return events.finish(complete);
}

}  // namespace heed::exporter
