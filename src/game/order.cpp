#include "order.h"

#include <heed/logic/nodes.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <string>
#include <unordered_map>

namespace heed::game {
namespace {

using Edge = std::vector<std::size_t>;

/// Parts of a clause with more variables than this say little about which of them belong together.
constexpr std::size_t most_together = 8;

/// Which variables a clause and its parts bring together, definitions expanded.
class Edges {
 public:
  explicit Edges(const spec::Gr1& spec) {
    for (const auto& variable : spec.inputs) add_name(variable.name, {variables_++});
    for (const auto& output : spec.outputs) add_name(output.variable.name, {variables_++});
    for (const auto& memory : spec.memories) add_name(memory.variable.name, {variables_++});
    for (const auto& definition : spec.definitions) {
      const Edge edge = variables_of(definition.formula);
      add_name(definition.name, edge);
      add_edge(edge);
    }
    for (const auto* part : {&spec.env_init, &spec.env_safety, &spec.env_justice, &spec.sys_init,
                             &spec.sys_safety, &spec.sys_justice})
      for (const auto& clause : *part) add_clause(clause.formula);
    for (const auto& memory : spec.memories) add_update(memory);
  }

  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }
  [[nodiscard]] std::size_t variables() const { return variables_; }

 private:
  void add_name(const std::string& name, Edge edge) { names_.emplace(name, std::move(edge)); }

  void add_edge(Edge edge) {
    if (edge.size() > 1) edges_.push_back(std::move(edge));
  }

  /// The clause, and its small parts: that bits of two numbers are compared one by one shows only there.
  void add_clause(const logic::Formula& formula) {
    const logic::Nodes nodes(formula);
    add_edge(variables_of(nodes.formulas()));
    std::vector<Edge> small;  // empty where there is none, or more than some
    small.reserve(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      Edge edge;
      if (nodes[i].op() == logic::Op::Name) append(edge, nodes[i].name());
      for (const std::uint32_t operand : nodes.operands(i))
        edge.insert(edge.end(), small[operand].begin(), small[operand].end());
      std::sort(edge.begin(), edge.end());
      edge.erase(std::unique(edge.begin(), edge.end()), edge.end());
      if (edge.size() > most_together) edge.clear();
      if (nodes.operands(i).size() > 1) add_edge(edge);
      small.push_back(std::move(edge));
    }
  }

  void add_update(const spec::Memory& memory) {
    Edge edge = variables_of(memory.update);
    for (const auto& guarded : memory.cases) {
      const Edge more = variables_of(guarded.guard);
      edge.insert(edge.end(), more.begin(), more.end());
    }
    edge.push_back(names_.at(memory.variable.name).front());
    std::sort(edge.begin(), edge.end());
    edge.erase(std::unique(edge.begin(), edge.end()), edge.end());
    add_edge(std::move(edge));
  }

  void append(Edge& edge, const std::string& name) const {
    const auto found = names_.find(name);
    if (found != names_.end()) edge.insert(edge.end(), found->second.begin(), found->second.end());
  }

  [[nodiscard]] Edge variables_of(const logic::Formula& formula) const {
    return variables_of(logic::postorder(formula));
  }

  [[nodiscard]] Edge variables_of(const std::vector<logic::Formula>& nodes) const {
    Edge edge;
    for (const logic::Formula& node : nodes) {
      if (node.op() == logic::Op::Name) append(edge, node.name());
    }
    std::sort(edge.begin(), edge.end());
    edge.erase(std::unique(edge.begin(), edge.end()), edge.end());
    return edge;
  }

  std::size_t variables_ = 0;
  std::unordered_map<std::string, Edge> names_;
  std::vector<Edge> edges_;
};

std::uint64_t total_span(const std::vector<Edge>& edges, const std::vector<std::size_t>& position) {
  std::uint64_t span = 0;
  for (const Edge& edge : edges) {
    std::size_t low = position[edge.front()];
    std::size_t high = low;
    for (const std::size_t variable : edge) {
      low = std::min(low, position[variable]);
      high = std::max(high, position[variable]);
    }
    span += high - low;
  }
  return span;
}

/// Moves every variable to the mean centre of its edges.
std::vector<std::size_t> one_round(const std::vector<Edge>& edges, const std::vector<std::size_t>& position) {
  const std::size_t n = position.size();
  std::vector<double> sum(n, 0);
  std::vector<std::size_t> count(n, 0);
  for (const Edge& edge : edges) {
    double centre = 0;
    for (const std::size_t variable : edge) centre += static_cast<double>(position[variable]);
    centre /= static_cast<double>(edge.size());
    for (const std::size_t variable : edge) {
      sum[variable] += centre;
      ++count[variable];
    }
  }
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto goal = [&](std::size_t variable) {
    return count[variable] == 0 ? static_cast<double>(position[variable])
                                : sum[variable] / static_cast<double>(count[variable]);
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return goal(a) < goal(b); });
  std::vector<std::size_t> moved(n);
  for (std::size_t i = 0; i < n; ++i) moved[order[i]] = i;
  return moved;
}

/// Which variable each one stands beside: itself, or the one that shares most of its clauses. A request that
/// is spoken of with its grant alone belongs beside it, wherever a hundred grants that exclude each other
/// pull one another.
std::vector<std::size_t> hosts_of(const std::vector<Edge>& edges, std::size_t variables) {
  std::vector<std::map<std::size_t, double>> shared(variables);
  std::vector<std::size_t> degree(variables, 0);
  for (const Edge& edge : edges) {
    for (const std::size_t variable : edge) {
      ++degree[variable];
      if (edge.size() > most_together) continue;
      for (const std::size_t other : edge)
        shared[variable][other] += 1.0 / static_cast<double>(edge.size() - 1);
    }
  }
  std::vector<std::size_t> hosts(variables);
  std::iota(hosts.begin(), hosts.end(), std::size_t{0});
  for (std::size_t variable = 0; variable < variables; ++variable) {
    double most = static_cast<double>(degree[variable]) / 2;
    for (const auto& [other, share] : shared[variable]) {
      // Hosts have more clauses than their guests, so that nobody is the guest of a guest's guest for ever.
      if (degree[other] <= degree[variable] || share <= most) continue;
      most = share;
      hosts[variable] = other;
    }
  }
  return hosts;
}

/// The edges between hosts; guests are left where they are.
std::vector<Edge> between_hosts(const std::vector<Edge>& edges, const std::vector<std::size_t>& hosts) {
  std::vector<Edge> result;
  for (Edge edge : edges) {
    for (std::size_t& variable : edge)
      while (hosts[variable] != variable) variable = hosts[variable];
    std::sort(edge.begin(), edge.end());
    edge.erase(std::unique(edge.begin(), edge.end()), edge.end());
    if (edge.size() > 1) result.push_back(std::move(edge));
  }
  return result;
}

/// \p order with every guest behind its host.
std::vector<std::size_t> with_guests(const std::vector<std::size_t>& order,
                                     const std::vector<std::size_t>& hosts) {
  std::vector<std::vector<std::size_t>> guests(order.size());
  for (const std::size_t variable : order)
    if (hosts[variable] != variable) guests[hosts[variable]].push_back(variable);
  std::vector<std::size_t> result;
  for (const std::size_t variable : order) {
    if (hosts[variable] != variable) continue;
    std::vector<std::size_t> open{variable};
    while (!open.empty()) {
      const std::size_t here = open.back();
      open.pop_back();
      result.push_back(here);
      open.insert(open.end(), guests[here].rbegin(), guests[here].rend());
    }
  }
  return result;
}

}  // namespace

std::vector<std::size_t> static_order(const spec::Gr1& spec) {
  const Edges graph(spec);
  const std::vector<std::size_t> hosts = hosts_of(graph.edges(), graph.variables());
  const std::vector<Edge> edges = between_hosts(graph.edges(), hosts);
  std::vector<std::size_t> position(graph.variables());
  std::iota(position.begin(), position.end(), std::size_t{0});
  std::vector<std::size_t> best = position;
  std::uint64_t best_span = total_span(edges, position);
  constexpr int most_rounds = 200;
  constexpr int patience = 10;
  for (int round = 0, stale = 0; round < most_rounds && stale < patience; ++round, ++stale) {
    position = one_round(edges, position);
    const std::uint64_t span = total_span(edges, position);
    if (span >= best_span) continue;
    best_span = span;
    best = position;
    stale = 0;
  }
  std::vector<std::size_t> order(best.size());
  for (std::size_t i = 0; i < best.size(); ++i) order[best[i]] = i;
  return with_guests(order, hosts);
}

}  // namespace heed::game
