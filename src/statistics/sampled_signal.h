#pragma once
// What stages ask of a signal, sample by sample: its white noise, its slope, and where it first
// gets somewhere.

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace tribolog::statistics {

// White noise of a signal from the third differences of neighbouring samples, in which everything
// slower than a few samples drops out: a parabola leaves none, white noise stays 20 times over.

/// Standard deviation of normal noise by the median of its sizes.
inline constexpr double normal_sd_by_median_size = 1.4826;

/// y3 - 3 y2 + 3 y1 - y0 of four neighbours.
double third_difference(const double* four_neighbours);

/// Those of a whole signal: three fewer than it has samples, none of a shorter one.
std::vector<double> third_differences(const std::vector<double>& signal);

/// Variance of the white noise by the mean square of third differences, on which jumps weigh; 0 of
/// none.
double white_variance(const std::vector<double>& third_differences);

/// Standard deviation of the white noise by the median of third differences, which passes over rare
/// jumps; 0 of none.
double white_sd_beside_jumps(std::vector<double> third_differences);

// The derivative of a signal that is differentiated, as speed from the angle: the one filter that
// all stages which need a speed from sample to sample share.
//
//   y'(i) = (mean of the h samples from i on - mean of the h samples before i) / distance of their
//           mean times
//
// At even sampling dt that is the derivative of the signal smoothed by a triangle 2 h samples wide:
// its gain is sinc^2(f h dt) of a true derivative's, without phase. Steps of the encoder and white
// noise are averaged h times on either side. At the ends of a recording the windows are shorter.

/// h for a recording of so many samples: a five-hundredth of it on both sides together, at least 3.
std::size_t half_window_of_slope(std::size_t samples);

/// @param t strictly rising. @param y of the same size. @param h >= 1.
/// @return as many values; 0 where there is but one sample.
std::vector<double> local_slope(const std::vector<double>& t, const std::vector<double>& y,
                                std::size_t h);

/// Where the gain has fallen to 1/sqrt(2) (-3 dB) [Hz].
/// @param interval_s between samples, > 0.
double cut_off_of_slope_Hz(std::size_t h, double interval_s);

// Where a long signal first gets somewhere, without looking at every sample on the way.

/// The largest values of a signal over stretches, over stretches of stretches, and so on.
class Summits {
 public:
  explicit Summits(std::vector<double> signal) {
    levels_.push_back(std::move(signal));
    while (levels_.back().size() > fan) {
      std::vector<double> largest;
      const std::vector<double>& below = levels_.back();
      for (std::size_t i = 0; i < below.size(); i += fan) {
        const auto first = below.begin() + static_cast<std::ptrdiff_t>(i);
        const auto size = static_cast<std::ptrdiff_t>(std::min(fan, below.size() - i));
        largest.push_back(*std::max_element(first, first + size));
      }
      levels_.push_back(std::move(largest));
    }
  }

  [[nodiscard]] const std::vector<double>& signal() const { return levels_.front(); }

  /// The first sample from `from` on of which `reached` holds, or the signal's size. Asks it of
  /// some 32 log16(size) values at most.
  /// @param reached whether a value is enough; holds of every larger value too.
  template <class Reached>
  [[nodiscard]] std::size_t first(std::size_t from, Reached reached) const {
    std::size_t level = 0;
    std::size_t i = from;
    while (i < levels_[level].size()) {
      if (reached(levels_[level][i])) {
        if (level == 0) return i;
        --level;
        i *= fan;
        continue;
      }
      ++i;
      while (i % fan == 0 && level + 1 < levels_.size()) {
        ++level;
        i /= fan;
      }
    }
    return signal().size();
  }

 private:
  static constexpr std::size_t fan = 16;
  std::vector<std::vector<double>> levels_;  // the signal first
};

}  // namespace tribolog::statistics
