#pragma once

#include <set>
#include <string>
#include <string_view>

namespace heed::awareness {

/// A name for formulas: `StopSign` becomes `stop_sign`, `giveWay` (which starts small) stays, what is no
/// letter, digit or underscore becomes an underscore.
[[nodiscard]] std::string atom_of(std::string_view local_name);

/// `hasMainColour` becomes `main_colour`.
[[nodiscard]] std::string role_atom_of(std::string_view local_name);

/// Hands out distinct names: the second `red` is `red_2`.
class AtomTable {
 public:
  [[nodiscard]] std::string claim(const std::string& wanted);

 private:
  std::set<std::string> used_;
};

}  // namespace heed::awareness
