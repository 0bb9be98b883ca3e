#pragma once
// All dynamic friction models by name, and each with parameters that match those of the others.

#include <memory>
#include <string>
#include <vector>

#include "friction/dynamic_friction.h"

namespace tribolog {

/// What one contact looks like to every model: stiffness at rest, break-away and Coulomb torque,
/// Stribeck velocity and viscous part. Default: table 1 of the paper as meant (Canudas de Wit et
/// al. 1995), of a unit mass [N, m].
struct ContactParameters {
  double stiffness_Nm_rad{1e5};
  double damping_Nms_rad{316.22776601683796};  ///< sqrt(1e5)
  double viscous_Nms_rad{0.4};
  double coulomb_Nm{1.0};
  double static_Nm{1.5};
  double stribeck_speed_rad_s{0.001};
};

/// What a model can show, as its authors claim it; the tests hold each model to it.
struct FrictionTraits {
  bool break_away{};        ///< More torque to start than to keep sliding.
  bool stribeck{};          ///< Steady torque falls with speed above zero.
  bool lag{};               ///< In sliding, torque at rising speed exceeds that at falling speed.
  bool presliding{};        ///< Elastic before sliding.
  bool non_local_memory{};  ///< An inner loop closes where it was left, and is forgotten.
  bool drifts{};            ///< Creeps under an oscillating torque below break-away.
  bool rate_independent{};  ///< Without its viscous part torque depends on the way alone.
  bool is_random{};         ///< Forward and backward are not mirror images.
};

struct FrictionModelEntry {
  std::string name;    ///< As a scenario says it: "lugre".
  std::string title;   ///< "LuGre"
  std::string source;  ///< Authors and year, and the paper's equation if it has one.
  FrictionTraits traits;
  std::unique_ptr<DynamicFriction> (*matched)(const ContactParameters&);
};

/// In the order in which the models were published.
const std::vector<FrictionModelEntry>& dynamic_friction_models();

/// @throw std::invalid_argument naming the models that there are.
const FrictionModelEntry& dynamic_friction_model(const std::string& name);

}  // namespace tribolog
