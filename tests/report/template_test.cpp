// The templates themselves, and the guards around the engine.

#include <regex>
#include <stdexcept>

#include <gtest/gtest.h>

#include "base/encodings.h"
#include "report/engine/embedded_files.h"
#include "report/engine/template_engine.h"
#include "report/engine/template_modifiers.h"

namespace tribolog::report::template_test {
namespace {

bool is_template(const EmbeddedFile& file) {
  return file.name.size() > 4 && file.name.substr(file.name.size() - 4) == ".tpl";
}

TEST(Templates, EveryOneBeginsWithThePragma) {
  std::size_t templates = 0;
  for (const EmbeddedFile& file : engine::embedded_files()) {
    if (!is_template(file)) continue;
    ++templates;
    EXPECT_EQ(file.text.rfind("{{%AUTOESCAPE context=\"HTML\"}}\n", 0), 0U) << file.name;
  }
  EXPECT_GE(templates, 15U);
}

TEST(Templates, NoneSwitchesEscapingOffOrScriptsOrStylesInline) {
  for (const EmbeddedFile& file : engine::embedded_files()) {
    const std::string text(file.text);
    EXPECT_EQ(text.find(":none"), std::string::npos) << file.name;
    if (!is_template(file)) continue;
    EXPECT_FALSE(std::regex_search(text, std::regex(R"(\sstyle\s*=)"))) << file.name;
    EXPECT_FALSE(std::regex_search(text, std::regex(R"(\son[a-z]+\s*=)"))) << file.name;
  }
}

TEST(Symbols, GetTheirIndexAndNothingElseDoes) {
  const std::string peak = "<i>q</i><sub>peak</sub>";
  EXPECT_EQ(engine::html_with_symbols("q_peak, fitted"), peak + ", fitted");
  EXPECT_EQ(engine::html_with_symbols("q_c = −q_peak"), "<i>q</i><sub>c</sub> = −" + peak);
  EXPECT_EQ(engine::html_with_symbols("cos(q - q_peak)."), "cos(q - " + peak + ").");
  EXPECT_EQ(engine::html_with_symbols("power δ_a"), "power <i>δ</i><sub>a</sub>");
  EXPECT_EQ(engine::html_with_symbols("at q_peak."), "at " + peak + ".");
  EXPECT_EQ(engine::html_with_symbols("slope T_ω, "), "slope <i>T</i><sub>ω</sub>, ");
  for (const char* plain : {"constant_speed", "q_peak.csv", "a/q_peak", "q_peak_rad", "joint_q_c",
                            "2q_c", "q_", "_c", "q_2", "q_C", "x_averylongindex", "é_c"}) {
    EXPECT_EQ(engine::html_with_symbols(plain), plain);
  }
  EXPECT_EQ(engine::html_with_symbols("column “q_rad”, q_c"),
            "column “q_rad”, <i>q</i><sub>c</sub>");
  EXPECT_EQ(engine::html_with_symbols("<b>&\"'"), "&lt;b&gt;&amp;&quot;&#39;");
}

TEST(Templates, KeepDatesOnOneLine) {
  const std::string date = "<span class=\"date\">2026-01-31</span>";
  EXPECT_EQ(engine::html_with_dates("2026-01-31"), date);
  EXPECT_EQ(engine::html_with_dates("from 2026-01-31, <q_c>"), "from " + date + ", &lt;q_c&gt;");
  EXPECT_EQ(engine::html_with_symbols("q_c on 2026-01-31."),
            "<i>q</i><sub>c</sub> on " + date + ".");
  EXPECT_EQ(engine::html_with_dates("2026-01-31T12:00:00Z"),
            "<span class=\"date\">2026-01-31T12:00:00Z</span>");
  for (const char* plain : {"12026-01-31", "2026-01-311", "2026-01-31-b", "a_2026-01-31",
                            "2026-01-3", "2026-01-31T12:00", "2026/01/31"}) {
    EXPECT_EQ(engine::html_with_dates(plain), plain);
  }
}

TEST(Templates, ModifiersStandOnlyWhereTheyBelong) {
  std::string all;
  for (const EmbeddedFile& file : engine::embedded_files()) {
    if (is_template(file)) all += file.text;
  }
  const std::regex modifier(R"(\{\{(\w+):([\w-]+)\}\})");
  for (std::sregex_iterator at(all.begin(), all.end(), modifier), end; at != end; ++at) {
    const std::string use = at->str();
    const bool is_ours = use == "{{PNG:x-png}}" || use == "{{CSV:x-csv}}" ||
                         use == "{{RESULT_JSON:x-json}}" || use == "{{LOOPS_JSON:x-json}}" ||
                         use == "{{CSS:x-css}}" || use == "{{SCRIPT:x-script}}" ||
                         at->str(2) == "x-symbols" || at->str(2) == "x-dates";
    EXPECT_TRUE(is_ours) << use;
  }
}

TEST(Templates, AForgottenVariableIsAnError) {
  engine::TemplateValues values;
  values.add_section("ITEM").set("STAGE_NAME", "stage");
  EXPECT_THROW(engine::expand_template("key_picture.tpl", values), std::logic_error);
}

TEST(Templates, AMissingFileIsAnError) {
  EXPECT_THROW(engine::expand_template("no_such.tpl", {}), std::logic_error);
  EXPECT_THROW(engine::embedded_file("no_such.css"), std::logic_error);
}

TEST(Templates, AnEmptyValueIsAnError) {
  engine::TemplateValues values;
  EXPECT_THROW(values.set("TITLE", ""), std::logic_error);
}

TEST(Templates, ValuesAreEscapedInTextAndAttributes) {
  engine::TemplateValues values;
  values.set("FIGURE_ID", "f\" onload=\"x");
  values.set("FIGURE_HEADING", "<script>x</script>");
  engine::TemplateValues& picture = values.add_section("PICTURE");
  picture.set_checked_by_modifier("PNG", "AA\"><script>");
  picture.set("ALT", "\"><script>x</script>");
  picture.set("WIDTH", "1");
  picture.set("HEIGHT", "1");
  picture.set("LOADING", "lazy");
  const std::string html = engine::expand_template("figure.tpl", values);
  EXPECT_EQ(html.find("<script"), std::string::npos);
  EXPECT_EQ(html.find("f\" onload"), std::string::npos);
  EXPECT_NE(html.find("src=\"data:image/png;base64,\""), std::string::npos);
}

TEST(Base64, KnownVectorsOfRfc4648) {
  const auto of = [](const std::string& text) {
    return base64(std::as_bytes(std::span(text.data(), text.size())));
  };
  EXPECT_EQ(of(""), "");
  EXPECT_EQ(of("f"), "Zg==");
  EXPECT_EQ(of("fo"), "Zm8=");
  EXPECT_EQ(of("foo"), "Zm9v");
  EXPECT_EQ(of("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64_of_hex("666F6f"), "Zm9v");
}

TEST(ScriptJson, NothingCanEndTheScript) {
  EXPECT_EQ(engine::json_for_script("\"</script>&\u2028\""),
            "\"\\u003c/script\\u003e\\u0026\\u2028\"");
}

}  // namespace
}  // namespace tribolog::report::template_test
