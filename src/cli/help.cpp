#include "help.h"

#include <heed/job/version.h>

#include <fmt/format.h>

#include <algorithm>

namespace heed::cli {
namespace {

constexpr std::string_view exit_codes =
    "0 done, realizable, verified; 1 unrealizable, refuted; 2 bad input or usage; 3 limit reached; 4 "
    "internal error";

std::string usage(const Command& command) {
  std::string line = fmt::format("heed {} [options]", command.name);
  for (const Operand& operand : command.operands)
    line += fmt::format(" {}{}{}{}", operand.required ? "" : "[", operand.name, operand.many ? " ..." : "",
                        operand.required ? "" : "]");
  return line;
}

std::string explained(const Option& option) {
  std::string text(option.help);
  if (!option.range.empty()) text += fmt::format(" ({})", option.range);
  if (!option.otherwise.empty()) text += fmt::format(" [{}]", option.otherwise);
  return text;
}

std::string spelled(const Option& option) {
  const std::string shorter = option.name == "--output" ? "-o, " : "";
  if (option.value.empty()) return shorter + std::string(option.name);
  const std::string_view space = option.value.starts_with('[') ? "" : " ";
  return fmt::format("{}{}{}{}", shorter, option.name, space, option.value);
}

/// For man(7): a dash that is a dash, and no line that begins with a control character.
std::string roff(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '-' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

}  // namespace

std::string help() {
  std::string out = fmt::format(
      "heed {} - from an ontology to a verified reactive controller\n\nusage: heed COMMAND [options] ...\n\n",
      job::version());
  for (const Command& command : commands()) out += fmt::format("  {:<10}{}\n", command.name, command.summary);
  out +=
      fmt::format("\nheed COMMAND --help shows its options and an example.\nExit codes: {}.\n", exit_codes);
  return out;
}

std::string help(const Command& command) {
  std::string out = fmt::format("usage: {}\n\n{}.\n", usage(command), command.summary);
  for (const Operand& operand : command.operands)
    out += fmt::format("\n  {:<24}{}", operand.name, operand.help);
  out += "\n";
  for (const auto* options : {&command.options, &common_options()}) {
    out += options == &command.options ? (options->empty() ? "" : "\noptions:\n")
                                       : "\noptions of every command:\n";
    for (const Option& option : *options)
      out += fmt::format("  {:<24}{}\n", spelled(option), explained(option));
  }
  return out + fmt::format("\nexample:\n  {}\n\nExit codes: {}.\n", command.example, exit_codes);
}

std::string man_page() {
  std::string out = fmt::format(
      ".TH HEED 1 \"\" \"heed {}\" \"User Commands\"\n.SH NAME\nheed \\- from an ontology to a verified "
      "reactive controller\n"
      ".SH SYNOPSIS\n.B heed\n.I COMMAND\n[options] ...\n.SH DESCRIPTION\n"
      "heed compiles what an autonomous system knows (an OWL 2 ontology), what it can do (a finite "
      "transition system) and "
      "what it must do (LTL) into a reactive controller, verifies it, and measures it.\n.SH COMMANDS\n",
      job::version());
  for (const Command& command : commands()) {
    out += fmt::format(".SS {}\n{}.\n", roff(usage(command)), roff(command.summary));
    for (const Operand& operand : command.operands)
      out += fmt::format(".TP\n.I {}\n{}\n", operand.name, roff(operand.help));
    for (const Option& option : command.options)
      out += fmt::format(".TP\n.B {}\n{}\n", roff(spelled(option)), roff(explained(option)));
    out += fmt::format(".PP\nExample:\n.PP\n.RS\n.nf\n{}\n.fi\n.RE\n", roff(command.example));
  }
  out += ".SH OPTIONS OF EVERY COMMAND\n";
  for (const Option& option : common_options())
    out += fmt::format(".TP\n.B {}\n{}\n", roff(spelled(option)), roff(explained(option)));
  return out + fmt::format(".SH EXIT STATUS\n{}.\n", exit_codes);
}

/// "synth --on-violation" and the words that it takes, for options that take one of a few.
std::string word_cases() {
  std::string cases;
  for (const Command& command : commands())
    for (const Option& option : command.options) {
      if (option.range.find('|') == std::string_view::npos) continue;
      std::string choices(option.range);
      std::replace(choices.begin(), choices.end(), '|', ' ');
      cases += fmt::format("    \"{} {}\") COMPREPLY=($(compgen -W \"{}\" -- \"$current\")); return ;;\n",
                           command.name, option.name, choices);
    }
  return cases;
}

std::string bash_completion() {
  std::string names, cases;
  for (const Command& command : commands()) {
    names += fmt::format("{} ", command.name);
    std::string options = "--help";
    for (const auto* list : {&command.options, &common_options()})
      for (const Option& option : *list) options += fmt::format(" {}", option.name);
    cases += fmt::format("    {}) words=\"{}\" ;;\n", command.name, options);
  }
  return fmt::format(
      "# bash completion for heed\n_heed() {{\n  local current=${{COMP_WORDS[COMP_CWORD]}} words=\n"
      "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n    COMPREPLY=($(compgen -W \"{}\" -- \"$current\"))\n    "
      "return\n  fi\n"
      "  case \"${{COMP_WORDS[1]}}\" in\n{}  esac\n"
      "  case \"${{COMP_WORDS[1]}} ${{COMP_WORDS[COMP_CWORD-1]}}\" in\n{}  esac\n"
      "  case \"$current\" in\n    -*) COMPREPLY=($(compgen -W \"$words\" -- \"$current\")) ;;\n"
      "    *) COMPREPLY=($(compgen -f -- \"$current\")) ;;\n  esac\n}}\ncomplete -o filenames -F _heed "
      "heed\n",
      names, cases, word_cases());
}

}  // namespace heed::cli
