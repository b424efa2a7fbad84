// Reads and classifies an ontology: time and memory of each stage, one figure a line (row, column, value
// between tabs). Usage: owl_bench FILE..., or owl_bench --write terminology|populated|rdf FILE [SIZE [SEED]].
#include "generators/ontologies.h"

#include <heed/dl/reasoner.h>
#include <heed/owl/read.h>
#include <heed/util/diagnostic.h>
#include <heed/util/file.h>
#include <heed/util/limits.h>

#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

namespace {

using namespace heed;

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

double megabytes() {
  return static_cast<double>(util::peak_resident_bytes()) / 1e6;
}

void measure(const std::string& path) {
  const std::string row = std::filesystem::path(path).filename().string();
  const auto figure = [&](const char* column, double value) {
    fmt::print("{}\t{}\t{:.4f}\n", row, column, value);
  };
  util::Diagnostics diagnostics;
  util::Budget budget;
  const double start = processor_seconds();
  util::Limits limits;
  limits.input_bytes = 0;
  owl::ImportOptions imports;
  imports.allow_missing = true;
  owl::Ontology ontology = owl::load(path, imports, limits, diagnostics);
  const double read = processor_seconds();
  figure("read s", read - start);
  figure("read MB/s", static_cast<double>(std::filesystem::file_size(path)) / 1e6 / (read - start));
  figure("read MB", megabytes());
  const dl::Reasoner reasoner(std::move(ontology), budget);
  figure("classify s", processor_seconds() - read);
  figure("both s", processor_seconds() - start);
  figure("peak MB", megabytes());
  figure("axioms", static_cast<double>(reasoner.ontology().axioms().size()));
  figure("groups of classes", static_cast<double>(reasoner.taxonomy().nodes.size()));
  figure("consistent", reasoner.consistent() ? 1 : 0);
}

int write(const std::vector<std::string>& words) {
  const std::size_t size = words.size() > 3 ? std::strtoul(words[3].c_str(), nullptr, 10) : 0;
  const std::uint64_t seed = words.size() > 4 ? std::strtoull(words[4].c_str(), nullptr, 10) : 1;
  bench::Terminology terminology{.seed = seed};
  if (size >= 8) terminology = {.classes = size, .definitions = size / 10, .seed = seed};
  bench::PopulatedSigns populated{.seed = seed};
  if (size > 0) populated.axioms = size;
  if (words[1] == "terminology")
    util::write_file(words[2], bench::write_terminology(terminology));
  else if (words[1] == "populated")
    util::write_file(words[2], bench::write_populated(populated));
  else if (words[1] == "rdf")
    util::write_file(words[2], bench::write_terminology_rdf(terminology));
  else
    return 2;
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  int result = words.empty() ? 2 : 0;
  try {
    if (words.size() > 2 && words[0] == "--write")
      result = write(words);
    else
      for (const std::string& path : words) measure(path);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
  if (result != 0)
    fmt::print(stderr,
               "usage: owl_bench FILE...\n"
               "       owl_bench --write terminology|populated|rdf FILE [SIZE [SEED]]\n");
  return result;
}
