// Checks on where the effort comes from, with answers known beforehand.

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "method/checks/check_list.h"
#include "method/checks/scale_causes.h"
#include "wording/words.h"

namespace tribolog::effort_checks_test {
namespace {

using std::numbers::pi;

/// There and back over two radians: T = cos q ± friction.
joint::Dataset swept(const joint::Drive& drive, double friction_share) {
  joint::Dataset d;
  d.manifest.drive = drive;
  joint::Recording r;
  r.name = "sweep.csv";
  r.role = joint::Role::rough_sweep;
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

joint::InputFile written_by_logger(const joint::LoggedEffort& effort) {
  joint::InputFile input;
  input.name = "sweep.csv";
  input.logged_effort = effort;
  return input;
}

joint::Drive at_joint(double gear_ratio) {
  return {gear_ratio, joint::EffortKind::joint_torque, joint::Side::joint};
}

TEST(EffortProvenance, OfAConfirmedMeasurementPasses) {
  for (const joint::Drive& drive :
       {joint::Drive(100, joint::EffortKind::motor_torque, joint::Side::motor), at_joint(100),
        joint::Drive(100, joint::EffortKind::motor_current, joint::Side::motor, 0.5)}) {
    EXPECT_EQ(
        method::checks::check_effort_provenance(method::checks::look_at(swept(drive, 0.1))).state,
        method::checks::CheckState::passed);
  }
  const joint::Dataset none =
      swept(joint::Drive(100, joint::EffortKind::none, joint::Side::motor), 0.1);
  EXPECT_EQ(method::checks::check_effort_provenance(method::checks::look_at(none)).state,
            method::checks::CheckState::not_applicable);
}

TEST(EffortProvenance, OfAProposalAndOfATargetFails) {
  joint::Dataset d =
      swept(joint::Drive(100, joint::EffortKind::motor_torque, joint::Side::motor), 0.1);
  d.manifest.effort_is_confirmed = false;
  const method::checks::DataCheck proposed =
      method::checks::check_effort_provenance(method::checks::look_at(d));
  EXPECT_EQ(proposed.state, method::checks::CheckState::fails);
  EXPECT_NE(wording::words(proposed.found)
                .find("'motor_torque' on the motor side is proposed, not confirmed"),
            std::string::npos);
  EXPECT_FALSE(proposed.experiment.empty());
  d.manifest.drive = joint::Drive(100, joint::EffortKind::target_torque, joint::Side::joint);
  const method::checks::DataCheck target =
      method::checks::check_effort_provenance(method::checks::look_at(d));
  EXPECT_EQ(target.state, method::checks::CheckState::fails);
  EXPECT_NE(wording::words(target.found).find("not a measurement; that, too,"), std::string::npos)
      << wording::words(target.found);
  EXPECT_NE(wording::words(target.consequence).find("the model's own, not the joint's"),
            std::string::npos);
}

TEST(EffortColumn, ContradictsTheManifestByItsName) {
  const auto current = joint::Drive(100, joint::EffortKind::motor_current, joint::Side::motor, 0.5);
  const auto motor = joint::Drive(100, joint::EffortKind::motor_torque, joint::Side::motor);
  const auto target = joint::Drive(100, joint::EffortKind::target_torque, joint::Side::joint);
  const joint::LoggedEffort ur_current{
      "UR RTDE", "actual_current_0", joint::EffortKind::motor_current, joint::Side::motor, false,
      false};
  const joint::LoggedEffort ur_target{
      "UR RTDE", "target_moment_0", joint::EffortKind::target_torque, joint::Side::joint, true,
      false};
  const joint::LoggedEffort franka{
      "libfranka", "state.tau_J[0]", joint::EffortKind::joint_torque, joint::Side::joint, false,
      true};
  const joint::LoggedEffort ros{"joint states", "elbow.effort", std::nullopt,
                                std::nullopt,   false,          false};
  struct Case {
    joint::Drive drive;
    joint::LoggedEffort logged;
    const char* word;  ///< Empty: they agree.
  };
  for (const Case& one :
       {Case{current, ur_current, ""}, Case{target, ur_target, ""}, Case{at_joint(100), franka, ""},
        Case{motor, ros, ""}, Case{current, ros, ""},
        // The side of a current is where its torque constant is stated.
        Case{joint::Drive(100, joint::EffortKind::motor_current, joint::Side::joint, 50),
             ur_current, ""},
        Case{motor, ur_current,
             "a 'motor_current' into column 'actual_current_0'; the manifest states a "
             "'motor_torque'"},
        Case{current, ur_target, "a controller target"},
        Case{at_joint(100), ur_target, "a controller target"},
        Case{target, ur_current, "a measurement"}, Case{current, franka, "a 'joint_torque'"},
        Case{motor, franka, "a joint-side torque"},
        Case{joint::Drive(100, joint::EffortKind::motor_torque, joint::Side::joint), franka,
             "on the output side of the gear"}}) {
    joint::Dataset d = swept(one.drive, 0.1);
    d.inputs = {written_by_logger(one.logged)};
    const method::checks::DataCheck check =
        method::checks::check_effort_column(method::checks::look_at(d));
    const bool agrees = std::string(one.word).empty();
    EXPECT_EQ(check.state,
              agrees ? method::checks::CheckState::passed : method::checks::CheckState::fails)
        << wording::words(check.found);
    EXPECT_NE(wording::words(check.found).find(one.word), std::string::npos)
        << wording::words(check.found);
    EXPECT_EQ(wording::words(check.found).find(one.logged.column) != std::string::npos, !agrees)
        << wording::words(check.found);
  }
  EXPECT_EQ(method::checks::check_effort_column(method::checks::look_at(swept(motor, 0.1))).state,
            method::checks::CheckState::not_applicable);
}

TEST(LinkSideTorque, WithLittleFrictionIsTakenBehindTheGear) {
  const method::checks::DataCheck check =
      method::checks::check_link_side_torque(method::checks::look_at(swept(at_joint(100), 0.01)));
  EXPECT_EQ(check.state, method::checks::CheckState::warns);
  EXPECT_NEAR(check.measured.value(), 100 * 0.01 / 1.01, 0.1);
  EXPECT_NE(wording::words(check.found).find("contains little gear friction"), std::string::npos)
      << wording::words(check.found);
  EXPECT_NE(wording::words(check.consequence).find("friction on its motor side is not in them"),
            std::string::npos);
}

TEST(LinkSideTorque, WithAGearsFrictionIsTakenForOneOfTheMotor) {
  const method::checks::DataCheck check =
      method::checks::check_link_side_torque(method::checks::look_at(swept(at_joint(100), 0.15)));
  EXPECT_EQ(check.state, method::checks::CheckState::passed);
  EXPECT_NE(wording::words(check.found).find("motor current"), std::string::npos)
      << wording::words(check.found);
  // More stages lose more.
  EXPECT_LT(
      *method::checks::check_link_side_torque(method::checks::look_at(swept(at_joint(10), 0.15)))
           .at_least,
      *check.at_least);
}

TEST(LinkSideTorque, OfASensorKnownToSitThereWarnsWhateverItShows) {
  const joint::LoggedEffort franka{
      "libfranka", "state.tau_J[0]", joint::EffortKind::joint_torque, joint::Side::joint, false,
      true};
  for (const double gear_ratio : {1.0, 100.0}) {
    for (const double friction : {0.001, 0.15}) {
      joint::Dataset d = swept(at_joint(gear_ratio), friction);
      d.inputs = {written_by_logger(franka)};
      EXPECT_EQ(method::checks::check_link_side_torque(method::checks::look_at(d)).state,
                method::checks::CheckState::warns);
    }
  }
}

TEST(LinkSideTorque, IsNoMatterOfOtherEffortsOrWithoutAGear) {
  for (const joint::Drive& drive :
       {at_joint(1), joint::Drive(100, joint::EffortKind::motor_torque, joint::Side::motor),
        joint::Drive(100, joint::EffortKind::motor_torque, joint::Side::joint),
        joint::Drive(100, joint::EffortKind::motor_current, joint::Side::joint, 50),
        joint::Drive(100, joint::EffortKind::target_torque, joint::Side::joint)}) {
    EXPECT_EQ(
        method::checks::check_link_side_torque(method::checks::look_at(swept(drive, 0.001))).state,
        method::checks::CheckState::not_applicable);
  }
}

TEST(LinkSideTorque, ThatNothingCanTellStillWarns) {
  joint::Dataset d = swept(at_joint(100), 0.01);
  joint::Recording& r = d.recordings.front();
  for (std::vector<double>* v : {&r.t_s, &r.q_rad, &r.torque_Nm}) v->resize(1000);
  const method::checks::DataCheck check =
      method::checks::check_link_side_torque(method::checks::look_at(d));
  EXPECT_EQ(check.state, method::checks::CheckState::warns);
  EXPECT_FALSE(check.measured);
}

joint::Manifest with_known_gravity(const joint::Drive& drive) {
  joint::Manifest m;
  m.drive = drive;
  m.known_gravity.emplace(400.0, 0.5);
  return m;
}

/// 400 N·m at the joint times the factor, as the motor of this drive carries it.
method::checks::FoundGravity found_with_factor(const joint::Drive& drive, double factor,
                                               double q_peak_rad = 0.5) {
  const double motor_Nm = 400 * factor / drive.gear_ratio();
  return {statistics::symmetric_estimate(motor_Nm, 0.01 * motor_Nm), q_peak_rad};
}

TEST(StaticTorque, NamesWhatMakesItWrongByAFactor) {
  const joint::Drive torque(100, joint::EffortKind::motor_torque, joint::Side::motor);
  const joint::Drive current(160, joint::EffortKind::motor_current, joint::Side::motor, 0.11);
  struct Case {
    joint::Drive drive;
    double factor;
    method::checks::CheckState state;
    const char* word;
  };
  for (const Case& one :
       {Case{torque, 1.0, method::checks::CheckState::passed, ""},
        Case{torque, 1.08, method::checks::CheckState::passed, ""},
        Case{torque, 0.92, method::checks::CheckState::passed, ""},
        Case{torque, 1.2, method::checks::CheckState::fails, "no common cause"},
        Case{torque, 100, method::checks::CheckState::fails,
             "joint's torque stated as the motor's"},
        Case{torque, 0.01, method::checks::CheckState::fails, "one over the gear ratio"},
        Case{torque, 1050, method::checks::CheckState::fails, "mN·m"},
        Case{torque, 0.102, method::checks::CheckState::fails, "kgf·m"},
        Case{torque, 9.81, method::checks::CheckState::fails, "g is missing"},
        Case{current, 1000, method::checks::CheckState::fails, "mA taken for A"},
        Case{current, 160, method::checks::CheckState::fails,
             "torque constant of the joint's side"},
        Case{current, 0.11, method::checks::CheckState::fails,
             "a torque in N·m taken for a current"},
        Case{torque, 3, method::checks::CheckState::fails, "a current in A taken for a torque"}}) {
    const method::checks::DataCheck check = method::checks::check_static_torque(
        with_known_gravity(one.drive), found_with_factor(one.drive, one.factor));
    EXPECT_EQ(check.state, one.state) << one.factor << ": " << wording::words(check.found);
    EXPECT_NE(wording::words(check.found).find(one.word), std::string::npos)
        << wording::words(check.found);
    EXPECT_EQ(check.consequence.empty(), one.state == method::checks::CheckState::passed);
    EXPECT_NEAR(check.measured.value(), one.factor, 1e-9 * one.factor);
  }
}

TEST(StaticTorque, NamesTheConventionsOfTorqueConstants) {
  const joint::Drive torque(100, joint::EffortKind::motor_torque, joint::Side::motor);
  const joint::Drive current(160, joint::EffortKind::motor_current, joint::Side::motor, 0.11);
  struct Convention {
    double factor;
    const char* code;
  };
  const std::array conventions{Convention{std::numbers::sqrt2, "cause.amplitude_for_effective"},
                               Convention{1.5, "cause.dq_convention"},
                               Convention{std::numbers::sqrt3, "cause.line_for_phase"},
                               Convention{2, "cause.two_phases_for_one"}};
  for (const joint::Drive& drive : {torque, current}) {
    for (const Convention& one : conventions) {
      for (const double factor : {one.factor, 1 / one.factor}) {
        const method::checks::DataCheck check = method::checks::check_static_torque(
            with_known_gravity(drive), found_with_factor(drive, factor));
        EXPECT_EQ(check.state, method::checks::CheckState::fails) << factor;
        EXPECT_NE(as_code(check.found).find(one.code), std::string::npos)
            << factor << ": " << wording::words(check.found);
      }
    }
  }
  // Between two of them no other is named.
  const method::checks::DataCheck between = method::checks::check_static_torque(
      with_known_gravity(current), found_with_factor(current, 1.6));
  EXPECT_EQ(wording::words(between.found).find("RMS"), std::string::npos);
  EXPECT_EQ(wording::words(between.found).find("two phases"), std::string::npos);
}

TEST(StaticTorque, IsAsNearAsTheStatedGravityIsKnown) {
  const joint::Drive drive(100, joint::EffortKind::motor_torque, joint::Side::motor);
  const auto state_at = [&](double percent, double factor) {
    joint::Manifest m;
    m.drive = drive;
    m.known_gravity.emplace(400.0, 0.5, percent);
    return method::checks::check_static_torque(m, found_with_factor(drive, factor)).state;
  };
  using enum method::checks::CheckState;
  EXPECT_EQ(joint::StatedGravity(400, 0.5).percent(), 10);
  // What is found is known to 1 % itself.
  EXPECT_EQ(state_at(10, 1.10), passed);
  EXPECT_EQ(state_at(10, 1.13), fails);
  EXPECT_EQ(state_at(10, 0.90), passed);
  EXPECT_EQ(state_at(10, 0.87), fails);
  EXPECT_EQ(state_at(2, 1.05), fails);
  EXPECT_EQ(state_at(2, 0.95), fails);
  EXPECT_EQ(state_at(30, 1.25), passed);
  EXPECT_EQ(state_at(30, 0.75), passed);
  EXPECT_EQ(state_at(30, 1.35), fails);
}

TEST(StaticTorque, HalfATurnAwayHasTheOtherSign) {
  const joint::Drive drive(100, joint::EffortKind::motor_torque, joint::Side::motor);
  const method::checks::DataCheck check = method::checks::check_static_torque(
      with_known_gravity(drive), found_with_factor(drive, 1, 0.5 + pi));
  EXPECT_EQ(check.state, method::checks::CheckState::fails);
  EXPECT_NE(wording::words(check.found).find("sign of the effort"), std::string::npos)
      << wording::words(check.found);
  EXPECT_NEAR(check.measured.value(), -1, 1e-12);
  const method::checks::DataCheck turned = method::checks::check_static_torque(
      with_known_gravity(drive), found_with_factor(drive, 1, 0.5 + pi / 3));
  EXPECT_EQ(turned.state, method::checks::CheckState::warns);
  EXPECT_NE(wording::words(turned.found).find("60° apart"), std::string::npos)
      << wording::words(turned.found);
}

TEST(StaticTorque, IsNotBelowThatOfThePayloadAlone) {
  joint::Manifest m;
  m.drive = joint::Drive(100, joint::EffortKind::motor_torque, joint::Side::motor);
  m.payload_kg = 10;
  const method::checks::FoundGravity heavy = found_with_factor(m.drive, 1);      // 400 N·m
  const method::checks::FoundGravity light = found_with_factor(m.drive, 0.001);  // 0.4 N·m
  EXPECT_EQ(method::checks::check_static_torque(m, heavy).state,
            method::checks::CheckState::not_applicable)
      << "no distance";
  m.payload_distance_m = 1;  // 98.1 N·m
  EXPECT_EQ(method::checks::check_static_torque(m, heavy).state, method::checks::CheckState::passed)
      << "the arm weighs more";
  EXPECT_EQ(method::checks::check_static_torque(m, light).state, method::checks::CheckState::fails);
  EXPECT_EQ(method::checks::check_static_torque(m, std::nullopt).state,
            method::checks::CheckState::not_applicable);
}

TEST(StaticTorque, OfAWideIntervalAccusesNobody) {
  const joint::Drive drive(100, joint::EffortKind::motor_torque, joint::Side::motor);
  const method::checks::FoundGravity vague{statistics::symmetric_estimate(8.0, 6.0),
                                           0.5};  // factor 2 ± 1.5
  EXPECT_EQ(method::checks::check_static_torque(with_known_gravity(drive), vague).state,
            method::checks::CheckState::passed);
}

}  // namespace
}  // namespace tribolog::effort_checks_test
