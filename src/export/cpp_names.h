#pragma once

#include <heed/model/mealy.h>

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace heed::exporter {

/// Identifiers of one scope: each valid in C++17 and C++20, none of them given out twice.
class Scope {
 public:
  explicit Scope(std::set<std::string> taken = {}) : taken_(std::move(taken)) {}
  /// As close to \p wish as is possible; \p otherwise where nothing is left of it.
  std::string take(std::string_view wish, std::string_view otherwise);

 private:
  std::set<std::string> taken_;
  std::map<std::string, std::size_t> numbers_;  ///< Used so far, per wish.
};

/// "perception tree" to "perception_tree": ASCII letters, digits and single underscores, no leading digit or
/// underscore, no keyword and no macro that a C++ program is likely to have; maybe empty.
[[nodiscard]] std::string identifier(std::string_view text);
/// "perception tree" to "PerceptionTree"; maybe empty.
[[nodiscard]] std::string type_identifier(std::string_view text);
/// Whether a name can be used in code as it stands.
[[nodiscard]] bool is_identifier(std::string_view text);

/// \p text as a string literal in ASCII.
[[nodiscard]] std::string cpp_literal(std::string_view text);
/// \p text for the rest of a line after "//": one line, nothing that a compiler or a reader could take for
/// something else (line splices, trigraphs, bidirectional controls, bytes that are no UTF-8).
[[nodiscard]] std::string cpp_comment(std::string_view text);

/// A column of the machine in the generated code.
struct CppColumn {
  model::Variable variable;
  std::string field;
  std::string type;                      ///< "bool", "std::int8_t", or the enumeration's name.
  std::vector<std::string> enumerators;  ///< Of an enumeration.
};

struct CppNames {
  std::string name_space;
  std::vector<CppColumn> inputs, outputs;
};

/// \param name_space  As wanted by the user; empty: from the machine's name. \throws InputError
[[nodiscard]] CppNames cpp_names(const model::Mealy& machine, const std::string& name_space);

/// The smallest integer type for \p low ... \p high.
[[nodiscard]] std::string_view smallest_type(std::int64_t low, std::int64_t high);

}  // namespace heed::exporter
