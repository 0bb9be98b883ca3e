// Is it the joint's angle, and did its zero stay?

#include <algorithm>
#include <cmath>
#include <vector>

#include "joint/degrees.h"
#include "method/checks/check_list.h"

namespace tribolog::method::checks {

DataCheck check_motor_speed(const CheckedDataset& data) {
  // 24 000 revolutions a minute: no joint's motor turns faster.
  constexpr double fastest_rad_s = 2500;
  DataCheck check;
  check.name = CheckName::motor_speed;
  check.measure = {"measure.fastest_motor"};
  check.unit = "rad/s";
  check.at_most = fastest_rad_s;
  double fastest = 0;
  for (const CheckedRecording& r : data.recordings) {
    for (const motion::Stroke& stroke : r.strokes) {
      const double duration = r.recording->t_s[stroke.last - 1] - r.recording->t_s[stroke.first];
      if (!(duration > 0)) continue;
      const double mean = data.manifest->drive.gear_ratio() * stroke.travel_rad / duration;
      if (mean < fastest) continue;
      fastest = mean;
      check.recording = r.recording->name;
    }
  }
  if (!(fastest > 0)) return not_applicable(check.name, {"not_applicable.none_has_to_move"});
  check.measured = fastest;
  if (fastest <= fastest_rad_s) return passed_by_all(check, {"motor_speed.plausible"});
  check.state = CheckState::fails;
  check.found = {"motor_speed.too_fast",
                 {{"fastest_rad_s", fastest},
                  {"ratio", data.manifest->drive.gear_ratio()},
                  {"rpm", fastest * joint::degrees_per_rad / 6}}};
  check.consequence = {"motor_speed.scale_wrong"};
  check.experiment = {"angle_unit.state_unit_and_side"};
  return check;
}

namespace {

/// A step of the angle that the motion before and after it does not make.
struct AngleJump {
  double t_s{};
  double size_rad{};
};

/// Whole jumps of a recording: larger than all steps about them, and there to stay.
std::vector<AngleJump> jumps_of(const CheckedRecording& r) {
  constexpr std::size_t about = 8;      // samples on either side
  constexpr double beyond_motion = 6;   // of the largest step about it
  constexpr double beyond_encoder = 6;  // of its steps
  constexpr double least_rad = 0.01 / joint::degrees_per_rad;
  constexpr double longest_interval = 1.5;
  const std::vector<double>& q = r.recording->q_rad;
  const std::vector<double>& t = r.recording->t_s;
  std::vector<AngleJump> found;
  for (std::size_t i = about; i + about + 1 < q.size(); ++i) {
    const double step = std::abs(q[i + 1] - q[i]);
    if (!(step > std::max(least_rad, beyond_encoder * r.angle_step_rad))) continue;
    if (t[i + 1] - t[i] > longest_interval * r.interval_s) continue;
    double largest = 0;
    for (std::size_t k = 1; k <= about; ++k) {
      largest =
          std::max({largest, std::abs(q[i - k + 1] - q[i - k]), std::abs(q[i + k + 1] - q[i + k])});
    }
    if (step > beyond_motion * largest) found.push_back({t[i + 1], q[i + 1] - q[i]});
  }
  return found;
}

}  // namespace

DataCheck check_angle_jumps(const CheckedDataset& data) {
  // A joint that sticks and slips leaps again and again; an encoder that lost counts does not.
  constexpr std::size_t most_of_a_fault = 3;
  DataCheck check;
  check.name = CheckName::angle_jumps;
  check.measure = {"measure.largest_jump"};
  check.unit = "rad";
  check.at_most = 0;
  AngleJump largest;
  RecordingsAsWanted even;
  for (const CheckedRecording& r : data.recordings) {
    if (r.recording->role == joint::Role::break_away || r.strokes.empty()) continue;
    const std::vector<AngleJump> jumps = jumps_of(r);
    const bool is_even = jumps.empty() || jumps.size() > most_of_a_fault;
    even.add(is_even, r.recording->name);
    if (is_even) continue;
    for (const AngleJump& jump : jumps) {
      if (std::abs(jump.size_rad) <= std::abs(largest.size_rad)) continue;
      largest = jump;
      check.recording = r.recording->name;
    }
  }
  if (even.all() == 0) return not_applicable(check.name, {"not_applicable.none_has_to_move"});
  check.measured = std::abs(largest.size_rad);
  if (even.others() == 0) return passed_by_all(check, {"angle_jumps.none"});
  check.state = CheckState::fails;
  check.found = {"angle_jumps.found",
                 {{"jump_deg", largest.size_rad * joint::degrees_per_rad},
                  {"t_s", largest.t_s},
                  {"recordings", even.others()}}};
  check.consequence = {"angle_jumps.zero_moved"};
  check.experiment = {"record.one_homing"};
  return check;
}

}  // namespace tribolog::method::checks
