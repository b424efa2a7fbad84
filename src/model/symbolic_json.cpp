// Symbolic controller files: docs/formats/symbolic.md.

#include <heed/model/symbolic.h>
#include <heed/util/diagnostic.h>

#include "document.h"

namespace heed::model {
namespace {

using Json = Document::Json;

std::size_t total_width(const std::vector<Output>& columns) {
  std::size_t bits = 0;
  for (const Output& column : columns) bits += bit_width(column.variable.domain);
  return bits;
}

/// Reads one symbolic controller.
class Reader {
 public:
  explicit Reader(const util::SourceText& source) : document_(source) {}

  SymbolicController read() {
    const Json& root = document_.root();
    document_.expect_keys(
        root, "the controller",
        {"heed", "version", "name", "inputs", "outputs", "memories", "definitions", "assumptions", "notes",
         "order", "nodes", "start", "legal", "updates", "derived", "winning", "goals"});
    if (root["heed"] != "symbolic-controller" || root["version"] != 1)
      document_.fail("expected \"heed\": \"symbolic-controller\" and \"version\": 1");
    SymbolicController result;
    result.name = document_.text(root["name"], "name");
    result.inputs = document_.variables("inputs");
    result.outputs = document_.columns("outputs");
    result.memories = document_.columns("memories");
    result.definitions = document_.columns("definitions");
    result.assumptions = document_.texts("assumptions");
    result.notes = document_.texts("notes");
    order(result);
    nodes(result);
    functions(result);
    return result;
  }

 private:
  void order(SymbolicController& result) {
    std::size_t positions = total_width(result.outputs) + total_width(result.memories);
    for (const Variable& input : result.inputs) positions += bit_width(input.domain);
    const std::size_t count = 2 * positions;
    level_.assign(count, count);
    for (const Json& item : document_.list(document_.root(), "order")) {
      const auto bit = static_cast<std::uint32_t>(
          document_.integer(item, "a bit of 'order'", 0, static_cast<std::int64_t>(count) - 1));
      if (level_[bit] != count) document_.fail(fmt::format("'order' has the bit {} twice", bit));
      level_[bit] = result.diagrams.order.size();
      result.diagrams.order.push_back(bit);
    }
    if (result.diagrams.order.size() != count)
      document_.fail(fmt::format("'order' must have each of the {} bits", count));
  }

  void nodes(SymbolicController& result) {
    const Json& list = document_.list(document_.root(), "nodes");
    if (list.size() % 3 != 0) document_.fail("'nodes' must have three integers for each node");
    auto& nodes = result.diagrams.nodes;
    nodes.reserve(list.size() / 3);
    for (std::size_t i = 0; i < list.size(); i += 3) {
      const auto last = static_cast<std::int64_t>(2 * nodes.size() + 1);
      const auto part = [&](std::size_t k, const char* what, std::int64_t high) {
        return static_cast<std::uint32_t>(document_.integer(list[i + k], what, 0, high));
      };
      const Diagrams::Node node{part(0, "the bit of a node", static_cast<std::int64_t>(level_.size()) - 1),
                                part(1, "a function of a node", last), part(2, "a function of a node", last)};
      check(node, nodes);
      nodes.push_back(node);
    }
    last_ = static_cast<std::int64_t>(2 * nodes.size() + 1);
  }

  void check(const Diagrams::Node& node, const std::vector<Diagrams::Node>& before) const {
    if ((node.high & 1U) != 0 || node.high == node.low)
      document_.fail("'nodes': the second function of a node is no negation and not the first one");
    for (const Function child : {node.low, node.high})
      if (child >> 1 != 0 && level_[before[(child >> 1) - 1].bit] <= level_[node.bit])
        document_.fail("'nodes': a bit stands below one that it should stand above");
  }

  void functions(SymbolicController& result) const {
    const Json& root = document_.root();
    const std::size_t outputs = total_width(result.outputs), memories = total_width(result.memories);
    const Json& start = root["start"];
    if (!start.is_object()) document_.fail("'start' must be an object");
    document_.expect_keys(start, "'start'", {"answered", "memories", "outputs"});
    result.start = {function(start["answered"], "start"), functions(start, "memories", memories),
                    functions(start, "outputs", outputs)};
    for (const Json& item : document_.list(root, "legal")) result.legal.push_back(function(item, "legal"));
    result.updates = functions(root, "updates", memories);
    result.derived = functions(root, "derived", result.definitions.size());
    result.winning = function(root["winning"], "winning");
    for (const Json& item : document_.list(root, "goals")) {
      if (!item.is_object()) document_.fail("'goals': a goal is an object");
      document_.expect_keys(item, "a goal", {"answers", "met", "ranks"});
      result.goals.push_back(
          {functions(item, "answers", outputs), function(item["met"], "met"), ranks(item)});
    }
    if (result.goals.empty()) document_.fail("'goals' is empty: a controller has at least one");
  }

  [[nodiscard]] Function function(const Json& item, std::string_view what) const {
    return static_cast<Function>(document_.integer(item, what, 0, last_));
  }

  std::vector<Function> functions(const Json& object, const char* key, std::size_t count) const {
    std::vector<Function> result;
    for (const Json& item : document_.list(object, key)) result.push_back(function(item, key));
    if (result.size() != count)
      document_.fail(fmt::format("'{}' has {} functions where {} are needed", key, result.size(), count));
    return result;
  }

  std::vector<Level> ranks(const Json& goal) const {
    std::vector<Level> result;
    for (const Json& item : document_.list(goal, "ranks")) {
      if (!item.is_array() || item.size() != 2) document_.fail("'ranks': a rank is [function, assumption]");
      Level level{function(item[0], "ranks"), std::nullopt};
      if (!item[1].is_null())
        level.assumption =
            static_cast<std::uint32_t>(document_.integer(item[1], "an assumption of 'ranks'", 0, INT32_MAX));
      result.push_back(level);
    }
    return result;
  }

  Document document_;
  std::vector<std::size_t> level_;  ///< By bit.
  std::int64_t last_ = 1;           ///< Greatest function.
};

std::string functions_text(const std::vector<Function>& functions) {
  return fmt::format("[{}]", fmt::join(functions, ", "));
}

void print_nodes(std::string& out, const std::vector<Diagrams::Node>& nodes) {
  out += "\"nodes\": [";
  for (std::size_t i = 0; i < nodes.size(); ++i)
    fmt::format_to(std::back_inserter(out), "{}{}, {}, {}", i == 0 ? "\n " : ",\n ", nodes[i].bit,
                   nodes[i].low, nodes[i].high);
  out += "\n],\n";
}

std::string goal_text(const SymbolicController::Goal& goal) {
  std::string out =
      fmt::format("\n {{\"answers\": {}, \"met\": {}, \"ranks\": [", functions_text(goal.answers), goal.met);
  for (std::size_t i = 0; i < goal.ranks.size(); ++i)
    fmt::format_to(std::back_inserter(out), "{}[{}, {}]", i == 0 ? "" : ", ", goal.ranks[i].states,
                   goal.ranks[i].assumption ? std::to_string(*goal.ranks[i].assumption) : "null");
  return out + "]}";
}

}  // namespace

std::string write_symbolic(const SymbolicController& controller) {
  std::string out = fmt::format("{{\n\"heed\": \"symbolic-controller\",\n\"version\": 1,\n\"name\": {},\n",
                                json_quoted(controller.name));
  json_list(out, "inputs", controller.inputs, json_variable);
  json_list(out, "outputs", controller.outputs, json_column);
  json_list(out, "memories", controller.memories, json_column);
  json_list(out, "definitions", controller.definitions, json_column);
  json_list(out, "assumptions", controller.assumptions, json_quoted);
  json_list(out, "notes", controller.notes, json_quoted);
  out += fmt::format("\"order\": [{}],\n", fmt::join(controller.diagrams.order, ", "));
  print_nodes(out, controller.diagrams.nodes);
  out += fmt::format("\"start\": {{\"answered\": {}, \"memories\": {}, \"outputs\": {}}},\n",
                     controller.start.answered, functions_text(controller.start.memories),
                     functions_text(controller.start.outputs));
  out += fmt::format("\"legal\": {},\n\"updates\": {},\n\"derived\": {},\n\"winning\": {},\n",
                     functions_text(controller.legal), functions_text(controller.updates),
                     functions_text(controller.derived), controller.winning);
  out += "\"goals\": [";
  for (std::size_t i = 0; i < controller.goals.size(); ++i)
    out += (i == 0 ? "" : ",") + goal_text(controller.goals[i]);
  return out + "\n]\n}\n";
}

SymbolicController read_symbolic(const util::SourceText& source, const util::Limits& limits) {
  if (limits.input_bytes != 0 && source.text().size() > limits.input_bytes)
    throw util::InputError(source.at(0), "file-too-large", "the controller is larger than the input limit",
                           "raise the limit with --max-input");
  return Reader(source).read();
}

bool is_symbolic(const util::SourceText& source) {
  // The writer puts the key first; whoever reorders by hand is heard within the first lines.
  return std::string_view(source.text()).substr(0, 4096).find("\"symbolic-controller\"") !=
         std::string_view::npos;
}

}  // namespace heed::model
