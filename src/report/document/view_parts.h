#pragma once
// Internal to the report: the makers of the view's parts, one source file each.

#include <string>
#include <vector>

#include "report/document/findings_view.h"
#include "report/document/report_view.h"
#include "wording/rounding.h"
#include "wording/words.h"

namespace tribolog::report::document {

/// The method's eight stages, in its order, and what was recorded beyond them.
enum class StageId {
  cog_rough,
  cog_precise,
  hysteresis,
  surrogate_masses,
  viscous_curves,
  quality_errors,
  selection,
  parameters,
  break_away,
};

const statistics::StageReport& stage_report(const calibration::Calibration& calibration,
                                            StageId stage);
int stage_number(StageId stage);
std::string section_anchor(StageId stage);  ///< "stage-3"
std::string stage_title(StageId stage);
std::string explanation_template(StageId stage);
/// Which measurement would bring what the stage could not give.
std::string helpful_experiment(StageId stage);
/// "stage 3"
std::string stage_reference(StageId stage);
std::string status_in_words(statistics::StageState state);

// Contents of the stages' sections: facts and tables. Nothing is added where nothing was found.
void describe_cog_sweep(const method::gravity::CogSweepResult& result, double gear_ratio,
                        Section& section);
void describe_hysteresis(const method::hysteresis::HysteresisResult& result, double gear_ratio,
                         Section& section);
void describe_surrogate_masses(const calibration::Calibration& calibration, Section& section);
void describe_viscous_curves(const calibration::Calibration& calibration, Section& section);
void describe_quality_errors(const calibration::Calibration& calibration, Section& section);
void describe_selection(const calibration::Calibration& calibration, Section& section);
void describe_parameters(const calibration::Calibration& calibration, Section& section);

void describe_break_away(const calibration::Calibration& calibration, Section& section);
/// The loops without any model; no rows where none was recorded.
Table loop_shapes_table(const std::vector<method::hysteresis::LoopShape>& shapes, double gear_ratio,
                        const Section& section);
/// Behind the stages: gravity by every way, ripple, positions.
Section cross_checks_section(const calibration::Calibration& calibration);
void describe_lugre(const method::hysteresis::LuGreFit& fit, double gear_ratio, Section& section);
/// The known-truth check as the section "known-truth"; only where the check was made.
Section truth_check_section(const calibration::TruthCheckResult& check, int number);

/// Of the findings, as many stand on page one.
inline constexpr std::size_t findings_on_page_one = 3;

std::vector<QuantityRow> quantity_rows(const calibration::Calibration& calibration,
                                       const NumberedFindings& findings,
                                       const std::optional<history::Comparison>& since_last);
/// Friction at a few speeds, on page one.
FrictionSpeeds friction_speeds(const calibration::Calibration& calibration);
/// Nothing rests on it, and it does not show: that is no fault.
bool is_merely_absent(const calibration::QuantityVerdict& quantity);
/// Nullptr where no number is stated: without an estimate, or where the verdict refuses it.
const calibration::UncertaintyBudget* stated_budget(const calibration::QuantityVerdict& quantity);
/// "surrogate mass", as it stands within a sentence.
std::string name_within_a_sentence(joint::Quantity quantity);
/// "9 of 10 quantities are usable. Doubtful: ..."; of those that stand in the first table.
std::string rows_in_words(const calibration::Judgement& judgement);
/// Quantities that nothing rests on and that do not show; empty: there are none.
std::string not_asked_for(const calibration::Judgement& judgement);
/// "tribolog-0123456789ab" of an id, or the laboratory's own number.
std::string report_number(const joint::Manifest& manifest, const std::string& id);
/// What went in, what the intervals include and do not, what was seen.
std::vector<Fact> boundary_facts(const calibration::Calibration& calibration);
std::vector<Fact> certificate_facts(const calibration::Calibration& calibration,
                                    const calibration::Provenance& provenance);
/// "2 kg at 0.3 m from the axis, gripper"; empty where not stated.
std::string payload_in_words(const joint::Manifest& manifest);
std::vector<DataCheckRow> data_check_rows(const method::checks::DataChecksResult& checks);
std::vector<DataCheckRow> rule_rows(const std::vector<calibration::RuleOutcome>& rules);
/// The effect of unknown size that makes most of all intervals, and what U would be without it;
/// empty: there is none.
std::string limiting_effect(const calibration::Judgement& judgement);
/// Of the quantities that have a number to state.
std::vector<BudgetRow> budget_rows(const calibration::Judgement& judgement);
/// "the recordings 97 %"; empty without a budget.
std::string largest_part(const calibration::QuantityVerdict& quantity);
Table key_numbers_table(const calibration::Calibration& calibration);
/// From the columns of the logs to signals; where speeds come from.
std::vector<Table> conversion_tables(const calibration::Calibration& calibration);
/// "1.825 N·m cos(q1_rad + q2_rad − 90°)", at the joint.
std::string load_formula(const joint::KnownLoad& load);
std::vector<Table> provenance_tables(const calibration::Calibration& calibration,
                                     const calibration::Provenance& provenance);

/// Without rows: quantity, estimate ± half width, unit, 95 % interval, from.
Table estimates_table(const std::string& id, const std::string& caption);
Row estimate_row(const std::string& quantity, const statistics::Estimate& estimate,
                 const wording::Scale& scale);
/// The same for a number without an interval.
Row number_row(const std::string& quantity, double value, const wording::Scale& scale,
               const std::string& from);
Row not_identified_row(const std::string& quantity, const std::string& why);

/// "Coulomb torque, at the motor"; as it is without a gear, as motor and joint are one.
std::string at_motor(const std::string& quantity, double gear_ratio);
std::string at_joint(const std::string& quantity, double gear_ratio);

/// Of one quantity: it is `to_joint` times as large at the joint.
struct Gear {
  double ratio{1.0};
  double to_joint{1.0};
};
/// A row at the motor and one at the joint; where the gear ratio is 1 a single one.
void add_both_sides(const std::string& quantity, const statistics::Estimate& motor,
                    const Gear& gear, wording::Scale (*scale_for)(double), Table& table);
/// The same where the interval at the joint is one of its own.
void add_both_sides(const std::string& quantity, const statistics::Estimate& motor,
                    const statistics::Estimate& joint, double gear_ratio,
                    wording::Scale (*scale_for)(double), Table& table);

/// The chosen surrogate mass, or nullptr.
const method::hysteresis::SurrogateMass* recommended_mass(
    const calibration::Calibration& calibration);

using wording::as_sentence;

}  // namespace tribolog::report::document
