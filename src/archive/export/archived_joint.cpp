#include "archive/export/archived_joint.h"

namespace tribolog::archive {

const Quantity* ArchivedJoint::found(const std::string& name) const {
  for (const Quantity& quantity : quantities) {
    if (quantity.name == name && quantity.estimate) return &quantity;
  }
  return nullptr;
}

}  // namespace tribolog::archive
