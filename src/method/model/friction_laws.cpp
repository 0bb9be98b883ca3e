#include "method/model/friction_laws.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Dense>

namespace tribolog::method::model {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// Viscous torque in one power of the speed, or two.
struct Family {
  std::string_view key;
  std::array<double, 2> powers;  // 0: none

  /// Of each law, less the line's: the less typical the farther from the line.
  [[nodiscard]] double log_prior() const {
    if (powers[1] > 0) return -1;
    return powers[0] == 1 ? 0 : -2.5 - 3 * std::abs(std::log(powers[0]));
  }
};

constexpr std::array families{Family{"line", {1, 0}},           Family{"parabola", {1, 2}},
                              Family{"sublinear", {0.4, 0}},    Family{"sublinear", {0.55, 0}},
                              Family{"sublinear", {0.7, 0}},    Family{"sublinear", {0.85, 0}},
                              Family{"superlinear", {1.25, 0}}, Family{"superlinear", {1.5, 0}},
                              Family{"superlinear", {1.75, 0}}};

/// Of the fastest speed: a dip beyond it is no dip but the law.
constexpr double widest_dip = 0.4;

/// Level at zero speed and slope of the straight line nearest to a column; of one speed alone, the
/// line from zero.
Eigen::Vector2d line_through(const LawColumn& column, const ArrayXd& v, const ArrayXd& weight,
                             double top) {
  if (!(v.maxCoeff() > (1 + 1e-6) * v.minCoeff())) return {0, column.at(top, top) / top};
  const ArrayXd f = v.unaryExpr([&](double speed) { return column.at(speed, top); });
  const ArrayXd share = weight / weight.sum();
  const double mean = (share * v).sum();
  const ArrayXd about = share * (v - mean);
  const double slope = (about * f).sum() / (about * v).sum();
  return {(share * f).sum() - slope * mean, slope};
}

/// What a coefficient adds to Coulomb torque and viscous coefficient, in each meaning.
using Meanings = std::array<Eigen::Vector2d, 3>;

}  // namespace

double LawColumn::at(double speed_rad_s, double fastest_rad_s) const {
  return dip_speed > 0 ? std::exp(-std::pow(speed_rad_s / dip_speed, dip_power))
                       : std::pow(speed_rad_s / fastest_rad_s, power);
}

Eigen::MatrixXd FrictionLaws::torque(const Cells& cells) const {
  Eigen::MatrixXd all(cells.size(), static_cast<Index>(columns.size()));
  for (Index i = 0; i < cells.size(); ++i) {
    const Cell& row = cells.rows[static_cast<std::size_t>(i)];
    for (Index k = 0; k < all.cols(); ++k) {
      all(i, k) =
          row.direction * columns[static_cast<std::size_t>(k)].at(row.speed_rad_s, fastest_rad_s);
    }
  }
  return all;
}

FrictionLaws candidate_laws(const Cells& cells, const Point& point, double near_speed_rad_s,
                            double half_span, const std::vector<double>& dip_powers) {
  const double top = point.fastest_rad_s;
  const double low = std::max(cells.of(&Cell::speed_rad_s).minCoeff(), top * 1e-4);
  FrictionLaws all;
  all.fastest_rad_s = top;
  all.columns.push_back({});  // Coulomb torque

  std::vector<LawColumn> dips;
  double step = coarse_dip_step;
  if (top / low > 3) {
    std::vector<double> speeds;
    if (near_speed_rad_s > 0) {
      step = half_span / dips_each_side;
      for (int k = -dips_each_side; k <= dips_each_side; ++k) {
        speeds.push_back(std::min(near_speed_rad_s * std::exp(k * step), widest_dip * top));
      }
    } else {
      for (double u = std::log(low); u < std::log(widest_dip * top); u += step) {
        speeds.push_back(std::exp(u));
      }
    }
    for (double speed : speeds) {
      for (double power : dip_powers) dips.push_back({0, speed, power});
    }
  }
  const double each_dip =
      std::log(step / std::max(std::log(widest_dip * top / low), coarse_dip_step) /
               static_cast<double>(dip_powers.size()));
  const auto first_dip = static_cast<Index>(all.columns.size());
  all.columns.insert(all.columns.end(), dips.begin(), dips.end());
  std::vector<std::pair<double, Index>> powers;
  const auto column_of = [&](double power) {
    for (const auto& [known, index] : powers) {
      if (known == power) return index;
    }
    powers.emplace_back(power, static_cast<Index>(all.columns.size()));
    all.columns.push_back({power, 0, 0});
    return powers.back().second;
  };
  const ArrayXd even = ArrayXd::LinSpaced(50, low, top);
  const ArrayXd measured = cells.of(&Cell::speed_rad_s);
  const ArrayXd count = cells.of(&Cell::count);
  for (const Family& family : families) {
    FrictionLaw law;
    law.family = family.key;
    law.log_prior = family.log_prior();
    std::vector<double> scale{2 * point.friction_Nm};
    const Eigen::Vector2d coulomb(1, 0);
    std::vector<Meanings> meanings{{coulomb, coulomb, coulomb}};
    law.index = {0};
    law.is_positive = {true};
    for (double power : family.powers) {
      if (power == 0) continue;
      const bool bends = power == 2;
      const LawColumn column{power, 0, 0};
      law.index.push_back(column_of(power));
      scale.push_back((bends ? 0.25 : 1.5) * point.friction_Nm);
      meanings.push_back({Eigen::Vector2d(0, 1 / top),
                          line_through(column, even, ArrayXd::Ones(even.size()), top),
                          line_through(column, measured, count, top)});
      law.is_positive.push_back(!bends);
    }
    const auto put = [&](bool has_dip, std::size_t dip) {
      FrictionLaw one = law;
      std::vector<double> scales = scale;
      std::vector<Meanings> all_meanings = meanings;
      if (has_dip) {
        one.has_dip = true;
        one.dip = dips[dip];
        one.index.push_back(first_dip + static_cast<Index>(dip));
        one.is_positive.push_back(true);
        one.log_prior += each_dip;
        scales.push_back(0.5 * point.friction_Nm);
        const Eigen::Vector2d none(0, 0);
        all_meanings.push_back({none, none, none});
      }
      const auto coefficients = static_cast<Index>(scales.size());
      one.scale = Eigen::Map<const Eigen::VectorXd>(scales.data(), coefficients);
      for (std::size_t m = 0; m < one.meanings.size(); ++m) {
        one.meanings[m].resize(2, coefficients);
        for (Index k = 0; k < coefficients; ++k) {
          one.meanings[m].col(k) = all_meanings[static_cast<std::size_t>(k)][m];
        }
      }
      all.laws.push_back(std::move(one));
    };
    put(false, 0);
    for (std::size_t dip = 0; dip < dips.size(); ++dip) put(true, dip);
  }
  return all;
}

}  // namespace tribolog::method::model
