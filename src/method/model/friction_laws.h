#pragma once
// Candidate laws of friction over the speed, each linear in its columns, and what Coulomb and
// viscous torque are in each.
//
//   F(v) = Tc + Tv (v / vmax)^p [+ Tp (v / vmax)^2] [+ Td exp(-(v / ws)^d)]

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "method/model/effects.h"

namespace tribolog::method::model {

/// One function of the speed.
struct LawColumn {
  double power{};      ///< Of v / fastest; without a dip.
  double dip_speed{};  ///< > 0: exp(-(v / dip_speed)^dip_power).
  double dip_power{};

  [[nodiscard]] double at(double speed_rad_s, double fastest_rad_s) const;
};

struct FrictionLaw {
  std::string_view family;          ///< "line", "parabola", "sublinear", "superlinear"
  std::size_t form{};               ///< Of the viscous torque: place of its family and power.
  std::vector<Eigen::Index> index;  ///< Of its columns among all, the Coulomb torque's first.
  Eigen::VectorXd scale;            ///< Prior of each coefficient [N·m].
  double log_prior{};
  bool has_dip{};
  LawColumn dip{};
  /// Coulomb torque and viscous coefficient (rows) as weights of the coefficients, in each of their
  /// meanings: limit at zero speed and secant to the fastest; the straight line nearest over the
  /// measured speeds; that nearest to the samples. The dip is taken off in all. They agree where
  /// the law is a line.
  std::array<Eigen::Matrix2Xd, 3> meanings;
  std::vector<bool> is_positive;  ///< Coefficients that are no negative friction.
};

struct FrictionLaws {
  std::vector<LawColumn> columns;  ///< Distinct; those of dips last.
  Eigen::Index dips_from{};        ///< Place of the first.
  std::vector<FrictionLaw> laws;
  double fastest_rad_s{};

  /// Torque of each column in each cell, of the direction's sign.
  [[nodiscard]] Eigen::MatrixXd torque(const Cells& cells) const;
};

/// Of log speed, between dips before one is known.
inline constexpr double coarse_dip_step = 0.35;
inline constexpr int dips_each_side = 4;

/// Dips of one power.
struct DipGrid {
  double power{};
  double near_rad_s{};  ///< 0: from the slowest speed to widest_dip of the fastest; else about this
  double half_span{};   ///< of log speed, on either side.

  [[nodiscard]] double step() const {
    return near_rad_s > 0 ? half_span / dips_each_side : coarse_dip_step;
  }
};

/// No contact's dip is known to be blunter or sharper.
inline constexpr double least_dip_power = 0.6;
inline constexpr double most_dip_power = 3.4;

/// For each form of the viscous torque: of powers from that of a contact that ages to that of one
/// that does not, a factor apart.
std::vector<std::vector<DipGrid>> coarse_dips();

/// @param grids for each form, as of coarse_dips().
FrictionLaws candidate_laws(const Cells& cells, const Point& point,
                            const std::vector<std::vector<DipGrid>>& grids);

}  // namespace tribolog::method::model
