#include "base/error.h"

#include <gtest/gtest.h>

#include "base/shown_text.h"

namespace tribolog::error_test {
namespace {

std::string message(const Location& where, const InputError::Problem& problem) {
  return InputError(where, problem).what();
}

TEST(InputErrorMessage, HasEveryPartInItsPlace) {
  EXPECT_EQ(message({"run.csv", 12, 7}, {"column 'tau'", "'1,25'", "a number", "decimal comma?"}),
            "run.csv:12:7: column 'tau', found '1,25', expected a number; hint: decimal comma?");
}

TEST(InputErrorMessage, LeavesOutWhatIsNotKnown) {
  EXPECT_EQ(message({"run.csv", 0, 5}, {"file is empty", "", "", ""}), "run.csv: file is empty");
  EXPECT_EQ(message({"run.csv", 3, 0}, {"ragged", "", "4", ""}), "run.csv:3: ragged, expected 4");
  EXPECT_EQ(message({"", 0, 0}, {"what", "", "", "do"}), "what; hint: do");
}

TEST(InputErrorMessage, IsOneLineWhateverTheFileSays) {
  const std::string text = message({"a\nb.csv", 1, 1}, {"x\ny", "\x1b[2J", "\t", "\r"});
  EXPECT_EQ(text, R"(a\x0ab.csv:1:1: x\x0ay, found \x1b[2J, expected \x09; hint: \x0d)");
}

TEST(InputErrorMessage, KeepsTheLocationAndTheStatus) {
  const InputError error({"run.csv", 12, 7}, {"what", "", "", ""});
  EXPECT_EQ(error.where().file, "run.csv");
  EXPECT_EQ(error.where().line, 12);
  EXPECT_EQ(error.where().column, 7);
  EXPECT_EQ(error.status(), ExitStatus::input_refused);
}

TEST(StatedBy, IsWhatARefusalOrAFigureErrorStates) {
  const Statement why{"test.code", {{"count", 3}, {"inner", Statement("test.inner")}}};
  EXPECT_EQ(stated_by(FigureError(why)), why);
  EXPECT_EQ(stated_by(Refusal(why)), why);
  EXPECT_EQ(stated_by(std::runtime_error("no such file")), Statement::verbatim("no such file"));
}

TEST(FigureErrorMessage, IsTheCodeWithItsValues) {
  const FigureError error({"test.code", {{"count", 3}, {"inner", Statement("test.inner")}}});
  EXPECT_STREQ(error.what(), "test.code (count 3, inner [test.inner])");
  EXPECT_EQ(error.status(), ExitStatus::figure_failed);
}

TEST(WithTexts, ChangesEveryTextAndNothingElse) {
  const auto doubled = [](const std::string& text) { return text + text; };
  const auto statement = [](const char* text) {
    const Statement inner{"test.inner", {{"label", text}, {"number", 0.5}}};
    return Statement{"test.code", {{"text", text}, {"count", 3}, {"inner", inner}}};
  };
  EXPECT_EQ(with_texts(statement("a"), doubled), statement("aa"));
  EXPECT_TRUE(with_texts({}, doubled).empty());
}

TEST(Printable, KeepsOrdinaryTextOfEveryScript) {
  EXPECT_EQ(printable("N·m 20 °C Größe 摩擦"), "N·m 20 °C Größe 摩擦");
}

TEST(Printable, EscapesWhatDisturbsATerminal) {
  EXPECT_EQ(printable("\x1b]0;title\a"), R"(\x1b]0;title\x07)");
  EXPECT_EQ(printable("a\xc2\x9b"
                      "b"),
            R"(a\xc2\x9bb)");  // C1 control
  EXPECT_EQ(printable("a\xe2\x80\xae"
                      "b"),
            R"(a\xe2\x80\xaeb)");  // right-to-left override
  EXPECT_EQ(printable(std::string("a\0b", 3)), R"(a\x00b)");
}

TEST(Printable, EscapesWhatTurnsOrHidesText) {
  for (const char* const hidden :
       {"\u0085", "\u00AD", "\u061C", "\u180E", "\u200B", "\u200F", "\u2028", "\u2029", "\u202A",
        "\u202E", "\u2066", "\u2069", "\uFEFF", "\uFFF9", "\uFFFE", "\U000E0041", "\x7f"}) {
    const std::string shown = printable(hidden);
    EXPECT_EQ(shown.substr(0, 2), "\\x") << shown;
    EXPECT_EQ(lines_for_terminal(std::string("a\n") + hidden), "a\n" + shown);
  }
}

TEST(JsonWithoutHidden, ReadsBackAsTheSame) {
  EXPECT_EQ(json_without_hidden("{\n  \"a\": \"N·m\"\n}\n"), "{\n  \"a\": \"N·m\"\n}\n");
  EXPECT_EQ(json_without_hidden("\"\u0085\u202E\x7f\U000E0041\""),
            "\"\\u0085\\u202e\\u007f\\udb40\\udc41\"");
  EXPECT_EQ(json_without_hidden("\"\xff\""), "\"\uFFFD\"");
}

TEST(Printable, EscapesBytesThatAreNotUtf8) {
  EXPECT_EQ(printable("\xb5s"), R"(\xb5s)");
  EXPECT_EQ(printable("\xc0\xaf"), R"(\xc0\xaf)");          // overlong
  EXPECT_EQ(printable("\xed\xa0\x80"), R"(\xed\xa0\x80)");  // surrogate
  EXPECT_EQ(printable("end \xe2\x82"), R"(end \xe2\x82)");  // cut off
}

TEST(Printable, CutsLongTextBetweenCharacters) {
  EXPECT_EQ(printable("123456789", 9), "123456789");
  EXPECT_EQ(printable("1234567890", 9), "123456…");
  EXPECT_EQ(printable("12345°°°°", 9), "12345…");
  EXPECT_LE(printable(std::string(1000, '\x01')).size(), 80U);
}

}  // namespace
}  // namespace tribolog::error_test
