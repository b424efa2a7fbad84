#include "arguments.h"
#include "help.h"
#include "output.h"
#include "ranks.h"
#include "table.h"

#include <heed/util/diagnostic.h>
#include <heed/util/file.h>
#include <heed/util/limits.h>

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <memory>
#include <new>

namespace {

using namespace heed;

constexpr int bad_input = 2, limit_reached = 3, internal_error = 4;

/// With the line in question and a caret below it, where whoever threw did not have the text at hand.
util::Diagnostic with_line(const util::Diagnostic& told) {
  if (!told.excerpt.empty() || told.location.line == 0 || told.location.column == 0) return told;
  try {
    const util::SourceText file = util::read_file(std::string(told.location.file_name()));
    std::size_t offset = 0;
    for (std::uint32_t line = 1; line < told.location.line; ++line) {
      offset = file.text().find('\n', offset);
      if (offset++ == std::string::npos) return told;
    }
    util::Diagnostic shown =
        util::InputError(file, std::min(offset + told.location.column - 1, file.text().size()), told.code,
                         told.message, told.hint)
            .diagnostic();
    return shown.location == told.location ? shown : told;
  } catch (const util::InputError&) {  // gone or unreadable by now: the message stands without it
    return told;
  }
}

/// A message in the form that was asked for: text, or the one JSON document.
cli::Ending failure(bool json, int code, const util::Diagnostic& diagnostic) {
  if (!json) return {code, true, util::to_string(with_line(diagnostic)) + '\n'};
  cli::Json out;
  out["error"] = cli::to_json(diagnostic);
  out["exit_code"] = code;
  return {code, true, cli::to_text(out)};
}

/// Text to standard error, JSON to standard output.
int finish(bool json, const cli::Ending& ending) {
  if (json)
    cli::print(ending.message);
  else
    fmt::print(stderr, "{}", ending.message);
  return ending.code;
}

util::Diagnostic plain(std::string code, std::string message, std::string hint = {}) {
  return {util::Severity::Error, {}, std::move(code), std::move(message), std::move(hint), {}};
}

std::string hint_for(util::LimitExceeded::Kind kind) {
  switch (kind) {
    case util::LimitExceeded::Kind::Time:
      return "raise it with --timeout";
    case util::LimitExceeded::Kind::Memory:
      return "raise it with --memory";
    case util::LimitExceeded::Kind::Size:
      return "the problem is too large for an explicit answer";
    case util::LimitExceeded::Kind::Cancelled:
      break;
  }
  return {};
}

template <class Work>
cli::Ending attempt(bool json, const Work& work) {
  try {
    return {work(), false, {}};
  } catch (const cli::PeerFailed&) {
    return {};
  } catch (const cli::UsageError& error) {
    return failure(json, bad_input, plain("usage", error.what(), error.hint()));
  } catch (const util::InputError& error) {
    return failure(json, bad_input, error.diagnostic());
  } catch (const util::LimitExceeded& error) {
    return failure(json, limit_reached, plain("limit", error.what(), hint_for(error.kind())));
  } catch (const std::bad_alloc&) {
    return failure(json, limit_reached, plain("limit", "out of memory"));
  } catch (const std::exception& error) {
    return failure(
        json, internal_error,
        plain("internal", error.what(), "this is a defect of heed; please report it with the input"));
  }
}

int run(const cli::Command& command, const std::vector<std::string>& words) {
  const bool json = std::find(words.begin(), words.end(), "--json") != words.end();
  std::unique_ptr<cli::Ranks> ranks;
  cli::Ending ending = attempt(json, [&] {
    if (command.shared) ranks = cli::Ranks::join();
    cli::Arguments arguments = cli::parse_arguments(command, words);
    arguments.set_team(ranks.get());
    return command.run(arguments);
  });
  if (ranks) ending = ranks->end(std::move(ending));
  return finish(json, ending);
}

const cli::Command* find(const std::string& name) {
  const auto& commands = cli::commands();
  const auto found =
      std::find_if(commands.begin(), commands.end(), [&](const cli::Command& c) { return c.name == name; });
  return found == commands.end() ? nullptr : &*found;
}

int unknown_command(const std::string& name, bool json) {
  std::vector<std::string> names;
  for (const cli::Command& command : cli::commands()) names.emplace_back(command.name);
  return finish(json, failure(json, bad_input,
                              plain("usage", fmt::format("there is no command '{}'", name),
                                    util::suggestion(name, names, 20))));
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  std::vector<std::string> words(argv + 1, argv + argc);
  if (words.empty() || words[0] == "--help" || words[0] == "-h" || words[0] == "help") {
    const cli::Command* command = words.size() > 1 ? find(words[1]) : nullptr;
    cli::print(command != nullptr ? cli::help(*command) : cli::help());
    return words.empty() ? bad_input : 0;
  }
  const bool json = std::find(words.begin(), words.end(), "--json") != words.end();
  if (words[0] == "--json" && words.size() > 1) std::rotate(words.begin(), words.begin() + 1, words.end());
  if (words[0] == "--version") words[0] = "version";
  if (words[0] == "--man") return cli::print(cli::man_page()), 0;
  if (words[0] == "--bash-completion") return cli::print(cli::bash_completion()), 0;
  const cli::Command* command = find(words[0]);
  if (command == nullptr) return unknown_command(words[0], json);
  words.erase(words.begin());
  if (std::find_if(words.begin(), words.end(), [](const auto& w) { return w == "--help" || w == "-h"; }) !=
      words.end()) {
    cli::print(cli::help(*command));
    return 0;
  }
  return run(*command, words);
}
