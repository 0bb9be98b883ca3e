// What loops, the masses read from them, LuGre fitted to them and break-away ramps state.

#include "wording/messages.h"

namespace tribolog::wording {

const Messages& hysteresis_messages() {
  static const Messages all{
      // The loop.
      {"loop.bristle_recorded", text("recorded")},
      {"loop.bristle_fitted", text("LuGre model fitted to the loop")},
      {"loop.no_oscillation",
       text("no oscillation was recorded; a sine of about ten cycles, with an amplitude of a few "
            "times the pre-sliding range, would give hysteresis and bristle stiffness; at the "
            "gravity peak, if there is one, the surrogate mass too")},
      {"loop.presliding_not_resolved",
       text("hysteresis cannot be resolved: no oscillation was recorded, and the angle's step of "
            "{step_rad:.3g} rad leaves {steps:.1f} steps in the {travel_rad:.2g} rad of "
            "pre-sliding travel after a reversal of the sweep; at least {needed:.0f} are needed")},
      {"loop.angle_not_periodic",
       text("{recording}: the angle is not periodic: a harmonic series leaves {residual_rad:.2g} "
            "rad of an amplitude of {amplitude_rad:.2g} rad; and {why}")},
      {"loop.no_whole_cycle",
       text("{recording}: the angle does not complete one whole cycle; and {why}")},
      {"loop.width_not_resolved",
       text("{recording}: the angle's step of {step_rad:.3g} rad leaves {steps:.1f} steps in the "
            "loop's width of {width_rad:.3g} rad; at least {needed:.0f} are needed")},
      {"loop.start_up_in_midline", text("{recording}: only one cycle was recorded; its mid-line "
                                        "still contains the start-up stroke")},
      {"loop.no_bristle_deflection", text("no bristle deflection is available: {why}")},

      // The surrogate masses.
      {"masses.no_gravity_torque",
       text("neither an oscillation, a sweep nor the runs give a gravity torque, so there is no "
            "surrogate mass")},
      {"masses.loop_far_from_peak",
       text("the oscillation lies {distance_deg:.0f}° from the gravity peak, where "
            "{share_percent:.0f} % of the gravity torque acts: the paper's six masses and the "
            "mid-line are not available there; oscillate at the peak")},
      {"masses.of_sweep_only",
       text("without a hysteresis loop the paper's six masses and the mid-line are not available; "
            "the mass comes from the sweep's gravity amplitude")},
      {"masses.of_model_only",
       text("without a hysteresis loop the paper's six masses and the mid-line are not available; "
            "the mass comes from the gravity of sweeps and runs")},
      {"masses.of_stated_gravity_only",
       text("without a hysteresis loop the paper's six masses and the mid-line are not available; "
            "the mass comes from the gravity stated in the manifest")},
      {"masses.no_loop_points",
       text("the points A to F were not found: no complete loop with its bristle deflection")},

      // Positions that average torque ripple out.
      {"positions.ripple_with_periods",
       text("the oscillation was recorded at one position only, where torque ripple is a constant "
            "that no repetition averages out: the sweep shows {lines: and } periods per motor "
            "turn, so the gravity torque read from the loop is known to ±{half_width_now_Nm:.3g} "
            "N·m at the motor; oscillating at the {further} further angles listed with the "
            "cross-checks would reduce that to ±{expected_half_width_Nm:.2g} N·m")},
      {"positions.ripple_line", text("{amplitude_Nm:.3g} N·m at {periods_per_turn:.4g}")},
      {"positions.ripple_without_period",
       text("the oscillation was recorded at one position only, where torque ripple is a constant "
            "that no repetition averages out: the sweep shows a standard deviation of "
            "{standard_deviation_Nm:.3g} N·m without a clear period, so the gravity torque read "
            "from the loop is known to ±{half_width_now_Nm:.3g} N·m at the motor; oscillating at "
            "the {further} further angles listed with the cross-checks would reduce that to "
            "±{expected_half_width_Nm:.2g} N·m")},

      // LuGre fitted to the loops.
      {"lugre.no_friction_to_fit",
       text("the torque is the same throughout the loop: there is no friction in it to fit")},
      {"lugre.not_converged",
       text("the LuGre model could not be fitted to the loops from any of the starting points")},
      {"lugre.loops_do_not_bend",
       text("the loops do not bend: friction stays elastic up to {elastic_up_to_Nm:.2g} N·m about "
            "the middle, so neither break-away torque, gravity torque nor the bristle deflection "
            "shows; a larger amplitude would show them")},
      {"lugre.loops_too_slow",
       text("the motor stays below {peak_speed_rad_s:.3g} rad/s in the loops: Coulomb torque and "
            "Stribeck velocity do not show in them and are taken from the constant-speed runs")},
      {"lugre.stribeck_not_apart",
       text("the motor stays below {peak_speed_rad_s:.3g} rad/s in the loops, where friction has "
            "only begun to fall with speed: Coulomb torque and Stribeck velocity cannot be told "
            "apart")},
      {"lugre.static_torque_extrapolated",
       text("the loops reach only {way_to_sliding_percent:.0f} % of the way to sliding, so the "
            "break-away torque is extrapolated: a larger amplitude would show it")},
      {"lugre.neighbours_averaged",
       text("{recording}: means of {samples} neighbouring samples are fitted")},
      {"lugre.start_left_out",
       text("the beginning of {loops} of the loops, where the drive starts the motion, is left out "
            "of the fit: {samples} samples, the first {longest_s:.2g} s of {recording} at most")},
      {"lugre.misfit",
       text("{recording}: the model leaves {residual_Nm:.2g} N·m (standard deviation) where the "
            "noise of angle and torque explains {explained_Nm:.2g} N·m: this joint's friction does "
            "not follow LuGre, and the numbers are those of the closest LuGre model")},
      {"lugre.misfit_behind_reversals",
       text("after a reversal the model has a stiffness of {model_Nm_rad:.3g} N·m/rad at the joint "
            "angle; {measured_Nm_rad:.3g} N·m/rad was measured")},
      {"lugre.contradicted_by_ramps",
       text("the loops flatten at {level_Nm:.3g} N·m, but torque ramps show that the joint holds "
            "{held_Nm:.3g} N·m without sliding: the loops creep, and their level is not the "
            "break-away torque")},

      // Why one of its parameters is not shown.
      {"lugre.any_value_fits", text("these loops would look the same with any value of it")},
      {"lugre.effect_too_small",
       text("what it alone can explain is {effect_Nm:.2g} N·m (rms), below {smallest_Nm:.2g} N·m, "
            "{smallest_share:g} of the loop's height")},
      {"lugre.interval_too_wide",
       text("its 95 % interval is {low:.2g} to {high:.2g} {unit}, wider than half its value")},
      {"lugre.negative",
       text("fitted freely it comes out at {value:.3g} {unit}, which no joint has: the loops "
            "depart from the model where it would act")},
      {"lugre.viscous_looks_like_damping",
       text("bristle damping has the same effect on these loops: only their sum shows")},
      {"lugre.loop_does_not_bend",
       text("the loop does not bend: friction stays elastic over the whole stroke")},
      {"lugre.friction_begins_to_fall",
       text("the motor stays below {peak_speed_rad_s:.3g} rad/s in the loops, where friction has "
            "only begun to fall: of T_s, T_c and ω_s only (T_s − T_c)/ω_s² shows")},
      {"lugre.friction_not_yet_falling",
       text("the motor stays below {peak_speed_rad_s:.3g} rad/s in the loops, where friction does "
            "not yet fall with speed")},
      {"lugre.same_friction_at_all_speeds",
       text("friction is the same at all speeds of the loops")},
      {"lugre.inertia_looks_elastic",
       text("at a single frequency its torque has the same shape as the bristles' elastic torque")},
      {"lugre.rests_on_contradicted_level",
       text("it was inferred from how friction falls from a level that the ramps contradict")},

      // What would show it.
      {"lugre_experiment.past_stribeck_speed",
       text("a further oscillation whose peak motor speed reaches twice the Stribeck velocity of "
            "the runs at constant speed, {stribeck_speed_rad_s:.2g} rad/s (these loops reach "
            "{peak_speed_rad_s:.2g} rad/s at the motor): {frequency_Hz:.2g} Hz with "
            "{amplitude_rad:.2g} rad at the joint, or {fast_frequency_Hz:.2g} Hz with "
            "{fast_amplitude_rad:.2g} rad")},
      {"lugre_experiment.past_unknown_stribeck_speed",
       text("a further oscillation whose peak motor speed 2π f n a exceeds the Stribeck velocity "
            "(these loops reach {peak_speed_rad_s:.2g} rad/s at the motor); runs at constant speed "
            "would show that velocity")},
      {"lugre_experiment.larger_amplitude",
       text("an oscillation of larger amplitude, {larger_rad:.2g} rad at the joint or more, until "
            "the ends of the loop flatten (it was {amplitude_rad:.2g} rad)")},
      {"lugre_experiment.other_frequency",
       text("another oscillation of the same amplitude at {frequency_Hz:.2g} Hz")},
      {"lugre_experiment.runs", text("runs at constant speed")},
      {"lugre_experiment.runs_or_other_frequency",
       text("runs at constant speed, or another oscillation of the same amplitude at "
            "{frequency_Hz:.2g} Hz")},
      {"lugre_experiment.ramps_that_slide",
       text("the ramps themselves show it, where they end in sliding")},

      // The columns of the fit's Jacobian, and the direction in which they show least.
      {"lugre_column.bristle_stiffness", text("bristle stiffness")},
      {"lugre_column.static_torque", text("break-away torque")},
      {"lugre_column.coulomb_torque", text("Coulomb torque")},
      {"lugre_column.stribeck_speed", text("Stribeck velocity")},
      {"lugre_column.bristle_damping", text("bristle damping")},
      {"lugre_column.viscous_coefficient", text("viscous coefficient")},
      {"lugre_column.inertia", text("inertia")},
      {"lugre_column.gravity_torque", text("gravity torque")},
      {"lugre_column.deflection_at_start", text("deflection at the start")},
      {"lugre_column.together_with", text("{columns} together with {column}")},
      {"lugre_column.against", text("{columns} against {column}")},

      // Break-away ramps.
      {"break_away.no_ramps",
       text("no break-away ramp was recorded; five slow torque ramps from rest in each direction "
            "would give the break-away torque without a model")},
      {"break_away.censored",
       text("{recording}: the torque reached {torque_Nm:.4g} N·m and the joint did not break away, "
            "so its break-away torque is larger than {friction_Nm:.4g} N·m (censored: a bound, not "
            "a value)")},
      {"break_away.some_censored",
       text("{count} of {ramps} ramps ended before the joint broke away, so its break-away torque "
            "is larger than {friction_Nm:.4g} N·m (a bound, of {recording}, not a value)")},
      {"break_away.censored_without_bound",
       text("{count} of {ramps} ramps ended before the joint broke away")},
      {"break_away.too_few_towards_negative",
       text("fewer than two ramps broke away towards negative torque; more ramps there, up to a "
            "larger torque, would give the break-away torque with its scatter")},
      {"break_away.too_few_towards_positive",
       text("fewer than two ramps broke away towards positive torque; more ramps there, up to a "
            "larger torque, would give the break-away torque with its scatter")},
      {"break_away.too_few_in_either_direction",
       text("fewer than two ramps broke away in either direction; more ramps there, up to a larger "
            "torque, would give the break-away torque with its scatter")},
      {"break_away.gravity_not_taken_off",
       text("gravity at these angles is not known and was not subtracted: only the mean of both "
            "directions is friction alone")}};
  return all;
}

}  // namespace tribolog::wording
