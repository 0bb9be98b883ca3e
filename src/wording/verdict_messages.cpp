// What the verdict, the known-truth check and the intervals state.

#include "wording/messages.h"

namespace tribolog::wording {

const Messages& verdict_messages() {
  static const Messages all{
      // The quantities.
      {"quantity.cog_angle", text("Angle of the centre of gravity")},
      {"quantity.gravity_torque", text("Gravity torque")},
      {"quantity.surrogate_mass", text("Surrogate mass")},
      {"quantity.break_away_torque", text("Break-away torque")},
      {"quantity.bristle_stiffness", text("Bristle stiffness")},
      {"quantity.bristle_damping", text("Bristle damping")},
      {"quantity.inertia", text("Inertia at the motor")},
      {"quantity.coulomb_torque", text("Coulomb torque")},
      {"quantity.stribeck_speed", text("Stribeck velocity")},
      {"quantity.viscous_coefficient", text("Viscous coefficient")},
      {"quantity.viscous_curve", text("Viscous curve")},
      {"quantity_at_joint.cog_angle", text("Angle of the centre of gravity at the joint")},
      {"quantity_at_joint.gravity_torque", text("Gravity torque at the joint")},
      {"quantity_at_joint.surrogate_mass", text("Surrogate mass at the joint")},
      {"quantity_at_joint.break_away_torque", text("Break-away torque at the joint")},
      {"quantity_at_joint.bristle_stiffness", text("Bristle stiffness at the joint")},
      {"quantity_at_joint.bristle_damping", text("Bristle damping at the joint")},
      {"quantity_at_joint.inertia", text("Inertia at the joint")},
      {"quantity_at_joint.coulomb_torque", text("Coulomb torque at the joint")},
      {"quantity_at_joint.stribeck_speed", text("Stribeck velocity at the joint")},
      {"quantity_at_joint.viscous_coefficient", text("Viscous coefficient at the joint")},

      // The verdict's rules, each by what it measures.
      {"rule.runs_against_ramps", text("Friction at rest by the runs' law, against the ramps")},
      {"rule.runs_against_loops",
       text("Friction at rest by the runs' law, less than that of the loops")},
      {"rule.break_away_over_sliding", text("Break-away torque over least sliding friction")},
      {"rule.ramps_that_slide", text("Friction at the speed of sliding ramps, below that at rest")},
      {"rule.inertia_at_break_away", text("Ramps read without the torque of inertia")},
      {"rule.false_stamps", text("Scatter of the time stamps, relative to the sampling interval")},
      {"rule.torque_outliers", text("Torque outliers in the worst recording")},
      {"rule.many_torque_outliers", text("The same, where they are too many to be told apart")},
      {"rule.amplitude_over_deflection",
       text("Amplitude of the smallest loop, over the deflection at which the bristle slides")},
      {"rule.fall_of_damping", text("Stiffness if the bristle damping fell with speed")},
      {"rule.slope_out_of_proportion", text("Torque not in proportion, effect on friction")},
      {"rule.loop_misfit", text("Misfit of the LuGre model to a loop")},
      {"rule.loops_within_dip",
       text("Five times the dip's speed over the fastest of the loops, where friction comes from "
            "them")},
      {"cause.loops_within_dip",
       text("the loops reach {fastest_rad_s:.2g} rad/s (motor side), and hardly leave the Stribeck "
            "dip: friction beyond it is not seen in them")},
      {"rule.loop_misfit_of_friction",
       text("The same where friction over the speed comes from the loops")},
      {"rule.loop_misfit_at_break_away",
       text("The same, where the break-away torque is read from the loops")},
      {"rule.loop_unlike_model", text("Misfit at which nothing of the LuGre model is left")},

      {"rule.friction_over_gravity", text("Friction as a share of the gravity torque")},
      {"rule.gravity_in_time",
       text("Slow change of the torque with time, relative to the gravity torque")},
      {"rule.gravity_in_time_on_friction",
       text("Torque that changes with time, relative to friction")},
      {"rule.others_move", text("Motion of another joint, without a description of the arm")},
      {"rule.others_inertia", text("Motion of another joint, of which gravity alone is taken off")},
      {"rule.others_taken_off",
       text("Gravity of the other joints' motion, taken off, relative to the gravity torque")},
      {"rule.description_differs", text("Gravity by the description against the recordings'")},
      {"cause.description_differs",
       text("by {file} gravity is {own_Nm:.3g} N·m at the joint, largest at {own_deg:.1f}°; the "
            "recordings show {found_Nm:.3g} N·m, largest at {found_deg:.1f}°: do both count the "
            "angles from the same zero and with the same sign, and is the payload described?")},
      {"cause.hidden_by_description",
       text("with the masses of the arm off by what is stated of them, the recordings no longer "
            "show this: its interval does not include them")},
      {"cause.hidden_by_hoses",
       text("with a torque of hoses as large as is stated, the recordings no longer show this: its "
            "interval does not include hoses")},
      {"cause.others_move",
       text("joint {joint} moves by {travel_deg:.3g}° in these recordings: what that does to this "
            "joint's gravity cannot be told apart from its own without a description of the arm")},
      {"cause.others_inertia", text("joint {joint} moves by {travel_deg:.3g}° in these recordings: "
                                    "the description takes off "
                                    "what that does to gravity, not what its inertia does")},
      {"cause.others_taken_off",
       text("the other joints' motion changes gravity by up to {largest_Nm:.3g} N·m at the joint; "
            "it is taken off by the masses of {file}, which are taken to be right within "
            "{percent:g} %")},
      {"rule.stribeck_exponent", text("Stribeck exponent other than 2, effect on friction")},
      {"rule.stribeck_exponent_in_loops",
       text("Stribeck dip of the curve unlike that of the loops' model, effect on friction")},
      {"rule.stribeck_exponent_at_break_away",
       text("Stribeck dip of the curve unlike that of the loops' model, without ramps, effect on "
            "friction")},
      {"cause.stribeck_exponent",
       text(
           "friction falls with the speed as exp(−(ω/ωs)^{exponent:.2g}), and the paper's law has "
           "the exponent 2; Coulomb torque, Stribeck velocity and viscous coefficient are those of "
           "the law that the speeds show")},
      {"cause.stribeck_exponent_in_loops",
       text(
           "friction falls with the speed as exp(−(ω/ωs)^{exponent:.2g}), and the loops' model has "
           "the exponent 2: over the loops' speeds the two differ by {percent:.2g} % of friction")},
      {"rule.scale_of_loops",
       text("Gravity of the loops against the sweep's, the part that is certain")},
      {"rule.course_of_angle",
       text("Course of the torque over the joint's angle, as a share of friction")},
      {"rule.offset_in_curves", text("Offset of the torque, as a share of friction")},
      {"rule.loops_against_ramps", text("Friction at rest, loops against ramps")},
      {"rule.vibration_in_loops", text("Vibration that the loops' cycles do not average out")},
      {"rule.runs_against_ramps_at_rest", text("Friction at rest, runs against ramps")},
      {"rule.motion_harmonics", text("Largest harmonic of an oscillation's motion")},
      {"rule.ripple", text("Torque ripple, relative to the gravity torque")},
      {"rule.vibration", text("Torque vibration, relative to the gravity torque")},
      {"rule.coloured_noise", text("Coloured noise, relative to the white noise")},
      {"rule.coloured_noise_in_friction", text("Coloured noise, relative to the friction")},
      {"rule.coloured_noise_large_in_friction",
       text("Coloured noise, large relative to the friction")},

      // What was found to be wrong with the joint or the log.
      {"cause.no_gravity",
       text("the gravity torque of {gravity_Nm:.2g} N·m is too small beside friction of "
            "{friction_Nm:.2g} N·m to be told from friction that changes with the angle: angle "
            "and mass cannot be known from this joint; friction can")},
      {"cause.no_gravity_or_removed",
       text("the gravity torque of {gravity_Nm:.2g} N·m is too small beside friction of "
            "{friction_Nm:.2g} N·m to be told from friction that changes with the angle: angle "
            "and mass cannot be known from this joint; friction can. Where the joint carries a "
            "load, the controller may have taken gravity off the effort, as UR's newer drivers do "
            "(gravity_removed = true under [effort])")},
      {"cause.gravity_removed",
       text("gravity is not in the effort: the controller has taken it off, as the manifest "
            "states; friction alone is asked for")},
      {"cause.no_gravity_stated",
       text("the manifest states that this joint has no gravity: friction alone is asked for")},
      {"cause.gravity_taken_off",
       text("the friction points are friction alone: gravity was taken off before, or there is "
            "none")},
      {"cause.other_joint",
       text("the torque swings by {amplitude_Nm:.2g} N·m ({percent:.1f} % of gravity) with a "
            "period of {period_s:.1f} s, whatever the angle: gravity changes in time, as when "
            "another joint moves")},
      {"cause.loops_against_ramps",
       text("friction at rest is {loops_Nm:.3g} N·m by the loops and {ramps_Nm:.3g} N·m by the "
            "ramps: "
            "their torques are of another scale, or the contact is another one than the loops' "
            "model has")},
      {"cause.vibration_in_loops",
       text("the torque vibrates by {amplitude_Nm:.3g} N·m at {frequency_Hz:.2f} Hz, near a "
            "multiple "
            "of the oscillation's frequency: its cycles do not average that out, and it bends the "
            "loops")},
      {"cause.scale_of_loops",
       text(
           "the loops put gravity {percent:+.2g} % beside the sweep: their torque has an offset or "
           "another scale, and of another scale the stiffness would be wrong by as much")},
      {"cause.course_of_angle",
       text("beside gravity the torque takes a course over the joint's angle that no term "
            "describes, "
            "of ±{amplitude_Nm:.3g} N·m or {percent:.2g} % of the friction, slower than the motor "
            "turns: as of a linkage, a hose that catches or a worn place")},
      {"cause.motion",
       text("the oscillation is not a sine: its motion has {second_percent:.1f} % of a second and "
            "{third_percent:.1f} % of a third harmonic; mid-lines are taken over the angle, and "
            "single points and pairs of the loop do not count")},
      {"cause.ripple",
       text("the torque has ripple of {ripple_Nm:.2g} N·m (standard deviation) that repeats with "
            "the motor's angle, in {lines} lines")},
      {"cause.ripple_without_lines",
       text("the torque has ripple of {ripple_Nm:.2g} N·m (standard deviation) that repeats with "
            "the angle, without a period of its own")},
      {"cause.vibration",
       text("the torque vibrates by {amplitude_Nm:.2g} N·m at {frequency_Hz:.2f} Hz, whatever the "
            "angle")},
      {"cause.coloured_noise", text("the torque has coloured noise of {coloured_Nm:.2g} N·m beside "
                                    "white noise of {white_Nm:.2g} N·m; the intervals include it")},
      {"cause.damping_falls",
       text("the bristle damping falls with speed, to a half at {half_at_rad_s:.2g} rad/s (motor "
            "side): with such a damping the stiffness would be {percent:+.2g} % different")},
      {"cause.runs_against_loops",
       text(
           "friction at rest is {runs_Nm:.3g} N·m by the runs and {loops_Nm:.3g} N·m by the loops: "
           "the logged torque may lack what the controller adds against friction, or friction "
           "changed between them")},
      {"cause.friction_taken_off",
       text("the break-away torque is {ratio:.2g} times the least friction of the runs, more than "
            "a contact sticks: the logged torque may lack what the controller adds against "
            "friction")},
      {"cause.loops_too_wide",
       text("the smallest loop is {times:.0f} times as wide as the bristle bends: the motion "
            "during pre-sliding is inferred from the rest of the loop")},
      {"cause.other_contact",
       text("{recording}: the LuGre model leaves {misfit_Nm:.2g} N·m, {percent:.1f} % of the "
            "loop's height, that noise does not explain: the contact follows another law, and the "
            "numbers are those of the closest LuGre model, not the joint's")},
      {"cause.other_contact_elasto_plastic",
       text("{recording}: the LuGre model leaves {misfit_Nm:.2g} N·m, {percent:.1f} % of the "
            "loop's height, that noise does not explain: the contact is elasto-plastic, and by "
            "that law its stiffness is {stiffness_Nm_rad:.3g} N·m/rad and it slides at "
            "{static_Nm:.3g} N·m")},
      {"cause.other_contact_maxwell_slip",
       text("{recording}: the LuGre model leaves {misfit_Nm:.2g} N·m, {percent:.1f} % of the "
            "loop's height, that noise does not explain: the contact remembers earlier reversals, "
            "as Maxwell-slip elements do, and by these its stiffness is {stiffness_Nm_rad:.3g} "
            "N·m/rad and it slides at {static_Nm:.3g} N·m")},

      {"cause.false_stamps",
       text("the time stamps scatter by {percent:.2g} % of the sampling interval of "
            "{interval_ms:.4g} ms ({recording}), but the angle was sampled evenly: they are those "
            "of writing, and the even clock that runs through them is used")},
      {"cause.outliers",
       text("{samples} samples of the torque lie far off their neighbours, up to {largest_Nm:.2g} "
            "N·m, and were replaced by the line between these ({recording}: {percent:.2g} % of its "
            "samples)")},
      {"cause.runs_against_ramps",
       text(
           "friction at rest is {runs_Nm:.3g} N·m by the runs and {ramps_Nm:.3g} N·m by the ramps: "
           "the logged torque may lack what the controller adds against friction, or friction "
           "changed between them")},
      {"cause.ramps_slide",
       text("in the ramps the joint slid at an even speed, {speed_rad_s:.2g} rad/s at the motor: "
            "what holds it there is friction at that speed, not at rest")},
      {"cause.ramps_without_inertia",
       text("ramps are read where the joint accelerates already, and nothing shows its inertia: "
            "that torque counts as friction")},
      {"verdict.lag_unknown",
       text("the recordings do not show how late the torque is logged against the angle, and a lag "
            "looks like bristle damping")},

      // The numbers that a simulation reads back.
      {"reading.A", text("point A")},
      {"reading.B", text("point B")},
      {"reading.C", text("point C")},
      {"reading.D", text("point D")},
      {"reading.E", text("point E")},
      {"reading.F", text("point F")},
      {"reading.A_steady", text("A of the steady loop")},
      {"reading.B_steady", text("B of the steady loop")},
      {"reading.AB", text("mean of A and B")},
      {"reading.CD", text("mean of C and D")},
      {"reading.EF", text("mean of E and F")},
      {"reading.midline", text("mid-line")},
      {"reading.model", text("model of sweeps and runs")},
      {"reading.fit", text("LuGre fit")},
      {"reading.q_peak", text("gravity peak q_peak")},
      {"reading.bristle_stiffness", text("bristle stiffness σ₀")},
      {"reading.static_torque", text("break-away torque T_s")},
      {"reading.sweep_friction", text("sweep friction")},
      {"reading.coulomb", text("Coulomb torque T_c")},
      {"reading.viscous", text("viscous coefficient c")},
      {"reading.asperity_torque", text("asperity torque T_a")},
      {"reading.stribeck_speed", text("Stribeck velocity ω_s")},
      {"reading.stribeck_power", text("Stribeck power δ_a")},
      {"reading.viscous_coefficient", text("viscous coefficient c_v")},
      {"reading.viscous_power", text("viscous power δ_v")},

      // The sentence at the top of the report.
      {"verdict.usable_without_gravity",
       text("The joint's friction is known; it has no gravity torque to speak of.")},
      {"verdict.doubtful_without_gravity",
       text("This joint has no gravity torque to speak of, and is judged by its friction, which is "
            "known in part.")},
      {"verdict.usable_friction_points",
       text("The joint's friction curve is known; friction points show nothing else.")},
      {"verdict.no_torque",
       text("No torque was recorded: the motion alone shows neither gravity nor friction.")},
      {"verdict.torque_not_read",
       text("No torque was read, though {columns} may hold one; tribolog init LOG --column "
            "effort=NAME --effort-unit UNIT states it. The motion alone shows neither gravity nor "
            "friction.")},
      {"verdict.data_cannot_carry", text("The data do not support an identification: {found}.")},
      {"verdict.neither_angle_nor_mass",
       text("Neither the centre of gravity nor the surrogate mass can be found in these "
            "recordings.")},
      {"verdict.no_mass", text("The surrogate mass cannot be found in these recordings.")},
      {"verdict.no_angle",
       text("The angle of the centre of gravity cannot be found in these recordings.")},
      {"verdict.usable",
       text(
           "All numbers that the verdict rests on are usable, and the independent estimates of the "
           "mass agree.")},
      {"verdict.checks_fail", text("Checks on the data fail.")},
      {"verdict.estimates_disagree", text("Independent estimates disagree.")},
      {"verdict.limit_not_kept", text("A limit in the manifest is not met.")},
      {"verdict.own_answer_not_found",
       text("In a simulation of what was identified the method does not recover its own result.")},
      {"verdict.not_all_usable", text("Usable but for: {quantities:, }.")},
      {"verdict.nothing_usable",
       text("No number can be used as it stands: each has its reason below.")},

      // Why a quantity is not usable.
      {"verdict.check", text("check “{check}” not passed: {found}")},
      {"verdict.check_fails", text("{found}: {consequence}")},
      {"verdict.ramps_bend_otherwise",
       text("the torque at which the ramps are seen to slide is {percent:.0f} % away from what "
            "their resting part tends to: the contact is another than the one assumed")},
      {"verdict.friction_of_sweep",
       text(
           "it is the friction at the sweep's speeds, and no run shows whether they lie within the "
           "Stribeck dip")},
      {"verdict.size_not_known", text("not even its order of magnitude is known")},
      {"verdict.of_law_without_coulomb",
       text("the same law has a Coulomb torque of {coulomb_Nm:.2g} N·m, which no joint has")},
      {"verdict.interval_reaches_below_zero",
       text("the data do not show it: its 95 % interval reaches below zero")},
      {"verdict.interval_reaches_zero",
       text("the data do not show it: its 95 % interval reaches zero")},
      {"verdict.beyond_the_runs",
       text(
           "the runs do not hold the law: its Coulomb torque lies far beyond every torque that was "
           "measured")},
      {"verdict.known_to_share", text("known only to ± {percent:.0f} %")},
      {"verdict.known_to_angle", text("known only to ± {degrees:.0f}°")},
      {"verdict.nothing_independent", text("nothing independent checks it: {why}")},
      {"verdict.no_loop_model", text("no friction model was fitted to the loop")},
      {"verdict.ramps_of_one_direction",
       text(
           "the joint broke away in one direction alone: an offset of the torque, or friction that "
           "differs with the direction, would not be seen")},
      {"verdict.ramps_do_not_show", text("the ramps do not show it: {why}")},
      {"verdict.never_broke_away",
       text("the loop's level lies below the Coulomb torque: the joint never broke away in it, and "
            "the break-away torque is only known to be larger")},
      {"verdict.nothing_checks_curve", text("nothing checks the curve: {why}")},
      {"verdict.no_stribeck_model",
       text("no model with a Stribeck velocity was fitted to the curve")},
      {"verdict.runs_share_no_angle",
       text("{angles}, so that gravity and friction cannot be told apart by comparing them; record "
            "every speed in both directions over the same angles")},

      // The uncertainty budget.
      {"influence.recordings", text("the recordings")},
      {"influence.disagreement", text("methods that disagree")},
      {"influence.torque_constant", text("torque constant")},
      {"influence.gear_ratio", text("gear ratio")},
      {"influence.surrogate_distance", text("distance of the surrogate mass")},
      {"influence.gravity", text("acceleration of gravity")},
      {"influence.angle_zero", text("zero of the angle")},
      {"influence.hoses", text("torque of hoses and cables")},
      {"influence.description", text("masses of the arm")},
      {"budget.torque_constant_not_stated",
       text("the uncertainty of the torque constant is not stated, and is in no interval: every "
            "torque is wrong by as many percent as the torque constant is; state "
            "torque_constant_percent in [uncertainty]")},
      {"budget.torque_scale_not_stated",
       text("the uncertainty of the torque's scale is not stated, and is in no interval: every "
            "torque is wrong by as many percent as the calibration of the torque sensor or the "
            "drive's torque constant is; state torque_constant_percent in [uncertainty]")},

      // Limits of the manifest.
      {"limit.min", text("the limit of at least {limit:.6g} {unit}")},
      {"limit.max", text("the limit of at most {limit:.6g} {unit}")},
      {"limit.half_width", text("the limit of an interval of at most ± {limit:.6g} {unit}")},
      {"limit.half_width_percent",
       text("the limit of an interval of at most ± {limit:.6g} {unit}")},
      {"limit.no_estimate", text("{quantity}: there is no estimate to compare with {limit}")},
      {"limit.kept",
       text("{quantity} {value:.5g} {unit} (95 %: {low:.5g} to {high:.5g}) meets {limit}")},
      {"limit.broken",
       text("{quantity} {value:.5g} {unit} (95 %: {low:.5g} to {high:.5g}) does not meet {limit}")},
      {"limit.not_shown",
       text("{quantity} {value:.5g} {unit} (95 %: {low:.5g} to {high:.5g}): the interval crosses "
            "{limit}: not shown")},

      // What to record next.
      {"record.other_frequency",
       text("the oscillation at a frequency of which no vibration is a multiple")},
      {"record.one_homing", text("all recordings after one homing, with the base at rest")},
      {"record.sweep",
       text("slow sweep over the joint's range, across the gravity peak, in both directions")},
      {"record.oscillation",
       text("ten cycles of a micro-oscillation, about the gravity peak if there is one, at eight "
            "positions spread over one turn of the motor, resolved into at least fifty encoder "
            "steps")},
      {"record.runs",
       text("ten to twenty constant speeds, from the slowest smooth one to the fastest allowed, in "
            "both directions over the same angles")},
      {"record.slower_speeds",
       text("runs at slower speeds, down to the slowest smooth one: they show what friction falls "
            "to")},
      {"record.faster_speeds",
       text(
           "runs at more of the fast speeds, up to the fastest allowed: the viscous coefficient is "
           "the slope there")},
      {"record.sweep_and_oscillation",
       text("slow sweep over the joint's range in both directions, and a micro-oscillation about "
            "the gravity peak")},
      {"record.slower_starts",
       text("sweeps or runs that speed up and slow down over fifty samples or more")},
      {"record.torque_at_loads",
       text("calibrate the torque at several known loads, or log a sensor's at the joint")},
      {"record.torque_measured",
       text(
           "log the torque that the motor gives, with all that the controller adds; runs and ramps "
           "one after the other")},
      {"record.no_lag", text("log torque and angle in the same cycle of the drive, unfiltered")},
      {"record.better_motion", text("a motion that shows it better, or less noise: the known-truth "
                                    "check shows how far off the recovered value is")},
      {"record.with_load", text("a load on the arm, or another posture, gives the joint gravity")},
      {"record.others_at_rest_or_described",
       text("the same again with all other joints at rest, or a description of the arm with its "
            "masses (URDF)")},
      {"record.other_joints_at_rest", text("the same again with all other joints at rest")},
      {"record.without_hoses",
       text("the same again with hoses and cables taken off, or led so that they pull less")},
      {"record.eight_positions",
       text("the micro-oscillation at eight positions spread over one turn of the motor")},
      {"record.ramps",
       text("torque ramps that continue until the joint slides, several in each direction")},
      {"record.larger_amplitude",
       text("oscillate with a larger amplitude, until the loop's branches run flat")},
      {"record.compare_reversals", text("compare with the stiffness after reversals, which needs "
                                        "no model (table of the loops)")},
      {"record.speeds_about_the_dip",
       text("more speeds below and around the dip of the friction curve")},
      {"record.second_measurement",
       text("nothing to record: the joint, or the limit, is not as it should be; a second "
            "measurement would confirm it")},
      {"record.more_of_the_same",
       text("more data of the same kind, to make the interval narrower")},

      // The known-truth check.
      {"truth.not_found",
       text("the method cannot recover its own result on these motions at this noise: the "
            "{reading} was not found in any of {runs} simulations of what was identified")},
      {"truth.does_not_come_back",
       text(
           "the method cannot recover its own result on these motions at this noise: the {reading} "
           "was simulated as {put_in:.5g} {unit} and recovered as {came_back:.5g} {unit}, and the "
           "stated interval contains the true value in {inside} of {runs} simulations")},
      {"truth.ramp_is_its_answer", text("the motion of a break-away ramp is itself the result; no "
                                        "recorded motion can stand in for it")},
      {"truth.sweep_without_gravity", text("the sweep gave no gravity")},
      {"truth.no_curve", text("no friction curve was identified")},
      {"truth.no_loop_model", text("no LuGre model was fitted to the loop")},
      {"truth.no_whole_cycle", text("the angle does not complete one whole cycle; and {why}")},
      {"truth.loop_parameters_not_shown",
       text("the loops do not show stiffness and break-away torque")},
      {"truth.nothing_to_simulate",
       text("nothing can be simulated: no gravity torque was identified")},
      {"truth.too_few_samples", text("too few samples")},
      {"truth.not_simulated", text("{recording}: {why}")},
      {"truth.first_samples_simulated",
       text("{recording}: {samples} of its {all} samples are simulated, starting with the first")},
      {"truth.spread_samples_simulated",
       text("{recording}: {samples} of its {all} samples are simulated, evenly spread")},

      // A log without torque.
      {"no_torque.log_a_column",
       text("no torque was recorded; log the motor's torque, or its actual current together with "
            "the torque constant, in a column beside the angle")},
      {"no_torque.no_loop", text("no torque was recorded; the loop is torque against angle")},
      {"no_torque.no_mass", text("no torque was recorded; a mass is read off a torque")},
      {"no_torque.no_curve", text("no torque was recorded; the curve is torque against speed")},
      {"no_torque.no_curve_to_check", text("no torque was recorded; there is no curve to check")},
      {"no_torque.no_mass_to_select", text("no torque was recorded; there is no mass to select")},
      {"no_torque.no_curve_to_fit", text("no torque was recorded; there is no curve to fit")}};
  return all;
}

}  // namespace tribolog::wording
