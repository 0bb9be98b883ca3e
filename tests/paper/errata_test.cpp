#include <string>

#include <gtest/gtest.h>

#include "paper/drawings/printed_paper.h"
#include "paper/page/page_parts.h"

namespace tribolog::errata_test {
namespace {

TEST(PaperTable, Equation12ReproducesEveryRowWithinRounding) {
  for (const paper::drawings::TorqueRow& row : paper::drawings::table_2) {
    EXPECT_NEAR(paper::drawings::mass_of_torque_kg(row.torque_Nm), row.mass_kg,
                paper::drawings::rounding_kg());
  }
  EXPECT_NEAR(paper::drawings::rounding_kg(), 0.0107, 5e-5);
}

TEST(PaperTable, HasTheMassesOfTheDatasetBesideThePrintedOnes) {
  calibration::Calibration c;
  method::hysteresis::SurrogateMass mass;
  mass.estimator = method::hysteresis::Estimator::A;
  mass.mass_kg = {80.000, 79.9, 80.1, {}};
  c.masses.masses = {mass};
  const report::elements::Table table = paper::page::table_2(c);
  ASSERT_EQ(table.rows.size(), 6U);
  EXPECT_EQ(table.rows[0].cells[5], "80.00 ± 0.10");
  EXPECT_EQ(table.rows[0].cells[6], "0.00");
  EXPECT_EQ(table.rows[1].cells[5], "–");
}

TEST(Errata, EvidenceComesFromTable2) {
  const paper::page::ErrataNumbers e =
      paper::page::errata_numbers(paper::charts::loops_of_figure_5({}));
  EXPECT_EQ(e.mass_A_with_500_m, "0.080");
  EXPECT_EQ(e.mass_A_with_500_mm, "80.000");
  EXPECT_EQ(e.mass_A_with_cos_q_c, "86.42");
  EXPECT_EQ(e.rad_of_22, "0.38397");
  EXPECT_EQ(e.rad_of_precise, "0.388019");
  EXPECT_EQ(e.cut_of_22, "cut");
  EXPECT_EQ(e.cut_of_precise, "cut");
  EXPECT_EQ(e.linear_branch_speed, "−0.50\u00a0mrad/s");
  EXPECT_EQ(e.linear_branch_printed, "+0.442\u00a0N·m");
  EXPECT_EQ(e.linear_branch_meant, "−0.442\u00a0N·m");
  EXPECT_EQ(e.mass_B_mirrored_in_bars, "78.818");
  EXPECT_EQ(e.figure_5_travel, "54.95 µm");
  EXPECT_LE(std::stod(e.largest_deviation), std::stod(e.allowed_deviation));
}

}  // namespace
}  // namespace tribolog::errata_test
