#include "ontologies.h"

#include <fmt/format.h>

#include <vector>

namespace heed::bench {
namespace {

constexpr std::size_t properties = 20;

/// \cite steele.14.oopsla
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::size_t below(std::size_t n) {
    state_ += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    return static_cast<std::size_t>((z ^ (z >> 31U)) % n);
  }

 private:
  std::uint64_t state_;
};

constexpr const char* head =
    "Prefix(:=<https://example.org/bench#>)\nPrefix(owl:=<http://www.w3.org/2002/07/owl#>)\n"
    "Ontology(<https://example.org/bench>\n";

class Population {
 public:
  explicit Population(const PopulatedSigns& wanted) : wanted_(wanted), random_(wanted.seed), text_(head) {}

  std::string write() {
    declare();
    for (std::size_t k = 0; k < wanted_.kinds; ++k) define(k);
    for (std::size_t i = 0; i < wanted_.individuals; ++i) {
      say(fmt::format("ClassAssertion(:Sign :sign{})", i));
      for (const Role& role : roles_)
        say(fmt::format("ObjectPropertyAssertion(:{} :sign{} :{}{})", role.name, i, role.value,
                        random_.below(role.values)));
    }
    for (std::size_t i = 1; i < wanted_.individuals && count_ < wanted_.axioms; ++i)
      say(fmt::format("ObjectPropertyAssertion(:next :sign{} :sign{})", i - 1, i));
    while (count_ < wanted_.axioms)
      say(fmt::format("ObjectPropertyAssertion(:near :sign{} :sign{})", random_.below(wanted_.individuals),
                      random_.below(wanted_.individuals)));
    return text_ + ")\n";
  }

 private:
  struct Role {
    const char *name, *value;
    std::size_t values;
  };

  void say(const std::string& axiom) {
    text_ += axiom + '\n';
    ++count_;
  }

  void declare() {
    say("SymmetricObjectProperty(:near)");
    say("TransitiveObjectProperty(:next)");
    for (const Role& role : roles_) {
      std::string all;
      for (std::size_t v = 0; v < role.values; ++v) all += fmt::format(" :{}{}", role.value, v);
      say(fmt::format("FunctionalObjectProperty(:{})", role.name));
      say(fmt::format("EquivalentClasses(:Any_{} ObjectOneOf({}))", role.value, all));
      say(fmt::format("ObjectPropertyRange(:{} :Any_{})", role.name, role.value));
      say(fmt::format("DifferentIndividuals({})", all));
    }
  }

  /// Two in three kinds have a value of every property, the third has one of two colours.
  void define(std::size_t kind) {
    std::string parts;
    for (const Role& role : roles_) {
      const std::size_t value = random_.below(role.values);
      if (kind % 3 == 2 && &role == &roles_.front())
        parts += fmt::format(" ObjectSomeValuesFrom(:{} ObjectOneOf(:{}{} :{}{}))", role.name, role.value,
                             value, role.value, (value + 1) % role.values);
      else
        parts += fmt::format(" ObjectHasValue(:{} :{}{})", role.name, role.value, value);
    }
    say(fmt::format("EquivalentClasses(:Kind{} ObjectIntersectionOf(:Sign{}))", kind, parts));
    say(fmt::format("SubClassOf(:Kind{} :Group{})", kind, kind % 7));
  }

  const PopulatedSigns& wanted_;
  Random random_;
  std::string text_;
  std::size_t count_ = 0;
  std::vector<Role> roles_{{"hasColour", "colour", 6}, {"hasShape", "shape", 5}, {"hasSymbol", "symbol", 20}};
};

}  // namespace

std::string write_terminology(const Terminology& wanted) {
  Random random(wanted.seed);
  std::string text = head;
  for (std::size_t i = 1; i < wanted.classes; ++i) {
    text += fmt::format("SubClassOf(:C{} :C{})\n", i, i / 8);
    if (i % 3 == 0)
      text += fmt::format("SubClassOf(:C{} ObjectSomeValuesFrom(:r{} :C{}))\n", i, random.below(properties),
                          random.below(wanted.classes));
  }
  for (std::size_t d = 0; d < wanted.definitions; ++d)
    text +=
        fmt::format("EquivalentClasses(:C{} ObjectIntersectionOf(:C{} ObjectSomeValuesFrom(:r{} :C{})))\n",
                    wanted.classes + d, random.below(wanted.classes), random.below(properties),
                    random.below(wanted.classes));
  return text + "TransitiveObjectProperty(:r0)\nSubObjectPropertyOf(ObjectPropertyChain(:r1 :r2) :r3)\n)\n";
}

std::string write_populated(const PopulatedSigns& wanted) {
  return Population(wanted).write();
}

std::string write_terminology_rdf(const Terminology& wanted) {
  Random random(wanted.seed);
  std::string text =
      "<?xml version=\"1.0\"?>\n<!DOCTYPE rdf:RDF [\n"
      "    <!ENTITY owl \"http://www.w3.org/2002/07/owl#\" >\n"
      "    <!ENTITY bench \"https://example.org/bench#\" >\n]>\n"
      "<rdf:RDF xmlns=\"https://example.org/bench#\" xml:base=\"https://example.org/bench\"\n"
      "     xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\"\n"
      "     xmlns:rdfs=\"http://www.w3.org/2000/01/rdf-schema#\"\n"
      "     xmlns:owl=\"http://www.w3.org/2002/07/owl#\">\n"
      "    <owl:Ontology rdf:about=\"https://example.org/bench\"/>\n";
  for (std::size_t r = 0; r < properties; ++r)
    text += fmt::format("    <owl:ObjectProperty rdf:about=\"&bench;r{}\"/>\n", r);
  for (std::size_t i = 1; i < wanted.classes; ++i) {
    text += fmt::format(
        "\n    <!-- https://example.org/bench#C{0} -->\n\n    <owl:Class rdf:about=\"&bench;C{0}\">\n"
        "        <rdfs:label xml:lang=\"en\">class number {0}</rdfs:label>\n"
        "        <rdfs:subClassOf rdf:resource=\"&bench;C{1}\"/>\n",
        i, i / 8);
    if (i % 3 == 0)
      text += fmt::format(
          "        <rdfs:subClassOf>\n            <owl:Restriction>\n"
          "                <owl:onProperty rdf:resource=\"&bench;r{}\"/>\n"
          "                <owl:someValuesFrom rdf:resource=\"&bench;C{}\"/>\n"
          "            </owl:Restriction>\n        </rdfs:subClassOf>\n",
          random.below(properties), random.below(wanted.classes));
    text += "    </owl:Class>\n";
  }
  return text + "</rdf:RDF>\n";
}

}  // namespace heed::bench
