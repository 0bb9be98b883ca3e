#include "cli/completion.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/command_tree.h"

namespace tribolog::cli {
namespace {

/// " archive list", as the scripts keep it: each word with a blank before it.
std::string key_of(const CLI::App& command) {
  const std::string path = path_of(command);
  return path.empty() ? "" : " " + path;
}

/// In single quotes, for any of the shells.
std::string in_shell_quotes(const std::string& text, const char* quote_within) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string(quote_within) : std::string(1, c);
  return quoted + "'";
}

std::string for_sh(const std::string& text) { return in_shell_quotes(text, "'\\''"); }
std::string for_fish(const std::string& text) { return in_shell_quotes(text, "\\'"); }

/// Those of the command and those that it takes from above.
std::vector<const CLI::Option*> options_taken_by(const CLI::App& command) {
  std::vector<const CLI::Option*> all;
  for (const CLI::App* at = &command; at != nullptr; at = at->get_parent()) {
    for (const CLI::Option* const option : options_of(*at)) {
      const bool is_there = std::any_of(all.begin(), all.end(), [&](const CLI::Option* one) {
        return main_name(*one) == main_name(*option);
      });
      if (!is_there) all.push_back(option);
    }
  }
  return all;
}

/// `case` patterns that go one command deeper.
std::string deeper_patterns(const CLI::App& program) {
  std::vector<std::string> patterns;
  for (const CLI::App* const command : all_commands(program)) {
    if (command != &program) patterns.push_back(for_sh(key_of(*command)));
  }
  return fmt::format("{}", fmt::join(patterns, "|"));
}

/// `case` patterns of the option behind its command: "' report -o'|' report --output'".
std::string option_patterns(const CLI::App& command, const CLI::Option& option) {
  std::vector<std::string> patterns;
  for (const std::string& name : names_of(option)) {
    patterns.push_back(for_sh(key_of(command) + " " + name));
  }
  return fmt::format("{}", fmt::join(patterns, "|"));
}

// bash and zsh: one function, which looks for the command among the words and then offers what
// may follow. `command` is a word of both shells, hence `at`.

constexpr const char* start_of_bash = R"(# Completion of tribolog for bash, made from its options.
_tribolog() {{
  local word="${{COMP_WORDS[COMP_CWORD]}}" previous="${{COMP_WORDS[COMP_CWORD-1]}}" at="" k
  if [[ $word == "=" ]]; then
    word=""
  elif [[ $previous == "=" ]]; then
    previous="${{COMP_WORDS[COMP_CWORD-2]}}"
  fi
  COMPREPLY=()
  for ((k = 1; k < COMP_CWORD; ++k)); do
    case "$at ${{COMP_WORDS[k]}}" in
      {}) at+=" ${{COMP_WORDS[k]}}" ;;
    esac
  done
)";

std::string bash_values(const CLI::App& program) {
  std::string cases = "  case \"$at $previous\" in\n";
  for (const CLI::App* const command : all_commands(program)) {
    for (const CLI::Option* const option : options_taken_by(*command)) {
      if (!takes_value(*option) || value_is_optional(*option)) continue;
      const std::vector<std::string> choices = choices_of(*option);
      cases +=
          fmt::format("    {})\n      COMPREPLY=($(compgen {} -- \"$word\")); return ;;\n",
                      option_patterns(*command, *option),
                      choices.empty() ? "-f" : fmt::format("-W '{}'", fmt::join(choices, " ")));
    }
  }
  return cases + "  esac\n";
}

std::string bash_words(const CLI::App& program) {
  std::string cases = "  local options=\"\" commands=\"\"\n  case \"$at\" in\n";
  for (const CLI::App* const command : all_commands(program)) {
    std::vector<std::string> options;
    for (const CLI::Option* const option : options_taken_by(*command)) {
      const std::vector<std::string> names = names_of(*option);
      options.insert(options.end(), names.begin(), names.end());
    }
    std::vector<std::string> commands;
    for (const CLI::App* const one : commands_of(*command)) commands.push_back(one->get_name());
    cases +=
        fmt::format("    {})\n      options='{}'\n      commands='{}' ;;\n",
                    for_sh(key_of(*command)), fmt::join(options, " "), fmt::join(commands, " "));
  }
  return cases + "  esac\n";
}

std::string bash_script(const CLI::App& program) {
  return fmt::format(start_of_bash, deeper_patterns(program)) + bash_values(program) +
         bash_words(program) + R"(  if [[ $word == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$word"))
  elif [[ -n $commands ]]; then
    COMPREPLY=($(compgen -W "$commands" -- "$word"))
  else
    COMPREPLY=($(compgen -f -- "$word"))
  fi
}
complete -o filenames -F _tribolog tribolog
)";
}

constexpr const char* start_of_zsh = R"(#compdef tribolog
# Completion of tribolog for zsh, made from its options.
_tribolog() {{
  local previous="${{words[CURRENT-1]}}" at="" k
  local -a options commands
  for ((k = 2; k < CURRENT; ++k)); do
    case "$at ${{words[k]}}" in
      {}) at+=" ${{words[k]}}" ;;
    esac
  done
)";

/// "name:what it is", as _describe takes it.
std::string described(const std::string& name, const std::string& what) {
  return for_sh(name + ":" + what);
}

std::string zsh_values(const CLI::App& program) {
  std::string cases = "  case \"$at $previous\" in\n";
  for (const CLI::App* const command : all_commands(program)) {
    for (const CLI::Option* const option : options_taken_by(*command)) {
      if (!takes_value(*option) || value_is_optional(*option)) continue;
      const std::vector<std::string> choices = choices_of(*option);
      cases += fmt::format(
          "    {}) {}; return ;;\n", option_patterns(*command, *option),
          choices.empty() ? "_files" : fmt::format("compadd -- {}", fmt::join(choices, " ")));
    }
  }
  return cases + "  esac\n";
}

std::string zsh_words(const CLI::App& program) {
  std::string cases = "  case \"$at\" in\n";
  for (const CLI::App* const command : all_commands(program)) {
    cases += fmt::format("    {})\n      options=(\n", for_sh(key_of(*command)));
    for (const CLI::Option* const option : options_taken_by(*command)) {
      for (const std::string& name : names_of(*option)) {
        cases += "        " + described(name, option->get_description()) + "\n";
      }
    }
    cases += "      )\n      commands=(\n";
    for (const CLI::App* const one : commands_of(*command)) {
      cases += "        " + described(one->get_name(), one->get_description()) + "\n";
    }
    cases += "      ) ;;\n";
  }
  return cases + "  esac\n";
}

std::string zsh_script(const CLI::App& program) {
  return fmt::format(start_of_zsh, deeper_patterns(program)) + zsh_values(program) +
         zsh_words(program) + R"(  if [[ ${words[CURRENT]} == -* ]]; then
    _describe option options
  elif (( ${#commands} )); then
    _describe command commands
  else
    _files
  fi
}
_tribolog "$@"
)";
}

// fish: a line for each command, option and word.

constexpr const char* start_of_fish = R"(# Completion of tribolog for fish, made from its options.
function __tribolog_at --description 'the command that the words name is this one'
  set -l at ''
  for word in (commandline --tokenize --cut-at-cursor --current-process)[2..-1]
    switch "$at $word"
      case {}
        set at "$at $word"
    end
  end
  test "$at" = "$argv[1]"
end
complete --command tribolog --condition "__tribolog_at ''" --no-files
)";

std::string fish_option(const CLI::App& command, const CLI::Option& option) {
  std::string line = fmt::format("complete --command tribolog --condition \"__tribolog_at '{}'\"",
                                 key_of(command));
  for (const std::string& name : option.get_snames()) line += " --short-option " + name;
  for (const std::string& name : option.get_lnames()) line += " --long-option " + name;
  const std::vector<std::string> choices = choices_of(option);
  if (takes_value(option) && !value_is_optional(option)) line += " --require-parameter";
  if (!choices.empty())
    line += fmt::format(" --no-files --arguments '{}'", fmt::join(choices, " "));
  return line + " --description " + for_fish(option.get_description()) + "\n";
}

std::string fish_script(const CLI::App& program) {
  std::vector<std::string> deeper;
  for (const CLI::App* const command : all_commands(program)) {
    if (command != &program) deeper.push_back(for_fish(key_of(*command)));
  }
  std::string script = fmt::format(start_of_fish, fmt::join(deeper, " "));
  for (const CLI::App* const command : all_commands(program)) {
    for (const CLI::App* const one : commands_of(*command)) {
      script += fmt::format(
          "complete --command tribolog --condition \"__tribolog_at '{}'\" --no-files --arguments "
          "{} --description {}\n",
          key_of(*command), one->get_name(), for_fish(one->get_description()));
    }
    for (const CLI::Option* const option : options_taken_by(*command)) {
      script += fish_option(*command, *option);
    }
  }
  return script;
}

}  // namespace

const std::vector<std::string>& shells_with_completion() {
  static const std::vector<std::string> shells{"bash", "zsh", "fish"};
  return shells;
}

std::string completion_script(const CLI::App& program, const std::string& shell) {
  if (shell == "bash") return bash_script(program);
  return shell == "zsh" ? zsh_script(program) : fish_script(program);
}

}  // namespace tribolog::cli
