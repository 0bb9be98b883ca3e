// Texts of enumerators: their own names and those of a table, there and back.

#include "base/enum_text.h"

#include <gtest/gtest.h>

namespace tribolog::enum_text_test {
namespace {

enum class Side { motor, joint_of_arm };

struct Log {
  enum class Kind : unsigned char { text };
};

static_assert(EnumTexts<Side>::size == 2);
static_assert(EnumTexts<Log::Kind>::size == 1);

TEST(EnumText, AnEnumeratorHasItsOwnName) {
  EXPECT_EQ(own_name(Side::joint_of_arm), "joint_of_arm");
  EXPECT_EQ(own_name(Log::Kind::text), "text");
  EXPECT_EQ(own_names<Side>.find("motor"), Side::motor);
  EXPECT_EQ(own_names<Side>.find("arm"), std::nullopt);
  EXPECT_EQ(own_names<Side>.all(), (std::vector<std::string>{"motor", "joint_of_arm"}));
}

TEST(EnumText, ATableHasOneTextForEach) {
  constexpr EnumTexts<Side> texts("before the gear", "behind it");
  EXPECT_EQ(texts.of(Side::joint_of_arm), "behind it");
  EXPECT_EQ(texts.find("before the gear"), Side::motor);
  static_assert(!std::is_constructible_v<EnumTexts<Side>, const char*>);
  static_assert(!std::is_constructible_v<EnumTexts<Side>, const char*, const char*, const char*>);
}

}  // namespace
}  // namespace tribolog::enum_text_test
