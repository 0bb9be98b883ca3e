#pragma once
// Internal to the paper's page: its parts.

#include <string>
#include <vector>

#include "calibration/calibration.h"
#include "paper/charts/paper_charts.h"
#include "paper/checks/check.h"
#include "paper/page/paper_page.h"
#include "report/document/report_view.h"
#include "report/elements/elements.h"
#include "report/engine/template_engine.h"

namespace tribolog::paper::page {

// Checks as the rows of a table.

/// A check's numbers, rounded so that the difference against what is allowed can be seen.
struct CheckTexts {
  std::string expected;
  std::string kind;  ///< "print" or "independent"
  std::string ours;
  std::string difference;
  std::string allowed;
};

CheckTexts check_texts(const checks::Check& check);

/// check_table.tpl at the marker.
/// @param id of the table in the page, without the "table-" in front.
void fill_checks(const checks::Checks& checks, const std::string& id, const std::string& caption,
                 const std::string& marker, report::engine::TemplateValues& values);

/// ✓ or ✗
std::string tick(bool is_well);

// The paper's misprints, and what shows them: computed from its own numbers and laws.

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
  std::string linear_branch_speed, linear_branch_printed, linear_branch_meant;
  std::string mass_B_mirrored, mass_B_mirrored_in_bars;
  std::string figure_5_travel, figure_5_forced_width, figure_5_forced_speed;
};

ErrataNumbers errata_numbers(const charts::PreslidingLoops& loops);

/// errata.tpl at the marker ERRATA.
void fill_errata(const charts::PreslidingLoops& loops, report::engine::TemplateValues& values);

/// Waiboer's five parameters for each candidate's curve, the selected one marked.
report::elements::Table fits_of_equation_6(const calibration::Calibration& calibration);

/// Table 2 as printed, recomputed, and the masses of the calibration beside it.
report::elements::Table table_2(const calibration::Calibration& calibration);

/// Section 3.4 beside its table 2: curves, masses, errors, choice, at the marker TABLE.
void fill_selection(const calibration::Calibration& calibration,
                    report::engine::TemplateValues& section);

// What the page counts, and its list to tick off.

/// "figure-15"
std::string item_anchor(const checks::PaperItem& item);

/// The verdict over the page with every check that fails, the table of counts at the marker TALLY,
/// and the sections KIND of the list to tick off.
void fill_outcome_of(const RegeneratedPaper& paper,
                     const std::vector<render::workers::DrawnFigure>& drawn,
                     report::engine::TemplateValues& values);

}  // namespace tribolog::paper::page
