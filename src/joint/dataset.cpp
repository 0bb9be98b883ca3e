#include "joint/dataset.h"

namespace tribolog {

std::vector<const Recording*> Dataset::with_role(Role role) const {
  std::vector<const Recording*> found;
  for (const Recording& recording : recordings) {
    if (recording.role == role) found.push_back(&recording);
  }
  return found;
}

}  // namespace tribolog
