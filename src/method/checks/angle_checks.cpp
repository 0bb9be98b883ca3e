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

/// How the angle moves in the samples on either side of a step.
struct MotionAbout {
  double largest_rad{};     ///< Largest step, by magnitude.
  double before_rad{};      ///< Mean step.
  double after_rad{};       ///< Mean step.
  double unevenness_rad{};  ///< Largest difference of a step from their mean.
};

constexpr std::size_t samples_about = 8;

/// @param i the step is that from i to i + 1.
MotionAbout motion_about(const std::vector<double>& q_rad, std::size_t i) {
  MotionAbout out;
  constexpr auto n = static_cast<double>(samples_about);
  out.before_rad = (q_rad[i] - q_rad[i - samples_about]) / n;
  out.after_rad = (q_rad[i + 1 + samples_about] - q_rad[i + 1]) / n;
  const double mean = (out.before_rad + out.after_rad) / 2;
  for (std::size_t k = 1; k <= samples_about; ++k) {
    for (const double step : {q_rad[i - k + 1] - q_rad[i - k], q_rad[i + k + 1] - q_rad[i + k]}) {
      out.largest_rad = std::max(out.largest_rad, std::abs(step));
      out.unevenness_rad = std::max(out.unevenness_rad, std::abs(step - mean));
    }
  }
  return out;
}

/// Whether a joint that moves on as before has been put elsewhere by `step_rad`, beyond its motion.
bool is_put_aside(double step_rad, const MotionAbout& about, double encoder_step_rad) {
  constexpr double beyond_unevenness = 4;
  constexpr double beyond_encoder = 3;  // of its steps
  constexpr double least_rad = 0.03 / joint::degrees_per_rad;
  constexpr double same_motion = 0.3;
  const double mean = (about.before_rad + about.after_rad) / 2;
  const double aside = step_rad - mean;
  if (!(std::abs(aside) > std::max({least_rad, beyond_encoder * encoder_step_rad,
                                    beyond_unevenness * about.unevenness_rad}))) {
    return false;
  }
  if (std::abs(about.after_rad - about.before_rad) > same_motion * std::abs(mean)) return false;
  // One or two rows that were lost under a clock that runs on.
  constexpr double most_lost = 2.5;
  const double lost = aside / mean;
  return !(lost > 0 && lost < most_lost && std::abs(lost - std::round(lost)) < 0.25);
}

/// Whole jumps of a recording: larger than the motion about them, and there to stay.
std::vector<AngleJump> jumps_of(const CheckedRecording& r) {
  constexpr double beyond_motion = 6;   // of the largest step about it
  constexpr double beyond_encoder = 6;  // of its steps
  constexpr double least_rad = 0.01 / joint::degrees_per_rad;
  constexpr double longest_interval = 1.5;
  const std::vector<double>& q = r.recording->q_rad;
  const std::vector<double>& t = r.recording->t_s;
  std::vector<AngleJump> found;
  for (std::size_t i = samples_about; i + samples_about + 1 < q.size(); ++i) {
    const double step = q[i + 1] - q[i];
    if (t[i + 1] - t[i] > longest_interval * r.interval_s) continue;
    // Most steps are those of the motion: only what stands out is looked at in full.
    if (std::abs(step - (q[i] - q[i - 1])) < least_rad) continue;
    const MotionAbout about = motion_about(q, i);
    const bool stands_out = std::abs(step) > std::max({least_rad, beyond_encoder * r.angle_step_rad,
                                                       beyond_motion * about.largest_rad});
    if (stands_out || is_put_aside(step, about, r.angle_step_rad))
      found.push_back({t[i + 1], step});
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
  RecordingCounts even;
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
