// What a plan says of its parts: what to do, what it gives, what stands in the way and what helps.

#include "wording/messages.h"

namespace tribolog::wording {

const Messages& plan_messages() {
  static const Messages all{
      {"plan_state.planned", text("planned")},
      {"plan_state.later", text("follows from the rough sweep")},
      {"plan_state.limited", text("planned, limited")},
      {"plan_state.impossible", text("not possible")},

      // Names of the segments.
      {"plan_segment.travel", text("travel")},
      {"plan_segment.rough_sweep", text("rough sweep")},
      {"plan_segment.precise_sweep", text("precise sweep")},
      {"plan_segment.oscillation", text("oscillation {number} of {oscillations}")},
      {"plan_segment.other_oscillation", text("oscillation of {amplitude:.3g} µrad")},
      {"plan_segment.constant_speed", text("constant speed {number}: {motor_speed:.3g} rad/s")},
      {"plan_segment.ramp_up", text("break-away {number} of {ramps}, torque rising")},
      {"plan_segment.ramp_down", text("break-away {number} of {ramps}, torque falling")},

      // What to do.
      {"plan_motion.sweep", text("from {start} to {end} and back at {joint_speed:.3g}°/s, "
                                 "{motor_speed:.3g} rad/s at the motor")},
      {"plan_motion.oscillations",
       by_count("positions",
                "{cycles} at {frequency:.3g} Hz, amplitude {amplitude:.3g} µrad "
                "({motor_amplitude:.3g} mrad at the motor), at {positions} position from {first} "
                "to {last}",
                "{cycles} at {frequency:.3g} Hz, amplitude {amplitude:.3g} µrad "
                "({motor_amplitude:.3g} mrad at the motor), at {positions} positions from {first} "
                "to {last}")},
      {"plan_motion.cycles", by_count("cycles", "{cycles} cycle", "{cycles} cycles")},
      {"plan_motion.other_amplitude", text("because the bristle stiffness is assumed, at the "
                                           "middle position also with {amplitude:.3g} µrad")},
      {"plan_motion.other_amplitudes",
       text("because the bristle stiffness is assumed, at the middle position also with "
            "{smaller:.3g} µrad and {larger:.3g} µrad")},
      {"plan_runs_to.speed_limit",
       by_count("speeds",
                "{speeds} speed in both directions from {slowest:.3g} to {fastest:.3g} rad/s at "
                "the motor ({slowest_joint:.3g}°/s to {fastest_joint:.3g}°/s), the fastest set by "
                "the speed limit",
                "{speeds} speeds in both directions from {slowest:.3g} to {fastest:.3g} rad/s at "
                "the motor ({slowest_joint:.3g}°/s to {fastest_joint:.3g}°/s), the fastest set by "
                "the speed limit")},
      {"plan_runs_to.angle_range",
       by_count("speeds",
                "{speeds} speed in both directions from {slowest:.3g} to {fastest:.3g} rad/s at "
                "the motor ({slowest_joint:.3g}°/s to {fastest_joint:.3g}°/s), the fastest set by "
                "the angle range",
                "{speeds} speeds in both directions from {slowest:.3g} to {fastest:.3g} rad/s at "
                "the motor ({slowest_joint:.3g}°/s to {fastest_joint:.3g}°/s), the fastest set by "
                "the angle range")},
      {"plan_runs_to.torque_limit",
       by_count("speeds",
                "{speeds} speed in both directions from {slowest:.3g} to {fastest:.3g} rad/s at "
                "the motor ({slowest_joint:.3g}°/s to {fastest_joint:.3g}°/s), the fastest set by "
                "the torque limit",
                "{speeds} speeds in both directions from {slowest:.3g} to {fastest:.3g} rad/s at "
                "the motor ({slowest_joint:.3g}°/s to {fastest_joint:.3g}°/s), the fastest set by "
                "the torque limit")},
      {"plan_motion.ramps",
       by_count("ramps",
                "at {angle}, {ramps} ramp up and {ramps} down at {rate:.3g} N·m/s, by up to "
                "{change:.3g} N·m at the motor from what holds the arm; a ramp ends when the joint "
                "has slid {travel:.2g}°",
                "at {angle}, {ramps} ramps up and {ramps} down at {rate:.3g} N·m/s, by up to "
                "{change:.3g} N·m at the motor from what holds the arm; a ramp ends when the joint "
                "has slid {travel:.2g}°")},

      // What it gives.
      {"plan_gives.rough_sweep",
       text("gravity torque, angle of the gravity peak, friction at low speed, torque ripple")},
      {"plan_gives.precise_sweep", text("more precise angle of the gravity peak")},
      {"plan_gives.oscillations", text("gravity torque free of friction, surrogate mass, bristle "
                                       "stiffness, break-away torque")},
      {"plan_gives.runs", text("friction against speed: Coulomb, Stribeck and viscous parameters")},
      {"plan_gives.ramps", text("break-away torque without any model")},

      // Why a part is limited or not possible.
      {"plan_limit.peak_unknown",
       text("it is centred on the gravity peak, whose angle the rough sweep gives")},
      {"plan_limit.peak_outside",
       text("the gravity peak at {peak} lies outside the usable range, {lowest} to {highest}")},
      {"plan_limit.range_too_small", text("over the usable range of {range} a cosine cannot be "
                                          "told from a constant; {needed} is needed")},
      {"plan_limit.short_range", text("{range} is a short range: gravity is separated from "
                                      "friction less reliably; {good} or more is good")},
      {"plan_limit.peak_not_crossed", text("the sweep does not cross the gravity peak at {peak}")},
      {"plan_limit.peak_at_end", text("the gravity peak at {peak} is {distance} from the end of "
                                      "the range; {needed} is needed")},
      {"plan_limit.encoder_in_presliding",
       text("the encoder is too coarse for pre-sliding: {counts:.0f} counts per motor turn give "
            "{steps:.2g} steps across a loop of {loop_width:.2g} rad at the motor; "
            "{steps_needed:.0f} are needed")},
      {"plan_limit.oscillation_too_wide",
       text("its width of {width:.3g} rad exceeds the range of {range:.3g} rad")},
      {"plan_limit.all_ripple_stays",
       text("all of the ripple's amplitude of {ripple_amplitude:.2g} N·m remains in the mean over "
            "the positions: a motor turn is {motor_turn} at the joint")},
      {"plan_limit.ripple_stays",
       text("{left_percent:.0f} % of the ripple's amplitude of {ripple_amplitude:.2g} N·m remains "
            "in the mean over the positions: a motor turn is {motor_turn} at the joint")},
      {"plan_no_runs_within.speed_limit",
       text("the speed limit allows {fastest:.3g} rad/s at the motor, below {slowest:.3g} rad/s "
            "where runs would begin (a fifth of the Stribeck velocity)")},
      {"plan_no_runs_within.angle_range",
       text("the angle range allows {fastest:.3g} rad/s at the motor, below {slowest:.3g} rad/s "
            "where runs would begin (a fifth of the Stribeck velocity)")},
      {"plan_no_runs_within.torque_limit",
       text("the torque limit allows {fastest:.3g} rad/s at the motor, below {slowest:.3g} rad/s "
            "where runs would begin (a fifth of the Stribeck velocity)")},
      {"plan_slow_runs_within.speed_limit",
       text("the speed limit allows {fastest:.3g} rad/s at the motor, {times:.2g} times the "
            "Stribeck velocity of {stribeck_speed:.3g} rad/s: viscous friction cannot be told from "
            "the Stribeck effect")},
      {"plan_slow_runs_within.angle_range",
       text("the angle range allows {fastest:.3g} rad/s at the motor, {times:.2g} times the "
            "Stribeck velocity of {stribeck_speed:.3g} rad/s: viscous friction cannot be told from "
            "the Stribeck effect")},
      {"plan_slow_runs_within.torque_limit",
       text("the torque limit allows {fastest:.3g} rad/s at the motor, {times:.2g} times the "
            "Stribeck velocity of {stribeck_speed:.3g} rad/s: viscous friction cannot be told from "
            "the Stribeck effect")},
      {"plan_limit.torque_left_for_ramp",
       text("holding gravity of {gravity_torque:.4g} N·m, the torque limit of {torque_limit:.4g} "
            "N·m leaves {torque_left:.3g} N·m; {torque_needed:.3g} N·m are needed to pass the "
            "break-away torque of {break_away_torque:.3g} N·m")},
      {"plan_limit.encoder_before_break_away",
       text("the {deflection:.2g} rad of motor travel to break-away are {steps:.2g} encoder steps; "
            "{steps_needed:.0f} are needed")},

      // What would help.
      {"plan_help.plan_again",
       text("record this plan, identify it, and plan again with --calibration and the result")},
      {"plan_help.bring_peak_inside",
       text("wider angle limits, a lighter load where torque is the limit, or another pose of the "
            "arm that brings the peak inside")},
      {"plan_help.wider_angle_limits", text("wider angle limits")},
      {"plan_help.range_with_peak", text("an angle range that includes the peak")},
      {"plan_help.finer_encoder_for_loop",
       text("an encoder of {counts:.0f} counts or more, interpolated lines counted; the sweep and "
            "the runs give gravity and sliding friction without it")},
      {"plan_help.finer_encoder", text("a finer encoder")},
      {"plan_help.wider_range_about_peak", text("a wider range about the gravity peak")},
      {"plan_higher.speed_limit", text("a higher speed limit")},
      {"plan_higher.angle_range", text("a wider angle range")},
      {"plan_higher.torque_limit", text("a higher torque limit")},
      {"plan_help.motor_speed", text("{motor_speed:.3g} rad/s or more at the motor")},
      {"plan_help.lighter_load", text("a lighter load")},

      // Of the whole plan.
      {"plan.torque_holds_stretch",
       text("the torque limit of {torque_limit:.4g} N·m at the motor holds gravity of "
            "{gravity_torque:.4g} N·m and friction of {break_away_torque:.3g} N·m only from "
            "{lowest} to {highest}: a lighter load, or a drive of {torque_needed:.3g} N·m, would "
            "open the whole range")},
      {"plan.torque_holds_nowhere",
       text("the torque limit of {torque_limit:.4g} N·m at the motor holds gravity of "
            "{gravity_torque:.4g} N·m and friction of {break_away_torque:.3g} N·m nowhere within "
            "the angle limits: a lighter load, or a drive of {torque_needed:.3g} N·m, would open "
            "the whole range")},
      {"plan.sweep_may_stall",
       text("gravity of {gravity_torque:.4g} N·m and friction of {break_away_torque:.3g} N·m "
            "exceed 95 % of the torque limit of {torque_limit:.4g} N·m at the motor: as long as "
            "the angle of the peak is not known, the sweep may stall")},
      {"plan.longer_than_budget",
       text("the shortest plan takes {duration:.0f} s, more than the time budget of {budget:.0f} "
            "s: leave parts out, starting with the last, or allow more time")},

      // What is known or assumed of the joint, and from where.
      {"assumed.q_peak", text("Angle of the gravity peak")},
      {"assumed.gravity", text("Gravity torque at the motor, centre of gravity level")},
      {"assumed.inertia", text("Inertia at the motor")},
      {"assumed.static_torque", text("Break-away torque at the motor")},
      {"assumed.coulomb_torque", text("Coulomb torque at the motor")},
      {"assumed.stribeck_speed", text("Stribeck velocity of the motor")},
      {"assumed.viscous_coefficient", text("Viscous coefficient c_v of eq. (6)")},
      {"assumed.bristle_stiffness", text("Bristle stiffness")},
      {"assumed.sample_rate", text("Sampling rate of the log")},
      {"assumed.set_point_rate", text("Rate of the set points")},
      {"assumed.encoder_counts", text("Encoder counts per motor turn")},
      {"assumed.torque_noise", text("White torque noise, standard deviation")},
      {"assumed.torque_step", text("Torque step")},
      {"assumed.ripple_amplitude", text("Torque ripple, amplitude of each period")},
      {"assumed.ripple_periods", text("Ripple periods per motor turn")},
      {"assumed_from.identified", text("identified")},
      {"assumed_from.stated", text("stated")},
      {"assumed_from.middle_of_range",
       text("not known: middle of the range, for the simulation only")},
      {"assumed_from.torque_limit_40_percent", text("40 % of the torque limit")},
      {"assumed_from.torque_limit_25_percent",
       text("takes 25 % of the torque limit at the acceleration limit")},
      {"assumed_from.torque_limit_10_percent", text("10 % of the torque limit")},
      {"assumed_from.torque_limit_400th", text("1/400 of the torque limit")},
      {"assumed_from.torque_limit_1600th", text("1/1600 of the torque limit")},
      {"assumed_from.coulomb_torque", text("Coulomb torque / 0.68")},
      {"assumed_from.break_away_torque_68_percent",
       text("68 % of the break-away torque, as for the paper's joint")},
      {"assumed_from.break_away_torque",
       text("share of the break-away torque as for the paper's joint")},
      {"assumed_from.papers_joint", text("as for the paper's joint")},
      {"assumed_from.papers_deflection",
       text("break-away after 1.9 mrad at the motor, as for the paper's joint")},
      {"assumed_from.usual", text("typical")},
      {"assumed_from.usual_interpolated", text("typical; the drive interpolates between them")},
      {"assumed_from.usual_encoder", text("typical: 2^17")},
      {"assumed_from.eccentric_shaft", text("typical: an eccentric shaft")},
      {"assumed_from.wave_generator", text("typical: wave generator of a strain wave gear")},
      {"assumed_from.pole_pairs", text("typical: a motor with three pole pairs")},

      // Whose interval is to be expected, by the name of the reading.
      {"expected.midline", text("gravity torque, mid-line of the loops")},
      {"expected.fit", text("gravity torque, LuGre fit")},
      {"expected.model", text("gravity torque, model of sweeps and runs")},
      {"expected.q_peak", text("angle of the gravity peak")},
      {"expected.bristle_stiffness", text("bristle stiffness σ₀")},
      {"expected.static_torque", text("break-away torque T_s, LuGre fit")},
      {"expected.break_away", text("break-away torque, ramps")},
      {"expected.sweep_friction", text("friction of the slow sweep")},
      {"expected.coulomb", text("Coulomb torque T_c, straight line")},
      {"expected.viscous", text("viscous coefficient c, straight line")},
      {"expected.asperity_torque", text("asperity torque T_a, eq. (6)")},
      {"expected.stribeck_speed", text("Stribeck velocity ω_s, eq. (6)")},
      {"expected.viscous_coefficient", text("viscous coefficient c_v, eq. (6)")},
      {"expected.viscous_power", text("viscous power δ_v, eq. (6)")}};
  return all;
}

}  // namespace tribolog::wording
