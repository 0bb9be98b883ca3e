// Evidence for the paper's misprints, computed from its own table 2.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "joint/gravity_load.h"
#include "report/paper_table.h"
#include "report/units.h"
#include "report/view_parts.h"

namespace tribolog::report {
namespace {

constexpr double printed_rough_deg = 22.0;
constexpr double printed_precise_deg = 22.23187;
constexpr double printed_rough_rad = 0.383;
constexpr double printed_precise_rad = 0.38801;

constexpr double to_rad = std::numbers::pi / 180.0;

std::string cut(double value, int decimals) {
  const double unit = std::pow(10.0, decimals);
  return fixed(std::trunc(value * unit) / unit, decimals);
}

const PaperRow& row(char point) {
  return *std::find_if(paper_table_2.begin(), paper_table_2.end(),
                       [point](const PaperRow& r) { return r.point == point; });
}

double pair_mass_kg(char one, char other) {
  return recomputed_mass_kg((row(one).torque_Nm + row(other).torque_Nm) / 2);
}

void add_table_2(ErrataNumbers& e) {
  const PaperRow& a = row('A');
  const double mass_A = recomputed_mass_kg(a.torque_Nm);
  e.torque_A = fixed(a.torque_Nm, 3);
  e.mass_A_printed = fixed(a.mass_kg, 3);
  e.mass_A_with_500_mm = fixed(mass_A, 3);
  constexpr double printed_distance_m = 500.0;
  e.mass_A_with_500_m = fixed(
      surrogate_mass_kg(a.torque_Nm, paper_gear_ratio, printed_distance_m, paper_gravity_m_s2, 1.0),
      3);
  const double n = paper_gear_ratio;
  e.mass_A_with_n_below = fixed(mass_A / (n * n), 4);
  e.mass_A_arm_torque_with_n_below = fixed(mass_A / n, 3);

  double largest = 0.0;
  double lightest = paper_table_2.front().mass_kg;
  double heaviest = lightest;
  for (const PaperRow& r : paper_table_2) {
    largest = std::max(largest, std::abs(recomputed_mass_kg(r.torque_Nm) - r.mass_kg));
    lightest = std::min(lightest, r.mass_kg);
    heaviest = std::max(heaviest, r.mass_kg);
  }
  e.largest_deviation = fixed(largest, 4);
  e.allowed_deviation = fixed(printed_rounding_kg(), 4);
  const double cosine = std::cos(printed_precise_deg * to_rad);
  e.cos_q_c = fixed(cosine, 4);
  e.mass_A_with_cos_q_c = fixed(mass_A / cosine, 2);

  const double ab = pair_mass_kg('A', 'B');
  const double cd = pair_mass_kg('C', 'D');
  const double ef = pair_mass_kg('E', 'F');
  e.pair_masses = fixed(ab, 2) + ", " + fixed(cd, 2) + " and " + fixed(ef, 2);
  e.pair_spread = fixed(std::max({ab, cd, ef}) - std::min({ab, cd, ef}), 2);
  e.single_spread = fixed(heaviest - lightest, 2);
}

}  // namespace

ErrataNumbers errata_numbers() {
  ErrataNumbers e;
  add_table_2(e);
  e.rad_of_22 = fixed(printed_rough_deg * to_rad, 5);
  e.rad_of_precise = fixed(printed_precise_deg * to_rad, 6);
  const bool rough_is_cut = cut(printed_rough_deg * to_rad, 3) == fixed(printed_rough_rad, 3);
  const bool precise_is_cut = cut(printed_precise_deg * to_rad, 5) == fixed(printed_precise_rad, 5);
  e.cut_of_22 = rough_is_cut ? "cut" : "misprinted";
  e.cut_of_precise = precise_is_cut ? "cut" : "misprinted";

  // Table 1: the bristle deflection at which the static force 1.5 N is reached is F_s / s0.
  constexpr double static_force_N = 1.5;
  constexpr double printed_stiffness_N_m = 1e-5;
  constexpr double meant_stiffness_N_m = 1e5;
  constexpr double to_km = 1e-3;
  constexpr double to_um = 1e6;
  e.table_1_deflection_printed =
      with_unit(significant(static_force_N / printed_stiffness_N_m * to_km, 3), "km");
  e.table_1_deflection_meant =
      with_unit(significant(static_force_N / meant_stiffness_N_m * to_um, 3), "µm");
  e.table_1_damping = with_unit(significant(std::sqrt(meant_stiffness_N_m), 4), "N·s/m");
  return e;
}

}  // namespace tribolog::report
