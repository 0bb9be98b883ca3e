#pragma once
// The derivative of a signal that is differentiated, as speed from the angle: the one filter that
// all stages which need a speed from sample to sample share.
//
//   y'(i) = (mean of the h samples from i on - mean of the h samples before i) / distance of their
//           mean times
//
// At even sampling dt that is the derivative of the signal smoothed by a triangle 2 h samples wide:
// its gain is sinc^2(f h dt) of a true derivative's, without phase. Steps of the encoder and white
// noise are averaged h times on either side. At the ends of a recording the windows are shorter.

#include <cstddef>
#include <vector>

namespace tribolog::statistics {

/// h for a recording of so many samples: a five-hundredth of it on both sides together, at least 3.
std::size_t half_window_of_slope(std::size_t samples);

/// @param t strictly rising. @param y of the same size. @param h >= 1.
/// @return as many values; 0 where there is but one sample.
std::vector<double> local_slope(const std::vector<double>& t, const std::vector<double>& y,
                                std::size_t h);

/// Where the gain has fallen to 1/sqrt(2) (-3 dB) [Hz].
/// @param interval_s between samples, > 0.
double cut_off_of_slope_Hz(std::size_t h, double interval_s);

}  // namespace tribolog::statistics
