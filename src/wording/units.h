#pragma once
// Which unit a size is read in: engineering prefixes, so that numbers lie between 0.1 and 1000.

#include "wording/rounding.h"

namespace tribolog::wording {

/// N·m, mN·m or µN·m for torques of about this size.
Scale torque_scale(double size_Nm);

/// rad, mrad or µrad for angles of about this size.
Scale radian_scale(double size_rad);

/// N·m·s/rad, mN·m·s/rad or µN·m·s/rad.
Scale viscous_scale(double size_Nms_rad);

/// N·m/rad, kN·m/rad or MN·m/rad for stiffnesses.
Scale stiffness_scale(double size_Nm_rad);

Scale degree_scale();                 ///< rad -> °
Scale degree_per_second_scale();      ///< rad/s -> °/s
Scale plain_scale(std::string unit);  ///< SI as it is.

/// By the unit of a quantity of the verdict, for a value of about this size.
Scale quantity_scale(const std::string& unit, double size);

}  // namespace tribolog::wording
