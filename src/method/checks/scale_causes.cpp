#include "method/checks/scale_causes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "base/requirements.h"
#include "joint/degrees.h"
#include "method/checks/check_outcome.h"
#include "method/checks/checked_recordings.h"

namespace tribolog::method::checks {

namespace {

constexpr double least_tolerance = 0.01;   // relative
constexpr double dead = 1e-3;              // of the true speed
constexpr double torque_tolerance = 0.12;  // of a weight by design
constexpr double standard_gravity = 9.80665;
const std::string no_cause = "no usual cause has this factor";

struct Cause {
  double factor;
  std::string words;
};

std::vector<Cause> usual_speed_causes(double n) {
  using std::numbers::pi;
  std::vector<Cause> causes{
      {2, "a difference over two samples divided by the time of one"},
      {0.5, "a difference over one sample divided by the time of two"},
      {5.0 / 3, "divided by a sampling time of 3/5 of the real one, such as 6 ms for 10 ms"},
      {3.0 / 5, "divided by a sampling time of 5/3 of the real one, such as 10 ms for 6 ms"},
      {joint::degrees_per_rad, "degrees per second taken for radians per second"},
      {joint::rad_per_degree, "radians per second taken for degrees per second"},
      {2 * pi / 60, "radians per second taken for revolutions per minute"},
      {60 / (2 * pi), "revolutions per minute taken for radians per second"},
      {2 * pi, "radians per second where the angle is in turns"},
      {1 / (2 * pi), "turns per second taken for radians per second"},
      {1000, "a clock in milliseconds taken for seconds, or milliradians for radians"},
      {1e-3, "a clock in seconds taken for milliseconds, or radians for milliradians"}};
  if (n != 1) {
    causes.push_back({n, "the motor's speed beside the joint's angle (the gear ratio)"});
    causes.push_back({1 / n,
                      "the joint's speed beside the motor's angle (one over the gear "
                      "ratio)"});
    causes.push_back({n * 60 / (2 * pi),
                      "the motor's speed in revolutions per minute taken for "
                      "the joint's in radians per second"});
  }
  return causes;
}

std::vector<Cause> usual_torque_causes(const joint::Drive& drive) {
  const double n = drive.gear_ratio();
  const bool is_current = drive.kind() == joint::EffortKind::motor_current;
  std::vector<Cause> causes{
      {1000, is_current ? "mA taken for A" : "mN·m taken for N·m"},
      {1e-3, is_current ? "A taken for mA" : "N·m taken for mN·m, or kN·m for N·m"},
      {standard_gravity, "kg·m stated where N·m was meant (g is missing)"},
      {1 / standard_gravity, "a torque in kgf·m taken for N·m"}};
  if (n != 1) {
    causes.push_back({n, is_current ? "a torque constant of the joint's side stated for the motor's"
                                    : "the joint's torque stated as the motor's (the gear ratio)"});
    causes.push_back({1 / n, is_current
                                 ? "a torque constant of the motor's side stated for the joint's"
                                 : "the motor's torque stated as the joint's (one over the gear "
                                   "ratio)"});
  }
  if (const auto constant = drive.torque_constant_Nm_A()) {
    causes.push_back({*constant, "a torque in N·m taken for a current (the torque constant)"});
    causes.push_back(
        {std::numbers::sqrt2, "amplitude and effective value of the current exchanged (√2)"});
    causes.push_back(
        {1 / std::numbers::sqrt2, "amplitude and effective value of the current exchanged (1/√2)"});
  }
  return causes;
}

std::string named_causes(const std::vector<Cause>& causes, double size, double tolerance) {
  std::string named;
  for (const Cause& cause : causes) {
    if (std::abs(size / cause.factor - 1) > tolerance) continue;
    named += (named.empty() ? "likely " : ", or ") + cause.words;
  }
  return named;
}

}  // namespace

std::string likely_cause_of_scale(double factor, double half_width, double gear_ratio) {
  const double size = std::abs(factor);
  if (size < dead) return "the column is dead: it does not change with the speed";
  const double tolerance = std::max(least_tolerance, half_width / size);
  const std::string named = named_causes(usual_speed_causes(gear_ratio), size, tolerance);
  if (factor < 0) {
    const std::string sign = "the sign is that of the other direction";
    if (std::abs(size - 1) <= tolerance) return sign;
    return sign + (named.empty() ? "" : "; " + named);
  }
  return named.empty() ? no_cause : named;
}

std::string likely_cause_of_torque_scale(double factor, double half_width,
                                         const joint::Drive& drive) {
  const double size = std::abs(factor);
  const double tolerance = std::max(torque_tolerance, half_width / size);
  std::string named = named_causes(usual_torque_causes(drive), size, tolerance);
  if (named.empty() && std::abs(size - 1) > tolerance) {
    named = no_cause;
    if (drive.kind() != joint::EffortKind::motor_current) {
      named += "; a current in A taken for a torque has one over its torque constant";
    }
  }
  if (factor > 0) return named.empty() ? no_cause : named;
  const std::string sign = "the sign of the effort is that of the other direction";
  return named.empty() ? sign : sign + "; " + named;
}

namespace {

// Gravity by design, with cables, covers and a mass that is known to some per cent.
constexpr double least = 0.8;
constexpr double most = 1 / least;
// No design is wrong by that.
constexpr double certainly_less = 0.5;
constexpr double certainly_more = 1 / certainly_less;
constexpr double noticeable_turn_deg = 20;

void judge(DataCheck& check, double factor, double half_width, const joint::Drive& drive) {
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
      is_reversed || high < certainly_less || (check.at_most && low > certainly_more);
  check.state = certain ? CheckState::fails : CheckState::warns;
  check.found += "; " + likely_cause_of_torque_scale(factor, half_width, drive);
  check.consequence =
      is_reversed && !too_small && !too_large
          ? "gravity's peak is taken for its trough, half a turn away"
          : "if what is stated is right, every torque and mass is wrong by the same factor";
  check.experiment =
      "hold the joint still with a known mass at a known distance, and compare the effort with "
      "m g r";
}

}  // namespace

DataCheck check_static_torque(const joint::Manifest& m, const std::optional<FoundGravity>& found) {
  DataCheck check;
  check.name = "static_torque";
  check.title = "Static torque against the weight";
  const bool has_payload = m.payload_kg && *m.payload_kg > 0 && m.payload_distance_m;
  if (!m.known_gravity && !has_payload) {
    return not_applicable(check.name, check.title,
                          "the manifest states neither [known_gravity] nor a [payload] with "
                          "mass_kg and distance_m");
  }
  if (!found) {
    return not_applicable(check.name, check.title, "no gravity was found to compare with");
  }
  const double n = m.drive.gear_ratio();
  const double found_Nm = n * found->amplitude_Nm.value;
  check.recording = "all";
  check.unit = pure_number;
  check.at_least = least;
  if (!m.known_gravity) {
    const double payload_Nm = *m.payload_kg * m.gravity_m_s2 * *m.payload_distance_m;
    const double half_width = n * found->amplitude_Nm.half_width() / payload_Nm;
    check.measure = "gravity torque found / m g r of the payload alone, at the joint";
    check.measured = found_Nm / payload_Nm;
    check.found =
        fmt::format("{:.4g} N·m found, {:.4g} N·m by the payload alone", found_Nm, payload_Nm);
    judge(check, *check.measured, std::isfinite(half_width) ? half_width : 0, m.drive);
    return check;
  }
  const double stated_Nm = m.known_gravity->amplitude_Nm();
  const double turn =
      std::remainder(found->q_peak_rad - m.known_gravity->q_peak_rad(), 2 * std::numbers::pi);
  const double half_width = n * found->amplitude_Nm.half_width() / stated_Nm;
  check.measure = "gravity torque found / stated, at the joint";
  check.at_most = most;
  const double sign = std::cos(turn) < 0 ? -1.0 : 1.0;
  check.measured = sign * found_Nm / stated_Nm;
  check.found = fmt::format("{:.4g} N·m found, largest at {:.4g}°; {:.4g} N·m stated, at {:.4g}°",
                            found_Nm, found->q_peak_rad * joint::degrees_per_rad, stated_Nm,
                            m.known_gravity->q_peak_rad() * joint::degrees_per_rad);
  judge(check, *check.measured, std::isfinite(half_width) ? half_width : 0, m.drive);
  const double off_deg = std::abs(std::remainder(turn, std::numbers::pi)) * joint::degrees_per_rad;
  if (off_deg > noticeable_turn_deg) {
    if (check.state == CheckState::passed) check.state = CheckState::warns;
    check.found += fmt::format("; the angles of the peak are {:.3g}° apart", off_deg);
    if (check.consequence.empty()) check.consequence = "one of the two angles counts otherwise";
    if (check.experiment.empty()) {
      check.experiment = "see from where the log and the stated gravity count the angle";
    }
  }
  return check;
}

}  // namespace tribolog::method::checks
