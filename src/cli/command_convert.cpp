#include "commands.h"
#include "output.h"

#include <heed/spec/dialect.h>
#include <heed/util/file.h>

#include <fmt/format.h>

namespace heed::cli {
namespace {

const std::vector<std::string> known{"slugsin", "structuredslugs", "gr1c", "gr1"};

/// What --to names, or else the extension of the file to write.
spec::Dialect target_of(const Arguments& arguments, const std::string& file) {
  const std::string word = arguments.text("--to");
  if (word.empty()) {
    if (file == "-") throw UsageError("--to is missing", "slugsin, structuredslugs, gr1c or gr1");
    return spec::dialect_of(util::SourceText(file, ""));
  }
  if (const auto dialect = spec::dialect_named(word)) return *dialect;
  throw UsageError(fmt::format("--to: unknown format '{}'", word), util::suggestion(word, known));
}

}  // namespace

int convert_command(const Arguments& arguments) {
  const util::Limits limits = arguments.limits();
  const std::string file = arguments.text("--output", "-");
  const spec::Dialect target = target_of(arguments, file);
  const util::SourceText source = util::read_file(arguments.operands().front(), limits);
  const spec::Gr1 spec = spec::read_any(source, limits);
  const std::string text = spec::write_as(spec, target);
  if (file != "-") util::write_file(file, text);
  if (arguments.json()) {
    Json out;
    out["from"] = std::string(spec::to_string(spec::dialect_of(source)));
    out["to"] = std::string(spec::to_string(target));
    out["inputs"] = spec.inputs.size();
    out["outputs"] = spec.outputs.size();
    if (file == "-")
      out["text"] = text;
    else
      out["file"] = file;
    print_json(out);
  } else if (file == "-") {
    print(text);
  }
  return 0;
}

}  // namespace heed::cli
