#include <heed/certify/certify.h>
#include <heed/spec/text.h>
#include <heed/util/diagnostic.h>
#include <heed/util/file.h>

#include <gtest/gtest.h>

#include <string>

namespace heed::certify {
namespace {

using model::Claim;
using model::Function;
using model::Level;

spec::Gr1 spec_of(const std::string& text) {
  return spec::read_gr1(util::SourceText("test.gr1", text));
}

/// The controller of the format's page, with one line of it replaced.
model::SymbolicController echo(const std::string& from = "", const std::string& to = "") {
  const std::string page = util::read_file(std::string(HEED_SOURCE_DIR) + "/docs/formats/symbolic.md").text();
  const std::size_t begin = page.find("```json\n") + 8;
  std::string text = page.substr(begin, page.find("```", begin) - begin);
  if (!from.empty()) text.replace(text.find(from), from.size(), to);
  return model::read_symbolic(util::SourceText("echo.symbolic.json", text));
}

const char* const echo_spec =
    "[input]\nred : boolean\n[output]\naction : {go, halt}\n[sys safety]\naction = halt <-> red\n";

std::string fault(const model::SymbolicController& controller, const std::string& spec) {
  util::Budget budget;
  return certify(controller, spec_of(spec), budget).fault;
}

std::string fault(const Claim& claim, const std::string& spec) {
  util::Budget budget;
  const Verdict verdict = certify(claim, spec_of(spec), budget);
  EXPECT_EQ(verdict.certified, verdict.fault.empty());
  return verdict.fault;
}

TEST(CertifyController, ThePagesExampleKeepsItsSpecification) {
  EXPECT_EQ(fault(echo(), echo_spec), "");
}

TEST(CertifyController, EachThingThatItDoesIsLookedAt) {
  const auto starts = [](const std::string& text, const std::string& with) {
    return text.rfind(with, 0) == 0;
  };
  EXPECT_PRED2(starts, fault(echo("\"answers\": [4]", "\"answers\": [5]"), echo_spec),
               "on the way to goal 'true' a guarantee is broken: action = halt <-> red");
  EXPECT_PRED2(starts, fault(echo("\"outputs\": [2]", "\"outputs\": [3]"), echo_spec),
               "the first answer breaks what holds at the start, everywhere");
  EXPECT_PRED2(starts, fault(echo("\"answered\": 0", "\"answered\": 2"), echo_spec),
               "a legal first observation is not answered, such as red = false");
  EXPECT_PRED2(starts, fault(echo("\"legal\": []", "\"legal\": [4]"), echo_spec),
               "a legal observation is not answered");
  EXPECT_PRED2(starts, fault(echo("\"winning\": 0", "\"winning\": 2"), echo_spec),
               "the first answer leaves the states that are won");
  EXPECT_PRED2(starts, fault(echo("\"winning\": 0", "\"winning\": 4"), echo_spec), "a set of states depends");
  EXPECT_PRED2(starts, fault(echo("[0, null]", "[2, null]"), echo_spec),
               "a state that is said to be won has no rank");
  EXPECT_PRED2(starts, fault(echo("[0, null]", "[0, 1]"), echo_spec), "a rank waits for an assumption");
}

// A value that must differ from itself has no step, so that none is bad; one that is whatever it is equals
// anything. What runs the controller has to begin somewhere, and does neither.
TEST(CertifyController, NothingIsDefinedByItself) {
  model::SymbolicController answers = echo();
  answers.diagrams.nodes.push_back({3, 1, 0});
  answers.goals[0].answers = {7};
  EXPECT_EQ(fault(answers, echo_spec), "an answer depends on itself or on later ones");
  model::SymbolicController starts = echo();
  starts.diagrams.nodes.push_back({2, 1, 0});
  starts.start.outputs = {7};
  EXPECT_EQ(fault(starts, echo_spec), "a first value depends on itself or on later ones");
  model::SymbolicController remembers = echo();
  remembers.memories = {{{"m", model::Domain::boolean(), {}, {}}, model::OutputRole::Memory}};
  remembers.diagrams.order.insert(remembers.diagrams.order.end(), {4, 5});
  remembers.diagrams.nodes.push_back({5, 1, 0});
  remembers.start.memories = {model::function_false};
  remembers.updates = {4};
  const std::string remembering = std::string(echo_spec) + "[memory]\nm : boolean = false\nm' = red'\n";
  EXPECT_EQ(fault(remembers, remembering), "");
  remembers.updates = {6};
  EXPECT_EQ(fault(remembers, remembering),
            "a memory's next value depends on what is chosen after it, or on itself");
}

TEST(CertifyController, AGoalIsNotMetBecauseTheControllerSaysSo) {
  const std::string wants = std::string(echo_spec) + "[sys justice]\naction = halt\n";
  EXPECT_NE(fault(echo(), wants).find("is taken to be met where it is not"), std::string::npos);
  // It waits for red, which may never come; only where that is an assumption is it right.
  const std::string met = "\"met\": 2";
  EXPECT_NE(fault(echo("\"met\": 0", met), wants), "");
  const std::string helped = wants + "[env justice]\nred\n";
  model::SymbolicController waits = echo("\"met\": 0, \"ranks\": [[0, null]]", met + ", \"ranks\": [[0, 0]]");
  // A state may have red and go only before it is won: the invariant is action = halt <-> red.
  waits.diagrams.nodes.push_back({2, 1, 0});
  waits.diagrams.nodes.push_back({0, 7, 6});
  waits.winning = 8;
  EXPECT_EQ(fault(waits, helped), "");
  EXPECT_NE(fault(waits, wants), "");
}

TEST(CertifyController, MooreAnswersBeforeItSees) {
  const std::string moore = "[options]\ntiming = moore\ninitial = forall-exists\n";
  const std::string free = "[input]\nred : boolean\n[output]\naction : {go, halt}\n";
  EXPECT_EQ(fault(echo("\"answers\": [4]", "\"answers\": [2]"), moore + free), "");
  EXPECT_EQ(fault(echo(), moore + free), "an answer depends on the observation of the same step");
  EXPECT_EQ(fault(echo(), "[options]\ninitial = exists-forall\n" + free),
            "the first answer depends on the first observation");
}

TEST(CertifyController, OtherVariablesAreBadInput) {
  EXPECT_THROW((void)fault(echo(), "[input]\nblue : boolean\n[output]\naction : {go, halt}\n"),
               util::InputError);
  EXPECT_THROW((void)fault(echo(), "[input]\nred : boolean\n"), util::InputError);
  EXPECT_THROW((void)fault(echo(), std::string(echo_spec) + "[define]\nd := red\n"), util::InputError);
}

/// Over one input x and one output y, nodes: 1 = x, 2 = y, both current.
Claim claim_over_two() {
  Claim claim;
  claim.inputs = {{"x", model::Domain::boolean(), {}, {}}};
  claim.outputs = {{"y", model::Domain::boolean(), {}, {}}};
  claim.diagrams.order = {0, 1, 2, 3};
  claim.diagrams.nodes = {{0, 1, 0}, {2, 1, 0}};
  return claim;
}

constexpr Function x = 2, y = 4;

// The next y is now's x, and y is wanted: one step after x. Without x for ever nobody can help.
TEST(CertifyClaim, RanksCountTheSteps) {
  const std::string follows = "[input]\nx : boolean\n[output]\ny : boolean\n[sys safety]\ny' <-> x\n";
  const std::string wants = follows + "[env justice]\nx\n[sys justice]\ny\n";
  Claim claim = claim_over_two();
  claim.realizable = true;
  claim.winning = model::function_true;
  claim.diagrams.nodes.push_back({0, y, 0});
  const Function x_or_y = 6;
  const Level near{y, {}}, one{x_or_y, {}};
  const Level waiting{model::function_true, 0};
  claim.ranks = {{near, one, waiting}};
  EXPECT_EQ(fault(claim, wants), "");
  EXPECT_NE(fault(claim, follows + "[sys justice]\ny\n"), "");
  claim.ranks = {{near, one, {model::function_true, {}}}};
  EXPECT_NE(fault(claim, wants).find("from rank 2 of goal 'y' the system does not come nearer"),
            std::string::npos);
  claim.ranks = {{near, one, near, waiting}};
  EXPECT_EQ(fault(claim, wants), "rank 2 of goal 'y' does not contain the one before");
  claim.ranks = {{near, one}};
  EXPECT_NE(fault(claim, wants).find("has no rank"), std::string::npos);
  claim.ranks = {};
  EXPECT_NE(fault(claim, wants), "");
}

// Without the assumption the environment keeps x away: everything but y is lost at once, then y too.
TEST(CertifyClaim, DefeatsAreShownRoundByRound) {
  const std::string wants =
      "[input]\nx : boolean\n[output]\ny : boolean\n[sys safety]\ny' <-> x\n[sys justice]\ny\n";
  Claim claim = claim_over_two();
  claim.diagrams.nodes.push_back({0, y, 0});  // x | y
  const Function x_or_y = 6;
  // Where neither x nor y holds, the environment stays away from x for ever.
  model::LosingRound first;
  first.lost = x_or_y ^ 1U;
  first.goal = 0;
  first.chains = {{x_or_y ^ 1U}};
  // From y alone it goes there, and from x it goes to y alone first.
  model::LosingRound second;
  second.lost = x ^ 1U;
  model::LosingRound third;
  third.lost = model::function_true;
  claim.rounds = {first, second, third};
  EXPECT_EQ(fault(claim, wants), "");
  EXPECT_NE(fault(claim, wants + "[env justice]\nx\n"), "");
  claim.rounds = {first, third};
  EXPECT_NE(fault(claim, wants).find("in round 1 of the defeat the environment cannot force"),
            std::string::npos);
  claim.rounds = {second, third};
  EXPECT_NE(fault(claim, wants), "");
  claim.rounds = {};
  EXPECT_EQ(fault(claim, wants), "the start does not lie in what is claimed to be lost");
}

TEST(CertifyClaim, ABrokenSpecificationIsBadInput) {
  Claim claim = claim_over_two();
  EXPECT_THROW((void)fault(claim, "[input]\nx : boolean\n[output]\nz : boolean\n"), util::InputError);
}

}  // namespace
}  // namespace heed::certify
