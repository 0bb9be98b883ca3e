#include "report/elements/loop_points_table.h"

#include <algorithm>
#include <cmath>

#include "report/elements/result_words.h"
#include "wording/axis_scale.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::elements {
namespace {

using wording::tr;

/// Decimals that show the largest of a column to four digits, so that numbers around zero read 0.
int column_decimals(const std::vector<method::hysteresis::LoopPoint>& points,
                    double method::hysteresis::LoopPoint::* member, double factor) {
  double largest = 0.0;
  for (const method::hysteresis::LoopPoint& p : points) {
    if (std::isfinite(p.*member)) largest = std::max(largest, std::abs(p.*member) * factor);
  }
  constexpr int digits = 4;
  if (largest == 0.0) return 0;
  return std::clamp(digits - 1 - static_cast<int>(std::floor(std::log10(largest))), 0, 12);
}

}  // namespace

Table loop_points_table(const std::vector<method::hysteresis::LoopPoint>& points,
                        const std::string& id, const std::string& caption) {
  Table table;
  table.id = id;
  table.caption = caption;
  double z = 0.0;
  for (const method::hysteresis::LoopPoint& p : points) {
    if (std::isfinite(p.z_rad)) z = std::max(z, std::abs(p.z_rad));
  }
  const wording::AxisScale shown = wording::prefixed("rad", z);  // as in the figures
  const wording::Scale bristle{shown.factor, shown.unit};
  table.columns = {{tr("Point"), "", false},
                   {tr("Where"), "", false, true},
                   {"t", "s", true},
                   {"q", "°", true},
                   {tr("Torque T"), "N·m", true},
                   {tr("95 % interval"), "N·m", true},
                   {"z", bristle.unit, true},
                   {"dz/dt", bristle.unit + "/s", true}};
  const int z_decimals =
      column_decimals(points, &method::hysteresis::LoopPoint::z_rad, bristle.factor);
  const int rate_decimals =
      column_decimals(points, &method::hysteresis::LoopPoint::dz_rad_s, bristle.factor);
  for (const method::hysteresis::LoopPoint& p : points) {
    const wording::RoundedEstimate torque = wording::round_by_interval(
        {p.torque_Nm, p.torque_low_Nm, p.torque_high_Nm, {}}, wording::plain_scale("N·m"));
    table.rows.push_back(
        {{to_string(p.name), meaning_of(p.name), wording::fixed(p.t_s, 4),
          wording::fixed(p.q_rad * wording::degree_scale().factor, 4), torque.plus_minus(),
          wording::or_dash(torque.range()), wording::fixed(p.z_rad * bristle.factor, z_decimals),
          wording::fixed(p.dz_rad_s * bristle.factor, rate_decimals)},
         false});
  }
  return table;
}

}  // namespace tribolog::report::elements
