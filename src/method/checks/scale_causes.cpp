#include "method/checks/scale_causes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "base/requirements.h"
#include "joint/degrees.h"
#include "method/checks/check_outcome.h"
#include "method/checks/checked_recordings.h"

namespace tribolog::method::checks {

namespace {

constexpr double least_tolerance = 0.01;   // relative
constexpr double dead = 1e-3;              // of the true speed
constexpr double torque_tolerance = 0.12;  // of a weight by design
constexpr double as_near = 0.04;           // of two causes: as likely as the nearest
constexpr double standard_gravity = 9.80665;

struct Cause {
  double factor;
  Code code;
};

std::vector<Cause> usual_speed_causes(double n) {
  using std::numbers::pi;
  std::vector<Cause> causes{{2, "cause.two_samples_in_time_of_one"},
                            {0.5, "cause.one_sample_in_time_of_two"},
                            {5.0 / 3, "cause.sampling_time_too_short"},
                            {3.0 / 5, "cause.sampling_time_too_long"},
                            {joint::degrees_per_rad, "cause.deg_s_taken_for_rad_s"},
                            {joint::rad_per_degree, "cause.rad_s_taken_for_deg_s"},
                            {2 * pi / 60, "cause.rad_s_taken_for_rpm"},
                            {60 / (2 * pi), "cause.rpm_taken_for_rad_s"},
                            {2 * pi, "cause.rad_s_beside_turns"},
                            {1 / (2 * pi), "cause.turns_s_taken_for_rad_s"},
                            {1000, "cause.ms_taken_for_s"},
                            {1e-3, "cause.s_taken_for_ms"}};
  if (n != 1) {
    causes.push_back({n, "cause.motor_speed_beside_joint_angle"});
    causes.push_back({1 / n, "cause.joint_speed_beside_motor_angle"});
    causes.push_back({n * 60 / (2 * pi), "cause.motor_rpm_taken_for_joint_rad_s"});
  }
  return causes;
}

std::vector<Cause> usual_torque_causes(const joint::Drive& drive) {
  const double n = drive.gear_ratio();
  const bool is_current = drive.kind() == joint::EffortKind::motor_current;
  std::vector<Cause> causes{
      {1000, is_current ? Code{"cause.milliampere_taken_for_ampere"}
                        : Code{"cause.millinewton_metre_taken_for_newton_metre"}},
      {1e-3, is_current ? Code{"cause.ampere_taken_for_milliampere"}
                        : Code{"cause.newton_metre_taken_for_millinewton_metre"}},
      {standard_gravity, "cause.kilogram_metre_stated_for_newton_metre"},
      {1 / standard_gravity, "cause.kilogram_force_metre_taken_for_newton_metre"}};
  if (n != 1) {
    causes.push_back({n, is_current ? Code{"cause.joint_torque_constant_as_motor"}
                                    : Code{"cause.joint_torque_as_motor"}});
    causes.push_back({1 / n, is_current ? Code{"cause.motor_torque_constant_as_joint"}
                                        : Code{"cause.motor_torque_as_joint"}});
  }
  if (const auto constant = drive.torque_constant_Nm_A()) {
    causes.push_back({*constant, "cause.torque_taken_for_current"});
  }
  // Conventions of a torque constant, which a torque that a drive computes has as well.
  for (const Cause& of_constant :
       {Cause{std::numbers::sqrt2, "cause.amplitude_for_effective"},
        Cause{1.5, "cause.dq_convention"}, Cause{std::numbers::sqrt3, "cause.line_for_phase"},
        Cause{2, "cause.two_phases_for_one"}}) {
    causes.push_back(of_constant);
    causes.push_back({1 / of_constant.factor, of_constant.code});
  }
  return causes;
}

/// The nearest, and those that are as near. Empty where none fits.
Statement fitting_causes(const std::vector<Cause>& causes, double size, double tolerance) {
  const auto distance = [&](const Cause& cause) { return std::abs(size / cause.factor - 1); };
  double nearest = tolerance;
  for (const Cause& cause : causes) nearest = std::min(nearest, distance(cause));
  std::vector<Statement> fitting;
  for (const Cause& cause : causes) {
    if (distance(cause) > std::min(tolerance, nearest + as_near)) continue;
    fitting.emplace_back(cause.code);
  }
  if (fitting.empty()) return {};
  return {"scale.likely", {{"causes", std::move(fitting)}}};
}

}  // namespace

Statement likely_cause_of_scale(double factor, double half_width, double gear_ratio) {
  const double size = std::abs(factor);
  if (size < dead) return {"scale.speed_dead"};
  const double tolerance = std::max(least_tolerance, half_width / size);
  const Statement causes = fitting_causes(usual_speed_causes(gear_ratio), size, tolerance);
  if (factor < 0) {
    Statement reversed{"scale.speed_reversed"};
    if (std::abs(size - 1) <= tolerance) return reversed;
    reversed.add(causes);
    return reversed;
  }
  return causes.empty() ? Statement{"scale.no_usual_cause"} : causes;
}

Statement likely_cause_of_torque_scale(double factor, double half_width,
                                       const joint::Drive& drive) {
  const double size = std::abs(factor);
  const double tolerance = std::max(torque_tolerance, half_width / size);
  Statement causes = fitting_causes(usual_torque_causes(drive), size, tolerance);
  if (causes.empty() && std::abs(size - 1) > tolerance) {
    causes = drive.kind() == joint::EffortKind::motor_current
                 ? Code{"scale.no_usual_cause"}
                 : Code{"scale.no_usual_cause_of_torque"};
  }
  if (factor > 0) return causes.empty() ? Statement{"scale.no_usual_cause"} : causes;
  Statement reversed{"scale.effort_reversed"};
  reversed.add(causes);
  return reversed;
}

namespace {

// Tolerance of gravity by design: cables, covers and a mass that is known to a few per cent.
constexpr double least_of_payload = 0.8;
// No design value is wrong by that much.
constexpr double certainly_less = 0.5;
constexpr double certainly_more = 1 / certainly_less;
constexpr double noticeable_turn_deg = 20;

/// @param is_certain beyond its limits the factor leaves no doubt that what is stated is not found.
void judge(DataCheck& check, double factor, double half_width, bool is_certain,
           const joint::Drive& drive) {
  const double low = std::abs(factor) - half_width;
  const double high = std::abs(factor) + half_width;
  const bool too_small = high < present(check.at_least);
  const bool too_large = check.at_most && low > *check.at_most;
  const bool is_reversed = factor < 0;
  if (!too_small && !too_large && !is_reversed) {
    check.state = CheckState::passed;
    return;
  }
  const bool certain =
      is_certain || is_reversed || high < certainly_less || (check.at_most && low > certainly_more);
  check.state = certain ? CheckState::fails : CheckState::warns;
  check.found.add(likely_cause_of_torque_scale(factor, half_width, drive));
  check.consequence = is_reversed && !too_small && !too_large
                          ? Code{"static_torque.peak_taken_for_trough"}
                          : Code{"static_torque.torques_wrong"};
  check.experiment = {"static_torque.hold_known_mass"};
}

}  // namespace

DataCheck check_static_torque(const joint::Manifest& m, const std::optional<FoundGravity>& found) {
  DataCheck check;
  check.name = CheckName::static_torque;
  const bool has_payload = m.payload_kg && *m.payload_kg > 0 && m.payload_distance_m;
  if (!m.known_gravity && !has_payload) {
    return not_applicable(check.name, {"not_applicable.no_stated_gravity"});
  }
  if (m.torque_is_in_amperes) {
    return not_applicable(check.name, {"not_applicable.torques_in_amperes"});
  }
  if (!found) {
    return not_applicable(check.name, {"not_applicable.no_gravity_to_compare"});
  }
  const double n = m.drive.gear_ratio();
  const double found_Nm = n * found->amplitude_Nm.value;
  check.recording = "all";
  check.unit = pure_number;
  if (!m.known_gravity) {
    const double payload_Nm = *m.payload_kg * m.gravity_m_s2 * *m.payload_distance_m;
    const double half_width = n * found->amplitude_Nm.half_width() / payload_Nm;
    check.measure = {"measure.found_of_payload"};
    check.at_least = least_of_payload;
    check.measured = found_Nm / payload_Nm;
    check.found = {"static_torque.found_by_payload",
                   {{"found_Nm", found_Nm}, {"payload_Nm", payload_Nm}}};
    judge(check, *check.measured, std::isfinite(half_width) ? half_width : 0, false, m.drive);
    return check;
  }
  const double stated_Nm = m.known_gravity->amplitude_Nm();
  const double turn =
      std::remainder(found->q_peak_rad - m.known_gravity->q_peak_rad(), 2 * std::numbers::pi);
  const double half_width = n * found->amplitude_Nm.half_width() / stated_Nm;
  check.measure = {"measure.found_of_stated"};
  check.at_least = 1 - m.known_gravity->percent() / 100;
  check.at_most = 1 + m.known_gravity->percent() / 100;
  const double sign = std::cos(turn) < 0 ? -1.0 : 1.0;
  check.measured = sign * found_Nm / stated_Nm;
  check.found = {"static_torque.found_and_stated",
                 {{"found_Nm", found_Nm},
                  {"found_deg", found->q_peak_rad * joint::degrees_per_rad},
                  {"stated_Nm", stated_Nm},
                  {"stated_deg", m.known_gravity->q_peak_rad() * joint::degrees_per_rad}}};
  judge(check, *check.measured, std::isfinite(half_width) ? half_width : 0, true, m.drive);
  const double off_deg = std::abs(std::remainder(turn, std::numbers::pi)) * joint::degrees_per_rad;
  if (off_deg > noticeable_turn_deg) {
    if (check.state == CheckState::passed) check.state = CheckState::warns;
    check.found.add({"static_torque.angles_apart", {{"apart_deg", off_deg}}});
    if (check.consequence.empty()) check.consequence = {"static_torque.angle_counts_otherwise"};
    if (check.experiment.empty()) {
      check.experiment = {"static_torque.see_zero_of_angle"};
    }
  }
  return check;
}

}  // namespace tribolog::method::checks
