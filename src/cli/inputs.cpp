#include "inputs.h"

#include <heed/job/knowledge.h>
#include <heed/util/diagnostic.h>
#include <heed/util/file.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace heed::cli {
namespace {

std::vector<job::Word> words(const Arguments& arguments, const std::string& option) {
  std::vector<job::Word> words;
  for (const std::string& list : arguments.texts(option)) {
    std::size_t begin = 0;
    while (begin <= list.size()) {
      const std::size_t comma = std::min(list.find(',', begin), list.size());
      if (comma > begin) words.push_back({list.substr(begin, comma - begin), {}});
      begin = comma + 1;
    }
  }
  return words;
}

}  // namespace

bool is_scenario(const std::string& path) {
  return path.ends_with(".toml");
}

job::Scenario load_scenario(const Arguments& arguments) {
  const util::Limits limits = arguments.limits();
  return job::read_scenario(util::read_file(arguments.operands().front(), limits), limits);
}

job::KnowledgePart knowledge_part(const Arguments& arguments, util::Budget& budget,
                                  util::Diagnostics& notes) {
  const std::string& path = arguments.operands().front();
  if (is_scenario(path)) return load_scenario(arguments).knowledge;
  job::KnowledgePart part;
  part.ontology = {path, {}};
  part.entities = words(arguments, "--entities");
  part.features = words(arguments, "--features");
  part.behaviours = words(arguments, "--behaviours");
  part.feature_roles = words(arguments, "--feature-roles");
  part.action_roles = words(arguments, "--action-roles");
  if (const auto role = words(arguments, "--subclass-role"); !role.empty()) part.subclass_role = role.front();
  const bool named = !part.entities.empty() || !part.features.empty() || !part.behaviours.empty();
  if (!named) return job::guess_knowledge(part, arguments.limits(), budget, notes);
  if (part.entities.empty() || part.features.empty() || part.behaviours.empty())
    throw UsageError("--entities, --features and --behaviours go together",
                     "or leave all three out, to have them guessed");
  return part;
}

std::vector<const job::ControllerPart*> chosen_controllers(const Arguments& arguments,
                                                           const job::Scenario& scenario) {
  const std::vector<job::Word> wanted = words(arguments, "--controller");
  std::vector<std::string> known;
  for (const job::ControllerPart& part : scenario.controllers) known.push_back(part.name.text);
  for (const job::Word& word : wanted)
    if (std::find(known.begin(), known.end(), word.text) == known.end())
      throw UsageError(fmt::format("the scenario has no controller '{}'", word.text),
                       util::suggestion(word.text, known));
  std::vector<const job::ControllerPart*> chosen;
  for (const job::ControllerPart& part : scenario.controllers)
    if (wanted.empty() ||
        std::any_of(wanted.begin(), wanted.end(), [&](const auto& w) { return w.text == part.name.text; }))
      chosen.push_back(&part);
  return chosen;
}

util::Diagnostics reading_warnings(const job::Knowledge& knowledge) {
  constexpr std::size_t most = 5;
  std::set<std::pair<std::string, std::string>> of_catalogue;
  for (const awareness::Warning& warning : knowledge.catalogue.warnings)
    of_catalogue.emplace(warning.code, warning.message);
  std::map<std::string, std::size_t> count;
  util::Diagnostics result;
  for (const util::Diagnostic& diagnostic : knowledge.diagnostics) {
    if (diagnostic.severity != util::Severity::Warning) continue;
    if (of_catalogue.contains({diagnostic.code, diagnostic.message})) continue;
    if (++count[diagnostic.code] <= most) result.push_back(diagnostic);
  }
  for (const auto& [code, number] : count)
    if (number > most)
      result.push_back({util::Severity::Warning,
                        {},
                        code,
                        fmt::format("and {} more of these", number - most),
                        "--json lists them all",
                        {}});
  return result;
}

}  // namespace heed::cli
