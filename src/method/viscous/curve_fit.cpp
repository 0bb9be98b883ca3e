#include "method/viscous/curve_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Core>

#include "method/viscous/curve_model.h"
#include "statistics/levenberg_marquardt.h"
#include "statistics/linear_systems.h"

namespace tribolog::method::viscous {

namespace {

// Shapes beyond these bounds are indistinguishable from a model with fewer parameters: a Stribeck
// effect below a thirtieth of the slowest speed or beyond three times the fastest, and powers so
// small or large that the term is a constant or a step.
constexpr double least_speed_share = 1.0 / 30;
constexpr double largest_speed = 3.0;
constexpr double least_power = 0.05;
constexpr double largest_power = 5.0;
constexpr double worst_condition = 1e-7;  // of columns scaled to length 1

struct Scaled {
  std::vector<CurveSample> samples;
  Eigen::VectorXd friction;
  double slowest{1.0};
};

Scaled scaled(const std::vector<CurveSample>& samples, double speed, double torque) {
  Scaled out;
  out.samples = samples;
  out.friction.resize(static_cast<Eigen::Index>(samples.size()));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    out.samples[i].speed_rad_s /= speed;
    out.friction(static_cast<Eigen::Index>(i)) = samples[i].friction_Nm / torque;
    out.slowest = std::min(out.slowest, out.samples[i].speed_rad_s);
  }
  return out;
}

bool is_speed(const CurveModel& model, Eigen::Index k) {
  return k == 0 && (model.law == CurveLaw::stribeck || model.law == CurveLaw::waiboer);
}

std::pair<double, double> bounds(const CurveModel& model, Eigen::Index k, double slowest) {
  return is_speed(model, k) ? std::pair{std::log(least_speed_share * std::max(slowest, 1e-9)),
                                        std::log(largest_speed)}
                            : std::pair{std::log(least_power), std::log(largest_power)};
}

Eigen::VectorXd clamped(const CurveModel& model, Eigen::VectorXd shape, double slowest) {
  for (Eigen::Index k = 0; k < shape.size(); ++k) {
    const auto [low, high] = bounds(model, k, slowest);
    shape(k) = std::clamp(shape(k), low, high);
  }
  return shape;
}

/// Columns at one shape, and the linear parameters that fit best.
struct Projection {
  Eigen::MatrixXd columns;
  std::vector<Eigen::MatrixXd> slopes;  // by each shape parameter
  statistics::OrthogonalColumns qr;
  Eigen::VectorXd linear;
  Eigen::VectorXd residual;

  Projection(const CurveModel& model, const Scaled& data, const Eigen::VectorXd& shape,
             bool with_slopes) {
    const auto rows = static_cast<Eigen::Index>(data.samples.size());
    columns.resize(rows, model.linear_parameters());
    if (with_slopes) {
      slopes.assign(static_cast<std::size_t>(shape.size()), Eigen::MatrixXd(rows, columns.cols()));
    }
    Eigen::RowVectorXd row;
    std::vector<Eigen::RowVectorXd> row_slopes;
    for (Eigen::Index i = 0; i < rows; ++i) {
      model_columns(model, data.samples[static_cast<std::size_t>(i)], shape, row,
                    with_slopes ? &row_slopes : nullptr);
      columns.row(i) = row;
      for (std::size_t k = 0; k < slopes.size(); ++k) slopes[k].row(i) = row_slopes[k];
    }
    qr = statistics::OrthogonalColumns(columns);
    linear = qr.solve(data.friction);
    residual = columns * linear - data.friction;
  }

  /// Kaufman: the slope of the columns, less what the linear parameters take up.
  [[nodiscard]] Eigen::MatrixXd jacobian() const {
    Eigen::MatrixXd j(columns.rows(), static_cast<Eigen::Index>(slopes.size()));
    for (std::size_t k = 0; k < slopes.size(); ++k) {
      const Eigen::VectorXd d = slopes[k] * linear;
      j.col(static_cast<Eigen::Index>(k)) = d - columns * qr.solve(d);
    }
    return j;
  }
};

bool are_distinct(const Eigen::MatrixXd& columns) {
  Eigen::MatrixXd unit = columns;
  for (Eigen::Index k = 0; k < unit.cols(); ++k) {
    const double norm = unit.col(k).norm();
    if (!(norm > 0)) return false;
    unit.col(k) /= norm;
  }
  const Eigen::MatrixXd gram = unit.transpose() * unit;
  return statistics::eigen_system(gram).values(0) > worst_condition;
}

std::vector<Eigen::VectorXd> grid(const CurveModel& model, double slowest) {
  const auto speeds = [&] {
    std::vector<double> logs;
    for (const double share : {0.05, 0.2, 0.35, 0.5, 0.65, 0.8}) {
      logs.push_back((1 - share) * std::log(std::max(slowest, 1e-6)));
    }
    return logs;
  };
  std::vector<Eigen::VectorXd> starts;
  if (model.law == CurveLaw::power_viscous) {
    for (const double p : {0.3, 0.6, 1.2, 2.0})
      starts.push_back(Eigen::VectorXd::Constant(1, std::log(p)));
  } else if (model.law == CurveLaw::stribeck) {
    for (const double s : speeds()) starts.push_back(Eigen::VectorXd::Constant(1, s));
  } else {
    for (const double s : speeds()) {
      for (const double sharpness : {0.6, 1.0, 2.0}) {
        for (const double power : {0.4, 0.8}) {
          starts.push_back(Eigen::Vector3d(s, std::log(sharpness), std::log(power)));
        }
      }
    }
  }
  return starts;
}

}  // namespace

double CurveFit::friction_Nm(const CurveSample& sample) const {
  CurveSample at = sample;
  at.speed_rad_s /= speed_scale_rad_s;
  Eigen::RowVectorXd columns;
  model_columns(model, at, shape, columns, nullptr);
  return torque_scale_Nm * columns.dot(linear);
}

double CurveFit::rms_Nm(const std::vector<CurveSample>& samples) const {
  double squares = 0;
  for (const CurveSample& s : samples) squares += std::pow(friction_Nm(s) - s.friction_Nm, 2);
  return std::sqrt(squares / static_cast<double>(samples.size()));
}

Statement CurveFit::impossible_because() const {
  const double power = model.law == CurveLaw::power_viscous ? std::exp(shape(0))
                       : model.law == CurveLaw::waiboer     ? std::exp(shape(2))
                                                            : 1.0;
  if (model.law == CurveLaw::waiboer) {
    if (linear(0) <= 0) return {"curve_fit.asperity_torque_not_positive"};
    if (linear(1) <= 0) return {"curve_fit.viscous_coefficient_not_positive"};
    if (power > 1 + 1e-6) return {"curve_fit.grows_faster_than_speed"};
    return {};
  }
  if (linear(0) <= 0) return {"curve_fit.coulomb_torque_not_positive"};
  if (model.law == CurveLaw::stribeck) {
    if (linear(1) <= 0) return {"curve_fit.friction_at_rest_below_coulomb"};
    if (linear(2) < 0) return {"curve_fit.viscous_coefficient_negative"};
  } else if (model.law != CurveLaw::coulomb && linear(1) < 0) {
    return {"curve_fit.viscous_coefficient_negative"};
  }
  return {};
}

std::optional<CurveFit> fit_curve(const CurveModel& model, const std::vector<CurveSample>& samples,
                                  const CurveFit* start) {
  CurveFit out;
  out.model = model;
  const auto rows = static_cast<Eigen::Index>(samples.size());
  if (rows < model.parameters()) return std::nullopt;
  if (start != nullptr) {
    out.speed_scale_rad_s = start->speed_scale_rad_s;
    out.torque_scale_Nm = start->torque_scale_Nm;
  } else {
    out.speed_scale_rad_s = out.torque_scale_Nm = 0;
    for (const CurveSample& s : samples) {
      out.speed_scale_rad_s = std::max(out.speed_scale_rad_s, s.speed_rad_s);
      out.torque_scale_Nm = std::max(out.torque_scale_Nm, std::abs(s.friction_Nm));
    }
    if (!(out.speed_scale_rad_s > 0) || !(out.torque_scale_Nm > 0)) return std::nullopt;
  }
  const Scaled data = scaled(samples, out.speed_scale_rad_s, out.torque_scale_Nm);
  out.shape.resize(model.shape_parameters());
  if (model.shape_parameters() > 0) {
    const statistics::LeastSquaresProblem problem{
        rows, [&](const Eigen::VectorXd& p, Eigen::VectorXd& r, Eigen::MatrixXd* j) {
          const Projection at(model, data, clamped(model, p, data.slowest), j != nullptr);
          r = at.residual;
          if (j != nullptr) *j = at.jacobian();
        }};
    std::vector<std::pair<double, Eigen::VectorXd>> starts;
    if (start != nullptr) {
      starts.emplace_back(0.0, start->shape);
    } else {
      for (const Eigen::VectorXd& s : grid(model, data.slowest)) {
        starts.emplace_back(Projection(model, data, s, false).residual.squaredNorm(), s);
      }
      std::stable_sort(starts.begin(), starts.end(),
                       [](const auto& a, const auto& b) { return a.first < b.first; });
      constexpr std::size_t tried = 3;
      starts.resize(std::min(starts.size(), tried));
    }
    double best = std::numeric_limits<double>::infinity();
    for (const auto& [unused, from] : starts) {
      const statistics::LeastSquaresSolution s = statistics::solve_least_squares(problem, from);
      // An exact curve ends in rounding, which the solver does not call converged.
      const bool is_usable = s.parameters.allFinite() && std::isfinite(s.cost);
      if (!is_usable || !(s.cost < best)) continue;
      best = s.cost;
      out.shape = clamped(model, s.parameters, data.slowest);
    }
    if (!std::isfinite(best)) return std::nullopt;
  }
  const Projection at(model, data, out.shape, false);
  if (!at.linear.allFinite() || !are_distinct(at.columns)) return std::nullopt;
  out.linear = at.linear;
  out.cost = at.residual.squaredNorm();
  return out;
}

Eigen::MatrixXd curve_jacobian(const CurveFit& fit, const std::vector<CurveSample>& samples) {
  const Scaled data = scaled(samples, fit.speed_scale_rad_s, fit.torque_scale_Nm);
  const Projection at(fit.model, data, fit.shape, true);
  Eigen::MatrixXd j(at.columns.rows(), fit.model.parameters());
  j.leftCols(at.columns.cols()) = at.columns;
  for (std::size_t k = 0; k < at.slopes.size(); ++k) {
    j.col(at.columns.cols() + static_cast<Eigen::Index>(k)) = at.slopes[k] * fit.linear;
  }
  return j;
}

namespace {

constexpr std::size_t enough_to_keep_the_ends = 6;

}  // namespace

std::vector<std::size_t> groups_to_hold_out(const std::vector<CurveSample>& samples) {
  const std::size_t all = group_count(samples);
  const std::size_t end = all >= enough_to_keep_the_ends ? 1 : 0;
  std::vector<std::size_t> groups;
  for (std::size_t g = end; g + end < all; ++g) groups.push_back(g);
  return groups;
}

std::vector<double> held_out_errors(const CurveFit& all, const std::vector<CurveSample>& samples,
                                    const std::vector<std::size_t>& groups) {
  std::vector<double> errors;
  std::vector<CurveSample> kept;
  for (const std::size_t group : groups) {
    kept.clear();
    for (const CurveSample& s : samples) {
      if (s.group != group) kept.push_back(s);
    }
    const auto fit = fit_curve(all.model, kept, &all);
    if (!fit) return {};
    double squares = 0;
    double count = 0;
    for (const CurveSample& s : samples) {
      if (s.group != group) continue;
      squares += std::pow(fit->friction_Nm(s) - s.friction_Nm, 2);
      count += 1;
    }
    errors.push_back(squares / count);
  }
  return errors;
}

}  // namespace tribolog::method::viscous
