#include "wording/message_pattern.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <stdexcept>

#include <fmt/format.h>

namespace tribolog::wording {
namespace {

[[noreturn]] void refuse(std::string_view message, const std::string& what) {
  throw std::invalid_argument("message \"" + std::string(message) + "\": " + what);
}

/// The report's numbers: digits, signs, exponents and intervals.
bool is_of_a_number(std::string_view text) {
  constexpr std::string_view plain = "0123456789.,+-e ";
  static constexpr std::string_view others[] = {"−", "±", "×", "–", "∞",      "⁻",
                                                "⁰", "¹", "²", "³", "⁴",      "⁵",
                                                "⁶", "⁷", "⁸", "⁹", "\u00a0", "\u202f"};
  while (!text.empty()) {
    std::size_t taken = plain.find(text.front()) != std::string_view::npos ? 1 : 0;
    for (const std::string_view other : others) {
      if (taken == 0 && text.starts_with(other)) taken = other.size();
    }
    if (taken == 0) return false;
    text.remove_prefix(taken);
  }
  return true;
}

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  for (std::size_t end = text.find(at); end != std::string_view::npos; end = text.find(at)) {
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  parts.push_back(text);
  return parts;
}

}  // namespace

MessagePattern::MessagePattern(std::string_view message) {
  std::string literal;
  for (std::size_t at = 0; at < message.size(); ++at) {
    if (message[at] != '{') {
      literal += message[at];
      continue;
    }
    const std::size_t end = message.find('}', at);
    if (end == std::string_view::npos) refuse(message, "a place is not closed");
    const std::string_view kind = message.substr(at + 1, end - at - 1);
    if (!kinds_.empty() && literal.empty()) refuse(message, "two places without text between");
    if (kind.empty()) {
      kinds_.push_back(Kind::any);
    } else if (kind == "n") {
      kinds_.push_back(Kind::number);
    } else if (kind == "t") {
      kinds_.push_back(Kind::translated);
    } else {
      refuse(message, fmt::format("{{{}}} is no kind of place", kind));
    }
    own_length_ += literal.size();
    literals_.push_back(std::move(literal));
    literal.clear();
    at = end;
  }
  own_length_ += literal.size();
  literals_.push_back(std::move(literal));
}

bool MessagePattern::fits(Kind kind, std::string_view text) {
  if (text.empty()) return false;
  if (kind != Kind::number) return true;
  const bool is_infinite = text.find("∞") != std::string_view::npos;
  return is_of_a_number(text) && text.front() != ' ' && text.back() != ' ' &&
         (is_infinite || std::any_of(text.begin(), text.end(), is_digit));
}

bool MessagePattern::match_from(std::size_t place, std::string_view rest,
                                std::vector<PlacedText>& found, int& tries) const {
  const std::string& next = literals_[place + 1];
  const bool is_last = place + 1 == kinds_.size();
  for (std::size_t end = 1; end <= rest.size() && --tries > 0; ++end) {
    if (is_last) {
      if (rest.size() < next.size() + 1 || !rest.ends_with(next)) return false;
      end = rest.size() - next.size();
    } else {
      end = rest.find(next, end);
      if (end == std::string_view::npos) return false;
    }
    const std::string_view text = rest.substr(0, end);
    if (fits(kinds_[place], text)) {
      found.push_back({text, kinds_[place] == Kind::translated});
      if (is_last || match_from(place + 1, rest.substr(end + next.size()), found, tries)) {
        return true;
      }
      found.pop_back();
    }
    if (is_last) return false;
  }
  return false;
}

std::optional<std::vector<PlacedText>> MessagePattern::match(std::string_view text) const {
  std::vector<PlacedText> found;
  if (!text.starts_with(literals_.front())) return std::nullopt;
  if (kinds_.empty()) {
    if (text == literals_.front()) return found;
    return std::nullopt;
  }
  int tries = most_tries;
  if (!match_from(0, text.substr(literals_.front().size()), found, tries)) return std::nullopt;
  return found;
}

int plural_form(std::string_view number) {
  long value = 0;
  const auto read = std::from_chars(number.data(), number.data() + number.size(), value);
  if (read.ec != std::errc() || read.ptr != number.data() + number.size() || value < 0) return 2;
  if (value == 1) return 0;
  const bool is_few = value % 10 >= 2 && value % 10 <= 4 && (value % 100 < 12 || value % 100 > 14);
  return is_few ? 1 : 2;
}

std::string fill_places(std::string_view translation, const std::vector<std::string>& texts) {
  std::string filled;
  for (std::size_t at = 0; at < translation.size(); ++at) {
    if (translation[at] != '{') {
      filled += translation[at];
      continue;
    }
    const std::size_t end = translation.find('}', at);
    if (end == std::string_view::npos) refuse(translation, "a place is not closed");
    const auto parts = split(translation.substr(at + 1, end - at - 1), '|');
    std::size_t place = texts.size();
    const char* const last = parts[0].data() + parts[0].size();
    const auto read = std::from_chars(parts[0].data(), last, place);
    const bool is_known = read.ec == std::errc() && read.ptr == last && place < texts.size();
    if (!is_known || (parts.size() != 1 && parts.size() != 4)) {
      refuse(translation, fmt::format("{{{}}} is no place of the message", parts[0]));
    }
    filled += parts.size() == 1
                  ? texts[place]
                  : std::string(parts[1 + static_cast<std::size_t>(plural_form(texts[place]))]);
    at = end;
  }
  return filled;
}

}  // namespace tribolog::wording
