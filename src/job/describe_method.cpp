#include "describe.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace heed::job {
namespace {

std::string words(const std::vector<Word>& list) {
  std::vector<std::string> texts;
  for (const Word& word : list) texts.push_back(word.text);
  return texts.empty() ? "nothing" : fmt::format("{}", fmt::join(texts, " or "));
}

bool noisy(const sim::FeatureSpec& feature) {
  return feature.detection != 1 || feature.detection_at_end.value_or(1) != 1 ||
         feature.false_detection != 0 || feature.false_detection_at_end.value_or(0) != 0;
}

bool is_flawless(const sim::ProfileSpec& profile) {
  return profile.misreadings.empty() && std::none_of(profile.features.begin(), profile.features.end(), noisy);
}

class Method {
 public:
  Method(const Scenario& scenario, const World& world) : scenario_(scenario), world_(world) {}

  std::vector<std::string> sentences(std::uint64_t traces, std::uint64_t seed) {
    control();
    if (scenario_.evaluate && !scenario_.profiles.empty()) {
      approach();
      perception();
      judgement();
      arithmetic();
      sampling(traces, seed);
    }
    not_modelled();
    return std::move(out_);
  }

 private:
  void say(std::string sentence) { out_.push_back(std::move(sentence)); }

  void control() {
    say("Time: the controller sees the observation of a step and then chooses the action of that step; what "
        "the "
        "action does is seen in the next step.");
    say("Derived symbols are definitions over what is perceived: nobody can imagine a thing or react without "
        "reason.");
    if (scenario_.only_when_prescribed)
      say("A bound behaviour happens when it is prescribed and for no other reason.");
    if (!world_.plant.deterministic())
      say("Where the plant's action has several outcomes, the one that is worst for the controller counts.");
    say("Every controller was verified by a checker that shares no code with the solver; it was then written "
        "to disk "
        "and read back before it was evaluated.");
  }

  void approach() {
    std::vector<std::string> cells;
    for (const ProfilePart& profile : scenario_.profiles)
      cells.push_back(fmt::format("{} of {}", profile.spec.cells, profile.spec.name));
    const EvaluatePart& part = *scenario_.evaluate;
    say(fmt::format(
        "Cells: an approach is cut into cells ({}); one step passes one cell, whatever the controller does. "
        "Cell 0 is the horizon, beyond which nothing is seen; the last one is the place of the thing.",
        fmt::join(cells, ", ")));
    if (part.speed_wanted)
      say(fmt::format(
          "Speed: a cell is {} m long and is approached at {} km/h, one cell every {:.2f} s. Braking is "
          "constant, v² / 2d over the whole cells that are left; 0 cells left is past the line.",
          part.cell_metres, part.speed_kmh, part.cell_metres / part.speed_kmh * 3.6));
    say(fmt::format(
        "A run begins with one observation in which nothing is in view, then comes one observation per cell. "
        "The first step in which `{}` holds decides the outcome; without one the outcome is \"{}\".",
        part.event.text, part.outcomes[part.rest].label));
  }

  void perception() {
    say("Independence and order: the rules of a profile are all that is assumed of perception. Each draw is "
        "independent "
        "of all others, given the onsets that its rule refers to; it does not depend on what the controller "
        "does, nor on "
        "the other things of a road.");
    std::vector<std::string> flawless;
    for (const ProfilePart& profile : scenario_.profiles)
      if (is_flawless(profile.spec)) flawless.push_back(profile.spec.name);
    if (!flawless.empty())
      say(fmt::format(
          "{}: what is in view is reported, and stays reported, in every cell; nothing is missed, misread or "
          "reported falsely.",
          fmt::join(flawless, ", ")));
    for (const ProfilePart& profile : scenario_.profiles)
      if (!is_flawless(profile.spec)) noise(profile.spec);
    say("On the way past a thing, what the ontology entails of it can be seen, in the order of the profile; "
        "what it does "
        "not have never appears, unless the profile reports it falsely or takes something else for it.");
    if (scenario_.perception.persistent || !scenario_.perception.assume.empty())
      say("The specification assumes more of perception, as listed there. Where a profile breaks that, a "
          "warning says "
          "with which probability, and who answers.");
  }

  void noise(const sim::ProfileSpec& profile) {
    const bool flickers =
        std::any_of(profile.features.begin(), profile.features.end(), [&](const auto& feature) {
          return noisy(feature) && !feature.persistent.value_or(profile.persistent);
        });
    say(fmt::format(
        "{}: features are missed{} or reported falsely at the rates of the profile, for each cell and each "
        "feature by itself{}.",
        profile.name, profile.misreadings.empty() ? "" : ", misread",
        flickers ? "; what was reported may be gone in the next cell" : "; what was rightly reported stays"));
  }

  void judgement() {
    const EvaluatePart& part = *scenario_.evaluate;
    say(fmt::format(
        "Errors: a miss is the outcome \"{}\" where {} is prescribed, or no reaction at all; a needless "
        "reaction is any reaction where {} is not. Each thing of the catalogue is approached alone, from the "
        "start; in "
        "means "
        "over things each counts the same, which says nothing of how often it stands on real roads.",
        part.outcomes[part.miss].label, words(part.must_react), words(part.may_react)));
  }

  void arithmetic() {
    say("Exact: every probability, expected distance and expected count, by dynamic programming over the "
        "product of profile and "
        "controller, as fractions. Where these would cost more than 2 · 10^7 words of arithmetic they are "
        "doubles, with a proved "
        "bound on the error beside them; a comparison of policies takes the upper end.");
  }

  void sampling(std::uint64_t traces, std::uint64_t seed) {
    if (traces == 0) return say("Nothing is sampled.");
    say(fmt::format(
        "Sampled: only the dots with whiskers, {} traces per chart, to check the exact figures. Traces are "
        "drawn "
        "cell by cell and step the controller; they know nothing of the exact figures. The generator is "
        "Philox "
        "4x32-10 with seed {}: trace i depends on seed and i alone, not on threads or machines, and each "
        "probability is met to within 2^-64.",
        traces, seed));
    say(
        fmt::format("Intervals are Wilson's at {} %, each by itself; p values are Pearson's chi-square test "
                    "of one chart, not "
                    "corrected for the number of charts, so that one in twenty may well lie below 0.05.",
                    100 * scenario_.evaluate->confidence));
  }

  void not_modelled() {
    say("Not modelled: motion within a cell, tyres and slopes, how long seeing and computing take, other "
        "traffic, several things "
        "in view at once, and any dependence of perception on weather, speed or the car's own motion beyond "
        "the profiles.");
  }

  const Scenario& scenario_;
  const World& world_;
  std::vector<std::string> out_;
};

}  // namespace

std::vector<std::string> describe_method(const Scenario& scenario, const World& world, std::uint64_t traces,
                                         std::uint64_t seed) {
  return Method(scenario, world).sentences(traces, seed);
}

}  // namespace heed::job
