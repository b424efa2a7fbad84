#include "structural.h"

#include <heed/owl/vocabulary.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

namespace heed::owl {
namespace {

using Group = StructuralBuilder::Group;

constexpr std::uint32_t most_range_depth = 200;
constexpr std::uint32_t most_annotation_depth = 32;

struct Word {
  Group group;
  unsigned code;
};

constexpr std::array<std::string_view, 6> entity_words = {
    "Class", "Datatype", "ObjectProperty", "DataProperty", "AnnotationProperty", "NamedIndividual"};

std::map<std::string_view, Word> make_words() {
  std::map<std::string_view, Word> out;
  const auto add = [&](Group group, const auto& words, unsigned first) {
    for (const std::string_view word : words) out.emplace(word, Word{group, first++});
  };
  add(Group::Axiom, axiom_words(), 0);
  add(Group::Class, class_words(), 1);
  add(Group::Range, range_words(), 1);
  add(Group::Entity, entity_words, 0);
  out.emplace("", Word{Group::Bracket, 0});
  out.emplace("Annotation", Word{Group::Annotation, 0});
  out.emplace("ObjectInverseOf", Word{Group::Inverse, 0});
  out.emplace("ObjectPropertyChain", Word{Group::Chain, 0});
  out.emplace("FacetRestriction", Word{Group::Facet, 0});
  for (const char* rule : {"DLSafeRule", "DGRule", "DescriptionGraph"})
    out.emplace(rule, Word{Group::Rule, 0});
  return out;
}

const std::map<std::string_view, Word>& words() {
  static const std::map<std::string_view, Word> table = make_words();
  return table;
}

}  // namespace

void StructuralBuilder::open(std::string_view word, std::size_t offset) {
  const std::size_t nesting = names_.limits().nesting;
  if (nesting != 0 && frames_.size() + ignored_ >= nesting)
    names_.fail(offset, "nesting", fmt::format("expressions nest more than {} deep", nesting),
                "give the inner expression a name of its own");
  if (ignored_ > 0) {
    ++ignored_;
    return;
  }
  const auto found = words().find(word);
  if (found == words().end()) {
    std::vector<std::string> known;
    for (const auto& entry : words()) known.emplace_back(entry.first);
    names_.fail(offset, "unknown-word", fmt::format("'{}' is no word of OWL 2", word),
                util::suggestion(word, known));
  }
  const auto& [name, meaning] = *found;
  const bool leads = meaning.group == Group::Axiom || meaning.group == Group::Rule;
  if (leads != frames_.empty() && meaning.group != Group::Annotation)
    names_.fail(offset, "misplaced",
                leads ? fmt::format("{} stands inside {}, but is an axiom", word, frames_.back().word)
                      : fmt::format("'{}' stands where an axiom is expected", word));
  if (meaning.group == Group::Rule) {
    ignored_ = 1;
    return names_.warn(offset, "swrl", fmt::format("{} is no axiom of OWL 2 and is left out", word),
                       "write it as class axioms where that is possible");
  }
  frames_.push_back({name, meaning.group, meaning.code, offset, arguments_.size()});
}

void StructuralBuilder::close() {
  if (ignored_ > 0) {
    --ignored_;
    return;
  }
  const Frame frame = frames_.back();
  frames_.pop_back();
  if (frame.group == Group::Axiom) {
    axiom(frame);
    arguments_.resize(frame.first, {std::uint32_t{0}, 0});
    return;
  }
  Argument made = built(frame);
  arguments_.resize(frame.first, {std::uint32_t{0}, 0});
  if (frames_.empty())
    parsed_.annotations.push_back(std::get<Annotation>(std::move(made.value)));
  else
    arguments_.push_back(std::move(made));
}

void StructuralBuilder::axiom(const Frame& frame) {
  Arguments arguments(names_, frame.word, frame.offset, arguments_.data() + frame.first,
                      arguments_.data() + arguments_.size());
  std::vector<Annotation> annotations = arguments.annotations();
  AxiomContent content = build_axiom(frame.code, arguments);
  arguments.expect_end();
  const auto* declared = std::get_if<Declaration>(&content);
  if (declared != nullptr && declared->entity.id < vocabulary::size) return;
  parsed_.drafts.push_back(
      {std::move(content), std::move(annotations), static_cast<std::uint32_t>(frame.offset)});
}

StructuralBuilder::Argument StructuralBuilder::built(const Frame& frame) {
  Arguments in(names_, frame.word, frame.offset, arguments_.data() + frame.first,
               arguments_.data() + arguments_.size());
  const auto make = [&]() -> Value {
    switch (frame.group) {
      case Group::Class:
        return build_class(frame.code, in);
      case Group::Range:
        return build_range(frame.code, in);
      case Group::Entity:
        return Name{in.iri(), true, static_cast<EntityKind>(frame.code)};
      case Group::Inverse: {
        ObjectProperty inner = in.property();
        inner.inverse = !inner.inverse;
        return inner;
      }
      case Group::Chain:
        return Properties{in.properties(2), true};
      case Group::Bracket: {
        Properties out;
        while (!in.at_end())
          out.members.push_back(in.peek<ObjectProperty>() ? in.property() : ObjectProperty{in.iri(), false});
        return out;
      }
      case Group::Facet: {
        const Iri facet = in.iri();
        return Facet{facet, in.literal()};
      }
      default: {
        std::vector<Annotation> inner = in.annotations();
        const Iri property = in.annotation_property();
        return Annotation{property, in.annotation_value(), std::move(inner)};
      }
    }
  };
  Argument out{make(), frame.offset, 0};
  in.expect_end();
  const bool range = frame.group == Group::Range;
  if (!range && frame.group != Group::Annotation) return out;
  out.depth = in.depth() + 1;
  if (out.depth > (range ? most_range_depth : most_annotation_depth))
    names_.fail(frame.offset, "nesting",
                range
                    ? fmt::format("data ranges nest more than {} deep", most_range_depth)
                    : fmt::format("annotations of annotations nest more than {} deep", most_annotation_depth),
                range ? "give the inner range a name by DatatypeDefinition" : "annotate the axiom itself");
  return out;
}

void StructuralBuilder::push(Value value, std::size_t offset, std::uint32_t depth) {
  if (ignored_ > 0) return;
  if (frames_.empty()) names_.fail(offset, "misplaced", "an axiom is expected");
  arguments_.push_back({std::move(value), offset, depth});
}

void StructuralBuilder::name(Iri iri, std::size_t offset) {
  push(Name{iri, false, {}}, offset);
}
void StructuralBuilder::entity(EntityKind kind, Iri iri, std::size_t offset) {
  push(Name{iri, true, kind}, offset);
}
void StructuralBuilder::literal(Literal literal, std::size_t offset) {
  push(std::move(literal), offset);
}
void StructuralBuilder::number(std::uint32_t n, std::size_t offset) {
  push(n, offset);
}

}  // namespace heed::owl
