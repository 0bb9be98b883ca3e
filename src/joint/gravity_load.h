#pragma once
// The arm as gravity sees it: one mass at one distance from the joint's axis.

namespace tribolog {

/// Gravity torque at the joint: `m g r cos(q - q_peak)`, eq. (9) with q_peak = -q_c.
class GravityLoad {
 public:
  /// @param mass_kg > 0 @param distance_m > 0 (axis to centre of gravity)
  /// @param q_peak_rad joint angle at which the centre of gravity is horizontal.
  /// @throw std::invalid_argument quoting the value and the rule.
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

}  // namespace tribolog
