#pragma once
// The arm as gravity sees it, and what is stated about gravity beforehand.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "joint/recording.h"

namespace tribolog::joint {

/// Gravity torque at the joint: `m g r cos(q - q_peak)`, eq. (9) with q_peak = -q_c.
class GravityLoad {
 public:
  /// @param mass_kg > 0 @param distance_m > 0 (axis to centre of gravity)
  /// @param q_peak_rad joint angle at which the centre of gravity is horizontal.
  /// @throw Refusal stating the value and the rule.
  GravityLoad(double mass_kg, double distance_m, double q_peak_rad, double gravity_m_s2 = 9.81);

  [[nodiscard]] double mass_kg() const { return mass_kg_; }
  [[nodiscard]] double distance_m() const { return distance_m_; }
  [[nodiscard]] double q_peak_rad() const { return q_peak_rad_; }
  [[nodiscard]] double gravity_m_s2() const { return gravity_m_s2_; }
  /// Largest gravity torque m g r at the joint [N·m].
  [[nodiscard]] double amplitude_Nm() const;
  /// Gravity torque at the joint [N·m].
  [[nodiscard]] double torque_Nm(double q_rad) const;

 private:
  double mass_kg_;
  double distance_m_;
  double q_peak_rad_;
  double gravity_m_s2_;
};

/// Surrogate mass [kg] that asks the motor-side torque `torque_Nm` at joint angle `q_rad`,
/// eq. (12) as corrected: m = n T / (g r cos(q - q_peak)).
double surrogate_mass_kg(double torque_Nm, double gear_ratio, double surrogate_distance_m,
                         double gravity_m_s2, double cos_from_peak);

// What the user states about gravity beforehand: further loads of the joint, and the joint's own.

/// A load that follows other angles than the tested joint's alone, as that of a second link:
/// torque at the joint = amplitude cos(sum of the angles + phase). It is subtracted when reading,
/// so that what is left is friction and the single cosine of the joint's own gravity.
struct KnownLoad {
  double amplitude_Nm{};            ///< Joint side, != 0.
  std::vector<std::string> angles;  ///< Columns of the log, one or more.
  double radian_per_unit{1.0};      ///< Of those columns.
  double phase_rad{};
  std::vector<Role> roles;  ///< Of the recordings that it loads; empty: all.
  std::string note;
  std::string stated_at;  ///< "dataset.toml:14", for messages.

  std::size_t samples{};  ///< From which it was subtracted; counted when reading.
  double largest_Nm{};    ///< Largest size subtracted, joint side.

  [[nodiscard]] bool loads(Role role) const;
  /// @param angle_sum_rad of the columns. @return torque at the joint [N·m].
  [[nodiscard]] double torque_Nm(double angle_sum_rad) const;
};

/// Gravity of the joint known beforehand, as from its design: a candidate beside those identified,
/// by which nothing is identified; a check holds the found one against it.
class StatedGravity {
 public:
  /// @param amplitude_Nm >= 0, joint side; 0: the joint has none. @param q_peak_rad joint angle at
  /// which it is largest. @param percent of the amplitude, half width at 95 %: cables and covers
  /// are in no design.
  /// @throw Refusal stating the value and the rule.
  StatedGravity(double amplitude_Nm, double q_peak_rad, double percent = usual_percent);
  static constexpr double usual_percent = 10;

  [[nodiscard]] double amplitude_Nm() const { return amplitude_Nm_; }
  [[nodiscard]] double q_peak_rad() const { return q_peak_rad_; }
  [[nodiscard]] double percent() const { return percent_; }

 private:
  double amplitude_Nm_;
  double q_peak_rad_;
  double percent_;
};

}  // namespace tribolog::joint
