#pragma once
// Texts of pages and figures, in the language of this thread's words (language.h).
//
// A message is English, a literal, and names its values, each with the format of a number behind a
// colon: tr("{share:.0f} % of {samples} samples", {{"share", s}, {"samples", n}}). "{{" prints "{".
// A whole sentence is one message: what is put together of pieces cannot be translated.

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

#include "base/statement.h"

namespace tribolog::wording {

/// @throw std::logic_error: a value is missing, or does not fit its format.
std::string tr(std::string_view message, std::initializer_list<StatedValue> values = {});

/// Of one, or of another number: tr_count(n, "{runs} run", "{runs} runs", {{"runs", n}}).
/// @throw as tr()
std::string tr_count(std::int64_t count, std::string_view one, std::string_view many,
                     std::initializer_list<StatedValue> values);

/// A message of a table, found by who translates; tr() makes words of it where it is shown.
constexpr const char* to_translate(const char* message) { return message; }

}  // namespace tribolog::wording
