#pragma once
// All friction models by name: those with memory, each with parameters that match those of the
// others, and the static laws.

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "friction/friction_model.h"

namespace tribolog::friction {

/// Properties of one contact that all models share: stiffness at rest, break-away and Coulomb
/// torque, Stribeck velocity and viscous part. Default: table 1 of the paper as intended (Canudas
/// de Wit et al. 1995), of a unit mass [N, m].
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
  bool rate_independent{};  ///< Without its viscous part torque depends on the path alone.
  bool is_random{};         ///< Forward and backward are not mirror images.
  bool remembers_rest{};    ///< Steady torque depends on the rest before it, not on speed alone.
};

/// A model by name, and how to make one from named parameters.
template <class Model>
struct ModelRecipe {
  std::string name;            ///< As in files: "lugre". Title and source are in the messages.
  NamedParameters parameters;  ///< All it has; only values with `has_usual` are meaningful.
  /// A parameter that is not given keeps its value in `parameters`.
  /// @throw Refusal stating value and rule, or for an unknown name.
  std::function<std::unique_ptr<Model>(const NamedParameters&)> make;
};

struct FrictionModelEntry : ModelRecipe<DynamicFriction> {
  FrictionTraits traits;
  std::function<NamedParameters(const ContactParameters&)> matched_parameters;

  [[nodiscard]] std::unique_ptr<DynamicFriction> matched(const ContactParameters& contact) const {
    return make(matched_parameters(contact));
  }
};

using StaticLawEntry = ModelRecipe<StaticFriction>;

/// In the order in which the models were published.
const std::vector<FrictionModelEntry>& dynamic_friction_models();

/// In the order of the paper's equations.
const std::vector<StaticLawEntry>& static_friction_laws();

/// @throw Refusal naming the available models.
const FrictionModelEntry& dynamic_friction_model(std::string_view name);

}  // namespace tribolog::friction
