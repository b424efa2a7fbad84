#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace heed::cli {

/// One option of a command. Help, man page, completion and parsing all come from this.
struct Option {
  std::string_view name;       ///< "--output"
  std::string_view value;      ///< "DIR"; empty for a switch; "[=N]" where it may be left out.
  std::string_view otherwise;  ///< Default, as text; empty: none.
  std::string_view range;      ///< "file|folder", "1 ... 64"; empty: any.
  std::string_view help;       ///< One sentence without full stop.
};

struct Operand {
  std::string_view name;  ///< "SCENARIO"
  std::string_view help;
  bool required = true;
  bool many = false;
};

class Arguments;

struct Command {
  std::string_view name;
  std::string_view summary;
  std::vector<Operand> operands;
  std::vector<Option> options;
  std::string_view example;
  std::function<int(const Arguments&)> run;
  bool shared = false;  ///< Processes that one mpirun started share its work.
};

/// Options that every command has.
[[nodiscard]] const std::vector<Option>& common_options();
[[nodiscard]] const std::vector<Command>& commands();

}  // namespace heed::cli
