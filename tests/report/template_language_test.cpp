// Templates in another language: which messages they hold, and that nothing else changes.

#include "report/engine/template_language.h"

#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "report/engine/embedded_files.h"
#include "wording/language.h"
#include "wording/translation.h"

namespace tribolog::report::template_language_test {
namespace {

using Texts = std::vector<std::string>;

std::string with(const std::string& source, const std::string& message,
                 const std::string& translation) {
  return engine::template_in_language(source, [&](const std::string& found) {
    return found == message ? translation : std::string();
  });
}

TEST(TemplateLanguage, MessagesAreWholeSentencesWithTheirMarks) {
  EXPECT_EQ(engine::messages_of_template(
                "<div>\n<p class=\"x\"> About <i>q</i><sub>p</sub>, {{N}} times:\n"
                "{{#LIST}}<li>{{ITEM}}</li>{{/LIST}}<img alt=\"A loop\" src=\"x\">"
                "<math><mi>q</mi></math> is small</p></div>"),
            (Texts{"About <i>q</i><sub>p</sub>, {{N}} times:", "A loop", "<math/> is small"}));
  EXPECT_EQ(
      engine::messages_of_template("<p>{{ONLY}} – 5 %</p><script>say</script><style>a</style>"),
      Texts{});
}

TEST(TemplateLanguage, OnlyTheMessageIsExchanged) {
  EXPECT_EQ(with("<p>\n  See <b>{{X}}</b> now\n</p>", "See <b>{{X}}</b> now", "Teraz <b>{{X}}</b>"),
            "<p>\n  Teraz <b>{{X}}</b>\n</p>");
  EXPECT_EQ(with("<a title=\"Up\">x</a>", "Up", "Góra"), "<a title=\"Góra\">x</a>");
  EXPECT_EQ(with("<p>If <math><mi>q</mi></math> is</p>", "If <math/> is", "jest <math/> gdy"),
            "<p>jest <math><mi>q</mi></math> gdy</p>");
}

TEST(TemplateLanguage, MarksMustStay) {
  EXPECT_THROW(with("<p>at {{X}}</p>", "at {{X}}", "przy"), std::invalid_argument);
  EXPECT_THROW(with("<p>at <b>c</b></p>", "at <b>c</b>", "przy <i>c</i>"), std::invalid_argument);
  EXPECT_THROW(with("<p>at</p>", "at", "przy <math/>"), std::invalid_argument);
  EXPECT_THROW(with("<p title=\"a\">5</p>", "a", "b\" onclick=\""), std::invalid_argument);
}

/// Whole catalogues: that every message has its translation, update.py --check finds.
class Languages : public testing::TestWithParam<wording::Language> {};

TEST_P(Languages, EveryTemplateTakesItsTranslation) {
  const wording::WordsIn words(GetParam());
  for (const EmbeddedFile& file : engine::embedded_files()) {
    if (!file.name.ends_with(".tpl")) continue;
    // Throws where a translation has other marks than its message.
    (void)engine::template_in_language(
        file.text, [](const std::string& message) { return wording::translated(message); });
  }
}

const std::vector<wording::Language>& others() {
  static const std::vector<wording::Language> all = [] {
    std::vector<wording::Language> found = wording::languages();
    found.erase(found.begin());
    return found;
  }();
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, Languages, testing::ValuesIn(others()),
                         [](const auto& one) { return one.param.code; });

}  // namespace
}  // namespace tribolog::report::template_language_test
