#pragma once

#include <heed/spec/gr1.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace heed::spec {

/// What a name of a specification stands for.
struct Symbol {
  enum class Kind : std::uint8_t { Input, Output, Memory, Definition };
  Kind kind = Kind::Input;
  std::uint32_t index = 0;  ///< In the list of its kind.
  model::Domain domain{};   ///< A definition is Boolean.
};

/// The names of a specification. Duplicates keep the first; validate() refuses them.
class Symbols {
 public:
  explicit Symbols(const Gr1& spec);
  [[nodiscard]] const Symbol* find(const std::string& name) const;
  [[nodiscard]] const std::vector<std::string>& names() const {
    return names_;
  }  ///< In the order of declaration.

 private:
  std::map<std::string, Symbol> table_;
  std::vector<std::string> names_;
};

/// The enumeration value that \p operand (0 or 1) of a comparison is, if it is one: the other operand is an
/// enumerated variable (primed or not) one of whose values has that name. A value hides a variable of the
/// same name there; where both operands could be values, the right one is.
[[nodiscard]] std::optional<std::int32_t> enumeration_value(const logic::Formula& comparison,
                                                            std::size_t operand, const Symbols& symbols);

/// Puts the definitions into an order in which each uses only earlier ones; the given order is kept where it
/// can be. \throws util::InputError  a cycle, with its names ("a -> b -> a").
void sort_definitions(Gr1& spec);

}  // namespace heed::spec
