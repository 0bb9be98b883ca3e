#include "ingest/manifest/toml_table.h"

#include <gtest/gtest.h>

#include "base/temporary_directory.h"

namespace tribolog::toml_table_test {
namespace {

ingest::manifest::TomlTable parse(std::string_view text) {
  return ingest::manifest::TomlTable::parse(text, "m.toml");
}

template <class Action>
std::string refusal(const Action& action) {
  return test::refusal_of<InputError>(action);
}

TEST(TomlTable, GivesTypedValues) {
  const ingest::manifest::TomlTable table = parse(
      "text = \"Größe\"\nnumber = 1.5\nwhole = 3\nflag = true\nlist = [1, 2.5]\n"
      "[a.b]\nx = 1\n[[c]]\ny = 1\n[[c]]\ny = 2\n");
  EXPECT_EQ(table.text("text"), "Größe");
  EXPECT_EQ(table.number("number"), 1.5);
  EXPECT_EQ(table.number("whole"), 3.0);
  EXPECT_EQ(table.count_or("whole", 7), 3U);
  EXPECT_TRUE(table.flag_or("flag", false));
  EXPECT_EQ(table.numbers("list"), (std::vector<double>{1, 2.5}));
  EXPECT_EQ(table.table("a").table("b").number("x"), 1.0);
  ASSERT_EQ(table.tables("c").size(), 2U);
  EXPECT_EQ(table.tables("c")[1].number("y"), 2.0);
  table.refuse_unknown_keys();
}

TEST(TomlTable, GivesWhatIsLeftOutItsDefault) {
  const ingest::manifest::TomlTable table = parse("");
  EXPECT_EQ(table.text_or("a", "x"), "x");
  EXPECT_EQ(table.number_or("a", 2.5), 2.5);
  EXPECT_EQ(table.find_number("a"), std::nullopt);
  EXPECT_EQ(table.count_or("a", 4), 4U);
  EXPECT_FALSE(table.find_table("a").has_value());
  EXPECT_TRUE(table.tables("a").empty());
}

TEST(TomlTable, RefusesMissingKeysWithWhatMayHaveBeenMeant) {
  const ingest::manifest::TomlTable table =
      parse("[joint]\nname = \"3\"\ngear_ration = 100\n").table("joint");
  EXPECT_EQ(
      refusal([&] { return table.number("gear_ratio"); }),
      "m.toml:1:1: key 'joint.gear_ratio' is missing; hint: is 'gear_ration' meant to be it?");
  EXPECT_EQ(refusal([&] { return table.number("mass", ingest::manifest::Sign::any, "in kg"); }),
            "m.toml:1:1: key 'joint.mass' is missing; hint: in kg");
}

TEST(TomlTable, RefusesOtherTypesAndRanges) {
  const ingest::manifest::TomlTable table =
      parse("a = \"100\"\nb = nan\nc = -1\nd = 0\ne = [1, \"x\"]\nf = 1.5\n");
  EXPECT_EQ(refusal([&] { return table.number("a"); }),
            "m.toml:1:5: key 'a': not usable, found the text '100', expected a finite number");
  EXPECT_EQ(refusal([&] { return table.number("b"); }),
            "m.toml:2:5: key 'b': not usable, found nan, expected a finite number");
  EXPECT_EQ(refusal([&] { return table.number("c", ingest::manifest::Sign::not_negative); }),
            "m.toml:3:5: key 'c': not usable, found -1, expected a number >= 0");
  EXPECT_EQ(refusal([&] { return table.number("d", ingest::manifest::Sign::positive); }),
            "m.toml:4:5: key 'd': not usable, found 0, expected a number > 0");
  EXPECT_EQ(refusal([&] { return table.numbers("e"); }),
            "m.toml:5:9: key 'e': not usable, found the text 'x', expected a finite number");
  EXPECT_EQ(refusal([&] { return table.text("f"); }),
            "m.toml:6:5: key 'f': wrong type, found 1.5, expected a text");
  EXPECT_EQ(refusal([&] { return table.flag_or("f", true); }),
            "m.toml:6:5: key 'f': wrong type, found 1.5, expected true or false");
  EXPECT_EQ(refusal([&] { return table.count_or("c", 1); }),
            "m.toml:3:5: key 'c': not usable, found -1, expected a whole number >= 0");
  EXPECT_EQ(refusal([&] { return table.table("f"); }),
            "m.toml:6:5: key 'f': wrong type, found 1.5, expected a table");
  EXPECT_EQ(refusal([&] { return table.tables("e"); }),
            "m.toml:5:5: key 'e': wrong type, found 1, expected a table; hint: write [[e]]");
}

TEST(TomlTable, RefusesWordsThatAreNoChoice) {
  const ingest::manifest::TomlTable table = parse("kind = \"motor_curent\"\n");
  EXPECT_EQ(refusal([&] { return table.choice("kind", {"motor_current", "motor_torque"}); }),
            "m.toml:1:8: key 'kind': not known, found 'motor_curent', expected one of "
            "'motor_current', 'motor_torque'; hint: did you mean 'motor_current'?");
}

TEST(TomlTable, RefusesKeysThatNobodyAskedFor) {
  const ingest::manifest::TomlTable table = parse("a = 1\ndistence = 2\n");
  (void)table.has("a");
  EXPECT_EQ(refusal([&] {
              table.refuse_unknown_keys();
              return 0;
            }),
            "m.toml:2:12: unknown key 'distence'; hint: known here: 'a'");
  (void)table.number_or("distance", 1.0);
  EXPECT_EQ(refusal([&] {
              table.refuse_unknown_keys();
              return 0;
            }),
            "m.toml:2:12: unknown key 'distence'; hint: did you mean 'distance'?");
}

TEST(TomlTable, RefusesWhatIsNoToml) {
  // Which column a missing value stands in, and the words, are the parser's.
  const std::string missing = refusal([] { return parse("a = \n"); });
  EXPECT_EQ(missing.substr(0, 9), "m.toml:1:") << missing;
  EXPECT_NE(missing.find(": not valid TOML: "), std::string::npos) << missing;
  EXPECT_NE(refusal([] { return parse("a = 1\na = 2\n"); }).find("m.toml:2:"), std::string::npos);
}

TEST(TomlTable, RefusesWhatIsNotUtf8) {
  EXPECT_EQ(refusal([] { return parse("a = 1\nb = \"°\xff\"\n"); }),
            "m.toml:2:8: text is not UTF-8, found byte 0xFF; hint: save the file as UTF-8");
}

// Some versions of the parser answer these with undefined behaviour.
TEST(TomlTable, RefusesStrayCharactersBeyondAscii) {
  EXPECT_EQ(refusal([] { return parse("a = 1\n§ = 2\n"); }),
            "m.toml:2:1: character beyond ASCII outside of quotes and comments");
  EXPECT_EQ(refusal([] { return parse("\xcc\xaa"); }),
            "m.toml:1:1: character beyond ASCII outside of quotes and comments");
  EXPECT_EQ(refusal([] { return parse("s = \"\"\"\\\n§\"\"\"\n"); }),
            "m.toml:1:9: backslash before a character beyond ASCII");
  EXPECT_EQ(refusal([] { return parse("s = \"\"\"\\°\"\"\"\n"); }),
            "m.toml:1:9: backslash before a character beyond ASCII");
  EXPECT_EQ(refusal([] { return parse("s = 1\"°\"\n"); }),
            "m.toml:1:6: quote in the middle of a key or value");
  EXPECT_EQ(refusal([] { return parse("s=+[\"О\"]\n"); }),
            "m.toml:1:4: bracket in the middle of a key or value");
  EXPECT_EQ(refusal([] { return parse("_=6.=\"О\"\n"); }),
            "m.toml:1:5: '=' in the middle of a value");
  EXPECT_EQ(refusal([] { return parse("_=6.\"О\"\n"); }),
            "m.toml:1:5: quote in the middle of a key or value");
  EXPECT_EQ(parse("a.\"О\" = {b = \"x\", c.\"О\" = [\"y\"]}\nd = 'z='\n").text("d"), "z=");
  EXPECT_EQ(refusal([] { return parse("s = 1{\"О\" = 1}\n"); }),
            "m.toml:1:6: bracket in the middle of a key or value");
  EXPECT_NE(refusal([] { return parse("[&"); }), "");
}

TEST(TomlTable, RefusesATextBehindAnElementThatHasBegun) {
  const std::string quote = "quote in the middle of a key or value";
  EXPECT_EQ(refusal([] { return parse("a = [6.\"О\"]\n"); }), "m.toml:1:8: " + quote);
  EXPECT_EQ(refusal([] { return parse("a = [1,\n  6. \"О\"]\n"); }), "m.toml:2:6: " + quote);
  EXPECT_EQ(refusal([] { return parse("a = 1979-05-27 \"О\n"); }), "m.toml:1:16: " + quote);
  EXPECT_EQ(refusal([] { return parse("a = {b = 1 'О'}\n"); }), "m.toml:1:12: " + quote);
  EXPECT_EQ(refusal([] { return parse("[a]\"О\"\n"); }), "m.toml:1:4: " + quote);
  EXPECT_EQ(refusal([] { return parse("a.[\"О\"] = 1\n"); }),
            "m.toml:1:3: bracket in the middle of a key or value");
}

TEST(TomlTable, AnUnclosedBracketIsFoundWhereItsLineStands) {
  EXPECT_EQ(refusal([] { return parse("a = [\n  1,\nb = 2\n"); }),
            "m.toml:3:3: '=' in the middle of a value; hint: the '[' of line 1 is not closed");
}

TEST(TomlTable, TakesTextsWhereverTheyMayStand) {
  const ingest::manifest::TomlTable table = parse(
      "a = [ # °\n  \"µ\", # one\n  '°'\n]\nb . \"c\" = {d = [[\"x\"], ['y', \"z\"]], e = 1.5}\n"
      "f = \"\"\"\"g\"\"\"\"\"\n[ h . 'i' ]\nj = 1979-05-27 07:32:00\n[[k]]\n\"l\" = 1 # °\n");
  EXPECT_EQ(table.text("f"), "\"g\"\"");
}

TEST(TomlTable, TakesCharactersBeyondAsciiWhereTextIs) {
  const ingest::manifest::TomlTable table = parse(
      "\xef\xbb\xbf# Größe\na = \"°\" # µ\nb = '°\\'\nc = \"\"\"\n°\"µ\\\"\n\"\"\"\n"
      "d = '''°'''\n\"°\" = 1\n");
  EXPECT_EQ(table.text("a"), "°");
  EXPECT_EQ(table.text("b"), "°\\");
  EXPECT_EQ(table.text("c"), "°\"µ\"\n");
  EXPECT_EQ(table.text("d"), "°");
  EXPECT_EQ(table.number("°"), 1);
}

TEST(TomlTable, BoundsNesting) {
  std::string dots = "a";
  for (int i = 0; i < 100'000; ++i) dots += ".a";
  EXPECT_EQ(refusal([&] { return parse(dots + " = 1\n"); }),
            "m.toml:1:102: key with too many dots");
  const std::string brackets(100'000, '[');
  EXPECT_NE(refusal([&] { return parse("a = " + brackets); }), "");
  std::string inline_tables = "a = ";
  for (int i = 0; i < 100'000; ++i) inline_tables += "{b = ";
  EXPECT_NE(refusal([&] { return parse(inline_tables); }), "");
}

}  // namespace
}  // namespace tribolog::toml_table_test
