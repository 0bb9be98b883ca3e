#pragma once
// Angles that are logged modulo a period: an encoder's turn, or the range of a field in a drive's
// message (+-12.5 rad is a usual one).
//
// The joint goes on through a jump from one end of the range to the other: samples before and
// behind it move by little, the clock goes on, and all jumps are by the same period. That period is
// a number of turns, or, of a range about zero or from zero on, a round number. A log in which the
// joint starts again at the other end, or one damaged sample, has no such jumps.

#include <cstddef>
#include <optional>
#include <vector>

namespace tribolog::joint {

struct AngleWraps {
  double period{};  ///< In the angle's unit.
  struct Jump {
    std::size_t sample{};  ///< The first behind it.
    bool is_up{};          ///< The logged angle rises; the joint's falls.
  };
  std::vector<Jump> jumps;  ///< In the order of the samples; not empty.
};

/// @param time, angle of the same length and of any unit; gaps (nan) are passed over.
/// @param turns that a wrap may be a whole number of, in the angle's unit: of the joint, of the
///        motor.
/// @return nothing where the angle does not wrap round, or where no period is certain.
std::optional<AngleWraps> find_wraps(const std::vector<double>& time,
                                     const std::vector<double>& angle,
                                     const std::vector<double>& turns);

/// The angle going on through the jumps, from where it begins.
std::vector<double> unwrapped(std::vector<double> angle, const AngleWraps& wraps);

}  // namespace tribolog::joint
