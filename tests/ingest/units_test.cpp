#include "ingest/log/units.h"

#include <numbers>

#include <gtest/gtest.h>

#include "base/temporary_directory.h"

namespace tribolog::units_test {
namespace {

using std::numbers::pi;

TEST(Units, HaveTheirFactors) {
  EXPECT_EQ(ingest::log::find_si_factor(ingest::log::Quantity::angle, "rad"), 1.0);
  EXPECT_EQ(ingest::log::find_si_factor(ingest::log::Quantity::angle, "mrad"), 1e-3);
  EXPECT_DOUBLE_EQ(*ingest::log::find_si_factor(ingest::log::Quantity::angle, "deg") * 180, pi);
  EXPECT_DOUBLE_EQ(*ingest::log::find_si_factor(ingest::log::Quantity::angular_speed, "rpm") * 60,
                   2 * pi);
  EXPECT_DOUBLE_EQ(*ingest::log::find_si_factor(ingest::log::Quantity::angular_speed, "°/s") * 180,
                   pi);
  EXPECT_EQ(ingest::log::find_si_factor(ingest::log::Quantity::torque, "kNm"), 1e3);
  EXPECT_EQ(ingest::log::find_si_factor(ingest::log::Quantity::current, "mA"), 1e-3);
  EXPECT_EQ(ingest::log::find_si_factor(ingest::log::Quantity::time, "ns"), 1e-9);
}

TEST(Units, MayBeSpeltInSeveralWays) {
  for (const char* unit : {"Nm", "N·m", "N⋅m", "N*m", "N m", " N m "}) {
    EXPECT_EQ(ingest::log::find_si_factor(ingest::log::Quantity::torque, unit), 1.0) << unit;
  }
  EXPECT_EQ(ingest::log::find_si_factor(ingest::log::Quantity::torque, "mN·m"), 1e-3);
  for (const char* unit : {"us", "µs", "μs"}) {  // Latin u, micro sign, Greek mu
    EXPECT_EQ(ingest::log::find_si_factor(ingest::log::Quantity::time, unit), 1e-6) << unit;
  }
}

TEST(Units, MayBeAMultipleOfOne) {
  EXPECT_DOUBLE_EQ(*ingest::log::find_si_factor(ingest::log::Quantity::angle, "0.018 deg"),
                   2 * pi / 20'000);
  EXPECT_DOUBLE_EQ(*ingest::log::find_si_factor(ingest::log::Quantity::angle, "5e-5turn"),
                   2 * pi / 20'000);
  EXPECT_DOUBLE_EQ(*ingest::log::find_si_factor(ingest::log::Quantity::torque, "0.0013 N·m"),
                   0.0013);
  EXPECT_DOUBLE_EQ(*ingest::log::find_si_factor(ingest::log::Quantity::angular_speed, "1/min"),
                   2 * pi / 60);
  EXPECT_DOUBLE_EQ(*ingest::log::find_si_factor(ingest::log::Quantity::angular_speed, "2 1/min"),
                   4 * pi / 60);
  for (const char* unit : {"0 deg", "-1 deg", "nan deg", "inf deg", "1e999 deg", "2", "2 2 deg"}) {
    EXPECT_EQ(ingest::log::find_si_factor(ingest::log::Quantity::angle, unit), std::nullopt)
        << unit;
  }
  EXPECT_TRUE(ingest::log::is_known_unit("deg"));
  EXPECT_FALSE(ingest::log::is_known_unit("0.5 s"));
}

TEST(Units, AreNeverOfAnotherQuantityOrCase) {
  EXPECT_EQ(ingest::log::find_si_factor(ingest::log::Quantity::torque, "A"), std::nullopt);
  EXPECT_EQ(ingest::log::find_si_factor(ingest::log::Quantity::time, "rad"), std::nullopt);
  EXPECT_EQ(ingest::log::find_si_factor(ingest::log::Quantity::torque, "MNm"), std::nullopt);
  EXPECT_EQ(ingest::log::find_si_factor(ingest::log::Quantity::angle, ""), std::nullopt);
}

TEST(Units, AreListedWhereOneIsNotKnown) {
  const auto refusal = [](ingest::log::Quantity quantity, const char* unit) {
    return test::refusal_of<InputError>(
        [&] { return ingest::log::si_factor(quantity, unit, {"m.toml", 5, 9}); });
  };
  EXPECT_EQ(
      refusal(ingest::log::Quantity::angle, "degree"),
      "m.toml:5:9: unknown unit of an angle, found 'degree', expected one of rad, mrad, deg, turn; "
      "hint: did you mean 'deg'?");
  EXPECT_EQ(refusal(ingest::log::Quantity::torque, "lbf"),
            "m.toml:5:9: unknown unit of a torque, found 'lbf', expected one of Nm, mNm, kNm; "
            "hint: a multiple of one will do, such as \"0.0013 Nm\"");
  EXPECT_EQ(refusal(ingest::log::Quantity::time, "fortnight"),
            "m.toml:5:9: unknown unit of a time, found 'fortnight', expected one of s, ms, us, "
            "ns; hint: a multiple of one will do, such as \"60 s\"");
}

}  // namespace
}  // namespace tribolog::units_test
