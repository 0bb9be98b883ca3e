#include "export/plan/set_points_csv.h"

#include <algorithm>
#include <cmath>

#include "base/shortest_number.h"

namespace tribolog {
namespace {

void append_row(const ExperimentPlan& plan, double t_s, std::string& csv) {
  append_number(csv, t_s);
  csv += ',';
  append_number(csv, plan.angle_rad(t_s));
  csv += ',';
  append_number(csv, plan.speed_rad_s(t_s));
  const PlannedSegment& s = plan.segments[plan.segment_at(t_s)];
  const bool torque_leads = s.ramp && t_s >= s.from_s && t_s < s.to_s;
  csv += torque_leads ? ",1," : ",0,";
  append_number(csv, torque_leads ? s.ramp->direction * s.ramp->rate_Nm_s * (t_s - s.from_s) : 0.0);
  csv += '\n';
}

}  // namespace

std::string set_points_csv(const ExperimentPlan& plan) {
  std::string csv = "t_s,q_rad,dq_rad_s,torque_mode,ramp_torque_Nm\n";
  if (plan.segments.empty()) return csv;
  const double rate = plan.joint.set_point_rate_Hz;
  const double end = plan.duration_s();
  const auto rows = static_cast<std::size_t>(std::floor(end * rate));
  constexpr std::size_t usual_row_bytes = 56;
  csv.reserve(rows * usual_row_bytes);
  double t_s = 0;
  for (std::size_t i = 0; i <= rows; ++i) {
    t_s = static_cast<double>(i) / rate;
    append_row(plan, std::min(t_s, end), csv);
  }
  if (t_s < end) append_row(plan, end, csv);
  return csv;
}

}  // namespace tribolog
