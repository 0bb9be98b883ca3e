#include "wording/message_table.h"

#include <cstddef>
#include <stdexcept>

#include <fmt/format.h>

namespace tribolog::wording {
namespace {

/// Takes the text in front of `mark` off, with the mark; what has none stays, and gives nothing.
std::string_view taken(std::string_view& text, std::string_view mark) {
  const std::size_t at = text.find(mark);
  if (at == std::string_view::npos) return {};
  const std::string_view front = text.substr(0, at);
  text.remove_prefix(at + mark.size());
  return front;
}

/// One line. @throw std::logic_error: it is none.
void add_message(std::string_view line, std::string_view& code_above, MessageTable& table) {
  const std::string_view code = taken(line, " ");
  const bool has_count = line.starts_with("[");
  if (has_count) line.remove_prefix(1);
  const std::string_view count = has_count ? taken(line, "] ") : std::string_view{};
  const std::string_view sign = taken(line, " ");
  const bool is_message = !code.empty() && (sign == "=" || (sign == "==" && !has_count)) &&
                          !line.empty() && line.front() != ' ' && line.back() != ' ';
  if (!is_message || (has_count && (count.empty() || code != code_above))) {
    throw std::logic_error("not 'code = text', nor a message above with [count] behind its code");
  }
  if (has_count) {
    Message& message = table.at(code);
    message.many = line;
    message.count = count;
    code_above = {};
  } else {
    if (!table.try_emplace(code, Message{line, {}, {}, sign == "=="}).second) {
      throw std::logic_error(fmt::format("'{}' has two messages", code));
    }
    code_above = sign == "=" ? code : std::string_view{};
  }
}

}  // namespace

MessageTable read_messages(const std::vector<EmbeddedFile>& files) {
  MessageTable table;
  table.reserve(2048);
  for (const EmbeddedFile& file : files) {
    std::string_view rest = file.text;
    std::string_view code_above;
    for (int number = 1; !rest.empty(); ++number) {
      const std::size_t end = rest.find('\n');
      const std::string_view line = rest.substr(0, end);
      rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
      if (line.empty() || line.front() == '#') continue;
      try {
        add_message(line, code_above, table);
      } catch (const std::logic_error& error) {
        throw std::logic_error(fmt::format("{}:{}: {}\n{}", file.name, number, error.what(), line));
      }
    }
  }
  return table;
}

const MessageTable& all_messages() {
  static const MessageTable table = read_messages(message_files());
  return table;
}

}  // namespace tribolog::wording
