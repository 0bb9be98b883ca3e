#include "method/checks/static_torque.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/present.h"
#include "joint/degrees.h"
#include "method/checks/check_outcome.h"
#include "method/checks/checked_recordings.h"
#include "method/checks/scale_causes.h"

namespace tribolog {
namespace {

// Gravity by design, with cables, covers and a mass that is known to some per cent.
constexpr double least = 0.8;
constexpr double most = 1 / least;
// No design is wrong by that.
constexpr double certainly_less = 0.5;
constexpr double certainly_more = 1 / certainly_less;
constexpr double noticeable_turn_deg = 20;

void judge(DataCheck& check, double factor, double half_width, const Drive& drive) {
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

DataCheck check_static_torque(const Manifest& m, const std::optional<FoundGravity>& found) {
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
                            found_Nm, found->q_peak_rad * degrees_per_rad, stated_Nm,
                            m.known_gravity->q_peak_rad() * degrees_per_rad);
  judge(check, *check.measured, std::isfinite(half_width) ? half_width : 0, m.drive);
  const double off_deg = std::abs(std::remainder(turn, std::numbers::pi)) * degrees_per_rad;
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

}  // namespace tribolog
