// Files of messages: what a line says, and what is refused with its place.

#include "wording/message_table.h"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "base/temporary_directory.h"

namespace tribolog::message_table_test {
namespace {

TEST(MessageTable, HasTheFormsOfEachCode) {
  const wording::MessageTable table =
      wording::read_messages({{"a.messages",
                               "# Of fits.\n\nfit.runs = {runs} run = few\n"
                               "fit.runs [runs] = {runs} runs\n"},
                              {"b.messages", "fit.mass == {mass_kg} kg"}});
  ASSERT_EQ(table.size(), 2u);
  EXPECT_EQ(table.at("fit.runs").one, "{runs} run = few");
  EXPECT_EQ(table.at("fit.runs").many, "{runs} runs");
  EXPECT_EQ(table.at("fit.runs").count, "runs");
  EXPECT_FALSE(table.at("fit.runs").is_the_same_everywhere);
  EXPECT_EQ(table.at("fit.mass").one, "{mass_kg} kg");
  EXPECT_TRUE(table.at("fit.mass").is_the_same_everywhere);
}

std::string refusal(const std::string& text) {
  return test::refusal_of<std::logic_error>(
      [&] { return wording::read_messages({{"a.messages", text}}); });
}

TEST(MessageTable, ALineThatIsNoMessageIsNamed) {
  for (const std::string line :
       {"b.c", "b.c =", "b.c = ", "b.c =  two blanks", "b.c = blank behind ", "b.c: text",
        " b.c = text", "b.c [n] = without the form of one", "a.b [] = text", "a.b [n] == text",
        "a.b [n = text"}) {
    EXPECT_TRUE(refusal("a.b = text\n\n" + line + "\n").starts_with("a.messages:3: not 'code"))
        << line;
  }
}

TEST(MessageTable, ACodeHasOneMessage) {
  EXPECT_EQ(refusal("a.b = text\na.b = text\n"),
            "a.messages:2: 'a.b' has two messages\na.b = text");
  EXPECT_TRUE(refusal("a.b = {n} run\na.b [n] = {n} runs\na.b [n] = {n} runs\n")
                  .starts_with("a.messages:3: not 'code"));
}

}  // namespace
}  // namespace tribolog::message_table_test
