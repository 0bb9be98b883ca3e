// Templates in another language: which messages they hold, and that nothing else changes.

#include "report/template_language.h"

#include <cstddef>
#include <stdexcept>

#include <gtest/gtest.h>

#include "report/embedded_files.h"
#include "report/page_style.h"
#include "wording/language.h"

namespace tribolog::report::template_language_test {
namespace {

using Texts = std::vector<std::string>;

std::string with(const std::string& source, const std::string& message,
                 const std::string& translation) {
  return template_in_language(source, [&](const std::string& found) {
    return found == message ? translation : std::string();
  });
}

TEST(TemplateLanguage, MessagesAreWholeSentencesWithTheirMarks) {
  EXPECT_EQ(messages_of_template("<div>\n<p class=\"x\"> About <i>q</i><sub>p</sub>, {{N}} times:\n"
                                 "{{#LIST}}<li>{{ITEM}}</li>{{/LIST}}<img alt=\"A loop\" src=\"x\">"
                                 "<math><mi>q</mi></math> is small</p></div>"),
            (Texts{"About <i>q</i><sub>p</sub>, {{N}} times:", "A loop", "<math/> is small"}));
  EXPECT_EQ(messages_of_template("<p>{{ONLY}} – 5 %</p><script>say</script><style>a</style>"),
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

TEST(TemplateLanguage, VariablesInsideTagsAreForMachines) {
  const auto found = variables_inside_tags(
      "<p id=\"{{ID}}\" class=\"a {{KIND:x}}\" title=\"{{TITLE}}\" alt=\"of "
      "{{ALT}}\">{{TEXT}}</p>");
  EXPECT_EQ(found, (std::set<std::string, std::less<>>{"ID", "KIND"}));
}

/// Printed outside of a tag, with the marker's end.
bool is_shown(std::string_view source, std::string_view name) {
  for (std::size_t at = source.find(name); at != std::string_view::npos;
       at = source.find(name, at + 1)) {
    const std::string_view before = source.substr(0, at);
    const std::size_t opened = before.rfind('<');
    const std::size_t closed = before.rfind('>');
    const bool is_inside =
        opened != std::string_view::npos && (closed == std::string_view::npos || opened > closed);
    const char end = source[at + name.size()];
    if (before.ends_with("{{") && !is_inside && (end == '}' || end == ':')) return true;
  }
  return false;
}

/// A variable that is read in one place and a word for machines in another would not be translated.
TEST(TemplateLanguage, NoVariableOfOursIsBoth) {
  EXPECT_TRUE(is_shown("<p class=\"{{A}}\">{{A}}</p>", "A"));
  EXPECT_FALSE(is_shown("<p class=\"{{A}}\">{{B}}</p>", "A"));
  for (const EmbeddedFile& file : embedded_files()) {
    if (!file.name.ends_with(".tpl")) continue;
    for (const std::string& name : variables_inside_tags(file.text)) {
      if (name == "TOOL") continue;  // "tribolog 0.1.0", the same in every language
      EXPECT_FALSE(is_shown(file.text, name)) << file.name << ": " << name;
    }
  }
}

class Languages : public testing::TestWithParam<wording::Language> {};

TEST_P(Languages, EveryMessageOfEveryTemplateIsTranslatedAndNoneIsLeftOver) {
  const wording::Catalogue& catalogue = *wording::catalogue_of(GetParam());
  std::set<std::string> used;
  for (const EmbeddedFile& file : embedded_files()) {
    if (!file.name.ends_with(".tpl")) continue;
    for (const std::string& message : messages_of_template(file.text)) {
      used.insert(message);
      EXPECT_NE(catalogue.find_in_templates(message), "") << file.name << ": " << message;
    }
    // Throws where a translation has other marks than its message.
    (void)template_in_language(file.text, [&](const std::string& message) {
      return catalogue.find_in_templates(message);
    });
  }
  for (const std::string& message : script_messages()) {
    used.insert(message);
    EXPECT_NE(catalogue.find_in_templates(message) + catalogue.find(message), "") << message;
  }
  for (const std::string& message : catalogue.template_messages()) {
    EXPECT_TRUE(used.contains(message)) << "no template says: " << message;
  }
}

INSTANTIATE_TEST_SUITE_P(All, Languages,
                         testing::ValuesIn(wording::languages().begin() + 1,
                                           wording::languages().end()),
                         [](const auto& one) { return std::string(wording::code_of(one.param)); });

}  // namespace
}  // namespace tribolog::report::template_language_test
