#include <heed/report/write.h>
#include <heed/util/file.h>

#include <cstdio>
#include <string>

#include "unit/report/sample.h"

/// Writes the page and the document of the sample result into the folder that is named: what the browser test
/// reads.
int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: sample_report FOLDER\n", stderr);
    return 2;
  }
  const std::string folder = argv[1];
  const heed::report::RunResult result = heed::report::sample::result();
  heed::util::write_file(folder + "/report.html", heed::report::to_html(result));
  heed::util::write_file(folder + "/report.json", heed::report::to_json(result));
  heed::util::write_file(folder + "/report.txt", heed::report::to_text(result));
  return 0;
}
