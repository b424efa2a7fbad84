#include "commands.h"
#include "output.h"

#include <heed/export/cpp.h>
#include <heed/export/dot.h>
#include <heed/export/exec.h>
#include <heed/export/symbolic_runner.h>
#include <heed/model/mealy.h>
#include <heed/util/diagnostic.h>
#include <heed/util/file.h>

#include <fmt/format.h>

#include <iostream>

namespace heed::cli {
namespace {

model::Mealy load_controller(const Arguments& arguments) {
  const util::Limits limits = arguments.limits();
  return model::read_mealy(util::read_file(arguments.operands().front(), limits), limits);
}

std::string exported(const model::Mealy& machine, const std::string& format) {
  if (format == "cpp") return exporter::to_cpp(machine);
  if (format == "dot") return exporter::to_dot(machine);
  if (format == "json") return model::write_mealy(machine);
  throw UsageError(fmt::format("--to: unknown format '{}'", format),
                   util::suggestion(format, {"cpp", "json", "dot"}));
}

}  // namespace

int export_command(const Arguments& arguments) {
  const std::string format = arguments.text("--to", "cpp");
  const std::string text = exported(load_controller(arguments), format);
  const std::string target = arguments.text("--output", "-");
  if (target != "-") util::write_file(target, text);
  if (arguments.json()) {
    Json out;
    out["format"] = format;
    if (target != "-")
      out["file"] = target;
    else
      out["content"] = text;
    print_json(out);
  } else if (target == "-") {
    print(text);
  }
  return 0;
}

int exec_command(const Arguments& arguments) {
  const util::Limits limits = arguments.limits();
  const util::SourceText source = util::read_file(arguments.operands().front(), limits);
  exporter::LineExecutor executor =
      model::is_symbolic(source)
          ? exporter::LineExecutor(exporter::SymbolicRunner(model::read_symbolic(source, limits)))
          : exporter::LineExecutor(model::read_mealy(source, limits));
  std::ios::sync_with_stdio(false);
  executor.run(std::cin, std::cout);
  return 0;
}

}  // namespace heed::cli
