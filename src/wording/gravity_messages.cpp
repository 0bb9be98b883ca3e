// What the motion of the joint, the sweeps and the runs state on the way to gravity.

#include "wording/messages.h"

namespace tribolog::wording {

const Messages& gravity_messages() {
  static const Messages all{
      // Why a recorded angle gives no motion.
      {"motion.too_few_samples",
       by_count("samples",
                "{samples} sample of motion; at least {needed} are needed to follow the angle",
                "{samples} samples of motion; at least {needed} are needed to follow the angle")},
      {"motion.angle_constant", text("the angle does not change")},
      {"motion.too_noisy",
       text("the angle is too noisy to give a speed: {source} leaves noise of {noise_rad:.2g} rad, "
            "{noise_percent:.1f} % of the amplitude of {amplitude_rad:.2g} rad; at most "
            "{most_percent:.0f} % is allowed")},
      {"motion.one_stroke",
       text("the angle makes {strokes} stroke, with {reversals} reversals between them; a loop "
            "needs at least {needed} strokes")},
      {"motion.too_few_strokes",
       by_count("reversals",
                "the angle makes {strokes} strokes, with {reversals} reversal between them; a loop "
                "needs at least {needed} strokes",
                "the angle makes {strokes} strokes, with {reversals} reversals between them; a "
                "loop needs at least {needed} strokes")},
      {"motion.too_few_samples_in_stroke",
       text("only {samples:.1f} samples per stroke; at least {needed:.0f} are needed to follow the "
            "angle through its reversals")},
      {"motion.to_and_fro",
       text("the angle is too noisy to give a speed: smoothed, with noise of {noise_rad:.2g} rad, "
            "it still goes back and forth by {excess_percent:.0f} % of its stroke travel; at most "
            "{most_percent:.0f} % is allowed")},

      // Where the noise of an angle comes from.
      {"motion.encoder_step", text("an encoder step of {step_rad:.2g} rad")},
      {"motion.sample_scatter", text("a sample scatter of {noise_rad:.2g} rad")},

      // Gravity from the sweeps.
      {"gravity.no_rough_sweep",
       text("no rough sweep was recorded; a slow sweep over the joint's range in both directions "
            "would give the angle of the centre of gravity and the gravity torque")},
      {"gravity.no_precise_sweep", text("no precise sweep was recorded; a slow sweep of about 1° "
                                        "to each side of the gravity peak would serve")},
      {"gravity.too_few_samples",
       by_count("samples",
                "only {samples} sample of the sweep moves steadily; at least {needed} are needed",
                "only {samples} samples of the sweep move steadily; at least {needed} are needed")},
      {"gravity.hardly_moves", text("the joint moves by only {travel_rad:.2g} rad")},
      {"gravity.not_shown",
       text("gravity does not show: amplitude {gravity_Nm:.3g} N·m with a 95 % interval from "
            "{low_Nm:.3g} to {high_Nm:.3g} N·m over {travel_deg:.1f}° of travel; sweep further, or "
            "load the joint")},
      {"gravity.one_direction",
       text("only one direction was recorded: friction does not cancel, and friction that varies "
            "with the angle would be taken for gravity")},
      {"gravity.peak_not_crossed",
       text("the sweep from {lowest_deg:.1f}° to {highest_deg:.1f}° does not cross the gravity "
            "peak, which is extrapolated to {peak_deg:.1f}°; the arg-max of the paper is not valid "
            "there")},

      // The equation that was fitted to a sweep.
      {"sweep_fit.constant_speed", text("T = offset of each direction + G cos(q − q_peak)")},
      {"sweep_fit.constant_speed_without_gravity", text("T = offset of each direction")},
      {"sweep_fit.varying_speed_without_gravity",
       text("T = offset + Coulomb sgn(q̇) + viscous q̇ + inertia q̈")},
      {"gravity.stated_none", text("the manifest states that there is no gravity to find")},
      {"sweep_fit.constant_speed_known_gravity",
       text("T = offset of each direction + G cos(q − q_peak), G from the rough sweep")},
      {"sweep_fit.varying_speed",
       text("T = offset + Coulomb sgn(q̇) + viscous q̇ + inertia q̈ + G cos(q − q_peak)")},
      {"sweep_fit.varying_speed_known_gravity",
       text("T = offset + Coulomb sgn(q̇) + viscous q̇ + inertia q̈ + G cos(q − q_peak), G from "
            "the rough sweep")},

      // Gravity from the runs at constant speed.
  };
  return all;
}

}  // namespace tribolog::wording
