// What was measured: 35 to 38. None is an error of a file: the verdict, or a note, says it.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "cli/input_cases/case_log.h"
#include "cli/input_cases/input_case.h"
#include "cli/small_dataset.h"

namespace tribolog::test {
namespace {

InputCase found(const std::string& id, const std::string& name, const Change& change,
                const std::string& finds, const std::string& notes = "") {
  InputCase one = accepted(id, name, case_log(change), notes);
  one.numbers = Numbers::any;
  one.finds = finds;
  return one;
}

std::string with_speed(const Change& speed) { return case_log(speed, "t,q,tau,dq"); }

}  // namespace

std::vector<InputCase> content_cases() {
  using std::numbers::pi;
  constexpr double speed_rad_s = 0.1;
  InputCase one_direction = accepted("35c", "OneDirectionOnly", case_log({}, "t,q,tau", ",", 400));
  one_direction.numbers = Numbers::any;
  one_direction.finds =
      "check fails: Both directions in the sweep: the joint angle only ever rises in the rough "
      "sweep: Coulomb friction and offset cannot be told apart";
  InputCase rpm = accepted("37c", "SpeedInRpmReadAsRadians", with_speed([](int i, Row& row) {
                             const double sign = i < 400 ? 1 : -1;
                             row.push_back(fmt::format("{:.6f}", sign * speed_rad_s * 30 / pi));
                           }));
  rpm.finds =
      "check fails: Logged speed against the angle: factor 9.537 ± 0.024 in 1 of 1 recordings; "
      "probably revolutions per minute taken for radians per second";
  rpm.numbers = Numbers::any;
  rpm.manifest =
      case_manifest("effort = {", "speed = { name = \"dq\", unit = \"rad/s\" }\neffort = {");
  return {
      found(
          "35a", "JointThatStands", [](int, Row& row) { row[1] = "0.5"; },
          "check fails: The joint moves: the angle does not change in 1 of 1 recordings"),
      found(
          "35b", "DeadTorqueSensor", [](int, Row& row) { row[2] = "0.0"; },
          "check fails: The torque changes: the torque has one constant value in 1 of 1 "
          "recordings: a dead sensor?"),
      one_direction,
      refused("36a", "FifteenRows", case_log({}, "t,q,tau", ",", 15),
              "log.csv: too few usable rows, found 15 of 15, expected at least 20"),
      with_manifest(refused("36b", "WindowWithNineRows", case_log(),
                            "log.csv: too few usable rows, found 9 of 801, expected at least 20; "
                            "hint: left out: outside the window 39.6.. s: 792"),
                    small_manifest() + "from_s = 39.6\n"),
      found(
          "37a", "DegreesReadAsRadians", [](int, Row& row) { row[1] = scaled(row[1], 180 / pi); },
          "check fails: The angle's unit: the joint's angle reaches 68.75 rad, 10.9 turns: "
          "probably degrees taken for radians, or the motor's angle for the joint's",
          "log.csv: the joint's angle reaches 68.75 rad, read as rad: degrees?"),
      found(
          "37b", "MillinewtonMetresReadAsNewtonMetres",
          [](int, Row& row) { row[2] = scaled(row[2], 1e3); }, "",
          "log.csv: the joint's torque reaches 350000 N·m, read as Nm: another unit, or the "
          "other side of the gear?"),
      rpm,
      found(
          "38a", "TorqueAtItsLimit",
          [](int, Row& row) {
            row[2] = fmt::format("{:.9f}", std::clamp(std::stod(row[2]), -2.0, 2.0));
          },
          "check fails: Torque not clipped: 79.3 % of the samples are stuck at 2 N·m at the motor; "
          "1 recording clipped"),
      found(
          "38b", "EncoderThatWrapsRound",
          [](int, Row& row) {
            if (std::stod(row[1]) > 0.5) row[1] = scaled(row[1], 1, -2 * pi);
          },
          "",
          "log.csv: the angle wraps round 2 times, first at 13.05 s, by 6.28319 rad: it is read as "
          "going on there"),
  };
}

}  // namespace tribolog::test
