#pragma once

// The case study's profiles, judged machines and figures, written by hand for the tests of this room.

#include <heed/model/mealy.h>
#include <heed/sim/run.h>

#include <functional>
#include <string>
#include <vector>

namespace heed::sim::case_study {

inline util::SourceText text(const std::string& content) {
  return {"test", content};
}
inline OnsetExpression at(const std::string& content) {
  return parse_onset(text(content));
}
inline Rational q(const std::string& content) {
  return parse_rational(text(content));
}

inline FeatureSpec feature(const std::string& name, Onset onset) {
  return {name, std::move(onset)};
}

inline ProfileSpec p1() {
  ProfileSpec profile;
  profile.name = "P1";
  profile.features = {feature("sign", LinearOnset{q("1/2"), 1}),
                      feature("red", GeometricOnset{q("0.5"), at("sign + 1")}),
                      feature("octagon", GeometricOnset{q("1/2"), at("sign + 1")}),
                      feature("stop_sign", GeometricOnset{q("1/2"), at("max(2, min(red, octagon) + 1)")})};
  profile.everything_visible_in = 4;
  return profile;
}

inline ProfileSpec p2() {
  ProfileSpec profile;
  profile.name = "P2";
  profile.features = {feature("sign", UniformOnset{0, 2}), feature("red", ShuffledOnset{}),
                      feature("octagon", ShuffledOnset{}), feature("stop_sign", FixedOnset{at("sign + 3")})};
  profile.shuffles = {{{"red", "octagon"}, {at("sign + 1"), at("sign + 2")}}};
  return profile;
}

inline ProfileSpec p3() {
  ProfileSpec profile;
  profile.name = "P3";
  profile.features = {feature("sign", UniformOnset{0, 3}),
                      feature("red", UniformOnset{at("octagon"), at("never")}),
                      feature("octagon", UniformOnset{at("sign"), at("never")}),
                      feature("stop_sign", UniformOnset{at("red"), at("never")})};
  return profile;
}

/// What the policy knows: the four inputs now, and whether the sign was seen one step before.
struct View {
  bool sign, red, octagon, stop_sign, sign_before;
};
using Policy = std::function<bool(const View&)>;

inline bool base(const View& v) {
  return v.stop_sign;
}
inline bool tree(const View& v) {
  return v.sign_before && v.red;
}
inline bool awareness(const View& v) {
  return v.sign + v.red + v.octagon >= 2;
}

/// Counts the steps: 0 before the blank observation, then the cells in locations 4 ... 0, and again. Outputs:
/// the location in which the observation was made, and whether the sign is detected.
inline model::Mealy machine(const Policy& policy) {
  constexpr std::uint32_t steps = 6;
  std::vector<model::Variable> inputs;
  for (const char* name : {"sign", "red", "octagon", "stop_sign"})
    inputs.push_back({name, model::Domain::boolean(), {}, {}});
  const model::Variable location{"location", model::Domain::integer(0, 4), {}, {}};
  const model::Variable detected{"detected", model::Domain::boolean(), {}, {}};
  model::MealyBuilder builder(
      "by hand", inputs, {{location, model::OutputRole::Plant}, {detected, model::OutputRole::Recognised}});
  for (std::uint32_t state = 0; state < 2 * steps; ++state) builder.add_state();
  for (std::uint32_t state = 0; state < 2 * steps; ++state) {
    const std::uint32_t step = state % steps;
    for (std::int32_t bits = 0; bits < 16; ++bits) {
      const model::Valuation input{bits & 1, bits >> 1 & 1, bits >> 2 & 1, bits >> 3 & 1};
      const bool yes = policy({input[0] != 0, input[1] != 0, input[2] != 0, input[3] != 0, state >= steps});
      const std::uint32_t next = (step == steps - 1 ? 1 : step + 1) + (input[0] != 0 ? steps : 0);
      builder.add(state, input, {step == 0 ? 0 : 5 - static_cast<std::int32_t>(step), yes ? 1 : 0}, next);
    }
  }
  return builder.finish();
}

/// "infeasible" for a detection in location 0 or none, else "stop in n".
inline Judge judge(const model::Mealy& mealy) {
  Judge result{{"infeasible", "stop in 1", "stop in 2", "stop in 3", "stop in 4"}, {}, 0};
  for (const model::Mealy::Transition& row : mealy.transitions) {
    const model::Valuation& output = mealy.output_letters[row.output];
    result.event.push_back(output[1] != 0 ? static_cast<std::uint32_t>(output[0]) : Judge::none);
  }
  return result;
}

inline Binding binding() {
  return {{0, 0, 0, 0}, {{0, 0, 1}, {1, 1, 1}, {2, 2, 1}, {3, 3, 1}}};
}

/// Everything that a Run refers to.
struct Chart {
  std::string name;
  Chain chain;
  model::Mealy mealy;
  Binding wiring;
  Judge judgement;
  std::vector<std::string> expected;  ///< Probability per category.
  [[nodiscard]] Run run() const { return {chain, mealy, wiring, judgement}; }
};

inline Chart chart(const ProfileSpec& profile, const std::string& name, const Policy& policy,
                   std::vector<std::string> expected) {
  util::Budget budget;
  model::Mealy mealy = machine(policy);
  Judge judgement = judge(mealy);
  return {profile.name + " " + name, compile(profile, budget), std::move(mealy), binding(),
          std::move(judgement),      std::move(expected)};
}

/// The nine charts with the figures of docs: [infeasible, stop in 1, 2, 3, 4].
inline std::vector<Chart> charts() {
  return {chart(p1(), "base", base, {"0.625", "0.1875", "0.1875", "0", "0"}),
          chart(p1(), "tree", tree, {"0.40625", "0.15625", "0.1875", "0.25", "0"}),
          chart(p1(), "awareness", awareness, {"0.296875", "0.140625", "0.1875", "0.375", "0"}),
          chart(p2(), "base", base, {"2/3", "1/3", "0", "0", "0"}),
          chart(p2(), "tree", tree, {"1/6", "1/3", "1/3", "1/6", "0"}),
          chart(p2(), "awareness", awareness, {"0", "1/3", "1/3", "1/3", "0"}),
          chart(p3(), "base", base, {"129691/144000", "20111/288000", "19153/864000", "671/108000", "1/864"}),
          chart(p3(), "tree", tree, {"631/800", "157/1200", "419/7200", "1/45", "0"}),
          chart(p3(), "awareness", awareness, {"19/40", "19/80", "37/240", "11/120", "1/24"})};
}

}  // namespace heed::sim::case_study
