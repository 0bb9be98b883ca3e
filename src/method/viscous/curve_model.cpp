#include "method/viscous/curve_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace tribolog::method::viscous {

int CurveModel::shape_parameters() const {
  switch (law) {
    case CurveLaw::coulomb:
    case CurveLaw::coulomb_viscous:
      return 0;
    case CurveLaw::power_viscous:
    case CurveLaw::stribeck:
      return 1;
    case CurveLaw::waiboer:
      break;
  }
  return 3;
}

int CurveModel::linear_parameters() const {
  const int of_law = law == CurveLaw::coulomb ? 1 : law == CurveLaw::stribeck ? 3 : 2;
  const int of_direction = asymmetry == Asymmetry::none      ? 0
                           : asymmetry == Asymmetry::coulomb ? 1
                                                             : 2;
  return of_law + of_direction + (load ? 1 : 0);
}

std::string to_string(CurveLaw law) {
  switch (law) {
    case CurveLaw::coulomb:
      return "coulomb";
    case CurveLaw::coulomb_viscous:
      return "coulomb_viscous";
    case CurveLaw::power_viscous:
      return "power_viscous";
    case CurveLaw::stribeck:
      return "stribeck";
    case CurveLaw::waiboer:
      break;
  }
  return "waiboer";
}

std::string to_string(Asymmetry asymmetry) {
  switch (asymmetry) {
    case Asymmetry::none:
      return "none";
    case Asymmetry::coulomb:
      return "coulomb";
    case Asymmetry::coulomb_viscous:
      break;
  }
  return "coulomb_viscous";
}

Statement described(CurveLaw law) { return Code::of("curve_law." + to_string(law)); }

Statement described(const CurveModel& model) {
  const Statement law = described(model.law);
  switch (model.asymmetry) {
    case Asymmetry::none:
      return model.load ? Statement{"curve_model.with_load", {{"law", law}}} : law;
    case Asymmetry::coulomb:
      return {model.load ? Code{"curve_model.with_coulomb_of_directions_and_load"}
                         : Code{"curve_model.with_coulomb_of_directions"},
              {{"law", law}}};
    case Asymmetry::coulomb_viscous:
      break;
  }
  return {model.load ? Code{"curve_model.with_lines_of_directions_and_load"}
                     : Code{"curve_model.with_lines_of_directions"},
          {{"law", law}}};
}

namespace {

constexpr std::size_t sweep_groups = 12;

}  // namespace

std::vector<CurveSample> curve_samples(const ViscousCurvesResult& curves,
                                       const ViscousCurve& curve) {
  std::vector<std::size_t> order(curves.runs.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::size_t i) {
    const ConstantSpeedRun& run = curves.runs[i];
    return curves.from_sweep ? run.q_rad : std::abs(run.speed_rad_s);
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  std::vector<CurveSample> samples;
  double first = std::numeric_limits<double>::quiet_NaN();
  std::size_t group = 0;
  for (std::size_t place = 0; place < order.size(); ++place) {
    const ConstantSpeedRun& run = curves.runs[order[place]];
    const double direction = run.speed_rad_s < 0 ? -1.0 : 1.0;
    const double friction = direction * curve.friction_Nm[order[place]];
    if (curves.from_sweep) {
      group = place * std::min(sweep_groups, order.size()) / order.size();
    } else if (!(key(order[place]) <= (1 + same_speed) * first)) {
      group += samples.empty() ? 0 : 1;
      first = key(order[place]);
    }
    samples.push_back({std::abs(run.speed_rad_s), friction, direction, run.mean_load, group,
                       run.torque_standard_error_Nm, static_cast<double>(run.samples),
                       order[place]});
  }
  return samples;
}

std::size_t group_count(const std::vector<CurveSample>& samples) {
  return samples.empty() ? 0 : samples.back().group + 1;
}

void model_columns(const CurveModel& model, const CurveSample& sample, const Eigen::VectorXd& shape,
                   Eigen::RowVectorXd& columns, std::vector<Eigen::RowVectorXd>* derivatives) {
  const double w = std::max(sample.speed_rad_s, 1e-12);
  columns.setZero(model.linear_parameters());
  if (derivatives != nullptr) {
    derivatives->assign(static_cast<std::size_t>(model.shape_parameters()),
                        Eigen::RowVectorXd::Zero(columns.size()));
  }
  const auto slope = [&](std::size_t k, Eigen::Index column, double value) {
    if (derivatives != nullptr) (*derivatives)[k](column) = value;
  };
  Eigen::Index next = 0;
  double viscous = w;  // the law's viscous term, and its slope by the log of its power
  double viscous_slope = 0;
  std::size_t viscous_shape = 0;
  const auto raise = [&](double power, std::size_t k) {
    viscous = std::pow(w, power);
    viscous_slope = viscous * power * std::log(w);
    viscous_shape = k;
  };
  if (model.law == CurveLaw::waiboer) {
    const double speed = std::exp(shape(0));
    const double sharpness = std::exp(shape(1));
    const double power = std::pow(w / speed, sharpness);
    const double asperity = std::exp(-power);
    columns(next) = asperity;
    slope(0, next, asperity * power * sharpness);
    slope(1, next, -asperity * power * sharpness * std::log(w / speed));
    ++next;
    raise(std::exp(shape(2)), 2);
  } else {
    columns(next++) = 1;
    if (model.law == CurveLaw::power_viscous) raise(std::exp(shape(0)), 0);
    if (model.law == CurveLaw::stribeck) {
      const double square = std::pow(w / std::exp(shape(0)), 2);
      columns(next) = std::exp(-square);
      slope(0, next, 2 * square * columns(next));
      ++next;
    }
  }
  const auto add_viscous = [&](double sign) {
    columns(next) = sign * viscous;
    if (viscous_slope != 0) slope(viscous_shape, next, sign * viscous_slope);
    ++next;
  };
  if (model.law != CurveLaw::coulomb) add_viscous(1);
  if (model.asymmetry != Asymmetry::none) columns(next++) = sample.direction;
  if (model.asymmetry == Asymmetry::coulomb_viscous) add_viscous(sample.direction);
  if (model.load) columns(next++) = sample.load;
}

}  // namespace tribolog::method::viscous
