#include "robot/joint_axis.h"

#include "base/statement.h"

namespace tribolog::robot {

void check_axis(const Eigen::Vector3d& axis, const std::string& joint) {
  if (axis.allFinite() && axis.norm() > 0) return;
  throw Refusal({"arm.axis_without_direction",
                 {{"x", axis.x()}, {"y", axis.y()}, {"z", axis.z()}, {"joint", joint}}});
}

}  // namespace tribolog::robot
