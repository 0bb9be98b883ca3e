#pragma once
// Internal to wording, the templates and the languages' module: messages as they stand in the
// language of this thread's words, their values not yet in them.

#include <cstdint>
#include <string>
#include <string_view>

namespace tribolog::wording {

/// The message itself where there is no translation.
std::string translated(std::string_view message);

/// The form for that count, by the language's own rule.
std::string translated(std::string_view one, std::string_view many, std::int64_t count);

/// The messages of one language, as its .po file has them.
class Translator {
 public:
  Translator() = default;
  Translator(const Translator&) = delete;
  Translator& operator=(const Translator&) = delete;
  virtual ~Translator() = default;
  /// The message in this language; empty where it has none.
  [[nodiscard]] virtual std::string find(const std::string& message) const = 0;
  /// The form for that count, by the language's own rule; empty where it has none.
  [[nodiscard]] virtual std::string find(const std::string& one, std::int64_t count) const = 0;
};

}  // namespace tribolog::wording

/// Of the module tribolog_translation, which has every language's messages.
/// @param code "pl". @return null where it has no such language.
extern "C" tribolog::wording::Translator* tribolog_translator(const char* code);
