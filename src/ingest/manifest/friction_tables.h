#pragma once
// The friction of a scenario, and the known curve of a manifest.

#include <memory>

#include "friction/friction_model.h"
#include "ingest/manifest/toml_table.h"

namespace tribolog::ingest::manifest {

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
