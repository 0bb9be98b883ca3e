#include "verdict/check_consequences.h"

#include <algorithm>
#include <string>

namespace tribolog {
namespace {

using Keys = std::vector<std::string>;

const Keys gravity{"cog_angle", "gravity_torque", "surrogate_mass"};
const Keys mass{"gravity_torque", "surrogate_mass"};
const Keys bristle{"bristle_stiffness", "bristle_damping"};
const Keys curve{"coulomb_torque", "stribeck_speed", "viscous_coefficient", "viscous_curve"};
const Keys slopes{"stribeck_speed", "viscous_coefficient", "viscous_curve"};
const Keys per_speed{"bristle_damping", "inertia"};

Keys operator+(const Keys& a, const Keys& b) {
  Keys all = a;
  all.insert(all.end(), b.begin(), b.end());
  return all;
}

struct Consequence {
  std::string check;
  Keys touched;
  Verdict lowered_to;
};

std::vector<Consequence> consequences(const Sources& sources) {
  const Keys torque = mass + bristle + curve + Keys{"break_away_torque", "inertia"};
  const Keys everything = torque + Keys{"cog_angle"};
  const Keys of_loop =
      sources.break_away_from_ramps ? bristle : bristle + Keys{"break_away_torque"};
  const auto doubtful = Verdict::doubtful;
  const auto none = Verdict::not_identifiable;
  std::vector<Consequence> all{
      {"effort_provenance", everything, doubtful},
      {"effort_column", everything, doubtful},
      {"static_torque", torque, doubtful},
      {"joint_moves", everything, doubtful},
      {"angle_unit", everything, doubtful},
      {"clock_jitter", slopes + per_speed, doubtful},
      {"clock_gaps", slopes + per_speed + Keys{"break_away_torque"}, doubtful},
      {"speed_scale", slopes + per_speed, doubtful},
      {"run_directions", {"coulomb_torque"}, none},
      {"run_directions", {"viscous_curve"}, doubtful},
      {"run_common_angles", curve, doubtful},
      {"run_speeds", slopes, none},
      {"run_speeds", {"coulomb_torque"}, doubtful},
      {"stick_slip", curve, doubtful},
      {"torque_alive", torque, doubtful},
      {"torque_noise", everything, none},
      {"torque_saturation", everything, doubtful},
      {"torque_step", torque, doubtful},
      {"friction_dissipates", everything, none},
      {"power", torque, doubtful},
      {"torque_ripple", mass, doubtful},
      {"friction_drift", curve + Keys{"break_away_torque"}, doubtful},
      {"temperature", curve + Keys{"break_away_torque"}, doubtful},
      {"encoder_step", of_loop, none},
      {"oscillation_cycles", mass + of_loop, doubtful},
      {"oscillation_at_peak", mass, doubtful},
      {"gravity_within_torque", gravity, none},
      {"sweep_directions", {"cog_angle"}, doubtful}};
  if (!sources.break_away_from_ramps) {
    all.push_back({"oscillation_slides", {"break_away_torque"}, none});
  }
  if (sources.mass_from_sweep) all.push_back({"sweep_directions", mass, doubtful});
  if (!sources.friction_from_runs) {
    all.push_back({"sweep_directions", {"coulomb_torque"}, none});
    all.push_back({"sweep_directions", {"viscous_curve"}, doubtful});
    all.push_back({"sweep_common_angles", curve, doubtful});
  }
  return all;
}

}  // namespace

void apply_data_checks(const DataChecksResult& checks, const Sources& sources,
                       std::vector<QuantityVerdict>& quantities) {
  for (const Consequence& consequence : consequences(sources)) {
    const DataCheck* check = checks.find(consequence.check);
    if (check == nullptr || check->state != CheckState::fails) continue;
    for (QuantityVerdict& quantity : quantities) {
      const Keys& touched = consequence.touched;
      if (std::find(touched.begin(), touched.end(), quantity.key) == touched.end()) continue;
      lower(quantity, consequence.lowered_to, check->found + ": " + check->consequence,
            check->experiment);
    }
  }
}

}  // namespace tribolog
