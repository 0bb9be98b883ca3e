// What the quality errors, the selection, its parameters and the cross-checks state.

#include "wording/messages.h"

namespace tribolog::wording {

const Messages& selection_messages() {
  static const Messages all{
      // The quality errors.
      {"quality_errors.no_curve", text("there is no viscous curve to judge")},
      {"quality_errors.no_pairs",
       text("no reference: none of {runs} runs has a counterpart in the opposite direction at the "
            "same speed over common angles ({angles}), and no true curve is known; half the "
            "difference between the directions cannot be used; recording every speed in both "
            "directions over the same angles would give it")},
      {"quality_errors.too_few_pairs",
       text("no reference: {paired} of {runs} runs have a counterpart in the opposite direction at "
            "the same speed over common angles ({angles}), and no true curve is known; half the "
            "difference between the directions cannot be used; recording every speed in both "
            "directions over the same angles would give it")},
      {"quality_errors.runs_left_out",
       text("{left_out} of {runs} runs are left out: no counterpart in the opposite direction, or "
            "a driving torque below {least_percent:.0f} % of the largest")},

      // What the reference can tell.
      {"quality_errors.reference_exact", text("the reference is known exactly")},
      {"quality_errors.all_beyond_reference",
       text("the reference itself is known to {reference_percent:.2g} % of the driving torque "
            "(rms, 95 %): all errors are larger and count as evidence")},
      {"quality_errors.some_within_reference",
       text(
           "the reference itself is known to {reference_percent:.2g} % of the driving torque (rms, "
           "95 %): a smaller error is no evidence, and those of {estimators:, } are smaller")},
      {"quality_errors.estimator", values_alone("{estimator}")},

      // Why an estimator is recommended.
      {"selection.why", values_alone("{sentences: }")},
      {"selection.midline",
       text("The mid-line averages the whole steady loop, in which friction cancels whatever its "
            "model; a single point still contains the friction at its instant.")},
      {"selection.no_gravity",
       text("The joint has no gravity torque: friction is all that there is.")},
      {"selection.model",
       text("The model of sweeps and runs tells gravity from an offset of the torque, from hoses "
            "and from friction that differs between the directions, as far as the recordings do; "
            "a loop at one position cannot.")},
      {"selection.sweep_alone",
       text("No hysteresis loop at the gravity peak was recorded; the gravity amplitude of the "
            "rough sweep is the only estimate of the mass.")},
      {"selection.stated_alone",
       text("No recording shows the gravity torque; the mass is the one stated in the manifest.")},
      {"selection.quality_errors",
       text("Against the reference its curve is off by {rms_percent:.2g} % of the driving torque "
            "(rms), that of point {point} by {point_rms_percent:.2g} %.")},
      {"selection.left_to_noise",
       text("Within the intervals of single readings the paper's rule could have chosen {rivals: "
            "or } instead of {point}: here its choice is left to noise.")},

      // Why none is, or the paper's rule cannot be applied.
      {"selection.no_candidate", text("there is no candidate to choose from")},
      {"selection.no_quality_error",
       text("the paper's rule cannot be applied: there is no quality error to compare")},
      {"selection.no_loop_points",
       text("the paper's rule cannot be applied: the points A to F were not found")},

      // The parameters of the chosen curve.
      {"friction_parameters.no_curve", text("there is no viscous curve to fit")},
      {"friction_parameters.too_few_runs",
       by_count("runs",
                "{runs} run beyond the Stribeck dip is too few for a line; at least {needed} are "
                "needed",
                "{runs} runs beyond the Stribeck dip are too few for a line; at least {needed} are "
                "needed")},
      {"friction_parameters.waiboer_not_fitted", text("eq. (6) was not fitted: {why}")},
      {"friction_parameters.speed_changes_with_angle",
       text("speed and angle change together in a sweep; runs at constant speed would show the "
            "Stribeck effect")},

      // The estimators of the gravity torque.
      {"estimator.A", text("A")},
      {"estimator.B", text("B")},
      {"estimator.C", text("C")},
      {"estimator.D", text("D")},
      {"estimator.E", text("E")},
      {"estimator.F", text("F")},
      {"estimator.AB", text("mean of A and B")},
      {"estimator.CD", text("mean of C and D")},
      {"estimator.EF", text("mean of E and F")},
      {"estimator.midline", text("mid-line")},
      {"estimator.fit", text("LuGre model fitted to the loops")},
      {"estimator.sweep", text("rough sweep")},
      {"estimator.model", text("model of sweeps and runs")},
      {"estimator.stated", text("stated")},

      // Estimators that disagree, and what would do that.
      {"cross_check.disagree",
       text("{recommended} and {other} disagree: {recommended_kg:.3f} kg against {other_kg:.3f} "
            "kg, a difference of {difference_percent:+.2f} % where up to {interval_percent:.2g} % "
            "would be within its interval; {cause}")},
      {"cross_check.ripple_at_position",
       text("ripple at the position of the oscillation would explain it")},
      {"cross_check.loop_not_steady", text("a loop that is not yet steady would explain it")},
      {"cross_check.friction_beyond_lugre",
       text("friction that LuGre does not describe would explain it")},
      {"cross_check.ripple_load_or_zero",
       text("torque ripple, friction that depends on the load, or a torque that is not zero "
            "without load would explain it")},
  };
  return all;
}

}  // namespace tribolog::wording
