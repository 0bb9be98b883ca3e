#pragma once
// What stages need from a sampled signal: its white noise, its slope, and where it first reaches a
// value.

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace tribolog::statistics {

// White noise of a signal from the third differences of neighbouring samples, in which everything
// slower than a few samples drops out: a parabola leaves nothing, white noise 20 times its
// variance.

/// Standard deviation of normal noise over the median of its magnitudes.
inline constexpr double normal_sd_by_median_size = 1.4826;

/// y3 - 3 y2 + 3 y1 - y0 of four neighbours.
double third_difference(const double* four_neighbours);

/// Third differences of a whole signal: three fewer than it has samples, none if it has fewer than
/// four.
std::vector<double> third_differences(const std::vector<double>& signal);

/// Variance of the white noise from the mean square of third differences, which jumps enlarge; 0
/// without any.
double white_variance(const std::vector<double>& third_differences);

/// Standard deviation of the white noise from the median of third differences, which is robust
/// against rare jumps; 0 without any.
double white_sd_beside_jumps(std::vector<double> third_differences);

// The derivative of a sampled signal, such as speed from the angle: the one filter shared by all
// stages that need a speed at each sample.
//
//   y'(i) = (mean of the h samples from i on - mean of the h samples before i) / distance of their
//           mean times
//
// At uniform sampling dt that is the derivative of the signal smoothed by a triangle 2 h samples
// wide: its gain is sinc^2(f h dt) times a true derivative's, with zero phase. Encoder steps and
// white noise are averaged over h samples on either side. At the ends of a recording the windows
// are shorter.

/// h for a recording of so many samples: both sides together span a five-hundredth of it; at least
/// 3.
std::size_t half_window_of_slope(std::size_t samples);

/// @param t strictly rising. @param y of the same size. @param h >= 1.
/// @return as many values; 0 where there is only one sample.
std::vector<double> local_slope(const std::vector<double>& t, const std::vector<double>& y,
                                std::size_t h);

/// Its slope. The samples from i on lie half an interval later than i: a local slope is that of
/// half an interval before, and the slope of slopes that of a whole one, which is put right here.
/// @return as many values.
std::vector<double> local_curvature(const std::vector<double>& t, const std::vector<double>& y,
                                    std::size_t h);

/// Where the gain has fallen to 1/sqrt(2) (-3 dB) [Hz].
/// @param interval_s between samples, > 0.
double cut_off_of_slope_Hz(std::size_t h, double interval_s);

/// Puts a signal at an even distance behind a first-order low pass, exactly for one that runs along
/// straight lines between its samples. It has rested at its first value before.
/// @param time_constant in samples; 0: the signal stays as it is.
void low_pass(std::span<double> signal, double time_constant);

/// Puts in place of each sample the mean over the time that ends there, exactly for a signal that
/// runs along straight lines between its samples. It has rested at its first value before.
/// @param width of the window, in intervals between samples; 0: the signal stays as it is.
void moving_mean(std::span<double> signal, double width);

// Where a long signal first reaches a value, without visiting every sample before it.

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

  /// The first sample from `from` on for which `reached` holds, or the signal's size. Evaluates it
  /// for at most some 32 log16(size) values.
  /// @param reached whether a value is enough; holds for every larger value too.
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
