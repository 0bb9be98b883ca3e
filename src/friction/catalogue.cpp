#include "friction/catalogue.h"

#include "base/statement.h"
#include "friction/model_entry.h"
#include "friction/static_laws.h"

namespace tribolog::friction {
const std::vector<FrictionModelEntry>& dynamic_friction_models() {
  static const std::vector<FrictionModelEntry> models{
      dahl_model(),      haessig_bristles_model(), reset_integrator_model(),
      hess_soom_model(), bliman_sorine_model(),    armstrong_model(),
      lugre_model(),     leuven_model(),           elasto_plastic_model(),
      gms_model(),
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
