// What stage 5 states: friction over speed, and its models.

#include "wording/messages.h"

namespace tribolog::wording {

const Messages& viscous_messages() {
  static const Messages all{
      // The viscous curves.
      {"viscous.no_runs",
       text("no run at constant speed was recorded; runs at ten or more speeds in both directions "
            "over the same angles would give the viscous curve")},
      {"viscous.no_plateau",
       text("no plateau of constant speed was found in the runs at constant speed")},
      {"viscous.gravity_not_known",
       text("the runs' torque still contains gravity: no surrogate mass is known")},
      {"viscous.friction_from_sweep",
       text("no run at constant speed was recorded; friction comes from the sweep's two directions "
            "at equal angle, so that speed and angle change together along the curve")},
      {"viscous.runs_without_plateau",
       text("{without_plateau} of {runs} runs contain no plateau of constant speed")},

      // Which angles the runs cover.
      {"run_angles.unknown", text("the angles of the runs are not known")},
      {"run_angles.rising_only", text("the joint angle rises in all of them")},
      {"run_angles.falling_only", text("the joint angle falls in all of them")},
      {"run_angles.covered",
       text("forward runs cover {rising_low_deg:.0f}° to {rising_high_deg:.0f}°, backward ones "
            "{falling_low_deg:.0f}° to {falling_high_deg:.0f}°")},
      {"run_angles.none_shared",
       text("forward runs cover {rising_low_deg:.0f}° to {rising_high_deg:.0f}°, backward ones "
            "{falling_low_deg:.0f}° to {falling_high_deg:.0f}°: the directions share no angle")},

      // Laws of friction over the speed.
      {"law.line", text("Coulomb and viscous")},
      {"law.line_with_dip", text("Coulomb and viscous, with a Stribeck dip")},
      {"law.parabola", text("Coulomb, viscous and quadratic")},
      {"law.parabola_with_dip", text("Coulomb, viscous and quadratic, with a Stribeck dip")},
      {"law.power", text("Coulomb and the speed to the power of {power:.3g}")},
      {"law.power_with_dip",
       text("Coulomb and the speed to the power of {power:.3g}, with a Stribeck dip")},

      // What of the headline is not sure.
      {"cause.stribeck_not_shown",
       text("the recordings show no Stribeck dip beyond doubt: from {slowest_rad_s:.3g} rad/s on "
            "(motor side) friction follows a law without one about as well; a dip below that "
            "speed would not be seen")},
      // Why Waiboer's five parameters were not fitted.
      {"waiboer_fit.too_few_runs",
       by_count("runs", "{runs} run for five parameters; at least {needed} are needed",
                "{runs} runs for five parameters; at least {needed} are needed")},
      {"waiboer_fit.did_not_converge", text("no fit converged from any of twelve starting points")},
      {"waiboer_fit.parameters_not_shown",
       text("the speeds recorded do not show all five parameters")},
      {"waiboer_fit.grows_faster_than_speed",
       text("viscous friction grows faster than speed, which eq. (6) does not describe")}};
  return all;
}

}  // namespace tribolog::wording
