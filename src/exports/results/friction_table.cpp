#include "exports/results/friction_table.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/requirements.h"
#include "calibration/json_values.h"

namespace tribolog::exports::results {
namespace {

using Recorded = nlohmann::json;

/// Runs of the two directions at one commanded speed differ by less.
constexpr double same_speed_share = 0.01;

struct MergedSpeed {
  double speed_sum{};
  double friction_sum{};
  int runs{};
  [[nodiscard]] double speed() const { return speed_sum / runs; }
};

/// Friction against absolute speed, by the curve that was selected, sorted.
std::vector<FrictionRow> measured_points(const Recorded& whole) {
  std::vector<FrictionRow> points;
  const Recorded& viscous = calibration::member(whole, "viscous");
  const Recorded& name = calibration::member(calibration::member(whole, "friction"), "curve");
  if (!name.is_string() || calibration::member(viscous, "from_sweep") != false) return points;
  const Recorded& runs = calibration::member(viscous, "runs");
  const Recorded& friction =
      calibration::member(calibration::member(viscous, "curves"), name.get<std::string>());
  if (!runs.is_array() || !friction.is_array() || friction.size() != runs.size()) return points;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const Recorded& speed = calibration::member(runs[k], "speed_rad_s");
    if (!speed.is_number() || !friction[k].is_number() || speed == 0) continue;
    const double sign = speed.get<double>() < 0 ? -1 : 1;
    points.push_back({sign * speed.get<double>(), sign * friction[k].get<double>()});
  }
  std::sort(points.begin(), points.end(), [](const FrictionRow& a, const FrictionRow& b) {
    return a.speed_rad_s < b.speed_rad_s;
  });
  return points;
}

std::vector<FrictionRow> merged(const std::vector<FrictionRow>& points) {
  std::vector<MergedSpeed> speeds;
  for (const FrictionRow& p : points) {
    if (speeds.empty() || p.speed_rad_s > (1 + same_speed_share) * speeds.back().speed()) {
      speeds.emplace_back();
    }
    MergedSpeed& last = speeds.back();
    last.speed_sum += p.speed_rad_s;
    last.friction_sum += p.friction_Nm;
    ++last.runs;
  }
  std::vector<FrictionRow> rows;
  for (const MergedSpeed& s : speeds) rows.push_back({s.speed(), s.friction_sum / s.runs});
  return rows;
}

FrictionTable straight_line(const ArchivedJoint& joint, const Recorded& whole) {
  const Recorded& line =
      calibration::member(calibration::member(whole, "friction"), "coulomb_viscous");
  const Recorded& fastest = calibration::member(line, "fastest_rad_s");
  const calibration::Quantity* const coulomb = joint.found("coulomb_torque");
  const calibration::Quantity* const viscous = joint.found("viscous_coefficient");
  if (coulomb == nullptr || viscous == nullptr || !fastest.is_number()) {
    return {{}, "the calibration holds no friction curve"};
  }
  const double c_Nm = present(coulomb->estimate).value;
  const double w_rad_s = fastest.get<double>();
  return {{{0, c_Nm}, {w_rad_s, c_Nm + present(viscous->estimate).value * w_rad_s}},
          "straight line of Coulomb and viscous friction up to the fastest motion"};
}

}  // namespace

FrictionTable friction_table(const ArchivedJoint& joint) {
  const Recorded whole = Recorded::parse(joint.calibration, nullptr, false);
  const std::vector<FrictionRow> rows = merged(measured_points(whole));
  FrictionTable table;
  if (rows.empty()) {
    table = straight_line(joint, whole);
  } else {
    table.source = fmt::format(
        "runs at {} constant speeds, mean of the directions where both were recorded; at rest the "
        "torque of the slowest, {:.6g} rad/s at the motor",
        rows.size(), rows.front().speed_rad_s);
    table.rows = rows;
    table.rows.insert(table.rows.begin(), {0, rows.front().friction_Nm});
  }
  for (const FrictionRow& row : table.rows) {
    if (row.friction_Nm > 0) continue;
    return {{},
            fmt::format("the friction curve has {:.3g} N·m at {:.3g} rad/s: not above zero",
                        row.friction_Nm, row.speed_rad_s)};
  }
  return table;
}

FrictionTable at_joint(FrictionTable table, double gear_ratio) {
  for (FrictionRow& row : table.rows) {
    row.speed_rad_s /= gear_ratio;
    row.friction_Nm *= gear_ratio;
  }
  return table;
}

}  // namespace tribolog::exports::results
