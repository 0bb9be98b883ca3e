// What friction depends on beside the speed: load, angle, direction, time.

#include "wording/messages.h"

namespace tribolog::wording {

const Messages& session_messages() {
  static const Messages all{
      {"session.gravity_not_known",
       text("what friction depends on beside the speed cannot be seen without gravity from a sweep "
            "or from runs")},
      {"session.too_few_strokes",
       text("what friction depends on beside the speed cannot be seen: {pairs} pairs of strokes at "
            "one speed over the same angles in both directions are too few")},
      {"session.examined",
       text("friction was compared over {pairs} pairs of strokes at one speed over the same angles "
            "in both directions")},

      {"rule.friction_by_load", text("Friction that the load adds")},
      {"rule.friction_by_load_slope", text("Slope over the speed that the load adds")},
      {"rule.friction_by_angle", text("Change of friction with the joint's angle")},
      {"rule.friction_by_angle_slope",
       text("Change of friction with the joint's angle, for the slope over the speed")},
      {"rule.friction_by_motor_angle", text("Change of friction along the sweep, as of a sine")},
      {"rule.break_away_by_motor_angle",
       text("What ramps at several motor angles differ by beyond the scatter at one")},
      {"rule.friction_by_direction", text("Asymmetry of friction")},
      {"rule.friction_by_direction_large",
       text("Asymmetry of friction at which the mean of both directions is no joint's")},
      {"rule.torque_offset", text("Offset of the torque, by the gravity torque")},
      {"rule.friction_drift", text("Change of friction over the session")},
      {"rule.friction_drift_angle",
       text("What the change of friction within the sweep leaves of the angle's uncertainty")},
      {"rule.friction_drift_gravity",
       text("What the change of friction within the sweep does to the gravity torque")},
      {"rule.offset_drift", text("Change of the torque's offset, by the gravity torque")},
      {"rule.offset_drift_gravity",
       text("Change of the torque's offset from the sweep to the oscillations, by the gravity "
            "torque")},
      {"rule.offset_drift_friction", text("Change of the torque's offset, by friction")},

      {"cause.load",
       text("friction grows with the load, by {share_percent:.2g} % of the gravity torque (95 %: "
            "{low_percent:.2g} to {high_percent:.2g} %): {at_peak_Nm:.3g} N·m at the gravity peak "
            "against {unloaded_Nm:.3g} N·m without load; friction and bristle hold at the load at "
            "which they were recorded")},
      {"cause.angle",
       text("friction changes with the joint's angle by ±{percent:.2g} % (95 %: {low_percent:.2g} "
            "to {high_percent:.2g} %), other than the load would: friction and bristle hold at the "
            "angles at which they were recorded")},
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
      {"cause.asymmetry",
       text("friction is not the same in both directions: {percent:+.2g} % (95 %: "
            "{low_percent:+.2g} to {high_percent:+.2g} %) while the angle rises, and as much the "
            "other way while it falls")},
      {"cause.asymmetry_or_offset",
       text("both directions have {offset_Nm:+.3g} N·m in common that is not gravity: friction "
            "that is {percent:+.2g} % larger while the angle rises, or an offset of the torque; "
            "friction differs too little between the speeds to tell which")},
      {"cause.offset",
       text("the torque has an offset of {offset_Nm:+.3g} ± {half_width_Nm:.2g} N·m, "
            "{percent:+.2g} % of the gravity torque, the same at all speeds")},
      {"cause.offset_or_dead_zone",
       text("the torque has an offset of {offset_Nm:+.3g} ± {half_width_Nm:.2g} N·m, "
            "{percent:+.2g} % of the gravity torque, the same at all speeds, or a dead zone of "
            "that size: it keeps its sign in sweep and runs, where both look alike")},
      {"cause.drift",
       text("friction changed by {percent:+.2g} % over the session of {minutes:.2g} min (95 %: "
            "{low_percent:+.2g} to {high_percent:+.2g} %; {levels} levels): "
            "what was measured at its beginning and at its end does not describe one joint")},
      {"cause.drift_within_sweep",
       text("friction changed within the sweep, {percent:+.2g} % over the session: that moved the "
            "angle by {shift_deg:+.2g}°, which was taken off; {slack_deg:.2g}° of it are not "
            "certain")},
      {"cause.drift_of_offset",
       text("the offset of the torque changed by {change_Nm:+.3g} ± {half_width_Nm:.2g} N·m over "
            "the session of {minutes:.2g} min, {percent:+.2g} % of the gravity torque")},

      {"record.friction_without_load",
       text("sweeps at several constant speeds over angles of high and of low gravity torque, or "
            "the joint with its axis vertical")},
      {"record.warmed_up",
       text("the same again with the joint warmed up and the drive's offset settled, the sweep "
            "once more at the end")},
      {"interval.widened_by_friction_of_angle",
       text("{interval}; widened by what friction changes with the motor's angle")},
      {"interval.without_drift_of_friction",
       text("{interval}; less what friction's change within the sweep did to it, and widened by "
            "what of that is not certain")},
      {"interval.laws_and_times",
       text("all laws over the speed and times of change that describe the levels about equally "
            "well")}};
  return all;
}

}  // namespace tribolog::wording
