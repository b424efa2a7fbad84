// Controller files: docs/formats/controller.md. Written by hand, one state a line, because a machine may have
// a million rows; read through the JSON library, then checked key by key.

#include <heed/model/mealy.h>
#include <heed/util/diagnostic.h>

#include <array>
#include <charconv>

#include "document.h"

namespace heed::model {
namespace {

using json = Document::Json;

std::string print_letter(const Valuation& letter) {
  std::string out = "[";
  for (std::size_t i = 0; i < letter.size(); ++i) {
    if (i != 0) out += ", ";
    out += std::to_string(letter[i]);
  }
  return out + ']';
}

/// Without a format string, which would take most of the time of writing a large machine.
void print_row(std::string& out, const Mealy::Transition& row) {
  std::array<char, 48> text{'['};
  char* end = text.data() + 1;
  for (const std::uint32_t number : {row.input, row.output, row.next}) {
    end = std::to_chars(end, text.data() + text.size(), number).ptr;
    *end++ = ',';
    *end++ = ' ';
  }
  if (row.fallback)
    *end++ = '1';
  else
    end -= 2;
  *end++ = ']';
  out.append(text.data(), end);
}

/// Reads one controller.
class Reader {
 public:
  explicit Reader(const util::SourceText& source) : document_(source) {}

  Mealy read() {
    const json& root = document_.root();
    if (root.contains("heed") && root["heed"] == "symbolic-controller")
      document_.fail("this controller is symbolic, and its states are not listed");
    document_.expect_keys(root, "the controller",
                          {"heed", "version", "name", "inputs", "outputs", "assumptions", "notes",
                           "input_letters", "output_letters", "states"});
    if (root["heed"] != "controller" || root["version"] != 1)
      document_.fail("expected \"heed\": \"controller\" and \"version\": 1");
    Mealy machine;
    machine.name = document_.text(root["name"], "name");
    machine.inputs = document_.variables("inputs");
    machine.outputs = document_.columns("outputs");
    machine.assumptions = document_.texts("assumptions");
    machine.notes = document_.texts("notes");
    std::vector<const Domain*> in, out;
    for (const Variable& v : machine.inputs) in.push_back(&v.domain);
    for (const Output& o : machine.outputs) out.push_back(&o.variable.domain);
    machine.input_letters = letters("input_letters", in);
    machine.output_letters = letters("output_letters", out);
    states(machine);
    return machine;
  }

 private:
  std::vector<Valuation> letters(const char* key, const std::vector<const Domain*>& domains) const {
    std::vector<Valuation> letters;
    for (const json& item : document_.list(document_.root(), key)) {
      if (!item.is_array() || item.size() != domains.size())
        document_.fail(fmt::format("'{}': a letter must have {} values", key, domains.size()));
      Valuation letter;
      for (std::size_t i = 0; i < domains.size(); ++i)
        letter.push_back(document_.integer(item[i], key, domains[i]->low, domains[i]->high));
      if (!letters.empty() && !(letters.back() < letter))
        document_.fail(fmt::format("'{}': letters must be ascending and different", key));
      letters.push_back(std::move(letter));
    }
    return letters;
  }

  void states(Mealy& machine) const {
    const json& states = document_.list(document_.root(), "states");
    if (states.empty()) document_.fail("'states' is empty: a controller has at least its start");
    machine.first.push_back(0);
    for (const json& rows : states) {
      if (!rows.is_array()) document_.fail("'states': a state is an array of rows");
      for (const json& row : rows) {
        const auto transition = this->row(row, machine, states.size());
        const bool first_of_state = machine.transitions.size() == machine.first.back();
        if (!first_of_state && machine.transitions.back().input >= transition.input)
          document_.fail("'states': rows of a state must be ascending by input letter");
        machine.transitions.push_back(transition);
      }
      machine.first.push_back(static_cast<std::uint32_t>(machine.transitions.size()));
    }
  }

  Mealy::Transition row(const json& row, const Mealy& machine, std::size_t states) const {
    if (!row.is_array() || row.size() < 3 || row.size() > 4 || (row.size() == 4 && row[3] != 1))
      document_.fail(
          "'states': a row is [input letter, output letter, next state] with an optional 1 for a fallback");
    const auto index = [&](std::size_t i, std::string_view what, std::size_t count) {
      return static_cast<std::uint32_t>(
          document_.integer(row[i], what, 0, static_cast<std::int64_t>(count) - 1));
    };
    return {index(0, "input letter of a row", machine.input_letters.size()),
            index(1, "output letter of a row", machine.output_letters.size()),
            index(2, "next state of a row", states), row.size() == 4};
  }

  Document document_;
};

}  // namespace

std::string write_mealy(const Mealy& machine) {
  std::string out = fmt::format("{{\n\"heed\": \"controller\",\n\"version\": 1,\n\"name\": {},\n",
                                json_quoted(machine.name));
  json_list(out, "inputs", machine.inputs, json_variable);
  json_list(out, "outputs", machine.outputs, json_column);
  json_list(out, "assumptions", machine.assumptions, json_quoted);
  json_list(out, "notes", machine.notes, json_quoted);
  json_list(out, "input_letters", machine.input_letters, print_letter);
  json_list(out, "output_letters", machine.output_letters, print_letter);
  out += "\"states\": [";
  for (std::uint32_t s = 0; s < machine.state_count(); ++s) {
    out += s == 0 ? "\n [" : ",\n [";
    for (std::uint32_t t = machine.first[s]; t < machine.first[s + 1]; ++t) {
      if (t != machine.first[s]) out += ", ";
      print_row(out, machine.transitions[t]);
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
