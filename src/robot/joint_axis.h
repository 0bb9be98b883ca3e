#pragma once

#include <string>

#include <Eigen/Core>

namespace tribolog::robot {

/// @param joint whose axis it is, for the message.
/// @throw Refusal: it has no direction.
void check_axis(const Eigen::Vector3d& axis, const std::string& joint);

}  // namespace tribolog::robot
