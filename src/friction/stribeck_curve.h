#pragma once
// The part of friction that falls from break-away to Coulomb torque as speed grows.

#include "friction/named_parameters.h"

namespace tribolog {

/// s(w) = Tc + (Ts - Tc) exp(-(|w|/ws)^d): what eq. (1) and (5) and every model after LuGre share.
class StribeckCurve {
 public:
  struct Parameters {
    double coulomb_Nm{};               ///< Tc > 0
    double static_Nm{};                ///< Ts >= Tc, break-away torque
    double stribeck_speed_rad_s{1.0};  ///< ws > 0
    double power{2.0};                 ///< d > 0
    ParameterSlots by_name();
  };

  /// @throw std::invalid_argument quoting the value and the rule.
  explicit StribeckCurve(const Parameters& parameters);

  [[nodiscard]] const Parameters& parameters() const { return p_; }
  /// s(|w|) [N·m], between Tc and Ts.
  [[nodiscard]] double operator()(double speed_rad_s) const;

 private:
  Parameters p_;
};

}  // namespace tribolog
