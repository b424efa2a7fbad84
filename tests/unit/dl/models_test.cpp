#include "support.h"

#include <heed/util/random.h>

#include <array>
#include <cstdlib>
#include <memory>

// Whatever is entailed holds in every model. All interpretations of four classes and two properties over two
// things are tried: the reasoner must entail nothing that one of those which satisfy the axioms refutes.

namespace heed::dl::test {
namespace {

constexpr unsigned classes = 4, roles = 2, things = 2, all = (1U << things) - 1;

/// Extensions as bits: thing t is in class c; (t, u) is in role r at bit t * things + u.
struct Interpretation {
  std::array<unsigned, classes> in{};
  std::array<unsigned, roles> pairs{};
  [[nodiscard]] bool linked(unsigned role, bool inverse, unsigned from, unsigned to) const {
    return (pairs[role] >> (inverse ? to * things + from : from * things + to) & 1U) != 0;
  }
};

struct Expression {
  enum Kind { Name, And, Or, Not, Some, Only, AtLeastTwo, AtMostOne } kind = Name;
  unsigned name = 0;
  bool inverse = false;
  std::vector<Expression> parts;

  [[nodiscard]] std::string text() const {
    const std::string role =
        inverse ? "ObjectInverseOf(:r" + std::to_string(name) + ")" : ":r" + std::to_string(name);
    switch (kind) {
      case Name:
        return ":C" + std::to_string(name);
      case And:
        return "ObjectIntersectionOf(" + parts[0].text() + " " + parts[1].text() + ")";
      case Or:
        return "ObjectUnionOf(" + parts[0].text() + " " + parts[1].text() + ")";
      case Not:
        return "ObjectComplementOf(" + parts[0].text() + ")";
      case Some:
        return "ObjectSomeValuesFrom(" + role + " " + parts[0].text() + ")";
      case Only:
        return "ObjectAllValuesFrom(" + role + " " + parts[0].text() + ")";
      case AtLeastTwo:
        return "ObjectMinCardinality(2 " + role + " " + parts[0].text() + ")";
      case AtMostOne:
        return "ObjectMaxCardinality(1 " + role + ")";
    }
    return {};
  }

  [[nodiscard]] unsigned value(const Interpretation& i) const {
    const unsigned a = parts.empty() ? 0 : parts[0].value(i);
    if (kind == Name) return i.in[name];
    if (kind == And) return a & parts[1].value(i);
    if (kind == Or) return a | parts[1].value(i);
    if (kind == Not) return all & ~a;
    unsigned out = 0;
    for (unsigned t = 0; t < things; ++t) {
      unsigned inside = 0, outside = 0;
      for (unsigned u = 0; u < things; ++u)
        if (i.linked(name, inverse, t, u)) ((a >> u & 1U) != 0 ? inside : outside) += 1;
      const bool holds = kind == Some         ? inside > 0
                         : kind == Only       ? outside == 0
                         : kind == AtLeastTwo ? inside > 1
                                              : inside + outside < 2;
      if (holds) out |= 1U << t;
    }
    return out;
  }
};

class Generator {
 public:
  explicit Generator(std::uint64_t seed) : random_(seed, 0) {}
  unsigned pick(unsigned n) { return static_cast<unsigned>(random_.below(n)); }

  Expression expression(unsigned depth) {
    Expression out;
    if (depth == 0 || pick(4) == 0) {
      out.name = pick(classes);
      return out;
    }
    out.kind = static_cast<Expression::Kind>(Expression::And + pick(7));
    out.name = pick(roles);
    out.inverse = pick(4) == 0;
    if (out.kind != Expression::AtMostOne) out.parts.push_back(expression(depth - 1));
    if (out.kind == Expression::And || out.kind == Expression::Or) out.parts.push_back(expression(depth - 1));
    return out;
  }

 private:
  util::CounterRandom random_;
};

struct Inclusion {
  Expression sub, super;
};

struct RoleAxioms {
  bool functional = false, below = false, transitive = false, inverse_functional = false;

  [[nodiscard]] std::string text() const {
    return std::string(functional ? "FunctionalObjectProperty(:r0)\n" : "") +
           (below ? "SubObjectPropertyOf(:r1 :r0)\n" : "") +
           (transitive ? "TransitiveObjectProperty(:r1)\n" : "") +
           (inverse_functional ? "InverseFunctionalObjectProperty(:r0)\n" : "");
  }
  [[nodiscard]] bool hold(const Interpretation& i) const {
    for (unsigned t = 0; t < things; ++t)
      for (unsigned u = 0; u < things; ++u) {
        if (below && i.linked(1, false, t, u) && !i.linked(0, false, t, u)) return false;
        for (unsigned w = 0; w < things; ++w) {
          const bool two = u != w;
          if (functional && two && i.linked(0, false, t, u) && i.linked(0, false, t, w)) return false;
          if (inverse_functional && two && i.linked(0, true, t, u) && i.linked(0, true, t, w)) return false;
          if (transitive && i.linked(1, false, t, u) && i.linked(1, false, u, w) && !i.linked(1, false, t, w))
            return false;
        }
      }
    return true;
  }
};

/// The models among all interpretations; the last pair of things stands for an individual x that is thing 0.
std::vector<Interpretation> models_of(const std::vector<Inclusion>& axioms, const RoleAxioms& role_axioms,
                                      const std::vector<Expression>& types) {
  std::vector<Interpretation> out;
  for (unsigned bits = 0; bits < 1U << (classes * things + roles * things * things); ++bits) {
    Interpretation i;
    unsigned rest = bits;
    for (unsigned& extension : i.in) extension = rest & all, rest >>= things;
    for (unsigned& extension : i.pairs) extension = rest & 15U, rest >>= things * things;
    bool model = role_axioms.hold(i);
    for (std::size_t a = 0; model && a < axioms.size(); ++a)
      model = (axioms[a].sub.value(i) & ~axioms[a].super.value(i)) == 0;
    for (std::size_t a = 0; model && a < types.size(); ++a) model = (types[a].value(i) & 1U) != 0;
    if (model) out.push_back(i);
  }
  return out;
}

owl::Ontology functional(const std::string& body) {
  util::Diagnostics diagnostics;
  std::string text = "Prefix(:=<http://e/#>)\nOntology(\nDeclaration(NamedIndividual(:x))\n";
  for (unsigned c = 0; c < classes; ++c) text += "Declaration(Class(:C" + std::to_string(c) + "))\n";
  for (unsigned r = 0; r < roles; ++r) text += "Declaration(ObjectProperty(:r" + std::to_string(r) + "))\n";
  return owl::read(util::SourceText("test.ofn", text + body + ")"), {}, diagnostics);
}

struct Tally {
  std::size_t entailed = 0, valid = 0;
};

void judge(std::uint64_t seed, Tally& tally) {
  Generator generate(seed);
  std::vector<Inclusion> axioms;
  std::vector<Expression> types;
  std::string body;
  for (unsigned a = 0; a < 3 + seed % 3; ++a) {
    axioms.push_back({generate.expression(generate.pick(2)), generate.expression(2)});
    if (a % 2 == 1) std::swap(axioms.back().sub, axioms.back().super);
    body += "SubClassOf(" + axioms.back().sub.text() + " " + axioms.back().super.text() + ")\n";
  }
  if (seed % 2 == 0) {
    types.push_back(generate.expression(1));
    body += "ClassAssertion(" + types.back().text() + " :x)\n";
  }
  const RoleAxioms role_axioms{generate.pick(3) == 0, generate.pick(3) == 0, generate.pick(4) == 0,
                               generate.pick(4) == 0};
  body += role_axioms.text();
  const owl::Ontology ontology = functional(body);
  util::Budget budget;
  const Reasoner reasoner(ontology, budget);
  const auto models = models_of(axioms, role_axioms, types);
  if (!models.empty()) {
    ASSERT_TRUE(reasoner.consistent()) << body;
  }
  const auto named = [&](unsigned c) { return *ontology.find("http://e/#C" + std::to_string(c)); };
  for (unsigned a = 0; a < classes; ++a)
    for (unsigned b = 0; b < classes; ++b) {
      const bool valid = std::all_of(models.begin(), models.end(),
                                     [&](const Interpretation& i) { return (i.in[a] & ~i.in[b]) == 0; });
      const bool entailed = reasoner.subsumes(named(b), named(a));
      ASSERT_TRUE(valid || !entailed) << "C" << a << " below C" << b << " by\n" << body;
      tally.entailed += entailed && a != b;
      tally.valid += valid && a != b;
    }
  const auto known = reasoner.types(*ontology.find("http://e/#x"));
  for (unsigned c = 0; c < classes && !types.empty(); ++c)
    if (std::find(known.begin(), known.end(), named(c)) != known.end()) {
      for (const Interpretation& i : models)
        ASSERT_TRUE((i.in[c] & 1U) != 0) << "x: C" << c << " by\n" << body;
    }
}

TEST(Models, NothingIsEntailedThatAModelRefutes) {
  Tally tally;
  const std::uint64_t most = std::getenv("HEED_SLOW") != nullptr ? 10'000 : 400;
  for (std::uint64_t seed = 0; seed < most; ++seed) {
    judge(seed, tally);
    if (testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GT(tally.entailed, 100U);
  EXPECT_LE(tally.entailed, tally.valid);
  RecordProperty("entailed", static_cast<int>(tally.entailed));
  RecordProperty("valid", static_cast<int>(tally.valid));
}

}  // namespace
}  // namespace heed::dl::test
