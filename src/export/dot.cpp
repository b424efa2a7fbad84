#include <heed/export/dot.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

#include "cubes.h"
#include "printable.h"

namespace heed::exporter {
namespace {

using model::OutputRole;

constexpr std::size_t most_merged = 4096;

/// For the inside of a quoted label: Graphviz reads escapes and HTML entities there.
std::string quote(std::string_view text) {
  std::string out;
  for (const char c : printable(text)) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
    if (c == '&') out += "amp;";
  }
  return out;
}

struct Edge {
  std::uint32_t next;
  bool fallback;
  std::string answer;
  friend auto operator<=>(const Edge&, const Edge&) = default;
};

class Drawing {
 public:
  Drawing(const model::Mealy& machine, const DotOptions& options) : machine_(machine), options_(options) {
    for (const model::Valuation& letter : machine.output_letters) answers_.push_back(answer(letter));
    shown_ = static_cast<std::uint32_t>(std::min<std::size_t>(machine.state_count(), options.max_states));
  }

  std::string draw() {
    std::string out = fmt::format("digraph \"{}\" {{\n  rankdir=LR;\n  labelloc=t;\n  label=\"{}\";\n",
                                  quote(machine_.name), title());
    out += "  node [shape=circle, fontname=\"sans-serif\"];\n  edge [fontname=\"sans-serif\"];\n";
    if (shown_ > 0) out += "  start [shape=point, label=\"\"];\n  start -> s0;\n";
    for (std::uint32_t state = 0; state < shown_; ++state)
      out += fmt::format("  s{} [label=\"{}\"];\n", state, state_label(state));
    if (shown_ < machine_.state_count())
      out += fmt::format("  more [shape=box, style=dashed, label=\"{} more states\"];\n",
                         machine_.state_count() - shown_);
    for (std::uint32_t state = 0; state < shown_; ++state) out += edges(state);
    return out + "}\n";
  }

 private:
  [[nodiscard]] std::string title() const {
    std::string out = quote(machine_.name);
    for (const std::string& assumption : machine_.assumptions) out += "\\nassumes " + quote(assumption);
    if (shown_ < machine_.state_count())
      out += fmt::format("\\nnote: only the first {} of {} states are drawn", shown_, machine_.state_count());
    return out;
  }

  /// What is true or has a value, of the columns that are meant for people.
  [[nodiscard]] std::string answer(const model::Valuation& letter) const {
    std::string out;
    for (std::size_t i = 0; i < letter.size(); ++i) {
      const auto& [variable, role] = machine_.outputs[i];
      if (role == OutputRole::Plant || role == OutputRole::Memory) continue;
      const bool boolean = variable.domain.kind == model::Domain::Kind::Boolean;
      if (boolean && letter[i] == 0) continue;
      if (!out.empty()) out += ", ";
      if (boolean)
        out += quote(variable.name);
      else if (role == OutputRole::Action)
        out += quote(variable.domain.print(letter[i]));
      else
        out += fmt::format("{} = {}", quote(variable.name), quote(variable.domain.print(letter[i])));
    }
    return out.empty() ? "-" : out;
  }

  /// The state's number, and each plant column that has the same value in all its rows.
  [[nodiscard]] std::string state_label(std::uint32_t state) const {
    std::string out = std::to_string(state);
    const std::uint32_t begin = machine_.first[state], end = machine_.first[state + 1];
    for (std::size_t i = 0; i < machine_.outputs.size() && begin < end; ++i) {
      if (machine_.outputs[i].role != OutputRole::Plant) continue;
      const auto value = [&](std::uint32_t t) {
        return machine_.output_letters[machine_.transitions[t].output][i];
      };
      bool same = true;
      for (std::uint32_t t = begin; t < end; ++t) same = same && value(t) == value(begin);
      if (same) out += "\\n" + quote(machine_.outputs[i].variable.domain.print(value(begin)));
    }
    return out;
  }

  [[nodiscard]] std::string edges(std::uint32_t state) const {
    std::map<Edge, std::vector<const model::Valuation*>> groups;
    for (std::uint32_t t = machine_.first[state]; t < machine_.first[state + 1]; ++t) {
      const model::Mealy::Transition& row = machine_.transitions[t];
      groups[{std::min(row.next, shown_), row.fallback, answers_[row.output]}].push_back(
          &machine_.input_letters[row.input]);
    }
    std::string out;
    for (const auto& [edge, letters] : groups) {
      const std::string next = edge.next < shown_ ? fmt::format("s{}", edge.next) : "more";
      out += fmt::format("  s{} -> {} [label=\"{}\\n/ {}\"{}];\n", state, next, condition(letters),
                         edge.answer, edge.fallback ? ", style=dashed" : "");
    }
    return out;
  }

  [[nodiscard]] std::string condition(const std::vector<const model::Valuation*>& letters) const {
    if (letters.size() > most_merged) return fmt::format("{} observations", letters.size());
    const std::vector<Cube> cubes = cover(machine_.inputs, letters);
    std::string out;
    for (std::size_t i = 0; i < std::min(cubes.size(), options_.max_cubes); ++i)
      out += (i == 0 ? "" : "\\n| ") + print_cube(machine_.inputs, cubes[i], quote);
    if (cubes.size() > options_.max_cubes)
      out += fmt::format("\\n| {} more", cubes.size() - options_.max_cubes);
    return out;
  }

  const model::Mealy& machine_;
  const DotOptions& options_;
  std::vector<std::string> answers_;  ///< Per output letter.
  std::uint32_t shown_ = 0;
};

}  // namespace

std::string to_dot(const model::Mealy& machine, const DotOptions& options) {
  return Drawing(machine, options).draw();
}

}  // namespace heed::exporter
