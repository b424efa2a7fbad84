#include "cycles.h"

#include <algorithm>
#include <unordered_map>

namespace heed::check {
namespace {

/// Strongly connected components of the product without the edges that meet one justice, and the justices
/// that their inner edges meet. An edge is an inner one exactly when its target is still on the stack once
/// the edge was followed. \cite tarjan.72.sicomp
class Components {
 public:
  Components(const Product& product, std::size_t justice, util::Budget& budget)
      : product_(product),
        justice_(justice),
        budget_(budget),
        order_(product.nodes.size(), none),
        low_(order_),
        of_(order_),
        marks_(product.nodes.size() * product.words),
        has_inner_(product.nodes.size()) {
    for (std::uint32_t node = 0; node < order_.size(); ++node)
      if (order_[node] == none) visit(node);
  }
  /// Whether the component has an inner edge; of each component, true once.
  bool take_cycle(std::size_t component) {
    const bool cycle = cycle_[component];
    cycle_[component] = false;
    return cycle;
  }
  /// Whether inner edges of the component meet each of the first \p justices.
  [[nodiscard]] bool meets_first(std::size_t component, std::size_t justices) const {
    for (std::size_t i = 0; i < justices; ++i)
      if (((met_[component * product_.words + i / 64] >> (i % 64)) & 1U) == 0) return false;
    return true;
  }
  [[nodiscard]] std::uint32_t of(std::uint32_t node) const { return of_[node]; }
  [[nodiscard]] bool inner(std::uint32_t node, std::size_t edge) const {
    return !product_.meets(edge, justice_) && of_[product_.edges[edge].target] == of_[node];
  }

 private:
  struct Frame {
    std::uint32_t node;
    std::size_t edge;
  };

  void visit(std::uint32_t root) {
    open(root);
    while (!frames_.empty()) {
      const std::uint32_t fresh = advance(frames_.back());
      if (fresh == none)
        close();
      else
        open(fresh);
    }
  }

  /// Follows the frame's edges up to one that leads to a node not seen before: that node, or none.
  std::uint32_t advance(Frame& frame) {
    const std::size_t end = product_.first[frame.node + 1];
    while (frame.edge != end) {
      const std::size_t edge = frame.edge++;
      if (product_.meets(edge, justice_)) continue;
      const std::uint32_t target = product_.edges[edge].target;
      if (order_[target] == none) return target;
      if (of_[target] != none) continue;
      low_[frame.node] = std::min(low_[frame.node], order_[target]);
      add_inner(frame.node, edge);
    }
    return none;
  }

  void add_inner(std::uint32_t node, std::size_t edge) {
    has_inner_[node] = 1;
    for (std::size_t w = 0; w < product_.words; ++w)
      marks_[node * product_.words + w] |= product_.marks[edge * product_.words + w];
  }

  void open(std::uint32_t node) {
    if ((next_ & 0xff) == 0) budget_.check();
    order_[node] = low_[node] = next_++;
    stack_.push_back(node);
    frames_.push_back({node, product_.first[node]});
  }

  void close() {
    const std::uint32_t node = frames_.back().node;
    frames_.pop_back();
    if (low_[node] != order_[node]) {
      const Frame& parent = frames_.back();
      low_[parent.node] = std::min(low_[parent.node], low_[node]);
      add_inner(parent.node, parent.edge - 1);
      return;
    }
    met_.resize(met_.size() + product_.words);
    std::uint64_t* const met = met_.data() + met_.size() - product_.words;
    bool cycle = false;
    std::uint32_t member = none;
    while (member != node) {
      member = stack_.back();
      stack_.pop_back();
      of_[member] = count_;
      cycle = cycle || has_inner_[member] != 0;
      for (std::size_t w = 0; w < product_.words; ++w) met[w] |= marks_[member * product_.words + w];
    }
    cycle_.push_back(cycle);
    ++count_;
  }

  const Product& product_;
  std::size_t justice_;
  util::Budget& budget_;
  std::vector<std::uint32_t> order_, low_, of_, stack_;
  std::vector<std::uint64_t> marks_;     ///< Per node: of its inner edges.
  std::vector<std::uint8_t> has_inner_;  ///< Per node.
  std::vector<std::uint64_t> met_;       ///< Per component: of all its inner edges.
  std::vector<bool> cycle_;              ///< Per component.
  std::vector<Frame> frames_;
  std::uint32_t next_ = 0, count_ = 0;
};

/// A closed walk within one component that takes an edge of every environment justice.
class Lasso {
 public:
  Lasso(const Product& product, const Components& components, std::size_t env_justices)
      : product_(product), components_(components), env_justices_(env_justices) {}

  std::vector<std::size_t> loop(std::uint32_t start) {
    std::vector<std::size_t> edges;
    std::uint32_t at = start;
    const auto append = [&](const std::vector<std::size_t>& path) {
      edges.insert(edges.end(), path.begin(), path.end());
      if (!path.empty()) at = product_.edges[path.back()].target;
    };
    for (std::size_t i = 0; i < env_justices_; ++i) {
      const auto meets = [&](std::size_t edge) { return product_.meets(edge, i); };
      if (std::none_of(edges.begin(), edges.end(), meets)) append(walk(at, meets));
    }
    if (edges.empty() || at != start)
      append(walk(at, [&](std::size_t edge) { return product_.edges[edge].target == start; }));
    return edges;
  }

 private:
  /// A shortest walk from \p from whose last edge is wanted.
  template <typename Wanted>
  std::vector<std::size_t> walk(std::uint32_t from, Wanted wanted) const {
    std::unordered_map<std::uint32_t, std::pair<std::uint32_t, std::size_t>> came;
    std::vector<std::uint32_t> queue{from};
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const std::uint32_t node = queue[next];
      for (std::size_t edge = product_.first[node]; edge < product_.first[node + 1]; ++edge) {
        if (!components_.inner(node, edge)) continue;
        if (wanted(edge)) return path(from, node, edge, came);
        const std::uint32_t target = product_.edges[edge].target;
        if (target != from && came.emplace(target, std::pair{node, edge}).second) queue.push_back(target);
      }
    }
    return {};
  }

  static std::vector<std::size_t> path(
      std::uint32_t from, std::uint32_t node, std::size_t last,
      const std::unordered_map<std::uint32_t, std::pair<std::uint32_t, std::size_t>>& came) {
    std::vector<std::size_t> out{last};
    while (node != from) {
      const auto& [before, edge] = came.at(node);
      out.push_back(edge);
      node = before;
    }
    std::reverse(out.begin(), out.end());
    return out;
  }

  const Product& product_;
  const Components& components_;
  std::size_t env_justices_;
};

Refutation lasso(const Explorer& explorer, const spec::Clause& clause, std::uint32_t start,
                 const std::vector<std::size_t>& loop) {
  Refutation out{Refutation::Kind::Justice, clause.text,
                 "a guarantee is not met again and again although every assumption is", explorer.trace(start),
                 0};
  out.loop_start = out.trace.size();
  for (const std::size_t edge : loop) out.trace.push_back(explorer.step(explorer.product().edges[edge].row));
  return out;
}

}  // namespace

void check_justice(const Explorer& explorer, const Rules& rules, util::Budget& budget, const Options& options,
                   Verdict& verdict) {
  const Product& product = explorer.product();
  for (std::size_t j = 0; j < rules.sys_justices && verdict.refutations.size() < options.most; ++j) {
    Components components(product, rules.env_justices + j, budget);
    for (std::uint32_t node = 0; node < product.nodes.size() && verdict.refutations.size() < options.most;
         ++node) {
      if (!components.take_cycle(components.of(node))) continue;
      if (!components.meets_first(components.of(node), rules.env_justices)) {
        verdict.relies_on_broken_justice = true;
      } else {
        const auto loop = Lasso(product, components, rules.env_justices).loop(node);
        verdict.refutations.push_back(lasso(explorer, rules.spec.sys_justice[j], node, loop));
      }
    }
  }
}

}  // namespace heed::check
