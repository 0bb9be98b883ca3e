#include "paper/charts/paper_charts.h"

namespace tribolog::paper::charts {
namespace {

constexpr double break_away_Nm = 0.884;
constexpr double coulomb_Nm = 0.45;
constexpr double stribeck_speed_rad_s = 5.0;
constexpr double viscous_Nms_rad = 2.4e-3;
constexpr double threshold_rad_s = 1e-3;

}  // namespace

friction::StribeckFriction stribeck_at_joint_scale() {
  friction::StribeckFriction::Parameters p;
  p.curve.coulomb_Nm = coulomb_Nm;
  p.curve.static_Nm = break_away_Nm;
  p.curve.stribeck_speed_rad_s = stribeck_speed_rad_s;
  p.viscous_Nms_rad = viscous_Nms_rad;
  return friction::StribeckFriction(p);
}

friction::ThresholdSpeedFriction linear_zone_at_joint_scale() {
  friction::ThresholdSpeedFriction::Parameters p;
  p.coulomb_Nm = coulomb_Nm;
  p.static_Nm = break_away_Nm;
  p.stribeck_decay_s_rad = 1 / stribeck_speed_rad_s;
  p.viscous_Nms_rad = viscous_Nms_rad;
  p.threshold_rad_s = threshold_rad_s;
  return friction::ThresholdSpeedFriction(p);
}

}  // namespace tribolog::paper::charts
