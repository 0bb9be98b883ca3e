// What the history states: of two calibrations side by side, and of a joint over time.

#include "wording/messages.h"

namespace tribolog::wording {

const Messages& history_messages() {
  static const Messages all{
      // A change, in a word.
      {"comparison.no_change_seen", text("no change seen")},
      {"comparison.changed", text("changed")},
      {"comparison.not_comparable", text("not comparable")},

      // Why two values cannot be compared, or only with caution.
      {"comparison.temperatures_differ",
       text("the temperatures differ by {difference_K:.3g} K ({first_temperature_C:.4g} °C and "
            "{second_temperature_C:.4g} °C), more than the {allowed_difference_K:.3g} K allowed, "
            "and friction changes with temperature")},
      {"comparison.no_first_temperature", text("the temperature of the first calibration is not "
                                               "stated; temperature alone can change friction")},
      {"comparison.no_second_temperature", text("the temperature of the second calibration is not "
                                                "stated; temperature alone can change friction")},
      {"comparison.no_temperature", text("the temperature of both calibrations is not stated; "
                                         "temperature alone can change friction")},
      {"comparison.sampling_rates_differ",
       text("the sampling rates differ more than {allowed_factor:.3g}-fold ({first_rate_Hz:.4g} Hz "
            "and {second_rate_Hz:.4g} Hz), and this quantity is read from fast changes")},
      {"comparison.gear_ratios_differ",
       text("the gear ratios differ ({first_ratio:.6g} and {second_ratio:.6g})")},
      {"comparison.payloads_differ",
       text("the payloads differ ({first_payload} and {second_payload})")},
      {"comparison.payloads_load_the_gear",
       text("the payloads differ ({first_payload} and {second_payload}); friction grows with the "
            "load of the gear")},
      {"comparison.different_influence",
       text("the two do not rest on the same {influence} ({first_id}; {second_id}): what is stated "
            "of its error is in the change's interval")},
      {"comparison.verdict_of_first", text("the first calibration's verdict on it is “{verdict}”")},
      {"comparison.verdict_of_second",
       text("the second calibration's verdict on it is “{verdict}”")},
      {"comparison.units_differ", text("the units differ ({first_unit} and {second_unit})")},

      // A payload.
      {"payload.none_stated", text("none stated")},
      {"payload.named", text("“{payload}”")},
      {"payload.mass", values_alone("{mass_kg:.6g} kg")},
      {"payload.distance", text("at {distance_m:.6g} m")},
      {"payload.named_mass", text("“{payload}”, {mass_kg:.6g} kg")},
      {"payload.named_at_distance", text("“{payload}” at {distance_m:.6g} m")},
      {"payload.mass_at_distance", text("{mass_kg:.6g} kg at {distance_m:.6g} m")},
      {"payload.named_mass_at_distance",
       text("“{payload}”, {mass_kg:.6g} kg at {distance_m:.6g} m")},

      // On the pair as a whole.
      {"comparison.different_joints",
       text("these are different joints ({first_robot} {first_serial}, joint {first_joint} and "
            "{second_robot} {second_serial}, joint {second_joint}): a difference is not a change")},
      {"comparison.backwards_in_time",
       text("the first one was measured after the second: changes run backwards in time")},
      {"comparison.time_not_stated",
       text("not both state when they were measured; the time of identification is used instead")},
      {"comparison.different_settings",
       text("they were identified with different settings, which affects the intervals")},
      {"comparison.different_versions",
       text("they were identified by different versions of the program; identifying the same "
            "inputs again with one version would rule that out")},

      // A joint over time.
      {"trend.too_few", text("too few calibrations yet")},
      {"trend.steady", text("no change visible")},
      {"trend.apart", text("single calibrations far from the others")},
      {"trend.recovered", text("changed and returned")},
      {"trend.changed", text("changed")},
      {"trend.time_not_stated",
       by_count("undated",
                "{undated} of {calibrations} calibrations does not state when it was measured; it "
                "is placed at the time of its identification",
                "{undated} of {calibrations} calibrations do not state when they were measured; "
                "they are placed at the time of their identification")},
      {"trend.warming",
       text("temperature and time changed together (correlation {correlation:.2f}): what looks "
            "like temperature may be drift; a calibration at an earlier temperature would tell")},

      // What an archive says of a result and of a calibration.
      {"archived_verdict.usable", text("usable")},
      {"archived_verdict.doubtful", text("doubtful")},
      {"archived_verdict.not_identifiable", text("not_identifiable")},
      {"archived_decision.approved", text("approved")},
      {"archived_decision.rejected", text("rejected")},
      // Where the side stands beside it.
      {"quantity_without_side.inertia", text("Inertia")}};
  return all;
}

}  // namespace tribolog::wording
