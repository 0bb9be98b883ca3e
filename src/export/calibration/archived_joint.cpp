#include "export/calibration/archived_joint.h"

#include <string_view>

namespace tribolog::archive {

const Quantity* ArchivedJoint::found(std::string_view name) const {
  for (const Quantity& quantity : quantities) {
    if (quantity.name == name && quantity.estimate) return &quantity;
  }
  return nullptr;
}

}  // namespace tribolog::archive
