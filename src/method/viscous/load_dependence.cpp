#include "method/viscous/load_dependence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <Eigen/Core>

#include "method/motion/sweep_samples.h"
#include "statistics/block_regression.h"
#include "statistics/held_out.h"
#include "statistics/linear_systems.h"

namespace tribolog::method::viscous {
namespace {

constexpr std::size_t cells = 48;
constexpr std::size_t cells_in_a_block = 3;
constexpr std::size_t fewest_cells = 18;
// A change of the load by less than this share of the gravity torque is hidden by any ripple.
constexpr double least_change = 0.2;
// A speed that varies by less than this share of the fastest counts as constant.
constexpr double constant_share = 0.1;

struct Row {
  std::size_t cell;
  double q_rad, load_Nm, speed_rad_s, friction_Nm;
  double rising_rad, rising_Nm, falling_rad, falling_Nm;
};

struct Mean {
  double torque{}, speed{}, angle{}, samples{};
};

/// Half differences of neighbouring strokes at equal angle, in the order of the cells.
std::vector<Row> paired_rows(const motion::Sweep& sweep, const gravity::CogSweepResult& found,
                             double q_peak, double gear_ratio) {
  const motion::SweepSamples& samples = sweep.samples;
  const double width = (found.highest_rad - found.lowest_rad) / static_cast<double>(cells);
  const double inertia = found.inertia_kgm2 ? found.inertia_kgm2->value * gear_ratio : 0.0;
  std::map<std::pair<std::size_t, std::size_t>, Mean> means;  // (cell, stroke)
  std::map<std::size_t, double> direction;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double q = sweep.q_rad(i);
    const auto cell = std::min(cells - 1, static_cast<std::size_t>((q - found.lowest_rad) / width));
    Mean& m = means[{cell, samples.stroke[i]}];
    m.torque += sweep.torque_Nm(i) - inertia * samples.acceleration_rad_s2[i];
    m.speed += gear_ratio * std::abs(samples.speed_rad_s[i]);
    m.angle += q;
    m.samples += 1;
    direction[samples.stroke[i]] = samples.direction[i];
  }
  std::vector<std::size_t> rising;
  std::vector<std::size_t> falling;
  for (const auto& [stroke, sign] : direction) (sign > 0 ? rising : falling).push_back(stroke);
  constexpr double fewest_samples = 3;
  std::vector<Row> rows;
  for (std::size_t cell = 0; cell < cells; ++cell) {
    for (std::size_t k = 0; k < std::min(rising.size(), falling.size()); ++k) {
      const auto up = means.find({cell, rising[k]});
      const auto down = means.find({cell, falling[k]});
      if (up == means.end() || down == means.end()) continue;
      const Mean& u = up->second;
      const Mean& d = down->second;
      if (u.samples < fewest_samples || d.samples < fewest_samples) continue;
      const double q = (u.angle / u.samples + d.angle / d.samples) / 2;
      rows.push_back({cell, q, std::abs(found.gravity_Nm.value * std::cos(q - q_peak)),
                      (u.speed / u.samples + d.speed / d.samples) / 2,
                      (u.torque / u.samples - d.torque / d.samples) / 2, u.angle / u.samples,
                      u.torque / u.samples, d.angle / d.samples, d.torque / d.samples});
    }
  }
  return rows;
}

enum class Terms { speed, speed_and_load, load, constant, cubic_of_speed };

Eigen::MatrixXd columns_of(const std::vector<Row>& rows, Terms terms) {
  const auto n = static_cast<Eigen::Index>(rows.size());
  const bool has_speed = terms == Terms::speed || terms == Terms::speed_and_load;
  const bool has_load = terms == Terms::load || terms == Terms::speed_and_load;
  const Eigen::Index extra = terms == Terms::cubic_of_speed ? 3 : has_speed + has_load;
  Eigen::MatrixXd x(n, 1 + extra);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Row& row = rows[static_cast<std::size_t>(i)];
    x(i, 0) = 1;
    Eigen::Index next = 1;
    if (has_load) x(i, next++) = row.load_Nm;
    if (has_speed) x(i, next++) = row.speed_rad_s;
    if (terms == Terms::cubic_of_speed) {
      for (Eigen::Index power = 1; power <= 3; ++power) {
        x(i, power) = std::pow(row.speed_rad_s, static_cast<double>(power));
      }
    }
  }
  return x;
}

/// Whether the mean of `worse - better` exceeds its standard error.
bool pays(const std::vector<double>& worse, const std::vector<double>& better) {
  const statistics::ErrorDifference gain = statistics::difference(worse, better);
  return gain.mean > gain.standard_error;
}

void add_points(const std::vector<Row>& rows, const Eigen::VectorXd& residuals,
                LoadDependenceResult& out) {
  for (std::size_t first = 0; first < rows.size();) {
    LoadPoint p;
    std::size_t last = first;
    for (; last < rows.size() && rows[last].cell == rows[first].cell; ++last) {
      const Row& row = rows[last];
      p.q_rad += row.q_rad;
      p.load_Nm += row.load_Nm;
      p.speed_rad_s += row.speed_rad_s;
      p.friction_Nm += row.friction_Nm;
      p.fit_Nm += row.friction_Nm - residuals(static_cast<Eigen::Index>(last));
    }
    const auto n = static_cast<double>(last - first);
    out.points.push_back(
        {p.q_rad / n, p.load_Nm / n, p.speed_rad_s / n, p.friction_Nm / n, p.fit_Nm / n});
    first = last;
  }
}

/// The torques of both directions over the angle, one row each.
struct BothDirections {
  /// Gravity in two parts, offset, friction; and what the angle adds, and the speed to friction.
  Eigen::MatrixXd columns;
  Eigen::VectorXd torque_Nm;
  std::vector<std::size_t> blocks;
};

/// What a sweep's torque holds beside gravity, offset and a friction that is the same throughout.
struct Beside {
  bool of_angle{};
  bool of_speed{};
};

/// @param blocks of the rows.
BothDirections both_directions(const std::vector<Row>& rows, const std::vector<std::size_t>& blocks,
                               const Beside& beside) {
  const auto n = static_cast<Eigen::Index>(rows.size());
  const Eigen::Index columns = 4 + (beside.of_angle ? 2 : 0) + (beside.of_speed ? 2 : 0);
  BothDirections out{Eigen::MatrixXd(2 * n, columns), Eigen::VectorXd(2 * n), {}};
  double fastest = 0;
  for (const Row& row : rows) fastest = std::max(fastest, row.speed_rad_s);
  for (Eigen::Index i = 0; i < 2 * n; ++i) {
    const Row& row = rows[static_cast<std::size_t>(i / 2)];
    const bool rises = i % 2 == 0;
    const double q = rises ? row.rising_rad : row.falling_rad;
    out.columns.row(i).head<4>() << std::cos(q), std::sin(q), 1, rises ? 1 : -1;
    if (beside.of_angle) out.columns.row(i).segment<2>(4) << std::cos(2 * q), std::sin(2 * q);
    if (beside.of_speed) {
      const double speed = row.speed_rad_s / fastest;
      out.columns.row(i).tail<2>() << out.columns(i, 3) * speed, out.columns(i, 3) * speed * speed;
    }
    out.torque_Nm(i) = rises ? row.rising_Nm : row.falling_Nm;
    out.blocks.push_back(blocks[static_cast<std::size_t>(i / 2)]);
  }
  return out;
}

/// The fit with further columns.
statistics::BlockRegression with_columns(const BothDirections& all,
                                         const std::vector<Eigen::VectorXd>& further) {
  Eigen::MatrixXd columns = all.columns;
  for (const Eigen::VectorXd& one : further) {
    columns.conservativeResize(Eigen::NoChange, columns.cols() + 1);
    columns.rightCols<1>() = one;
  }
  return statistics::block_regression(columns, all.torque_Nm, all.blocks);
}

/// A saturation that would do what an offset of the torque does: near the gravity peak both make
/// the cosine's amplitude look smaller.
std::optional<TorqueProportion> saturation_for_offset(const BothDirections& all,
                                                      const statistics::BlockRegression& plain,
                                                      const Eigen::VectorXd& cube, double unit_Nm) {
  constexpr double beyond_doubt = 1.5;  // half widths
  constexpr double about_as_well = 1.05;
  constexpr Eigen::Index offset = 2;
  if (std::abs(plain.coefficients(offset)) < beyond_doubt * plain.half_width(offset)) {
    return std::nullopt;
  }
  Eigen::MatrixXd columns = all.columns;
  columns.col(offset) = cube;
  const statistics::BlockRegression fit =
      statistics::block_regression(columns, all.torque_Nm, all.blocks);
  if (fit.residuals.squaredNorm() > about_as_well * plain.residuals.squaredNorm()) {
    return std::nullopt;
  }
  return TorqueProportion{OutOfProportion::saturation_or_offset,
                          statistics::symmetric_estimate(fit.coefficients(offset) / unit_Nm,
                                                         fit.half_width(offset) / unit_Nm,
                                                         {"interval.paired_strokes"})};
}

/// Friction that changes with the joint's angle: what its second harmonic has in common with the
/// load, or with a cube of the torque, is no sign of these.
std::vector<Eigen::VectorXd> friction_of_angle(const BothDirections& all) {
  const Eigen::ArrayXd cosine = all.columns.col(0).array();
  const Eigen::ArrayXd sine = all.columns.col(1).array();
  const Eigen::ArrayXd direction = all.columns.col(3).array();
  return {direction * cosine, direction * sine, direction * (cosine.square() - sine.square()),
          2 * direction * cosine * sine};
}

/// The cube beside it, in the last column, where it describes the sweep certainly better than the
/// cube does without it. A saturation bends the mean of both directions as well, which no friction
/// does.
/// @param best squared residuals with the cube, with or without the load.
std::optional<statistics::BlockRegression> cube_beside_friction_of_angle(
    const BothDirections& all, const Eigen::VectorXd& cube, double best) {
  constexpr double certainly_better = 1.25;
  std::vector<Eigen::VectorXd> further = friction_of_angle(all);
  const double of_angle = with_columns(all, further).residuals.squaredNorm();
  if (best < certainly_better * of_angle) return std::nullopt;
  further.push_back(cube);
  return with_columns(all, further);
}

/// A share that grows with the torque's magnitude, T |T|. While the torque keeps its sign that is
/// friction by the load and a torque of twice the angle, in a proportion that only it explains.
std::optional<TorqueProportion> share_by_magnitude(const std::vector<Row>& rows,
                                                   const std::vector<std::size_t>& blocks) {
  constexpr double beyond_doubt = 1.5;  // half widths
  constexpr double about_as_well = 1.05;
  const BothDirections all = both_directions(rows, blocks, {false, false});
  const statistics::BlockRegression plain = with_columns(all, {});
  const double gravity = std::hypot(plain.coefficients(0), plain.coefficients(1));
  const Eigen::ArrayXd along = all.columns.leftCols<2>() * plain.coefficients.head<2>() / gravity;
  const Eigen::ArrayXd across =
      (all.columns.col(1) * plain.coefficients(0) - all.columns.col(0) * plain.coefficients(1)) /
      gravity;
  const Eigen::VectorXd twist = 2 * along * across;
  const Eigen::VectorXd even = along.square() - across.square();
  const Eigen::VectorXd load = all.columns.col(3).array() * along.abs();
  const Eigen::ArrayXd torque = (all.torque_Nm - plain.residuals) / gravity;
  const statistics::BlockRegression square =
      with_columns(all, {twist, (torque * torque.abs()).matrix()});
  const double left = square.residuals.squaredNorm();
  const auto is_worse = [&](const std::vector<Eigen::VectorXd>& further, double by) {
    return with_columns(all, further).residuals.squaredNorm() > by * left;
  };
  const bool wins = is_worse({twist, load}, about_as_well) &&
                    is_worse({twist, even}, about_as_well) &&
                    is_worse({twist, torque.cube().matrix()}, 1) &&
                    is_worse({twist, load, even}, 1 / about_as_well);
  const Eigen::Index last = square.coefficients.size() - 1;
  if (!wins || square.coefficients(last) < beyond_doubt * square.half_width(last)) {
    return std::nullopt;
  }
  // At the peak the mean of G + F and G - F has 1 + (F/G)^2 of the square.
  const double unit_Nm = gravity / (1 + std::pow(plain.coefficients(3) / gravity, 2));
  return TorqueProportion{OutOfProportion::saturation,
                          statistics::symmetric_estimate(square.coefficients(last) / unit_Nm,
                                                         square.half_width(last) / unit_Nm,
                                                         {"interval.paired_strokes"})};
}

/// @param blocks of the rows.
/// @param load_found whether friction seems to grow with the load.
std::optional<TorqueProportion> torque_out_of_proportion(const std::vector<Row>& rows,
                                                         const std::vector<std::size_t>& blocks,
                                                         const Beside& beside, bool load_found) {
  const BothDirections all = both_directions(rows, blocks, beside);
  const statistics::BlockRegression plain = with_columns(all, {});
  const double gravity = std::hypot(plain.coefficients(0), plain.coefficients(1));
  const double friction = plain.coefficients(3);
  const Eigen::VectorXd torque = all.torque_Nm - plain.residuals;
  const Eigen::VectorXd weight = all.columns.leftCols<2>() * plain.coefficients.head<2>() / gravity;
  const Eigen::VectorXd load = all.columns.col(3).cwiseProduct(weight.cwiseAbs());
  const Eigen::VectorXd cube = (torque / gravity).array().cube();
  constexpr double width = 0.02;  // of the dead zone's edges, of gravity: means of cells are soft
  const Eigen::VectorXd edge = (torque / (width * gravity)).cwiseMax(-1).cwiseMin(1);

  const statistics::BlockRegression saturated = with_columns(all, {cube});
  /// Of the last column, in this unit.
  const auto share_of = [](const statistics::BlockRegression& fit, double unit_Nm) {
    const Eigen::Index last = fit.coefficients.size() - 1;
    return statistics::symmetric_estimate(fit.coefficients(last) / unit_Nm,
                                          fit.half_width(last) / unit_Nm,
                                          {"interval.paired_strokes"});
  };
  // Seen over the angle only where the torque changes its sign within a direction.
  const Eigen::VectorXd left = statistics::left_by_columns(all.columns, edge);
  constexpr double least_seen = 0.1;
  if (left.norm() > least_seen * edge.norm()) {
    const statistics::BlockRegression dead = with_columns(all, {edge});
    const double of_load = with_columns(all, {load}).residuals.squaredNorm();
    const statistics::Estimate share = share_of(dead, gravity);
    if (share.low > 0 &&
        dead.residuals.squaredNorm() < std::min(of_load, saturated.residuals.squaredNorm())) {
      return TorqueProportion{OutOfProportion::dead_zone, share};
    }
  }
  // At the peak the mean of G + F and G - F has 1 + 3 (F/G)^2 of the cube.
  const double unit_Nm = gravity / (1 + 3 * std::pow(friction / gravity, 2));
  if (beside.of_speed) return saturation_for_offset(all, plain, cube, unit_Nm);
  const statistics::Estimate alone = share_of(saturated, unit_Nm);
  const statistics::BlockRegression both = with_columns(all, {load, cube});
  const double best = std::min(saturated.residuals.squaredNorm(), both.residuals.squaredNorm());
  constexpr double beyond_doubt = 1.5;  // half widths
  if (const auto beside_it = cube_beside_friction_of_angle(all, cube, best)) {
    const statistics::Estimate share = share_of(*beside_it, unit_Nm);
    return share.value > beyond_doubt * share.half_width()
               ? std::optional(TorqueProportion{OutOfProportion::saturation, share})
               : std::nullopt;
  }
  const Eigen::Index of_load_in_both = all.columns.cols();
  const bool needs_load =
      both.coefficients(of_load_in_both) > beyond_doubt * both.half_width(of_load_in_both);
  if (needs_load) {
    const statistics::Estimate share = share_of(both, unit_Nm);
    return share.low > 0 ? std::optional(TorqueProportion{OutOfProportion::saturation, share})
                         : std::nullopt;
  }
  const double certainty = load_found ? 1 : beyond_doubt;  // friction by load is common
  if (alone.value > certainty * alone.half_width()) {
    return TorqueProportion{OutOfProportion::saturation, alone};
  }
  return saturation_for_offset(all, plain, cube, unit_Nm);
}

}  // namespace

std::string to_string(OutOfProportion form) {
  switch (form) {
    case OutOfProportion::saturation:
      return "saturation";
    case OutOfProportion::dead_zone:
      return "dead_zone";
    case OutOfProportion::saturation_or_offset:
      return "saturation_or_offset";
  }
  return "";
}

LoadDependenceResult identify_load_dependence(const motion::Sweep& sweep,
                                              const gravity::CogSweepResult& rough,
                                              const std::optional<statistics::Estimate>& q_peak_rad,
                                              double gear_ratio) {
  LoadDependenceResult out;
  if (!rough.found || !q_peak_rad || !rough.both_directions) {
    out.sentence = {"load_dependence.no_sweep_in_both_directions"};
    return out;
  }
  const std::vector<Row> rows = paired_rows(sweep, rough, q_peak_rad->value, gear_ratio);
  double slowest = std::numeric_limits<double>::infinity();
  double fastest = 0;
  std::size_t used_cells = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    slowest = std::min(slowest, rows[i].speed_rad_s);
    fastest = std::max(fastest, rows[i].speed_rad_s);
    out.lowest_load_Nm = i == 0 ? rows[i].load_Nm : std::min(out.lowest_load_Nm, rows[i].load_Nm);
    out.highest_load_Nm = std::max(out.highest_load_Nm, rows[i].load_Nm);
    used_cells += i == 0 || rows[i].cell != rows[i - 1].cell ? 1 : 0;
  }
  if (used_cells < fewest_cells) {
    out.sentence = {"load_dependence.too_few_shared_cells",
                    {{"shared", used_cells}, {"cells", cells}}};
    return out;
  }
  if (out.highest_load_Nm - out.lowest_load_Nm < least_change * rough.gravity_Nm.value) {
    out.sentence = {"load_dependence.load_changes_too_little",
                    {{"lowest_Nm", out.lowest_load_Nm},
                     {"highest_Nm", out.highest_load_Nm},
                     {"needed_percent", 100 * least_change}}};
    return out;
  }
  const bool speed_changes = fastest - slowest > constant_share * fastest;
  const Terms with = speed_changes ? Terms::speed_and_load : Terms::load;
  const Terms without = speed_changes ? Terms::speed : Terms::constant;
  Eigen::VectorXd y(static_cast<Eigen::Index>(rows.size()));
  std::vector<std::size_t> blocks;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    y(static_cast<Eigen::Index>(i)) = rows[i].friction_Nm;
    const bool is_new =
        i > 0 && rows[i].cell / cells_in_a_block != rows[i - 1].cell / cells_in_a_block;
    blocks.push_back(i == 0 ? 0 : blocks.back() + (is_new ? 1 : 0));
  }
  const statistics::BlockRegression fit =
      statistics::block_regression(columns_of(rows, with), y, blocks);
  const auto estimate = [&](Eigen::Index k) {
    return statistics::symmetric_estimate(fit.coefficients(k), fit.half_width(k),
                                          {"interval.paired_strokes"});
  };
  out.unloaded_Nm = estimate(0);
  out.per_load = estimate(1);
  if (speed_changes) out.viscous_Nms_rad = estimate(2);
  const auto held_out = [&](Terms terms) {  // one block of angles at a time
    return statistics::held_out_errors(columns_of(rows, terms), y, blocks);
  };
  const std::vector<double> errors = held_out(with);
  const std::vector<double> errors_without = held_out(without);
  out.held_out_Nm = statistics::root_mean(errors);
  out.held_out_without_load_Nm = statistics::root_mean(errors_without);
  out.held_out_speed_alone_Nm = speed_changes
                                    ? statistics::root_mean(held_out(Terms::cubic_of_speed))
                                    : std::numeric_limits<double>::quiet_NaN();
  add_points(rows, fit.residuals, out);
  out.examined = true;
  out.found = out.per_load.low > 0 && pays(errors_without, errors);
  const Beside beside{rough.of_angle || rough.twist_rad, speed_changes};
  out.out_of_proportion = torque_out_of_proportion(rows, blocks, beside, out.found);
  if (!out.out_of_proportion && !speed_changes) {
    out.out_of_proportion = share_by_magnitude(rows, blocks);
  }
  if (!out.found) {
    out.sentence = {"load_dependence.does_not_show",
                    {{"share_percent", 100 * out.per_load.value},
                     {"low_percent", 100 * out.per_load.low},
                     {"high_percent", 100 * out.per_load.high},
                     {"error_Nm", out.held_out_Nm},
                     {"error_without_load_Nm", out.held_out_without_load_Nm}}};
    return out;
  }
  out.sentence = {"load_dependence.found",
                  {{"share_percent", 100 * out.per_load.value},
                   {"low_percent", 100 * out.per_load.low},
                   {"high_percent", 100 * out.per_load.high},
                   {"unloaded_Nm", out.unloaded_Nm.value},
                   {"added_Nm", out.per_load.value * out.highest_load_Nm},
                   {"error_Nm", out.held_out_Nm},
                   {"error_without_load_Nm", out.held_out_without_load_Nm}}};
  const bool speed_rivals = speed_changes && out.held_out_speed_alone_Nm <= out.held_out_Nm;
  if (speed_rivals) out.sentence.add({"load_dependence.curved_viscous_law_rivals"});
  return out;
}

}  // namespace tribolog::method::viscous
