#include "verdict/quantity_rooms.h"

namespace tribolog {
namespace {

QuantityVerdict viscous_curve(const Calibration& c) {
  QuantityVerdict q;
  q.key = "viscous_curve";
  q.words = "Viscous curve";
  const StageReport& stage = c.viscous.stage;
  if (c.viscous.runs.empty() || c.viscous.curves.empty()) {
    lower(q, Verdict::not_identifiable, stage.reason, record_runs);
    return q;
  }
  if (stage.state != StageState::done) lower(q, Verdict::doubtful, stage.reason, record_runs);
  if (c.quality.errors.empty()) {
    lower(q, Verdict::doubtful, "nothing checks the curve: " + c.quality.stage.reason, record_runs);
  }
  return q;
}

}  // namespace

std::optional<Estimate> coulomb_torque(const Calibration& c) {
  const auto& line = c.friction.coulomb_viscous;
  return line ? line->coulomb_Nm : c.rough.coulomb_Nm;
}

std::vector<QuantityVerdict> curve_verdicts(const Calibration& c) {
  const auto& line = c.friction.coulomb_viscous;
  const auto& waiboer = c.friction.waiboer;
  const std::string why = c.friction.stage.reason;
  std::optional<Estimate> viscous = c.rough.viscous_Nms_rad;
  std::optional<Estimate> stribeck;
  if (line) viscous = line->viscous_Nms_rad;
  if (waiboer && waiboer->converged) stribeck = waiboer->stribeck_speed_rad_s;
  // Which model of the curve was chosen, and what it shows of each parameter, enters here.
  std::vector<QuantityVerdict> all{
      by_estimate("coulomb_torque", "Coulomb torque", "N·m", coulomb_torque(c), why, record_runs),
      by_estimate("stribeck_speed", "Stribeck velocity", "rad/s", stribeck,
                  why.empty() ? "no model with a Stribeck velocity was fitted to the curve" : why,
                  "more speeds below and about the dip of the friction curve"),
      by_estimate("viscous_coefficient", "Viscous coefficient", "N·m·s/rad", viscous, why,
                  record_runs),
      viscous_curve(c)};
  // A curve without a dip has none.
  all[1].decides = false;
  return all;
}

}  // namespace tribolog
