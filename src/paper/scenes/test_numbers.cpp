#include "paper/scenes/test_numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "paper/scenes/scene_words.h"
#include "wording/axis_scale.h"
#include "wording/number_text.h"

namespace tribolog::paper::scenes {
namespace {

statistics::Estimate exact(double value) {
  return statistics::symmetric_estimate(value, 0.0, {"interval.stated"});
}

bool is_finite(const statistics::Estimate& e) {
  return std::isfinite(e.value) && std::isfinite(e.low) && std::isfinite(e.high);
}

/// Of all samples, also those where the joint starts and stops.
std::optional<robot::AngleRange> range_of(const method::gravity::SweepCurves& sweep) {
  if (!(sweep.lowest_rad < sweep.highest_rad)) return std::nullopt;
  return robot::AngleRange{sweep.lowest_rad, sweep.highest_rad};
}

}  // namespace

TestNumbers stated_numbers(const robot::RobotDescription& robot) {
  TestNumbers out;
  out.range = robot.range;
  out.surrogate_distance_m = robot.surrogate_distance_m;
  if (!robot.load) return out;
  const joint::GravityLoad& load = *robot.load;
  out.q_peak_rad = exact(load.q_peak_rad());
  out.mass = DrivenMass{load.mass_kg(), load.distance_m()};
  out.gravity_m_s2 = load.gravity_m_s2();
  out.surrogate_mass_kg = exact(joint::surrogate_mass_kg(
      load.amplitude_Nm(), 1.0, out.surrogate_distance_m, out.gravity_m_s2, 1.0));
  return out;
}

TestNumbers identified_numbers(const calibration::Calibration& c) {
  TestNumbers out;
  out.identified = true;
  out.surrogate_distance_m = c.manifest.surrogate_distance_m;
  out.gravity_m_s2 = c.manifest.gravity_m_s2;
  out.range = range_of(c.curves.rough);
  if (!out.range) out.range = range_of(c.curves.precise);
  if (c.q_peak_rad && is_finite(*c.q_peak_rad)) out.q_peak_rad = c.q_peak_rad;
  const method::hysteresis::SurrogateMass* mass = c.masses.find(c.selection.recommended);
  if (mass != nullptr && is_finite(mass->mass_kg)) out.surrogate_mass_kg = mass->mass_kg;
  return out;
}

statistics::Estimate mass_angle_rad(const robot::JointUnderTest& test,
                                    const statistics::Estimate& q_peak_rad) {
  const double shift = -test.line_above_level_rad();
  const double value = std::remainder(shift - q_peak_rad.value, 2 * std::numbers::pi);
  return {value, value - (q_peak_rad.high - q_peak_rad.value),
          value + (q_peak_rad.value - q_peak_rad.low), q_peak_rad.method};
}

std::string angle_text(const TestNumbers& numbers, const statistics::Estimate& angle_rad) {
  return numbers.identified ? wording::with_interval(angle_rad, wording::degrees())
                            : degrees_text(angle_rad.value, 5);
}

std::string size_text(const TestNumbers& numbers, const statistics::Estimate& angle_rad) {
  return angle_text(numbers, statistics::scaled(angle_rad, angle_rad.value < 0 ? -1 : 1));
}

std::string mass_text(const TestNumbers& numbers, const statistics::Estimate& mass_kg) {
  return numbers.identified ? wording::with_interval(mass_kg, {1.0, "kg"})
                            : kilogram_text(mass_kg.value);
}

}  // namespace tribolog::paper::scenes
