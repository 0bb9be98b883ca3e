#pragma once
// Stage 4: the surrogate mass of every estimator, eq. (12) as corrected.
//
// A to F: the paper's six. AB, CD, EF: means of opposite points of the steady loop. midline: the
// mean of the steady loop. fit: gravity torque of LuGre fitted to all loops. sweep: the gravity
// amplitude of the rough sweep.

#include <optional>
#include <string>
#include <vector>

#include "stages/cog_sweep.h"
#include "stages/estimate.h"
#include "stages/hysteresis_loop.h"

namespace tribolog {

struct SurrogateMass {
  std::string estimator;  ///< "A".."F", "AB", "CD", "EF", "midline", "fit", "sweep", in this
                          ///< order.
  Estimate torque_Nm;     ///< Motor side.
  double q_rad{};         ///< Joint angle it was read at.
  Estimate mass_kg;
  Estimate gravity_Nm;  ///< Amplitude G/n that it stands for: torque / cos(q - q_peak).
};

struct SurrogateMassesResult {
  StageReport stage;
  std::vector<SurrogateMass> masses;
  double distance_m{};  ///< r_REPL
  double gravity_m_s2{};

  [[nodiscard]] const SurrogateMass* find(const std::string& estimator) const;
};

SurrogateMassesResult identify_surrogate_masses(const CogSweepResult& rough,
                                                const HysteresisResult& hysteresis,
                                                const std::optional<Estimate>& q_peak_rad,
                                                double gear_ratio, double distance_m,
                                                double gravity_m_s2);

}  // namespace tribolog
