#pragma once
// Table 2 of the paper: the printed torques and masses, and what eq. (12) makes of the torques.
//
// The paper: "Viscous friction measurement technique in robot joint with the use of surrogate
// mass", joint 3 of a FANUC AM100iB. The evidence for its misprints is computed from these rows.

#include <array>
#include <string>

namespace tribolog::report {

inline constexpr double paper_gear_ratio = 100.0;
inline constexpr double paper_distance_m = 0.5;  ///< Printed as 500 m; see the errata.
inline constexpr double paper_gravity_m_s2 = 9.81;

struct PaperRow {
  char point{'A'};
  double torque_Nm{};  ///< Motor side, printed to 0.001 N·m.
  double mass_kg{};    ///< Printed to 0.001 kg.
};

inline constexpr std::array<PaperRow, 6> paper_table_2{{{'A', 3.924, 79.999},
                                                        {'B', 3.866, 78.811},
                                                        {'C', 4.759, 97.023},
                                                        {'D', 2.993, 61.009},
                                                        {'E', 3.703, 75.494},
                                                        {'F', 4.061, 82.785}}};

/// Surrogate mass of a printed torque by eq. (12) as corrected: n T / (g r), at the peak.
double recomputed_mass_kg(double torque_Nm);

/// Largest difference that rounding the printed torque and mass to three places can make [kg].
double printed_rounding_kg();

/// What the point is, in words: "z = 0 while the arm rises".
std::string point_meaning(const std::string& point);

/// Is this the paper's joint (or its reconstruction)? By the robot's name and the gear ratio.
bool is_papers_joint(const std::string& robot, double gear_ratio);

}  // namespace tribolog::report
