// Controller files: docs/formats/controller.md. Written by hand, one state a line, because a machine may have
// a million rows; read through the JSON library, then checked key by key.

#include <heed/model/mealy.h>
#include <heed/util/diagnostic.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

namespace heed::model {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 6> roles = {"action", "output",     "plant",
                                                   "memory", "recognised", "prescribed"};

std::string quoted(const std::string& text) {
  return json(text).dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string print_variable(const Variable& variable) {
  std::string type;
  switch (variable.domain.kind) {
    case Domain::Kind::Boolean:
      type = "\"boolean\"";
      break;
    case Domain::Kind::Integer:
      type = fmt::format("[{}, {}]", variable.domain.low, variable.domain.high);
      break;
    case Domain::Kind::Enumeration: {
      for (const std::string& value : variable.domain.values)
        type += (type.empty() ? "[" : ", ") + quoted(value);
      type += ']';
    }
  }
  std::string out = fmt::format("{{\"name\": {}, \"type\": {}", quoted(variable.name), type);
  if (!variable.comment.empty()) out += fmt::format(", \"comment\": {}", quoted(variable.comment));
  return out;
}

template <class Items, class Print>
void print_list(std::string& out, std::string_view key, const Items& items, Print print) {
  out += fmt::format("\"{}\": [", key);
  bool first = true;
  for (const auto& item : items) {
    out += first ? "" : ", ";
    out += print(item);
    first = false;
  }
  out += "],\n";
}

std::string print_letter(const Valuation& letter) {
  std::string out = "[";
  for (std::size_t i = 0; i < letter.size(); ++i) {
    if (i != 0) out += ", ";
    out += std::to_string(letter[i]);
  }
  return out + ']';
}

/// Reads one controller; every complaint names the key.
class Reader {
 public:
  explicit Reader(const util::SourceText& source) : source_(source) {}

  Mealy read() {
    parse();
    expect_keys(root_, "the controller",
                {"heed", "version", "name", "inputs", "outputs", "assumptions", "notes", "input_letters",
                 "output_letters", "states"});
    if (root_["heed"] != "controller" || root_["version"] != 1)
      fail("expected \"heed\": \"controller\" and \"version\": 1");
    Mealy machine;
    machine.name = text(root_["name"], "name");
    for (const json& item : list(root_, "inputs")) machine.inputs.push_back(variable(item, false));
    for (const json& item : list(root_, "outputs"))
      machine.outputs.push_back({variable(item, true), role(item)});
    for (const json& item : list(root_, "assumptions"))
      machine.assumptions.push_back(text(item, "assumptions"));
    for (const json& item : list(root_, "notes")) machine.notes.push_back(text(item, "notes"));
    std::vector<const Domain*> in, out;
    for (const Variable& v : machine.inputs) in.push_back(&v.domain);
    for (const Output& o : machine.outputs) out.push_back(&o.variable.domain);
    machine.input_letters = letters("input_letters", in);
    machine.output_letters = letters("output_letters", out);
    states(machine);
    return machine;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw util::InputError(
        util::Location{source_.at(0).file, 0, 0}, "bad-controller", message,
        "a controller file is written by `heed run` or `heed synth` (docs/formats/controller.md)");
  }

  void parse() {
    try {
      // The callback refuses deep nesting before the parser's own recursion-free stack grows without bound.
      root_ = json::parse(source_.text(), [](int depth, json::parse_event_t, json&) {
        if (depth > 8) throw std::length_error("nested deeper than a controller is");
        return true;
      });
    } catch (const json::parse_error& error) {
      throw util::InputError(source_, error.byte > 0 ? error.byte - 1 : 0, "bad-json", "not JSON here",
                             "a controller file is one JSON document");
    } catch (const std::length_error& error) {
      fail(error.what());
    }
    if (!root_.is_object()) fail("expected a JSON object");
  }

  void expect_keys(const json& object, std::string_view what, const std::vector<std::string>& keys) const {
    for (const std::string& key : keys)
      if (!object.contains(key)) fail(fmt::format("{} lacks the key '{}'", what, key));
    for (const auto& [key, value] : object.items())
      if (std::find(keys.begin(), keys.end(), key) == keys.end())
        fail(fmt::format("unknown key '{}' in {}; {}", key, what, util::suggestion(key, keys)));
  }

  const json& list(const json& object, const char* key) const {
    if (!object[key].is_array()) fail(fmt::format("'{}' must be an array", key));
    return object[key];
  }

  std::string text(const json& value, std::string_view what) const {
    if (!value.is_string()) fail(fmt::format("'{}' must hold text", what));
    return value.get<std::string>();
  }

  std::int32_t integer(const json& value, std::string_view what, std::int64_t low, std::int64_t high) const {
    if (!value.is_number_integer())
      fail(fmt::format("{}: expected an integer, found {}", what, value.dump().substr(0, 40)));
    const auto number = value.get<std::int64_t>();
    if (number < low || number > high)
      fail(fmt::format("{}: {} is outside {} ... {}", what, number, low, high));
    return static_cast<std::int32_t>(number);
  }

  Variable variable(const json& item, bool with_role) const {
    if (!item.is_object()) fail("a variable must be an object with 'name' and 'type'");
    std::vector<std::string> keys{"name", "type"};
    if (with_role) keys.emplace_back("role");
    if (item.contains("comment")) keys.emplace_back("comment");
    expect_keys(item, "a variable", keys);
    Variable variable{text(item["name"], "name"), domain(item["type"]), {}, {}};
    if (item.contains("comment")) variable.comment = text(item["comment"], "comment");
    return variable;
  }

  Domain domain(const json& type) const {
    if (type == "boolean") return Domain::boolean();
    if (!type.is_array() || type.empty())
      fail("'type' must be \"boolean\", [low, high] or an array of names");
    if (type[0].is_string()) {
      std::vector<std::string> values;
      for (const json& value : type) values.push_back(text(value, "type"));
      return Domain::enumeration(std::move(values));
    }
    if (type.size() != 2) fail("an integer type is [low, high]");
    const std::int32_t low = integer(type[0], "type", INT32_MIN / 2, INT32_MAX / 2);
    return Domain::integer(low, integer(type[1], "type", low, INT32_MAX / 2));
  }

  OutputRole role(const json& item) const {
    const std::string name = text(item["role"], "role");
    const auto found = std::find(roles.begin(), roles.end(), name);
    if (found == roles.end())
      fail(fmt::format("unknown role '{}'; {}", name, util::suggestion(name, {roles.begin(), roles.end()})));
    return static_cast<OutputRole>(found - roles.begin());
  }

  std::vector<Valuation> letters(const char* key, const std::vector<const Domain*>& domains) const {
    std::vector<Valuation> letters;
    for (const json& item : list(root_, key)) {
      if (!item.is_array() || item.size() != domains.size())
        fail(fmt::format("'{}': a letter must have {} values", key, domains.size()));
      Valuation letter;
      for (std::size_t i = 0; i < domains.size(); ++i)
        letter.push_back(integer(item[i], key, domains[i]->low, domains[i]->high));
      if (!letters.empty() && !(letters.back() < letter))
        fail(fmt::format("'{}': letters must be ascending and different", key));
      letters.push_back(std::move(letter));
    }
    return letters;
  }

  void states(Mealy& machine) const {
    const json& states = list(root_, "states");
    if (states.empty()) fail("'states' is empty: a controller has at least its start");
    machine.first.push_back(0);
    for (const json& rows : states) {
      if (!rows.is_array()) fail("'states': a state is an array of rows");
      for (const json& row : rows) {
        const auto transition = this->row(row, machine, states.size());
        const bool first_of_state = machine.transitions.size() == machine.first.back();
        if (!first_of_state && machine.transitions.back().input >= transition.input)
          fail("'states': rows of a state must be ascending by input letter");
        machine.transitions.push_back(transition);
      }
      machine.first.push_back(static_cast<std::uint32_t>(machine.transitions.size()));
    }
  }

  Mealy::Transition row(const json& row, const Mealy& machine, std::size_t states) const {
    if (!row.is_array() || row.size() < 3 || row.size() > 4 || (row.size() == 4 && row[3] != 1))
      fail("'states': a row is [input letter, output letter, next state] with an optional 1 for a fallback");
    const auto index = [&](std::size_t i, std::string_view what, std::size_t count) {
      return static_cast<std::uint32_t>(integer(row[i], what, 0, static_cast<std::int64_t>(count) - 1));
    };
    return {index(0, "input letter of a row", machine.input_letters.size()),
            index(1, "output letter of a row", machine.output_letters.size()),
            index(2, "next state of a row", states), row.size() == 4};
  }

  const util::SourceText& source_;
  json root_;
};

}  // namespace

std::string write_mealy(const Mealy& machine) {
  std::string out =
      fmt::format("{{\n\"heed\": \"controller\",\n\"version\": 1,\n\"name\": {},\n", quoted(machine.name));
  print_list(out, "inputs", machine.inputs, [](const Variable& v) { return print_variable(v) + '}'; });
  print_list(out, "outputs", machine.outputs, [](const Output& o) {
    return fmt::format("{}, \"role\": \"{}\"}}", print_variable(o.variable),
                       roles[static_cast<std::size_t>(o.role)]);
  });
  print_list(out, "assumptions", machine.assumptions, quoted);
  print_list(out, "notes", machine.notes, quoted);
  print_list(out, "input_letters", machine.input_letters, print_letter);
  print_list(out, "output_letters", machine.output_letters, print_letter);
  out += "\"states\": [";
  for (std::uint32_t s = 0; s < machine.state_count(); ++s) {
    out += s == 0 ? "\n [" : ",\n [";
    for (std::uint32_t t = machine.first[s]; t < machine.first[s + 1]; ++t) {
      const Mealy::Transition& row = machine.transitions[t];
      fmt::format_to(std::back_inserter(out), "{}[{}, {}, {}{}]", t == machine.first[s] ? "" : ", ",
                     row.input, row.output, row.next, row.fallback ? ", 1" : "");
    }
    out += ']';
  }
  return out + "\n]\n}\n";
}

Mealy read_mealy(const util::SourceText& source, const util::Limits& limits) {
  if (limits.input_bytes != 0 && source.text().size() > limits.input_bytes)
    throw util::InputError(source.at(0), "file-too-large", "the controller is larger than the input limit",
                           "raise the limit with --max-input");
  return Reader(source).read();
}

}  // namespace heed::model
