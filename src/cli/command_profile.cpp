#include "commands.h"
#include "inputs.h"
#include "output.h"

#include <heed/report/write.h>
#include <heed/sim/marginals.h>
#include <heed/sim/rational.h>
#include <heed/util/file.h>

#include <fmt/format.h>

namespace heed::cli {
namespace {

/// One profile: a table to \p text, a list to \p documents, a picture to \p pictures.
struct Shown {
  std::string text;
  Json documents = Json::array();
  std::vector<report::ProfilePicture> pictures;
};

void show(const job::ProfilePart& profile, util::Budget& budget, Shown& shown) {
  const sim::Chain chain = sim::compile(profile.spec, budget);
  const auto reported = sim::reported_in_cell(chain);
  report::ProfilePicture picture{profile.spec.name, profile.title, {}};
  Json features = Json::array();
  shown.text += fmt::format("{}{}: {}\n", shown.text.empty() ? "" : "\n", profile.spec.name, profile.title);
  for (const std::string& line : profile.description) shown.text += fmt::format("  {}\n", line);
  for (std::size_t f = 0; f < reported.size(); ++f) {
    picture.features.emplace_back(chain.features[f], std::vector<double>());
    Json cells = Json::array();
    shown.text += fmt::format("  {:<16}", chain.features[f]);
    for (const sim::Rational& p : reported[f]) {
      picture.features.back().second.push_back(sim::to_double(p));
      cells.push_back(sim::fraction(p));
      shown.text += fmt::format(" {:>8}", sim::decimal(p, 4));
    }
    shown.text += '\n';
    features.push_back({{"feature", chain.features[f]}, {"reported", std::move(cells)}});
  }
  shown.documents.push_back({{"profile", profile.spec.name}, {"features", std::move(features)}});
  shown.pictures.push_back(std::move(picture));
}

}  // namespace

int profile_command(const Arguments& arguments) {
  util::Budget budget(arguments.limits());
  const job::Scenario scenario = load_scenario(arguments);
  if (scenario.profiles.empty())
    throw UsageError("the scenario has no [[profile]]", "docs/formats/profile.md says what it may hold");
  Shown shown;
  for (const job::ProfilePart& profile : scenario.profiles) show(profile, budget, shown);
  if (const std::string path = arguments.text("--output"); !path.empty())
    util::write_file(path, report::to_svg(shown.pictures));
  if (arguments.json())
    print_json(shown.documents);
  else
    print(shown.text);
  return 0;
}

}  // namespace heed::cli
