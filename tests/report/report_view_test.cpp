#include "report/document/report_view.h"

#include <algorithm>
#include <limits>
#include <optional>

#include <gtest/gtest.h>

#include "calibration/friction_speeds.h"
#include "identify/identify.h"
#include "report/document/key_pictures.h"
#include "report/document/view_parts.h"
#include "report/sample_calibration.h"
#include "support/paper_joint.h"
#include "wording/words.h"

namespace tribolog::test::report_view_test {
namespace {

report::document::ReportView view_of(const calibration::Calibration& c) {
  return report::document::make_report_view(c, {}, {}, sample_provenance());
}

const report::elements::Row* row_of(const report::elements::Table& table,
                                    const std::string& start) {
  const auto found = std::find_if(
      table.rows.begin(), table.rows.end(),
      [&](const report::elements::Row& row) { return row.cells.front().rfind(start, 0) == 0; });
  return found == table.rows.end() ? nullptr : &*found;
}

TEST(ReportView, KeyNumbersAreRoundedByTheirIntervals) {
  const report::elements::Table table = view_of(complete_calibration()).key_numbers;
  const report::elements::Row* mass =
      row_of(table, "Surrogate mass at r = 0.5\u00a0m, recommended");
  ASSERT_NE(mass, nullptr);
  EXPECT_EQ(mass->cells[1], "79.168 ± 0.088");
  EXPECT_EQ(mass->cells[3], "79.080 … 79.256");
  EXPECT_EQ(mass->cells[2], "kg");
  EXPECT_TRUE(mass->is_chosen);
  const report::elements::Row* angle = row_of(table, "Joint angle of largest gravity torque");
  ASSERT_NE(angle, nullptr);
  EXPECT_EQ(angle->cells[1], "−22.232 ± 0.012");
}

TEST(ReportView, KeyNumbersGiveBothSidesOfTheGear) {
  const report::elements::Table table = view_of(complete_calibration()).key_numbers;
  EXPECT_EQ(row_of(table, "Gravity torque, at the motor")->cells[1], "3.8832 ± 0.0043");
  EXPECT_EQ(row_of(table, "Gravity torque, at the joint")->cells[1], "388.32 ± 0.43");
  EXPECT_EQ(row_of(table, "Viscous coefficient, at the joint")->cells[1], "26.4 ± 1.7");
  EXPECT_EQ(row_of(table, "Break-away torque, at the joint")->cells[1], "88.44 ± 0.13");
}

TEST(ReportView, EachReasonIsSaidOnceAndReferredTo) {
  const Statement rests_on = Statement::verbatim("no oscillation was recorded");
  const Statement found = Statement::verbatim("factor 2");
  calibration::QuantityVerdict mass;
  mass.quantity = joint::Quantity::surrogate_mass;
  mass.verdict = calibration::Verdict::doubtful;
  mass.reasons = {{"verdict.nothing_independent", {{"why", rests_on}}},
                  {"verdict.check_fails",
                   {{"found", found}, {"consequence", Statement::verbatim("speeds are wrong")}}}};
  calibration::QuantityVerdict damping;
  damping.quantity = joint::Quantity::bristle_damping;
  damping.verdict = calibration::Verdict::doubtful;
  damping.reasons = {rests_on, Statement::verbatim("known only roughly")};
  calibration::Judgement judgement;
  judgement.quantities = {mass, damping};
  judgement.findings = {
      Statement::verbatim("a note"),
      {"verdict.check", {{"check", Statement::verbatim("Speeds")}, {"found", found}}},
      rests_on};
  const report::document::NumberedFindings findings(judgement);
  ASSERT_EQ(findings.all().size(), 4U);
  EXPECT_EQ(findings.all()[0].consequence, "Speeds are wrong.");
  EXPECT_EQ(findings.all()[1].text, "No oscillation was recorded.");
  EXPECT_EQ(findings.all()[2].text, "Bristle damping: known only roughly.") << "the noun first";
  EXPECT_EQ(findings.all()[3].text, "A note.") << "lowers nothing";
  EXPECT_EQ(findings.numbers_of(mass), (std::vector<int>{1, 2}));
  EXPECT_EQ(findings.numbers_of(damping), (std::vector<int>{2, 3}));
  EXPECT_EQ(findings.all()[1].quantities,
            (std::vector<std::string>{"surrogate mass", "bristle damping"}));
}

TEST(ReportView, BeforeWhatIsKnownLittleStandsWhatMayBeWhy) {
  calibration::Judgement judgement;
  const Statement ripple{"cause.vibration", {{"amplitude_Nm", 0.1}, {"frequency_Hz", 7.0}}};
  const Statement drift{"cause.ripple_without_lines", {{"ripple_Nm", 0.01}}};
  judgement.findings = {drift, ripple};
  judgement.rules = {{"offset_drift",
                      calibration::RuleState::broken,
                      2.0,
                      1.0,
                      "%",
                      {},
                      calibration::Verdict::usable,
                      drift,
                      false},
                     {"vibration",
                      calibration::RuleState::broken,
                      30.0,
                      1.0,
                      "%",
                      {},
                      calibration::Verdict::usable,
                      ripple,
                      false}};
  judgement.quantities.resize(1);
  calibration::lower(judgement.quantities.front(), calibration::Verdict::doubtful,
                     {"verdict.known_to_share", {{"percent", 41.0}}}, {"record.ramps"});
  const report::document::NumberedFindings findings(judgement);
  EXPECT_EQ(findings.number_of(ripple), 1);
  EXPECT_EQ(findings.number_of(judgement.quantities.front().reasons.front()), 2);
  EXPECT_EQ(findings.number_of(drift), 3);
}

TEST(ReportView, TheSentenceIsMadeFromTheRows) {
  calibration::Judgement judgement;
  calibration::QuantityVerdict q;
  q.quantity = joint::Quantity::gravity_torque;
  judgement.quantities = {q, q, q};
  EXPECT_EQ(report::document::rows_in_words(judgement), "All 3 quantities are usable.");
  judgement.quantities[1].quantity = joint::Quantity::coulomb_torque;
  judgement.quantities[1].verdict = calibration::Verdict::doubtful;
  judgement.quantities[2].quantity = joint::Quantity::inertia;
  judgement.quantities[2].verdict = calibration::Verdict::not_identifiable;
  EXPECT_EQ(report::document::rows_in_words(judgement),
            "1 of 3 quantities is usable. Doubtful: Coulomb torque. Not identifiable: inertia.");
  judgement.quantities[2].decides = false;
  EXPECT_EQ(report::document::rows_in_words(judgement),
            "1 of 2 quantities is usable. Doubtful: Coulomb torque.");
  EXPECT_EQ(report::document::not_asked_for(judgement),
            "Not identified, and not needed for the verdict: inertia.");
}

std::string text_of(const std::vector<report::elements::Fact>& facts, const std::string& name) {
  for (const report::elements::Fact& fact : facts) {
    if (fact.name == name) return fact.text;
  }
  return "";
}

TEST(ReportView, TheCertificateStatesWhatTheManifestDoesAndSaysWhatItDoesNot) {
  calibration::Calibration c = complete_calibration();
  std::vector<report::elements::Fact> facts = view_of(c).certificate;
  EXPECT_EQ(text_of(facts, "Laboratory"), "");
  EXPECT_EQ(text_of(facts, "Not stated"),
            "laboratory, customer, received, measured, place, operator, procedure, adjustment, "
            "responsible");
  EXPECT_NE(text_of(facts, "Traceability").find("instruments not stated"), std::string::npos);
  joint::Certificate& stated = c.manifest.certificate;
  stated.number = "CAL-2026/0815";
  stated.laboratory = "Joint laboratory";
  stated.laboratory_address = "Main street 1";
  stated.customer = "Robots Ltd";
  stated.instruments = {{"torque sensor", "4711", "D-K-15195, 2026-03", "for the torque"}};
  stated.humidity_percent = 40;
  c.manifest.temperature_C = 23.5;
  const report::document::ReportView view = view_of(c);
  EXPECT_EQ(view.number, "CAL-2026/0815");
  EXPECT_EQ(text_of(view.certificate, "Laboratory"), "Joint laboratory, Main street 1");
  EXPECT_EQ(text_of(view.certificate, "Customer"), "Robots Ltd");
  EXPECT_NE(text_of(view.certificate, "Traceability")
                .find("torque sensor 4711 (D-K-15195, 2026-03; for the torque)"),
            std::string::npos);
  EXPECT_NE(text_of(view.certificate, "Conditions").find("23.5\u00a0°C; humidity 40\u00a0%"),
            std::string::npos);
  EXPECT_EQ(text_of(view.certificate, "Not stated").find("laboratory"), std::string::npos);
}

TEST(ReportView, TheBoundarySaysWhatIsIncludedAndWhatIsNot) {
  const std::vector<report::elements::Fact> facts = view_of(complete_calibration()).boundary;
  EXPECT_NE(text_of(facts, "What went in").find("1 sweep; 139\u202f210 of 140\u202f410 rows"),
            std::string::npos)
      << text_of(facts, "What went in");
  EXPECT_EQ(text_of(facts, "Included in U"), "torque constant, the recordings");
  EXPECT_NE(text_of(facts, "Not included").find("uncertainty of the gear ratio: not stated"),
            std::string::npos);
}

TEST(ReportView, AQuantitysBudgetIsWhole) {
  const std::vector<report::document::BudgetRow> rows = view_of(complete_calibration()).budget;
  ASSERT_EQ(rows.size(), 1U);
  ASSERT_EQ(rows[0].parts.size(), 2U);
  EXPECT_EQ(rows[0].parts[0].kind, "torque-constant");
  EXPECT_EQ(rows[0].parts[0].from_percent, 0);
  EXPECT_NEAR(rows[0].parts[1].from_percent + rows[0].parts[1].percent, 100, 1e-9);
  EXPECT_NEAR(rows[0].parts[0].percent, 95.3, 0.1);  // (0.5 % of 3.883 N·m)² of all
  EXPECT_EQ(rows[0].effects,
            "hoses and cables, typical 0.10\u00a0%: 60\u00a0%; a lag between torque and angle, "
            "stated 0.50\u00a0ms: 20\u00a0%; the choice among laws of friction over the speed: "
            "10\u00a0%");
}

TEST(ReportView, PageOneShowsLoopAndFrictionCurve) {
  const joint::Dataset dataset = simulate::simulated_dataset(paper_joint());
  const std::vector<report::document::KeyPicture> pictures =
      report::document::key_pictures(identify::identify(dataset));
  ASSERT_EQ(pictures.size(), 2U);
  EXPECT_EQ(pictures[0].id, "picture-loop");
  EXPECT_FALSE(pictures[0].fitted.empty());
  EXPECT_FALSE(pictures[0].band.empty());
  EXPECT_EQ(pictures[1].id, "picture-curve");
  EXPECT_FALSE(pictures[1].backward.empty());
  for (const report::document::KeyPicture& picture : pictures) {
    EXPECT_GE(picture.x_ticks.size(), 3U);
    EXPECT_GE(picture.y_ticks.size(), 3U);
    for (const report::document::KeyPicture::Tick& tick : picture.x_ticks) {
      EXPECT_TRUE(tick.at > 50 && tick.at < report::document::picture_width) << tick.label;
    }
    for (const std::string& path : {picture.measured, picture.fitted, picture.forward}) {
      EXPECT_EQ(path.find("nan"), std::string::npos);
    }
  }
}

calibration::FrictionAtSpeed friction_at(double speed_rad_s, double torque_Nm, double half_width_Nm,
                                         calibration::Verdict verdict) {
  return {speed_rad_s, verdict, statistics::symmetric_estimate(torque_Nm, half_width_Nm),
          verdict == calibration::Verdict::usable ? Statement{}
                                                  : Statement::verbatim("known to ± 40 %")};
}

TEST(ReportView, PageOneShowsFrictionAtAFewSpeedsAndWhereItIsUsable) {
  using calibration::Verdict;
  calibration::Calibration c = complete_calibration();
  EXPECT_TRUE(view_of(c).friction_speeds.rows.empty());
  c.judgement.friction_at_speed = {
      friction_at(1, 0.5, 0.2, Verdict::doubtful), friction_at(10, 0.6, 0.01, Verdict::usable),
      friction_at(11, 0.61, 0.01, Verdict::usable), friction_at(100, 1, 0.02, Verdict::usable),
      friction_at(1000, 9, 9, Verdict::not_identifiable)};
  const report::document::FrictionSpeeds shown = view_of(c).friction_speeds;
  ASSERT_EQ(shown.rows.size(), 5U);
  EXPECT_EQ(shown.rows[1].speed, "10.0");
  EXPECT_EQ(shown.rows[1].torque, "0.600 ± 0.010");
  EXPECT_EQ(shown.rows[1].speed_at_joint, "0.100");
  EXPECT_EQ(shown.rows[1].torque_at_joint, "60.0 ± 1.0");
  EXPECT_EQ(shown.rows[0].outcome, report::elements::Outcome::partial);
  EXPECT_EQ(shown.rows[4].torque, "");  // a number that its verdict refuses
  EXPECT_EQ(shown.good_for,
            "Good for feed-forward and simulation at motor speeds of 10.0 to 100\u00a0rad/s. At "
            "1000\u00a0rad/s: known to ± 40 %.");
  c.judgement.friction_at_speed = {friction_at(1, 0.5, 0.2, Verdict::doubtful)};
  EXPECT_EQ(view_of(c).friction_speeds.good_for,
            "Not good for feed-forward or simulation at any of these speeds. At 1.00\u00a0rad/s: "
            "known to ± 40 %.");
}

TEST(ReportView, PageOneSaysWhereFrictionDiffersWithTheDirection) {
  using calibration::Verdict;
  calibration::Calibration c = complete_calibration();
  calibration::FrictionAtSpeed f = friction_at(10, 0.6, 0.01, Verdict::usable);
  f.forward_Nm = statistics::symmetric_estimate(0.61, 0.02);
  f.backward_Nm = statistics::symmetric_estimate(0.59, 0.02);
  c.judgement.friction_at_speed = {f};
  EXPECT_EQ(view_of(c).friction_speeds.good_for.find("while the angle rises"), std::string::npos);
  f.forward_Nm = statistics::symmetric_estimate(0.65, 0.02);
  f.backward_Nm = statistics::symmetric_estimate(0.55, 0.02);
  c.judgement.friction_at_speed = {f};
  EXPECT_NE(view_of(c).friction_speeds.good_for.find(
                "At 10.0\u00a0rad/s friction is 0.650\u00a0N·m while the angle rises and "
                "0.550\u00a0N·m while it falls."),
            std::string::npos)
      << view_of(c).friction_speeds.good_for;
}

TEST(ReportView, PageOneComparesGravityWithTheDesign) {
  calibration::Calibration c = complete_calibration();
  const auto stated = [&](joint::Quantity quantity) {
    const report::document::ReportView view = view_of(c);
    const std::string words = wording::words_for("quantity", to_string(quantity));
    const auto row = std::find_if(view.quantities.begin(), view.quantities.end(),
                                  [&](const auto& one) { return one.words == words; });
    return row == view.quantities.end() ? std::nullopt : row->stated;
  };
  EXPECT_FALSE(stated(joint::Quantity::gravity_torque));
  const double n = c.manifest.drive.gear_ratio();
  const auto& found = c.judgement.find(joint::Quantity::gravity_torque)->estimate;
  ASSERT_TRUE(found);
  c.manifest.known_gravity = joint::StatedGravity(n * found->value, 0);
  ASSERT_TRUE(stated(joint::Quantity::gravity_torque));
  EXPECT_EQ(stated(joint::Quantity::gravity_torque)->word, "agrees");
  c.manifest.known_gravity = joint::StatedGravity(0.9 * n * found->value, 0);
  EXPECT_EQ(stated(joint::Quantity::gravity_torque)->word.find("differs by +"), 0U)
      << stated(joint::Quantity::gravity_torque)->word;
  EXPECT_EQ(stated(joint::Quantity::gravity_torque)->outcome, report::elements::Outcome::partial);
  EXPECT_FALSE(stated(joint::Quantity::inertia));
}

// The speeds that the manifest asks for, and a word for what no recording reaches.
TEST(ReportView, PageOneShowsFrictionAtTheSpeedsThatAreStated) {
  using calibration::Verdict;
  calibration::Calibration c = complete_calibration();
  c.manifest.friction_at_rad_s = {0.05, 0.5, 20};  // of the joint; the gear ratio is 100
  c.judgement.friction_at_speed = calibration::with_stated_speeds(
      {friction_at(10, 0.6, 0.01, Verdict::usable), friction_at(100, 1, 0.02, Verdict::usable)},
      {5, 50, 2000});
  const report::document::FrictionSpeeds shown = view_of(c).friction_speeds;
  ASSERT_EQ(shown.rows.size(), 3U);
  EXPECT_EQ(shown.rows[0].speed_at_joint, "0.0500");
  EXPECT_EQ(shown.rows[0].torque, "");
  EXPECT_EQ(shown.rows[0].verdict_word, "not measured");
  EXPECT_EQ(shown.rows[1].speed_at_joint, "0.500");
  EXPECT_EQ(shown.rows[1].torque, "0.880 ± 0.017");
  EXPECT_EQ(shown.rows[2].speed, "2000");
}

TEST(ReportView, ADirectDriveHasOneSide) {
  calibration::Calibration c = complete_calibration();
  c.manifest.drive = joint::Drive(1.0, joint::EffortKind::motor_torque, joint::Side::motor);
  const report::elements::Table table = view_of(c).key_numbers;
  EXPECT_NE(row_of(table, "Gravity torque"), nullptr);
  EXPECT_EQ(row_of(table, "Gravity torque, at the joint"), nullptr);
}

TEST(ReportView, EveryRowHasACellPerColumn) {
  for (const calibration::Calibration& c : {complete_calibration(), sweep_only()}) {
    const report::document::ReportView view = view_of(c);
    std::vector<report::elements::Table> tables{view.key_numbers};
    tables.insert(tables.end(), view.conversion_tables.begin(), view.conversion_tables.end());
    tables.insert(tables.end(), view.provenance_tables.begin(), view.provenance_tables.end());
    for (const report::document::Section& section : view.sections) {
      tables.insert(tables.end(), section.tables.begin(), section.tables.end());
    }
    for (const report::elements::Table& table : tables) {
      for (const report::elements::Row& row : table.rows) {
        EXPECT_EQ(row.cells.size(), table.columns.size()) << table.id;
      }
    }
  }
}

TEST(ReportView, ConversionsShowEachStepTheFactorAndTheResult) {
  const report::document::ReportView view = view_of(complete_calibration());
  ASSERT_EQ(view.conversion_tables.size(), 2U);
  const report::elements::Table& columns = view.conversion_tables[0];
  ASSERT_EQ(columns.rows.size(), 3U);
  EXPECT_EQ(columns.rows[0].cells[3], "as logged");
  EXPECT_EQ(columns.rows[0].cells[6], "all");
  const std::vector<std::string>& angle = row_of(columns, "Angle")->cells;
  EXPECT_EQ(angle[3], "× 0.01745329252 (from deg) ÷ 100 (gear ratio)");
  EXPECT_EQ(angle[4], "0.0001745329252");
  EXPECT_EQ(angle[5], "rad, joint side");
  const std::vector<std::string>& torque = row_of(columns, "Torque")->cells;
  EXPECT_EQ(torque[1], "“tau”");
  EXPECT_EQ(torque[4], "−0.001");
  const report::elements::Table& speeds = view.conversion_tables[1];
  ASSERT_EQ(speeds.rows.size(), 1U);
  EXPECT_EQ(speeds.rows[0].cells[0], "rough_sweep (1)");
  EXPECT_EQ(speeds.rows[0].cells[1], "yes");
  EXPECT_EQ(speeds.rows[0].cells[3], "280\u00a0ms, 280 samples");
  EXPECT_EQ(speeds.rows[0].cells[4], "2.28\u00a0Hz");
}

TEST(ReportView, KnownLoadsAreAmongTheConversions) {
  calibration::Calibration c = complete_calibration();
  joint::KnownLoad load;
  load.amplitude_Nm = 1.825;
  load.angles = {"q1", "q2"};
  load.roles = {joint::Role::constant_speed};
  c.manifest.known_loads = {load};
  const report::document::ReportView view = view_of(c);
  const report::elements::Row* row = row_of(view.conversion_tables[0], "Known load");
  ASSERT_NE(row, nullptr);
  EXPECT_EQ(row->cells[3], "1.825\u00a0N·m cos(q1 + q2) ÷ 100 (gear ratio)");
  EXPECT_EQ(row->cells[6], "constant_speed");
}

TEST(ReportView, WhatIsMissingSaysWhyAndWhatWouldBringIt) {
  const report::document::ReportView view = view_of(sweep_only());
  std::size_t missing = 0;
  for (const report::document::Section& section : view.sections) {
    if (section.outcome == report::elements::Outcome::good) continue;
    ++missing;
    EXPECT_FALSE(section.reason.empty());
    EXPECT_FALSE(section.experiment.empty());
  }
  EXPECT_EQ(missing, 7U);
  EXPECT_EQ(view.sections[1].reason, "No precise_sweep was recorded.");
  EXPECT_EQ(row_of(view.key_numbers, "Break-away torque")->cells[1], "not identified");
  EXPECT_TRUE(view.sections[4].tables.empty());
}

TEST(ReportView, FiguresGoToTheirStages) {
  const calibration::Calibration c = complete_calibration();
  const auto figures = sample_figures(c);
  const auto drawn = sample_pictures(figures);
  const report::document::ReportView view =
      report::document::make_report_view(c, figures, drawn, sample_provenance());
  ASSERT_EQ(view.sections.size(), 8U);
  for (const report::document::Section& section : view.sections)
    ASSERT_EQ(section.figures.size(), 1U);
  EXPECT_FALSE(view.sections[2].figures[0].is_lazy);
  EXPECT_TRUE(view.sections[3].figures[0].is_lazy);
  EXPECT_EQ(view.figures_missing, "");
}

TEST(ReportView, TheKnownTruthCheckIsASectionOfItsOwn) {
  calibration::Calibration c = complete_calibration();
  c.truth_check.runs = 20;
  c.truth_check.white_Nm = 0.02;
  c.truth_check.quantities = {
      {calibration::ReadingName::midline,
       "N·m",
       3.88319,
       3.88325,
       0.0002,
       0.0005,
       20,
       19,
       {0.1, 1.2},
       true},
      {calibration::ReadingName::q_peak, "rad", -0.388, -0.380, 1e-5, 1e-5, 20, 0, {}, false}};
  c.truth_check.findings = {{calibration::ReadingName::q_peak,
                             Statement::verbatim("the gravity peak does not come back")}};
  auto figures = sample_figures(c);
  figures[0].stage = "known-truth";
  const auto drawn = sample_pictures(figures);
  const report::document::ReportView view =
      report::document::make_report_view(c, figures, drawn, sample_provenance());
  ASSERT_EQ(view.sections.size(), 9U);
  const report::document::Section& section = view.sections[8];
  EXPECT_EQ(section.number, 9);
  EXPECT_EQ(section.id, "known-truth");
  EXPECT_EQ(section.outcome, report::elements::Outcome::bad);
  EXPECT_EQ(section.reason, "The gravity peak does not come back.");
  ASSERT_EQ(section.figures.size(), 1U);
  ASSERT_EQ(section.tables.size(), 1U);
  ASSERT_EQ(section.tables[0].rows.size(), 2U);
  const std::vector<std::string>& midline = section.tables[0].rows[0].cells;
  EXPECT_EQ(midline[0], "Mid-line");
  EXPECT_EQ(midline[1], "3.88319");
  EXPECT_EQ(midline[3], "+0.0000600");
  EXPECT_EQ(midline[6], "19 of 20");
  // Angles are read in degrees: 8 mrad are 0.458 degrees.
  EXPECT_EQ(section.tables[0].rows[1].cells[3], "+0.458");
  EXPECT_EQ(section.tables[0].rows[1].cells[7], "no");
}

TEST(ReportView, BreakAwayRampsHaveASectionOnlyWhereRecorded) {
  calibration::Calibration c = complete_calibration();
  const auto sections = [&] { return view_of(c).sections; };
  EXPECT_EQ(sections().size(), 8U);
  method::hysteresis::BreakAwayRamp ramp;
  ramp.recording = "ramp_1.csv";
  ramp.friction_Nm = 0.8;
  ramp.travel_rad = 1e-4;
  c.break_away.stage = {"break_away", statistics::StageState::not_identifiable,
                        Statement::verbatim("never slid")};
  c.break_away.censored = 1;
  c.break_away.ramps = {ramp};
  ASSERT_EQ(sections().size(), 9U);
  const report::document::Section section = sections().back();
  EXPECT_EQ(section.title, "Break-away ramps");
  ASSERT_EQ(section.tables.size(), 1U);
  // A bound is told from a value.
  EXPECT_EQ(section.tables.front().rows.front().cells[3], "> 0.8000");
  EXPECT_EQ(section.tables.front().rows.front().cells[5], "censored: did not break away");
}

/// Cells of the key numbers' row that begins with these words.
std::vector<std::string> key_number(const calibration::Calibration& c, const std::string& words) {
  for (const report::elements::Row& row : view_of(c).key_numbers.rows) {
    if (row.cells[0].starts_with(words)) return row.cells;
  }
  return {};
}

TEST(ReportView, KeyNumbersAgreeWithTheVerdicts) {
  calibration::Calibration c = complete_calibration();
  ASSERT_EQ(key_number(c, "Break-away torque").back(), "stage 8, LuGre fit of the loops");
  c.break_away.mean_Nm = statistics::symmetric_estimate(0.9, 0.02, Statement::verbatim("ramps"));
  EXPECT_EQ(key_number(c, "Break-away torque").back(), "stage 9, torque ramps");
  calibration::QuantityVerdict refused;
  refused.quantity = joint::Quantity::break_away_torque;
  refused.verdict = calibration::Verdict::not_identifiable;
  c.judgement.quantities.push_back(refused);
  EXPECT_EQ(key_number(c, "Break-away torque").back(), "see the verdict on it");
}

TEST(ReportView, CrossChecksHaveASectionOfTheirOwn) {
  calibration::Calibration c = complete_calibration();
  method::selection::CrossCheck ours;
  ours.estimator = method::hysteresis::Estimator::midline;
  ours.mass_kg = statistics::symmetric_estimate(79.17, 0.01);
  ours.is_recommended = true;
  method::selection::CrossCheck other = ours;
  other.estimator = method::hysteresis::Estimator::fit;
  other.mass_kg = statistics::symmetric_estimate(79.97, 0.02);
  other.is_recommended = false;
  other.difference_percent = 1.01;
  other.difference_half_width_percent = 0.028;
  other.difference_in_intervals = 36;
  other.disagrees = true;
  c.cross_checks.checks = {ours, other};
  c.cross_checks.doubtful = true;
  const report::document::ReportView view = view_of(c);
  ASSERT_EQ(view.sections.size(), 9U);
  const report::document::Section& section = view.sections.back();
  EXPECT_EQ(section.number, 9);
  EXPECT_EQ(section.status, "disagreement");
  ASSERT_GE(section.tables.size(), 2U);
  const std::vector<std::string>& row = section.tables.front().rows[1].cells;
  EXPECT_EQ(row.front(), "2. LuGre model fitted to the loops");
  EXPECT_EQ(row[3], "+1.010");
  EXPECT_EQ(row.back(), "disagrees");
}

TEST(ReportView, OfAPrintedAngleTheStepIsABound) {
  calibration::Calibration c = complete_calibration();
  const auto oscillations = [&] {
    report::document::Section section;
    section.id = "hysteresis";
    report::document::describe_hysteresis(c.hysteresis, 1.0, section);
    return *std::find_if(
        section.tables.begin(), section.tables.end(),
        [](const report::elements::Table& table) { return table.id == "hysteresis-oscillations"; });
  };
  EXPECT_EQ(oscillations().rows.front().cells.back(), "0.000480");
  EXPECT_EQ(oscillations().note.find("decimals"), std::string::npos);
  c.hysteresis.oscillations.front().step_is_of_print = true;
  EXPECT_EQ(oscillations().rows.front().cells.back(), "≥ 0.000480");
  EXPECT_NE(oscillations().note.find("the log's decimals"), std::string::npos);
  c.hysteresis.oscillations.front().encoder_step_rad = 0;
  EXPECT_EQ(oscillations().rows.front().cells.back(), "continuous");
}

TEST(ReportView, AFigureOfNoStageIsNotLost) {
  auto figures = sample_figures(complete_calibration());
  figures[0].stage = "models";
  const auto drawn = sample_pictures(figures);
  const report::document::ReportView view = report::document::make_report_view(
      complete_calibration(), figures, drawn, sample_provenance());
  ASSERT_EQ(view.sections.size(), 9U);
  EXPECT_EQ(view.sections[8].figures[0].id, "fig-1");
}

TEST(ReportView, MissingPicturesAreCounted) {
  const calibration::Calibration c = complete_calibration();
  const auto figures = sample_figures(c);
  auto drawn = sample_pictures(figures);
  drawn[0].error = Statement::verbatim("the worker stopped");
  drawn[0].png.clear();
  drawn.pop_back();
  const report::document::ReportView view =
      report::document::make_report_view(c, figures, drawn, sample_provenance());
  EXPECT_EQ(view.figures_missing, "2 figures missing");
  EXPECT_EQ(view.sections[0].figures[0].error, "The worker stopped.");
}

TEST(ReportView, ALongRunTableIsThinnedAndSaysSo) {
  calibration::Calibration c = complete_calibration();
  c.viscous.runs.assign(500, c.viscous.runs.front());
  const report::elements::Table table = view_of(c).sections[4].tables.front();
  EXPECT_LE(table.rows.size(), 48U);
  EXPECT_NE(table.note.find("One row in 11"), std::string::npos);
}

}  // namespace
}  // namespace tribolog::test::report_view_test
