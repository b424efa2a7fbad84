#pragma once

#include <heed/awareness/catalogue.h>
#include <heed/owl/ontology.h>
#include <heed/owl/read.h>

#include <fmt/format.h>

#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace heed::awareness::test {

/// A small ontology of signs in functional style: two groups, four to six leaves, two functional roles with
/// some disjoint values and one role without, three behaviours of which one is special.
class RandomHorn {
 public:
  explicit RandomHorn(std::uint32_t seed) : random_(seed) {
    head();
    for (const char* group : {"G0", "G1"}) entity(group, "Sign");
    const int leaves = 4 + pick(3);
    for (int i = 0; i < leaves; ++i) entity(fmt::format("L{}", i), pick(2) == 0 ? "G0" : "G1");
    if (pick(3) == 0) say("DisjointClasses(:L0 :L1)");
    if (pick(3) == 0) say(fmt::format("SubClassOf({} :L2)", some_feature()));
    if (pick(3) == 0) say(fmt::format("SubClassOf(ObjectIntersectionOf(:L0 {}) :L3)", some_feature()));
    text_ += ")\n";
  }

  [[nodiscard]] const std::string& text() const { return text_; }

  static CatalogueOptions options() {
    CatalogueOptions options;
    options.entities = {"Sign"};
    options.features = {"Feature"};
    options.behaviours = {"Behaviour"};
    options.feature_roles = {"colour", "shape", "mark"};
    options.action_roles = {"act"};
    return options;
  }

 private:
  int pick(int n) { return static_cast<int>(random_() % static_cast<std::uint32_t>(n)); }
  void say(const std::string& axiom) { text_ += axiom + '\n'; }

  void head() {
    text_ =
        "Prefix(:=<http://example.org/h#>)\nPrefix(owl:=<http://www.w3.org/2002/07/owl#>)\n"
        "Ontology(<http://example.org/h>\n";
    for (const char* name : {"Sign", "Feature", "Behaviour"})
      say(fmt::format("Declaration(Class(:{}))", name));
    for (const char* role : {"colour", "shape", "mark", "act"})
      say(fmt::format("Declaration(ObjectProperty(:{}))", role));
    say("FunctionalObjectProperty(:colour) FunctionalObjectProperty(:shape)");
    for (const char* value : {"C0", "C1", "S0", "S1", "S2", "M0", "M1"})
      say(fmt::format("SubClassOf(:{} :Feature)", value));
    say("DisjointClasses(:C0 :C1)");
    say(pick(2) == 0 ? "DisjointClasses(:S0 :S1 :S2)" : "DisjointClasses(:S0 :S1)");
    for (const char* act : {"B0", "B1", "B2"}) say(fmt::format("SubClassOf(:{} :Behaviour)", act));
    say("SubClassOf(:B1 :B0)");
  }

  std::string some_feature() {
    static const std::vector<std::string> all{"colour :C0", "colour :C1", "shape :S0", "shape :S1",
                                              "shape :S2",  "mark :M0",   "mark :M1"};
    return fmt::format("ObjectSomeValuesFrom(:{})", all[static_cast<std::size_t>(pick(7))]);
  }

  void entity(const std::string& name, const std::string& above) {
    std::set<std::string> parts;
    for (int i = pick(4); i > 0; --i) parts.insert(some_feature());
    std::string all = ":" + above;
    for (const std::string& part : parts) all += " " + part;
    if (parts.empty())
      say(fmt::format("SubClassOf(:{} :{})", name, above));
    else
      say(fmt::format("{}(:{} ObjectIntersectionOf({}))", pick(3) != 0 ? "EquivalentClasses" : "SubClassOf",
                      name, all));
    if (pick(4) == 0) say(fmt::format("SubClassOf(:{} {})", name, some_feature()));
    for (int i = pick(3); i > 0; --i)
      say(fmt::format("SubClassOf(:{} ObjectSomeValuesFrom(:act :B{}))", name, pick(3)));
  }

  std::mt19937 random_;
  std::string text_;
};

}  // namespace heed::awareness::test
