// Messages and plural rules by Boost.Locale, which reads what gettext's msgfmt compiles.

#include <algorithm>
#include <cstdlib>
#include <locale>
#include <string_view>
#include <vector>

#include <boost/locale/gnu_gettext.hpp>
#include <boost/locale/message.hpp>

#include "wording/gettext/compiled_messages.h"
#include "wording/translation.h"

namespace tribolog::wording::gettext {
namespace {

class BoostTranslator : public Translator {
 public:
  explicit BoostTranslator(const CompiledMessages& compiled) {
    namespace gnu = boost::locale::gnu_gettext;
    gnu::messages_info info;
    info.language = compiled.code;
    info.encoding = "UTF-8";
    info.domains.emplace_back("tribolog");
    info.paths.emplace_back();
    info.callback = [&compiled](const std::string& /*file*/, const std::string& /*encoding*/) {
      return std::vector<char>(compiled.begin, compiled.end);
    };
    locale_ = std::locale(std::locale::classic(), gnu::create_messages_facet<char>(info));
  }

  [[nodiscard]] std::string find(const std::string& message) const override {
    const char* const found = messages().get(0, nullptr, message.c_str());
    return found == nullptr ? "" : found;
  }

  [[nodiscard]] std::string find(const std::string& one, std::int64_t count) const override {
    // Older versions take an int. Of a larger count the last digits decide, in every language.
    constexpr std::int64_t most = 1'000'000'000;
    const std::int64_t size = std::abs(count);
    const auto number = static_cast<int>(size > most ? most + size % most : size);
    const char* const found = messages().get(0, nullptr, one.c_str(), number);
    return found == nullptr ? "" : found;
  }

 private:
  [[nodiscard]] const boost::locale::message_format<char>& messages() const {
    return std::use_facet<boost::locale::message_format<char>>(locale_);
  }

  std::locale locale_;
};

}  // namespace
}  // namespace tribolog::wording::gettext

extern "C" __attribute__((visibility("default"))) tribolog::wording::Translator*
tribolog_translator(const char* code) {
  namespace gettext = tribolog::wording::gettext;
  const auto& all = gettext::compiled_messages();
  const auto found = std::find_if(
      all.begin(), all.end(),
      [code](const gettext::CompiledMessages& one) { return std::string_view(one.code) == code; });
  return found == all.end() ? nullptr : new gettext::BoostTranslator(*found);
}
