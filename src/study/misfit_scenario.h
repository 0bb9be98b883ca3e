#pragma once
// Internal to the misfit study: what its scenarios, all of LuGre's contact before a disturbance,
// consist of.

#include "friction/lugre.h"
#include "simulate/scenario.h"

namespace tribolog::study {

using LuGreParameters = friction::LuGreFriction::Parameters;

/// @throw std::bad_cast for another contact.
const LuGreParameters& lugre_of(const simulate::Scenario& s);
void set_lugre(simulate::Scenario& s, const LuGreParameters& p);

/// Gravity torque at the motor [N·m].
double motor_gravity(const simulate::Scenario& s);

}  // namespace tribolog::study
