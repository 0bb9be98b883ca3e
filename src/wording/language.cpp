#include "wording/language.h"

#include <stdexcept>

#include "wording/embedded_catalogues.h"

namespace tribolog::wording {
namespace {

Catalogue read_catalogue(Language language) {
  const std::string prefix = std::string(code_of(language)) + "_";
  Catalogue catalogue;
  for (const EmbeddedFile& file : embedded_catalogues()) {
    if (!file.name.starts_with(prefix)) continue;
    try {
      catalogue.add(file.text, std::string(file.name));
    } catch (const std::invalid_argument& error) {
      throw std::logic_error(error.what());
    }
  }
  return catalogue;
}

}  // namespace

const char* code_of(Language language) { return language == Language::polish ? "pl" : "en"; }

const std::vector<Language>& languages() {
  static const std::vector<Language> all{Language::english, Language::polish};
  return all;
}

const Catalogue* catalogue_of(Language language) {
  if (language == Language::english) return nullptr;
  static const Catalogue polish = read_catalogue(Language::polish);
  return &polish;
}

std::string in_language(Language language, std::string_view text) {
  const Catalogue* const catalogue = catalogue_of(language);
  return catalogue == nullptr ? std::string(text) : catalogue->translate(text);
}

}  // namespace tribolog::wording
