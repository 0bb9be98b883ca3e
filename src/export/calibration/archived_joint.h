#pragma once
// What an export is made of: one archived calibration.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "calibration/archived_calibration.h"
#include "joint/drive.h"

namespace tribolog::archive {

struct ArchivedJoint {
  Entry entry;
  std::vector<Quantity> quantities;  ///< SI, motor side.
  std::string calibration;           ///< The file of `tribolog identify`; empty: not archived.

  /// @return nullptr if there is none of this name, or none with an estimate.
  [[nodiscard]] const Quantity* found(std::string_view name) const;
};

/// What an export for a simulator may do beyond the usual.
struct SimulatorOptions {
  bool doubtful_too{};  ///< Also numbers whose verdict is not usable.
  Side side{Side::joint};
  /// Inertia of all that the joint moves about its axis [kg·m²], joint side: that of the links in
  /// the simulator's model.
  std::optional<double> arm_inertia_kgm2;
};

}  // namespace tribolog::archive
