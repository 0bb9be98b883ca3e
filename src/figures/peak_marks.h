#pragma once
// The gravity peak on a torque curve: the largest torque (the paper's way) and the fitted vertex.

#include <string>

#include "method/gravity/cog_sweep.h"
#include "render/figure/figure.h"
#include "wording/axis_scale.h"

namespace tribolog::figures {

/// The arg-max as a labelled point, with a bar over the angles that noise cannot tell from it.
void add_argmax(render::Panel& panel, const CogSweepResult& sweep, const AxisScale& torque);

/// The fitted q_peak as a vertical line; its interval as a band where it is wide enough to see.
/// @param torques what the panel shows: the height of the band.
void add_peak(render::Panel& panel, const CogSweepResult& sweep, const Extent& torques,
              const AxisScale& torque);

/// "the largest torque, 4.77 N·m, stands at −22.2° (noise allows −22.9° to −21.6°)"
std::string argmax_words(const CogSweepResult& sweep);

}  // namespace tribolog::figures
