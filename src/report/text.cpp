#include <heed/report/write.h>

#include <fmt/format.h>

#include <algorithm>

#include "format.h"
#include "lookup.h"
#include "text_table.h"

namespace heed::report {

namespace {

using Align = TextTable::Align;

class Writer {
 public:
  Writer(const RunResult& result, const TextOptions& options)
      : result_(result), details_(options.details), width_(std::max<std::size_t>(options.width, 60)) {}

  std::string write() {
    answer();
    if (details_) knowledge();
    warnings();
    controllers();
    outcomes();
    catalogue();
    roads();
    speed();
    closing();
    return std::move(text_);
  }

 private:
  void title(std::string_view words) {
    if (!text_.empty()) text_ += '\n';
    text_ += wrap(words, width_);
  }
  void item(std::string_view words) { text_ += wrap(words, width_, "  - "); }

  void answer() {
    title(result_.scenario);
    if (!result_.description.empty()) text_ += wrap(result_.description, width_, "  ");
    for (const std::string& sentence : result_.headline) item(sentence);
  }

  void knowledge() {
    if (result_.knowledge.empty()) return;
    title("What follows from the ontology (σ)");
    for (const KnowledgeFormula& formula : result_.knowledge) {
      text_ += wrap(formula.text, width_, fmt::format("  {}  ", clean(formula.id)));
      if (!formula.sentence.empty()) text_ += wrap(formula.sentence, width_, "      ");
      for (const Axiom& axiom : formula.axioms)
        text_ += wrap(fmt::format("{} ({})", axiom.text, util::to_string(axiom.location)), width_,
                      "      because ");
    }
  }

  void warnings() {
    if (result_.warnings.empty()) return;
    title("Warnings");
    for (const util::Diagnostic& warning : result_.warnings) {
      const std::string place = util::to_string(warning.location);
      item(fmt::format("{}{}{} [{}]", place, place.empty() ? "" : ": ", warning.message, warning.code));
    }
  }

  void controllers();
  void outcomes();
  void outcome_rows(TextTable& table, const Chart& chart, const std::vector<std::string>& labels) const;
  void catalogue();
  void roads();
  [[nodiscard]] std::string name_of(const std::string& controller) const;
  void speed();
  void closing();

  const RunResult& result_;
  const bool details_;
  const std::size_t width_;
  std::string text_;
};

std::string verdict_word(Verdict verdict) {
  switch (verdict) {
    case Verdict::Verified:
      return "verified";
    case Verdict::Refuted:
      return "REFUTED";
    case Verdict::Unrealizable:
      break;
  }
  return "UNREALIZABLE";
}

void Writer::controllers() {
  if (result_.controllers.empty()) return;
  title("Controllers");
  TextTable table({{"controller"},
                   {"check"},
                   {"states", Align::Right},
                   {"before", Align::Right},
                   {"transitions", Align::Right}});
  for (const Controller& controller : result_.controllers) {
    const bool built = controller.verdict != Verdict::Unrealizable;
    table.add({title_of(controller), verdict_word(controller.verdict),
               built ? grouped(controller.states) : "",
               built ? grouped(controller.states_before_minimisation) : "",
               built ? grouped(controller.transitions) : ""});
  }
  text_ += table.render(width_);
  for (const Controller& controller : result_.controllers) {
    if (!controller.policy.empty())
      item(fmt::format("{}: recognises when {}", title_of(controller), controller.policy));
    for (const std::string& note : controller.notes) item(fmt::format("{}: {}", title_of(controller), note));
    for (const std::string& reason : controller.reasons)
      item(fmt::format("{}: {}", title_of(controller), reason));
  }
}

std::string Writer::name_of(const std::string& name) const {
  for (const Controller& controller : result_.controllers)
    if (controller.name == name) return title_of(controller);
  return name;
}

void Writer::outcome_rows(TextTable& table, const Chart& chart,
                          const std::vector<std::string>& labels) const {
  std::vector<std::string> decimals{name_of(chart.controller)}, exact{""}, sampled{"  sampled"};
  bool rational = false;
  for (const std::string& label : labels) {
    const auto bar =
        std::find_if(chart.bars.begin(), chart.bars.end(), [&](const Bar& b) { return b.label == label; });
    const bool known = bar != chart.bars.end();
    decimals.push_back(known ? fixed(bar->exact.value, 4) : "-");
    exact.push_back(known ? bar->exact.exact : "");
    rational = rational || (known && bar->exact.exact.find('/') != std::string::npos);
    const double share =
        known && chart.traces > 0 ? static_cast<double>(bar->sampled) / static_cast<double>(chart.traces) : 0;
    sampled.push_back(known ? fixed(share, 4) : "");
  }
  if (chart.reaction) {
    decimals.push_back(fixed(chart.reaction->value, 4));
    exact.emplace_back();  // it would push the controller's name out of the line
    sampled.emplace_back();
  }
  table.add(std::move(decimals));
  if (rational) table.add(std::move(exact));
  if (details_ && chart.traces > 0) table.add(std::move(sampled));
}

void Writer::outcomes() {
  for (const Profile& profile : result_.profiles) {
    const std::vector<std::string> labels = bar_labels(result_, profile.name);
    if (labels.empty()) continue;
    title(profile.title.empty() ? profile.name : fmt::format("{}: {}", profile.name, profile.title));
    std::vector<TextTable::Column> columns{{"probability"}};
    for (const std::string& label : labels) columns.push_back({label, Align::Right});
    const bool reactions = std::any_of(result_.charts.begin(), result_.charts.end(), [&](const Chart& c) {
      return c.profile == profile.name && c.reaction;
    });
    if (reactions) columns.push_back({"cells left", Align::Right});
    TextTable table(std::move(columns));
    for (const Chart& chart : result_.charts)
      if (chart.profile == profile.name) outcome_rows(table, chart, labels);
    text_ += table.render(width_);
  }
}

void Writer::catalogue() {
  if (!has_errors(result_)) return;
  title(fmt::format("Past every {} of the catalogue", result_.kind));
  TextTable table({{"controller"},
                   {"reacts needlessly to", Align::Right},
                   {"worst", Align::Right},
                   {"at", Align::Left, 30},
                   {"can miss", Align::Right},
                   {fmt::format("with no {}", result_.kind)}});
  for (const Controller& controller : result_.controllers) {
    if (controller.verdict == Verdict::Unrealizable) continue;
    const ErrorCount count = count_errors(result_, controller.name);
    table.add({title_of(controller), fmt::format("{} of {}", count.needless, count.signs),
               percent(count.worst_needless), count.worst_sign,
               fmt::format("{} of {}", count.missed, count.halting), count.open_road ? "reacts" : "goes on"});
  }
  text_ += table.render(width_) + wrap(errors_explained(result_), width_, "  ");
}

void Writer::roads() {
  for (const Road& road : result_.roads) {
    title(fmt::format("Road: {}", road.title));
    text_ += wrap(road_explained(road), width_, "  ");
    std::vector<TextTable::Column> columns{{"profile"},
                                           {"controller"},
                                           {"needless", Align::Right},
                                           {"misses", Align::Right},
                                           {"needless a thing", Align::Right},
                                           {"misses a thing", Align::Right}};
    const bool conflicts = sees_conflicts(road);
    if (conflicts) columns.push_back({"conflict", Align::Right});
    TextTable table(std::move(columns));
    const auto number = [](const std::optional<Number>& one) {
      return one ? fixed(one->value, 4) : std::string("-");
    };
    for (const Drive& drive : road.drives) {
      std::vector<std::string> cells{
          drive.profile,        name_of(drive.controller),   number(drive.needless),
          number(drive.misses), number(drive.long_needless), number(drive.long_misses)};
      if (conflicts) cells.push_back(number(drive.conflict));
      table.add(std::move(cells));
    }
    text_ += table.render(width_);
  }
}

void Writer::speed() {
  if (result_.speed.curves.empty() || result_.charts.empty()) return;
  title(fmt::format("Braking from {} km/h, cells of {} m", compact(result_.speed.speed_kmh, 1),
                    compact(result_.speed.cell_metres, 1)));
  TextTable table(
      {{"outcome"}, {"distance", Align::Right}, {"deceleration", Align::Right}, {"the car's way"}});
  for (const SpeedCurve& curve : result_.speed.curves)
    table.add({curve.label, fmt::format("{} m", compact(curve.cells * result_.speed.cell_metres, 1)),
               fmt::format("{:.1f} m/s²", curve.deceleration), join(curve.states, " ")});
  text_ += table.render(width_);
}

void Writer::closing() {
  text_ += '\n';
  std::vector<std::string> versions;
  versions.reserve(result_.versions.size());
  for (const Version& version : result_.versions) versions.push_back(version.name + " " + version.version);
  std::string line = fmt::format("seed {}", result_.seed);
  if (!versions.empty()) line += ", " + join(versions, ", ");
  const Timings& timings = result_.timings;
  if (timings.cpu_seconds > 0) line += fmt::format("; {} of CPU", seconds(timings.cpu_seconds));
  if (timings.peak_bytes > 0) line += fmt::format(", {} at most", bytes(timings.peak_bytes));
  text_ += wrap(line, width_);
}

}  // namespace

std::string to_text(const RunResult& result, const TextOptions& options) {
  return Writer(result, options).write();
}

}  // namespace heed::report
