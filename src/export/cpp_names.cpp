// Names and texts of a machine may be anything (labels of an ontology, in any script); code may not.
#include <heed/util/diagnostic.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "cpp_names.h"
#include "printable.h"

namespace heed::exporter {
namespace {

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Keywords up to C++20, alternative tokens, and macros of common headers and of gnu++17.
const std::set<std::string, std::less<>>& reserved() {
  static const std::set<std::string, std::less<>> words{
      "alignas",      "alignof",       "and",         "and_eq",
      "asm",          "auto",          "bitand",      "bitor",
      "bool",         "break",         "case",        "catch",
      "char",         "char16_t",      "char32_t",    "char8_t",
      "class",        "co_await",      "co_return",   "co_yield",
      "compl",        "concept",       "const",       "const_cast",
      "consteval",    "constexpr",     "constinit",   "continue",
      "decltype",     "default",       "delete",      "do",
      "double",       "dynamic_cast",  "else",        "enum",
      "explicit",     "export",        "extern",      "false",
      "float",        "for",           "friend",      "goto",
      "if",           "inline",        "int",         "long",
      "mutable",      "namespace",     "new",         "noexcept",
      "not",          "not_eq",        "nullptr",     "operator",
      "or",           "or_eq",         "private",     "protected",
      "public",       "register",      "requires",    "return",
      "short",        "signed",        "sizeof",      "static",
      "struct",       "switch",        "template",    "this",
      "thread_local", "throw",         "true",        "try",
      "typedef",      "typeid",        "typename",    "union",
      "unsigned",     "using",         "virtual",     "void",
      "volatile",     "wchar_t",       "while",       "xor",
      "xor_eq",       "static_assert", "static_cast", "reinterpret_cast",
      "std",          "linux",         "unix",        "i386",
      "errno",        "assert",        "stdin",       "stdout",
      "stderr",       "major",         "minor",       "NULL",
      "EOF",          "TRUE",          "FALSE",       "DOMAIN",
      "OVERFLOW",     "UNDERFLOW",     "HUGE",        "INFINITY",
      "NAN",          "HUGE_VAL"};
  return words;
}

/// INT8_MAX, UINT64_C, SIZE_MAX, SIG_ATOMIC_MIN and their like, which <cstdint> defines.
bool is_integer_macro(std::string_view word) {
  constexpr std::array<std::string_view, 4> ends{"_MAX", "_MIN", "_C", "_WIDTH"};
  const bool upper = std::none_of(word.begin(), word.end(), [](char c) { return c >= 'a' && c <= 'z'; });
  return upper && std::any_of(ends.begin(), ends.end(), [&](auto end) { return word.ends_with(end); });
}

bool is_taken_by_language(std::string_view word) {
  return reserved().contains(word) || is_integer_macro(word);
}

CppColumn column_of(const model::Variable& variable, Scope& types) {
  CppColumn column{variable, {}, {}, {}};
  switch (variable.domain.kind) {
    case model::Domain::Kind::Boolean:
      column.type = "bool";
      break;
    case model::Domain::Kind::Integer:
      column.type = smallest_type(variable.domain.low, variable.domain.high);
      break;
    case model::Domain::Kind::Enumeration: {
      column.type = types.take(type_identifier(variable.name), "Value");
      Scope scope;
      for (const std::string& value : variable.domain.values)
        column.enumerators.push_back(scope.take(identifier(value), "value"));
      break;
    }
  }
  return column;
}

/// A field may not be called like a type that its struct uses, hence like none at all.
void name_fields(std::vector<CppColumn>& columns, const std::set<std::string>& types) {
  Scope scope(types);
  for (CppColumn& column : columns) column.field = scope.take(identifier(column.variable.name), "value");
}

void check_namespace(const std::string& name_space) {
  std::size_t begin = 0;
  for (;;) {
    const std::size_t end = std::min(name_space.find("::", begin), name_space.size());
    const std::string part = name_space.substr(begin, end - begin);
    if (!is_identifier(part) || part == "std")
      throw util::InputError({}, "bad-namespace", fmt::format("'{}' is no namespace for C++", name_space),
                             "identifiers joined by '::', such as acme::car");
    if (end == name_space.size()) return;
    begin = end + 2;
  }
}

}  // namespace

std::string identifier(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (is_letter(c) || (is_digit(c) && !out.empty()))
      out += c;
    else if (is_digit(c))
      (out += 'v') += c;
    else if (!out.empty() && out.back() != '_')
      out += '_';
  }
  while (!out.empty() && out.back() == '_') out.pop_back();
  if (is_taken_by_language(out)) out += '_';
  return out;
}

std::string type_identifier(std::string_view text) {
  std::string out;
  bool upper = true;
  for (const char c : text) {
    const bool usable = is_letter(c) || is_digit(c);
    if (usable && out.empty() && is_digit(c)) out += 'V';
    if (usable) out += upper && c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    upper = !usable;
  }
  if (is_taken_by_language(out)) out += '_';
  return out;
}

bool is_identifier(std::string_view text) {
  return !text.empty() && is_letter(text[0]) &&
         std::all_of(text.begin(), text.end(),
                     [](char c) { return is_letter(c) || is_digit(c) || c == '_'; }) &&
         text.find("__") == std::string_view::npos && !is_taken_by_language(text);
}

std::string Scope::take(std::string_view wish, std::string_view otherwise) {
  const std::string base(wish.empty() ? otherwise : wish);
  const char* glue = base.ends_with('_') ? "" : "_";
  std::string name = base;
  for (std::size_t& number = numbers_[base]; !taken_.insert(name).second;)
    name = fmt::format("{}{}{}", base, glue, ++number + 1);
  return name;
}

std::string cpp_literal(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\' || c == '?')
      (out += '\\') += c;
    else if (byte < 0x20 || byte >= 0x7F)
      out += fmt::format("\\{:03o}", byte);
    else
      out += c;
  }
  return out + '"';
}

std::string cpp_comment(std::string_view text) {
  std::string out;
  for (const char c : printable(text)) out += c == '?' && out.ends_with('?') ? " ?" : std::string(1, c);
  while (out.ends_with(' ')) out.pop_back();
  if (out.ends_with('\\')) out += " .";
  return out;
}

std::string_view smallest_type(std::int64_t low, std::int64_t high) {
  if (low >= 0)
    return high <= UINT8_MAX ? "std::uint8_t" : high <= UINT16_MAX ? "std::uint16_t" : "std::uint32_t";
  if (low >= INT8_MIN && high <= INT8_MAX) return "std::int8_t";
  return low >= INT16_MIN && high <= INT16_MAX ? "std::int16_t" : "std::int32_t";
}

CppNames cpp_names(const model::Mealy& machine, const std::string& name_space) {
  CppNames names;
  if (!name_space.empty()) check_namespace(name_space);
  const std::string own = identifier(machine.name);
  names.name_space = !name_space.empty()  ? name_space
                     : own.empty()        ? "controller"
                     : own.ends_with('_') ? own + "controller"
                                          : own + "_controller";
  const std::set<std::string> fixed{"Observation", "Reaction", "Controller", "Status"};
  Scope types(fixed);
  std::set<std::string> used(fixed);
  const auto add = [&](std::vector<CppColumn>& columns, const model::Variable& variable) {
    columns.push_back(column_of(variable, types));
    if (!columns.back().enumerators.empty()) used.insert(columns.back().type);
  };
  for (const model::Variable& input : machine.inputs) add(names.inputs, input);
  for (const model::Output& output : machine.outputs) add(names.outputs, output.variable);
  name_fields(names.inputs, used);
  name_fields(names.outputs, used);
  return names;
}

}  // namespace heed::exporter
