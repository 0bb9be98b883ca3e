#include "method/checks/scale_causes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "joint/degrees.h"

namespace tribolog {
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
      {degrees_per_rad, "degrees per second taken for radians per second"},
      {rad_per_degree, "radians per second taken for degrees per second"},
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

std::vector<Cause> usual_torque_causes(const Drive& drive) {
  const double n = drive.gear_ratio();
  const bool is_current = drive.kind() == EffortKind::motor_current;
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

std::string likely_cause_of_torque_scale(double factor, double half_width, const Drive& drive) {
  const double size = std::abs(factor);
  const double tolerance = std::max(torque_tolerance, half_width / size);
  std::string named = named_causes(usual_torque_causes(drive), size, tolerance);
  if (named.empty() && std::abs(size - 1) > tolerance) {
    named = no_cause;
    if (drive.kind() != EffortKind::motor_current) {
      named += "; a current in A taken for a torque has one over its torque constant";
    }
  }
  if (factor > 0) return named.empty() ? no_cause : named;
  const std::string sign = "the sign of the effort is that of the other direction";
  return named.empty() ? sign : sign + "; " + named;
}

}  // namespace tribolog
