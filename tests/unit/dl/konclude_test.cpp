#include "support.h"
#include "temporary_folder.h"

#include <heed/dl/konclude.h>
#include <heed/owl/vocabulary.h>

#include <gmock/gmock.h>

#include <fstream>
#include <iostream>

namespace heed::dl::test {
namespace {

namespace v = owl::vocabulary;

bool installed() {
  return std::system("command -v Konclude >/dev/null 2>&1") == 0;
}

/// A program in place of Konclude: a shell script whose last argument is where the answer goes.
class Pretender {
 public:
  explicit Pretender(const std::string& body) {
    std::ofstream(program()) << "#!/bin/sh\nfor last; do :; done\n" << body << '\n';
    std::filesystem::permissions(program(), std::filesystem::perms::owner_all);
  }
  [[nodiscard]] KoncludeOptions options() const { return {.program = program(), .seconds = 20}; }

 private:
  [[nodiscard]] std::string program() const { return folder_.path("konclude"); }

  heed::test::TemporaryFolder folder_;
};

const std::string disjunctive =
    ":A a owl:Class. :B a owl:Class. :C a owl:Class. :A rdfs:subClassOf [owl:onProperty :r; "
    "owl:maxQualifiedCardinality "
    "2; owl:onClass :C], [owl:onProperty :r; owl:minQualifiedCardinality 3; owl:onClass :C]. :r a "
    "owl:ObjectProperty. ";

std::string code_of(const Asked& asked, const KoncludeOptions& options) {
  util::Budget budget;
  try {
    (void)ask_konclude(asked.reasoner, options, budget);
  } catch (const util::InputError& error) {
    return error.diagnostic().code + ": " + error.diagnostic().message;
  }
  return "no error";
}

std::string answer_with(const std::string& classes) {
  std::string out =
      "cat >\"$last\" <<'END'\n<?xml version=\"1.0\"?>\n<Ontology xmlns=\"" + std::string(HEED_OWL) + "\">";
  for (const char name : classes)
    out += std::string("<Declaration><Class IRI=\"http://e/#") + name + "\"/></Declaration>";
  return out + "</Ontology>\nEND\n";
}

TEST(Konclude, ItsAnswerAddsWhatTheFragmentLacks) {
  if (!installed()) GTEST_SKIP() << "no Konclude (Debian: konclude)";
  const Asked a(disjunctive);
  util::Budget budget;
  const KoncludeAnswer answer = ask_konclude(a.reasoner, {}, budget);
  EXPECT_TRUE(answer.consistent);
  EXPECT_THAT(answer.added, testing::ElementsAre(Subsumption{a.iri("A"), v::owl_nothing}));
  EXPECT_TRUE(answer.missing.empty());
}

/// Its own steps fail then, which its log calls errors.
TEST(Konclude, AnInconsistencyIsAnAnswer) {
  if (!installed()) GTEST_SKIP() << "no Konclude (Debian: konclude)";
  const Asked a(":A a owl:Class; owl:disjointWith :B. :x a :A, :B.");
  util::Budget budget;
  EXPECT_FALSE(ask_konclude(a.reasoner, {}, budget).consistent);
}

/// Every ontology of the corpus, with what its import closure holds.
TEST(KoncludeCorpus, AgreesOnEveryFile) {
  if (!installed()) GTEST_SKIP() << "no Konclude (Debian: konclude)";
  for (const char* file :
       {"signs/signs.owl", "public/galen.owl", "public/sio.owl", "public/pizza.owl", "public/wine.owl",
        "public/SWEET.owl", "auto/automotive_urban_traffic_ontology.owl"}) {
    const std::string path = corpus() + "/owl/" + file;
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "no corpus at " << corpus();
    util::Diagnostics diagnostics;
    util::Budget budget;
    const Reasoner reasoner(owl::load(path, {}, {}, diagnostics), budget);
    const KoncludeAnswer answer = ask_konclude(reasoner, {.seconds = 120}, budget);
    EXPECT_TRUE(answer.consistent) << file;
    EXPECT_TRUE(answer.missing.empty()) << file;
    for (const Subsumption& s : answer.added)
      ADD_FAILURE() << file << ": " << reasoner.ontology().text(s.sub) << " below "
                    << reasoner.ontology().text(s.super);
    std::cout << file << ": " << answer.added.size() << " added, " << answer.remarks.size() << " remarks\n";
  }
}

TEST(Konclude, AMissingProgramIsSaidWithAHint) {
  EXPECT_THAT(code_of(Asked(":A a owl:Class."), {.program = "no-such-reasoner"}),
              testing::HasSubstr("no-reasoner"));
}

TEST(Konclude, NoAnswerIsTrustedThatIsNotWhole) {
  const Asked a(":A a owl:Class. :B a owl:Class.");
  EXPECT_EQ(code_of(a, Pretender(answer_with("AB")).options()), "no error");
  EXPECT_THAT(code_of(a, Pretender(answer_with("A")).options()), testing::HasSubstr("lacks the class"));
  EXPECT_THAT(code_of(a, Pretender(answer_with("AB") + "echo '{error} 10:00 >> broken'").options()),
              testing::HasSubstr("broken"));
  EXPECT_THAT(code_of(a, Pretender("exit 0").options()), testing::HasSubstr("left no answer"));
  EXPECT_THAT(code_of(a, Pretender(answer_with("AB") + "exit 3").options()),
              testing::HasSubstr("exit code 3"));
  EXPECT_THAT(code_of(a, Pretender("kill -9 $$").options()), testing::HasSubstr("signal 9"));
}

/// What it started goes with it.
TEST(Konclude, TimeIsLimited) {
  const Asked a(":A a owl:Class.");
  const Pretender sleeper("sleep 60");
  KoncludeOptions options = sleeper.options();
  options.seconds = 0.3;
  util::Budget budget;
  EXPECT_THROW((void)ask_konclude(a.reasoner, options, budget), util::LimitExceeded);
  EXPECT_LT(budget.elapsed_seconds(), 20);
}

}  // namespace
}  // namespace heed::dl::test
