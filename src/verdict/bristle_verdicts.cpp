#include "verdict/quantity_rooms.h"

namespace tribolog {
namespace {

/// Why the loop gave no parameters: the fit's own words, or the stage's.
std::string why_no_fit(const Calibration& c) {
  const auto& fit = c.hysteresis.lugre;
  if (fit && !fit->reason.empty()) return fit->reason;
  if (!c.hysteresis.stage.reason.empty()) return c.hysteresis.stage.reason;
  return "no friction model was fitted to the loop";
}

/// From ramps where there are some that broke away, else from the loop's level.
QuantityVerdict break_away(const Calibration& c, const std::optional<Estimate>& loop_level_Nm,
                           const std::string& why) {
  const BreakAwayResult& ramps = c.break_away;
  const bool from_ramps = ramps.mean_Nm.has_value();
  QuantityVerdict q =
      by_estimate("break_away_torque", "Break-away torque", "N·m",
                  from_ramps ? ramps.mean_Nm : loop_level_Nm, why, record_an_oscillation);
  if (!ramps.ramps.empty() && !from_ramps) {
    lower(q, Verdict::doubtful, "the ramps do not show it: " + ramps.stage.reason,
          "ramps of the torque that go on until the joint slides, several in each direction");
  }
  // Sliding friction cannot be larger than what it takes to start sliding.
  const std::optional<Estimate> coulomb = coulomb_torque(c);
  if (!from_ramps && loop_level_Nm && coulomb && loop_level_Nm->high < coulomb->low) {
    lower(q, Verdict::not_identifiable,
          "the loop's level lies below the Coulomb torque: the joint never broke away in it, and "
          "the break-away torque is only known to be larger",
          "oscillate with a larger amplitude, until the loop's branches run flat");
  }
  return q;
}

}  // namespace

std::vector<QuantityVerdict> bristle_verdicts(const Calibration& c) {
  const auto& fit = c.hysteresis.lugre;
  const bool fitted = fit && fit->converged;
  const std::string why = why_no_fit(c);
  const auto of_fit = [&](Estimate LuGreFit::*member) {
    return fitted ? std::optional<Estimate>((*fit).*member) : std::nullopt;
  };
  // What a fit says of each of its parameters lowers that one here.
  std::vector<QuantityVerdict> all{
      break_away(c, of_fit(&LuGreFit::static_Nm), why),
      by_estimate("bristle_stiffness", "Bristle stiffness", "N·m/rad",
                  of_fit(&LuGreFit::bristle_stiffness_Nm_rad), why, record_an_oscillation),
      by_estimate("bristle_damping", "Bristle damping", "N·m·s/rad",
                  of_fit(&LuGreFit::bristle_damping_Nms_rad), why,
                  "micro-oscillation of higher frequency: damping shows with the speed"),
      by_estimate("inertia", "Inertia at the motor", "kg·m²",
                  c.rough.inertia_kgm2 ? c.rough.inertia_kgm2 : of_fit(&LuGreFit::inertia_kgm2),
                  why, "motion with large accelerations, such as a fast sine over some degrees")};
  // The method does not rest on these two, and slow loops hardly show them.
  all[2].decides = false;
  all[3].decides = false;
  return all;
}

}  // namespace tribolog
