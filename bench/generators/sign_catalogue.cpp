#include "sign_catalogue.h"

#include "parts_scenario.h"

#include <fmt/format.h>
#include <heed/util/file.h>

#include <filesystem>
#include <set>
#include <vector>

namespace heed::bench {
namespace {

struct Role {
  std::string name, value;
  std::size_t values;
};

class Writer {
 public:
  explicit Writer(const SignCatalogue& wanted)
      : wanted_(wanted),
        state_(wanted.seed),
        roles_{{"hasShape", "Shape", 10},
               {"hasGroundColour", "Ground", 10},
               {"hasBorderColour", "Border", 10},
               {"hasText", "Text", 20},
               {"hasSymbol", "Symbol", wanted.features - 50}} {}

  std::string write() {
    text_ =
        "Prefix(:=<https://example.org/catalogue#>)\nPrefix(owl:=<http://www.w3.org/2002/07/owl#>)\n"
        "Ontology(<https://example.org/catalogue>\n";
    declare();
    const std::size_t groups = std::max<std::size_t>(2, wanted_.entities / 100);
    const std::size_t subgroups = std::max<std::size_t>(4, wanted_.entities / 16);
    for (std::size_t g = 0; g < groups; ++g) entity(fmt::format("Group{}", g), "Sign");
    for (std::size_t s = 0; s < subgroups; ++s)
      entity(fmt::format("Family{}", s), fmt::format("Group{}", s % groups));
    for (std::size_t leaf = 0; leaf + 1 + groups + subgroups < wanted_.entities; ++leaf)
      describe(leaf, fmt::format("Family{}", leaf % subgroups));
    return text_ + ")\n";
  }

 private:
  /// \cite steele.14.oopsla
  std::size_t pick(std::size_t n) {
    state_ += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    return static_cast<std::size_t>((z ^ (z >> 31U)) % n);
  }

  void say(const std::string& axiom) { text_ += axiom + '\n'; }

  void declare() {
    for (const char* root : {"Sign", "Feature", "Behaviour"})
      say(fmt::format("Declaration(Class(:{}))", root));
    say("Declaration(ObjectProperty(:hasFeature))\nDeclaration(ObjectProperty(:hasAction))");
    for (const Role& role : roles_) {
      say(
          fmt::format("Declaration(ObjectProperty(:{0}))\nFunctionalObjectProperty(:{0})\n"
                      "SubObjectPropertyOf(:{0} :hasFeature)",
                      role.name));
      std::string all;
      for (std::size_t v = 0; v < role.values; ++v) {
        all += fmt::format(" :{}{}", role.value, v);
        say(fmt::format("SubClassOf(:{}{} :Feature)", role.value, v));
      }
      say(fmt::format("DisjointClasses({})", all));
    }
    for (const char* act : {"SlowDown", "Observe", "GiveWay", "Halt", "Turn"})
      say(fmt::format("SubClassOf(:{} :Behaviour)", act));
    say("SubClassOf(:Halt :SlowDown)\nSubClassOf(:GiveWay :SlowDown)");
    say("SubClassOf(:Sign ObjectSomeValuesFrom(:hasAction :Observe))");
  }

  void entity(const std::string& name, const std::string& above) {
    say(fmt::format("SubClassOf(:{} :{})", name, above));
    if (pick(4) == 0) say(fmt::format("SubClassOf(:{} ObjectSomeValuesFrom(:hasAction :SlowDown))", name));
  }

  /// Every leaf has a shape and a ground colour, most have a border colour, a symbol or a text; few values
  /// are much more common than the others, as on the road.
  void describe(std::size_t leaf, const std::string& family) {
    static const std::vector<std::string> acts{"SlowDown", "GiveWay", "Halt", "Turn", "Observe"};
    std::string features;
    do {
      features.clear();
      for (std::size_t r = 0; r < roles_.size(); ++r) {
        const bool has = r < 2 || r == 4 || pick(2) == 0;
        const std::size_t values = r < 3 && pick(2) == 0 ? 3 : roles_[r].values;
        if (has)
          features +=
              fmt::format(" ObjectSomeValuesFrom(:{} :{}{})", roles_[r].name, roles_[r].value, pick(values));
      }
    } while (!taken_.insert(features).second);
    const std::string name = fmt::format("Sign{}", leaf);
    say(fmt::format("EquivalentClasses(:{} ObjectIntersectionOf(:Sign{}))", name, features));
    say(fmt::format("SubClassOf(:{} :{})", name, family));
    say(fmt::format("SubClassOf(:{} ObjectSomeValuesFrom(:hasAction :{}))", name, acts[pick(acts.size())]));
  }

  const SignCatalogue& wanted_;
  std::uint64_t state_;
  std::vector<Role> roles_;
  std::set<std::string> taken_;
  std::string text_;
};

}  // namespace

std::string write_catalogue(const SignCatalogue& wanted) {
  return Writer(wanted).write();
}

std::string write_scenario(const SignCatalogue& wanted, const std::string& folder) {
  std::string text =
      "[knowledge]\nontology = \"catalogue.ofn\"\nentities = [\"Sign\"]\nfeatures = [\"Feature\"]\n"
      "behaviours = [\"Behaviour\"]\nfeature_roles = [\"hasFeature\"]\naction_roles = [\"hasAction\"]\n\n"
      "[perception]\ninputs = [\n  { name = \"sign\", what = \"Sign\" },\n";
  for (const char* role : {"hasShape", "hasGroundColour", "hasBorderColour", "hasText", "hasSymbol"})
    text += fmt::format("  {{ what = \"{}\" }},\n", role);
  text +=
      "]\n\n[plant]\nfts = \"car.fts\"\ninitial = [\"M0\"]\n\n"
      "[task]\nguarantees = [\"GF location = 0\", \"GF location != 0\"]\n\n"
      "[bind]\nonly_when_prescribed = true\nHalt = \"stopping\"\n\n"
      "[[controller]]\nname = \"definition\"\npolicy = \"definition\"\n\n"
      "[[controller]]\nname = \"common\"\npolicy = \"identifying\"\nbehaviours = \"common\"\nclosed = true\n";
  std::filesystem::create_directories(folder);
  util::write_file(folder + "/catalogue.ofn", write_catalogue(wanted));
  util::write_file(folder + "/car.fts", plant_text({}));
  util::write_file(folder + "/scenario.toml", text);
  return folder + "/scenario.toml";
}

}  // namespace heed::bench
