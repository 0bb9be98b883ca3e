#pragma once
// The languages that a report is written in.

#include <string>
#include <string_view>
#include <vector>

#include "wording/catalogue.h"

namespace tribolog::wording {

/// English is the program's own; every other one has a catalogue in templates/languages/.
enum class Language { english, polish };

/// As HTML and the command line name it: "en", "pl".
const char* code_of(Language language);

/// All of them, English first.
const std::vector<Language>& languages();

/// The language's messages; null for English.
/// @throw std::logic_error if one of the catalogue's files is wrong.
const Catalogue* catalogue_of(Language language);

/// The text in the language, or as it is where there is no translation.
std::string in_language(Language language, std::string_view text);

}  // namespace tribolog::wording
