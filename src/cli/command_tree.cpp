#include "cli/command_tree.h"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace tribolog::cli {

std::string path_of(const CLI::App& command) {
  const CLI::App* const above = command.get_parent();
  if (above == nullptr) return "";
  const std::string path = path_of(*above);
  return path.empty() ? command.get_name() : path + " " + command.get_name();
}

std::string typed(const CLI::App& command) {
  const std::string path = path_of(command);
  return path.empty() ? "tribolog" : "tribolog " + path;
}

const CLI::App& chosen_command(const CLI::App& program) {
  const std::vector<CLI::App*> chosen = program.get_subcommands();
  return chosen.empty() ? program : chosen_command(*chosen.front());
}

std::vector<const CLI::App*> commands_of(const CLI::App& command) {
  return command.get_subcommands([](const CLI::App* one) { return !one->get_group().empty(); });
}

std::vector<const CLI::App*> all_commands(const CLI::App& program) {
  std::vector<const CLI::App*> all{&program};
  for (const CLI::App* const command : commands_of(program)) {
    const std::vector<const CLI::App*> below = all_commands(*command);
    all.insert(all.end(), below.begin(), below.end());
  }
  return all;
}

std::vector<const CLI::Option*> options_of(const CLI::App& command) {
  return command.get_options([](const CLI::Option* one) { return !one->get_positional(); });
}

std::vector<const CLI::Option*> positionals_of(const CLI::App& command) {
  return command.get_options([](const CLI::Option* one) { return one->get_positional(); });
}

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

std::string main_name(const CLI::Option& option) {
  const std::vector<std::string> names = names_of(option);
  return names.empty() ? option.get_name(true) : names.back();
}

std::vector<std::string> choices_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t open = type.find('{');
  const std::size_t close = type.rfind('}');
  if (open == std::string::npos || close == std::string::npos) return {};
  std::vector<std::string> choices;
  std::string word;
  for (const char c : type.substr(open + 1, close - open - 1) + ",") {
    if (c != ',') {
      word += c;
    } else if (!word.empty()) {
      choices.push_back(std::move(word));
      word.clear();
    }
  }
  return choices;
}

std::string value_name(const CLI::Option& option) {
  if (!takes_value(option)) return "";
  const std::string type = option.get_type_name();
  const std::string name = type.substr(0, type.find(':'));
  if (name == "TEXT") {
    const bool is_folder = option.get_description().find("directory") != std::string::npos;
    return is_folder ? "DIRECTORY" : "TEXT";
  }
  return name == "UINT" || name == "INT" || name == "FLOAT" ? "NUMBER" : name;
}

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

bool value_is_optional(const CLI::Option& option) {
  return takes_value(option) && option.get_items_expected_min() == 0;
}

bool looks_like_option(const std::string& argument) {
  return argument.size() > 1 && argument.front() == '-';
}

const CLI::Option* find_option(const CLI::App& command, const std::string& argument) {
  const std::string name = argument.substr(0, argument.find('='));
  if (name.empty() || name.front() != '-') return nullptr;
  for (const CLI::App* at = &command; at != nullptr; at = at->get_parent()) {
    if (const CLI::Option* const found = at->get_option_no_throw(name)) return found;
  }
  return nullptr;
}

std::vector<std::string> long_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* at = &command; at != nullptr; at = at->get_parent()) {
    for (const CLI::Option* const option : options_of(*at)) {
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
  }
  return names;
}

void take_one_value_each(CLI::App& program) {
  for (CLI::Option* const option : program.get_options()) {
    if (!option->get_positional()) option->allow_extra_args(false);
  }
  for (CLI::App* const command : program.get_subcommands([](CLI::App*) { return true; })) {
    take_one_value_each(*command);
  }
}

}  // namespace tribolog::cli
