#include "paper/scenes/scene_words.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "base/error.h"
#include "joint/degrees.h"
#include "wording/axis_scale.h"
#include "wording/number_text.h"
#include "wording/tr.h"

namespace tribolog::paper::scenes {

std::string degrees_text(double rad, int places) {
  const double degrees = rad * joint::degrees_per_rad;
  const std::string size = fmt::format("{:.{}f}°", std::abs(degrees), places);
  const bool zero = size.find_first_of("123456789") == std::string::npos;
  return (degrees < 0 && !zero ? "−" : "") + size;
}

int places_for(const robot::AngleRange& range) {
  const double span_deg = (range.highest_rad - range.lowest_rad) * joint::degrees_per_rad;
  return span_deg >= 10 ? 0 : span_deg >= 1 ? 1 : 3;
}

std::string millimetres_text(double metres) { return fmt::format("{:.0f} mm", 1000 * metres); }

std::string kilogram_text(double kg) { return fmt::format("{:.4g} kg", kg); }

std::string drawn_text(const std::string& text, std::size_t limit) {
  std::string drawn = printable(text, limit);
  std::replace(drawn.begin(), drawn.end(), '{', '(');
  std::replace(drawn.begin(), drawn.end(), '}', ')');
  return drawn;
}

std::string index_text(const std::string& joint_name) {
  constexpr std::size_t longest_plain = 3;
  constexpr std::size_t longest = 16;
  const bool plain =
      joint_name.size() <= longest_plain &&
      std::all_of(joint_name.begin(), joint_name.end(), [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
      });
  return plain ? joint_name : fmt::format("({})", drawn_text(joint_name, longest));
}

std::string dimensions_note(const robot::RobotDescription& robot) {
  return robot.approximate ? wording::tr("Dimensions are approximate.") : "";
}

std::string sentences(std::initializer_list<std::string> all) {
  std::string text;
  for (const std::string& one : all) {
    if (!text.empty() && !one.empty()) text += ' ';
    text += one;
  }
  return text;
}

// The numbers of a test.

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
