#include "tune_measure.h"

#include <heed/job/tune.h>

#include <heed/job/clashes.h>
#include <heed/logic/parse.h>
#include <heed/util/diagnostic.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string_view>

namespace heed::job {
namespace {

constexpr std::size_t most_features = 4;

bool less(const sim::Figure& a, const sim::Figure& b) {
  return a.exact && b.exact ? *a.exact < *b.exact : a.value < b.value;
}

/// Surely.
bool at_most(const sim::Figure& a, const sim::Rational& bound) {
  return a.exact ? *a.exact <= bound : sim::Rational(a.value) + sim::Rational(a.error) <= bound;
}

bool dominates(const TuneFigure& a, const TuneFigure& b) {
  const bool no_worse =
      !less(b.miss, a.miss) && !less(b.needless, a.needless) && !less(a.distance, b.distance);
  return no_worse && (less(a.miss, b.miss) || less(a.needless, b.needless) || less(b.distance, a.distance));
}

struct Policy {
  std::string words;
  ControllerPart part;
};

class Tuner {
 public:
  Tuner(const Scenario& scenario, const World& world, const TuneOptions& options, util::Budget& budget)
      : scenario_(scenario),
        world_(world),
        options_(options),
        budget_(budget),
        measure_(scenario, world, budget) {
    const auto& approached = scenario.evaluate->approached;
    if (!approached)
      throw util::InputError(util::Location{}, "missing-key", "what is to be approached?",
                             "name it as 'approached' in [evaluate]");
    approached_ = *approached;
    thing_ = world.knowledge.catalogue.entity(awareness::Name(approached_.text, approached_.location));
    find_features();
    tuning_.noise = options.noise;
  }

  Tuning run() {
    list_policies();
    for (const Policy& policy : policies_) evaluate_policy(policy);
    if (tuning_.policies.empty())
      throw util::InputError(approached_.location, "no-policy",
                             "no policy is possible: " + tuning_.left_out.front().reason,
                             "report more of what it shows, or name features in a controller's 'over'");
    for (std::size_t p = 0; p < scenario_.profiles.size(); ++p)
      for (std::size_t n = 0; n < tuning_.noise.size(); ++n) measure_.measure({thing_, p, n}, tuning_);
    mark_fronts();
    choose();
    return std::move(tuning_);
  }

 private:
  void find_features() {
    for (const ControllerPart& part : scenario_.controllers)
      if (features_.empty()) features_ = part.over;
    const awareness::Catalogue& catalogue = world_.knowledge.catalogue;
    if (features_.empty())
      for (const auto& described : catalogue.described(thing_, world_.perception.perceivable))
        features_.push_back({catalogue.features[described.index].atom, approached_.location});
    if (features_.size() <= most_features) return;
    throw util::InputError(
        features_.front().location, "too-many-features",
        fmt::format("{} features have too many orders to try", features_.size()),
        fmt::format("let a controller's 'over' name the {} that matter most", most_features));
  }

  static std::string words(const std::vector<Word>& features, const char* between) {
    std::vector<std::string> texts;
    for (const Word& word : features) texts.push_back(word.text);
    return fmt::format("{}", fmt::join(texts, between));
  }

  void add(const std::string& text, const char* policy, const auto& set) {
    Policy made{text, {}};
    made.part.name = {fmt::format("policy-{}", policies_.size() + 1), {}};
    made.part.title = text;
    made.part.policy = {policy, approached_.location};
    made.part.entities = {approached_};
    made.part.closed =
        std::any_of(scenario_.controllers.begin(), scenario_.controllers.end(),
                    [&](const ControllerPart& part) { return part.closed && part.policy.text == policy; });
    set(made.part);
    policies_.push_back(std::move(made));
  }

  void list_policies() {
    add("read whole", "full", [](ControllerPart&) {});
    add("definition", "definition", [](ControllerPart&) {});
    for (std::size_t k = 1; k <= features_.size(); ++k)
      add(fmt::format("at least {} of {}", k, words(features_, ", ")), "at-least", [&](ControllerPart& part) {
        part.k = k;
        part.over = features_;
      });
    std::vector<std::size_t> order;
    add_trees(order);
    if (options_.simple) return;
    for (const char* acting : {"cautious", "common", "brave"})
      add(fmt::format("identifying, {}", acting), "identifying", [&](ControllerPart& part) {
        part.behaviours = Word{acting, approached_.location};
        part.entities.clear();
      });
  }

  /// Of simple policies one kind of tree, with full reading where there is any; and those of the scenario.
  [[nodiscard]] bool wanted(std::string_view policy, const std::vector<Word>& path) const {
    if (!options_.simple || (policy == "tree-or-full") == read_whole()) return true;
    const auto same = [](const Word& a, const Word& b) { return a.text == b.text; };
    return std::any_of(scenario_.controllers.begin(), scenario_.controllers.end(), [&](const auto& own) {
      return own.policy.text == policy &&
             std::equal(own.order.begin(), own.order.end(), path.begin(), path.end(), same);
    });
  }

  [[nodiscard]] bool read_whole() const {
    for (const awareness::PerceptionInput& input : world_.perception.inputs)
      for (const awareness::PerceptionInput::Meaning& meaning : input.meanings)
        if (meaning.whole == thing_) return true;
    return false;
  }

  /// Every order of two features or more that begins with \p order. As deep as there are features.
  void add_trees(std::vector<std::size_t>& order) {
    if (order.size() >= 2) {
      std::vector<Word> path;
      for (const std::size_t f : order) path.push_back(features_[f]);
      for (const char* policy : {"tree", "tree-or-full"})
        if (wanted(policy, path))
          add(fmt::format("{} {}", policy, words(path, " -> ")), policy,
              [&](ControllerPart& part) { part.order = path; });
    }
    if (options_.simple && order.size() == 2) return;
    for (std::size_t f = 0; f < features_.size(); ++f) {
      if (std::find(order.begin(), order.end(), f) != order.end()) continue;
      order.push_back(f);
      add_trees(order);
      order.pop_back();
    }
  }

  void evaluate_policy(const Policy& policy) {
    Synthesized done;
    std::vector<std::size_t> own;
    try {
      const Design designed = design(scenario_, world_, policy.part);
      (void)settle_clashes(scenario_, world_, designed, budget_);
      own = own_of(policy, designed);
      done = synthesize(designed, scenario_.perception.on_violation, budget_);
    } catch (const util::InputError& error) {
      tuning_.left_out.push_back({policy.words, error.diagnostic().message});
      return;
    }
    if (!done.result.realizable || !done.verdict || !done.verdict->verified) {
      tuning_.left_out.push_back({policy.words, "no controller keeps the guarantees with it"});
      return;
    }
    for (const std::size_t controller : own) tuning_.own.push_back({tuning_.policies.size(), controller});
    tuning_.policies.push_back(policy.words);
    measure_.add(std::move(*done.result.machine));
  }

  /// The controllers of the scenario that are this policy: they recognise the same in the same way.
  std::vector<std::size_t> own_of(const Policy& policy, const Design& designed) {
    std::vector<std::size_t> same;
    for (std::size_t c = 0; c < scenario_.controllers.size(); ++c) {
      const ControllerPart& own = scenario_.controllers[c];
      if (own.policy.text != policy.part.policy.text) continue;
      if (own_designs_.size() <= c) own_designs_.resize(scenario_.controllers.size());
      if (!own_designs_[c]) own_designs_[c] = rules_of(design(scenario_, world_, own));
      if (*own_designs_[c] == rules_of(designed)) same.push_back(c);
    }
    return same;
  }

  static std::string rules_of(const Design& designed) {
    std::string rules;
    for (const spec::Memory& memory : designed.composed.spec.memories)
      rules += memory.variable.name + " := " + logic::to_string(memory.update) + '\n';
    for (const spec::Definition& definition : designed.composed.spec.definitions)
      rules += definition.name + " <-> " + logic::to_string(definition.formula) + '\n';
    return rules;
  }

  void mark_fronts() {
    auto& figures = tuning_.figures;
    std::stable_sort(figures.begin(), figures.end(), [](const TuneFigure& a, const TuneFigure& b) {
      if (a.profile != b.profile) return a.profile < b.profile;
      if (a.noise != b.noise) return a.noise < b.noise;
      if (less(a.miss, b.miss) || less(b.miss, a.miss)) return less(a.miss, b.miss);
      return less(a.needless, b.needless);
    });
    for (TuneFigure& one : figures)
      one.on_front = std::none_of(figures.begin(), figures.end(), [&](const TuneFigure& other) {
        return other.profile == one.profile && other.noise == one.noise && dominates(other, one);
      });
  }

  /// By the worst case of each policy; the first of equals in the order in which policies are listed.
  void choose() {
    struct Worst {
      sim::Figure miss = sim::known(0), needless = sim::known(0);
    };
    std::vector<Worst> worst(tuning_.policies.size());
    for (const TuneFigure& figure : tuning_.figures) {
      Worst& of = worst[figure.policy];
      if (less(of.miss, figure.miss)) of.miss = figure.miss;
      if (less(of.needless, figure.needless)) of.needless = figure.needless;
    }
    for (std::size_t p = 0; p < worst.size(); ++p) {
      if (options_.most_needless && !at_most(worst[p].needless, *options_.most_needless)) continue;
      const bool better = !tuning_.best || less(worst[p].miss, worst[*tuning_.best].miss) ||
                          (!less(worst[*tuning_.best].miss, worst[p].miss) &&
                           less(worst[p].needless, worst[*tuning_.best].needless));
      if (better) tuning_.best = p;
    }
  }

  const Scenario& scenario_;
  const World& world_;
  const TuneOptions& options_;
  util::Budget& budget_;
  Word approached_;
  std::size_t thing_ = 0;
  std::vector<Word> features_;
  std::vector<Policy> policies_;
  std::vector<std::optional<std::string>> own_designs_;
  TuneMeasure measure_;
  Tuning tuning_;
};

}  // namespace

TuneOptions tune_options(const Scenario& scenario) {
  TuneOptions options;
  if (!scenario.tune) return options;
  options.most_needless = scenario.tune->most_needless;
  options.noise = scenario.tune->noise;
  return options;
}

Tuning tune(const Scenario& scenario, const World& world, const TuneOptions& options, util::Budget& budget) {
  return Tuner(scenario, world, options, budget).run();
}

}  // namespace heed::job
