#include "cli/language_option.h"

#include <map>
#include <string>

namespace tribolog {
namespace {

const std::map<std::string, Language>& languages_by_code() {
  static const std::map<std::string, Language> by_code = [] {
    std::map<std::string, Language> all;
    for (const Language language : languages()) all.emplace(code_of(language), language);
    return all;
  }();
  return by_code;
}

}  // namespace

void add_language(CLI::App& command, Language& language) {
  command
      .add_option_function<std::string>(
          "--language",
          [&language](const std::string& code) { language = languages_by_code().at(code); },
          "of the texts: en (the default), pl; numbers, units and JSON are the same in each")
      ->check(CLI::IsMember(languages_by_code()))
      ->type_name("CODE");
}

}  // namespace tribolog
