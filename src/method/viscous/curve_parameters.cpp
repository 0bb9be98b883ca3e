#include "method/viscous/curve_parameters.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <Eigen/Core>

#include "base/statement.h"
#include "method/viscous/model_choice.h"
#include "statistics/block_regression.h"

namespace tribolog::method::viscous {
namespace {

using Unknowns = Eigen::VectorXd;  // scaled linear parameters, then logarithms of the shape
using Quantity = std::function<double(const Unknowns&)>;

/// Builds the list; knows the index of each unknown.
class Parameters {
 public:
  Parameters(const CurveFit& fit, const std::vector<CurveSample>& samples) : fit_(fit) {
    const Eigen::MatrixXd j = curve_jacobian(fit, samples);
    Eigen::VectorXd residual(j.rows());
    std::vector<std::size_t> blocks;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      residual(static_cast<Eigen::Index>(i)) =
          (samples[i].friction_Nm - fit.friction_Nm(samples[i])) / fit.torque_scale_Nm;
      blocks.push_back(samples[i].group);
    }
    around_ = statistics::block_regression(j, residual, blocks);
    at_.resize(j.cols());
    at_ << fit.linear, fit.shape;
  }

  void add(const char* name, Code title, const char* unit, const Quantity& q) {
    const double h = half_width(q);
    list_.push_back({name, title, unit, {}, statistics::symmetric_estimate(q(at_), h, method_)});
  }

  /// In the unit that another parameter has.
  void add_in_unit_as(Code unit_as, const char* name, Code title, const Quantity& q) {
    add(name, title, "", q);
    list_.back().unit_as = unit_as;
  }

  /// For what is positive by nature: `log_q` is the logarithm.
  void add_positive(const char* name, Code title, const char* unit, const Quantity& log_q) {
    const double value = log_q(at_);
    const double h = half_width(log_q);
    list_.push_back({name,
                     title,
                     unit,
                     {},
                     {std::exp(value), std::exp(value - h), std::exp(value + h), method_}});
  }

  [[nodiscard]] double speed() const { return fit_.speed_scale_rad_s; }
  [[nodiscard]] double torque() const { return fit_.torque_scale_Nm; }
  [[nodiscard]] Eigen::Index shape(Eigen::Index k) const { return fit_.linear.size() + k; }
  std::vector<CurveParameter> take() { return std::move(list_); }

 private:
  double half_width(const Quantity& q) const {
    Eigen::VectorXd slope(at_.size());
    for (Eigen::Index k = 0; k < at_.size(); ++k) {
      const double step = 1e-6 * std::max(1.0, std::abs(at_(k)));
      Unknowns up = at_;
      Unknowns down = at_;
      up(k) += step;
      down(k) -= step;
      slope(k) = (q(up) - q(down)) / (2 * step);
    }
    return around_.half_width_along(slope);
  }

  const CurveFit& fit_;
  statistics::BlockRegression around_;
  Unknowns at_;
  std::vector<CurveParameter> list_;
  static constexpr Code method_{"interval.curve_fit_speeds"};
};

}  // namespace

std::vector<CurveParameter> curve_parameters(const CurveFit& fit,
                                             const std::vector<CurveSample>& samples) {
  Parameters list(fit, samples);
  const CurveModel& model = fit.model;
  const double torque = list.torque();
  const double speed = list.speed();
  const auto linear = [=](Eigen::Index k, double unit) {
    return [=](const Unknowns& p) { return unit * p(k); };
  };
  const auto log_shape = [&list](Eigen::Index k, double offset) {
    return [i = list.shape(k), offset](const Unknowns& p) { return p(i) + offset; };
  };
  /// N·m of the term at 1 rad/s: a (1/scale)^power.
  const auto at_unit_speed = [&list, torque, speed](Eigen::Index k, Eigen::Index power) {
    return [=, i = list.shape(power)](const Unknowns& p) {
      return torque * p(k) * std::pow(speed, -std::exp(p(i)));
    };
  };
  Eigen::Index next = 0;
  switch (model.law) {
    case CurveLaw::coulomb:
      list.add("coulomb_Nm", "curve_parameter.coulomb_torque", "N·m", linear(next++, torque));
      break;
    case CurveLaw::coulomb_viscous:
      list.add("coulomb_Nm", "curve_parameter.coulomb_torque", "N·m", linear(next++, torque));
      list.add("viscous_Nms_rad", "curve_parameter.viscous_coefficient", "N·m·s/rad",
               linear(next++, torque / speed));
      break;
    case CurveLaw::power_viscous:
      list.add("coulomb_Nm", "curve_parameter.coulomb_torque", "N·m", linear(next++, torque));
      list.add("viscous_coefficient", "curve_parameter.power_law_coefficient", "N·m·(s/rad)^p",
               at_unit_speed(next++, 0));
      list.add_positive("viscous_exponent", "curve_parameter.viscous_exponent", "",
                        log_shape(0, 0.0));
      break;
    case CurveLaw::stribeck:
      list.add("coulomb_Nm", "curve_parameter.coulomb_torque", "N·m", linear(next++, torque));
      list.add("stribeck_excess_Nm", "curve_parameter.excess_at_rest", "N·m",
               linear(next++, torque));
      list.add_positive("stribeck_speed_rad_s", "curve_parameter.stribeck_velocity", "rad/s",
                        log_shape(0, std::log(speed)));
      list.add("viscous_Nms_rad", "curve_parameter.viscous_coefficient", "N·m·s/rad",
               linear(next++, torque / speed));
      break;
    case CurveLaw::waiboer:
      list.add("asperity_torque_Nm", "curve_parameter.asperity_torque", "N·m",
               linear(next++, torque));
      list.add_positive("stribeck_speed_rad_s", "curve_parameter.stribeck_velocity", "rad/s",
                        log_shape(0, std::log(speed)));
      list.add_positive("stribeck_power", "curve_parameter.stribeck_power", "", log_shape(1, 0.0));
      list.add("viscous_coefficient", "curve_parameter.power_law_coefficient",
               "N·m·(s/rad)^(1−δ_v)", at_unit_speed(next++, 2));
      list.add_positive("viscous_exponent", "curve_parameter.waiboer_exponent", "",
                        log_shape(2, 0.0));
      break;
  }
  if (model.asymmetry != Asymmetry::none) {
    list.add("asymmetry_Nm", "curve_parameter.coulomb_asymmetry", "N·m", linear(next++, torque));
  }
  if (model.asymmetry == Asymmetry::coulomb_viscous) {
    if (model.law == CurveLaw::power_viscous || model.law == CurveLaw::waiboer) {
      list.add_in_unit_as("unit.as_viscous_coefficient", "viscous_asymmetry",
                          "curve_parameter.power_law_asymmetry",
                          at_unit_speed(next++, model.law == CurveLaw::waiboer ? 2 : 0));
    } else {
      list.add("viscous_asymmetry_Nms_rad", "curve_parameter.viscous_asymmetry", "N·m·s/rad",
               linear(next++, torque / speed));
    }
  }
  if (model.load) {
    list.add("load_Nm", "curve_parameter.load_torque", "N·m", linear(next++, torque));
  }
  return list.take();
}

}  // namespace tribolog::method::viscous
