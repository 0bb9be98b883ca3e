// What the checks on the recordings state.

#include "wording/messages.h"

namespace tribolog::wording {

const Messages& check_messages() {
  static const Messages all{
      // The checks, in the order of the report.
      {"check.effort_provenance", text("Provenance of the effort")},
      {"check.angle_provenance", text("Provenance of the angle's unit")},
      {"check.speed_provenance", text("Provenance of the units of time and speed")},
      {"check.effort_column", text("Effort column as its logger defines it")},
      {"check.link_side_torque", text("Gear friction in a joint-side torque")},
      {"check.joint_moves", text("The joint moves")},
      {"check.angle_unit", text("The angle's unit")},
      {"check.motor_speed", text("The motor's speed")},
      {"check.angle_jumps", text("Angle without jumps")},
      {"check.clock_jitter", text("Regular sampling")},
      {"check.angle_interpolated", text("Angle sampled as often as logged")},
      {"check.torque_interpolated", text("Torque sampled as often as logged")},
      {"check.clock_gaps", text("No gaps in time")},
      {"check.speed_scale", text("Logged speed against the angle")},
      {"check.speed_noise", text("Noise of the logged speed")},
      {"check.sweep_directions", text("Both directions in the sweep")},
      {"check.run_directions", text("Both directions in the runs")},
      {"check.sweep_common_angles", text("Angles common to both sweep directions")},
      {"check.run_common_angles", text("Angles common to both run directions")},
      {"check.run_speeds", text("Number of speeds")},
      {"check.stick_slip", text("No stick-slip")},
      {"check.torque_alive", text("The torque changes")},
      {"check.torque_held", text("The torque does not stick")},
      {"check.torque_noise", text("Torque signal above the noise")},
      {"check.torque_saturation", text("Torque not clipped")},
      {"check.torque_step", text("Torque step against friction")},
      {"check.friction_dissipates", text("Friction dissipates power")},
      {"check.power", text("Plausible joint power")},
      {"check.friction_drift", text("Friction steady over time")},
      {"check.temperature", text("Temperature")},
      {"check.encoder_step", text("Encoder step against pre-sliding")},
      {"check.oscillation_cycles", text("Cycles of the oscillation")},
      {"check.oscillation_slides", text("The loop reaches sliding")},
      {"check.oscillation_at_peak", text("Oscillation at the gravity peak")},
      {"check.gravity_within_torque", text("Gravity within the measured torque")},
      {"check.static_torque", text("Gravity torque against the stated load")},
      {"check.torque_ripple", text("Torque ripple in the oscillations")},
      {"check.ripple_period", text("Gear ratio against the ripple's period")},

      // What was measured.
      {"measure.effort_as_stated", text("logs whose effort column matches the manifest")},
      {"measure.friction_of_largest_torque",
       text("friction / largest torque in the same recordings")},
      {"measure.moving_recordings", text("recordings in which the joint moves")},
      {"measure.largest_angle", text("largest joint angle")},
      {"measure.interval_scatter", text("scatter of the sampling interval")},
      {"measure.time_in_gaps", text("time lost in gaps")},
      {"measure.speed_of_derivative", text("logged speed / derivative of the angle")},
      {"measure.speed_scatter",
       text("scatter of the logged speed about the angle's slope, relative to the speed")},
      {"measure.rarer_direction", text("share of the travel in the less frequent direction")},
      {"measure.common_travel_at_same_speed",
       text("share of the travel covered in both directions at the same speed")},
      {"measure.common_angles", text("share of the angles covered in both directions")},
      {"measure.different_speeds", text("distinct plateau speeds")},
      {"measure.stops", text("stops within one stroke, each followed by a burst")},
      {"measure.live_recordings", text("recordings in which the torque changes")},
      {"measure.white_noise", text("share of white noise in the variance of the torque")},
      {"measure.clipped_samples", text("samples stuck at the extreme torque")},
      {"measure.torque_step_of_friction",
       text("torque step / half the difference between the directions")},
      {"measure.half_difference",
       text("half the torque difference between the directions at equal angle, motor side")},
      {"measure.largest_power", text("largest torque times speed")},
      {"measure.friction_change", text("change of friction from the first strokes to the last")},
      {"measure.temperature_range", text("range of the temperature over all recordings")},
      {"measure.steps_across_loop", text("angle steps across the loop")},
      {"measure.steps_after_reversal",
       text("angle steps in the pre-sliding travel after a reversal")},
      {"measure.cycles", text("cycles")},
      {"measure.stiffness_left",
       text("stiffness at the end of a stroke / stiffness after a reversal")},
      {"measure.distance_from_peak",
       text("distance of the oscillation's centre from the gravity peak")},
      {"measure.fitted_of_largest_torque", text("fitted gravity torque / largest measured torque")},
      {"measure.found_of_payload",
       text("gravity torque found / m g r of the payload alone, at the joint")},
      {"measure.found_of_stated", text("gravity torque found / stated, at the joint")},
      {"measure.ripple_left_in_mean",
       text("ripple not averaged out over the oscillation positions / gravity torque")},
      {"measure.ripple_periods_off",
       text("distance of the ripple periods per motor turn from a whole number")},

      // Why a check does not apply.
      {"not_applicable.no_torque", text("no torque was recorded")},
      {"not_applicable.no_recording", text("no recording")},
      {"not_applicable.logger_unknown", text("the column names match no known logger")},
      {"not_applicable.no_gear", text("there is no gear between motor and joint")},
      {"not_applicable.no_joint_torque",
       text("the effort is not stated as a torque measured at the joint")},
      {"not_applicable.none_has_to_move", text("no recording in which the joint has to move")},
      {"not_applicable.no_speed_beside_angle",
       text("no speed is logged with a moving angle; it is derived from the angle")},
      {"not_applicable.no_speed_logged", text("no speed is logged in a sweep or a run")},
      {"not_applicable.no_rough_sweep", text("no rough sweep was recorded")},
      {"not_applicable.no_gravity", text("the manifest states that there is no gravity")},
      {"not_applicable.no_run", text("no run at constant speed was recorded")},
      {"not_applicable.joint_stands", text("the joint does not move")},
      {"not_applicable.one_direction", text("only one direction was recorded")},
      {"not_applicable.no_runs", text("no runs at constant speed")},
      {"not_applicable.no_sweep_or_run", text("no sweep or run")},
      {"not_applicable.no_sweep_oscillation_or_run", text("no sweep, oscillation or run")},
      {"not_applicable.no_common_angles",
       text("no recording has both directions over the same angles")},
      {"not_applicable.strokes_not_repeated",
       text("no recording repeats its strokes three times or more")},
      {"not_applicable.no_temperature", text("no temperature is logged")},
      {"not_applicable.no_stepped_reversal",
       text("no oscillation, and no sweep reversal with visible angle steps")},
      {"not_applicable.no_oscillation", text("no oscillation was recorded")},
      {"not_applicable.no_whole_strokes", text("no oscillation with whole strokes")},
      {"not_applicable.peak_unknown", text("the angle of the gravity peak is not known")},
      {"not_applicable.no_gravity_in_sweep", text("no gravity was found in a sweep")},
      {"not_applicable.no_stated_gravity",
       text("the manifest states neither [known_gravity] nor a [payload] with mass_kg and "
            "distance_m")},
      {"not_applicable.no_gravity_to_compare", text("no gravity was found to compare with")},
      {"not_applicable.torques_in_amperes",
       text("the torques are numbers of amperes: without the torque constant none can be compared "
            "with one of newton metres")},
      {"not_applicable.no_sweep_residual",
       text("no gravity was found in a rough sweep, the residual of which would show ripple")},
      {"not_applicable.sweep_too_short_for_ripple",
       text("the rough sweep does not turn the motor often enough to show a period")},
      {"not_applicable.no_ripple_for_gear_ratio",
       text("no ripple stands out; without it nothing in these logs checks the gear ratio")},

      // Where the effort comes from.
      {"effort.stated_at_motor", text("'{effort}' on the motor side, as the manifest states")},
      {"effort.stated_at_joint", text("'{effort}' on the joint side, as the manifest states")},
      {"effort.proposed_at_motor", text("'{effort}' on the motor side is proposed, not confirmed")},
      {"effort.proposed_at_joint", text("'{effort}' on the joint side is proposed, not confirmed")},
      {"effort.is_target",
       text("the effort is a target torque from a controller or its model, not a measurement")},
      {"effort.is_target_proposed",
       text("the effort is a target torque from a controller or its model, not a measurement; "
            "that, too, is proposed, not confirmed")},
      {"effort.constant_unknown",
       text("the torque constant is not known: the effort is a current")},
      {"effort.is_of_amperes",
       text("every torque is a number of amperes: times the torque constant it is one "
            "of newton metres")},
      {"effort.state_constant",
       text("state --torque-constant NM_PER_A, or torque_constant_Nm_A in the manifest")},
      {"effort.friction_of_model",
       text("friction and gravity found in it are the model's own, not the joint's")},
      {"effort.record_measurement", text("also record the motor current or a measured torque")},
      {"effort.wrong_by_one_factor",
       text("if the column is anything else, every torque and mass is wrong by the same factor")},
      {"effort.confirm",
       text("look up what the driver writes, then state effort.kind and effort.side and delete "
            "'confirmed = false'")},

      // Where the units come from.
      {"unit.stated", text("as the manifest states")},
      {"unit.proposed",
       text("'{unit}' of column '{column}' is proposed, not confirmed: the log states no unit")},
      {"unit.proved_by_gravity",
       text("'{unit}' of column '{column}' is proposed; the torque follows the cosine of the angle "
            "in it over a whole turn")},
      {"unit.angle_wrong",
       text("in another unit each number per angle, and with it gravity, is wrong by a factor")},
      {"unit.speed_wrong",
       text("in another unit each number per speed is wrong by the factor between them, the "
            "inertia by its square")},
      {"unit.state_angle",
       text("look up what the logger writes, and state it: --angle-unit UNIT, or in the manifest "
            "without 'confirmed = false'")},
      {"unit.state_speed",
       text("look up what the logger writes, and state it: --time-unit UNIT (of friction points "
            "--speed-unit), or in the manifest without 'confirmed = false'")},

      // The effort against what its logger writes.
      {"effort_column.as_stated", text("the column's name agrees with what the manifest states")},
      {"effort_column.is_target", text("{logger} writes a controller target into column "
                                       "'{column}'; the manifest states a measured '{stated}'")},
      {"effort_column.is_measurement", text("{logger} writes a measurement into column '{column}'; "
                                            "the manifest states a 'target_torque'")},
      {"effort_column.is_other_kind", text("{logger} writes a '{written}' into column '{column}'; "
                                           "the manifest states a '{stated}'")},
      {"effort_column.is_on_motor_side", text("{logger} writes a motor-side torque into column "
                                              "'{column}'; the manifest states the joint side")},
      {"effort_column.is_on_joint_side", text("{logger} writes a joint-side torque into column "
                                              "'{column}'; the manifest states the motor side")},
      {"effort_column.is_behind_gear",
       text("{logger} writes a torque measured on the output side of the gear into column "
            "'{column}'; the manifest states a 'motor_torque'")},
      {"effort_column.other_than_identified",
       text("if the logger is right, the torque differs in kind, unit or side from what the "
            "identification took it for, or is not a measurement at all")},
      {"effort_column.state_as_logged",
       text("state effort.kind and effort.side as the logger writes this column")},

      // A torque measured behind the gear.
      {"link_side.friction_of_a_gear",
       text("friction is {friction_percent:.3g} % of the largest torque, as much as in a gear: the "
            "torque looks as if computed from the motor current; if it does come from a sensor, "
            "friction on the motor side of the sensor is not in it")},
      {"link_side.friction_unknown",
       text("the torque is stated as measured at the joint, on the output side of the gear; no "
            "recording has both directions over the same angles to show how much friction is in "
            "it")},
      {"link_side.friction_in_sensor",
       text("the sensor is on the output side of the gear, and the torque still shows friction of "
            "{friction_percent:.3g} % of its largest value: bearings, seals, cables")},
      {"link_side.little_friction",
       text("friction is only {friction_percent:.3g} % of the largest torque; a gear loses "
            "{gear_loss_percent:.3g} % or more: the torque is measured on the output side and "
            "contains little gear friction")},
      {"link_side.friction_as_sensor_feels",
       text("mass and angle remain valid; friction, break-away torque and bristle parameters are "
            "as seen by the sensor: friction on its motor side is not in them")},
      {"link_side.record_current",
       text("also record the motor current: the difference is the gear friction")},

      // Whether the joint moves, and whether its angle can be one.
      {"joint_moves.in_all", text("the joint moves in every recording")},
      {"joint_moves.angle_stands",
       text("the angle does not change in {standing} of {recordings} recordings")},
      {"joint_moves.shows_nothing",
       text("a joint at rest shows neither the angle of gravity nor friction")},
      {"joint_moves.see_drive_and_column",
       text("check that the joint was driven and that the angle column is live")},
      {"angle_unit.of_a_joint", text("the angles are plausible for a joint")},
      {"angle_unit.torque_follows",
       text("the joint turns further than once; the sweep's torque follows the cosine of the angle "
            "as it was read")},
      {"angle_unit.too_large",
       text("the joint's angle reaches {largest_rad:.4g} rad, {turns:.3g} turns: degrees taken for "
            "radians, or the motor's angle for the joint's?")},
      {"angle_unit.gravity_not_found",
       text("gravity follows the cosine of the angle: in a wrong unit it is not found, or is "
            "wrong, and so is everything that depends on it")},
      {"measure.fastest_motor", text("fastest mean speed of the motor over a stroke")},
      {"motor_speed.plausible", text("the motor turns at speeds that motors have")},
      {"motor_speed.too_fast",
       text("with a gear ratio of {ratio:.6g} the motor would turn at {fastest_rad_s:.3g} rad/s, "
            "{rpm:.2g} revolutions a minute: is the angle the motor's, or are degrees taken for "
            "radians?")},
      {"motor_speed.scale_wrong",
       text("in an angle that is too large by the gear ratio, stiffness, inertia, Stribeck "
            "velocity and viscous coefficient are wrong by that or its square")},
      {"measure.largest_jump", text("largest jump of the angle from a sample to the next")},
      {"angle_jumps.none", text("the angle moves without jumps")},
      {"angle_jumps.found", text("the angle jumps by {jump_deg:+.3g}° at {t_s:.4g} s, as where an "
                                 "encoder loses counts or "
                                 "is homed anew; recordings with jumps: {recordings}")},
      {"angle_jumps.zero_moved",
       text(
           "before and after a jump the same angle is not the same place of the joint: gravity and "
           "its peak are a mixture, and so is a loop")},
      {"angle_unit.state_unit_and_side", text("state the true unit and side of the angle column")},

      // The clock.
      {"measure.samples_between_bends", text("samples from one bend of the angle to the next")},
      {"angle_interpolated.is_not", text("the angle was sampled as often as it is logged")},
      {"angle_interpolated.straight_between", text("the angle bends once in {samples} samples and "
                                                   "is straight between: it comes from a channel "
                                                   "of one sample in {interval_ms:.3g} ms")},
      {"angle_interpolated.held_between", text("the angle changes once in {samples} samples and "
                                               "stands between: it comes from a channel "
                                               "of one sample in {interval_ms:.3g} ms")},
      {"angle_interpolated.bends_acceleration",
       text("acceleration read from it is wrong, and with it inertia and what the loops show")},
      {"measure.samples_between_torque_bends",
       text("samples from one bend of the torque to the next")},
      {"torque_interpolated.is_not", text("the torque was sampled as often as it is logged")},
      {"torque_interpolated.straight_between",
       text("the torque bends once in {samples} samples and is straight between: it comes from a "
            "channel of one sample in {interval_ms:.3g} ms")},
      {"torque_interpolated.held_between",
       text("the torque changes once in {samples} samples and stands between: it comes from a "
            "channel of one sample in {interval_ms:.3g} ms")},
      {"torque_interpolated.is_late", text("it is late against the angle, and what changes faster "
                                           "than it was sampled is not in it: "
                                           "damping and inertia suffer first")},
      {"angle_interpolated.log_each_sample",
       text("log the angle at the torque's rate, or the torque at the angle's")},
      {"clock.interval_scatters",
       text("the sampling interval of {interval_ms:.4g} ms scatters by {scatter_percent:.1f} %")},
      {"clock.speeds_wrong", text("speed and acceleration are derived from angle and clock, and "
                                  "are wrong if the clock is")},
      {"clock.log_time_of_sampling",
       text("log the time at which the drive sampled, not the time at which the row was written")},
      {"clock.no_gap", text("no interval is longer than {intervals} sampling intervals")},
      {"clock.gaps", by_count("gaps", "{gaps} gap, the longest {longest_s:.3g} s",
                              "{gaps} gaps, the longest {longest_s:.3g} s")},
      {"clock.gaps_hide_motion",
       text("what happened in the gaps is unknown: a reversal or settling may be missing, and "
            "slopes across a gap are not speeds")},
      {"clock.log_locally",
       text("log locally in the controller, or at a lower rate that the connection can sustain")},

      // The logged speed against the angle.
      {"speed_scale.factor", text("factor {factor:.4g} ± {half_width:.2g}")},
      {"speed_scale.factor_in_recordings",
       text("factor {factor:.4g} ± {half_width:.2g} in {wrong} of {recordings} recordings")},
      {"speed_scale.does_not_follow_angle",
       text("the speed does not follow the angle at all (correlation {correlation:.2f}): columns "
            "swapped?")},
      {"speed_scale.every_speed_wrong",
       text("speeds are derived from the angle; but one of angle, speed and clock is not what the "
            "manifest says, and then every speed, and everything measured per speed, is wrong by "
            "this factor")},
      {"speed_scale.correct_manifest",
       text("correct the unit, the side or the scale of the speed in the manifest, or of the angle "
            "if that is the wrong one")},

      // What makes a signal wrong by a factor.
      {"scale.likely", text("probably {causes:, or }")},
      {"scale.no_usual_cause", text("no common cause has this factor")},
      {"scale.no_usual_cause_of_torque", text("no common cause has this factor; a current in A "
                                              "taken for a torque would give 1 / torque constant")},
      {"scale.speed_dead", text("the column is dead: it does not change with the speed")},
      {"scale.speed_reversed", text("the sign is reversed")},
      {"scale.effort_reversed", text("the sign of the effort is reversed")},

      // The usual causes of a factor of the speed.
      {"cause.two_samples_in_time_of_one",
       text("a difference over two samples divided by the time of one")},
      {"cause.one_sample_in_time_of_two",
       text("a difference over one sample divided by the time of two")},
      {"cause.sampling_time_too_short",
       text("divided by a sampling time of 3/5 of the real one, such as 6 ms for 10 ms")},
      {"cause.sampling_time_too_long",
       text("divided by a sampling time of 5/3 of the real one, such as 10 ms for 6 ms")},
      {"cause.deg_s_taken_for_rad_s", text("degrees per second taken for radians per second")},
      {"cause.rad_s_taken_for_deg_s", text("radians per second taken for degrees per second")},
      {"cause.rad_s_taken_for_rpm", text("radians per second taken for revolutions per minute")},
      {"cause.rpm_taken_for_rad_s", text("revolutions per minute taken for radians per second")},
      {"cause.rad_s_beside_turns", text("radians per second while the angle is in turns")},
      {"cause.turns_s_taken_for_rad_s", text("turns per second taken for radians per second")},
      {"cause.ms_taken_for_s",
       text("a clock in milliseconds taken for seconds, or milliradians for radians")},
      {"cause.s_taken_for_ms",
       text("a clock in seconds taken for milliseconds, or radians for milliradians")},
      {"cause.motor_speed_beside_joint_angle",
       text("the motor's speed with the joint's angle (the gear ratio)")},
      {"cause.joint_speed_beside_motor_angle",
       text("the joint's speed with the motor's angle (one over the gear ratio)")},
      {"cause.motor_rpm_taken_for_joint_rad_s",
       text("the motor's speed in revolutions per minute taken for the joint's in radians per "
            "second")},

      // The usual causes of a factor of the torque.
      {"cause.milliampere_taken_for_ampere", text("mA taken for A")},
      {"cause.millinewton_metre_taken_for_newton_metre", text("mN·m taken for N·m")},
      {"cause.ampere_taken_for_milliampere", text("A taken for mA")},
      {"cause.newton_metre_taken_for_millinewton_metre",
       text("N·m taken for mN·m, or kN·m for N·m")},
      {"cause.kilogram_metre_stated_for_newton_metre",
       text("kg·m stated where N·m was meant (g is missing)")},
      {"cause.kilogram_force_metre_taken_for_newton_metre",
       text("a torque in kgf·m taken for N·m")},
      {"cause.joint_torque_constant_as_motor",
       text("a torque constant of the joint's side stated for the motor's")},
      {"cause.joint_torque_as_motor",
       text("the joint's torque stated as the motor's (the gear ratio)")},
      {"cause.motor_torque_constant_as_joint",
       text("a torque constant of the motor's side stated for the joint's")},
      {"cause.motor_torque_as_joint",
       text("the motor's torque stated as the joint's (one over the gear ratio)")},
      {"cause.torque_taken_for_current",
       text("a torque in N·m taken for a current (the torque constant)")},
      {"cause.amplitude_for_effective",
       text("amplitude and RMS value of the current mixed up (√2)")},
      {"cause.dq_convention",
       text("torque constants of two conventions of the dq currents mixed up (3/2)")},
      {"cause.line_for_phase", text("line and phase values of the motor mixed up (√3)")},
      {"cause.two_phases_for_one",
       text("the torque constant of two phases in series taken for that of one, or a constant "
            "applied twice (2)")},

      // Noise of the logged speed.
      {"speed_noise.scatters",
       text("the logged speed scatters by {scatter_percent:.3g} % of the speed")},
      {"speed_noise.hardly_more_than_steps",
       text("the logged speed scatters by {scatter_percent:.3g} % of the speed; at this speed that "
            "is little more than the angle's quantisation")},
      {"speed_noise.none_for_results",
       text("none for the results: speeds are derived from the angle")},
      {"speed_noise.differentiate_angle",
       text("do not use this column at low speed; differentiate the angle")},

      // Both directions, over the same angles.
      {"directions.both_recorded", text("both directions were recorded")},
      {"directions.sweep_only_rises", text("the joint angle only ever rises in the rough sweep: "
                                           "Coulomb friction and offset cannot be told apart")},
      {"directions.sweep_only_falls", text("the joint angle only ever falls in the rough sweep: "
                                           "Coulomb friction and offset cannot be told apart")},
      {"directions.runs_only_rise",
       text("the joint angle only ever rises in the runs at constant speed: Coulomb friction and "
            "offset cannot be told apart")},
      {"directions.runs_only_fall",
       text("the joint angle only ever falls in the runs at constant speed: Coulomb friction and "
            "offset cannot be told apart")},
      {"directions.constant_in_one_direction",
       text("in a single direction both are a constant torque, and friction that varies with the "
            "angle would be taken for gravity")},
      {"directions.record_the_way_back",
       text("record the return motion too, over the same angles at the same speed")},
      {"directions.share_angles",
       text("the directions share {share_percent:.0f} % of their angles")},
      {"directions.share_few_angles",
       text("the directions share only {share_percent:.1f} % of their angles")},
      {"directions.share_no_angle", text("the directions share no angle")},
      {"directions.share_no_angle_at_same_speed",
       text("the directions share no angle at the same speed")},
      {"directions.no_difference_at_equal_angle",
       text("half the difference between the directions at equal angle, which gravity does not "
            "affect, is not available: friction relies on the gravity model, and nothing in these "
            "data checks it")},
      {"directions.record_same_angles", text("record both directions over the same angles")},

      // The speeds of the runs.
      {"run_speeds.plateaus", by_count("speeds", "{plateaus} plateaus at {speeds} different speed",
                                       "{plateaus} plateaus at {speeds} different speeds")},
      {"run_speeds.too_few", text("so few do not show how friction changes with speed: neither the "
                                  "viscous coefficient nor the Stribeck velocity can be found")},
      {"run_speeds.record_ten_to_twenty",
       text("run the joint at ten to twenty speeds, from the slowest smooth one to the fastest "
            "allowed, in both directions")},

      // Stick-slip.
      {"stick_slip.moves_on", text("the joint moves without stopping")},
      {"stick_slip.stops", by_count("recordings",
                                    "the joint stops and jumps ahead {stops:.0f} times in one "
                                    "stroke; {recordings} recording affected",
                                    "the joint stops and jumps ahead {stops:.0f} times in one "
                                    "stroke; {recordings} recordings affected")},
      {"stick_slip.torque_of_no_one_speed",
       text("the torque alternates between sticking and sliding, at no single speed: its mean is "
            "not the friction at this speed")},
      {"stick_slip.move_faster",
       text("move faster than the speed at which the joint sticks, or make the speed control "
            "stiffer")},

      // The signal in the torque.
      {"torque_alive.in_all", text("the torque changes in every recording")},
      {"torque_alive.constant", text("the torque has one constant value in {constant} of "
                                     "{recordings} recordings: a dead sensor?")},
      {"torque_alive.shows_nothing",
       text("a torque that does not change shows neither gravity nor friction")},
      {"torque_alive.see_column",
       text("check that the torque column is live before the next measurement")},
      {"measure.held_torque", text("samples that repeat an old torque, in the worst recording")},
      {"not_applicable.torque_in_steps",
       text("the torque comes in steps so coarse, or so rarely, that equal values prove nothing")},
      {"torque_held.nowhere", text("the torque keeps changing with its noise throughout")},
      {"torque_held.percent",
       text("{percent:.2g} % of the samples repeat the previous torque, 25 or more in a row, while "
            "the joint moves")},
      {"torque_held.is_of_before",
       text("what the torque was there is not known, and the fits take the old value for it")},
      {"torque_held.see_log",
       text("look for lost messages in the drive's log, and leave these stretches out (nan)")},
      {"torque_noise.white", text("{white_percent:.2g} % of the torque's variance is white noise")},
      {"torque_noise.signal_drowns", text("it drowns what is left of gravity and friction; the "
                                          "intervals are correspondingly wide")},
      {"torque_noise.record_longer", text("record for longer, or filter the current in the drive; "
                                          "check that the column really is the torque")},

      // Clipping.
      {"torque_saturation.none", text("the torque does not stick at its extremes")},
      {"torque_saturation.clipped",
       by_count("recordings",
                "{flat_percent:.1f} % of the samples are stuck at {extreme_Nm:.4g} N·m at the "
                "motor; {recordings} recording clipped",
                "{flat_percent:.1f} % of the samples are stuck at {extreme_Nm:.4g} N·m at the "
                "motor; {recordings} recordings clipped")},
      {"torque_saturation.same_at_all_speeds",
       text("runs at {speeds} speeds have the same largest torque, {torque_Nm:.4g} N·m at the "
            "motor, where those of the other direction differ: the drive's limit sets it, not the "
            "joint")},
      {"torque_saturation.peaks_cut_off",
       text("the largest torques are cut off: gravity and friction come out too small, and the "
            "angle of the peak is set by the clipping")},
      {"torque_saturation.widen_range",
       text("widen the measuring range, raise the drive's limit, or reduce the load on the joint")},

      // The step of the torque against friction.
      {"torque_step.continuous", text("the torque looks continuous")},
      {"torque_step.against_friction",
       text("steps of {step_Nm:.3g} N·m against {friction_Nm:.3g} N·m, at the motor")},
      {"torque_step.friction_in_few_steps",
       text("friction spans only a few steps, and where noise does not spread the samples over "
            "several of them averaging does not help")},
      {"torque_step.record_finer",
       text("record the current with more digits, or in a smaller measuring range")},

      // Power: friction takes it up, and a joint has only so much of it.
      {"dissipation.rising_takes_more",
       text("rising takes more torque than falling at the same angle")},
      {"dissipation.friction_negative",
       text("friction is negative, {friction_Nm:.3g} N·m: the joint would gain power from it; the "
            "sign of the torque or of the angle is wrong")},
      {"dissipation.signs_wrong", text("the gravity peak is mistaken for the trough, half a turn "
                                       "away, and every friction torque has the wrong sign")},
      {"dissipation.state_sign",
       text("state effort.sign = -1, or give the angle the sign in which the torque drives it")},
      {"power.at_most", text("at most {power_kW:.3g} kW")},
      {"power.beyond_any_joint",
       text("torque times speed reaches {power_kW:.3g} kW, which no robot joint has: a torque in "
            "mN·m taken for N·m, a joint torque taken for the motor's, or a wrong gear ratio or "
            "torque constant?")},
      {"power.torques_wrong", text("every torque and mass is wrong by the same factor")},
      {"power.state_unit_and_side", text("state the true unit and side of the effort")},

      // What changes while it is measured.
      {"friction_drift.over_strokes",
       text("{first_Nm:.3g} to {last_Nm:.3g} N·m at the motor in {duration_s:.3g} s ({pairs} pairs "
            "of strokes)")},
      {"friction_drift.no_one_temperature",
       text("friction does not belong to a single temperature: what is measured first and what is "
            "measured last are not on one curve")},
      {"friction_drift.warm_up", text("warm the joint up until friction is steady, log the "
                                      "temperature, and run the speeds in mixed order")},
      {"temperature.range", text("{low_C:.3g} to {high_C:.3g} °C")},
      {"temperature.no_one_curve",
       text("friction changes by several per cent per kelvin, so recordings at different "
            "temperatures are not on one curve")},
      {"temperature.record_at_one",
       text("warm the joint up first, and record all roles at one temperature")},

      // Whether the encoder resolves pre-sliding.
      {"encoder_step.continuous", text("the angle looks continuous")},
      {"encoder_step.steps",
       by_count("steps", "{steps:.3g} step of {step_rad:.3g} rad in {travel_rad:.2g} rad",
                "{steps:.3g} steps of {step_rad:.3g} rad in {travel_rad:.2g} rad")},
      {"encoder_step.steps_of_print",
       by_count("steps",
                "{steps:.3g} step of {step_rad:.3g} rad in {travel_rad:.2g} rad, which is the last "
                "decimal of the log; the encoder's step may be larger",
                "{steps:.3g} steps of {step_rad:.3g} rad in {travel_rad:.2g} rad, which is the "
                "last decimal of the log; the encoder's step may be larger")},
      {"encoder_step.presliding_not_resolved",
       text("pre-sliding is not resolved: bristle stiffness, bristle damping and break-away torque "
            "cannot be identified from these logs")},
      {"encoder_step.record_finer",
       text("record the motor's encoder instead of the joint's angle, or use an encoder fine "
            "enough for fifty steps across the loop")},

      // The oscillation: its cycles, and whether friction turns over in it.
      {"oscillation_cycles.recorded", text("{cycles:.1f} cycles")},
      {"oscillation_cycles.too_few",
       text("the start-up stroke is not a steady loop, and too few cycles follow it: it biases the "
            "mid-line, and nothing shows how the cycles scatter")},
      {"oscillation_cycles.record_ten", text("record ten cycles or more")},
      {"oscillation_slides.stiffness_left",
       text("{stiffness_percent:.2g} % of the stiffness remains at the end of a stroke")},
      {"oscillation_slides.stroke_too_small",
       text("the stroke is too small: friction does not level off, so the break-away torque is not "
            "reached, only known to be larger")},

      // The oscillation against the gravity peak.
      {"oscillation_at_peak.centre",
       text("centre at {centre_deg:.3f}°, peak at {peak_deg:.3f}°: gravity is "
            "{smaller_percent:.3g} % smaller there")},
      {"oscillation_at_peak.error_of_peak_costs",
       text(
           "the cosine corrects for it, but the angle of the peak is known to ± "
           "{angle_deg:.2g}° only, which costs {cost_percent:.2g} % of gravity torque and mass; at "
           "the peak it costs nothing")},
      {"oscillation_at_peak.repeat_about", text("repeat the oscillation about {peak_deg:.2f}°")},

      // Gravity against the measured torque.
      {"gravity_within_torque.fitted",
       text("{fitted_Nm:.4g} N·m fitted, {measured_Nm:.4g} N·m measured, at the motor")},
      {"gravity_within_torque.offset_would_balance",
       text("a large offset would have to balance it")},
      {"gravity_within_torque.does_not_follow_cosine",
       text("the torque does not follow the cosine of this angle: an angle in radians taken for "
            "degrees, too short a range, or a spring that supports the arm")},
      {"gravity_within_torque.sweep_farther",
       text("state the true unit of the angle, and sweep over at least 60°")},

      // The static torque against the weight.
      {"static_torque.found_by_payload",
       text("{found_Nm:.4g} N·m found, {payload_Nm:.4g} N·m by the payload alone")},
      {"static_torque.found_and_stated",
       text("{found_Nm:.4g} N·m found, largest at {found_deg:.4g}°; {stated_Nm:.4g} N·m stated, at "
            "{stated_deg:.4g}°")},
      {"static_torque.angles_apart", text("the angles of the peak are {apart_deg:.3g}° apart")},
      {"static_torque.peak_taken_for_trough",
       text("the gravity peak is mistaken for the trough, half a turn away")},
      {"static_torque.torques_wrong",
       text("if what is stated is right, every torque and mass is wrong by the same factor; if it "
            "is known less well, state its half width: percent under [known_gravity]")},
      {"static_torque.angle_counts_otherwise",
       text("one of the two angles has another zero or sign")},
      {"static_torque.hold_known_mass",
       text("hold the joint still with a known mass at a known distance, and compare the effort "
            "with m g r")},
      {"static_torque.see_zero_of_angle",
       text("check which zero and sign the log and the stated gravity use for the angle")},

      // Torque ripple.
      {"ripple_lines.none", text("no ripple stands out from the noise of the sweep")},
      {"ripple_lines.found", text("ripple of {lines:, } per motor turn")},
      {"ripple_lines.line", text("{amplitude_Nm:.3g} N·m at {periods:.2f} periods")},
      {"torque_ripple.not_averaged_out",
       by_count("oscillations", "{oscillations} oscillation at one position cannot average it out",
                "{oscillations} oscillations cannot average it out")},
      {"torque_ripple.taken_for_gravity",
       text("over a micro-oscillation the ripple is a constant torque, up to {ripple_Nm:.3g} N·m, "
            "that is taken for gravity")},
      {"torque_ripple.oscillate_at_eight_positions",
       text("repeat the oscillation at eight positions spread evenly over one turn of the motor")},
      {"ripple_period.is_gear_ratio_right",
       text("the motor's own ripple repeats a whole number of times per turn: is the gear ratio "
            "really {gear_ratio:.6g}?")},
      {"ripple_period.other_side_wrong",
       text("a wrong gear ratio leaves angles and motor torques as they are, and scales every "
            "torque, mass and speed on the other side")},
      {"ripple_period.count_turns",
       text("turn the joint by a known angle and count the motor's turns")}};
  return all;
}

}  // namespace tribolog::wording
