#include <fmt/format.h>

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

/// A number of a model is one of the joint as far as the model describes the joint.
void judge_by_misfit(const LuGreFit& fit, QuantityVerdict& q) {
  // A joint whose loop differs from LuGre's by 0.6 % of its height can be 26 % stiffer or softer
  // (tests/pipeline/other_friction_test.cpp).
  constexpr double doubtful_share = 0.005;
  constexpr double hopeless_share = 0.1;
  const LuGreLoop* worst = fit.worst_described();
  if (worst == nullptr || !(worst->height_Nm > 0)) return;
  const double share = worst->systematic_Nm / worst->height_Nm;
  if (share <= doubtful_share) return;
  lower(q, share > hopeless_share ? Verdict::not_identifiable : Verdict::doubtful,
        fmt::format("{}: the LuGre model leaves {:.2g} N·m, {:.1f} % of the loop's height, that "
                    "noise does not explain (limit {:.1f} %): its number is the model's nearest, "
                    "not the joint's",
                    worst->recording, worst->systematic_Nm, 100 * share, 100 * doubtful_share),
        "compare with the stiffness behind reversals, which needs no model (table of the loops)");
}

}  // namespace

std::vector<QuantityVerdict> bristle_verdicts(const Calibration& c) {
  const auto& fit = c.hysteresis.lugre;
  // A parameter that the loops do not show says why, and what would show it.
  const auto of_fit = [&](const std::string& key, const std::string& words, const std::string& unit,
                          const char* name, const std::optional<Estimate>& instead) {
    std::string why = why_no_fit(c);
    std::string experiment = record_an_oscillation;
    std::optional<Estimate> estimate = instead;
    if (fit && !estimate) estimate = fit->shown(name);
    for (const LuGreParameter& p : fit ? fit->parameters : std::vector<LuGreParameter>{}) {
      if (p.name != name || p.estimate) continue;
      why = p.why_not;
      experiment = p.experiment;
    }
    return by_estimate(key, words, unit, estimate, why, experiment);
  };
  std::vector<QuantityVerdict> all{
      break_away(c, fit ? fit->shown("static_Nm") : std::nullopt, why_no_fit(c)),
      of_fit("bristle_stiffness", "Bristle stiffness", "N·m/rad", "bristle_stiffness_Nm_rad", {}),
      of_fit("bristle_damping", "Bristle damping", "N·m·s/rad", "bristle_damping_Nms_rad", {}),
      of_fit("inertia", "Inertia at the motor", "kg·m²", "inertia_kgm2", c.rough.inertia_kgm2)};
  if (fit && fit->converged) {
    for (std::size_t k = 1; k < 3; ++k) judge_by_misfit(*fit, all[k]);
  }
  // The method does not rest on these two, and slow loops hardly show them.
  all[2].decides = false;
  all[3].decides = false;
  return all;
}

}  // namespace tribolog
