#include "wording/visible_text.h"

#include <gtest/gtest.h>

namespace tribolog::report::visible_text_test {
namespace {

TEST(VisibleText, OrdinaryTextStays) {
  const std::string text = "Grüße, 22.2° σ₀ 関節 🤖 <b>\"&'</b>\n\tnext";
  EXPECT_EQ(wording::visible_text(text), text);
}

TEST(VisibleText, BytesThatAreNotUtf8BecomeVisible) {
  EXPECT_EQ(wording::visible_text("a\xff\xfe"), "a\\xff\\xfe");
  EXPECT_EQ(wording::visible_text("\xc0\xaf"), "\\xc0\\xaf");           // overlong '/'
  EXPECT_EQ(wording::visible_text("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // a surrogate
  EXPECT_EQ(wording::visible_text("cut \xe2\x82"), "cut \\xe2\\x82");
  EXPECT_EQ(wording::visible_text("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");  // above U+10FFFF
}

TEST(VisibleText, ControlCharactersBecomeVisible) {
  EXPECT_EQ(wording::visible_text(std::string_view("a\0b\x1b[31m\x7f", 9)),
            "a\\x00b\\x1b[31m\\x7f");
  EXPECT_EQ(wording::visible_text("\u0085"), "\\x85");
}

TEST(VisibleText, WhatTurnsOrHidesTextBecomesVisible) {
  EXPECT_EQ(wording::visible_text("\u202Egnp.exe"), "[U+202E]gnp.exe");
  EXPECT_EQ(wording::visible_text("a\u200Bb\u2066c\uFEFF"), "a[U+200B]b[U+2066]c[U+FEFF]");
  EXPECT_EQ(wording::visible_text("\u2028"), "[U+2028]");
  EXPECT_EQ(wording::visible_text("\U000E0041"), "[U+E0041]");
}

}  // namespace
}  // namespace tribolog::report::visible_text_test
