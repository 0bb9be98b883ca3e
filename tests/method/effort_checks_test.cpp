// Checks on where the effort comes from, with answers known beforehand.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "method/checks/check_list.h"
#include "method/checks/scale_causes.h"

namespace tribolog {
namespace {

using std::numbers::pi;

/// There and back over two radians: T = cos q ± friction.
Dataset swept(const Drive& drive, double friction_share) {
  Dataset d;
  d.manifest.drive = drive;
  Recording r;
  r.name = "sweep.csv";
  r.role = Role::rough_sweep;
  for (int i = 0; i <= 2000; ++i) {
    const bool up = i <= 1000;
    const double q = up ? -1 + 0.002 * i : 1 - 0.002 * (i - 1000);
    r.t_s.push_back(0.01 * i);
    r.q_rad.push_back(q);
    r.torque_Nm.push_back(std::cos(q) + (up ? friction_share : -friction_share));
  }
  d.recordings.push_back(r);
  return d;
}

InputFile written_by_logger(const LoggedEffort& effort) {
  InputFile input;
  input.name = "sweep.csv";
  input.logged_effort = effort;
  return input;
}

Drive at_joint(double gear_ratio) { return {gear_ratio, EffortKind::joint_torque, Side::joint}; }

TEST(EffortProvenance, OfAConfirmedMeasurementPasses) {
  for (const Drive& drive : {Drive(100, EffortKind::motor_torque, Side::motor), at_joint(100),
                             Drive(100, EffortKind::motor_current, Side::motor, 0.5)}) {
    EXPECT_EQ(check_effort_provenance(look_at(swept(drive, 0.1))).state, CheckState::passed);
  }
  const Dataset none = swept(Drive(100, EffortKind::none, Side::motor), 0.1);
  EXPECT_EQ(check_effort_provenance(look_at(none)).state, CheckState::not_applicable);
}

TEST(EffortProvenance, OfAProposalWarnsAndOfATargetFails) {
  Dataset d = swept(Drive(100, EffortKind::motor_torque, Side::motor), 0.1);
  d.manifest.effort_is_confirmed = false;
  const DataCheck proposed = check_effort_provenance(look_at(d));
  EXPECT_EQ(proposed.state, CheckState::warns);
  EXPECT_NE(proposed.found.find("motor_torque on the motor side is a proposal"), std::string::npos);
  EXPECT_FALSE(proposed.experiment.empty());
  d.manifest.drive = Drive(100, EffortKind::target_torque, Side::joint);
  const DataCheck target = check_effort_provenance(look_at(d));
  EXPECT_EQ(target.state, CheckState::fails);
  EXPECT_NE(target.found.find("no measurement; that it is one"), std::string::npos) << target.found;
  EXPECT_NE(target.consequence.find("the model's own friction"), std::string::npos);
}

TEST(EffortColumn, ContradictsTheManifestByItsName) {
  const auto current = Drive(100, EffortKind::motor_current, Side::motor, 0.5);
  const auto motor = Drive(100, EffortKind::motor_torque, Side::motor);
  const auto target = Drive(100, EffortKind::target_torque, Side::joint);
  const LoggedEffort ur_current{
      "UR RTDE", "actual_current_0", EffortKind::motor_current, Side::motor, false, false};
  const LoggedEffort ur_target{
      "UR RTDE", "target_moment_0", EffortKind::target_torque, Side::joint, true, false};
  const LoggedEffort franka{
      "libfranka", "state.tau_J[0]", EffortKind::joint_torque, Side::joint, false, true};
  const LoggedEffort ros{"joint states", "elbow.effort", std::nullopt, std::nullopt, false, false};
  struct Case {
    Drive drive;
    LoggedEffort logged;
    const char* word;  ///< Empty: they agree.
  };
  for (const Case& one :
       {Case{current, ur_current, ""}, Case{target, ur_target, ""}, Case{at_joint(100), franka, ""},
        Case{motor, ros, ""}, Case{current, ros, ""},
        // The side of a current is where its torque constant is stated.
        Case{Drive(100, EffortKind::motor_current, Side::joint, 50), ur_current, ""},
        Case{motor, ur_current, "a motor_current; the manifest states a motor_torque"},
        Case{current, ur_target, "a target of its controller"},
        Case{at_joint(100), ur_target, "a target of its controller"},
        Case{target, ur_current, "a measurement"}, Case{current, franka, "a joint_torque"},
        Case{motor, franka, "on the joint side"},
        Case{Drive(100, EffortKind::motor_torque, Side::joint), franka, "behind the gear"}}) {
    Dataset d = swept(one.drive, 0.1);
    d.inputs = {written_by_logger(one.logged)};
    const DataCheck check = check_effort_column(look_at(d));
    const bool agrees = std::string(one.word).empty();
    EXPECT_EQ(check.state, agrees ? CheckState::passed : CheckState::fails) << check.found;
    EXPECT_NE(check.found.find(one.word), std::string::npos) << check.found;
    EXPECT_EQ(check.found.find(one.logged.column) != std::string::npos, !agrees) << check.found;
  }
  EXPECT_EQ(check_effort_column(look_at(swept(motor, 0.1))).state, CheckState::not_applicable);
}

TEST(LinkSideTorque, WithLittleFrictionIsTakenBehindTheGear) {
  const DataCheck check = check_link_side_torque(look_at(swept(at_joint(100), 0.01)));
  EXPECT_EQ(check.state, CheckState::warns);
  EXPECT_NEAR(check.measured.value(), 100 * 0.01 / 1.01, 0.1);
  EXPECT_NE(check.found.find("contains little gear friction"), std::string::npos) << check.found;
  EXPECT_NE(check.consequence.find("friction behind the sensor"), std::string::npos);
}

TEST(LinkSideTorque, WithAGearsFrictionIsTakenForOneOfTheMotor) {
  const DataCheck check = check_link_side_torque(look_at(swept(at_joint(100), 0.15)));
  EXPECT_EQ(check.state, CheckState::passed);
  EXPECT_NE(check.found.find("motor's current"), std::string::npos) << check.found;
  // More stages lose more.
  EXPECT_LT(*check_link_side_torque(look_at(swept(at_joint(10), 0.15))).at_least, *check.at_least);
}

TEST(LinkSideTorque, OfASensorKnownToSitThereWarnsWhateverItShows) {
  const LoggedEffort franka{
      "libfranka", "state.tau_J[0]", EffortKind::joint_torque, Side::joint, false, true};
  for (const double gear_ratio : {1.0, 100.0}) {
    for (const double friction : {0.001, 0.15}) {
      Dataset d = swept(at_joint(gear_ratio), friction);
      d.inputs = {written_by_logger(franka)};
      EXPECT_EQ(check_link_side_torque(look_at(d)).state, CheckState::warns);
    }
  }
}

TEST(LinkSideTorque, IsNoMatterOfOtherEffortsOrWithoutAGear) {
  for (const Drive& drive : {at_joint(1), Drive(100, EffortKind::motor_torque, Side::motor),
                             Drive(100, EffortKind::motor_torque, Side::joint),
                             Drive(100, EffortKind::motor_current, Side::joint, 50),
                             Drive(100, EffortKind::target_torque, Side::joint)}) {
    EXPECT_EQ(check_link_side_torque(look_at(swept(drive, 0.001))).state,
              CheckState::not_applicable);
  }
}

TEST(LinkSideTorque, ThatNothingCanTellStillWarns) {
  Dataset d = swept(at_joint(100), 0.01);
  Recording& r = d.recordings.front();
  for (std::vector<double>* v : {&r.t_s, &r.q_rad, &r.torque_Nm}) v->resize(1000);
  const DataCheck check = check_link_side_torque(look_at(d));
  EXPECT_EQ(check.state, CheckState::warns);
  EXPECT_FALSE(check.measured);
}

Manifest with_known_gravity(const Drive& drive) {
  Manifest m;
  m.drive = drive;
  m.known_gravity.emplace(400.0, 0.5);
  return m;
}

/// 400 N·m at the joint times the factor, as the motor of this drive carries it.
FoundGravity found_with_factor(const Drive& drive, double factor, double q_peak_rad = 0.5) {
  const double motor_Nm = 400 * factor / drive.gear_ratio();
  return {symmetric_estimate(motor_Nm, 0.01 * motor_Nm, "known"), q_peak_rad};
}

TEST(StaticTorque, NamesWhatMakesItWrongByAFactor) {
  const Drive torque(100, EffortKind::motor_torque, Side::motor);
  const Drive current(160, EffortKind::motor_current, Side::motor, 0.11);
  struct Case {
    Drive drive;
    double factor;
    CheckState state;
    const char* word;
  };
  for (const Case& one :
       {Case{torque, 1.0, CheckState::passed, ""}, Case{torque, 1.15, CheckState::passed, ""},
        Case{torque, 0.85, CheckState::passed, ""},
        Case{torque, 1.5, CheckState::warns, "no usual cause"},
        Case{torque, 100, CheckState::fails, "joint's torque stated as the motor's"},
        Case{torque, 0.01, CheckState::fails, "one over the gear ratio"},
        Case{torque, 1050, CheckState::fails, "mN·m"},
        Case{torque, 0.102, CheckState::fails, "kgf·m"},
        Case{torque, 9.81, CheckState::fails, "g is missing"},
        Case{current, 1000, CheckState::fails, "mA taken for A"},
        Case{current, 160, CheckState::fails, "torque constant of the joint's side"},
        Case{current, 0.11, CheckState::fails, "a torque in N·m taken for a current"},
        Case{current, 1.42, CheckState::warns, "effective value"},
        Case{torque, 3, CheckState::fails, "a current in A taken for a torque"}}) {
    const DataCheck check = check_static_torque(with_known_gravity(one.drive),
                                                found_with_factor(one.drive, one.factor));
    EXPECT_EQ(check.state, one.state) << one.factor << ": " << check.found;
    EXPECT_NE(check.found.find(one.word), std::string::npos) << check.found;
    EXPECT_EQ(check.consequence.empty(), one.state == CheckState::passed);
    EXPECT_NEAR(check.measured.value(), one.factor, 1e-9 * one.factor);
  }
}

TEST(StaticTorque, HalfATurnAwayHasTheOtherSign) {
  const Drive drive(100, EffortKind::motor_torque, Side::motor);
  const DataCheck check =
      check_static_torque(with_known_gravity(drive), found_with_factor(drive, 1, 0.5 + pi));
  EXPECT_EQ(check.state, CheckState::fails);
  EXPECT_NE(check.found.find("sign of the effort"), std::string::npos) << check.found;
  EXPECT_NEAR(check.measured.value(), -1, 1e-12);
  const DataCheck turned =
      check_static_torque(with_known_gravity(drive), found_with_factor(drive, 1, 0.5 + pi / 3));
  EXPECT_EQ(turned.state, CheckState::warns);
  EXPECT_NE(turned.found.find("60° apart"), std::string::npos) << turned.found;
}

TEST(StaticTorque, IsNotBelowThatOfThePayloadAlone) {
  Manifest m;
  m.drive = Drive(100, EffortKind::motor_torque, Side::motor);
  m.payload_kg = 10;
  const FoundGravity heavy = found_with_factor(m.drive, 1);      // 400 N·m
  const FoundGravity light = found_with_factor(m.drive, 0.001);  // 0.4 N·m
  EXPECT_EQ(check_static_torque(m, heavy).state, CheckState::not_applicable) << "no distance";
  m.payload_distance_m = 1;  // 98.1 N·m
  EXPECT_EQ(check_static_torque(m, heavy).state, CheckState::passed) << "the arm weighs more";
  EXPECT_EQ(check_static_torque(m, light).state, CheckState::fails);
  EXPECT_EQ(check_static_torque(m, std::nullopt).state, CheckState::not_applicable);
}

TEST(StaticTorque, OfAWideIntervalAccusesNobody) {
  const Drive drive(100, EffortKind::motor_torque, Side::motor);
  const FoundGravity vague{symmetric_estimate(8.0, 6.0, "wide"), 0.5};  // factor 2 ± 1.5
  EXPECT_EQ(check_static_torque(with_known_gravity(drive), vague).state, CheckState::passed);
}

}  // namespace
}  // namespace tribolog
