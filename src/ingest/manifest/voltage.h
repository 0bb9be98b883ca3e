#pragma once
// Voltage, PWM and duty cycle in place of an effort: no torque follows from them, and that is said
// in one line.

#include "ingest/manifest/toml_table.h"

namespace tribolog {

/// @throw InputError if the table's `kind` is a voltage or a duty cycle.
void refuse_voltage_kind(const TomlTable& effort);

/// @throw InputError if the column's `unit` is one of voltage or duty cycle.
void refuse_voltage_unit(const TomlTable& column);

}  // namespace tribolog
