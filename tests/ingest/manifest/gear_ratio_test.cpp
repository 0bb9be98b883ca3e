#include "ingest/manifest/gear_ratio.h"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "ingest/manifest/toml_table.h"

namespace tribolog::gear_ratio_test {
namespace {

using ingest::manifest::parse_gear_ratio;
using ingest::manifest::TomlTable;

std::string refusal_of(const std::string& text) {
  try {
    parse_gear_ratio(text);
  } catch (const std::invalid_argument& refused) {
    return refused.what();
  }
  return "";
}

TEST(GearRatio, IsANumberOrMotorToJoint) {
  EXPECT_DOUBLE_EQ(parse_gear_ratio("101"), 101);
  EXPECT_DOUBLE_EQ(parse_gear_ratio("101:1"), 101);
  EXPECT_DOUBLE_EQ(parse_gear_ratio(" 101 : 2 "), 50.5);
  EXPECT_DOUBLE_EQ(parse_gear_ratio("157.5:1.5"), 105);
  EXPECT_DOUBLE_EQ(parse_gear_ratio("1:1"), 1);
  EXPECT_DOUBLE_EQ(parse_gear_ratio("0.5"), 0.5);
}

TEST(GearRatio, TheWrongWayRoundIsRefusedWithTheRightOne) {
  EXPECT_NE(refusal_of("1:101").find("did you mean '101:1'?"), std::string::npos);
  EXPECT_NE(refusal_of("2:101").find("did you mean '101:2'?"), std::string::npos);
}

TEST(GearRatio, WhatIsNoneIsRefused) {
  for (const char* text : {"", ":", "101:", ":1", "101:0", "0:1", "-101:1", "101:-1", "101:1:1",
                           "ten", "101:x", "nan:1", "inf:1", "101/1", "1e999:1", "101,5:1"}) {
    EXPECT_NE(refusal_of(text).find("expected motor angle / joint angle"), std::string::npos)
        << text;
  }
}

TEST(GearRatio, StandsInAManifestInEitherForm) {
  const auto ratio_in = [](const std::string& value) {
    return TomlTable::parse("gear_ratio = " + value + "\n", "d.toml").number("gear_ratio");
  };
  EXPECT_DOUBLE_EQ(ratio_in("101"), 101);
  EXPECT_DOUBLE_EQ(ratio_in("\"101:1\""), 101);
  for (const char* wrong : {"\"1:101\"", "\"many\"", "\"1e9:1\"", "true"}) {
    try {
      static_cast<void>(ratio_in(wrong));
      ADD_FAILURE() << wrong;
    } catch (const InputError& refused) {
      EXPECT_EQ(std::string(refused.what()).rfind("d.toml:1:14: key 'gear_ratio'", 0), 0U)
          << refused.what();
    }
  }
}

TEST(GearRatio, OtherKeysTakeNumbersAlone) {
  const TomlTable table = TomlTable::parse("mass_kg = \"101:1\"\n", "d.toml");
  EXPECT_THROW(static_cast<void>(table.number("mass_kg")), InputError);
}

}  // namespace
}  // namespace tribolog::gear_ratio_test
