#pragma once
// Units of a log's columns, and their factors to SI.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "ingest/log/log_table.h"

namespace tribolog::ingest::log {

enum class Quantity { time, angle, angular_speed, torque, current, temperature };

/// "an angle", for messages.
std::string to_string(Quantity quantity);

/// "angle", for tables; an angular speed is "speed".
std::string quantity_word(Quantity quantity);

/// Factor from the unit to s, rad, rad/s, N·m, A or °C; nothing for a unit that is not one of this
/// quantity. A multiple of one is a unit too: "0.018 deg" for a count of 20,000 to the turn,
/// "0.0013 Nm" for a per mille of the rated torque, which is also "‰ of 1.3 Nm". Ordinary spellings
/// are known: "msec", "Degrees", "rev/min", "N.m". Case counts in a prefix alone ("mNm" is not
/// "MNm"); "N·m", "N*m", "N-m", "N m" and "Nm" are the same.
std::optional<double> find_si_factor(Quantity quantity, std::string_view unit);

/// As above. @throw InputError at `where`, listing the known units and naming the closest.
double si_factor(Quantity quantity, std::string_view unit, const Location& where);

/// The unit that a manifest states for a time that is no number: "iso8601", "hh:mm:ss",
/// "yyyy-mm-dd"; empty for the other readings.
std::string_view unit_of_time(ColumnReading reading);
/// The reading that has this unit; nothing for a unit of numbers.
std::optional<ColumnReading> reading_of_time(std::string_view unit);

/// Of what drives log, counts of an encoder or per mille of a rated value: "0.018 deg".
std::string_view example_of_multiple(Quantity quantity);

/// Whether it is a unit of any quantity; a multiple is not one here: "0.5 s" may be a value.
bool is_known_unit(std::string_view unit);

/// The known units that messages list.
std::vector<std::string> listed_units(Quantity quantity);

/// The same in one text: "rad, mrad, deg, turn".
std::string known_units(Quantity quantity);

}  // namespace tribolog::ingest::log
