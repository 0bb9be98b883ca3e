#include "exports/results/friction_table.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "base/requirements.h"
#include "calibration/read_calibration.h"
#include "method/motion/plateaus.h"

namespace tribolog::exports::results {
namespace {

struct MergedSpeed {
  double speed_sum{};
  double friction_sum{};
  int runs{};
  [[nodiscard]] double speed() const { return speed_sum / runs; }
};

/// Of a run and its partner of the other direction: over the angles that both share, where they do.
FrictionRow of_both_directions(const calibration::RecordedFriction& runs, std::size_t k) {
  const auto other = static_cast<std::size_t>(runs.partner[k]);
  const double speed = (std::abs(runs.speed_rad_s[k]) + std::abs(runs.speed_rad_s[other])) / 2;
  const auto along = [&](std::size_t run) {
    return runs.speed_rad_s[run] < 0 ? -runs.friction_Nm[run] : runs.friction_Nm[run];
  };
  const double sign = runs.speed_rad_s[k] < 0 ? -1 : 1;
  const double difference = sign * runs.direction_difference_Nm[k];
  return {speed, std::isfinite(difference) ? difference : (along(k) + along(other)) / 2};
}

/// What both directions have in common at the paired speed that is nearest: an offset of the
/// torque.
double offset_near(const calibration::RecordedFriction& runs, double speed_rad_s) {
  double nearest = std::numeric_limits<double>::infinity();
  double offset_Nm = 0;
  for (std::size_t k = 0; k < runs.speed_rad_s.size(); ++k) {
    const double apart = std::abs(std::log(std::abs(runs.speed_rad_s[k]) / speed_rad_s));
    if (runs.partner[k] < 0 || !(apart < nearest)) continue;
    nearest = apart;
    offset_Nm =
        (runs.friction_Nm[k] + runs.friction_Nm[static_cast<std::size_t>(runs.partner[k])]) / 2;
  }
  return offset_Nm;
}

/// Friction against absolute speed, sorted. Of a speed that was recorded in one direction alone the
/// offset is taken off that the others show; where none was recorded in both, it is in there.
std::vector<FrictionRow> measured_points(const calibration::RecordedFriction& runs,
                                         bool& has_pairs) {
  std::vector<FrictionRow> points;
  has_pairs = std::any_of(runs.partner.begin(), runs.partner.end(), [](int k) { return k >= 0; });
  if (runs.from_sweep) return points;
  for (std::size_t k = 0; k < runs.speed_rad_s.size(); ++k) {
    const double sign = runs.speed_rad_s[k] < 0 ? -1 : 1;
    const double speed = sign * runs.speed_rad_s[k];
    if (speed == 0) continue;
    points.push_back(runs.partner[k] >= 0 ? of_both_directions(runs, k)
                                          : FrictionRow{speed, sign * (runs.friction_Nm[k] -
                                                                       offset_near(runs, speed))});
  }
  std::sort(points.begin(), points.end(), [](const FrictionRow& a, const FrictionRow& b) {
    return a.speed_rad_s < b.speed_rad_s;
  });
  return points;
}

std::vector<FrictionRow> merged(const std::vector<FrictionRow>& points) {
  std::vector<MergedSpeed> speeds;
  for (const FrictionRow& p : points) {
    if (speeds.empty() ||
        p.speed_rad_s > (1 + method::motion::same_speed) * speeds.back().speed()) {
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
  const auto is_known = [](const calibration::Quantity* q) {
    return q != nullptr && q->verdict != calibration::Verdict::not_identifiable;
  };
  if (!is_known(coulomb) || !is_known(viscous) || !fastest_rad_s) {
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
  bool has_pairs = false;
  const std::vector<FrictionRow> rows = merged(measured_points(curves.friction, has_pairs));
  FrictionTable table;
  if (rows.empty()) {
    table = straight_line(joint, curves.fastest_rad_s);
  } else {
    table.source = fmt::format(
        "runs at {} constant speeds, {}; at rest the torque of the slowest, {:.6g} rad/s at the "
        "motor",
        rows.size(),
        has_pairs ? "half the difference between the directions"
                  : "in one direction alone: an offset of the torque is in it",
        rows.front().speed_rad_s);
    table.rows = rows;
    table.rows.insert(table.rows.begin(), {0, rows.front().friction_Nm});
  }
  for (const FrictionRow& row : table.rows) {
    if (row.friction_Nm > 0) continue;
    return {{},
            fmt::format("the friction curve has {:.3g} {} at {:.3g} rad/s: not above zero",
                        row.friction_Nm, joint.is_in_amperes() ? "A" : "N·m", row.speed_rad_s)};
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
