// Values that perception reports by a wide role, though every entity has them by a narrow one.
//
//     hasShape SubPropertyOf hasFeature     Functional(hasShape)     Disc DisjointWith Octagon
//
// What has the feature Octagon may have the shape Disc as well: OWL knows no role that is the sum of those
// below it. So nothing follows, and nothing is invented here either; it is said which symbol would tell more.
#include <heed/awareness/observation.h>
#include <heed/awareness/perception.h>

#include "horn.h"
#include "told.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

namespace heed::awareness {
namespace {

class Widths {
 public:
  Widths(const Catalogue& catalogue, const Perception& perception)
      : catalogue_(catalogue), perception_(perception), base_(catalogue), judge_(catalogue, {true, {}}) {}

  [[nodiscard]] std::vector<Warning> warnings() const {
    std::map<std::vector<owl::Iri>, std::vector<std::size_t>> groups;  // by the wide role and the narrow ones
    for (std::size_t f = 0; f < catalogue_.features.size(); ++f) {
      if (!perception_.perceivable[f] || !only_narrower(f)) continue;
      std::vector<owl::Iri> roles{catalogue_.features[f].role};
      for (const std::size_t g : narrower(f)) roles.push_back(catalogue_.features[g].role);
      groups[roles].push_back(f);
    }
    std::vector<Warning> result;
    for (const auto& [roles, symbols] : groups)
      if (auto warning = judge(symbols)) result.push_back(std::move(*warning));
    return result;
  }

 private:
  /// The same value by a role below, of which a thing has one.
  [[nodiscard]] std::vector<std::size_t> narrower(std::size_t wide) const {
    std::vector<std::size_t> result;
    const Feature& it = catalogue_.features[wide];
    if (it.kind == Feature::Kind::Class || !it.functional.empty()) return result;
    for (std::size_t g = 0; g < catalogue_.features.size(); ++g) {
      const Feature& other = catalogue_.features[g];
      if (other.kind == it.kind && other.filler == it.filler && !other.functional.empty() &&
          catalogue_.implies(g, wide) != nullptr)
        result.push_back(g);
    }
    return result;
  }

  /// Nobody has it otherwise, so nothing is lost by a narrower symbol.
  [[nodiscard]] bool only_narrower(std::size_t wide) const {
    const auto narrow = narrower(wide);
    if (narrow.empty()) return false;
    for (std::size_t e = 0; e < catalogue_.entities.size(); ++e) {
      if (!catalogue_.entities[e].satisfiable || catalogue_.has_feature(e, wide) == nullptr) continue;
      if (std::none_of(narrow.begin(), narrow.end(),
                       [&](std::size_t g) { return catalogue_.has_feature(e, g) != nullptr; }))
        return false;
    }
    return true;
  }

  /// The first of \p symbols whose narrower form rules more out.
  [[nodiscard]] std::optional<Warning> judge(const std::vector<std::size_t>& symbols) const {
    for (const std::size_t wide : symbols) {
      const auto before = judge_({{wide}, {}, {}}).candidates;
      for (const std::size_t narrow : narrower(wide)) {
        const auto after = judge_({{narrow}, {}, {}}).candidates;
        std::vector<std::size_t> out;
        std::set_difference(before.begin(), before.end(), after.begin(), after.end(),
                            std::back_inserter(out));
        if (!out.empty()) return warning(symbols, wide, narrow, std::move(out));
      }
    }
    return std::nullopt;
  }

  /// \param out  what \p narrow rules out and \p wide does not
  [[nodiscard]] Warning warning(const std::vector<std::size_t>& symbols, std::size_t wide, std::size_t narrow,
                                std::vector<std::size_t> out) const {
    const bool one = symbols.size() == 1;
    const auto [example, why] = shortest(narrow, out);
    Warning result{"excludes-less", ""};
    result.message = fmt::format(
        "{} {} reported as {} of '{}', of which a thing may have several, so that seeing {} rules less out "
        "than "
        "it could. Every entity that has {} has it by {}, of which a thing has one: '{}' would rule out {} "
        "{} "
        "more, such as '{}'.",
        names(symbols), one ? "is" : "are", one ? "a value" : "values", role(wide), one ? "it" : "one",
        one ? "it" : "one", roles(wide), words(narrow), out.size(), out.size() == 1 ? "entity" : "entities",
        catalogue_.entities[example].label);
    result.hint =
        fmt::format("report what = \"{}\"{}", words(narrow), one ? "" : ", and the others likewise");
    result.axioms = join(catalogue_.implies(narrow, wide)->axioms, why);
    result.location = perception_.feature_location[wide];
    result.entities = std::move(out);
    return result;
  }

  /// Of \p out the entity that the fewest axioms rule out, and these. The first few are enough to look at.
  [[nodiscard]] std::pair<std::size_t, Axioms> shortest(std::size_t narrow,
                                                        const std::vector<std::size_t>& out) const {
    constexpr std::size_t few = 64;
    std::pair<std::size_t, Axioms> best{out.front(), {}};
    for (std::size_t i = 0; i < std::min(out.size(), few); ++i) {
      auto why = base_.why({base_.entity(out[i]), base_.feature(narrow)}, base_.nothing());
      if (why && (i == 0 || why->size() < best.second.size())) best = {out[i], *std::move(why)};
    }
    return best;
  }

  [[nodiscard]] std::string role(std::size_t feature) const {
    return catalogue_.ontology.name(catalogue_.features[feature].role, catalogue_.language);
  }
  [[nodiscard]] std::string roles(std::size_t wide) const {
    std::string out;
    for (const std::size_t g : narrower(wide))
      out += fmt::format("{}'{}'", out.empty() ? "" : " or ", role(g));
    return out;
  }
  /// As a scenario says it: "hasShape Octagon".
  [[nodiscard]] std::string words(std::size_t feature) const {
    const Feature& it = catalogue_.features[feature];
    return fmt::format("{} {}", catalogue_.ontology.local_name(it.role),
                       catalogue_.ontology.local_name(it.filler));
  }
  [[nodiscard]] std::string names(const std::vector<std::size_t>& symbols) const {
    constexpr std::size_t most = 6;
    std::string out;
    for (std::size_t i = 0; i < std::min(symbols.size(), most); ++i)
      out += fmt::format("{}'{}'", i == 0 ? "" : ", ", perception_.feature_atom[symbols[i]]);
    return symbols.size() > most ? fmt::format("{} and {} more", out, symbols.size() - most) : out;
  }

  const Catalogue& catalogue_;
  const Perception& perception_;
  HornBase base_;
  Judge judge_;
};

}  // namespace

std::vector<Warning> judge_perception(const Catalogue& catalogue, const Perception& perception) {
  return Widths(catalogue, perception).warnings();
}

}  // namespace heed::awareness
