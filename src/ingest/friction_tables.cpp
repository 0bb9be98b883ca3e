#include "ingest/friction_tables.h"

#include "ingest/key_guard.h"

namespace tribolog {

LuGreFriction read_lugre(const TomlTable& table) {
  LuGreFriction::Parameters p;
  p.bristle_stiffness_Nm_rad = table.number("bristle_stiffness_Nm_rad", Sign::positive);
  p.bristle_damping_Nms_rad = table.number("bristle_damping_Nms_rad", Sign::not_negative);
  p.viscous_Nms_rad = table.number("viscous_Nms_rad", Sign::not_negative);
  p.coulomb_Nm = table.number("coulomb_Nm", Sign::positive);
  p.static_Nm = table.number("static_Nm", Sign::positive);
  p.stribeck_speed_rad_s = table.number("stribeck_speed_rad_s", Sign::positive);
  table.refuse_unknown_keys();
  return guarded(table, "coulomb_Nm", [&] { return LuGreFriction(p); });
}

WaiboerFriction read_waiboer(const TomlTable& table) {
  WaiboerFriction::Parameters p;
  p.asperity_torque_Nm = table.number("asperity_torque_Nm", Sign::not_negative);
  p.stribeck_speed_rad_s = table.number("stribeck_speed_rad_s", Sign::positive);
  p.stribeck_power = table.number("stribeck_power", Sign::positive);
  p.viscous_coefficient = table.number("viscous_coefficient", Sign::not_negative);
  p.viscous_power = table.number("viscous_power", Sign::not_negative);
  p.smoothing_s_rad = table.number_or("smoothing_s_rad", p.smoothing_s_rad, Sign::positive);
  table.refuse_unknown_keys();
  return guarded(table, "viscous_power", [&] { return WaiboerFriction(p); });
}

}  // namespace tribolog
