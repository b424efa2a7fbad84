#include "structural.h"

#include <fmt/format.h>

#include <array>

namespace heed::owl {
namespace {

constexpr std::array<std::string_view, 6> kind_words = {
    "a class",      "a datatype", "an object property", "a data property", "an annotation property",
    "an individual"};

}  // namespace

void Arguments::wrong(std::string_view expected) const {
  if (next_ == last_)
    names_.fail(offset_, "too-few", fmt::format("{} ends where {} is expected", word_, expected));
  names_.fail(next_->offset, "wrong-argument", fmt::format("{} is expected here in {}", expected, word_),
              "compare the order of the parts in docs/formats/owl.md");
}

void Arguments::expect_end() const {
  if (next_ == last_) return;
  names_.fail(next_->offset, "too-many", fmt::format("{} takes nothing more here", word_));
}

Iri Arguments::entity(EntityKind kind) {
  const auto* name = peek<StructuralBuilder::Name>();
  if (name == nullptr || (name->typed && name->kind != kind))
    wrong(kind_words[static_cast<std::size_t>(kind)]);
  const Iri out = (next_++, name->iri);
  if (kind != EntityKind::NamedIndividual && names_.iris().text(out).starts_with("_:")) {
    --next_;
    wrong(kind_words[static_cast<std::size_t>(kind)]);
  }
  names_.use(kind, out);
  return out;
}

Iri Arguments::iri() {
  if (!peek<StructuralBuilder::Name>()) wrong("a name");
  return take<StructuralBuilder::Name>().iri;
}

ClassExpression Arguments::class_expression() {
  if (peek<ClassExpression>()) return take<ClassExpression>();
  if (!peek<StructuralBuilder::Name>()) wrong("a class expression");
  return ClassExpression::named(named_class());
}

ObjectProperty Arguments::property() {
  if (peek<ObjectProperty>()) return take<ObjectProperty>();
  return {entity(EntityKind::ObjectProperty), false};
}

DataRange Arguments::range() {
  if (!peek<DataRange>()) return DataRange::datatype(entity(EntityKind::Datatype));
  depth_ = std::max(depth_, next_->depth);
  return take<DataRange>();
}

Literal Arguments::literal() {
  if (!peek<Literal>()) wrong("a literal");
  return take<Literal>();
}

AnnotationValue Arguments::annotation_value() {
  if (peek<Literal>()) return take<Literal>();
  return iri();
}

std::uint32_t Arguments::number() {
  if (!peek<std::uint32_t>()) wrong("a natural number");
  return take<std::uint32_t>();
}

std::vector<ObjectProperty> Arguments::chain() {
  if (!peek<StructuralBuilder::Properties>()) return {property()};
  auto out = take<StructuralBuilder::Properties>();
  if (!out.chain) {
    --next_;
    wrong("an object property");
  }
  return std::move(out.members);
}

template <class Take>
auto Arguments::rest(std::size_t at_least, std::string_view what, Take take_one) {
  std::vector<decltype(take_one())> out;
  while (!at_end()) out.push_back(take_one());
  if (out.size() < at_least) wrong(what);
  return out;
}

std::vector<ClassExpression> Arguments::classes(std::size_t at_least) {
  return rest(at_least, "another class expression", [this] { return class_expression(); });
}
std::vector<ObjectProperty> Arguments::properties(std::size_t at_least) {
  return rest(at_least, "another object property", [this] { return property(); });
}
std::vector<Iri> Arguments::entities(EntityKind kind, std::size_t at_least) {
  return rest(at_least, kind_words[static_cast<std::size_t>(kind)], [this, kind] { return entity(kind); });
}

std::vector<Annotation> Arguments::annotations() {
  std::vector<Annotation> out;
  while (peek<Annotation>()) {
    depth_ = std::max(depth_, next_->depth);
    out.push_back(take<Annotation>());
  }
  return out;
}

}  // namespace heed::owl
