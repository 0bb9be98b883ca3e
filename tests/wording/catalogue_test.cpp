// What a catalogue finds: whole messages, sentences, and nothing that it does not know.

#include "wording/catalogue.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace tribolog::catalogue_test {
namespace {

wording::Catalogue catalogue() {
  wording::Catalogue c;
  c.add(R"({"texts": {
    "gear ratio": "przełożenie", "LuGre fit": "dopasowanie LuGre", "łatwe": "źle",
    "the joint moves": "przegub się porusza", "it rests": "ćwiczenie: stoi",
    "{n} runs": "{0} {0|przejazd|przejazdy|przejazdów}",
    "{t} of {}": "{1}: {0}", "{t} of the {}": "ten {1}: {0}",
    "it: whole; message. With ends": "w całości"},
    "templates": {"<b>{{X}}</b> is": "jest <b>{{X}}</b>"}})",
        "test");
  return c;
}

TEST(Catalogue, TranslatesWholeMessages) {
  const wording::Catalogue c = catalogue();
  EXPECT_EQ(c.translate("gear ratio"), "przełożenie");
  EXPECT_EQ(c.translate("3 runs"), "3 przejazdy");
  EXPECT_EQ(c.translate("LuGre fit of loop 7"), "loop 7: dopasowanie LuGre");
  EXPECT_EQ(c.find_in_templates("<b>{{X}}</b> is"), "jest <b>{{X}}</b>");
}

TEST(Catalogue, TheMessageThatSaysMostWins) {
  EXPECT_EQ(catalogue().translate("gear ratio of the joint"), "ten joint: przełożenie");
}

TEST(Catalogue, WhatItDoesNotKnowStays) {
  const wording::Catalogue c = catalogue();
  EXPECT_EQ(c.translate("Robot 7"), "Robot 7");
  EXPECT_EQ(c.translate(""), "");
  EXPECT_EQ(c.find("the joint moves. Robot 7."), "");
  EXPECT_EQ(c.find_in_templates("gear ratio"), "");
}

TEST(Catalogue, SentencesAreTranslatedOneByOne) {
  const wording::Catalogue c = catalogue();
  EXPECT_EQ(c.translate("the joint moves; 1 runs."), "przegub się porusza; 1 przejazd.");
  EXPECT_EQ(c.translate("Gear ratio: 5 runs"), "Przełożenie: 5 przejazdów");
  EXPECT_EQ(c.translate("It: whole; message. With ends. The joint moves."),
            "W całości. Przegub się porusza.");
}

TEST(Catalogue, ASentenceBeginsWithALargeLetterInEither) {
  const wording::Catalogue c = catalogue();
  EXPECT_EQ(c.translate("It rests."), "Ćwiczenie: stoi.");
  // A name that begins large is no sentence.
  EXPECT_EQ(c.translate("GEAR ratio"), "GEAR ratio");
}

TEST(Catalogue, RefusesWhatIsNoCatalogue) {
  for (const char* wrong : {"", "[]", R"({"other": {}})", R"({"texts": {"a": 1}})",
                            R"({"texts": {"a": ""}})", R"({"texts": {"{n": "b"}})",
                            R"({"texts": {"{n} a": "{1}"}})", R"({"texts": {"{n} a": "{0|b}"}})"}) {
    wording::Catalogue c;
    EXPECT_THROW(c.add(wrong, "test"), std::invalid_argument) << wrong;
  }
  wording::Catalogue c = catalogue();
  EXPECT_THROW(c.add(R"({"texts": {"gear ratio": "inaczej"}})", "test"), std::invalid_argument);
}

}  // namespace
}  // namespace tribolog::catalogue_test
