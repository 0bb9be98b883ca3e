#include "friction/catalogue.h"

#include "base/statement.h"
#include "friction/armstrong.h"
#include "friction/bliman_sorine.h"
#include "friction/dahl.h"
#include "friction/elasto_plastic.h"
#include "friction/gms.h"
#include "friction/haessig_bristles.h"
#include "friction/hess_soom.h"
#include "friction/leuven.h"
#include "friction/lugre.h"
#include "friction/reset_integrator.h"
#include "friction/stribeck.h"
#include "friction/threshold_speed.h"
#include "friction/waiboer.h"

namespace tribolog::friction {
namespace {

constexpr int elements = 10;
constexpr double lag_s = 0.003;  // of the size measured in lubricated contacts (Armstrong 1994)

StribeckCurve::Parameters curve(const ContactParameters& c) {
  return {c.coulomb_Nm, c.static_Nm, c.stribeck_speed_rad_s, 2.0};
}

DahlFriction::Parameters dahl(const ContactParameters& c) {
  return {c.stiffness_Nm_rad, c.coulomb_Nm, 1.0, c.viscous_Nms_rad};
}

/// Its stiffness appears over the bonds' average stretch, its Coulomb torque is a third of what all
/// of them could carry.
HaessigBristleFriction::Parameters haessig_bristles(const ContactParameters& c) {
  return {c.stiffness_Nm_rad, 3 * c.coulomb_Nm / c.stiffness_Nm_rad, 500, c.viscous_Nms_rad, 1};
}

ResetIntegratorFriction::Parameters reset_integrator(const ContactParameters& c) {
  return {c.stiffness_Nm_rad, c.damping_Nms_rad, c.coulomb_Nm / c.stiffness_Nm_rad,
          c.static_Nm / c.coulomb_Nm - 1, c.viscous_Nms_rad};
}

HessSoomFriction::Parameters hess_soom(const ContactParameters& c) {
  return {c.coulomb_Nm, c.static_Nm, c.stribeck_speed_rad_s, c.viscous_Nms_rad, lag_s};
}

/// f1 and f2 such that the peak is the break-away torque; the initial stiffness then sets the ways.
BlimanSorineFriction::Parameters bliman_sorine(const ContactParameters& c) {
  constexpr double eta = 0.5;
  const auto with = [&](double slow) {
    const double fast = c.coulomb_Nm + slow;
    const double way = (fast / eta - slow) / c.stiffness_Nm_rad;
    return BlimanSorineFriction::Parameters{fast, slow, way, eta, c.viscous_Nms_rad};
  };
  double low = 0;
  double high = 100 * c.static_Nm;
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (low + high) / 2;
    const bool too_small = BlimanSorineFriction(with(middle)).break_away_Nm() < c.static_Nm;
    (too_small ? low : high) = middle;
  }
  return with((low + high) / 2);
}

ArmstrongFriction::Parameters armstrong(const ContactParameters& c) {
  return {c.stiffness_Nm_rad,
          c.coulomb_Nm,
          c.viscous_Nms_rad,
          c.static_Nm - c.coulomb_Nm,
          c.stribeck_speed_rad_s,
          lag_s,
          0.1};
}

LuGreFriction::Parameters lugre(const ContactParameters& c) {
  return {c.stiffness_Nm_rad, c.damping_Nms_rad, c.viscous_Nms_rad,
          c.coulomb_Nm,       c.static_Nm,       c.stribeck_speed_rad_s};
}

LeuvenFriction::Parameters leuven(const ContactParameters& c) {
  return {maxwell_elements(c.stiffness_Nm_rad, LeuvenFriction::reserve * c.static_Nm, elements),
          curve(c), 4.0, c.damping_Nms_rad, c.viscous_Nms_rad};
}

ElastoPlasticFriction::Parameters elasto_plastic(const ContactParameters& c) {
  return {c.stiffness_Nm_rad, c.damping_Nms_rad, c.viscous_Nms_rad, curve(c),
          0.7 * c.coulomb_Nm / c.stiffness_Nm_rad};
}

/// The attraction gives the same time constant s(w)/C as the lag of lubricated contacts.
GmsFriction::Parameters gms(const ContactParameters& c) {
  return {maxwell_elements(c.stiffness_Nm_rad, c.static_Nm, elements), curve(c),
          c.coulomb_Nm / lag_s, c.viscous_Nms_rad};
}

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

template <class Model>
FrictionModelEntry model(FrictionTraits traits,
                         typename Model::Parameters (*match)(const ContactParameters&)) {
  return {recipe<DynamicFriction>(Model(match({}))), traits,
          [match](const ContactParameters& c) { return named(match(c)); }};
}

}  // namespace

const std::vector<FrictionModelEntry>& dynamic_friction_models() {
  // break-away, Stribeck, lag, pre-sliding, non-local memory, drifts, rate independent, random,
  // remembers rest
  static const std::vector<FrictionModelEntry> models{
      model<DahlFriction>({0, 0, 0, 1, 0, 1, 1, 0}, dahl),
      model<HaessigBristleFriction>({0, 0, 0, 1, 0, 0, 1, 1}, haessig_bristles),
      model<ResetIntegratorFriction>({1, 0, 0, 1, 0, 0, 0, 0}, reset_integrator),
      model<HessSoomFriction>({0, 1, 1, 0, 0, 0, 0, 0}, hess_soom),
      model<BlimanSorineFriction>({1, 0, 0, 1, 0, 1, 1, 0}, bliman_sorine),
      model<ArmstrongFriction>({1, 1, 1, 1, 0, 0, 0, 0, 1}, armstrong),
      model<LuGreFriction>({1, 1, 1, 1, 0, 1, 0, 0}, lugre),
      model<LeuvenFriction>({1, 1, 1, 1, 1, 1, 0, 0}, leuven),
      model<ElastoPlasticFriction>({1, 1, 1, 1, 0, 0, 0, 0}, elasto_plastic),
      model<GmsFriction>({1, 1, 1, 1, 1, 0, 0, 0}, gms),
  };
  return models;
}

const std::vector<StaticLawEntry>& static_friction_laws() {
  static const std::vector<StaticLawEntry> laws{
      recipe<StaticFriction>(StribeckFriction({{1, 1, 1, 2}, 0})),
      recipe<StaticFriction>(ThresholdSpeedFriction({1, 1, 0, 0, 1})),
      recipe<StaticFriction>(WaiboerFriction({})),
  };
  return laws;
}

const FrictionModelEntry& dynamic_friction_model(std::string_view name) {
  std::string known;
  for (const FrictionModelEntry& one : dynamic_friction_models()) {
    if (one.name == name) return one;
    known += (known.empty() ? "" : ", ") + one.name;
  }
  throw Refusal({"friction.no_such_model", {{"model", std::string(name)}, {"known", known}}});
}

}  // namespace tribolog::friction
