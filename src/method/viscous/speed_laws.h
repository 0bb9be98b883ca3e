#pragma once
// Internal to the viscous stage: the laws of law_scan.h against one set of speeds, the scatter
// between speeds at which they describe these, and the speeds that are inconsistent with the
// others.

#include <cstddef>
#include <optional>
#include <vector>

#include "method/viscous/law_scan.h"
#include "method/viscous/sliding_law.h"
#include "method/viscous/speed_means.h"

namespace tribolog::method::viscous {

inline constexpr double line_parameters = 2;
inline constexpr double dip_parameters = 4;
inline constexpr std::size_t speeds_tried = 40;

/// That of the smallest chi2; null: there are none.
const LawPoint* best_of(const std::vector<LawPoint>& points);

/// Laws against one set of speeds.
class SpeedLaws {
 public:
  SpeedLaws(std::vector<SpeedMean> means, bool load);

  /// All speeds ws, at the present d and p.
  [[nodiscard]] LawGrid whole_grid() const;
  void set_shape(double exponent, double power) {
    exponent_ = exponent;
    power_ = power;
  }
  [[nodiscard]] double freedom(double parameters) const {
    return static_cast<double>(means_.size()) - parameters - (load_ ? 1 : 0);
  }
  /// Lines of these powers; of bent ones those that a joint can have: where Coulomb torque is not
  /// negative.
  [[nodiscard]] std::vector<LawPoint> possible_lines(const std::vector<double>& powers) const;
  [[nodiscard]] LawPoint line(double power = 1) const {
    return line_at(means_, scatter2_, power, load_);
  }
  [[nodiscard]] std::vector<LawPoint> scan(const LawGrid& grid) const {
    return scan_laws(means_, scatter2_, grid, speeds_tried);
  }
  /// The best law at d and p; the line where none is better.
  [[nodiscard]] LawPoint best() const;
  /// By successively finer scans.
  [[nodiscard]] std::optional<LawPoint> best_law(LawGrid grid) const;
  [[nodiscard]] bool can_dip() const { return freedom(dip_parameters) >= 2; }
  [[nodiscard]] double best_freedom() const {
    return freedom(can_dip() ? dip_parameters : line_parameters);
  }
  [[nodiscard]] double scatter2() const { return scatter2_; }
  [[nodiscard]] double slowest() const { return slowest_; }
  [[nodiscard]] double fastest() const { return fastest_; }
  [[nodiscard]] double largest() const { return largest_; }
  [[nodiscard]] const std::vector<SpeedMean>& means() const { return means_; }

  /// Scatter between speeds at which the best law's chi2 equals its degrees of freedom.
  void find_scatter();
  void set_scatter2(double scatter2) { scatter2_ = scatter2; }

 private:
  std::vector<SpeedMean> means_;
  bool load_{};
  double slowest_{}, fastest_{}, largest_{};
  double exponent_{2}, power_{1};
  double scatter2_{};
};

/// Scatter between speeds of the directions' difference, squared, beyond the scatter within the
/// runs. A difference that is constant (gravity, offset), a share of the friction or proportional
/// to the speed is no scatter. 0 if none is significant beyond `scatter2`.
double direction_scatter2(const std::vector<FrictionAtSpeed>& speeds, double scatter2,
                          double freedom_of_scatter);

/// Removes speeds that are inconsistent with the others, the farthest first.
std::vector<StrayFriction> without_strays(std::vector<FrictionAtSpeed>& speeds, bool load);

}  // namespace tribolog::method::viscous
