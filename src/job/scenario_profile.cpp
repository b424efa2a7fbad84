#include "scenario_profile.h"

#include <heed/sim/profile.h>
#include <heed/sim/rational.h>
#include <heed/util/diagnostic.h>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <tuple>

namespace heed::job {
namespace {

using sim::OnsetExpression;
using sim::Rational;

Rational probability(TomlTable& table, const std::string& key, const Rational& otherwise) {
  return table.has(key) ? sim::parse_rational(table.scalar(key)) : otherwise;
}

OnsetExpression from_of(TomlTable& table, const util::Limits& limits) {
  return table.has("from") ? sim::parse_onset(table.scalar("from"), limits) : OnsetExpression(0);
}

/// The two items of an array such as `uniform = [0, 2]`.
std::pair<util::SourceText, util::SourceText> pair_of(TomlTable& table, const std::string& key) {
  const auto items = table.scalars(key);
  if (items.size() != 2)
    table.fail(key, "wrong-type", fmt::format("'{}' takes two items, found {}", key, items.size()));
  return {items[0], items[1]};
}

/// One probability, or two: at the horizon and in the last cell.
std::pair<Rational, std::optional<Rational>> rate(TomlTable& table, const std::string& key,
                                                  const Rational& otherwise) {
  if (!table.is_array(key)) return {probability(table, key, otherwise), std::nullopt};
  const auto [begin, end] = pair_of(table, key);
  return {sim::parse_rational(begin), sim::parse_rational(end)};
}

sim::TableOnset table_onset(TomlTable& table, const util::Limits& limits) {
  sim::TableOnset onset;
  for (const util::SourceText& item : table.scalars("table")) onset.p.push_back(sim::parse_rational(item));
  onset.never = probability(table, "never", 0);
  onset.from = from_of(table, limits);
  return onset;
}

sim::Onset read_rule(TomlTable& table, const std::string& rule, const util::Limits& limits) {
  if (rule == "fixed") return sim::FixedOnset{sim::parse_onset(table.scalar("fixed"), limits)};
  if (rule == "uniform") {
    const auto [from, to] = pair_of(table, "uniform");
    return sim::UniformOnset{sim::parse_onset(from, limits), sim::parse_onset(to, limits)};
  }
  if (rule == "geometric")
    return sim::GeometricOnset{sim::parse_rational(table.scalar("geometric")), from_of(table, limits)};
  if (rule == "linear") {
    const auto [start, end] = pair_of(table, "linear");
    return sim::LinearOnset{sim::parse_rational(start), sim::parse_rational(end)};
  }
  return table_onset(table, limits);
}

/// The rule keys that stand in an entry.
std::vector<std::string> rules_in(TomlTable& table) {
  std::vector<std::string> found;
  for (const char* rule : {"fixed", "uniform", "geometric", "linear", "table"})
    if (table.has(rule)) found.emplace_back(rule);
  return found;
}

void read_shuffle(TomlTable& table, ProfilePart& part, const util::Limits& limits) {
  sim::ShuffleSpec shuffle;
  shuffle.location = table.location();
  for (const Word& word : table.words("shuffle")) shuffle.features.push_back(word.text);
  for (const util::SourceText& at : table.scalars("at")) shuffle.at.push_back(sim::parse_onset(at, limits));
  table.finish();
  part.spec.shuffles.push_back(std::move(shuffle));
}

void read_feature(TomlTable& table, ProfilePart& part, const util::Limits& limits) {
  sim::FeatureSpec feature;
  const Word name = table.word("feature");
  feature.name = name.text;
  feature.location = name.location;
  const auto rules = rules_in(table);
  if (rules.size() > 1)
    table.fail(rules[1], "two-rules",
               fmt::format("'{}' has two rules: {} and {}", name.text, rules[0], rules[1]));
  feature.onset = rules.empty() ? sim::Onset{sim::ShuffledOnset{}} : read_rule(table, rules.front(), limits);
  feature.absent = table.flag("absent", false);
  std::tie(feature.detection, feature.detection_at_end) = rate(table, "detection", 1);
  std::tie(feature.false_detection, feature.false_detection_at_end) = rate(table, "false_detection", 0);
  if (table.has("persistent")) feature.persistent = table.flag("persistent", true);
  table.finish();
  part.spec.features.push_back(std::move(feature));
}

/// What a feature is taken for need not be there itself.
void read_misreading(TomlTable& table, ProfilePart& part) {
  sim::Misreading misreading;
  const Word of = table.word("of"), as = table.word("as");
  misreading.of = of.text;
  misreading.as = as.text;
  misreading.location = of.location;
  if (!table.has("probability")) (void)table.scalar("probability");  // says that it is missing
  std::tie(misreading.probability, misreading.probability_at_end) = rate(table, "probability", 0);
  const Word per = table.optional_word("per").value_or(Word{"cell", table.location()});
  if (per.text != "cell" && per.text != "approach")
    throw util::InputError(per.location, "unknown-word",
                           fmt::format("a misreading is per cell or per approach, not '{}'", per.text),
                           util::suggestion(per.text, {"cell", "approach"}));
  misreading.per_approach = per.text == "approach";
  if (misreading.per_approach && misreading.probability_at_end)
    table.fail("probability", "wrong-type", "what is decided once has one probability",
               "leave out per, or give one number");
  table.finish();
  const bool known = std::any_of(part.spec.features.begin(), part.spec.features.end(),
                                 [&](const sim::FeatureSpec& f) { return f.name == as.text; });
  if (!known) {
    sim::FeatureSpec feature{as.text, sim::FixedOnset{}};
    feature.absent = true;
    feature.location = as.location;
    part.spec.features.push_back(std::move(feature));
  }
  part.spec.misreadings.push_back(std::move(misreading));
}

/// Shuffled features without an entry of their own are features all the same.
void add_shuffled(sim::ProfileSpec& spec) {
  for (const sim::ShuffleSpec& shuffle : spec.shuffles)
    for (const std::string& name : shuffle.features) {
      const bool known = std::any_of(spec.features.begin(), spec.features.end(),
                                     [&](const sim::FeatureSpec& f) { return f.name == name; });
      if (known) continue;
      sim::FeatureSpec feature;
      feature.name = name;
      feature.onset = sim::ShuffledOnset{};
      feature.location = shuffle.location;
      spec.features.push_back(std::move(feature));
    }
}

std::string bound(const OnsetExpression& e) {
  if (!e.text().empty()) return e.text();
  return e.items().size() == 1 ? std::to_string(e.items()[0].number) : "?";
}

std::string words_of(const Rational& begin, const std::optional<Rational>& end) {
  if (!end) return sim::fraction(begin);
  return fmt::format("{} at the horizon, linearly to {} in the last cell", sim::fraction(begin),
                     sim::fraction(*end));
}

std::string words_of(const sim::Misreading& misreading) {
  return fmt::format("{}: read as {} with probability {}, {}", misreading.of, misreading.as,
                     words_of(misreading.probability, misreading.probability_at_end),
                     misreading.per_approach ? "for the whole approach" : "in each cell anew");
}

std::string words_of(const sim::FeatureSpec& feature) {
  struct Words {
    std::string operator()(const sim::FixedOnset& o) const {
      return fmt::format("seen from cell {} on", bound(o.at));
    }
    std::string operator()(const sim::UniformOnset& o) const {
      return fmt::format("seen from a cell on that is uniform in {} ... {}", bound(o.from), bound(o.to));
    }
    std::string operator()(const sim::GeometricOnset& o) const {
      return fmt::format("turns on with probability {} per cell, from cell {} on", sim::fraction(o.p),
                         bound(o.from));
    }
    std::string operator()(const sim::LinearOnset& o) const {
      return fmt::format(
          "visible with a probability that grows linearly from {} at the horizon to {} in the last cell",
          sim::fraction(o.start), sim::fraction(o.end));
    }
    std::string operator()(const sim::TableOnset& o) const {
      std::string out;
      for (const Rational& p : o.p) out += (out.empty() ? "" : ", ") + sim::fraction(p);
      return fmt::format("onset by table from cell {} on: {}", bound(o.from), out);
    }
    std::string operator()(const sim::ShuffledOnset&) const { return {}; }
  };
  std::string words = std::visit(Words{}, feature.onset);
  if (words.empty()) return words;
  words = fmt::format("{}: {}", feature.name, words);
  if (feature.detection != 1 || feature.detection_at_end)
    words += "; reported with probability " + words_of(feature.detection, feature.detection_at_end);
  if (feature.false_detection != 0 || feature.false_detection_at_end)
    words += "; falsely reported with probability " +
             words_of(feature.false_detection, feature.false_detection_at_end);
  if (feature.persistent) words += *feature.persistent ? "; stays reported" : "; reported anew in each cell";
  return words;
}

/// Nothing but what something else is taken for.
bool only_misread(const sim::ProfileSpec& spec, const sim::FeatureSpec& feature) {
  return feature.absent && feature.false_detection == 0 && !feature.false_detection_at_end &&
         std::any_of(spec.misreadings.begin(), spec.misreadings.end(),
                     [&](const sim::Misreading& one) { return one.as == feature.name; });
}

void describe(ProfilePart& part) {
  for (const sim::FeatureSpec& feature : part.spec.features)
    if (std::string words = words_of(feature); !words.empty() && !only_misread(part.spec, feature))
      part.description.push_back(std::move(words));
  for (const sim::ShuffleSpec& shuffle : part.spec.shuffles) {
    std::string features, cells;
    for (const std::string& f : shuffle.features) features += (features.empty() ? "" : ", ") + f;
    for (const OnsetExpression& e : shuffle.at) cells += (cells.empty() ? "" : ", ") + bound(e);
    part.description.push_back(fmt::format("{}: in random order in cells {}", features, cells));
  }
  for (const sim::Misreading& one : part.spec.misreadings) part.description.push_back(words_of(one));
  if (part.spec.everything_visible_in)
    part.description.push_back(
        fmt::format("in cell {} everything is visible", *part.spec.everything_visible_in));
}

}  // namespace

ProfilePart read_profile(TomlTable& table, const util::Limits& limits) {
  ProfilePart part;
  const Word name = table.word("name");
  part.spec.name = name.text;
  part.spec.location = name.location;
  part.title = table.text("title", name.text);
  part.spec.cells = static_cast<std::uint32_t>(table.integer("cells", 5, 1, 10'000));
  if (table.has("everything_visible_in"))
    part.spec.everything_visible_in =
        static_cast<std::uint32_t>(table.integer("everything_visible_in", 0, 0, part.spec.cells - 1));
  part.spec.persistent = table.flag("persistent", true);
  for (TomlTable& entry : table.tables("onsets")) {
    if (entry.has("shuffle"))
      read_shuffle(entry, part, limits);
    else
      read_feature(entry, part, limits);
  }
  add_shuffled(part.spec);
  for (TomlTable& entry : table.tables("misreadings")) read_misreading(entry, part);
  table.finish();
  describe(part);
  return part;
}

}  // namespace heed::job
