#pragma once
// The bristle model of Haessig and Friedland (1990): many elastic bonds that snap and form anew.
//
//   T = sum over N bonds of (s0/N) di,     ddi/dt = w while |di| < ds
//
// A bond that is stretched to ds snaps; a new one forms at a random place, with a deflection
// equally likely anywhere between -ds and ds. The Coulomb torque of steady sliding is therefore s0
// ds/3 on the average, and the torque scatters about it as 1/sqrt(N). The places come from a
// counter, not from a clock: the same seed and motion give the same torque.

#include <cstdint>

#include "friction/dynamic_friction.h"

namespace tribolog::friction {

/// State: d1 ... dN [rad], then how often each bond has snapped.
class HaessigBristleFriction final : public DynamicFriction {
 public:
  struct Parameters {
    double stiffness_Nm_rad{};     ///< s0 > 0, of all bonds together
    double snap_deflection_rad{};  ///< ds > 0
    std::uint64_t bristles{50};    ///< N, from 1 to most_bristles
    double viscous_Nms_rad{};      ///< >= 0; added to the torque
    std::uint64_t seed{1};
    ParameterSlots by_name();
  };

  /// Bounds memory and time.
  static constexpr std::uint64_t most_bristles = 100'000;

  /// @throw Refusal stating the value and the rule.
  explicit HaessigBristleFriction(const Parameters& parameters);

  [[nodiscard]] const Parameters& parameters() const { return p_; }
  [[nodiscard]] std::string name() const override { return "haessig_bristles"; }
  [[nodiscard]] NamedParameters named_parameters() const override { return named(p_); }
  [[nodiscard]] std::size_t states() const override;
  /// Deflections spread evenly between -ds and ds: no torque.
  [[nodiscard]] std::vector<double> unloaded() const override;
  void state_scales(std::span<double> scales) const override;
  /// One: how far the most stretched bond is beyond its limit.
  [[nodiscard]] std::size_t events() const override { return 1; }
  void event_values(std::span<const double> state, double speed_rad_s,
                    std::span<double> values) const override;
  void rates(std::span<const double> state, double speed_rad_s,
             std::span<double> rates) const override;
  /// Snaps the bonds that are stretched to the full.
  void settle(std::span<double> state, double speed_rad_s) const override;
  [[nodiscard]] double torque_Nm(std::span<const double> state, double speed_rad_s) const override;
  /// The average over many snaps.
  [[nodiscard]] double steady_torque_Nm(double speed_rad_s) const override;
  /// Exact, bond by bond.
  void advance(std::span<double> state, const SpeedStep& step) const override;

 private:
  [[nodiscard]] double new_deflection_rad(std::size_t bristle, double snaps) const;
  Parameters p_;
};

}  // namespace tribolog::friction
