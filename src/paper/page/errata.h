#pragma once
// The paper's misprints, and what shows them: computed from its own numbers and laws.

#include <string>

#include "calibration/calibration.h"
#include "report/report_view.h"
#include "report/template_engine.h"

namespace tribolog::paper::page {

/// What the errata quote, all of it computed from what is printed.
struct ErrataNumbers {
  std::string torque_A, mass_A_printed, mass_A_with_500_mm, mass_A_with_500_m;
  std::string mass_A_with_n_below, mass_A_arm_torque_with_n_below;
  std::string largest_deviation, allowed_deviation;
  std::string cos_q_c, mass_A_with_cos_q_c;
  std::string rad_of_22, rad_of_precise, cut_of_22, cut_of_precise;
  std::string table_1_deflection_printed, table_1_deflection_meant, table_1_damping;
  std::string pair_masses, pair_spread, single_spread;
  std::string backwards_speed, equation_1_meant, equation_1_printed;
  std::string equation_2_jump, equation_2_half, equation_6_printed;
  std::string equation_10_gravity, equation_10_error;
};

ErrataNumbers errata_numbers();

/// errata.tpl at the marker ERRATA.
void fill_errata(report::TemplateValues& values);

/// Table 2 as printed, recomputed, and the masses of the calibration beside it.
report::Table table_2(const calibration::Calibration& calibration);

}  // namespace tribolog::paper::page
