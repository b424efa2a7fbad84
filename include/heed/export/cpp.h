#pragma once

#include <heed/model/mealy.h>

#include <string>

namespace heed::exporter {

struct CppOptions {
  /// Where everything goes, such as "car" or "acme::car"; empty: the controller's name and "_controller".
  std::string name_space;
};

/// The controller as one C++17 header that needs nothing but <cstdint>: an enumeration per enumerated column
/// with `name(value)`, `struct Observation`, `struct Reaction` (all columns) and `class Controller` with
/// `reset()`, `step(observation)` and `last_status()`. No heap, no exceptions, no run-time type information;
/// a step is two look-ups in constant tables. An observation without a row, or with a value outside its
/// domain, keeps the state, repeats the last reaction and sets `last_status()` to `Status::Undefined`.
/// Names become valid identifiers, all different; `name(value)` gives the original text. O(size of the
/// tables). \throws InputError  the wanted namespace is no sequence of identifiers
[[nodiscard]] std::string to_cpp(const model::Mealy& machine, const CppOptions& options = {});

}  // namespace heed::exporter
