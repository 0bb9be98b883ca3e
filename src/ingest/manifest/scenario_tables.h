#pragma once
// Tables of a scenario file, some of which robot files and manifests have too: its experiments,
// load and friction.

#include <memory>
#include <string>

#include "friction/friction_model.h"
#include "ingest/manifest/toml_table.h"
#include "joint/gravity_load.h"
#include "simulate/scenario.h"

namespace tribolog::ingest::manifest {

/// An angle given as `<name>_rad` or `<name>_deg` [rad]. @throw InputError if both or neither is.
double read_angle(const TomlTable& table, const std::string& name, Sign sign = Sign::any);

/// The same of a rate: `<name>_rad<after>` or `<name>_deg<after>`; after = "_s", "_s2".
double read_angular_rate(const TomlTable& table, const std::string& name, const std::string& after);

/// As read_angle() where the key may be left out.
double read_angle_or(const TomlTable& table, const std::string& name, double otherwise_rad);

// Each refuses what cannot be carried out. @throw InputError at the key.
simulate::SweepExperiment read_sweep(const TomlTable& table);
simulate::SineSweepExperiment read_sine_sweep(const TomlTable& table);
/// One, or as many as `positions` says, spread over a turn of the motor.
std::vector<simulate::OscillationExperiment> read_oscillation(const TomlTable& table,
                                                              double gear_ratio);
simulate::BreakAwayExperiment read_break_away(const TomlTable& table);
simulate::ConstantSpeedExperiment read_constant_speed(const TomlTable& table);
simulate::Noise read_noise(const TomlTable& table);
simulate::LogForm read_log_form(const TomlTable& table);

/// [load]: mass_kg, distance_m, q_peak; gravity_m_s2 = 9.81. @throw InputError at the key.
joint::GravityLoad read_load(const TomlTable& load);

// Friction: that of a scenario, and the known curve of a manifest.

/// As Scenario has them: `sliding` is null where the dynamic model drives sweeps and runs too.
struct JointFriction {
  std::shared_ptr<const friction::DynamicFriction> presliding;
  std::shared_ptr<const friction::StaticFriction> sliding;
};

/// [friction] of a scenario (scenario_file.h).
/// @throw InputError for what is missing, impossible, unknown, or of a model that is not chosen.
JointFriction read_friction(const TomlTable& friction);

/// [reference] of a manifest: one table named after a static law, or after a dynamic model, of
/// which the torque at constant speed is meant. Null where it has none.
/// @throw InputError as above, and where there are two.
std::shared_ptr<const friction::StaticFriction> read_known_curve(const TomlTable& reference);

}  // namespace tribolog::ingest::manifest
