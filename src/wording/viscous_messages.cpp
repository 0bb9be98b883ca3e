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

      // The models of the curve.
      {"curve_law.coulomb", text("Coulomb")},
      {"curve_law.coulomb_viscous", text("Coulomb and viscous")},
      {"curve_law.power_viscous", text("Coulomb and power-law viscous")},
      {"curve_law.stribeck", text("Stribeck and viscous")},
      {"curve_law.waiboer", text("Waiboer, eq. (6)")},
      {"curve_model.with_load", text("{law}, growing with the load")},
      {"curve_model.with_coulomb_of_directions", text("{law}, Coulomb friction per direction")},
      {"curve_model.with_coulomb_of_directions_and_load",
       text("{law}, Coulomb friction per direction, growing with the load")},
      {"curve_model.with_lines_of_directions",
       text("{law}, Coulomb and viscous friction per direction")},
      {"curve_model.with_lines_of_directions_and_load",
       text("{law}, Coulomb and viscous friction per direction, growing with the load")},

      // Why a model takes no part.
      {"curve_fit.sweep_hides_stribeck",
       text("speed and angle change together in a sweep, which hides a Stribeck effect")},
      {"curve_fit.too_few_speeds",
       text("{speeds} speeds for {parameters} parameters; at least {needed} are needed")},
      {"curve_fit.parameters_not_distinct",
       text("its parameters cannot be told apart in this curve")},
      {"curve_fit.asperity_torque_not_positive", text("its asperity torque is not positive")},
      {"curve_fit.viscous_coefficient_not_positive",
       text("its viscous coefficient is not positive")},
      {"curve_fit.grows_faster_than_speed",
       text("its friction grows faster than speed, which eq. (6) excludes")},
      {"curve_fit.coulomb_torque_not_positive", text("its Coulomb torque is not positive")},
      {"curve_fit.friction_at_rest_below_coulomb",
       text("its friction at rest lies below the Coulomb torque")},
      {"curve_fit.viscous_coefficient_negative", text("its viscous coefficient is negative")},
      {"curve_fit.needs_every_speed", text("it cannot be fitted without each of the speeds")},

      // Which model the curve carries.
      {"curve_model.no_curve", text("there is no viscous curve to choose a model for")},
      {"curve_model.too_few_speeds",
       by_count("speeds",
                "{speeds} speed cannot tell friction models apart; at least {needed} are needed, "
                "ten or more would be good",
                "{speeds} speeds cannot tell friction models apart; at least {needed} are needed, "
                "ten or more would be good")},
      {"curve_model.none_possible_because",
       text("no friction model describes this curve with parameters that a joint can have: {why}")},
      {"curve_model.none_possible",
       text("no friction model describes this curve with parameters that a joint can have")},
      {"curve_model.chosen",
       text("{model}: {parameters} parameters, error {error_Nm:.3g} N·m at held-out speeds")},
      {"curve_model.best_gains_too_little",
       text("{law} with {parameters} parameters has {error_Nm:.3g} N·m, a gain within its standard "
            "error")},
      {"curve_model.next_simpler", text("the next simpler one, {law}, has {error_Nm:.3g} N·m")},

      // The sliding law: what of the headline is not sure.
      {"cause.stribeck_not_shown",
       text(
           "the curve shows no Stribeck dip: friction follows a straight line from "
           "{slowest_rad_s:.3g} rad/s on (motor side); a dip below that speed, or one so wide that "
           "it reaches beyond a third of the fastest, would not be seen")},
      {"cause.stribeck_at_the_edge",
       text("the Stribeck dip, at {stribeck_rad_s:.3g} rad/s (motor side), lies at the edge of the "
            "recorded speeds: {below} of them lie below it and {beyond} beyond twice that speed; "
            "{needed} of each would show the law on both sides")},
      {"cause.stray_within_dip",
       text(
           "a speed within the Stribeck dip does not belong to the others' curve and was left out; "
           "of the others only {below} show the dip: which of them are right is not known")},
      {"cause.outliers_of_speeds",
       text("{speeds} of {all} speeds do not belong to the others' curve and were left out; the "
            "farthest, {speed_rad_s:.3g} rad/s (motor side), is off by {off_Nm:.3g} N·m")},
      {"cause.outliers_between_directions",
       text("the difference of the two directions jumps from speed to speed, by {scatter_Nm:.2g} "
            "N·m or {percent:.2g} % of the Coulomb torque, more than the runs themselves scatter: "
            "single runs are wrong, or something other than friction acts in them")},
      {"curve_model.no_coulomb_torque",
       text(
           "the curve follows Waiboer's eq. (6), which has no Coulomb torque: without its Stribeck "
           "term friction goes to zero with the speed")},
      {"curve_model.viscous_not_linear",
       text("friction does not grow in proportion to speed but with its power {exponent:.2g}: the "
            "viscous coefficient is the slope at the fastest speed alone")},
      {"waiboer_five.carried", text("the curve supports Waiboer's five parameters")},
      {"waiboer_five.not_carried",
       text("the curve does not support Waiboer's five parameters: {why}")},
      {"waiboer_five.no_gain",
       text("the curve does not support Waiboer's five parameters: at held-out speeds their error "
            "is {error_Nm:.3g} N·m, no less than the {error_of_chosen_Nm:.3g} N·m of the model "
            "with {parameters_of_chosen}")},
      {"waiboer_five.gain_too_little",
       text("the curve does not support Waiboer's five parameters: at held-out speeds their error "
            "is {error_Nm:.3g} N·m, against {error_of_chosen_Nm:.3g} N·m of the model with "
            "{parameters_of_chosen}, a gain within its standard error")},

      // The parameters of the chosen model.
      {"curve_parameter.coulomb_torque", text("Coulomb torque T_c")},
      {"curve_parameter.excess_at_rest", text("Excess at rest T_s − T_c")},
      {"curve_parameter.asperity_torque", text("Asperity torque T_a")},
      {"curve_parameter.stribeck_velocity", text("Stribeck velocity ω_s")},
      {"curve_parameter.stribeck_power", text("Stribeck power δ_a")},
      {"curve_parameter.viscous_coefficient", text("Viscous coefficient c")},
      {"curve_parameter.power_law_coefficient", text("Viscous coefficient c_v")},
      {"curve_parameter.viscous_exponent", text("Viscous exponent p")},
      {"curve_parameter.waiboer_exponent", text("Viscous exponent 1 − δ_v")},
      {"curve_parameter.coulomb_asymmetry", text("Coulomb asymmetry, (forward − backward)/2")},
      {"curve_parameter.viscous_asymmetry", text("Viscous asymmetry, (forward − backward)/2")},
      {"curve_parameter.power_law_asymmetry",
       text("Asymmetry of the viscous coefficient, (forward − backward)/2")},
      {"curve_parameter.load_torque", text("Added by the full gravity torque")},
      {"unit.as_viscous_coefficient", text("as the viscous coefficient")},

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
