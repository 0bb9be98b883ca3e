#pragma once
// What a joint did over time: where it turns, stands, and moves one way.

#include <cstddef>
#include <optional>
#include <vector>

namespace tribolog::inspect::motion {

struct AngleTrace {
  std::vector<double> t_s;    ///< Strictly increasing.
  std::vector<double> q_rad;  ///< Angle; no gaps.
  /// Torque or current in any unit, of the same length, without gaps; empty: none was recorded.
  std::vector<double> effort;

  [[nodiscard]] std::size_t size() const { return t_s.size(); }
};

// Where a signal turns, smaller wiggles passed over.

/// Indices of the alternating extremes within [first, last] that differ by `threshold` (> 0) or
/// more from their neighbours in the list. Empty where the signal stays within the threshold.
std::vector<std::size_t> turning_points(const std::vector<double>& signal, std::size_t first,
                                        std::size_t last, double threshold);

// Where a signal first stands still, or last stood still.

struct QuietSearch {
  std::size_t from{};  ///< First sample looked at.
  std::size_t to{};    ///< Last one, >= from.
  double window_s{};   ///< How long it has to stand, > 0.
  double tolerance{};  ///< Largest spread of the signal meanwhile.
};

/// First sample of the first window within which the signal stands; nothing: it never does.
std::optional<std::size_t> first_quiet(const std::vector<double>& t_s,
                                       const std::vector<double>& signal,
                                       const QuietSearch& search);

/// Last sample of the last such window.
std::optional<std::size_t> last_quiet(const std::vector<double>& t_s,
                                      const std::vector<double>& signal, const QuietSearch& search);

// One direction of a motion between two turning points.

/// The angle counted from its start, in its direction: it rises from 0 to its travel, but for
/// wiggles.
class TravelBetweenTurns {
 public:
  TravelBetweenTurns(const AngleTrace& trace, std::size_t first, std::size_t last);

  [[nodiscard]] std::size_t first() const { return first_; }
  [[nodiscard]] std::size_t last() const { return last_; }
  [[nodiscard]] double travel_rad() const { return at(last_); }
  [[nodiscard]] double at(std::size_t i) const {
    return sign_ * (trace_->q_rad[i] - trace_->q_rad[first_]);
  }

  /// Largest fall behind the furthest point so far.
  [[nodiscard]] double largest_wiggle_rad() const;
  /// Samples at which it first reaches 0, 1, 2 ... bands; the last one is its end.
  [[nodiscard]] std::vector<std::size_t> passages(double band_rad) const;

 private:
  const AngleTrace* trace_;
  std::size_t first_;
  std::size_t last_;
  double sign_;
};

// Below which change a signal's samples cannot be told from one another.

/// The larger of three of the signal's steps (an encoder's, or of the decimals it was printed with)
/// and five standard deviations of its white noise. Noise is what third differences leave in the
/// quietest quarter of the signal; where neighbouring differences agree in sign there, these show
/// curved motion, and count for no more than 1e-4 of the signal's range. 0 for fewer than four
/// samples.
double noise_floor(const std::vector<double>& signal);

}  // namespace tribolog::inspect::motion
