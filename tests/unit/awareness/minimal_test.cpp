// What the catalogue says of entities comes with axioms: alone they entail it, and without any one of them no
// longer. Judged by a reasoner that reads these axioms only.
#include "ontologies.h"

#include <heed/dl/reasoner.h>
#include <heed/owl/print.h>

#include <gtest/gtest.h>

#include <iostream>

namespace heed::awareness {
namespace {

/// "Every `entity` is a `filler`", or has one by `role`; all in full.
struct Statement {
  std::string entity, role, filler;
  bool value = false;
};

class Judge {
 public:
  explicit Judge(const Catalogue& catalogue) : catalogue_(catalogue) {
    for (const owl::Axiom& axiom : catalogue.ontology.axioms())
      if (axiom.as<owl::Declaration>() != nullptr) declarations_.push_back(axiom.id);
  }

  void judge(const Statement& statement, const std::vector<owl::AxiomId>& axioms) {
    ++judged;
    ASSERT_TRUE(entailed(statement, axioms)) << words(statement);
    for (const owl::AxiomId gone : axioms) {
      auto fewer = axioms;
      std::erase(fewer, gone);
      EXPECT_FALSE(entailed(statement, fewer)) << words(statement) << " without " << owl::to_string(gone);
    }
  }

  std::size_t judged = 0;

 private:
  static std::string words(const Statement& s) { return s.entity + " " + s.role + " " + s.filler; }

  [[nodiscard]] bool entailed(const Statement& statement, const std::vector<owl::AxiomId>& axioms) const {
    std::vector<owl::AxiomId> ids = declarations_;
    ids.insert(ids.end(), axioms.begin(), axioms.end());
    util::Diagnostics diagnostics;
    util::Budget budget;
    const owl::Ontology part = owl::read(
        util::SourceText("part.ofn", owl::to_functional(ids, catalogue_.ontology)), {}, diagnostics);
    const dl::Reasoner reasoner(part, budget);
    const auto entity = part.find(statement.entity), filler = part.find(statement.filler);
    if (!entity || !filler) return false;
    auto super = owl::ClassExpression::named(*filler);
    if (!statement.role.empty()) {
      const auto role = part.find(statement.role);
      if (!role) return false;
      super = statement.value ? owl::ClassExpression::has_value({*role, false}, *filler)
                              : owl::ClassExpression::some({*role, false}, super);
    }
    return reasoner.entails_subsumption(owl::ClassExpression::named(*entity), super);
  }

  const Catalogue& catalogue_;
  std::vector<owl::AxiomId> declarations_;
};

/// All that the catalogue lists of satisfiable entities: ancestors, features, behaviours.
void judge_all(const std::string& path, const CatalogueOptions& options, const std::string& action) {
  util::Diagnostics diagnostics;
  util::Budget budget;
  const dl::Reasoner reasoner(owl::load(path, {}, {}, diagnostics), budget);
  const Catalogue catalogue = build_catalogue(reasoner, options, budget);
  const owl::Ontology& o = catalogue.ontology;
  const auto text = [&](owl::Iri iri) { return std::string(o.text(iri)); };
  Judge judge(catalogue);
  for (const Entity& entity : catalogue.entities) {
    if (!entity.satisfiable) continue;
    for (const Entailed& up : entity.ancestors)
      judge.judge({text(entity.iri), "", text(catalogue.entities[up.index].iri)}, up.axioms);
    for (const Entailed& has : entity.features) {
      const Feature& feature = catalogue.features[has.index];
      if (feature.kind == Feature::Kind::Class) continue;
      judge.judge(
          {text(entity.iri), text(feature.role), text(feature.filler), feature.kind == Feature::Kind::Value},
          has.axioms);
    }
    for (const Entailed& act : entity.behaviours)
      judge.judge({text(entity.iri), text(o.lookup(action).front()),
                   text(catalogue.behaviours[act.index].iri), catalogue.behaviours[act.index].individual},
                  act.axioms);
  }
  EXPECT_GT(judge.judged, 40U);
  std::cout << path << ": " << judge.judged << " statements\n";
}

TEST(Minimal, WhatTheStopSignExampleSays) {
  judge_all(test::source_path("examples/stop-sign/traffic-signs.owl"), test::traffic_options(), "hasAction");
}

/// Here chains of properties bind behaviours, and one class is another one by accident.
TEST(MinimalCorpus, WhatTheSignsOfTheCorpusSay) {
  const std::string path = test::corpus_path("owl/signs/signs.ofn");
  if (path.empty()) GTEST_SKIP() << "no corpus";
  CatalogueOptions options;
  options.entities = {"Sign"};
  options.features = {"Feature"};
  options.behaviours = {"Action"};
  options.action_roles = {"hasAction"};
  judge_all(path, options, "hasAction");
}

}  // namespace
}  // namespace heed::awareness
