#include "method/model/friction_laws.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/Core>

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
  const ArrayXd direction = cells.of(&Cell::direction);
  const ArrayXd v = cells.of(&Cell::speed_rad_s);
  const ArrayXd u = v.log();
  for (Index k = 0; k < all.cols(); ++k) {
    const LawColumn& column = columns[static_cast<std::size_t>(k)];
    all.col(k) =
        direction *
        (column.dip_speed > 0
             ? ArrayXd((-(column.dip_power * (u - std::log(column.dip_speed))).exp()).exp())
             : ArrayXd((v / fastest_rad_s).pow(column.power)));
  }
  return all;
}

std::vector<std::vector<DipGrid>> coarse_dips() {
  std::vector<DipGrid> grids;
  for (const double power : {0.7, 1.0, 1.4, 2.0, 2.8}) grids.push_back({power});
  return std::vector<std::vector<DipGrid>>(families.size(), grids);
}

namespace {

struct Dip {
  LawColumn column;
  double log_prior{};
};

/// @param low slowest speed. @param top fastest.
std::vector<Dip> dips_of(const std::vector<DipGrid>& grids, double low, double top) {
  constexpr double of_dips = -1;  // of all of them, less that of no dip
  std::vector<Dip> dips;
  const double range = std::max(std::log(widest_dip * top / low), coarse_dip_step);
  for (const DipGrid& grid : grids) {
    const double step = grid.step();
    const double prior = of_dips + std::log(step / range / static_cast<double>(grids.size()));
    const bool is_near = grid.near_rad_s > 0;
    const double from = is_near ? std::log(grid.near_rad_s) - grid.half_span : std::log(low);
    const int count = is_near
                          ? 2 * dips_each_side + 1
                          : static_cast<int>(std::ceil((std::log(widest_dip * top) - from) / step));
    for (int k = 0; k < count; ++k) {
      const double speed = std::min(std::exp(from + k * step), widest_dip * top);
      dips.push_back({{0, speed, grid.power}, prior});
    }
  }
  return dips;
}

}  // namespace

FrictionLaws candidate_laws(const Cells& cells, const Point& point,
                            const std::vector<std::vector<DipGrid>>& grids) {
  const double top = point.fastest_rad_s;
  const double low = std::max(cells.of(&Cell::speed_rad_s).minCoeff(), top * 1e-4);
  const bool can_dip = top / low > 3;
  FrictionLaws all;
  all.fastest_rad_s = top;
  all.columns.push_back({});  // Coulomb torque
  std::map<std::pair<double, double>, Index> known_dips;
  const auto column_of_dip = [&](const LawColumn& dip) {
    const auto [at, is_new] = known_dips.try_emplace({dip.dip_speed, dip.dip_power},
                                                     static_cast<Index>(all.columns.size()));
    if (is_new) all.columns.push_back(dip);
    return at->second;
  };
  std::map<double, Index> column_of_power;
  for (const Family& family : families) {
    for (const double power : family.powers) {
      if (power == 0 || column_of_power.contains(power)) continue;
      column_of_power[power] = static_cast<Index>(all.columns.size());
      all.columns.push_back({power, 0, 0});
    }
  }
  all.dips_from = static_cast<Index>(all.columns.size());
  const ArrayXd even = ArrayXd::LinSpaced(50, low, top);
  const ArrayXd measured = cells.of(&Cell::speed_rad_s);
  const ArrayXd count = cells.of(&Cell::count);
  for (std::size_t form = 0; form < families.size(); ++form) {
    const Family& family = families[form];
    FrictionLaw law;
    law.form = form;
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
      law.index.push_back(column_of_power.at(power));
      scale.push_back((bends ? 0.25 : 1.5) * point.friction_Nm);
      meanings.push_back({Eigen::Vector2d(0, 1 / top),
                          line_through(column, even, ArrayXd::Ones(even.size()), top),
                          line_through(column, measured, count, top)});
      law.is_positive.push_back(!bends);
    }
    const auto put = [&](const Dip* dip) {
      FrictionLaw one = law;
      std::vector<double> scales = scale;
      std::vector<Meanings> all_meanings = meanings;
      if (dip != nullptr) {
        one.has_dip = true;
        one.dip = dip->column;
        one.index.push_back(column_of_dip(dip->column));
        one.is_positive.push_back(true);
        one.log_prior += dip->log_prior;
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
    put(nullptr);
    if (!can_dip) continue;
    for (const Dip& dip : dips_of(grids[form], low, top)) put(&dip);
  }
  return all;
}

}  // namespace tribolog::method::model
