#include <gtest/gtest.h>
#include <heed/sim/exact.h>
#include <heed/sim/product.h>

#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "unit/sim/case_study.h"

namespace heed::sim {
namespace {

using namespace case_study;

Product product_of(const Run& run) {
  util::Budget budget;
  return product(run, budget);
}

/// A chain as another tool would read it.
struct Read {
  std::map<std::uint32_t, std::vector<std::pair<Rational, std::uint32_t>>> steps;
  std::map<std::string, std::vector<std::uint32_t>> labels;

  /// The probability to reach a label, by pushing mass forward until all of it rests.
  [[nodiscard]] Rational reach(const std::string& label) const {
    std::map<std::uint32_t, Rational> moving{{0, 1}}, resting;
    while (!moving.empty()) {
      std::map<std::uint32_t, Rational> next;
      for (const auto& [state, mass] : moving) {
        const auto found = steps.find(state);
        if (found == steps.end()) {
          resting[state] += mass;
          continue;
        }
        for (const auto& [p, to] : found->second) next[to] += mass * p;
      }
      moving = std::move(next);
    }
    Rational sum = 0;
    for (const std::uint32_t state : labels.at(label)) sum += resting[state];
    return sum;
  }
};

Read read_prism(const std::string& text) {
  Read chain;
  std::istringstream lines(text);
  const std::regex command(R"(\s*\[\] s=(\d+) -> (.*?);.*)"), branch(R"(([0-9/]+):\(s'=(\d+)\))");
  const std::regex label(R"re(label "(\w+)" = (.*?);.*)re"), state(R"(s=(\d+))");
  std::smatch m;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, m, command)) {
      const auto from = static_cast<std::uint32_t>(std::stoul(m[1]));
      const std::string right = m[2];
      for (std::sregex_iterator i(right.begin(), right.end(), branch), end; i != end; ++i)
        chain.steps[from].emplace_back(q((*i)[1]), static_cast<std::uint32_t>(std::stoul((*i)[2])));
    } else if (std::regex_match(line, m, label)) {
      auto& states = chain.labels[m[1]];
      const std::string right = m[2];
      for (std::sregex_iterator i(right.begin(), right.end(), state), end; i != end; ++i)
        states.push_back(static_cast<std::uint32_t>(std::stoul((*i)[1])));
    }
  }
  return chain;
}

std::uint32_t place(const nlohmann::json& name) {
  return static_cast<std::uint32_t>(std::stoul(name.get<std::string>().substr(1)));
}

Rational value(const nlohmann::json& probability) {
  if (probability.is_number()) return probability.get<long>();
  EXPECT_EQ(probability.at("op"), "/");
  return Rational(probability.at("left").get<long>(), probability.at("right").get<long>());
}

Read read_jani(const std::string& text) {
  const auto model = nlohmann::json::parse(text);
  EXPECT_EQ(model.at("type"), "dtmc");
  const auto& automaton = model.at("automata").at(0);
  Read chain;
  for (const auto& variable : model.at("variables")) chain.labels[variable.at("name")];
  for (const auto& location : automaton.at("locations"))
    for (const auto& set : location.value("transient-values", nlohmann::json::array()))
      chain.labels.at(set.at("ref")).push_back(place(location.at("name")));
  for (const auto& edge : automaton.at("edges"))
    for (const auto& to : edge.at("destinations"))
      if (to.contains("probability"))
        chain.steps[place(edge.at("location"))].emplace_back(value(to.at("probability").at("exp")),
                                                             place(to.at("location")));
  return chain;
}

void expect_outcomes(const Read& chain, const Chart& chart) {
  const std::vector<std::string> names = {"outcome_infeasible", "outcome_stop_in_1", "outcome_stop_in_2",
                                          "outcome_stop_in_3", "outcome_stop_in_4"};
  ASSERT_EQ(chart.judgement.categories.size(), names.size());
  for (std::size_t c = 0; c < names.size(); ++c)
    EXPECT_EQ(fraction(chain.reach(names[c])), fraction(q(chart.expected[c]))) << chart.name << names[c];
  EXPECT_EQ(chain.reach("undefined"), 0);
  EXPECT_EQ(chain.reach("missing"), 0);
}

TEST(Product, OtherToolsFindTheTableOfTheCaseStudy) {
  for (const Chart& chart : charts()) {
    const Product chain = product_of(chart.run());
    expect_outcomes(read_prism(write_prism(chain)), chart);
    expect_outcomes(read_jani(write_jani(chain)), chart);
  }
}

TEST(Product, OtherToolsFindWhatIsMisread) {
  ProfileSpec profile = p1();
  profile.misreadings = {{"red", "stop_sign", q("1/4"), q("0")}, {"octagon", "red", q("1/3"), {}, true}};
  Chart made = chart(profile, "base", base, {});
  util::Budget budget;
  for (const Rational& p : exact_outcome(made.run(), budget).probability)
    made.expected.push_back(fraction(p));
  ASSERT_NE(made.expected[0], "5/8");
  expect_outcomes(read_prism(write_prism(product_of(made.run()))), made);
  expect_outcomes(read_jani(write_jani(product_of(made.run()))), made);
}

TEST(Product, ProbabilitiesOfAStateAddUpToOneAndEndsHaveNoSteps) {
  for (const Chart& chart : charts()) {
    const Product chain = product_of(chart.run());
    ASSERT_EQ(chain.first.size(), chain.states.size() + 1);
    for (std::size_t s = 0; s < chain.states.size(); ++s) {
      Rational sum = 0;
      for (std::uint32_t i = chain.first[s]; i < chain.first[s + 1]; ++i) sum += chain.steps[i].probability;
      EXPECT_EQ(sum, chain.states[s].end ? 0 : 1);
    }
  }
}

// One feature that flickers and a machine that knows no answer to it in its second state.
TEST(Product, MissingRowsAndFallbacksAreLabelled) {
  ProfileSpec profile;
  profile.cells = 2;
  profile.features = {feature("f", FixedOnset{0})};
  profile.features[0].detection = q("1/3");
  profile.persistent = false;
  util::Budget budget;
  const Chain chain = compile(profile, budget);
  model::MealyBuilder builder("m", {{"f", model::Domain::boolean(), {}, {}}}, {});
  builder.add_state();
  builder.add_state();
  builder.add(0, {0}, {}, 0);
  builder.add(0, {1}, {}, 1, true);
  builder.add(1, {1}, {}, 1);
  const model::Mealy machine = builder.finish();
  const Binding binding{{0}, {{0, 0, 1}}};
  const Judge judge{{"nothing"}, {Judge::none, Judge::none, Judge::none}, 0};
  const sim::Run run{chain, machine, binding, judge};
  const ExactOutcome exact = exact_outcome(run, budget);
  const Read read = read_prism(write_prism(product_of(run)));
  EXPECT_EQ(read.reach("missing"), q("2/9"));
  EXPECT_EQ(read.reach("missing"), exact.missing);
  EXPECT_EQ(read.reach("fallback"), q("5/9"));
  EXPECT_EQ(read.reach("fallback"), exact.fallback);
  EXPECT_EQ(read.reach("outcome_nothing"), q("7/9"));
  EXPECT_EQ(read.reach("undefined"), exact.undefined);
}

}  // namespace
}  // namespace heed::sim
