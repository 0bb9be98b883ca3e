#pragma once
// Units of a log's columns, and their factors to SI.

#include <optional>
#include <string>
#include <string_view>

#include "error.h"

namespace tribolog {

enum class Quantity { time, angle, angular_speed, torque, current, temperature };

/// "an angle", for messages.
std::string to_string(Quantity quantity);

/// "angle", for tables; an angular speed is "speed".
std::string quantity_word(Quantity quantity);

/// Factor from the unit to s, rad, rad/s, N·m, A or °C; nothing for a unit that is not one of this
/// quantity. Case counts ("mNm" is not "MNm"); "N·m", "N*m", "N m" and "Nm" are the same.
std::optional<double> find_si_factor(Quantity quantity, std::string_view unit);

/// As above. @throw InputError at `where`, listing the known units and naming the closest.
double si_factor(Quantity quantity, std::string_view unit, const Location& where);

/// Whether it is a unit of any quantity.
bool is_known_unit(std::string_view unit);

/// The known units as they are listed in messages: "rad, mrad, deg".
std::string known_units(Quantity quantity);

}  // namespace tribolog
