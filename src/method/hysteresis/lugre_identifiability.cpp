#include "method/hysteresis/lugre_identifiability.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "statistics/linear_systems.h"

namespace tribolog::method::hysteresis {
namespace {

using Shared = LuGreShared;

constexpr Code interval_from{"interval.loop_fit_blocks"};

using Reading = statistics::LinearisedReading;

class Reader {
 public:
  explicit Reader(const LuGreClimb& climb) : climb_(climb) {}

  [[nodiscard]] Eigen::VectorXd none() const {
    return Eigen::VectorXd::Zero(climb_.linear.r_factor.cols());
  }
  void add(Shared::Index parameter, double factor, Eigen::VectorXd& gradient) const {
    const Eigen::Index k = climb_.column(parameter);
    if (k >= 0) gradient(k) += factor;
  }
  [[nodiscard]] Reading product(
      double value, std::initializer_list<std::pair<Shared::Index, double>> powers) const {
    Reading out{value, none(), true};
    for (const auto& [parameter, power] : powers) add(parameter, power, out.gradient);
    return out;
  }
  [[nodiscard]] Reading plain(Shared::Index parameter) const {
    Reading out{climb_.point.shared(parameter), none(), false};
    add(parameter, 1, out.gradient);
    return out;
  }
  /// Torque due to a change of the reading by its size that no other parameter can imitate.
  [[nodiscard]] double effect_Nm(const Reading& r) const {
    const Eigen::VectorXd row =
        statistics::solve_transposed_triangle(climb_.linear.r_factor, r.gradient);
    const double size = r.logarithmic ? 1.0 : std::abs(r.value);
    return size / (row.norm() * std::sqrt(static_cast<double>(climb_.linear.fit.residuals.size())));
  }

 private:
  const LuGreClimb& climb_;
};

statistics::Estimate estimate_of(const Reading& r, double half_width) {
  if (!r.logarithmic) return statistics::symmetric_estimate(r.value, half_width, interval_from);
  return {r.value, r.value * std::exp(-half_width), r.value * std::exp(half_width), interval_from};
}

/// Judges a reading that the fit varied.
LuGreParameter judged(LuGreParameterName name, const char* unit, const Reading& r,
                      const Reader& reader, const LuGreClimb& climb) {
  LuGreParameter out;
  out.name = name;
  const double half = climb.around.half_width_along(r.gradient);
  const double size = r.logarithmic ? 1.0 : std::abs(r.value);
  const double relative = half / size;
  out.relative_error = climb.around.standard_error_along(r.gradient) / size;
  out.effect_Nm = reader.effect_Nm(r);
  const double smallest = smallest_effect * climb.height_Nm;
  const bool is_bounded = std::isfinite(half) && std::isfinite(*out.effect_Nm);
  const bool has_effect = *out.effect_Nm > smallest;
  if (!is_bounded) {
    out.why_not = {"lugre.any_value_fits"};
  } else if (!has_effect) {
    out.why_not = {"lugre.effect_too_small",
                   {{"effect_Nm", *out.effect_Nm},
                    {"smallest_Nm", smallest},
                    {"smallest_share", smallest_effect}}};
  } else if (r.value + half < 0) {
    out.why_not = {"lugre.negative", {{"value", r.value}, {"unit", unit}}};
  } else if (relative < widest_shown) {
    out.estimate = estimate_of(r, half);
  } else {
    const statistics::Estimate wide = estimate_of(r, half);
    out.why_not = {"lugre.interval_too_wide",
                   {{"low", wide.low}, {"high", wide.high}, {"unit", unit}}};
  }
  return out;
}

LuGreParameter held(LuGreParameterName name, std::optional<double> at, Statement why) {
  LuGreParameter out;
  out.name = name;
  out.held_at = at;
  out.why_not = std::move(why);
  return out;
}

struct Size {
  Code name;
  double value;
};

/// Natural size of a shared parameter's variable.
Size size_of(Shared::Index parameter, const LuGreClimb& climb, double peak_speed,
             double peak_acceleration) {
  const double friction = climb.height_Nm / 2;
  switch (parameter) {
    case Shared::log_stiffness:
      return {"lugre_column.bristle_stiffness", 1};
    case Shared::log_static:
      return {"lugre_column.static_torque", 1};
    case Shared::log_share:
      return {"lugre_column.coulomb_torque", 1};
    case Shared::fall:
      return {"lugre_column.stribeck_speed", climb.rung == LuGreRung::whole
                                                 ? 2 * climb.point.shared(Shared::fall)
                                                 : climb.point.shared(Shared::fall)};
    case Shared::damping:
      return {"lugre_column.bristle_damping", friction / peak_speed};
    case Shared::viscous:
      return {"lugre_column.viscous_coefficient", friction / peak_speed};
    case Shared::inertia:
      return {"lugre_column.inertia", friction / peak_acceleration};
  }
  return {{}, 1};
}

/// The columns that make up a direction, the largest first, each with its sign.
Statement described_direction(const std::vector<Statement>& names,
                              const std::vector<double>& direction) {
  constexpr double worth_naming = 0.3;
  std::vector<std::size_t> order(names.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(direction[a]) > std::abs(direction[b]);
  });
  Statement found = names[order.front()];
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (std::abs(direction[order[i]]) < worth_naming) break;
    const bool same_side = direction[order[i]] * direction[order.front()] > 0;
    found = {same_side ? Code{"lugre_column.together_with"} : Code{"lugre_column.against"},
             {{"columns", found}, {"column", names[order[i]]}}};
  }
  return found;
}

}  // namespace

std::vector<LuGreParameter> read_lugre_parameters(const LuGreClimb& climb,
                                                  const LoopEffects& effects,
                                                  double peak_speed_rad_s) {
  const Reader reader(climb);
  const Shared::Vector& p = climb.point.shared;
  const double s0 = std::exp(p(Shared::log_stiffness));
  const double ts = std::exp(p(Shared::log_static));
  const double share = std::exp(p(Shared::log_share));
  const double fall = p(Shared::fall);
  std::vector<LuGreParameter> out;
  const auto judge = [&](LuGreParameterName name, const char* unit, const Reading& r) {
    out.push_back(judged(name, unit, r, reader, climb));
    const double deviation = climb.around.standard_error_along(r.gradient);
    out.back().shares = effects.shares(r.gradient, deviation * deviation);
  };
  judge(LuGreParameterName::bristle_stiffness, "N·m/rad",
        reader.product(s0, {{Shared::log_stiffness, 1}}));
  if (climb.column(Shared::damping) >= 0) {
    judge(LuGreParameterName::bristle_damping, "N·m·s/rad", reader.plain(Shared::damping));
  } else {
    out.push_back(held(LuGreParameterName::bristle_damping, 0.0, Statement{}));
  }
  if (climb.column(Shared::viscous) >= 0) {
    judge(LuGreParameterName::viscous, "N·m·s/rad", reader.plain(Shared::viscous));
  } else {
    out.push_back(held(LuGreParameterName::viscous, 0.0, {"lugre.viscous_looks_like_damping"}));
  }
  if (climb.column(Shared::log_static) >= 0) {
    judge(LuGreParameterName::static_torque, "N·m", reader.product(ts, {{Shared::log_static, 1}}));
  } else {
    out.push_back(
        held(LuGreParameterName::static_torque, std::nullopt, {"lugre.loop_does_not_bend"}));
  }
  const bool whole = climb.rung == LuGreRung::whole;
  if (whole) {
    judge(LuGreParameterName::coulomb_torque, "N·m",
          reader.product(ts * share, {{Shared::log_static, 1}, {Shared::log_share, 1}}));
    judge(LuGreParameterName::stribeck_speed, "rad/s",
          reader.product(1 / std::sqrt(fall), {{Shared::fall, -0.5 / fall}}));
  } else {
    const Statement why{climb.rung == LuGreRung::curvature ? Code{"lugre.friction_begins_to_fall"}
                                                           : Code{"lugre.friction_not_yet_falling"},
                        {{"peak_speed_rad_s", peak_speed_rad_s}}};
    out.push_back(held(LuGreParameterName::coulomb_torque, std::nullopt, why));
    out.push_back(held(LuGreParameterName::stribeck_speed, std::nullopt, why));
  }
  if (climb.column(Shared::fall) >= 0) {
    judge(LuGreParameterName::speed_weakening, "N·m·s²/rad²",
          reader.product(ts * (1 - share) * fall, {{Shared::log_static, 1},
                                                   {Shared::log_share, -share / (1 - share)},
                                                   {Shared::fall, 1 / fall}}));
  } else {
    out.push_back(
        held(LuGreParameterName::speed_weakening, 0.0, {"lugre.same_friction_at_all_speeds"}));
  }
  if (climb.column(Shared::inertia) >= 0) {
    judge(LuGreParameterName::inertia, "kg·m²", reader.plain(Shared::inertia));
  } else {
    out.push_back(held(LuGreParameterName::inertia, 0.0, {"lugre.inertia_looks_elastic"}));
  }
  return out;
}

LuGreIdentifiability lugre_identifiability(const LuGreClimb& climb, double peak_speed_rad_s,
                                           double peak_acceleration_rad_s2) {
  LuGreIdentifiability out;
  const Eigen::MatrixXd& r = climb.linear.r_factor;
  std::vector<Eigen::Index> columns;
  std::vector<double> sizes;
  const auto use = [&](Eigen::Index column, const Size& size) {
    columns.push_back(column);
    out.names.emplace_back(size.name);
    sizes.push_back(size.value);
  };
  for (const Shared::Index parameter : climb.free.shared) {
    use(climb.column(parameter),
        size_of(parameter, climb, peak_speed_rad_s, peak_acceleration_rad_s2));
  }
  const double friction = climb.height_Nm / 2;
  const Eigen::Index gravity = LuGreProblem::gravity_column(climb.free, 0);
  use(gravity, {"lugre_column.gravity_torque", friction});
  if (climb.free.starts) {
    use(gravity + 1, {"lugre_column.deflection_at_start",
                      friction / std::exp(climb.point.shared(Shared::log_stiffness))});
  }
  const auto n = static_cast<Eigen::Index>(columns.size());
  // Rows of R^-1 are the pseudo-inverse of the Jacobian with the other columns projected out.
  Eigen::MatrixXd inverse(n, r.cols());
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto at = static_cast<std::size_t>(k);
    inverse.row(k) =
        statistics::solve_transposed_triangle(r, Eigen::VectorXd::Unit(r.cols(), columns[at]))
            .transpose() /
        sizes[at];
  }
  if (!inverse.allFinite()) return {};  // two columns are the same to the last bit
  const statistics::SingularValues svd = statistics::singular_values(inverse);
  const double root = std::sqrt(static_cast<double>(climb.linear.fit.residuals.size()));
  for (Eigen::Index k = n; k-- > 0;) {
    out.singular_values_Nm.push_back(1 / (svd.values(k) * root));
  }
  out.condition = svd.values(0) / svd.values(n - 1);
  for (Eigen::Index k = 0; k < n; ++k) out.weakest.push_back(svd.left(k, 0));
  out.weakest_statement = described_direction(out.names, out.weakest);
  for (Eigen::Index a = 0; a < n; ++a) {
    std::vector<double> row;
    for (Eigen::Index b = 0; b < n; ++b) {
      const auto i = columns[static_cast<std::size_t>(a)];
      const auto j = columns[static_cast<std::size_t>(b)];
      const Eigen::MatrixXd& c = climb.around.covariance;
      const double scale = std::sqrt(c(i, i) * c(j, j));
      row.push_back(scale > 0 ? c(i, j) / scale : (a == b ? 1.0 : 0.0));
    }
    out.correlation.push_back(std::move(row));
  }
  return out;
}

}  // namespace tribolog::method::hysteresis
