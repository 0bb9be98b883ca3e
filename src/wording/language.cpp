#include "wording/language.h"

#include <map>
#include <memory>
#include <mutex>
#include <sstream>
#include <stdexcept>

#include "base/program_module.h"
#include "wording/translation.h"

namespace tribolog::wording {
namespace {

thread_local const Translator* translator = nullptr;  // null: English

/// Once opened they stay.
const Translator* translator_of(const Language& language) {
  if (language.is_english()) return nullptr;
  static std::mutex opening;
  static std::map<std::string, std::unique_ptr<Translator>> opened;
  const std::lock_guard lock(opening);
  std::unique_ptr<Translator>& found = opened[language.code];
  if (!found) {
    void* const open =
        function_of({"tribolog_translation", TRIBOLOG_TRANSLATION_PACKAGES}, "tribolog_translator");
    found.reset(reinterpret_cast<decltype(&tribolog_translator)>(open)(language.code.c_str()));
  }
  if (!found) throw std::invalid_argument("there is no language '" + language.code + "'");
  return found.get();
}

}  // namespace

std::vector<Language> languages() {
  std::vector<Language> all{Language{}};
  std::istringstream codes(TRIBOLOG_LANGUAGES);
  for (std::string code; codes >> code;) all.push_back({code});
  return all;
}

WordsIn::WordsIn(const Language& language) : before_(translator) {
  translator = translator_of(language);
}

WordsIn::~WordsIn() { translator = before_; }

std::string translated(std::string_view message) {
  std::string text(message);
  if (translator == nullptr) return text;
  std::string found = translator->find(text);
  return found.empty() ? text : found;
}

std::string translated(std::string_view one, std::string_view many, std::int64_t count) {
  if (translator != nullptr) {
    std::string found = translator->find(std::string(one), count);
    if (!found.empty()) return found;
  }
  return std::string(count == 1 ? one : many);
}

}  // namespace tribolog::wording
