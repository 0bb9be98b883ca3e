#include "render/workers/statement_message.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/error.h"

namespace tribolog::render::workers {
namespace {

constexpr int deepest = 8;
constexpr std::size_t longest_code = 100;

/// As the alternatives of StatedValue::Value.
enum Kind : std::uint32_t { number_kind, count_kind, text_kind, statements_kind };

template <class Value>
Value take_plain(Message& message) {
  Value value{};
  message.take_raw(&value, sizeof value);
  return value;
}

Code take_code(Message& message) {
  const std::string text = message.take_text();
  const bool is_one =
      text.size() <= longest_code && std::all_of(text.begin(), text.end(), [](unsigned char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '.';
      });
  // What is no code must not be kept as one.
  if (!is_one) throw FigureError({"drawing.message_damaged"});
  return text.empty() ? Code() : Code::of(text);
}

Statement take(Message& message, int depth);

StatedValue::Value take_value(Message& message, int depth) {
  switch (message.take_number()) {
    case number_kind:
      return take_plain<double>(message);
    case count_kind:
      return take_plain<std::int64_t>(message);
    case text_kind:
      return message.take_text();
    case statements_kind: {
      std::vector<Statement> inner;
      const std::uint32_t count = message.take_number();
      for (std::uint32_t i = 0; i < count; ++i) inner.push_back(take(message, depth + 1));
      return inner;
    }
    default:
      throw FigureError({"drawing.message_damaged"});
  }
}

Statement take(Message& message, int depth) {
  if (depth > deepest) throw FigureError({"drawing.message_damaged"});
  const Code code = take_code(message);
  std::vector<StatedValue> values;
  const std::uint32_t count = message.take_number();
  for (std::uint32_t i = 0; i < count; ++i) {
    StatedValue one(message.take_text(), std::string());
    one.value = take_value(message, depth);
    values.push_back(std::move(one));
  }
  return Statement::with(code, std::move(values));
}

}  // namespace

void put_statement(Message& message, const Statement& statement) {
  message.put(std::string(statement.code().text()));
  message.put(static_cast<std::uint32_t>(statement.values().size()));
  for (const StatedValue& one : statement.values()) {
    message.put(one.name);
    message.put(static_cast<std::uint32_t>(one.value.index()));
    if (const auto* number = std::get_if<double>(&one.value)) {
      message.put_raw(number, sizeof *number);
    } else if (const auto* count = std::get_if<std::int64_t>(&one.value)) {
      message.put_raw(count, sizeof *count);
    } else if (const auto* text = std::get_if<std::string>(&one.value)) {
      message.put(*text);
    } else {
      const auto& inner = std::get<std::vector<Statement>>(one.value);
      message.put(static_cast<std::uint32_t>(inner.size()));
      for (const Statement& part : inner) put_statement(message, part);
    }
  }
}

Statement take_statement(Message& message) { return take(message, 0); }

}  // namespace tribolog::render::workers
