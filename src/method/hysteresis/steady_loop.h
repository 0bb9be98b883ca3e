#pragma once
// The steady loop of an oscillation in few points, for storing and drawing.

#include <cstddef>
#include <optional>
#include <vector>

#include "method/hysteresis/hysteresis_loop.h"

namespace tribolog::method::hysteresis {

/// In the order of time; closed where it is the mean of whole cycles.
struct SteadyLoop {
  double centre_rad{};                  ///< Joint.
  std::vector<double> from_centre_rad;  ///< Joint angle less the centre: a micro-oscillation needs
                                        ///< all its digits.
  std::vector<double> torque_Nm;        ///< Motor side.
};

/// The mean of the steady cycles over their phase; for a loop without a period, or with one cycle,
/// its last cycle, thinned out.
/// @param most_points at least 3. @return nothing where trace or loop has fewer than three points,
/// or there is no duration or frequency.
std::optional<SteadyLoop> steady_loop(const LoopTrace& trace, const Oscillation& oscillation,
                                      std::size_t most_points);

}  // namespace tribolog::method::hysteresis
