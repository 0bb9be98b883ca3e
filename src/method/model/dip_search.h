#pragma once
// Where the Stribeck dip of a law lies: grids over its speed and its power that are drawn together
// about the likeliest, round by round, as far as the evidence reaches.

#include <vector>

#include "method/model/friction_laws.h"

namespace tribolog::method::model {

/// Laws with the logarithm of their evidence, one each.
struct WeighedLaws {
  const std::vector<FrictionLaw>& laws;
  const std::vector<double>& evidence;
};

class DipSearch {
 public:
  /// For each form of the viscous torque.
  [[nodiscard]] const std::vector<std::vector<DipGrid>>& grids() const { return grids_; }
  /// Speeds of dips, and their powers once the speeds are found. Where a law without a dip is the
  /// likeliest, the search begins again.
  /// @param weighed of the present grids.
  void look_nearer(const WeighedLaws& weighed);

 private:
  void refine_powers(const FrictionLaw& best, double sd_of_power);

  std::vector<std::vector<DipGrid>> grids_{coarse_dips()};
  double power_step_{0.35};  ///< Of their logarithm.
};

}  // namespace tribolog::method::model
