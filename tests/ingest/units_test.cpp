#include "ingest/log/units.h"

#include <numbers>
#include <vector>

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

TEST(Units, MayBeSpeltInEveryOrdinaryWay) {
  using enum ingest::log::Quantity;
  const struct {
    ingest::log::Quantity quantity;
    double factor;
    std::vector<const char*> spellings;
  } known[] = {
      {time, 1, {"seconds", "second", "Sec", "SEC", "secs", "S"}},
      {time, 1e-3, {"msec", "millisec", "Milliseconds", "millisecond", "ms"}},
      {time, 1e-6, {"usec", "microseconds", "µsec"}},
      {time, 60, {"min", "minutes"}},
      {angle, 1, {"radian", "radians", "Rad", "RAD"}},
      {angle, pi / 180, {"degree", "Degrees", "DEG", "deg", "°"}},
      {angle, 2 * pi, {"turns", "rev", "revs", "Revolutions"}},
      {angular_speed, 1, {"rad/sec", "radians/second", "rad per second", "rad s^-1", "rad.s-1"}},
      {angular_speed, pi / 180, {"deg/sec", "dps", "degrees/s", "DEG/S", "°/s"}},
      {angular_speed, 2 * pi / 60, {"RPM", "rev/min", "U/min", "tr/min", "1/min", "min^-1"}},
      {angular_speed, 2 * pi, {"turns/s", "rps", "rev/sec"}},
      {torque, 1, {"N.m", "N-m", "N_m", "NM", "newton meters"}},
      {torque, 1e-3, {"mN.m", "mN-m", "N.mm", "millinewtonmeter"}},
      {torque, 1e-2, {"Ncm", "N.cm", "N-cm"}},
      {torque, 0.0980665, {"kgcm", "kgf.cm", "kg-cm"}},
      {torque, 0.00706155, {"oz-in", "ozin"}},
      {current, 1, {"Amps", "Ampere", "amperes", "Arms", "A_rms", "amp"}},
      {current, 1e-3, {"mA", "milliamps", "mAmp"}},
  };
  for (const auto& one : known) {
    for (const char* spelling : one.spellings) {
      const auto factor = ingest::log::find_si_factor(one.quantity, spelling);
      ASSERT_TRUE(factor.has_value()) << spelling;
      EXPECT_NEAR(*factor / one.factor, 1, 1e-6) << spelling;
    }
  }
}

TEST(Units, AreNoOthersWherePrefixesDifferByCaseAlone) {
  using enum ingest::log::Quantity;
  EXPECT_FALSE(ingest::log::find_si_factor(time, "Ms"));
  EXPECT_FALSE(ingest::log::find_si_factor(time, "MS"));
  EXPECT_FALSE(ingest::log::find_si_factor(current, "MA"));
  EXPECT_FALSE(ingest::log::find_si_factor(angle, "Mrad"));
  EXPECT_FALSE(ingest::log::find_si_factor(torque, "MNm"));
}

TEST(Units, MayBeAShareOfARatedValue) {
  using enum ingest::log::Quantity;
  EXPECT_NEAR(*ingest::log::find_si_factor(torque, "‰ of 1.27 Nm"), 0.00127, 1e-12);
  EXPECT_NEAR(*ingest::log::find_si_factor(current, "% of 8 A"), 0.08, 1e-12);
  EXPECT_NEAR(*ingest::log::find_si_factor(torque, "per mille of 1.27 Nm"), 0.00127, 1e-12);
  EXPECT_FALSE(ingest::log::find_si_factor(torque, "% of 8 A"));
  EXPECT_FALSE(ingest::log::find_si_factor(torque, "% of % of 8 Nm"));
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

TEST(Units, NotAvailableIsNoNanoampere) {
  const auto current = [](const char* unit) {
    return ingest::log::find_si_factor(ingest::log::Quantity::current, unit);
  };
  EXPECT_EQ(current("nA"), 1e-9);
  EXPECT_EQ(current("nanoampere"), 1e-9);
  for (const char* const unit : {"NA", "N.A.", "n.a.", "na", "N/A", "#N/A"}) {
    EXPECT_EQ(current(unit), std::nullopt) << unit;
    EXPECT_FALSE(ingest::log::is_known_unit(unit)) << unit;
  }
}

TEST(Units, AreListedWhereOneIsNotKnown) {
  const auto refusal = [](ingest::log::Quantity quantity, const char* unit) {
    return test::refusal_of<InputError>(
        [&] { return ingest::log::si_factor(quantity, unit, {"m.toml", 5, 9}); });
  };
  EXPECT_EQ(
      refusal(ingest::log::Quantity::angle, "dg"),
      "m.toml:5:9: unknown unit of an angle, found 'dg', expected one of rad, mrad, deg, turn; "
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
