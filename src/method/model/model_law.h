#pragma once
// The law of sliding friction over the speed that a joint's model finds likeliest, its likeliest
// candidate laws of other forms, and what all laws that its recordings do not exclude say of the
// Stribeck dip:
//
//   F(v) = level + rise (v / vmax)^power + bend (v / vmax)^2 + excess exp(-(v / ws)^d)

#include <optional>
#include <string_view>
#include <vector>

#include "base/statement.h"
#include "method/model/joint_model.h"
#include "statistics/estimate.h"

namespace tribolog::method::model {

/// Motor side, v > 0.
struct SpeedLaw {
  std::string_view family;  ///< FrictionLaw::family
  double fastest_rad_s{};   ///< vmax, of the speeds measured; 0: there is no law.
  double level_Nm{};        ///< Coulomb torque.
  double rise_Nm{};         ///< At the fastest speed.
  double power{1};          ///< Of the speed.
  double bend_Nm{};         ///< At the fastest speed.
  double excess_Nm{};       ///< At rest.
  double dip_rad_s{};       ///< ws; 0: the law has no dip.
  double dip_power{};       ///< d

  [[nodiscard]] bool empty() const { return fastest_rad_s == 0; }
  [[nodiscard]] double friction_Nm(double speed_rad_s) const;
  /// Of each speed.
  [[nodiscard]] std::vector<double> friction_Nm(const std::vector<double>& speed_rad_s) const;
};

/// The law's form, e.g. "Coulomb and viscous, with a Stribeck dip".
Statement described(const SpeedLaw& law);

/// The likeliest law of a form.
struct CandidateLaw {
  SpeedLaw law;
  double probability{};  ///< Of all laws of this form.
};

struct ModelLaw : SpeedLaw {
  std::vector<CandidateLaw> candidates;  ///< Likeliest form first.
  double slowest_rad_s{};                ///< Of the speeds measured.
  double lowest_power{};                 ///< Of the dip: what the laws together leave, 95 %.
  double highest_power{};
  double dip_probability{};   ///< Of all laws with a dip.
  double bend_probability{};  ///< Of all laws that are not linear in speed but for the dip.
  /// Speed at which the excess has fallen to 1/e; absent where a law without a dip is not excluded.
  std::optional<statistics::Estimate> stribeck_speed_rad_s;

  [[nodiscard]] bool has_dip() const { return stribeck_speed_rad_s.has_value(); }
  /// Beyond doubt no line, but for a dip.
  [[nodiscard]] bool bends() const;
  /// Whether the recordings show all five parameters of Waiboer's law, eq. (6): a dip, and a
  /// viscous torque out of proportion to the speed.
  [[nodiscard]] bool carries_waiboer() const;
  /// From the slowest to the fastest measured, as far apart in proportion.
  [[nodiscard]] std::vector<double> speeds_rad_s(int count) const;
};

/// @param model not empty.
ModelLaw law_of(const JointModel& model);

}  // namespace tribolog::method::model
