#include "base/error.h"

#include <fmt/format.h>

#include "base/utf8.h"

namespace tribolog {
namespace {

constexpr std::size_t longest_part = 2000;

/// Control characters, and what moves or hides other text on a screen.
bool disturbs_the_terminal(char32_t c) { return is_control_character(c) || is_hidden_character(c); }

std::string escaped(std::string_view bytes) {
  std::string text;
  for (const char byte : bytes) {
    text += fmt::format("\\x{:02x}", static_cast<unsigned>(static_cast<unsigned char>(byte)));
  }
  return text;
}

std::string message_of(const Location& where, const InputError::Problem& problem) {
  std::string message = printable(where.file, longest_path);
  if (where.line > 0) message += fmt::format(":{}", where.line);
  if (where.line > 0 && where.column > 0) message += fmt::format(":{}", where.column);
  if (!message.empty()) message += ": ";
  message += printable(problem.what, longest_part);
  const auto add = [&](const char* before, const std::string& part) {
    if (!part.empty()) message += before + printable(part, longest_part);
  };
  add(", found ", problem.found);
  add(", expected ", problem.expected);
  add("; hint: ", problem.hint);
  return message;
}

}  // namespace

InputError::InputError(Location where, const Problem& problem)
    : Error(ExitStatus::input_refused, message_of(where, problem)), where_(std::move(where)) {}

FigureError::FigureError(Statement statement)
    : Error(ExitStatus::figure_failed, as_code(statement)), statement_(std::move(statement)) {}

Statement stated_by(const std::exception& error) {
  if (const auto* figure = dynamic_cast<const FigureError*>(&error)) return figure->statement();
  if (const auto* refusal = dynamic_cast<const Refusal*>(&error)) return refusal->statement();
  return Statement::verbatim(error.what());
}

std::string printable(const std::string& text, std::size_t limit) {
  constexpr std::string_view ellipsis = "…";
  std::string shown;
  std::size_t room_for_ellipsis = 0;  // where the text is cut if it turns out too long
  std::string_view rest = text;
  while (!rest.empty()) {
    const Utf8Character character = first_utf8_character(rest);
    const std::string_view bytes = rest.substr(0, character.bytes == 0 ? 1 : character.bytes);
    if (character.bytes == 0 || disturbs_the_terminal(character.code_point)) {
      shown += escaped(bytes);
    } else {
      shown += bytes;
    }
    if (shown.size() > limit) {
      shown.resize(room_for_ellipsis);
      return shown.append(ellipsis);
    }
    if (shown.size() + ellipsis.size() <= limit) room_for_ellipsis = shown.size();
    rest.remove_prefix(bytes.size());
  }
  return shown;
}

}  // namespace tribolog
