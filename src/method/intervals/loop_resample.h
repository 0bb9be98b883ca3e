#pragma once
// Resampling the oscillations. With one loop: whole cycles, the same ones for everything that is
// read from it, so that estimates from the same cycles stay correlated. With several loops: the
// positions' scatter, common to mid-line and fit as far as their positions' residuals are
// correlated, and for the fit's parameters its own blocks.

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "method/hysteresis/hysteresis_loop.h"
#include "statistics/random_stream.h"

namespace tribolog::method::intervals {

/// Shifts of the results by one draw of cycles, and of the ripple at the loop's position.
struct LoopShift {
  double midline_Nm{};
  std::array<double, 6> points_Nm{};  ///< A to F as the paper reads them, from the first strokes.
  std::array<double, 6> steady_points_Nm{};  ///< A to F of the steady loop.
  std::array<double, 6> angle_rad{};         ///< Of A to F as the paper reads them.
  double fit_gravity_Nm{};                   ///< Of the loop fit's gravity, at the peak.
  /// Of the loop fit's readings, or of their logarithms (LinearisedFit::readings); empty without a
  /// fit.
  std::vector<double> lugre;
};

class LoopResampler {
 public:
  /// @param loop must outlive the resampler.
  LoopResampler(const hysteresis::Hysteresis& loop, const gravity::Ripple& ripple);
  [[nodiscard]] LoopShift draw(statistics::RandomStream& random) const;

 private:
  [[nodiscard]] double draw_ripple(statistics::RandomStream& random) const;
  void prepare_fit();
  void draw_gravity(statistics::RandomStream& random, const std::vector<double>& counts,
                    double scale, double ripple_Nm, LoopShift& shift) const;
  void draw_points(statistics::RandomStream& random, const std::vector<double>& counts,
                   double scale, double ripple_Nm, LoopShift& shift) const;
  void draw_fit(statistics::RandomStream& random, const std::vector<double>& counts, double scale,
                LoopShift& shift) const;
  void draw_angles(statistics::RandomStream& random, LoopShift& shift) const;

  const hysteresis::Hysteresis& loop_;
  const hysteresis::HysteresisResult& hysteresis_;
  gravity::Ripple ripple_;
  std::size_t cycles_{};                      // the start-up cycle first
  std::array<std::vector<double>, 6> turns_;  // readings by point, in the order of the cycles
  bool fit_by_cycles_{false};                 // else by the fit's own blocks
  Eigen::MatrixXd reading_shifts_;            // one row for each reading, one column for each block
  Eigen::MatrixXd further_shifts_;            // errors beside the blocks, one row for each reading
  std::vector<double> reading_freedom_;
  Eigen::RowVectorXd gravity_shifts_;  // of the fit's gravity where it is by cycles
  double position_correlation_{0};     // of the mid-lines' scatter and that of the fit
  // Of ln(Ts) and ln(s0) among the readings; both or none.
  std::optional<std::pair<std::size_t, std::size_t>> reach_;
};

}  // namespace tribolog::method::intervals
