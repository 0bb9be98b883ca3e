#include "history/fleet.h"

#include <stdexcept>
#include <string_view>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "history/history_json.h"
#include "history/sample_fleet.h"

namespace tribolog::archive::fleet_test {
namespace {

using test::measured_fleet;

std::size_t outliers_of(const history::Fleet& fleet) {
  std::size_t count = 0;
  for (const history::FleetRobot& robot : fleet.robots) {
    for (const history::FleetJoint& joint : robot.joints)
      count += joint.furthest > fleet.limit ? 1 : 0;
  }
  return count;
}

statistics::Estimate& estimate_of(calibration::Measured& measured, const std::string& name) {
  for (calibration::Quantity& q : measured.quantities) {
    if (q.name == name) return *q.estimate;
  }
  throw std::logic_error("no " + std::string(name));
}

const history::FleetCell& cell_of(const history::Fleet& fleet, const history::FleetJoint& joint,
                                  std::string_view name) {
  for (const history::FleetCell& cell : joint.cells) {
    if (fleet.columns[cell.column].name == name) return cell;
  }
  throw std::logic_error("no " + std::string(name));
}

TEST(Fleet, CallsNothingAnOutlierThatIsNone) {
  // Half an outlier a fleet is allowed by the limit; Poisson: more than 35 of 40 fleets, or 3 of
  // one, come by chance less than once in a hundred times.
  std::size_t small = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    small += outliers_of(history::fleet_of(test::measured_fleet({8, 6, 6}, seed)));
  }
  const std::size_t large = outliers_of(history::fleet_of(test::measured_fleet({500, 6, 10}, 2)));
  RecordProperty("outliers_of_40_small_fleets", static_cast<int>(small));
  RecordProperty("outliers_of_a_large_fleet", static_cast<int>(large));
  EXPECT_LE(small, 35U);
  EXPECT_LE(large, 3U);
}

// One robot's torque constant is not known: its currents are held against no torques.
TEST(Fleet, HoldsNoAmperesAgainstNewtonMetres) {
  std::vector<calibration::Measured> all = test::measured_fleet({8, 1, 6}, 5);
  for (calibration::Measured& one : all) {
    if (one.entry.facts.of.robot != all.front().entry.facts.of.robot) continue;
    for (calibration::Quantity& q : one.quantities) {
      if (q.unit == "N·m") q.estimate = statistics::scaled(*q.estimate, 20);
      q.unit = joint::in_amperes(q.unit);
    }
  }
  const history::Fleet fleet = history::fleet_of(all);
  EXPECT_EQ(outliers_of(fleet), 0U);
  std::size_t columns = 0;
  for (const history::FleetColumn& column : fleet.columns) {
    if (column.name == "coulomb_torque") ++columns;
  }
  EXPECT_EQ(columns, 2U);
}

TEST(Fleet, FindsTheWornJointFirst) {
  for (const test::FleetSize size : {test::FleetSize{12, 3, 6}, test::FleetSize{60, 6, 10}}) {
    std::vector<calibration::Measured> all = test::measured_fleet(size, 5);
    // The last calibration of robot 4's joint 2: 8 % more, eight times what calibrations scatter.
    const int at = (4 * size.joints + 1) * size.calibrations + size.calibrations - 1;
    calibration::Measured& worn = all[static_cast<std::size_t>(at)];
    estimate_of(worn, "coulomb_torque") =
        statistics::scaled(estimate_of(worn, "coulomb_torque"), 1.08);
    const history::Fleet fleet = history::fleet_of(all);
    EXPECT_EQ(fleet.robots.front().robot, "R1004");
    const history::FleetJoint& joint = fleet.robots.front().joints[1];
    EXPECT_EQ(joint.latest.facts.of.joint, "J2");
    EXPECT_EQ(joint.furthest, fleet.robots.front().furthest);
    EXPECT_GT(joint.furthest, fleet.limit);
    const history::FleetCell& cell = cell_of(fleet, joint, "coulomb_torque");
    EXPECT_NEAR(cell.to_history->z, 8 / std::sqrt(1 + 1.571 / (size.calibrations - 1)), 2.5);
    EXPECT_EQ(cell.to_history->count, static_cast<std::size_t>(size.calibrations - 1));
    EXPECT_EQ(cell.to_others->count, static_cast<std::size_t>(size.robots - 1));
  }
}

TEST(Fleet, AJointOfAnotherKindIsFarFromTheOthersAndNotFromItsPast) {
  std::vector<calibration::Measured> all = test::measured_fleet({30, 2, 6}, 6);
  for (calibration::Measured& m : all) {
    if (m.entry.facts.of == calibration::JointName{"R1007", "S1000", "J1"} ||
        (m.entry.facts.of.robot == "R1007" && m.entry.facts.of.joint == "J1")) {
      estimate_of(m, "inertia") = statistics::scaled(estimate_of(m, "inertia"), 2);
    }
  }
  const history::Fleet fleet = history::fleet_of(all);
  EXPECT_EQ(fleet.robots.front().robot, "R1007");
  const history::FleetCell& cell = cell_of(fleet, fleet.robots.front().joints[0], "inertia");
  EXPECT_GT(cell.to_others->z, fleet.limit);
  EXPECT_LT(std::abs(cell.to_history->z), fleet.limit);
}

TEST(Fleet, ComparesWhatIsComparable) {
  // Half of the robots have another gear, which moves torques; by themselves all are alike.
  std::vector<calibration::Measured> all = test::measured_fleet({20, 1, 5}, 7);
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (k / 5 % 2 == 0) continue;
    all[k].entry.facts.gear_ratio = 160;
    for (calibration::Quantity& q : all[k].quantities)
      q.estimate = statistics::scaled(*q.estimate, 0.6);
  }
  const history::Fleet fleet = history::fleet_of(all);
  EXPECT_EQ(outliers_of(fleet), 0U);
  EXPECT_EQ(cell_of(fleet, fleet.robots[0].joints[0], "inertia").to_others->count, 9U);
  // Robots of one name are held against each other where there are enough.
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::string serial = all[k].entry.facts.of.robot;
    all[k].entry.facts.of = {k / 5 < 16 ? "A" : "B", serial, "J1"};
  }
  const history::Fleet named = history::fleet_of(all);
  for (const history::FleetRobot& robot : named.robots) {
    const auto& to_others = cell_of(named, robot.joints[0], "inertia").to_others;
    if (robot.robot == "A") {
      EXPECT_EQ(to_others->count, 7U);
    } else {
      EXPECT_FALSE(to_others);
    }
  }
}

TEST(Fleet, SaysNothingOfTooFew) {
  const history::Fleet fleet = history::fleet_of(test::measured_fleet({5, 2, 4}, 8));
  EXPECT_EQ(fleet.distances, 0U);
  EXPECT_EQ(outliers_of(fleet), 0U);
  const history::Fleet enough = history::fleet_of(test::measured_fleet({6, 2, 5}, 8));
  EXPECT_EQ(enough.distances, 6U * 2U * 10U * 2U);
  EXPECT_EQ(history::fleet_of({}).joints, 0U);
}

TEST(Fleet, EqualNumbersWithoutIntervalsAreNoOutliers) {
  std::vector<calibration::Measured> all = test::measured_fleet({7, 1, 5}, 9);
  for (calibration::Measured& m : all) {
    for (calibration::Quantity& q : m.quantities) q.estimate = statistics::Estimate{1, 1, 1, {}};
  }
  EXPECT_EQ(history::fleet_of(all).distances, 0U);
}

TEST(Fleet, JsonHasTheDistances) {
  const history::Fleet fleet = history::fleet_of(test::measured_fleet({6, 2, 5}, 10));
  const auto json = nlohmann::json::parse(history::fleet_json(fleet));
  EXPECT_EQ(json["schema"], "tribolog-fleet-1");
  ASSERT_EQ(json["robots"].size(), 6U);
  const auto& joint = json["robots"][0]["joints"][1];
  EXPECT_EQ(joint["joint"], "J2");
  ASSERT_EQ(joint["quantities"].size(), 10U);
  EXPECT_EQ(joint["quantities"][7]["quantity"], "coulomb_torque");
  EXPECT_EQ(joint["quantities"][7]["to_others"]["count"], 5);
  EXPECT_EQ(joint["quantities"][7]["to_history"]["count"], 4);
  EXPECT_GE(json["robots"][0]["furthest_z"], json["robots"][5]["furthest_z"]);
}

}  // namespace
}  // namespace tribolog::archive::fleet_test
