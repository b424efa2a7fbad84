// From an OWL document to compiled recognition at any size, stage by stage. Usage: catalogue_bench [ENTITIES
// FEATURES [SEED]], or catalogue_bench --write FILE ENTITIES FEATURES [SEED] for the document alone, or
// catalogue_bench --scenario FOLDER ENTITIES FEATURES [SEED] for a scenario: `heed synth` goes from there to
// a certified controller.
#include "generators/sign_catalogue.h"

#include <heed/awareness/policy.h>
#include <heed/owl/read.h>
#include <heed/util/file.h>
#include <heed/util/limits.h>

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using namespace heed;

class Clock {
 public:
  void lap(const char* stage) {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    total_ += seconds;
    fmt::print("{:32} {:7.3f} s {:6} MB\n", stage, seconds, util::peak_resident_bytes() >> 20U);
    last_ = std::chrono::steady_clock::now();
  }
  [[nodiscard]] double total() const { return total_; }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  double total_ = 0;
};

awareness::CatalogueOptions options() {
  awareness::CatalogueOptions options;
  options.entities = {"Sign"};
  options.features = {"Feature"};
  options.behaviours = {"Behaviour"};
  options.feature_roles = {"hasFeature"};
  options.action_roles = {"hasAction"};
  return options;
}

void measure(const bench::SignCatalogue& wanted) {
  const std::string text = bench::write_catalogue(wanted);
  util::Budget budget;
  util::Diagnostics diagnostics;
  Clock clock;
  const auto ontology = owl::read(util::SourceText("catalogue.ofn", text), {}, diagnostics);
  clock.lap("read");
  const dl::Reasoner reasoner(ontology, budget);
  clock.lap("classify");
  const auto catalogue = awareness::build_catalogue(reasoner, options(), budget);
  clock.lap("catalogue");
  const auto perception = awareness::resolve_perception(catalogue, {});
  clock.lap("perception");
  awareness::PolicyOptions policy;
  const auto defined = awareness::compile_policy(catalogue, perception, policy);
  clock.lap("policy definition");
  const double until_here = clock.total();
  policy.kind = awareness::PolicyOptions::Kind::Identifying;
  policy.acting = awareness::PolicyOptions::Acting::Common;
  policy.closed = true;
  policy.direct = false;
  const auto identifying = awareness::compile_policy(catalogue, perception, policy);
  clock.lap("policy identifying, common");
  fmt::print("{} entities, {} features, {} warnings; {} and {} recognised; {:.3f} s up to 'definition'\n",
             catalogue.entities.size(), catalogue.features.size(), catalogue.warnings.size(),
             defined.entities.size(), identifying.entities.size(), until_here);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  std::string file, folder;
  if (words.size() > 1 && (words[0] == "--write" || words[0] == "--scenario")) {
    (words[0] == "--write" ? file : folder) = words[1];
    words.erase(words.begin(), words.begin() + 2);
  }
  bench::SignCatalogue wanted;
  if (!words.empty()) wanted.entities = std::strtoul(words[0].c_str(), nullptr, 10);
  if (words.size() > 1) wanted.features = std::strtoul(words[1].c_str(), nullptr, 10);
  if (words.size() > 2) wanted.seed = std::strtoull(words[2].c_str(), nullptr, 10);
  if (wanted.entities < 20 || wanted.features < 60) {
    fmt::print(
        stderr,
        "usage: catalogue_bench [--write FILE|--scenario FOLDER] [ENTITIES (from 20) FEATURES (from 60) "
        "[SEED]]\n");
    return 2;
  }
  if (!folder.empty())
    fmt::print("{}\n", bench::write_scenario(wanted, folder));
  else if (!file.empty())
    util::write_file(file, bench::write_catalogue(wanted));
  else
    measure(wanted);
}
