// What belongs to no stage alone: how intervals were made, and what joins statements.

#include "wording/messages.h"

namespace tribolog::wording {

const Messages& general_messages() {
  static const Messages all{
      {"verbatim", values_alone("{words}")},
      {"setting.seed", text("Seed of the known-truth check")},
      {"setting.archived_as", text("Archived as")},
      {"general.together", values_alone("{parts:; }")},

      // Where an interval comes from.
      {"interval.stated", text("stated")},
      {"interval.known", text("known")},
      {"interval.one_reading", text("one reading")},
      {"interval.in_quadrature", text("independent intervals, in quadrature")},
      {"interval.largest_torque", text("paper's method: largest torque")},
      {"interval.largest_torque_at_end", text("paper's method; lies at the end of the sweep")},
      {"interval.put_in", text("simulated value")},
      {"interval.stated_in_manifest", text("stated in the manifest")},
      {"interval.last_three_against_reference", text("the last three against the reference")},
      {"interval.line_over_calibrations", text("straight line over all calibrations")},
      {"interval.least_squares_blocks", text("least squares, blocks of neighbouring samples")},
      {"interval.least_squares_known_amplitude",
       text("least squares with the amplitude of the rough sweep")},
      {"interval.widened_by_sweep_ripple",
       text("{interval}, widened by the ripple that the sweep shows")},
      {"interval.less_offset",
       text("{interval}, less the torque offset that sweeps and runs show, with its error")},
      {"interval.mean_over_angle",
       text("{interval}, mean over the angle as the motion has a second harmonic")},
      {"interval.with_type_b", text("{interval}, with what the manifest states of other errors")},
      {"interval.curve_fit", text("curve fit, scatter of the runs")},
      {"interval.scatter_of_cycles", text("scatter of the cycles")},
      {"interval.white_noise_only", text("white noise only: fewer than three steady cycles")},
      {"interval.lugre_fit_blocks", text("LuGre fit, blocks of half a cycle")},
      {"interval.scatter_of_ramps", text("scatter of the ramps")},
      {"interval.scatter_of_ramps_at_rest",
       text("scatter of the ramps' levels at rest, and what the readings differ from them")},
      {"interval.widened_by_loops", text("{interval}, widened to hold what the loops show")},
      {"interval.of_ramps_and_loops", text("ramps and the level of the loops together")},
      {"interval.scatter_of_ramps_both_directions", text("scatter of the ramps, both directions")},
      {"interval.scatter_of_strokes", text("scatter of the strokes")},
      {"interval.loop_fit_blocks", text("loop fit, blocks of half a cycle")},
      {"interval.scatter_of_positions_about_ripple",
       text("scatter of the positions about the ripple")},
      {"interval.scatter_of_positions", text("scatter of the positions")},
      {"interval.scatter_of_cycles_and_recordings",
       text("scatter of the cycles and of the recordings")},
      {"interval.scatter_of_half_cycles_and_recordings",
       text("scatter of the half cycles and of the recordings")}};
  return all;
}

}  // namespace tribolog::wording
