#pragma once
// Friction folded: size over size of motor speed, so that the two directions lie on each other.
// Signed along the motion: friction that would drive the joint shows as negative.

#include <string>

#include "calibration/calibration.h"
#include "render/figure/figure.h"
#include "wording/axis_scale.h"

namespace tribolog::figures {

/// Both directions of an estimator's curve as markers; the recommended one with the 95 % bars of
/// its runs that are longer than a marker. Nothing if there is no such curve.
void add_folded_curve(render::Panel& panel, const Calibration& calibration,
                      const std::string& estimator, const AxisScale& scale, bool recommended);

/// The reference over these speeds (sizes).
void add_folded_reference(render::Panel& panel, const Calibration& calibration,
                          const Extent& speeds, const AxisScale& scale);

/// The laws of stage 8, where they were fitted. A logarithmic x axis must have its minimum set.
void add_fitted_laws(render::Panel& panel, const FrictionParametersResult& friction,
                     const AxisScale& scale);

}  // namespace tribolog::figures
