#pragma once
// What the user accepts: limits of identified quantities, as the manifest states them.

#include <optional>
#include <string>
#include <vector>

namespace tribolog::joint {

/// One `[[limit]]` of the manifest. At least one of the four is set.
struct AcceptanceLimit {
  std::string quantity;       ///< A key of limited_quantities().
  std::optional<double> min;  ///< In the unit that the key names, as all but the last.
  std::optional<double> max;
  std::optional<double> half_width;          ///< Largest half width of the 95 % interval.
  std::optional<double> half_width_percent;  ///< The same, of the estimate.
};

/// A quantity on a side of the gear and in a unit, of which a limit may speak.
struct LimitedQuantity {
  std::string key;       ///< "coulomb_joint_Nm"
  std::string quantity;  ///< Key of the verdict's quantity: "coulomb_torque".
  std::string unit;      ///< "N·m"
  double factor{1.0};    ///< From SI to the unit.
  int gear_power{0};     ///< From the motor's side: times gear ratio to this power.
};

const std::vector<LimitedQuantity>& limited_quantities();
/// nullptr if there is none of this key.
const LimitedQuantity* find_limited_quantity(const std::string& key);

}  // namespace tribolog::joint
