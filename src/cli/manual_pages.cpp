#include "cli/manual_pages.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/command_tree.h"

namespace tribolog::cli {
namespace {

/// A text as it is: no character of it is obeyed.
std::string literal(const std::string& text) {
  std::string escaped;
  bool is_at_start = true;
  for (const char c : text) {
    if (is_at_start && (c == '.' || c == '\'')) escaped += "\\&";
    if (c == '\\') {
      escaped += "\\e";
    } else if (c == '-') {
      escaped += "\\-";
    } else {
      escaped += c;
    }
    is_at_start = c == '\n';
  }
  return escaped;
}

std::string name_of_page(const CLI::App& command) {
  std::string name = typed(command);
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

/// Lines that keep their breaks and indents.
std::string as_written(const std::string& text) {
  const std::size_t first = text.find_first_not_of('\n');
  if (first == std::string::npos) return "";
  return ".nf\n" + literal(text.substr(first, text.find_last_not_of('\n') + 1 - first)) + "\n.fi\n";
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// "-o, --output TEXT", and of one with words of its own those.
std::string heading_of(const CLI::Option& option) {
  const std::string value = value_name(option);
  std::string heading =
      fmt::format("\\fB{}\\fR", literal(fmt::format("{}", fmt::join(names_of(option), ", "))));
  if (value.empty()) return heading;
  return heading + (value_is_optional(option) ? fmt::format(" [\\fI{}\\fR]", literal(value))
                                              : fmt::format(" \\fI{}\\fR", literal(value)));
}

/// "joint, motor"; empty where its description names each of them already.
std::string unnamed_choices(const CLI::Option& option) {
  const std::vector<std::string> choices = choices_of(option);
  const std::string description = option.get_description();
  const bool are_named = std::all_of(
      choices.begin(), choices.end(),
      [&](const std::string& choice) { return description.find(choice) != std::string::npos; });
  return are_named ? "" : fmt::format("{}", fmt::join(choices, ", "));
}

std::string options_section(const CLI::App& command) {
  std::string section = ".SH OPTIONS\n";
  for (const CLI::Option* const option : options_of(command)) {
    section += ".TP\n" + heading_of(*option) + "\n" + literal(option->get_description());
    const std::string choices = unnamed_choices(*option);
    if (!choices.empty()) section += literal("\nOne of: " + choices + ".");
    if (option->get_required()) section += "\nRequired.";
    if (!option->get_default_str().empty()) {
      section += literal(fmt::format("\nDefault: {}.", option->get_default_str()));
    }
    section += "\n";
  }
  return section;
}

std::string arguments_section(const CLI::App& command) {
  const std::vector<const CLI::Option*> arguments = positionals_of(command);
  if (arguments.empty()) return "";
  std::string section = ".SH ARGUMENTS\n";
  for (const CLI::Option* const one : arguments) {
    section += fmt::format(".TP\n\\fI{}\\fR\n{}\n", literal(main_name(*one)),
                           literal(one->get_description()));
  }
  return section;
}

std::string commands_section(const CLI::App& command) {
  const std::vector<const CLI::App*> commands = commands_of(command);
  if (commands.empty()) return "";
  std::string section = ".SH COMMANDS\n";
  for (const CLI::App* const one : commands) {
    section += fmt::format(".TP\n\\fB{}\\fR\n{}\n", literal(one->get_name()),
                           literal(one->get_description()));
  }
  return section;
}

/// "[OPTIONS] FILE..."
std::string synopsis(const CLI::App& command) {
  constexpr int many = 16;
  std::string line = fmt::format("\\fB{}\\fR [\\fIOPTIONS\\fR]", literal(typed(command)));
  for (const CLI::Option* const one : positionals_of(command)) {
    const std::string name = fmt::format("\\fI{}\\fR{}", literal(main_name(*one)),
                                         one->get_items_expected_max() >= many ? "..." : "");
    line += one->get_required() ? " " + name : " [" + name + "]";
  }
  return line + (commands_of(command).empty() ? "" : " \\fICOMMAND\\fR");
}

std::string see_also(const CLI::App& command) {
  std::vector<std::string> pages;
  if (command.get_parent() != nullptr) pages.push_back(name_of_page(*command.get_parent()));
  for (const CLI::App* const one : commands_of(command)) pages.push_back(name_of_page(*one));
  std::string section = ".SH SEE ALSO\n";
  for (std::size_t k = 0; k < pages.size(); ++k) {
    section += fmt::format(".BR {} (1){}\n", literal(pages[k]), k + 1 < pages.size() ? "," : "");
  }
  return section;
}

/// A command without notes of its own has the program's, the exit statuses.
bool has_notes_of_program(const CLI::App& command) {
  const CLI::App* program = &command;
  while (program->get_parent() != nullptr) program = program->get_parent();
  return command.get_footer() == program->get_footer();
}

constexpr const char* files_section = R"(.SH FILES
.TP
.I ~/.local/share/tribolog/archive.tribolog
the archive, where none is named
.TP
.I /usr/share/doc/tribolog
README.md, docs, the full description, and the examples
)";

ManualPage page_of(const CLI::App& command, const std::string& version) {
  const bool is_program = command.get_parent() == nullptr;
  const std::string name = name_of_page(command);
  ManualPage page{name + ".1", ""};
  page.text = fmt::format(".TH {} 1 \"\" \"tribolog {}\" \"User Commands\"\n.SH NAME\n{} \\- {}\n",
                          upper(literal(name)), version, literal(name),
                          literal(first_line(command.get_description())));
  page.text += ".SH SYNOPSIS\n" + synopsis(command) + "\n";
  if (is_program) page.text += ".SH DESCRIPTION\n" + as_written(command.get_description());
  page.text += commands_section(command) + arguments_section(command) + options_section(command);
  const std::string notes = as_written(command.get_footer());
  if (!notes.empty()) {
    page.text += (has_notes_of_program(command) ? ".SH EXIT STATUS\n" : ".SH NOTES\n") + notes;
  }
  if (is_program) page.text += files_section;
  page.text += see_also(command);
  return page;
}

/// Of a table's cell: nothing in it ends the cell or begins a tag.
std::string in_cell(const std::string& text) {
  std::string cell;
  for (const char c : text) {
    if (c == '|') {
      cell += "\\|";
    } else if (c == '<') {
      cell += "&lt;";
    } else {
      cell += c == '\n' ? ' ' : c;
    }
  }
  return cell;
}

/// "`-o`, `--output` TEXT"
std::string option_in_markdown(const CLI::Option& option) {
  const std::string value = value_name(option);
  const std::string shown = value_is_optional(option) ? "[" + value + "]" : value;
  return fmt::format("`{}`{}", fmt::join(names_of(option), "`, `"),
                     value.empty() ? "" : " " + in_cell(shown));
}

std::string rows_in_markdown(const CLI::App& command) {
  std::string rows;
  const auto add = [&](const std::string& name, const CLI::Option& option) {
    std::string states = option.get_description();
    const std::string choices = unnamed_choices(option);
    if (!choices.empty()) states += "; one of: " + choices;
    if (option.get_required()) states += "; required";
    if (!option.get_default_str().empty()) states += "; default: " + option.get_default_str();
    rows += fmt::format("| {} | {} |\n", name, in_cell(states));
  };
  for (const CLI::Option* const one : positionals_of(command))
    add("`" + main_name(*one) + "`", *one);
  for (const CLI::Option* const one : options_of(command)) {
    if (main_name(*one) == "--help") continue;
    add(option_in_markdown(*one), *one);
  }
  return rows.empty() ? "" : "| | |\n|---|---|\n" + rows;
}

}  // namespace

std::string command_reference(const CLI::App& command) {
  std::string text;
  for (const CLI::App* const one : all_commands(command)) {
    const std::string table = rows_in_markdown(*one);
    text += fmt::format("{}### {}\n\n{}\n{}", text.empty() ? "" : "\n", typed(*one),
                        first_line(one->get_description()), table.empty() ? "" : "\n" + table);
  }
  return text;
}

std::vector<ManualPage> manual_pages(const CLI::App& program, const std::string& version) {
  std::vector<ManualPage> pages;
  for (const CLI::App* const command : all_commands(program)) {
    pages.push_back(page_of(*command, version));
  }
  return pages;
}

}  // namespace tribolog::cli
