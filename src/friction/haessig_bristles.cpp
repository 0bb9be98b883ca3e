// The bristle model of Haessig and Friedland (1990): many elastic bonds that snap and form anew.
//
//   T = sum over N bonds of (s0/N) di,     ddi/dt = w while |di| < ds
//
// A bond that is stretched to ds snaps; a new one forms at a random place, with a deflection
// equally likely anywhere between -ds and ds. The Coulomb torque of steady sliding is therefore s0
// ds/3 on average, and the torque scatters about it as 1/sqrt(N). The places are derived from a
// counter: the same seed and motion give the same torque.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/requirements.h"
#include "base/statement.h"
#include "friction/friction_model.h"
#include "friction/model_entry.h"

namespace tribolog::friction {
namespace {

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

/// Uniform in [0, 1): SplitMix64's finaliser over a counter.
double share_of(std::uint64_t seed, std::uint64_t bristle, std::uint64_t snaps) {
  std::uint64_t x = seed * 0x9E3779B97F4A7C15ULL + bristle * 0xD1B54A32D192ED03ULL + snaps;
  x = (x + 0x9E3779B97F4A7C15ULL) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27U)) * 0x94D049BB133111EBULL;
  return static_cast<double>((x ^ (x >> 31U)) >> 11U) * 0x1p-53;
}

ParameterSlots HaessigBristleFriction::Parameters::by_name() {
  return {{"stiffness_Nm_rad", &stiffness_Nm_rad},
          {"snap_deflection_rad", &snap_deflection_rad},
          {"bristles", &bristles, true},
          {"viscous_Nms_rad", &viscous_Nms_rad},
          {"seed", &seed, true}};
}

HaessigBristleFriction::HaessigBristleFriction(const Parameters& parameters) : p_(parameters) {
  require_positive(p_.stiffness_Nm_rad, "stiffness", "N·m/rad");
  require_positive(p_.snap_deflection_rad, Code{"parameter.snap_deflection"}, "rad");
  require_not_negative(p_.viscous_Nms_rad, "viscous coefficient", "N·m·s/rad");
  if (p_.bristles < 1 || p_.bristles > most_bristles) {
    throw Refusal({"haessig_bristles.number_not_allowed",
                   {{"bristles", p_.bristles}, {"most", most_bristles}}});
  }
}

std::size_t HaessigBristleFriction::states() const { return 2 * p_.bristles; }

std::vector<double> HaessigBristleFriction::unloaded() const {
  std::vector<double> state(states(), 0.0);
  const auto n = static_cast<double>(p_.bristles);
  for (std::size_t i = 0; i < p_.bristles; ++i) {
    const double share = (2.0 * static_cast<double>(i) + 1) / n - 1;
    state[i] = share * p_.snap_deflection_rad;
  }
  return state;
}

double HaessigBristleFriction::new_deflection_rad(std::size_t bristle, double snaps) const {
  const double share = share_of(p_.seed, bristle, static_cast<std::uint64_t>(snaps));
  return (2 * share - 1) * p_.snap_deflection_rad;
}

void HaessigBristleFriction::rates(std::span<const double> state, double speed_rad_s,
                                   std::span<double> rates) const {
  const std::size_t n = state.size() / 2;
  for (std::size_t i = 0; i < n; ++i) {
    rates[i] = speed_rad_s;
    rates[n + i] = 0;
  }
}

void HaessigBristleFriction::settle(std::span<double> state, double /*speed_rad_s*/) const {
  const std::size_t n = state.size() / 2;
  for (std::size_t i = 0; i < n; ++i) {
    if (std::abs(state[i]) >= p_.snap_deflection_rad) {
      state[n + i] += 1;
      state[i] = new_deflection_rad(i, state[n + i]);
    }
  }
}

double HaessigBristleFriction::torque_Nm(std::span<const double> state, double speed_rad_s) const {
  const std::size_t n = state.size() / 2;
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += state[i];
  return p_.stiffness_Nm_rad * sum / static_cast<double>(n) + p_.viscous_Nms_rad * speed_rad_s;
}

double HaessigBristleFriction::steady_torque_Nm(double speed_rad_s) const {
  const double sign = direction_of(speed_rad_s);
  return sign * p_.stiffness_Nm_rad * p_.snap_deflection_rad / 3 + p_.viscous_Nms_rad * speed_rad_s;
}

void HaessigBristleFriction::advance(std::span<double> state, const SpeedStep& step) const {
  const double direction = step.direction();
  const double snap = p_.snap_deflection_rad;
  const std::size_t n = state.size() / 2;
  const double way = std::abs(step.path_rad());
  for (std::size_t i = 0; i < n; ++i) {
    double left = way;
    double d = direction * state[i];
    while (d + left >= snap && direction != 0.0) {
      left -= snap - d;
      state[n + i] += 1;
      d = direction * new_deflection_rad(i, state[n + i]);
    }
    state[i] = direction == 0.0 ? state[i] : direction * (d + left);
  }
}

void HaessigBristleFriction::state_scales(std::span<double> scales) const {
  const std::size_t n = scales.size() / 2;
  for (std::size_t i = 0; i < n; ++i) {
    scales[i] = p_.snap_deflection_rad;
    scales[n + i] = 1;
  }
}

void HaessigBristleFriction::event_values(std::span<const double> state, double /*speed_rad_s*/,
                                          std::span<double> values) const {
  double farthest = 0;
  for (const double d : state.first(state.size() / 2)) farthest = std::max(farthest, std::abs(d));
  values[0] = farthest - p_.snap_deflection_rad;
}

/// Its stiffness appears over the bonds' average stretch, its Coulomb torque is a third of what all
/// of them could carry.
HaessigBristleFriction::Parameters haessig_bristles(const ContactParameters& c) {
  return {c.stiffness_Nm_rad, 3 * c.coulomb_Nm / c.stiffness_Nm_rad, 500, c.viscous_Nms_rad, 1};
}

}  // namespace

FrictionModelEntry haessig_bristles_model() {
  return model<HaessigBristleFriction>(
      {.presliding = true, .rate_independent = true, .is_random = true}, haessig_bristles);
}

}  // namespace tribolog::friction
