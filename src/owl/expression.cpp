#include <heed/owl/expression.h>
#include <heed/owl/vocabulary.h>

#include <algorithm>
#include <cassert>

namespace heed::owl {

struct DataRange::Node {
  std::vector<DataRange> operands;
  std::vector<Literal> literals;
  std::vector<Facet> facets;

  Node() = default;
  Node(const Node&) = delete;
  Node(Node&&) = default;
  Node& operator=(const Node&) = delete;
  Node& operator=(Node&&) = delete;
  /// Nested nodes move into one list first, so that a deep range does not exhaust the stack.
  ~Node() {
    std::vector<DataRange> pending = std::move(operands);
    while (!pending.empty()) {
      const DataRange last = std::move(pending.back());
      pending.pop_back();
      if (last.node_ && last.node_.use_count() == 1) {
        auto& inner = const_cast<Node&>(*last.node_).operands;
        std::move(inner.begin(), inner.end(), std::back_inserter(pending));
        inner.clear();
      }
    }
  }
};

DataRange::DataRange(Kind kind, Iri iri, std::shared_ptr<const Node> node)
    : kind_(kind), iri_(iri), node_(std::move(node)) {}

DataRange DataRange::datatype(Iri iri) {
  return {Kind::Datatype, iri, nullptr};
}

DataRange DataRange::intersection(std::vector<DataRange> operands) {
  Node node;
  node.operands = std::move(operands);
  return {Kind::Intersection, {}, std::make_shared<Node>(std::move(node))};
}

DataRange DataRange::union_of(std::vector<DataRange> operands) {
  Node node;
  node.operands = std::move(operands);
  return {Kind::Union, {}, std::make_shared<Node>(std::move(node))};
}

DataRange DataRange::complement(DataRange operand) {
  Node node;
  node.operands.push_back(std::move(operand));
  return {Kind::Complement, {}, std::make_shared<Node>(std::move(node))};
}

DataRange DataRange::one_of(std::vector<Literal> literals) {
  Node node;
  node.literals = std::move(literals);
  return {Kind::OneOf, {}, std::make_shared<Node>(std::move(node))};
}

DataRange DataRange::restriction(Iri datatype, std::vector<Facet> facets) {
  Node node;
  node.facets = std::move(facets);
  return {Kind::Restriction, datatype, std::make_shared<Node>(std::move(node))};
}

const std::vector<DataRange>& DataRange::operands() const {
  static const std::vector<DataRange> none;
  return node_ ? node_->operands : none;
}

const std::vector<Literal>& DataRange::literals() const {
  static const std::vector<Literal> none;
  return node_ ? node_->literals : none;
}

const std::vector<Facet>& DataRange::facets() const {
  static const std::vector<Facet> none;
  return node_ ? node_->facets : none;
}

struct ClassExpression::Node {
  std::vector<ClassExpression> operands;  ///< The filler is operand 0.
  std::vector<Iri> names;                 ///< Individuals, or data properties.
  ObjectProperty property;
  std::uint32_t cardinality = 0;
  std::uint32_t depth = 1;
  std::optional<DataRange> range;
  std::optional<Literal> literal;

  Node() = default;
  Node(const Node&) = delete;
  Node(Node&&) = default;
  Node& operator=(const Node&) = delete;
  Node& operator=(Node&&) = delete;
  ~Node() {
    std::vector<ClassExpression> pending = std::move(operands);
    while (!pending.empty()) {
      const ClassExpression last = std::move(pending.back());
      pending.pop_back();
      if (last.node_ && last.node_.use_count() == 1) {
        auto& inner = const_cast<Node&>(*last.node_).operands;
        std::move(inner.begin(), inner.end(), std::back_inserter(pending));
        inner.clear();
      }
    }
  }
};

ClassExpression::ClassExpression(Kind kind, Iri iri, std::shared_ptr<const Node> node)
    : kind_(kind), iri_(iri), node_(std::move(node)) {}

ClassExpression::ClassExpression() : ClassExpression(Kind::Class, vocabulary::owl_thing, nullptr) {}

ClassExpression ClassExpression::make(Kind kind, Node&& node) {
  for (const ClassExpression& operand : node.operands) node.depth = std::max(node.depth, operand.depth() + 1);
  return {kind, {}, std::make_shared<Node>(std::move(node))};
}

ClassExpression ClassExpression::named(Iri iri) {
  return {Kind::Class, iri, nullptr};
}
ClassExpression ClassExpression::thing() {
  return named(vocabulary::owl_thing);
}
ClassExpression ClassExpression::nothing() {
  return named(vocabulary::owl_nothing);
}

ClassExpression ClassExpression::intersection(std::vector<ClassExpression> operands) {
  if (operands.empty()) return thing();
  if (operands.size() == 1) return operands.front();
  Node node;
  node.operands = std::move(operands);
  return make(Kind::Intersection, std::move(node));
}

ClassExpression ClassExpression::union_of(std::vector<ClassExpression> operands) {
  if (operands.empty()) return nothing();
  if (operands.size() == 1) return operands.front();
  Node node;
  node.operands = std::move(operands);
  return make(Kind::Union, std::move(node));
}

ClassExpression ClassExpression::complement(ClassExpression operand) {
  Node node;
  node.operands.push_back(std::move(operand));
  return make(Kind::Complement, std::move(node));
}

ClassExpression ClassExpression::one_of(std::vector<Iri> individuals) {
  if (individuals.empty()) return nothing();
  Node node;
  node.names = std::move(individuals);
  return make(Kind::OneOf, std::move(node));
}

ClassExpression ClassExpression::some(ObjectProperty property, ClassExpression filler) {
  Node node;
  node.property = property;
  node.operands.push_back(std::move(filler));
  return make(Kind::Some, std::move(node));
}

ClassExpression ClassExpression::only(ObjectProperty property, ClassExpression filler) {
  Node node;
  node.property = property;
  node.operands.push_back(std::move(filler));
  return make(Kind::Only, std::move(node));
}

ClassExpression ClassExpression::has_value(ObjectProperty property, Iri individual) {
  Node node;
  node.property = property;
  node.names.push_back(individual);
  return make(Kind::HasValue, std::move(node));
}

ClassExpression ClassExpression::has_self(ObjectProperty property) {
  Node node;
  node.property = property;
  return make(Kind::HasSelf, std::move(node));
}

ClassExpression ClassExpression::cardinality_of(Kind kind, std::uint32_t n, ObjectProperty property,
                                                ClassExpression filler) {
  assert(kind == Kind::Min || kind == Kind::Max || kind == Kind::Exactly);
  Node node;
  node.property = property;
  node.cardinality = n;
  node.operands.push_back(std::move(filler));
  return make(kind, std::move(node));
}

ClassExpression ClassExpression::data_quantified(Kind kind, std::vector<Iri> properties, DataRange range) {
  assert(kind == Kind::DataSome || kind == Kind::DataOnly);
  Node node;
  node.names = std::move(properties);
  node.range = std::move(range);
  return make(kind, std::move(node));
}

ClassExpression ClassExpression::data_has_value(Iri property, Literal literal) {
  Node node;
  node.names.push_back(property);
  node.literal = std::move(literal);
  return make(Kind::DataHasValue, std::move(node));
}

ClassExpression ClassExpression::data_cardinality(Kind kind, std::uint32_t n, Iri property, DataRange range) {
  assert(kind == Kind::DataMin || kind == Kind::DataMax || kind == Kind::DataExactly);
  Node node;
  node.names.push_back(property);
  node.cardinality = n;
  node.range = std::move(range);
  return make(kind, std::move(node));
}

bool ClassExpression::is_thing() const {
  return is_named() && iri_ == vocabulary::owl_thing;
}
bool ClassExpression::is_nothing() const {
  return is_named() && iri_ == vocabulary::owl_nothing;
}

const std::vector<ClassExpression>& ClassExpression::operands() const {
  static const std::vector<ClassExpression> none;
  return node_ ? node_->operands : none;
}

const ClassExpression& ClassExpression::filler() const {
  assert(node_ && !node_->operands.empty());
  return node_->operands.front();
}

ObjectProperty ClassExpression::property() const {
  return node_ ? node_->property : ObjectProperty{};
}

const std::vector<Iri>& ClassExpression::individuals() const {
  static const std::vector<Iri> none;
  return node_ ? node_->names : none;
}

const std::vector<Iri>& ClassExpression::data_properties() const {
  return individuals();
}

const DataRange& ClassExpression::range() const {
  assert(node_ && node_->range);
  return *node_->range;
}

const Literal& ClassExpression::literal() const {
  assert(node_ && node_->literal);
  return *node_->literal;
}

std::uint32_t ClassExpression::cardinality() const {
  return node_ ? node_->cardinality : 0;
}
std::uint32_t ClassExpression::depth() const {
  return node_ ? node_->depth : 0;
}

bool ClassExpression::identical(const ClassExpression& other) const {
  return kind_ == other.kind_ && iri_ == other.iri_ && node_ == other.node_;
}

}  // namespace heed::owl
