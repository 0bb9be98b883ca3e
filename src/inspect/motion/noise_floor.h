#pragma once
// Below which change a signal's samples cannot be told from one another.

#include <vector>

namespace tribolog::inspect::motion {

/// The larger of three of the signal's steps (an encoder's, or of the decimals it was printed with)
/// and five standard deviations of its white noise. Noise is what third differences leave in the
/// quietest quarter of the signal; where neighbouring differences agree in sign there, these show
/// curved motion, and count for no more than 1e-4 of the signal's range. 0 for fewer than four
/// samples.
double noise_floor(const std::vector<double>& signal);

}  // namespace tribolog::inspect::motion
