#pragma once
// Resampling the oscillation: whole cycles, the same ones for everything that is read from the
// loop, so that estimates of the same cycles stay as alike as they are.

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "simulate/random_stream.h"
#include "stages/hysteresis_loop.h"

namespace tribolog::bootstrap {

/// What one draw of cycles, and of the ripple at the loop's position, does to the results.
struct LoopShift {
  double midline_Nm{};
  std::array<double, 6> points_Nm{};  ///< A to F as the paper reads them, from the first strokes.
  std::array<double, 6> steady_points_Nm{};  ///< A to F of the steady loop.
  std::array<double, 6> angle_rad{};         ///< Of A to F as the paper reads them.
  Eigen::VectorXd lugre;                     ///< Of the loop fit's parameters; empty without a fit.
};

class LoopResampler {
 public:
  /// @param hysteresis must outlive the resampler.
  LoopResampler(const HysteresisResult& hysteresis, const Ripple& ripple);
  [[nodiscard]] LoopShift draw(RandomStream& random) const;

 private:
  [[nodiscard]] double draw_ripple(RandomStream& random) const;
  void draw_angles(RandomStream& random, LoopShift& shift) const;

  const HysteresisResult& hysteresis_;
  Ripple ripple_;
  std::size_t cycles_{};                      // the start-up cycle first
  std::array<std::vector<double>, 6> turns_;  // readings by point, in the order of the cycles
  Eigen::MatrixXd lugre_shifts_;              // one column for each cycle
};

}  // namespace tribolog::bootstrap
