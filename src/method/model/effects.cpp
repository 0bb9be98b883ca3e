#include "method/model/effects.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include <Eigen/Core>

#include "statistics/linear_systems.h"

namespace tribolog::method::model {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;
using std::numbers::pi;

/// Beyond it a random effect says no more than the noise of neighbouring cells does.
constexpr std::size_t most_random = 120;

MatrixXd beside(const ArrayXd& a, const ArrayXd& b) {
  MatrixXd both(a.size(), 2);
  both << a.matrix(), b.matrix();
  return both;
}

/// One column for each sweep and one for all runs, 1 at its cells; of many sweeps, one for all.
/// None where there is but one.
MatrixXd homing_columns(const Cells& cells) {
  constexpr std::size_t most_sweeps = 4;
  std::map<int, Index> sweeps;
  bool has_runs = false;
  for (const Cell& row : cells.rows) {
    if (row.count == 0) continue;
    if (row.is_run > 0) {
      has_runs = true;
    } else {
      sweeps.emplace(row.recording, 0);
    }
  }
  const bool is_one = sweeps.size() > most_sweeps;
  Index next = 0;
  for (auto& [recording, column] : sweeps) column = is_one ? 0 : next++;
  const Index of_sweeps = is_one ? 1 : next;
  const Index all = of_sweeps + (has_runs ? 1 : 0);
  if (all < 2) return {cells.size(), 0};
  MatrixXd columns = MatrixXd::Zero(cells.size(), all);
  for (Index i = 0; i < cells.size(); ++i) {
    const Cell& row = cells.rows[static_cast<std::size_t>(i)];
    if (row.count > 0) columns(i, row.is_run > 0 ? of_sweeps : sweeps.at(row.recording)) = 1;
  }
  return columns;
}

/// Cell::others of all rows.
MatrixXd others_of(const Cells& cells) {
  MatrixXd all(cells.size(), static_cast<Index>(values_of_other * cells.others()));
  for (Index i = 0; i < cells.size(); ++i) {
    const std::vector<double>& row = cells.rows[static_cast<std::size_t>(i)].others;
    // Points of the friction curve have none.
    if (row.empty()) {
      all.row(i).setZero();
    } else {
      all.row(i) = Eigen::Map<const RowVectorXd>(row.data(), all.cols());
    }
  }
  return all;
}

}  // namespace

double Point::friction_at(double speed_rad_s) const {
  const double dip = dip_speed_rad_s > 0
                         ? dip_Nm * std::exp(-std::pow(speed_rad_s / dip_speed_rad_s, dip_power))
                         : 0;
  return coulomb_Nm + viscous_Nms_rad * speed_rad_s + dip;
}

Eigen::RowVector2d Point::asymmetry_at(double speed_rad_s, double slowest_rad_s) const {
  const double dip_speed = dip_speed_rad_s > 0 ? dip_speed_rad_s : 2 * slowest_rad_s;
  return {speed_rad_s / fastest_rad_s, std::exp(-std::pow(speed_rad_s / dip_speed, dip_power))};
}

Point first_point(const Cells& cells, bool has_gravity) {
  const ArrayXd torque = cells.of(&Cell::torque_Nm);
  const ArrayXd v = cells.of(&Cell::speed_rad_s);
  const VectorXd count = cells.of(&Cell::count);
  MatrixXd x = plain_columns(cells);
  const VectorXd size = (x.array().square().colwise().mean().sqrt() + 1e-12).matrix();
  x.array().rowwise() /= size.transpose().array();
  MatrixXd gram = x.transpose() * count.asDiagonal() * x;
  gram.diagonal().array() += 1e-4 * count.sum();
  const VectorXd theta =
      statistics::solve_normal(gram, x.transpose() * (count.array() * torque).matrix())
          .cwiseQuotient(size);
  Point p;
  p.top_Nm = value_at_share(torque.abs(), 0.98);
  p.friction_Nm =
      std::clamp(value_at_share((theta[4] + theta[5] * v).abs(), 0.5), 0.03 * p.top_Nm, p.top_Nm);
  p.fastest_rad_s = v.maxCoeff();
  if (has_gravity) {
    p.gravity_cos_Nm = theta[0];
    p.gravity_sin_Nm = theta[1];
  }
  p.inertia_kgm2 = theta[3];
  p.coulomb_Nm = theta[4];
  p.viscous_Nms_rad = theta[5];
  return p;
}

LawHats law_hats(const Cells& cells, const Point& point) {
  LawHats hats;
  hats.fastest_rad_s = point.fastest_rad_s;
  const ArrayXd v = cells.of(&Cell::speed_rad_s);
  const ArrayXd u = v.log();
  const double span = u.maxCoeff() - u.minCoeff();
  if (!(span > 0.3)) return hats;
  const auto count = std::clamp<Index>(std::lround(span / 0.7), 2, 9);
  hats.knots = ArrayXd::LinSpaced(count, u.minCoeff(), u.maxCoeff());
  hats.width = 0.8 * span / static_cast<double>(count - 1);
  MatrixXd all(v.size(), count);
  for (Index i = 0; i < v.size(); ++i) all.row(i) = hats.whole(v[i]);
  const ArrayXd root = cells.of(&Cell::count).sqrt();
  const MatrixXd line = beside(root, root * v / point.fastest_rad_s);
  all.array().colwise() *= root;
  hats.on_line = statistics::least_squares(line, all);
  return hats;
}

RowVectorXd LawHats::whole(double speed_rad_s) const {
  return (-0.5 * ((std::log(speed_rad_s) - knots) / width).square()).exp().matrix().transpose();
}

RowVectorXd LawHats::bent(double speed_rad_s) const {
  return whole(speed_rad_s) - on_line.row(0) - speed_rad_s / fastest_rad_s * on_line.row(1);
}

std::vector<EffectColumns> effect_columns(const Cells& cells, bool has_gravity, const Point& point,
                                          const joint::EffectSizes& sizes) {
  namespace effect = joint::effect;
  const Index n = cells.size();
  const ArrayXd s = cells.of(&Cell::direction);
  const ArrayXd v = cells.of(&Cell::speed_rad_s);
  const ArrayXd t = cells.of(&Cell::time_s);
  const ArrayXd q = cells.of(&Cell::q_rad);
  const ArrayXd cos_q = cells.of(&Cell::cos_q);
  const ArrayXd sin_q = cells.of(&Cell::sin_q);
  const ArrayXd a = cells.of(&Cell::acceleration_rad_s2);
  const ArrayXd count = cells.of(&Cell::count);
  const ArrayXd run = cells.of(&Cell::is_run);
  const ArrayXd one = ArrayXd::Ones(n);
  const double top = point.top_Nm;
  const double friction = point.friction_Nm;
  std::vector<EffectColumns> all;
  const auto add = [&](const Effect& of, const MatrixXd& columns, const ArrayXd& scale) {
    if ((scale > 0).all()) all.push_back({&of, columns, scale.matrix()});
  };
  const auto add_one = [&](const Effect& of, const ArrayXd& column, double scale) {
    add(of, column.matrix(), ArrayXd::Constant(1, scale));
  };
  // Percent as shares, mrad and ms in SI.
  const auto size_of = [&](const Effect& of) {
    return sizes.of(of) * (of.unit == "percent" ? 0.01 : 0.001);
  };

  const bool has_runs = (run > 0).any();
  const bool has_sweeps = (run == 0).any();
  const bool runs_go_both_ways = has_runs && (s * run).minCoeff() < 0 && (s * run).maxCoeff() > 0;
  const ArrayXd at = has_runs && (runs_go_both_ways || !has_sweeps) ? run : one;
  const ArrayXd share = count * at / (count * at).sum();
  const auto about_runs = [&](const ArrayXd& x) -> ArrayXd { return x - (share * x).sum(); };

  const ArrayXd g = point.gravity_cos_Nm * cos_q + point.gravity_sin_Nm * sin_q;
  const ArrayXd place = cells.of(&Cell::has_place);
  const bool has_place = (place > 0).any();
  const double infinite = std::numeric_limits<double>::infinity();
  const double low = has_place ? (place * count > 0).select(q, infinite).minCoeff() : 0;
  const double high = has_place ? (place * count > 0).select(q, -infinite).maxCoeff() : 0;
  const double middle = (low + high) / 2;
  const ArrayXd x = place * (q - middle) / std::max((high - low) / 2, 1e-9);
  const auto [begin_s, end_s] = cells.session_s();
  const ArrayXd age = (t - begin_s) / std::max(end_s - begin_s, 1e-9);

  if (has_gravity && has_place) {
    add(effect::gravity, beside(cos_q, sin_q), ArrayXd::Constant(2, 3 * top));
  } else if (!cells.is_turning && has_place) {
    add(effect::gravity_left, beside(cos_q, sin_q),
        ArrayXd::Constant(2, size_of(effect::gravity_left) * top));
  }
  if (has_place) add_one(effect::inertia, a, 3 * top / std::max(a.abs().maxCoeff(), 1e-9));

  const MatrixXd others = others_of(cells);
  const auto of_others = [&](auto keep) -> MatrixXd {
    std::vector<Index> columns;
    for (Index k = 0; k < others.cols(); ++k) {
      const bool is_acceleration = k % values_of_other == values_of_other - 1;
      if (is_acceleration == keep && others.col(k).cwiseAbs().maxCoeff() > 0) columns.push_back(k);
    }
    return others(Eigen::all, columns);
  };
  if (const MatrixXd moved = of_others(false); has_gravity && moved.cols() > 0) {
    add(effect::others_gravity, moved,
        ArrayXd::Constant(moved.cols(), size_of(effect::others_gravity) * top));
  }
  if (const MatrixXd accelerated = of_others(true); accelerated.cols() > 0) {
    add(effect::others_inertia, accelerated,
        size_of(effect::others_inertia) * top /
            accelerated.cwiseAbs().colwise().maxCoeff().array().transpose());
  }

  // What the torque's signal does.
  const double rising = (count * (s > 0).cast<double>()).sum() / count.sum();
  const bool one_way = std::min(rising, 1 - rising) < 0.05;
  // Friction that differs with the direction has a part that does not differ from an offset.
  const double offset_Nm =
      std::hypot(size_of(effect::offset) * top, size_of(effect::asymmetry) * friction);
  add_one(effect::offset, one,
          one_way && offset_Nm > 0 ? std::max(0.05 * top, friction) : offset_Nm);
  add_one(effect::offset_drift, 2 * age - 1, size_of(effect::offset_drift) * top);
  if (has_gravity && has_place) {
    add_one(effect::gain_drift, g * about_runs(2 * age - 1), size_of(effect::gain_drift));
  }
  const ArrayXd own_friction =
      s * v.unaryExpr([&](double speed) { return point.friction_at(speed); });
  const ArrayXd model = g + point.inertia_kgm2 * a + own_friction;
  add(effect::torque_nonlinear, beside(model * model.abs() / top, model.cube() / (top * top)),
      ArrayXd::Constant(2, size_of(effect::torque_nonlinear)));
  add_one(effect::gain_of_speed, model * v / point.fastest_rad_s, size_of(effect::gain_of_speed));
  if (has_runs && has_sweeps) {
    add_one(effect::gain_of_runs, model * run, size_of(effect::gain_of_runs));
    if (has_gravity && has_place) add_one(effect::tool, place * g * run, size_of(effect::tool));
  }
  const ArrayXd rate = point.gravity_cos_Nm * cells.of(&Cell::cos_rate) +
                       point.gravity_sin_Nm * cells.of(&Cell::sin_rate) +
                       point.inertia_kgm2 * cells.of(&Cell::jerk_rad_s3) +
                       point.viscous_Nms_rad * a;
  ArrayXd intervals = cells.of(&Cell::interval_s);
  std::nth_element(intervals.begin(), intervals.begin() + n / 2, intervals.end());
  const double lag_s = size_of(effect::lag);
  add_one(effect::lag, -rate,
          sizes.is_stated(effect::lag) ? lag_s : std::max(lag_s, 0.3 * intervals[n / 2]));

  // Direction.
  MatrixXd uneven(n, 2);
  const double slowest = v.minCoeff();
  for (Index k = 0; k < n; ++k) uneven.row(k) = point.asymmetry_at(v[k], slowest);
  add(effect::asymmetry, uneven, ArrayXd::Constant(2, 0.4 * size_of(effect::asymmetry) * friction));

  // Friction by load, place and time; torque by place.
  if (has_gravity && has_place)
    add_one(effect::load, s * about_runs(g.abs()), size_of(effect::load));
  if (!has_place) {
    // Points alone: no angle.
  } else if (cells.is_turning) {
    constexpr Index orders = 4;
    MatrixXd turn(n, 2 * orders);
    ArrayXd order(2 * orders);
    for (Index k = 0; k < orders; ++k) {
      const auto multiple = static_cast<double>(k + 1);
      turn.col(2 * k) = place * (multiple * q).cos();
      turn.col(2 * k + 1) = place * (multiple * q).sin();
      order[2 * k] = order[2 * k + 1] = multiple;
    }
    add(effect::position, s.matrix().asDiagonal() * turn,
        size_of(effect::position) * friction / order);
    add(effect::torque_over_turn, turn, size_of(effect::torque_over_turn) * top / order);
  } else {
    const auto mode = [&](double k) -> ArrayXd { return place * (pi * k * (x + 1) / 2).cos(); };
    MatrixXd places(n, 5);
    for (Index k = 0; k < 5; ++k) {
      places.col(k) = s * about_runs(mode(static_cast<double>(k + 1)));
    }
    add(effect::position, places,
        size_of(effect::position) * friction / ArrayXd::LinSpaced(5, 1, 5));
    if (has_gravity) {
      add_one(effect::hoses, x, size_of(effect::hoses) * top);
      const ArrayXd steep = place * (point.gravity_sin_Nm * cos_q - point.gravity_cos_Nm * sin_q);
      add_one(effect::angle_scale, steep * (q - middle), size_of(effect::angle_scale));
      add_one(effect::peak_drift, steep * (2 * age - 1), size_of(effect::peak_drift));
      if (const MatrixXd own = homing_columns(cells); own.cols() > 0) {
        add(effect::homing, steep.matrix().asDiagonal() * own,
            ArrayXd::Constant(own.cols(), size_of(effect::homing)));
      }
      const double peak = std::atan2(point.gravity_sin_Nm, point.gravity_cos_Nm);
      MatrixXd waves(n, 4);
      for (Index k = 0; k < 2; ++k) {
        waves.col(2 * k) = place * (static_cast<double>(k + 2) * (q - peak)).cos();
        waves.col(2 * k + 1) = place * (static_cast<double>(k + 2) * (q - peak)).sin();
      }
      add(effect::harmonics, waves, ArrayXd::Constant(4, size_of(effect::harmonics) * top));
    }
    MatrixXd modes(n, 6);
    for (Index k = 0; k < 6; ++k) modes.col(k) = mode(static_cast<double>(k + 3));
    add(effect::smooth_over_angle, modes,
        size_of(effect::smooth_over_angle) * top / ArrayXd::LinSpaced(6, 1, 6));
  }
  // Of a motor that hardly turns it is friction over the joint's angle.
  constexpr double fewest_turns = 3;
  if (has_place && cells.gear_ratio * (high - low) > fewest_turns * 2 * pi) {
    MatrixXd turns(n, 4);
    for (Index i = 0; i < n; ++i) {
      turns.row(i) =
          Eigen::Map<const RowVectorXd>(cells.rows[static_cast<std::size_t>(i)].motor.data(), 4);
    }
    add(effect::motor_turn, (place * s).matrix().asDiagonal() * turns,
        ArrayXd::Constant(4, size_of(effect::motor_turn) * friction));
  }
  std::set<int> strokes;
  std::map<int, Index> recordings;
  for (const Cell& row : cells.rows) {
    if (row.count == 0) continue;
    strokes.insert(row.stroke);
    recordings.emplace(row.recording, 0);
  }
  if (strokes.size() > 2) {
    MatrixXd ages(n, 3);
    ages << (s * about_runs((-age / 0.12).exp())).matrix(),
        (s * about_runs((-age / 0.4).exp())).matrix(), (s * about_runs(age)).matrix();
    add(effect::drift, ages, ArrayXd::Constant(3, size_of(effect::drift) * friction));
  }

  add_one(effect::friction_of_session, own_friction, size_of(effect::friction_of_session));

  // What no law of friction over the speed is exact about.
  const LawHats hats = law_hats(cells, point);
  if (hats.knots.size() > 0) {
    MatrixXd bent(n, hats.knots.size());
    MatrixXd whole(n, hats.knots.size());
    for (Index i = 0; i < n; ++i) {
      bent.row(i) = s[i] * hats.bent(v[i]);
      whole.row(i) = s[i] * hats.whole(v[i]);
    }
    // Of the friction at the speed, where that is less than usual: where viscous torque is most of
    // it, the usual one is much at slow speeds.
    constexpr double least = 0.1;
    const ArrayXd misfit =
        size_of(effect::law_misfit) * hats.knots.unaryExpr([&](double log_speed) {
          return std::clamp(point.friction_at(std::exp(log_speed)), least * friction, friction);
        });
    add(effect::law_misfit, bent, misfit);
    add(effect::law_at_its_ends, whole, effect::law_at_its_ends.typical * misfit);
  }

  // What nothing explains: friction of its own in each recording; of few recordings, each stroke.
  const bool by_recording = recordings.size() > 3;
  std::map<int, Index> groups;
  for (const Cell& row : cells.rows) {
    if (row.count > 0) groups.emplace(by_recording ? row.recording : row.stroke, 0);
  }
  if (groups.size() > 2 && groups.size() <= most_random) {
    Index next = 0;
    for (auto& [key, column] : groups) column = next++;
    MatrixXd own = MatrixXd::Zero(n, next);
    for (Index i = 0; i < n; ++i) {
      const Cell& row = cells.rows[static_cast<std::size_t>(i)];
      if (row.count > 0) own(i, groups.at(by_recording ? row.recording : row.stroke)) = 1;
    }
    if (by_recording) {
      add(effect::tare, own, ArrayXd::Constant(next, size_of(effect::tare) * top));
    }
    add(effect::friction_of_recording, s.matrix().asDiagonal() * own,
        ArrayXd::Constant(next, size_of(effect::friction_of_recording) * friction));
  }
  return all;
}

}  // namespace tribolog::method::model
