#include "method/viscous/model_columns.h"

#include <algorithm>
#include <cmath>

namespace tribolog {

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

}  // namespace tribolog
