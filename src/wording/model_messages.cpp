// The one model of sweeps, runs and points: its effects, and why a number of it cannot be used.

#include "wording/messages.h"

namespace tribolog::wording {

const Messages& model_messages() {
  static const Messages all{
      {"interval.of_model",
       text("95 % credible interval of one model of all sweeps, runs and friction points")},
      {"model.wide",
       text("known to ± {half_width:.3g} %, and ± {need:.2g} % is needed; most of it comes from "
            "{effect}")},
      {"model.angle_wide",
       text("known to ± {half_width:.3g}°, and ± {need:.2g}° is needed; most of it comes from "
            "{effect}")},
      {"model.not_shown", text("the recordings do not show it, mostly because of {effect}")},
      {"model.cells_far_off",
       text("{percent:.0f} % of the torque's means lie far off any model of the joint")},
      {"model.recordings_unlike",
       text("recordings whose torque is unlike that of all others: {recordings}")},
      {"model.recordings_left_out",
       by_count("recordings",
                "{recordings} recording does not belong with the others and is not in the model of "
                "sweeps and runs: {names:, }",
                "{recordings} recordings do not belong with the others and are not in the model of "
                "sweeps and runs: {names:, }")},
      {"model.law_bends",
       text("friction does not grow in proportion to speed: Coulomb torque and viscous coefficient "
            "depend on the law that is assumed, friction at the speeds does not")},
      {"model.negative_friction",
       text("friction falls with the speed as a whole, or drives the joint: no joint's does")},
      {"model.effect_too_large",
       text("the number depends on {effect}, which is larger here than on any known joint")},
      {"model.rests_on_effect",
       text("the recordings show {effect}, and most of what is not known of the number is how it "
            "goes on")},
      {"model.effect_shows",
       text("the recordings show {effect}: up to {largest_Nm:.2g} ± {half_width_Nm:.1g} N·m, "
            "{percent:.2g} % of the friction; it is taken off the numbers of sweeps and runs")},
      {"model.others_too_large",
       text(
           "{effect} is not small beside the friction, and nothing but the other joints' angles is "
           "known of it")},

      {"record.whole_turn", text("a sweep over a whole turn of the joint, or as much of it as it "
                                 "can, in both directions")},
      {"record.one_session", text("sweeps and runs one after the other, at the same temperature")},
      {"record.one_tool", text("sweeps and runs with the same tool")},
      {"record.one_tare", text("all recordings after one tare of the torque sensor")},
      {"record.both_directions", text("the same motions in both directions")},
      {"record.other_days", text("the same again on other days")},
      {"record.repeated_runs", text("the same runs once more, in random order")},

      {"effect.gravity_left", text("gravity of a joint stated to have none")},
      {"effect.others_gravity", text("gravity that other joints change")},
      {"effect.others_inertia", text("what the acceleration of other joints takes")},
      {"effect.offset",
       text("an offset of the torque, or friction that differs with the direction")},
      {"effect.offset_drift", text("a drift of the torque's offset")},
      {"effect.gain_drift", text("a drift of the torque's scale")},
      {"effect.torque_nonlinear", text("a torque out of proportion")},
      {"effect.gain_of_speed", text("a torque's scale that changes with the speed")},
      {"effect.gain_of_runs", text("another torque scale in the runs")},
      {"effect.tool", text("another load in the runs than in the sweeps")},
      {"effect.lag", text("a lag between torque and angle")},
      {"effect.asymmetry", text("friction that differs with the direction and the speed")},
      {"effect.load", text("friction that grows with the load")},
      {"effect.position", text("friction that changes with the joint's angle")},
      {"effect.torque_over_turn", text("a torque that repeats with each turn")},
      {"effect.hoses", text("hoses and cables")},
      {"effect.angle_scale", text("a scale of the angle that is off")},
      {"effect.motor_turn", text("friction that changes over the motor's turn")},
      {"effect.homing", text("an angle whose zero differs between recordings")},
      {"effect.peak_drift", text("a gravity peak that moves")},
      {"effect.harmonics",
       text("a torque of the angle beside gravity: hoses, twist of the gear, crosstalk")},
      {"effect.smooth_over_angle", text("a torque that changes slowly with the angle")},
      {"effect.drift", text("friction that changes over the session")},
      {"effect.law_misfit", text("friction over the speed that follows no law")},
      {"effect.contact_misfit", text("a contact that is not quite LuGre's")},
      {"effect.law_at_its_ends", text("the law of friction at the ends of the speeds")},
      {"effect.choice_of_law", text("the choice among laws of friction over the speed")},
      {"effect.friction_of_session", text("how friction changes from day to day")},
      {"effect.tare", text("an offset of its own in each recording")},
      {"effect.friction_of_recording", text("how friction changes between recordings")},

      {"interval.at_the_runs",
       text("{interval}; at the mean load, place and time of the runs, widened by what of their "
            "effect on friction is not known")},
      {"interval.at_the_gain",
       text("{interval}; less what a change of the torque is logged too large under the loops' "
            "load, widened by what is not known of it")},
      {"rule.friction_by_motor_angle", text("Change of friction along the sweep, as of a sine")},
      {"rule.break_away_by_motor_angle",
       text("What ramps at several motor angles differ by beyond the scatter at one")},
      {"cause.friction_by_motor_angle",
       text("friction changes with the motor's angle by ±{percent:.2g} %, strongest with "
            "{periods:.3g} periods to the motor's turn: ramps and loops have that of the angles at "
            "which they were recorded, and their intervals hold the mean over all angles")},
      {"cause.friction_along_angle",
       text("friction changes along the sweep by ±{percent:.2g} %, without a period of its own: "
            "ramps and loops have that of the angles at which they were recorded, and their "
            "intervals hold the mean over all angles")},
      {"cause.friction_by_motor_angle_of_ramps",
       text("break-away ramps at {positions} motor angles differ by {percent:.2g} % (standard "
            "deviation) beyond the scatter at one angle: the interval is that of the mean over all "
            "angles")},
      {"record.friction_without_load",
       text("sweeps at several constant speeds over angles of high and of low gravity torque, or "
            "the joint with its axis vertical")},
      {"record.warmed_up",
       text("the same again with the joint warmed up and the drive's offset settled, the sweep "
            "once more at the end")}};
  return all;
}

}  // namespace tribolog::wording
