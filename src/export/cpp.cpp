#include <heed/export/cpp.h>

#include <fmt/format.h>

#include <algorithm>

#include "cpp_names.h"
#include "cpp_tables.h"

namespace heed::exporter {
namespace {

std::string list(std::string_view head, const std::vector<std::string>& texts) {
  if (texts.empty()) return {};
  std::string out = fmt::format("//\n// {}\n", head);
  for (const std::string& text : texts) out += fmt::format("//   {}\n", cpp_comment(text));
  return out;
}

/// One line of use with a name that the controller really has.
std::string example(const CppNames& names) {
  const std::string& ns = names.name_space;
  std::string out = fmt::format("//   {0}::Controller controller;\n//   {0}::Observation observation;\n", ns);
  if (!names.inputs.empty()) {
    const CppColumn& input = names.inputs.front();
    const std::string scope = input.enumerators.empty() ? "" : ns + "::";
    out += fmt::format("//   observation.{} = {}{};\n", input.field, scope,
                       cpp_value(input, input.variable.domain.high));
  }
  out += fmt::format("//   const {}::Reaction reaction = controller.step(observation);\n", ns);
  if (!names.outputs.empty()) out += fmt::format("//   use(reaction.{});\n", names.outputs.front().field);
  return out;
}

std::string head(const model::Mealy& machine, const CppNames& names) {
  std::string out =
      fmt::format("// The controller \"{}\", written by heed: {} states, {} observations, {} reactions.\n",
                  cpp_comment(machine.name), machine.state_count(), machine.input_letters.size(),
                  machine.output_letters.size());
  out += list("It relies on these assumptions on its environment:", machine.assumptions);
  out += list("Notes:", machine.notes);
  out += "//\n// How to use it, once per observation:\n" + example(names);
  out +=
      "//\n"
      "// Controller::last_status() says how the last observation was answered: Defined; Fallback (it "
      "breaks\n"
      "// an assumption, and this is the stated answer to that); Undefined (there is no answer to it here, "
      "or\n"
      "// a value is outside its domain: the state is kept and the last reaction repeated). Before any\n"
      "// reaction, every column has its first value.\n"
      "// C++17, no heap, no exceptions. Everything is a table; a step is two look-ups.\n";
  return out;
}

std::string guard(const std::string& name_space) {
  std::string out;
  for (const char c : name_space + "_h")
    if (c != ':')
      out += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    else if (!out.ends_with('_'))
      out += '_';
  return out;
}

/// The enumeration, and name() for its values.
std::string enumeration(const CppColumn& column) {
  const std::size_t count = column.enumerators.size();
  std::string out = fmt::format("\nenum class {} : {} {{\n", column.type,
                                smallest_type(0, static_cast<std::int64_t>(count) - 1));
  for (std::size_t i = 0; i < count; ++i) {
    const std::string& original = column.variable.domain.values[i];
    out += fmt::format("  {}{}", column.enumerators[i], i + 1 < count ? "," : "");
    out += column.enumerators[i] != original ? "  // " + cpp_comment(original) + "\n" : "\n";
  }
  out += fmt::format("}};\n\nnamespace detail {{\ninline constexpr const char* names_of_{}[] = {{\n",
                     column.type);
  for (const std::string& value : column.variable.domain.values)
    out += fmt::format("    {},\n", cpp_literal(value));
  out += "};\n}  // namespace detail\n\n/// The value as the controller's file writes it.\n";
  return out + fmt::format(
                   "constexpr const char* name({0} value) noexcept {{\n"
                   "  const auto index = static_cast<std::uint32_t>(value);\n"
                   "  return index < {1} ? detail::names_of_{0}[index] : \"?\";\n}}\n",
                   column.type, count);
}

std::string field(const CppColumn& column) {
  const model::Variable& variable = column.variable;
  std::string about;
  if (variable.domain.kind == model::Domain::Kind::Integer)
    about = fmt::format("{} ... {}", variable.domain.low, variable.domain.high);
  if (column.field != variable.name) about += (about.empty() ? "" : "; ") + variable.name;
  if (!variable.comment.empty()) about += (about.empty() ? "" : "; ") + variable.comment;
  std::string out =
      fmt::format("  {} {} = {};", column.type, column.field, cpp_value(column, variable.domain.low));
  return about.empty() ? out + "\n" : out + "  // " + cpp_comment(about) + "\n";
}

std::string structure(std::string_view about, std::string_view name, const std::vector<CppColumn>& columns) {
  std::string out = fmt::format("\n/// {}\nstruct {} {{\n", about, name);
  for (const CppColumn& column : columns) out += field(column);
  return out + "};\n";
}

constexpr std::string_view status = R"(
/// How an observation was answered.
enum class Status : std::uint8_t { Defined, Fallback, Undefined };
)";

constexpr std::string_view controller = R"(
class Controller {
 public:
  /// Back before the first observation.
  void reset() noexcept { *this = Controller(); }

  /// The reaction to what is observed now.
  Reaction step(const Observation& observation) noexcept {
    const detail::Row row = detail::row_of(state_, detail::letter_of(observation));
    status_ = static_cast<Status>(row.status);
    if (status_ != Status::Undefined) {
      state_ = row.next;
      reaction_ = detail::reactions[row.reaction];
    }
    return reaction_;
  }

  /// How the last observation was answered; Undefined before the first.
  Status last_status() const noexcept { return status_; }

 private:
  std::uint32_t state_ = 0;
  Status status_ = Status::Undefined;
  Reaction reaction_{};
};
)";

}  // namespace

std::string to_cpp(const model::Mealy& machine, const CppOptions& options) {
  const CppNames names = cpp_names(machine, options.name_space);
  const std::string include_guard = guard(names.name_space);
  std::string out = head(machine, names);
  out += fmt::format("#ifndef {0}\n#define {0}\n\n#include <cstdint>\n\nnamespace {1} {{\n", include_guard,
                     names.name_space);
  out += status;
  for (const auto* columns : {&names.inputs, &names.outputs})
    for (const CppColumn& column : *columns)
      if (!column.enumerators.empty()) out += enumeration(column);
  out +=
      structure("What is observed in a step; what is not set is not perceived.", "Observation", names.inputs);
  out += structure("What is done, and what is known.", "Reaction", names.outputs);
  out += "\nnamespace detail {\n\n" + cpp_letters(machine, names) + "\n" + cpp_rows(machine, names);
  out += "\n}  // namespace detail\n" + std::string(controller);
  out += fmt::format("\n}}  // namespace {}\n\n#endif  // {}\n", names.name_space, include_guard);
  return out;
}

}  // namespace heed::exporter
