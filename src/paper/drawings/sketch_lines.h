#pragma once
// Lines that mechanical sketches are made of.

#include <vector>

#include "render/figure/diagram.h"

namespace tribolog::paper {

/// An elastic bristle, clamped at `root` and straight down (or up, if length is negative) when at
/// rest, whose tip is pushed sideways by `deflection`: the bending line of a cantilever.
std::vector<render::DiagramPoint> bent_bristle(render::DiagramPoint root, double length,
                                               double deflection);

/// Corners of an upright rectangle.
std::vector<render::DiagramPoint> upright_rectangle(double left, double top, double right,
                                                    double bottom);

}  // namespace tribolog::paper
