#pragma once
// Internal to the viscous stage: weighted least squares of a sliding law at every shape of a grid.

#include <cstddef>
#include <vector>

namespace tribolog::method::viscous {

/// Friction at one speed, mean of the directions.
struct SpeedMean {
  double speed_rad_s{};
  double friction_Nm{};
  double variance{};  ///< From the scatter within the runs [N²·m²].
  double load{};
};

/// One shape, and the linear parameters that fit best.
struct LawPoint {
  bool has_excess{};
  double speed_rad_s{};  ///< ws; then d and p. Without an excess only p counts.
  double exponent{2};
  double power{1};
  double coulomb_Nm{}, excess_Nm{}, slope{};  ///< Slope at the fastest speed.
  double load_Nm{};
  double coulomb_error{}, slope_error{};  ///< Standard errors, taking the variances as given.
  double chi2{};
};

/// Which shapes.
struct LawGrid {
  std::vector<double> exponents{2.0};
  std::vector<double> powers{1.0};
  bool load{false};
  double slowest_speed{};  ///< Of ws.
  double fastest_speed{};
};

/// The straight line, or the power law at a power. @param scatter2 is added to each variance
/// [N²·m²].
LawPoint line_at(const std::vector<SpeedMean>& means, double scatter2, double power, bool load);

/// The fits at all shapes of the grid that a joint can have: Coulomb torque, excess and slope not
/// negative.
std::vector<LawPoint> scan_laws(const std::vector<SpeedMean>& means, double scatter2,
                                const LawGrid& grid, std::size_t speeds);

}  // namespace tribolog::method::viscous
