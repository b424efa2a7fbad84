#include "taxonomy.h"

#include <heed/owl/vocabulary.h>

#include <algorithm>

namespace heed::dl {

namespace v = owl::vocabulary;

std::size_t Taxonomy::node_of(owl::Iri iri) const {
  return iri.id < index.size() ? index[iri.id] : npos;
}

namespace {

struct Input {
  const std::vector<owl::Iri>& classes;
  const std::vector<std::vector<owl::Iri>>& supers;
  const std::vector<bool>& unsatisfiable;
};

/// One node per group of classes that are below each other.
void group(const Input& input, Taxonomy& out) {
  std::vector<std::size_t> place(out.index.size(), Taxonomy::npos);
  for (std::size_t i = 0; i < input.classes.size(); ++i) place[input.classes[i].id] = i;
  const auto below = [&](std::size_t i, owl::Iri super) {
    return std::binary_search(input.supers[i].begin(), input.supers[i].end(), super);
  };
  for (std::size_t i = 0; i < input.classes.size(); ++i) {
    const owl::Iri self = input.classes[i];
    if (input.unsatisfiable[i] || out.index[self.id] != Taxonomy::npos) continue;
    TaxonomyNode node;
    for (const owl::Iri super : input.supers[i])
      if (super == self || (place[super.id] != Taxonomy::npos && below(place[super.id], self)))
        node.classes.push_back(super);
    for (const owl::Iri member : node.classes) out.index[member.id] = out.nodes.size();
    out.nodes.push_back(std::move(node));
  }
}

/// Direct parents: superclasses that are above no other superclass.
void link(const Input& input, Taxonomy& out) {
  std::vector<std::vector<std::size_t>> above(out.nodes.size());
  for (std::size_t i = 0; i < input.classes.size(); ++i) {
    const std::size_t self = out.index[input.classes[i].id];
    if (self <= 1 || !above[self].empty()) continue;
    for (const owl::Iri super : input.supers[i]) {
      const std::size_t node = out.index[super.id];
      if (node != self && node > 1) above[self].push_back(node);
    }
    std::sort(above[self].begin(), above[self].end());
    above[self].erase(std::unique(above[self].begin(), above[self].end()), above[self].end());
  }
  std::vector<std::size_t> marked(out.nodes.size(), 0);
  for (std::size_t node = 2; node < out.nodes.size(); ++node) {
    for (const std::size_t super : above[node])
      for (const std::size_t far : above[super]) marked[far] = node;
    for (const std::size_t super : above[node])
      if (marked[super] != node) out.nodes[node].parents.push_back(super);
    if (out.nodes[node].parents.empty()) out.nodes[node].parents.push_back(0);
    for (const std::size_t parent : out.nodes[node].parents) out.nodes[parent].children.push_back(node);
  }
  for (std::size_t node = 2; node < out.nodes.size(); ++node) {
    if (!out.nodes[node].children.empty()) continue;
    out.nodes[node].children.push_back(1);
    out.nodes[1].parents.push_back(node);
  }
  if (out.nodes[0].children.empty()) {
    out.nodes[0].children.push_back(1);
    out.nodes[1].parents.push_back(0);
  }
}

}  // namespace

Taxonomy build_taxonomy(const std::vector<owl::Iri>& classes,
                        const std::vector<std::vector<owl::Iri>>& supers,
                        const std::vector<bool>& unsatisfiable, const std::vector<owl::Iri>& thing,
                        std::size_t iri_count) {
  Taxonomy out;
  out.index.assign(iri_count, Taxonomy::npos);
  out.nodes.resize(2);
  out.nodes[0].classes.push_back(v::owl_thing);
  out.nodes[1].classes.push_back(v::owl_nothing);
  for (const owl::Iri iri : thing) out.nodes[0].classes.push_back(iri);
  for (std::size_t i = 0; i < classes.size(); ++i)
    if (unsatisfiable[i]) out.nodes[1].classes.push_back(classes[i]);
  for (std::size_t node = 0; node < 2; ++node)
    for (const owl::Iri iri : out.nodes[node].classes) out.index[iri.id] = node;
  const Input input{classes, supers, unsatisfiable};
  group(input, out);
  link(input, out);
  return out;
}

}  // namespace heed::dl
