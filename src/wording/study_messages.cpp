// What a Monte-Carlo study varies, and what it found.

#include "wording/messages.h"

namespace tribolog::wording {

const Messages& study_messages() {
  static const Messages all{
      // The factors, by their keys.
      {"factor.torque_noise", text("White torque noise")},
      {"factor.torque_step", text("Torque quantisation")},
      {"factor.encoder", text("Encoder resolution")},
      {"factor.ripple_one_position", text("Torque ripple, one position")},
      {"factor.ripple_eight_positions", text("Torque ripple, eight positions")},
      {"factor.amplitude", text("Amplitude of the oscillation")},
      {"factor.cycles", text("Cycles of the oscillation")},
      {"factor_axis.torque_noise", text("white torque noise, standard deviation [mN·m]")},
      {"factor_axis.torque_step", text("torque step [mN·m]")},
      {"factor_axis.encoder", text("encoder resolution [bits of one motor turn]")},
      {"factor_axis.ripple_one_position", text("amplitude of each of the two ripples [mN·m]")},
      {"factor_axis.ripple_eight_positions", text("amplitude of each of the two ripples [mN·m]")},
      {"factor_axis.amplitude", text("amplitude at the joint [µrad]")},
      {"factor_axis.cycles", text("cycles recorded")},
      {"factor_note.torque_noise",
       text("Standard deviation of the white noise of the torque samples.")},
      {"factor_note.torque_step", text("Step in which the torque is logged.")},
      {"factor_note.encoder",
       text("Counts of the motor encoder; the logged speed is derived from their difference.")},
      {"factor_note.ripple_one_position",
       text("Ripple of 1 and of 6 periods per motor turn, with new random phases in each run; the "
            "oscillation is recorded at one motor position. The precise sweep and the runs at "
            "constant speed, which it does not affect, are left out.")},
      {"factor_note.ripple_eight_positions",
       text("Ripple of 1 and of 6 periods per motor turn, with new random phases in each run; the "
            "oscillation is recorded at eight motor positions spread over a turn. The precise "
            "sweep and the runs at constant speed, which it does not affect, are left out.")},
      {"factor_note.amplitude",
       text("Amplitude of the oscillation at the joint, at the same frequency. The precise sweep "
            "and the runs at constant speed, which it does not affect, are left out.")},
      {"factor_note.cycles",
       text("Cycles of the oscillation; the first is the start-up stroke. The precise sweep and "
            "the runs at constant speed, which it does not affect, are left out.")},

      // Levels of a factor.
      {"study_level.torque", values_alone("{torque:.4g} mN·m")},
      {"study_level.amplitude", values_alone("{amplitude:.4g} µrad")},
      {"study_level.counts", by_count("counts", "{counts} count", "{counts} counts")},
      {"study_level.cycles", by_count("cycles", "{cycles} cycle", "{cycles} cycles")},
      {"study_level.broken_cycles", text("{cycles:.4g} cycles")},
      {"study_at.torque_noise", text("white torque noise {level}")},
      {"study_at.torque_step", text("torque quantisation {level}")},
      {"study_at.encoder", text("encoder resolution {level}")},
      {"study_at.ripple_one_position", text("torque ripple, one position {level}")},
      {"study_at.ripple_eight_positions", text("torque ripple, eight positions {level}")},
      {"study_at.amplitude", text("amplitude of the oscillation {level}")},
      {"study_at.cycles", text("cycles of the oscillation {level}")},
      {"study_not_found_at.torque_noise", text("white torque noise {level} (not found there)")},
      {"study_not_found_at.torque_step", text("torque quantisation {level} (not found there)")},
      {"study_not_found_at.encoder", text("encoder resolution {level} (not found there)")},
      {"study_not_found_at.ripple_one_position",
       text("torque ripple, one position {level} (not found there)")},
      {"study_not_found_at.ripple_eight_positions",
       text("torque ripple, eight positions {level} (not found there)")},
      {"study_not_found_at.amplitude",
       text("amplitude of the oscillation {level} (not found there)")},
      {"study_not_found_at.cycles", text("cycles of the oscillation {level} (not found there)")},

      // How far the recommended estimator can be trusted.
      {"study.no_gravity", text("No gravity torque was found in the base case.")},
      {"study_sentence.midline",
       text("In the base case the mid-line is within {error_percent:.2g} % of the true gravity "
            "torque in 95 of 100 runs, and {coverage_percent:.0f} % of its stated intervals "
            "contain the true value.")},
      {"study_sentence.model",
       text("In the base case the model of sweeps and runs is within {error_percent:.2g} % of the "
            "true gravity torque in 95 of 100 runs, and {coverage_percent:.0f} % of its stated "
            "intervals "
            "contain the true value.")},
      {"study_sentence.midline_beside_B",
       text("In the base case the mid-line is within {error_percent:.2g} % of the true gravity "
            "torque in 95 of 100 runs, and {coverage_percent:.0f} % of its stated intervals "
            "contain the true value; point B is off by {point_b_bias_percent:+.2f} %, the mid-line "
            "by {bias_percent:+.3f} %.")},
      {"study_sentence.model_beside_B",
       text("In the base case the model of sweeps and runs is within {error_percent:.2g} % of the "
            "true gravity torque in 95 of 100 runs, and {coverage_percent:.0f} % of its stated "
            "intervals "
            "contain the true value; point B is off by {point_b_bias_percent:+.2f} %, the model "
            "by {bias_percent:+.3f} %.")},

      // What was found.
      {"study.gravity_in_base_case", text("Gravity torque in the base case: {estimators:; }.")},
      {"study.biased", text("{estimator} biased by {bias_percent:+.3f} ± "
                            "{standard_error_percent:.3f} %")},
      {"study.free_of_bias", text("{estimator} free of relevant bias ({bias_percent:+.3f} ± "
                                  "{standard_error_percent:.3f} %)")},
      {"study.steady_loop",
       text("In the steady loop A and B lie on either side of the true value, "
            "{point_a_bias_percent:+.2f} % and {point_b_bias_percent:+.2f} %: which of them is "
            "nearer in the paper's reading depends on the start-up stroke alone.")},
      {"studied.midline", text("Mid-line")},
      {"studied.fit", text("LuGre fit")},
      {"studied.model", text("Model of sweeps and runs")},
      {"study_fine.not_in_base_case", text("{estimator} exceeds 0.1 % already in the base case.")},
      {"study_coarse.not_in_base_case",
       text("{estimator} exceeds 0.3 % already in the base case.")},
      {"study_coverage.not_in_base_case",
       text("{estimator} has intervals that are too narrow already in the base case.")},
      {"study_fine.at_all_levels", text("{estimator} exceeds 0.1 % at no level tried.")},
      {"study_coarse.at_all_levels", text("{estimator} exceeds 0.3 % at no level tried.")},
      {"study_coverage.at_all_levels",
       text("{estimator} has intervals that are too narrow at no level tried.")},
      {"study_fine.left_at", text("{estimator} first exceeds 0.1 % at {levels:; }.")},
      {"study_coarse.left_at", text("{estimator} first exceeds 0.3 % at {levels:; }.")},
      {"study_coverage.left_at",
       text("{estimator} first has intervals that are too narrow at {levels:; }.")}};
  return all;
}

}  // namespace tribolog::wording
