#include "calibration/json_values.h"
#include "calibration/parts.h"
#include "wording/words.h"

namespace tribolog::calibration {
namespace {

using method::session::SessionFriction;

Json load(const method::session::LoadEffect& l) {
  const auto if_examined = [&](double value) { return l.examined ? number(value) : Json(nullptr); };
  return {{"examined", l.examined},
          {"found", l.found},
          {"per_load", interval_if(l.examined, l.per_load)},
          {"reference_load", if_examined(l.reference_load)},
          {"unloaded_Nm", if_examined(l.unloaded_Nm)},
          {"at_peak_Nm", if_examined(l.at_peak_Nm)},
          {"viscous_Nms_rad", if_examined(l.viscous_Nms_rad)}};
}

Json angle(const method::session::AngleEffect& a) {
  return {{"examined", a.examined},
          {"found", a.found},
          {"amplitude", interval_if(a.examined, a.amplitude)}};
}

Json direction(const method::session::DirectionEffect& d) {
  return {{"examined", d.examined},
          {"asymmetry_found", d.asymmetry_found},
          {"offset_found", d.offset_found},
          {"told_apart", d.told_apart},
          {"asymmetry", interval_if(d.examined, d.asymmetry)},
          {"offset_Nm", interval_if(d.examined, d.offset_Nm)}};
}

Json shift(const std::optional<method::session::SweepShift>& s) {
  if (!s) return nullptr;
  return {{"q_peak_rad", number(s->q_peak_rad)},
          {"q_peak_slack_rad", number(s->q_peak_slack_rad)},
          {"gravity_Nm", number(s->gravity_Nm)},
          {"gravity_slack_Nm", number(s->gravity_slack_Nm)}};
}

Json drift(const SessionFriction& s) {
  const method::session::FrictionDrift& d = s.drift;
  const statistics::Estimate change{d.change, d.low, d.high, {"interval.laws_and_times"}};
  const auto if_examined = [&](double value) { return d.examined ? number(value) : Json(nullptr); };
  return {{"examined", d.examined},
          {"found", d.found},
          {"change", interval_if(d.examined, change)},
          {"time_constant", if_examined(d.time_constant)},
          {"chance", if_examined(d.chance)},
          {"levels", d.levels},
          {"rough_sweep", shift(s.rough_shift)},
          {"precise_sweep", shift(s.precise_shift)}};
}

Json offset_drift(const method::session::OffsetDrift& d) {
  return {{"examined", d.examined},
          {"found", d.found},
          {"change_Nm", interval_if(d.examined, d.change_Nm)},
          {"to_oscillations_Nm", d.examined ? number(d.to_oscillations_Nm) : Json(nullptr)}};
}

}  // namespace

Json session(const SessionFriction& s) {
  return {{"examined", s.examined},
          {"sentence", wording::words(s.sentence)},
          {"sentence_code", code_of(s.sentence)},
          {"by_clock", s.by_clock},
          {"whole_s", number(s.whole_s)},
          {"pairs", s.pairs},
          {"mean_friction_Nm", s.examined ? number(s.mean_friction_Nm) : Json(nullptr)},
          {"load", load(s.load)},
          {"angle", angle(s.angle)},
          {"direction", direction(s.direction)},
          {"drift", drift(s)},
          {"offset_drift", offset_drift(s.offset_drift)}};
}

}  // namespace tribolog::calibration
