#include "exports/results/friction_table.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include <fmt/format.h>

#include "base/requirements.h"
#include "calibration/read_calibration.h"

namespace tribolog::exports::results {
namespace {

/// Runs of the two directions at one commanded speed differ by less.
constexpr double same_speed_share = 0.01;

struct MergedSpeed {
  double speed_sum{};
  double friction_sum{};
  int runs{};
  [[nodiscard]] double speed() const { return speed_sum / runs; }
};

/// Friction against absolute speed, sorted.
std::vector<FrictionRow> measured_points(const calibration::RecordedFriction& runs) {
  std::vector<FrictionRow> points;
  if (runs.from_sweep) return points;
  for (std::size_t k = 0; k < runs.speed_rad_s.size(); ++k) {
    const double sign = runs.speed_rad_s[k] < 0 ? -1 : 1;
    if (runs.speed_rad_s[k] == 0) continue;
    points.push_back({sign * runs.speed_rad_s[k], sign * runs.friction_Nm[k]});
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

FrictionTable straight_line(const ArchivedJoint& joint,
                            const std::optional<double>& fastest_rad_s) {
  const calibration::Quantity* const coulomb = joint.found(joint::Quantity::coulomb_torque);
  const calibration::Quantity* const viscous = joint.found(joint::Quantity::viscous_coefficient);
  if (coulomb == nullptr || viscous == nullptr || !fastest_rad_s) {
    return {{}, "the calibration holds no friction curve"};
  }
  const double c_Nm = present(coulomb->estimate).value;
  const double w_rad_s = *fastest_rad_s;
  return {{{0, c_Nm}, {w_rad_s, c_Nm + present(viscous->estimate).value * w_rad_s}},
          "straight line of Coulomb and viscous friction up to the fastest motion"};
}

}  // namespace

FrictionTable friction_table(const ArchivedJoint& joint) {
  const calibration::RecordedCurves curves = calibration::read_curves(joint.calibration);
  const std::vector<FrictionRow> rows = merged(measured_points(curves.friction));
  FrictionTable table;
  if (rows.empty()) {
    table = straight_line(joint, curves.fastest_rad_s);
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
