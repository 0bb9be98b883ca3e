// The friction curve as simulators get it: an offset of the torque is not friction.

#include "exports/results/friction_table.h"

#include <cmath>
#include <optional>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "exports/export_sample.h"

namespace tribolog::friction_table_test {
namespace {

constexpr double offset_Nm = 0.07;

double friction_Nm(double speed_rad_s) { return 0.3 + 0.002 * std::abs(speed_rad_s); }

struct Run {
  double speed_rad_s;
  int partner{-1};
  /// Half the difference over the angles that both directions share; absent: they share none.
  std::optional<double> difference_Nm{};
};

/// Torques are friction and an offset.
exports::results::FrictionTable table_of(const std::vector<Run>& runs) {
  exports::results::ArchivedJoint joint = test::export_sample();
  nlohmann::json calibration = nlohmann::json::parse(joint.calibration);
  nlohmann::json list = nlohmann::json::array();
  nlohmann::json torques = nlohmann::json::array();
  for (const Run& run : runs) {
    nlohmann::json one{{"speed_rad_s", run.speed_rad_s},
                       {"partner", nullptr},
                       {"direction_difference_Nm", nullptr}};
    if (run.partner >= 0) one["partner"] = run.partner;
    if (run.difference_Nm) one["direction_difference_Nm"] = *run.difference_Nm;
    list.push_back(one);
    torques.push_back(std::copysign(friction_Nm(run.speed_rad_s), run.speed_rad_s) + offset_Nm);
  }
  calibration["viscous"]["runs"] = list;
  calibration["viscous"]["curves"]["midline"] = torques;
  joint.calibration = calibration.dump();
  return exports::results::friction_table(joint);
}

TEST(FrictionTable, OfBothDirectionsHasNoOffset) {
  // Of one commanded speed the last digits differ.
  const auto table = table_of({{-100.01, 3}, {-10.002, 2}, {10, 1}, {99.99, 0}});
  ASSERT_EQ(table.rows.size(), 3U) << "at rest and two speeds";
  EXPECT_EQ(table.rows[0].speed_rad_s, 0);
  EXPECT_EQ(table.rows[0].friction_Nm, table.rows[1].friction_Nm);
  EXPECT_NEAR(table.rows[1].speed_rad_s, 10.001, 1e-9);
  EXPECT_NEAR(table.rows[1].friction_Nm, friction_Nm(10.001), 1e-12);
  EXPECT_NEAR(table.rows[2].speed_rad_s, 100, 1e-9);
  EXPECT_NEAR(table.rows[2].friction_Nm, friction_Nm(100), 1e-12);
  EXPECT_NE(table.source.find("2 constant speeds, half the difference between the directions"),
            std::string::npos)
      << table.source;
}

TEST(FrictionTable, TakesTheDifferenceOverTheAnglesThatBothShare) {
  const auto table = table_of({{-10, 1, -0.29}, {10, 0, 0.29}});
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_NEAR(table.rows[1].friction_Nm, 0.29, 1e-12);
}

TEST(FrictionTable, OfOneDirectionLosesTheOffsetThatTheOthersShow) {
  const auto table = table_of({{-10, 1}, {10, 0}, {50}, {-80}});
  ASSERT_EQ(table.rows.size(), 4U);
  EXPECT_NEAR(table.rows[2].friction_Nm, friction_Nm(50), 1e-12);
  EXPECT_NEAR(table.rows[3].friction_Nm, friction_Nm(80), 1e-12) << "of either sign";
}

TEST(FrictionTable, OfOneDirectionAloneHasTheOffsetAndSaysSo) {
  const auto table = table_of({{10}, {50}});
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_NEAR(table.rows[1].friction_Nm, friction_Nm(10) + offset_Nm, 1e-12);
  EXPECT_NE(table.source.find("an offset of the torque is in it"), std::string::npos)
      << table.source;
}

TEST(FrictionTable, KeepsSpeedsApartThatDifferByMoreThanThreePercent) {
  const auto table = table_of({{-10, 1}, {10, 0}, {-10.5, 3}, {10.5, 2}});
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_NEAR(table.rows[2].friction_Nm, friction_Nm(10.5), 1e-12);
}

TEST(FrictionTable, CountsPartnersPastARunThatIsNotRead) {
  // The first run has no number: indices of partners count it all the same.
  exports::results::ArchivedJoint joint = test::export_sample();
  nlohmann::json calibration = nlohmann::json::parse(joint.calibration);
  calibration["viscous"]["runs"] = {{{"speed_rad_s", nullptr}, {"partner", nullptr}},
                                    {{"speed_rad_s", -10}, {"partner", 2}},
                                    {{"speed_rad_s", 10}, {"partner", 1}},
                                    {{"speed_rad_s", 20}, {"partner", 0}}};
  calibration["viscous"]["curves"]["midline"] = {0, -0.25, 0.39, 0.47};
  joint.calibration = calibration.dump();
  const auto table = exports::results::friction_table(joint);
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_NEAR(table.rows[1].friction_Nm, 0.32, 1e-12);
  EXPECT_NEAR(table.rows[2].friction_Nm, 0.40, 1e-12) << "its partner is none";
}

}  // namespace
}  // namespace tribolog::friction_table_test
