#pragma once
// Internal to friction: makes a catalogue entry from a model's class. Each model with memory has a
// file of its own, which provides its entry and nothing else.

#include <memory>

#include "friction/catalogue.h"
#include "friction/static_laws.h"

namespace tribolog::friction {

/// @param example only its name counts.
template <class Kind, class Model>
ModelRecipe<Kind> recipe(const Model& example) {
  using Parameters = typename Model::Parameters;
  return {example.name(), named(Parameters{}),
          [](const NamedParameters& values) -> std::unique_ptr<Kind> {
            Parameters parameters;
            set_values(parameters.by_name(), values);
            return std::make_unique<Model>(parameters);
          }};
}

/// @param match gives the model's parameters from the contact properties common to all models.
template <class Model>
FrictionModelEntry model(FrictionTraits traits,
                         typename Model::Parameters (*match)(const ContactParameters&)) {
  return {recipe<DynamicFriction>(Model(match({}))), traits,
          [match](const ContactParameters& c) { return named(match(c)); }};
}

/// Number of elements, and frictional lag, of models that have these: a contact does not specify
/// them.
inline constexpr int matched_elements = 10;
inline constexpr double matched_lag_s = 0.003;  ///< As in lubricated contacts (Armstrong 1994).

/// The contact's steady torque over speed.
inline StribeckCurve::Parameters matched_curve(const ContactParameters& c) {
  return {c.coulomb_Nm, c.static_Nm, c.stribeck_speed_rad_s, 2.0};
}

FrictionModelEntry dahl_model();
FrictionModelEntry haessig_bristles_model();
FrictionModelEntry reset_integrator_model();
FrictionModelEntry hess_soom_model();
FrictionModelEntry bliman_sorine_model();
FrictionModelEntry armstrong_model();
FrictionModelEntry lugre_model();
FrictionModelEntry leuven_model();
FrictionModelEntry elasto_plastic_model();
FrictionModelEntry gms_model();

}  // namespace tribolog::friction
