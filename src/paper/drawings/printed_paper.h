#pragma once
// What the paper prints: "Viscous friction measurement technique in robot joint with the use of
// surrogate mass", joint 3 of a FANUC AM100iB. Misprints stand here as they are printed; the errata
// show what is meant.

#include <algorithm>
#include <array>
#include <cmath>

#include "joint/gravity_load.h"

namespace tribolog::paper::drawings {

inline constexpr double gear_ratio = 100.0;   ///< n3, section 2.3
inline constexpr double gravity_m_s2 = 9.81;  ///< Not printed; what table 2 was computed with.
inline constexpr double distance_m = 0.5;     ///< r_REPL as meant; printed as 500 m, section 3.3
inline constexpr double distance_printed_m = 500.0;

inline constexpr double rough_angle_deg = 22.0;  ///< Printed with a minus sign, section 3.2
inline constexpr double rough_angle_rad = 0.383;
inline constexpr double precise_angle_deg = 22.23187;
inline constexpr double precise_angle_rad = 0.38801;

inline constexpr int figures = 22;
/// Below the figures in print, in their order.
inline constexpr std::array<const char*, figures> figure_captions{
    "Static, discontinuous model of friction",
    "Static, continuous model of friction",
    "Dynamic, continuous friction model using bristles",
    "Block diagram of the dynamical LuGre friction model",
    "Hysteresis of friction in presliding regime",
    "Input-output block diagram of the robot driving system in third joint",
    "Numerical model of the third robot joint contains the friction model, mechanical gears model, "
    "robot arms and reference signal system and ideal source of movement",
    "Numerical model of mechanical gears in the third robot joint",
    "Investigated object FANUC AM100iB robot",
    "Phenomenological model of the investigated robot and designation of its kinematic and dynamic "
    "parameters",
    "Kinematic and dynamic parameters of rough movement",
    "Available range of robot arms motion and angular position of mass center of gravity",
    "Rough determination of angular position of the maximum motor's load existence",
    "Very precisely determined angle of the maximum motor's load existence",
    "Hysteresis friction in third robot joint",
    "Hysteresis of friction asperities position z(t) and robot arms position",
    "Hysteresis of velocity of asperities z'(t) and robot arm position",
    "Viscous friction characteristics",
    "Viscous friction characteristics",
    "Quality assessment of the viscous friction characteristic replication",
    "Selected viscous friction characteristic",
    "The choice of the correct value of driving torque and angular position of mass center of "
    "gravity"};

inline constexpr int tables = 2;
inline constexpr int equations = 14;

/// A row of table 2.
struct TorqueRow {
  char point{'A'};
  double torque_Nm{};  ///< Motor side, printed to 0.001 N·m.
  double mass_kg{};    ///< Printed to 0.001 kg.
};

inline constexpr std::array<TorqueRow, 6> table_2{{{'A', 3.924, 79.999},
                                                   {'B', 3.866, 78.811},
                                                   {'C', 4.759, 97.023},
                                                   {'D', 2.993, 61.009},
                                                   {'E', 3.703, 75.494},
                                                   {'F', 4.061, 82.785}}};
inline constexpr double last_place = 0.001;  ///< Of table 2, N·m and kg.
inline constexpr char selected_point = 'B';  ///< Section 3.4

/// Surrogate mass of a torque at the motor by eq. (12) as corrected, at the gravity peak [kg].
inline double mass_of_torque_kg(double torque_Nm) {
  return joint::surrogate_mass_kg(torque_Nm, gear_ratio, distance_m, gravity_m_s2, 1.0);
}

/// Half of the smallest difference between two torques of table 2 [N·m]: what is closer to the
/// printed torque than this is closer to it than to any other. The joint's parameters are not
/// printed, so that the six torques can be expected no more closely than they tell points apart.
inline double half_smallest_gap_Nm() {
  double smallest = table_2[0].torque_Nm;
  for (std::size_t i = 0; i < table_2.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      smallest = std::min(smallest, std::abs(table_2[i].torque_Nm - table_2[k].torque_Nm));
    }
  }
  return smallest / 2;
}

/// Largest difference that rounding the printed torque and mass to three places can make [kg].
inline double rounding_kg() { return mass_of_torque_kg(last_place / 2) + last_place / 2; }

/// Table 1, the stiffness and damping as printed; the rest is printed as meant.
inline constexpr double table_1_stiffness_N_m = 1e-5;
inline constexpr double table_1_damping_Ns_m = 1e-10;
/// As meant: Canudas de Wit et al. 1995, their table 1.
struct ContactRow {
  const char* symbol;
  const char* unit;
  double printed;
  double meant;
};
inline constexpr std::array<ContactRow, 6> table_1{
    {{"σ₀", "N/m", table_1_stiffness_N_m, 1e5},
     {"σ₁", "N·s/m", table_1_damping_Ns_m, 316.22776601683796},
     {"σ₂", "N·s/m", 0.4, 0.4},
     {"T_s", "N", 1.5, 1.5},
     {"T_c", "N", 1.0, 1.0},
     {"ω_s", "m/s", 0.001, 0.001}}};

/// Figure 5: “amplitude of friction” and frequency, section 2.2.
struct Swing {
  double amplitude_N;
  double frequency_Hz;
};
inline constexpr std::array<Swing, 3> figure_5{{{1.425, 1.0}, {1.3, 10.0}, {1.0, 25.0}}};

/// From reversal to reversal, where friction of table 1 as meant swings so far and so slowly that
/// its rate does not count [m]: g ln((1 + a)/(1 - a)), with g = T_s/s0 and a = amplitude/T_s.
inline double presliding_travel_m(double amplitude_N) {
  const double stiffness_N_m = table_1[0].meant;
  const double static_N = table_1[3].meant;
  const double share = amplitude_N / static_N;
  return static_N / stiffness_N_m * std::log((1 + share) / (1 - share));
}

/// Section 1: the range of a useful threshold speed in eq. (2).
inline constexpr double smallest_threshold_rad_s = 1e-5;
inline constexpr double largest_threshold_rad_s = 1e-3;
/// Section 2.1: where the direction changes in eq. (7), and the c that does it.
inline constexpr double direction_change_rad_s = 1e-4;
inline constexpr double smoothing_s_rad = 1e6;

}  // namespace tribolog::paper::drawings
