#include "wording/words.h"

#include <cmath>
#include <cstdint>
#include <cwctype>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <variant>

#include <fmt/args.h>
#include <fmt/format.h>
#include <locale.h>

#include "base/error.h"
#include "base/utf8.h"
#include "wording/message_table.h"
#include "wording/rounding.h"
#include "wording/torques_in.h"
#include "wording/tr.h"
#include "wording/translation.h"

namespace tribolog::wording {
namespace {

/// A number as a message has it, without an exponent and with a minus sign.
struct Shown {
  double value;
};

/// Words of several statements; the text between two of them stands where a number has its format.
struct Listed {
  std::vector<std::string> parts;
};

/// Keeps what a field has behind its colon.
struct FieldText {
  constexpr auto parse(fmt::format_parse_context& context) {
    const auto* end = context.begin();
    while (end != context.end() && *end != '}') ++end;
    behind_colon = {context.begin(), static_cast<std::size_t>(end - context.begin())};
    return end;
  }
  std::string_view behind_colon;
};

}  // namespace
}  // namespace tribolog::wording

template <>
struct fmt::formatter<tribolog::wording::Shown> : tribolog::wording::FieldText {
  auto format(const tribolog::wording::Shown& number, format_context& context) const {
    const std::string field = behind_colon.empty() ? "{}" : "{:" + std::string(behind_colon) + "}";
    const std::string printed = fmt::format(fmt::runtime(field), number.value);
    return fmt::format_to(
        context.out(), "{}",
        tribolog::wording::with_minus_sign(tribolog::wording::without_exponent(printed)));
  }
};

template <>
struct fmt::formatter<tribolog::wording::Listed> : tribolog::wording::FieldText {
  auto format(const tribolog::wording::Listed& listed, format_context& context) const {
    return fmt::format_to(context.out(), "{}", fmt::join(listed.parts, behind_colon));
  }
};

namespace tribolog::wording {
namespace {

using Arguments = fmt::dynamic_format_arg_store<fmt::format_context>;

const Message& message_of(std::string_view code) {
  const auto found = all_messages().find(code);
  if (found == all_messages().end()) {
    throw std::logic_error(fmt::format("there are no words for '{}'", code));
  }
  return found->second;
}

/// In the language of this thread's words.
std::string form_of(const Message& message, const Statement& statement) {
  if (message.is_the_same_everywhere) return std::string(message.one);
  if (message.count.empty()) return translated(message.one);
  for (const StatedValue& value : statement.values()) {
    if (value.name != message.count) continue;
    // What is counted may be known to a fraction: steps of an encoder in a travel.
    const auto* const size = std::get_if<double>(&value.value);
    const std::int64_t count =
        size != nullptr ? std::llround(*size) : std::get<std::int64_t>(value.value);
    return translated(message.one, message.many, count);
  }
  throw std::logic_error(fmt::format("'{}' states no {}", statement.code().text(), message.count));
}

std::string with_values(std::string_view message, std::span<const StatedValue> values) {
  Arguments arguments;
  for (const StatedValue& one : values) {
    const char* const name = one.name.c_str();
    if (const auto* number = std::get_if<double>(&one.value)) {
      arguments.push_back(fmt::arg(name, Shown{*number}));
    } else if (const auto* count = std::get_if<std::int64_t>(&one.value)) {
      arguments.push_back(fmt::arg(name, *count));
    } else if (const auto* text = std::get_if<std::string>(&one.value)) {
      arguments.push_back(fmt::arg(name, *text));
    } else {
      arguments.push_back(
          fmt::arg(name, Listed{words(std::get<std::vector<Statement>>(one.value))}));
    }
  }
  try {
    return fmt::vformat(shown_units(std::string(message)), arguments);
  } catch (const fmt::format_error& error) {
    throw std::logic_error(fmt::format("\"{}\": {}", message, error.what()));
  }
}

}  // namespace

std::string tr(std::string_view message, std::initializer_list<StatedValue> values) {
  return with_values(translated(message), values);
}

std::string tr_count(std::int64_t count, std::string_view one, std::string_view many,
                     std::initializer_list<StatedValue> values) {
  return with_values(translated(one, many, count), values);
}

std::string words(const Statement& statement) {
  if (statement.empty()) return {};
  return with_values(form_of(message_of(statement.code().text()), statement), statement.values());
}

std::vector<std::string> words(const std::vector<Statement>& statements) {
  std::vector<std::string> all;
  all.reserve(statements.size());
  for (const Statement& one : statements) all.push_back(words(one));
  return all;
}

std::string words(const std::exception& error) {
  try {
    return words(stated_by(error));
  } catch (const std::logic_error&) {  // must not take the place of the error that is reported
    return error.what();
  }
}

std::string words_for(std::string_view topic, std::string_view key) {
  return translated(message_of(fmt::format("{}.{}", topic, key)).one);
}

std::string words_for(std::string_view topic, std::string_view key, const std::string& text) {
  const auto found = all_messages().find(fmt::format("{}.{}", topic, key));
  const bool is_message = found != all_messages().end() && found->second.one == text;
  return is_message ? translated(text) : text;
}

bool has_words(std::string_view code) { return all_messages().contains(code); }

// As a sentence of its own.

namespace {

/// Greek letters are symbols.
bool is_latin(char32_t c) {
  return c < 0x80 || (c >= 0xc0 && c < 0x250) || (c >= 0x1e00 && c < 0x1f00);
}

char32_t capital_of(char32_t letter) {
  static const locale_t characters = newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr);
  if (letter >= 'a' && letter <= 'z') return letter - 'a' + 'A';
  if (letter < 0x80 || !is_latin(letter) || characters == nullptr) return letter;
  return towupper_l(static_cast<wint_t>(letter), characters);
}

bool is_word_of_one_letter(std::string_view letter) {
  std::istringstream words(
      /* TRANSLATORS: the words of one letter that may begin a sentence, with blanks between */
      tr("a"));
  for (std::string word; words >> word;) {
    if (word == letter) return true;
  }
  return false;
}

bool is_symbol(std::string_view word) {
  if (word.find('_') != std::string_view::npos) return true;
  return first_utf8_character(word).bytes == word.size() && !is_word_of_one_letter(word);
}

}  // namespace

std::string capitalised(const std::string& text) {
  if (is_symbol(std::string_view(text).substr(0, text.find(' ')))) return text;
  const Utf8Character first = first_utf8_character(text);
  if (first.bytes == 0) return text;
  return utf8_of(capital_of(first.code_point)) + text.substr(first.bytes);
}

std::string capitalised(const Statement& statement) { return capitalised(words(statement)); }

std::string within_a_sentence(const std::string& label) {
  const bool is_name = label.starts_with("Coulomb") || label.starts_with("Stribeck");
  const bool is_capital = !label.empty() && label.front() >= 'A' && label.front() <= 'Z';
  if (is_name || !is_capital) return label;
  std::string text = label;
  text.front() = static_cast<char>(text.front() - 'A' + 'a');
  return text;
}

std::string as_sentence(const std::string& text) {
  if (text.empty()) return text;
  std::string sentence = capitalised(text);
  const char last = sentence.back();
  return last == '.' || last == '!' || last == '?' || last == ':' ? sentence : sentence + ".";
}

std::string as_sentence(const Statement& statement) { return as_sentence(words(statement)); }

std::string or_dash(const std::string& text) { return text.empty() ? "–" : text; }

}  // namespace tribolog::wording
