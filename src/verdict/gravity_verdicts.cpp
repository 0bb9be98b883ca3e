
#include <fmt/format.h>

#include "joint/degrees.h"
#include "verdict/quantity_rooms.h"

namespace tribolog {
namespace {

/// Why no sweep gave the angle: the sweep that was recorded speaks first.
std::string why_no_angle(const Calibration& c) {
  const StageReport& rough = c.rough.stage;
  const StageReport& precise = c.precise.stage;
  return rough.state == StageState::skipped && precise.state != StageState::skipped ? precise.reason
                                                                                    : rough.reason;
}

QuantityVerdict angle(const Calibration& c) {
  constexpr double widest_usable_rad = 5 * rad_per_degree;
  constexpr double widest_known_rad = 30 * rad_per_degree;
  QuantityVerdict q;
  q.key = "cog_angle";
  q.words = "Angle of the centre of gravity";
  q.unit = "rad";
  if (!c.q_peak_rad) {
    lower(q, Verdict::not_identifiable, why_no_angle(c), record_a_sweep);
    return q;
  }
  q.estimate = c.q_peak_rad;
  const double half_width = c.q_peak_rad->half_width();
  if (half_width > widest_usable_rad) {
    lower(q, half_width > widest_known_rad ? Verdict::not_identifiable : Verdict::doubtful,
          fmt::format("known to ± {:.0f}° only", half_width * degrees_per_rad), record_a_sweep);
  }
  const StageReport& source = c.q_peak_source == "cog_precise" ? c.precise.stage : c.rough.stage;
  if (source.state == StageState::partial) {
    lower(q, Verdict::doubtful, source.reason, record_a_sweep);
  }
  return q;
}

}  // namespace

std::vector<QuantityVerdict> gravity_verdicts(const Calibration& c) {
  const SurrogateMass* mass = c.masses.find(c.selection.recommended);
  const std::string why = c.masses.stage.reason;
  const char* const both =
      "slow sweep over the joint's range in both directions, and a "
      "micro-oscillation about the gravity peak";
  std::optional<Estimate> gravity_Nm;
  std::optional<Estimate> mass_kg;
  if (mass != nullptr) {
    gravity_Nm = mass->gravity_Nm;
    mass_kg = mass->mass_kg;
  }
  std::vector<QuantityVerdict> all{
      angle(c), by_estimate("gravity_torque", "Gravity torque", "N·m", gravity_Nm, why, both),
      by_estimate("surrogate_mass", "Surrogate mass", "kg", mass_kg, why, both)};
  // Each independent way to gravity has to be there, or the mass stands on one alone.
  for (const StageReport* stage : {&c.rough.stage, &c.hysteresis.stage}) {
    if (mass == nullptr || stage->state == StageState::done) continue;
    for (std::size_t k = 1; k < all.size(); ++k) {
      lower(all[k], Verdict::doubtful, "nothing independent checks it: " + stage->reason, both);
    }
  }
  return all;
}

}  // namespace tribolog
