#pragma once
// The model behind the loop fit: LuGre under a known motion, with its derivatives.
//
//   T = G cos(q - q_peak) + s0 z + s1 dz/dt + s2 w + J dw/dt,    dz/dt = w - |w| z / g(w)
//   s0 g(w) = Ts (c + (1 - c) exp(-b w^2)),    c = Tc/Ts,    b = 1/ws^2
//
// One recording: G and the initial deflection are its own, all else is shared by the recordings of
// a joint. z depends on four numbers only: g at rest Ts/s0, c, b and its initial value; its
// derivatives with respect to them are carried through the exponential step as dual numbers. s1,
// s2, J and G enter linearly.
//
// At speeds far below ws only b (1 - c) shows, the curvature of g; b = 0 is the micro-speed limit,
// where the derivative with respect to b exists too.

#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "joint/recording.h"
#include "simulate/motion.h"

namespace tribolog::method::hysteresis {

/// The shared parameters as the fit varies them: positive ones as their logarithms.
struct LuGreShared {
  enum Index { log_stiffness, log_static, log_share, fall, damping, viscous, inertia };
  static constexpr int count = 7;
  using Vector = Eigen::Matrix<double, count, 1>;
  /// T_s/sigma0, the deflection in sliding at the lowest speeds: the largest that a bristle holds
  /// (eq. (4)) [rad].
  [[nodiscard]] static double largest_deflection_rad(const Vector& shared);
};

/// Those of one recording.
struct LuGreLocal {
  double gravity_Nm{};  ///< G, at the peak, motor side.
  double start_rad{};   ///< z at the first sample.
};

/// The sampling at which a recording is compared with the model.
struct LuGreGrain {
  std::size_t stride{1};          ///< Every `stride`-th sample is used; the others are skipped.
  std::size_t samples_in_row{1};  ///< Neighbours averaged before comparison, as is the model.
  std::size_t most_samples{std::numeric_limits<std::size_t>::max()};  ///< Counted from the first.
  /// Rows before are not compared: the drive starts the motion there [s since the first sample].
  double compared_from_s{0};
};

class LuGreLoopModel {
 public:
  /// Columns of the derivatives: G, start, then the shared ones in their order.
  static constexpr int local_count = 2;
  static constexpr int columns = local_count + LuGreShared::count;
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, columns>;

  /// @param motion of the motor shaft, by the time since the recording's first sample.
  /// @param grain how the samples are compared.
  LuGreLoopModel(const joint::Recording& recording, std::shared_ptr<const simulate::Motion> motion,
                 double gear_ratio, double q_peak_rad, const LuGreGrain& grain = {});

  /// One per sample, or per samples_in_row() samples.
  [[nodiscard]] Eigen::Index rows() const { return static_cast<Eigen::Index>(measured_Nm_.size()); }
  [[nodiscard]] std::size_t samples_in_row() const { return samples_in_row_; }
  /// Times of the rows since the first sample, and the torque measured there.
  [[nodiscard]] std::vector<double> row_times_s() const;
  [[nodiscard]] const simulate::Motion& motion() const { return *motion_; }
  /// Subtracts a torque from that measured at each row.
  void take_off(const Eigen::VectorXd& torque_Nm);
  /// Motor speed there, by the motion.
  [[nodiscard]] Eigen::VectorXd row_speeds_rad_s() const;
  [[nodiscard]] Eigen::VectorXd measured() const;
  /// Residuals T_model - T_measured, and their derivatives; zero in rows that are not compared.
  /// @param bends whether c and b are varied or b != 0; otherwise their columns stay zero and the
  /// micro-speed limit is integrated at half the cost.
  void evaluate(const LuGreShared::Vector& shared, const LuGreLocal& local, bool bends,
                Eigen::VectorXd& residuals, Rows& derivatives) const;
  /// Rows at the beginning that are not compared (LuGreGrain::compared_from_s).
  [[nodiscard]] Eigen::Index rows_left_out() const { return rows_left_out_; }
  /// Residuals alone, of all rows. @pre a row is a sample
  [[nodiscard]] Eigen::VectorXd residuals(const LuGreShared::Vector& shared,
                                          const LuGreLocal& local) const;
  /// z and dz/dt of the model at the samples. @pre a row is a sample
  void bristle(const LuGreShared::Vector& shared, double start_rad, std::vector<double>& z_rad,
               std::vector<double>& dz_rad_s) const;
  /// Motor speed at the samples, by the motion. @pre a row is a sample
  [[nodiscard]] const std::vector<double>& speed_rad_s() const { return speed_; }
  /// Largest motor speed [rad/s] where the model is evaluated.
  [[nodiscard]] double peak_speed_rad_s() const;
  /// Between the extremes of the motion [rad, motor].
  [[nodiscard]] double middle_rad() const;
  /// Half the distance between the extremes of the motion [rad, motor].
  [[nodiscard]] double motor_amplitude_rad() const;
  /// Largest minus smallest torque that is compared, without jumps [N·m].
  [[nodiscard]] double height_Nm() const;
  [[nodiscard]] double mean_torque_Nm() const;

 private:
  /// A piece of the motion between two instants in which the speed keeps its sign. It begins where
  /// the previous one ends.
  struct Piece {
    double end_s, middle_speed, end_speed;
    bool backward, ends_at_instant;
  };
  struct Together;
  [[nodiscard]] std::vector<Together> rows_of(const joint::Recording& recording,
                                              const LuGreGrain& grain) const;
  std::vector<double> look_at_samples(const joint::Recording& recording, const LuGreGrain& grain);
  std::vector<double> look_at_rows(const joint::Recording& recording, const LuGreGrain& grain);
  static void tell_smooth_rows(std::vector<Together>& rows);
  void add_instants(const std::vector<double>& times_s, double gear_ratio, double q_peak_rad);
  void add_ways(const std::vector<double>& instants);
  void add_way(double from_s, double to_s, double start_speed, double end_speed);
  template <class Scalar, class Deflection, class Visit>
  void run(const Deflection& g, const Scalar& start, Visit visit) const;
  template <int N>
  void evaluate_with(const LuGreShared::Vector& shared, const LuGreLocal& local,
                     Eigen::VectorXd& residuals, Rows& derivatives) const;

  std::shared_ptr<const simulate::Motion> motion_;
  std::size_t samples_in_row_;
  Eigen::Index rows_left_out_{0};
  [[nodiscard]] Eigen::Index row_of(Eigen::Index instant) const;
  void average_over_rows(Eigen::Ref<Eigen::VectorXd> column) const;

  std::vector<Piece> pieces_;
  std::vector<double> distance_rad_;  // of each piece
  // Where the model is evaluated: at each sample, or once in a row through which it is smooth.
  std::vector<double> angle_;
  std::vector<double> speed_;
  std::vector<double> acceleration_;
  std::vector<double> cosine_;
  std::vector<double> measured_Nm_;  // of each row
  std::vector<double> time_s_;       // of each instant
  bool starts_at_instant_{true};     // the first is that of the first sample
  double start_speed_{};             // at the first sample
  // Only where rows hold several samples:
  struct Row {
    double time_s;       // mean
    double variance_s2;  // of the times of its samples, where the model is looked at but once
    std::size_t instants;
  };
  std::vector<Row> row_;
  std::vector<Eigen::Index> row_of_instant_;
};

}  // namespace tribolog::method::hysteresis
