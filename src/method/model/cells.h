#pragma once
// The rows of the model: means of torque, angle and their derivatives over the samples of one
// stroke in one bin of angle and one bin of speed.
//
// A stroke moves one way without stopping. One kernel smooths the torque, the cosine of the angle
// and the derivatives of the angle alike (a triangle of 4 h + 1 samples, or two means of 2 h + 1
// samples in succession), so that T = J q'' + g(q) + ... holds between the smoothed signals as
// between the signals, at corners of the speed too.

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "joint/recording.h"

namespace tribolog::method::model {

/// Torque and motion are the motor's, angle and its cosine are the joint's.
struct Cell {
  double torque_Nm{};
  double cos_q{};
  double sin_q{};
  double q_rad{};
  double speed_rad_s{};  ///< > 0; see direction.
  double acceleration_rad_s2{};
  double jerk_rad_s3{};
  double cos_rate{};   ///< d cos(q)/dt [1/s]
  double sin_rate{};   ///< d sin(q)/dt [1/s]
  double time_s{};     ///< Since the session began: recordings follow one another.
  double count{};      ///< Samples; 0: the row is no part of a fit.
  double direction{};  ///< +1: the angle rises; -1: it falls.
  /// Cosine and sine of the motor's angle, and of twice it: once and twice a turn.
  std::array<double, 4> motor{};
  double is_run{};      ///< 1: of a run at constant speed, or a point; 0: of a sweep.
  double has_place{1};  ///< 0: a point of the friction curve, which has no angle and no gravity.
  double scatter_Nm{};  ///< Of the samples about a line over time; NaN: too few of them.
  double interval_s{};  ///< Between samples.
  /// Of each other joint that moves: cos and sin of its angle, of q + its angle and q - its angle,
  /// and its acceleration [rad/s²].
  std::vector<double> others{};
  int stroke{};
  int recording{};  ///< Index among those given, points behind recordings.
};

inline constexpr std::size_t values_of_other = 7;

/// Where and when loops or ramps were recorded: a row of no samples for each recording.
struct Contacts {
  std::vector<Cell> loops;
  std::vector<Cell> ramps;
};

struct Cells {
  std::vector<Cell> rows;
  Contacts contacts;
  double gear_ratio{1};
  bool is_turning{};  ///< No gravity, and more than a turn: the angle counts modulo a turn.

  [[nodiscard]] bool empty() const { return rows.empty(); }
  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(rows.size()); }
  /// Other joints that move.
  [[nodiscard]] std::size_t others() const {
    return rows.empty() ? 0 : rows.front().others.size() / values_of_other;
  }
  /// Session times of the first and the last row or contact.
  [[nodiscard]] std::pair<double, double> session_s() const;
  /// One value of all rows.
  [[nodiscard]] Eigen::ArrayXd of(double Cell::* value) const;
  /// Those for which `keep` holds, with their strokes and recordings numbered as before.
  template <class Keep>
  [[nodiscard]] Cells select(Keep keep) const {
    Cells chosen;
    chosen.contacts = contacts;
    chosen.gear_ratio = gear_ratio;
    chosen.is_turning = is_turning;
    for (const Cell& row : rows) {
      if (keep(row)) chosen.rows.push_back(row);
    }
    return chosen;
  }
};

/// The value below which this share of them lies, 0 to 1: statistics::value_at_share().
double value_at_share(const Eigen::ArrayXd& values, double share);
/// statistics::median()
double median(const Eigen::ArrayXd& values);

/// From which on the friction of these cells is that of steady motion: next to where a sweep turns
/// round it is not.
double slowest_stated(const Cells& cells);

/// Gravity's two parts, offset, inertia, Coulomb and viscous torque, each per unit: what any joint
/// has, without an effect of the catalogue.
Eigen::MatrixXd plain_columns(const Cells& cells);

/// @param recordings sweeps and runs with a torque; of loops and ramps only place and time count.
/// @param points of the friction curve, each a row.
/// @param gear_ratio > 0. @param has_gravity false: the joint's axis is vertical, say.
/// @param lag_s by which the torque is known to be logged later than the angle; taken off.
Cells make_cells(const std::vector<const joint::Recording*>& recordings,
                 const std::vector<joint::FrictionPoints>& points, double gear_ratio,
                 bool has_gravity, double lag_s = 0);

}  // namespace tribolog::method::model
