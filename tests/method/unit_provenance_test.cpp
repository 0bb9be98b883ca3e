// A unit that is only proposed is in doubt until the data prove it.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "method/checks/check_list.h"
#include "wording/words.h"

namespace tribolog::unit_provenance_test {
namespace {

using method::checks::CheckState;
using std::numbers::pi;

joint::ColumnConversion read_as(joint::LoggedSignal signal, const char* column, const char* unit,
                                bool is_proposed) {
  joint::ColumnConversion conversion;
  conversion.signal = signal;
  conversion.column = column;
  conversion.unit = unit;
  conversion.is_proposed = is_proposed;
  return conversion;
}

/// A sweep there and back by this angle, under gravity and friction, of a log in which a unit is
/// proposed. @param period_rad of gravity: 2 pi where the unit is the right one.
joint::Dataset swept_by(double range_rad, double gravity_Nm, const joint::ColumnConversion& column,
                        double period_rad = 2 * pi) {
  joint::Dataset d;
  d.manifest.drive = {100, joint::EffortKind::motor_torque, joint::Side::motor};
  joint::Recording r;
  r.name = "sweep.csv";
  r.role = joint::Role::rough_sweep;
  constexpr int half = 2000;
  for (int i = 0; i <= 2 * half; ++i) {
    const bool up = i < half;
    const double share = static_cast<double>(up ? i : 2 * half - i) / half;
    const double q = (share - 0.5) * range_rad;
    r.t_s.push_back(0.01 * i);
    r.q_rad.push_back(q);
    r.torque_Nm.push_back(gravity_Nm * std::cos(2 * pi * q / period_rad - 0.4) + (up ? 0.3 : -0.3));
  }
  d.recordings.push_back(r);
  joint::InputFile input;
  input.name = r.name;
  input.role = joint::to_string(r.role);
  input.conversions = {column};
  d.inputs = {input};
  return d;
}

method::checks::DataCheck angle_check(const joint::Dataset& d) {
  return method::checks::check_angle_provenance(method::checks::look_at(d));
}

const auto proposed_angle = read_as(joint::LoggedSignal::angle, "pos", "rad", true);

TEST(AngleProvenance, OfAStatedUnitPasses) {
  const auto check =
      angle_check(swept_by(2, 3, read_as(joint::LoggedSignal::angle, "pos", "rad", false)));
  EXPECT_EQ(check.state, CheckState::passed);
  EXPECT_TRUE(check.found.is("unit.stated")) << as_code(check.found);
}

TEST(AngleProvenance, OfAProposedUnitFailsAndNamesTheColumn) {
  const auto check = angle_check(swept_by(2, 3, proposed_angle));
  EXPECT_EQ(check.state, CheckState::fails);
  EXPECT_EQ(check.recording, "sweep.csv");
  EXPECT_NE(wording::words(check.found).find("'rad' of column 'pos' is proposed"),
            std::string::npos)
      << wording::words(check.found);
  EXPECT_TRUE(check.consequence.is("unit.angle_wrong"));
  EXPECT_NE(wording::words(check.experiment).find("--angle-unit"), std::string::npos);
}

TEST(AngleProvenance, IsProvedByGravityOverAWholeTurnAlone) {
  const auto proved = angle_check(swept_by(2 * pi, 3, proposed_angle));
  EXPECT_EQ(proved.state, CheckState::passed);
  EXPECT_TRUE(proved.found.is("unit.proved_by_gravity")) << as_code(proved.found);
  EXPECT_TRUE(proved.consequence.empty());
  EXPECT_EQ(angle_check(swept_by(0.9 * 2 * pi, 3, proposed_angle)).state, CheckState::fails)
      << "less than a turn";
  EXPECT_EQ(angle_check(swept_by(2 * pi, 0, proposed_angle)).state, CheckState::fails)
      << "no gravity shows";
  for (const double times : {0.5, 1.2, 2.0, pi / 180, 180 / pi}) {
    EXPECT_EQ(angle_check(swept_by(times * 2 * pi, 3, proposed_angle, times * 2 * pi)).state,
              CheckState::fails)
        << "a unit that is wrong by a factor of " << times;
  }
}

TEST(SpeedProvenance, OfAProposedClockFails) {
  const joint::Dataset d =
      swept_by(2 * pi, 3, read_as(joint::LoggedSignal::time, "stamp", "ms", true));
  const auto check = method::checks::check_speed_provenance(method::checks::look_at(d));
  EXPECT_EQ(check.state, CheckState::fails) << "gravity proves no clock";
  EXPECT_NE(wording::words(check.found).find("'ms' of column 'stamp' is proposed"),
            std::string::npos)
      << wording::words(check.found);
  EXPECT_TRUE(check.consequence.is("unit.speed_wrong"));
  EXPECT_EQ(angle_check(d).state, CheckState::passed);
}

TEST(SpeedProvenance, OfAProposedSpeedMattersWhereItIsRead) {
  joint::Dataset d = swept_by(2, 3, read_as(joint::LoggedSignal::speed, "velocity", "deg/s", true));
  const auto state = [&] {
    return method::checks::check_speed_provenance(method::checks::look_at(d)).state;
  };
  EXPECT_EQ(state(), CheckState::passed) << "speeds of recordings are derived from the angle";
  d.inputs.front().role = joint::to_string(joint::Role::friction_points);
  EXPECT_EQ(state(), CheckState::fails);
}

}  // namespace
}  // namespace tribolog::unit_provenance_test
