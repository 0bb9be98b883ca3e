#include "base/statement.h"

#include <functional>
#include <mutex>
#include <set>

#include <fmt/format.h>

namespace tribolog {

Code Code::of(const std::string& text) {
  static std::mutex keeping;
  static std::set<std::string, std::less<>> kept;
  const std::lock_guard lock(keeping);
  return Code(std::string_view(*kept.insert(text).first));
}

Statement::Statement(Code code) : code_(code) {}

Statement::Statement(Code code, std::initializer_list<StatedValue> values)
    : code_(code), values_(values) {}

Statement Statement::with(Code code, std::vector<StatedValue> values) {
  Statement statement(code);
  statement.values_ = std::move(values);
  return statement;
}

Statement Statement::verbatim(const std::string& words) {
  return words.empty() ? Statement{} : Statement{Code("verbatim"), {{"words", words}}};
}

void Statement::add(const Statement& more) {
  constexpr Code together{"general.together"};
  if (more.empty()) return;
  if (empty()) {
    *this = more;
  } else if (is(together)) {
    std::get<std::vector<Statement>>(values_.front().value).push_back(more);
  } else {
    *this = {together, {{"parts", std::vector<Statement>{*this, more}}}};
  }
}

bool operator==(const Statement& a, const Statement& b) {
  return a.code_ == b.code_ && a.values_ == b.values_;
}

std::string as_code(const Statement& statement) {
  std::string text(statement.code().text());
  const char* before = " (";
  for (const StatedValue& one : statement.values()) {
    text.append(before).append(one.name).append(" ");
    if (const auto* number = std::get_if<double>(&one.value)) text += fmt::format("{}", *number);
    if (const auto* count = std::get_if<std::int64_t>(&one.value)) {
      text += fmt::format("{}", *count);
    }
    if (const auto* name = std::get_if<std::string>(&one.value)) text += *name;
    if (const auto* inner = std::get_if<std::vector<Statement>>(&one.value)) {
      for (const Statement& part : *inner) text.append("[").append(as_code(part)).append("]");
    }
    before = ", ";
  }
  return statement.values().empty() ? text : text + ")";
}

Statement with_texts(const Statement& statement, std::string (*shown)(const std::string& text)) {
  std::vector<StatedValue> values = statement.values();
  for (StatedValue& one : values) {
    if (auto* text = std::get_if<std::string>(&one.value)) *text = shown(*text);
    if (auto* inner = std::get_if<std::vector<Statement>>(&one.value)) {
      for (Statement& part : *inner) part = with_texts(part, shown);
    }
  }
  return Statement::with(statement.code(), std::move(values));
}

Refusal::Refusal(Statement statement)
    : std::invalid_argument(as_code(statement)), statement_(std::move(statement)) {}

}  // namespace tribolog
