#include <charconv>
#include <optional>
#include <system_error>

#include "base/utf8.h"
#include "ingest/arrays/npy.h"

namespace tribolog::ingest::arrays {
namespace {

/// Digits of the code point behind \x, \u and \U.
std::size_t code_digits(char kind) {
  return kind == 'x' ? 2 : kind == 'u' ? 4 : kind == 'U' ? 8 : 0;
}

std::optional<char> plain_escape(char kind) {
  switch (kind) {
    case '\\':
    case '\'':
    case '"':
      return kind;
    case 'n':
      return '\n';
    case 'r':
      return '\r';
    case 't':
      return '\t';
    default:
      return std::nullopt;
  }
}

}  // namespace

void PythonText::skip_blanks() {
  const std::size_t first = rest_.find_first_not_of(" \n\t\r");
  rest_.remove_prefix(first == std::string_view::npos ? rest_.size() : first);
}

bool PythonText::take(char c) {
  skip_blanks();
  if (!rest_.starts_with(c)) return false;
  rest_.remove_prefix(1);
  return true;
}

bool PythonText::take(std::string_view word) {
  skip_blanks();
  if (!rest_.starts_with(word)) return false;
  rest_.remove_prefix(word.size());
  return true;
}

bool PythonText::take_escape(std::string& text) {
  if (rest_.empty()) return false;
  const char kind = rest_[0];
  rest_.remove_prefix(1);
  if (const auto plain = plain_escape(kind)) {
    text += *plain;
    return true;
  }
  const std::string_view digits = rest_.substr(0, code_digits(kind));
  std::uint32_t code_point{};
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), code_point, 16);
  const bool is_whole = !digits.empty() && digits.size() == code_digits(kind) &&
                        end == digits.data() + digits.size() && error == std::errc();
  const std::string character = is_whole ? utf8_of(code_point) : "";
  if (character.empty()) return false;
  text += character;
  rest_.remove_prefix(digits.size());
  return true;
}

bool PythonText::take_text(std::string& text) {
  skip_blanks();
  if (!rest_.starts_with('\'') && !rest_.starts_with('"')) return false;
  const char quote = rest_[0];
  rest_.remove_prefix(1);
  text.clear();
  while (!rest_.empty()) {
    const char c = rest_[0];
    rest_.remove_prefix(1);
    if (c == quote) return true;
    if (c != '\\') {
      text += c;
    } else if (!take_escape(text)) {
      return false;
    }
  }
  return false;
}

bool PythonText::take_number(std::uint64_t& number) {
  skip_blanks();
  const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
  if (error != std::errc()) return false;
  rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
  (void)take('L');  // Python 2 wrote 3L
  return true;
}

bool PythonText::is_at_end() {
  skip_blanks();
  return rest_.empty();
}

}  // namespace tribolog::ingest::arrays
