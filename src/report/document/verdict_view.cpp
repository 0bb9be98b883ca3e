// The verdict on each quantity, as rows of the first table.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/document/view_parts.h"
#include "report/elements/result_words.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::document {

namespace {

using wording::tr;
using wording::tr_count;

/// "≤ 12 N·m", of a half width "± ≤ 5 %".
std::string rule_of(const calibration::LimitOutcome& limit) {
  using calibration::LimitRule;
  const bool is_percent = limit.rule == LimitRule::half_width_percent;
  const bool is_of_width = is_percent || limit.rule == LimitRule::half_width;
  const char* const sign = limit.rule == LimitRule::min ? "≥ " : is_of_width ? "± ≤ " : "≤ ";
  const std::string rule =
      sign + wording::with_unit(wording::as_stated(limit.limit), is_percent ? "%" : limit.unit);
  return limit.at_joint ? tr("{limit} at the joint", {{"limit", rule}}) : rule;
}

LimitCell cell_of(const calibration::LimitOutcome& limit) {
  switch (limit.state) {
    case calibration::LimitState::inside:
      return {rule_of(limit), tr("met"), Outcome::good};
    case calibration::LimitState::outside:
      return {rule_of(limit), tr("not met"), Outcome::bad};
    case calibration::LimitState::crosses:
      return {rule_of(limit), tr("not shown to be met"), Outcome::partial};
    case calibration::LimitState::unknown:
      break;
  }
  return {rule_of(limit), tr("not known"), Outcome::absent};
}

/// The manifest's gravity beside what was found: within its interval, or how far away.
std::optional<LimitCell> stated_gravity(const calibration::Calibration& c,
                                        const calibration::QuantityVerdict& q) {
  const std::optional<joint::StatedGravity>& stated = c.manifest.known_gravity;
  const bool is_angle = q.quantity == joint::Quantity::cog_angle;
  if (!stated || !(stated->amplitude_Nm() > 0) || !q.estimate) return std::nullopt;
  if (!is_angle && q.quantity != joint::Quantity::gravity_torque) return std::nullopt;
  const double gear_ratio = std::abs(c.manifest.drive.gear_ratio());
  const statistics::Estimate found =
      statistics::scaled(q.budget ? q.budget->expanded : *q.estimate, is_angle ? 1.0 : gear_ratio);
  const double at = is_angle ? stated->q_peak_rad() : stated->amplitude_Nm();
  const double away =
      is_angle ? std::remainder(found.value - at, 2 * std::numbers::pi) : found.value - at;
  const wording::Scale scale = wording::quantity_scale(q.unit, at);
  constexpr int digits = 4;
  const auto shown = [&](double value, int so_many) {
    return wording::with_unit(wording::significant(value * scale.factor, so_many), scale.unit);
  };
  LimitCell cell{tr("stated {value}", {{"value", shown(at, digits)}}), tr("agrees"), Outcome::good};
  if (!is_angle && gear_ratio != 1.0)
    cell.rule = tr("{limit} at the joint", {{"limit", cell.rule}});
  if (std::abs(away) <= found.half_width()) return cell;
  cell.word =
      tr("differs by {difference}", {{"difference", wording::with_plus_sign(shown(away, 2))}});
  cell.outcome = Outcome::partial;
  return cell;
}

/// The quantity on the joint's side, where that is another.
const joint::LimitedQuantity* at_joint_of(joint::Quantity quantity, double gear_ratio) {
  if (gear_ratio == 1.0) return nullptr;
  const auto& all = joint::limited_quantities();
  const auto found = std::find_if(all.begin(), all.end(), [&](const joint::LimitedQuantity& q) {
    return q.quantity == quantity && q.at_joint;
  });
  return found == all.end() ? nullptr : &*found;
}

/// Angle and mass of the arm: there is no such number of the motor.
bool is_of_joint_alone(joint::Quantity quantity) {
  return quantity == joint::Quantity::cog_angle || quantity == joint::Quantity::surrogate_mass;
}

void add_estimate(const calibration::QuantityVerdict& q, double gear_ratio, QuantityRow& row) {
  if (!q.estimate) return;
  const statistics::Estimate& shown = q.budget ? q.budget->expanded : *q.estimate;
  std::string& own =
      gear_ratio != 1.0 && is_of_joint_alone(q.quantity) ? row.at_joint : row.at_motor;
  own = wording::in_words(shown, wording::quantity_scale(q.unit, shown.value));
  if (q.budget) row.coverage = wording::fixed(q.budget->coverage_factor, 2);
  row.largest_part = largest_part(q);
  const joint::LimitedQuantity* joint_side = at_joint_of(q.quantity, gear_ratio);
  if (joint_side == nullptr) return;
  const statistics::Estimate at_joint = statistics::scaled(
      q.budget ? calibration::expanded_at(*q.budget, *q.estimate, joint_side->gear_power) : shown,
      std::pow(gear_ratio, joint_side->gear_power));
  row.at_joint = wording::in_words(at_joint, wording::quantity_scale(q.unit, at_joint.value));
}

void add_change(const history::Comparison& since_last, const calibration::QuantityVerdict& q,
                QuantityRow& row) {
  const auto found = std::find_if(
      since_last.quantities.begin(), since_last.quantities.end(),
      [&](const history::ComparedQuantity& c) { return c.name == to_string(q.quantity); });
  if (found == since_last.quantities.end()) return;
  row.change_word = wording::words(history::statement_of(found->word));
  row.is_changed = found->word == history::ChangeWord::changed;
  const history::ComparedQuantity& compared = *found;
  if (!compared.change) return;
  const statistics::Estimate& absolute = compared.change->absolute;
  const wording::Scale scale = wording::quantity_scale(
      compared.unit, compared.second ? compared.second->value : absolute.value);
  const wording::RoundedEstimate text = wording::round_by_interval(absolute, scale);
  row.change = wording::with_unit(wording::with_plus_sign(text.estimate), scale.unit);
  row.change_range = text.half_width.empty() ? text.range() : "± " + text.half_width;
}

}  // namespace

bool is_merely_absent(const calibration::QuantityVerdict& q) {
  return !q.decides && q.verdict == calibration::Verdict::not_identifiable;
}

std::string name_within_a_sentence(joint::Quantity quantity) {
  return wording::within_a_sentence(wording::words_for("quantity", to_string(quantity)));
}

std::vector<QuantityRow> quantity_rows(const calibration::Calibration& c,
                                       const NumberedFindings& findings,
                                       const std::optional<history::Comparison>& since_last) {
  std::vector<QuantityRow> rows;
  for (const calibration::QuantityVerdict& q : c.judgement.quantities) {
    if (is_merely_absent(q) && q.limits.empty()) continue;
    QuantityRow row;
    row.words = wording::words_for("quantity", to_string(q.quantity));
    row.outcome = is_merely_absent(q) ? Outcome::absent : elements::outcome_of(q.verdict);
    row.verdict_word = elements::verdict_in_words(q.verdict);
    // A number that its verdict refuses is not to be filed.
    if (q.verdict != calibration::Verdict::not_identifiable) {
      add_estimate(q, c.manifest.drive.gear_ratio(), row);
      if (q.quantity == joint::Quantity::viscous_curve && !c.model.law.empty()) {
        row.at_motor = wording::capitalised(described(c.model.law));
      }
    }
    for (const calibration::LimitOutcome& limit : q.limits) row.limits.push_back(cell_of(limit));
    row.stated = stated_gravity(c, q);
    if (since_last) add_change(*since_last, q, row);
    row.findings = findings.numbers_of(q);
    rows.push_back(std::move(row));
  }
  std::stable_partition(rows.begin(), rows.end(),
                        [](const QuantityRow& row) { return row.outcome != Outcome::absent; });
  return rows;
}

namespace {

/// "Coulomb torque, gravity torque", of those that a test picks.
template <typename Test>
std::string names_of(const calibration::Judgement& judgement, Test is_meant) {
  std::vector<std::string> names;
  for (const calibration::QuantityVerdict& q : judgement.quantities) {
    if (is_meant(q)) names.push_back(name_within_a_sentence(q.quantity));
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

std::string rows_in_words(const calibration::Judgement& judgement) {
  const auto has = [](calibration::Verdict verdict) {
    return [verdict](const calibration::QuantityVerdict& q) {
      return !is_merely_absent(q) && q.verdict == verdict;
    };
  };
  const auto count = [&](auto is_meant) {
    return std::count_if(judgement.quantities.begin(), judgement.quantities.end(), is_meant);
  };
  const auto usable = count(has(calibration::Verdict::usable));
  const auto all =
      count([](const calibration::QuantityVerdict& q) { return !is_merely_absent(q); });
  if (all == 0) return "";
  if (usable == all) {
    return tr_count(all, "The one quantity is usable.", "All {quantities} quantities are usable.",
                    {{"quantities", all}});
  }
  std::string words = usable == 0
                          ? tr("None of {quantities} quantities is usable.", {{"quantities", all}})
                          : tr_count(usable, "{usable} of {quantities} quantities is usable.",
                                     "{usable} of {quantities} quantities are usable.",
                                     {{"usable", usable}, {"quantities", all}});
  const std::string doubtful = names_of(judgement, has(calibration::Verdict::doubtful));
  const std::string none = names_of(judgement, has(calibration::Verdict::not_identifiable));
  if (!doubtful.empty()) words += " " + tr("Doubtful: {quantities}.", {{"quantities", doubtful}});
  if (!none.empty()) words += " " + tr("Not identifiable: {quantities}.", {{"quantities", none}});
  return words;
}

std::string not_asked_for(const calibration::Judgement& judgement) {
  const std::string names = names_of(judgement, [](const calibration::QuantityVerdict& q) {
    return is_merely_absent(q) && q.limits.empty();
  });
  if (names.empty()) return "";
  return tr("Not identified, and not needed for the verdict: {quantities}.",
            {{"quantities", names}});
}

// The checks on the data, as rows of their table.

namespace {

Outcome outcome_of(method::checks::CheckState state) {
  switch (state) {
    case method::checks::CheckState::passed:
      return Outcome::good;
    case method::checks::CheckState::warns:
      return Outcome::partial;
    case method::checks::CheckState::fails:
      return Outcome::bad;
    case method::checks::CheckState::not_applicable:
      break;
  }
  return Outcome::absent;
}

std::string word_of(method::checks::CheckState state) {
  return wording::words_for("check_state", to_string(state));
}

std::string with_the_unit(double value, const std::string& unit, int digits) {
  // Below what any limit asks for it is nothing.
  constexpr double nothing = 5e-4;
  const std::string number = std::abs(value) < nothing ? "0" : wording::significant(value, digits);
  return unit == "1" ? number : wording::with_unit(number, unit == "deg" ? "°" : unit);
}

std::string limit_in_words(const method::checks::DataCheck& check) {
  const auto bound = [&](double value) {
    const std::string number = wording::as_stated(value);
    return check.unit == "1" ? number
                             : wording::with_unit(number, check.unit == "deg" ? "°" : check.unit);
  };
  if (check.at_least && check.at_most) {
    return tr("{lowest} to {highest}", {{"lowest", wording::as_stated(*check.at_least)},
                                        {"highest", bound(*check.at_most)}});
  }
  if (check.at_least) return "≥ " + bound(*check.at_least);
  return check.at_most ? "≤ " + bound(*check.at_most) : "";
}

}  // namespace

std::vector<DataCheckRow> data_check_rows(const method::checks::DataChecksResult& checks) {
  std::vector<DataCheckRow> rows;
  for (const method::checks::DataCheck& check : checks.checks) {
    DataCheckRow row;
    row.id = "check-" + to_string(check.name);
    std::replace(row.id.begin(), row.id.end(), '_', '-');
    row.title = wording::words_for("check", to_string(check.name));
    row.measure = wording::words(check.measure);
    row.outcome = outcome_of(check.state);
    row.state_word = word_of(check.state);
    if (check.measured) row.measured = with_the_unit(*check.measured, check.unit, 3);
    row.limit = limit_in_words(check);
    if (check.is_of_whole_role) {
      row.recording = tr("{role}, all", {{"role", check.recording}});
    } else if (check.recording != "all") {
      row.recording = check.recording;
    }
    row.found = wording::as_sentence(check.found);
    row.consequence = wording::as_sentence(check.consequence);
    row.experiment = wording::as_sentence(check.experiment);
    rows.push_back(std::move(row));
  }
  return rows;
}

namespace {

Outcome outcome_of(const calibration::RuleOutcome& rule) {
  switch (rule.state) {
    case calibration::RuleState::kept:
      return Outcome::good;
    case calibration::RuleState::broken:
      return rule.lowers_to == calibration::Verdict::not_identifiable ? Outcome::bad
                                                                      : Outcome::partial;
    case calibration::RuleState::not_computed:
      break;
  }
  return Outcome::absent;
}

std::string word_of(const calibration::RuleOutcome& rule) {
  switch (rule.state) {
    case calibration::RuleState::kept:
      return tr("kept");
    case calibration::RuleState::broken:
      return rule.lowers_to == calibration::Verdict::usable
                 ? tr("noted")
                 : elements::verdict_in_words(rule.lowers_to);
    case calibration::RuleState::not_computed:
      break;
  }
  return tr("not computed");
}

}  // namespace

std::vector<DataCheckRow> rule_rows(const std::vector<calibration::RuleOutcome>& rules) {
  std::vector<DataCheckRow> rows;
  for (const calibration::RuleOutcome& rule : rules) {
    DataCheckRow row;
    row.id = "rule-" + rule.rule;
    std::replace(row.id.begin(), row.id.end(), '_', '-');
    row.title = wording::words_for("rule", rule.rule);
    row.outcome = outcome_of(rule);
    row.state_word = word_of(rule);
    if (rule.value) row.measured = with_the_unit(*rule.value, rule.unit, 3);
    row.limit = "≤ " + with_the_unit(rule.threshold, rule.unit, 3);
    row.found = wording::as_sentence(rule.finding);
    std::vector<std::string> names;
    for (const joint::Quantity q : rule.quantities) {
      names.push_back(wording::words_for("quantity", to_string(q)));
    }
    row.consequence = fmt::format("{}", fmt::join(names, ", "));
    rows.push_back(std::move(row));
  }
  return rows;
}

// The known-truth check.

namespace {

constexpr int digits = 3;

/// An angle is read in degrees.
wording::Scale scale_of(const calibration::ReturnedQuantity& q) {
  return q.unit == "rad" ? wording::degree_scale() : wording::plain_scale(q.unit);
}

std::string simulations_inside(const calibration::ReturnedQuantity& q) {
  return tr("{simulations} of {found}", {{"simulations", q.inside}, {"found", q.found}});
}

Row row_of(const calibration::ReturnedQuantity& q) {
  const wording::Scale scale = scale_of(q);
  const std::string name = wording::capitalised(wording::words_for("reading", to_string(q.name)));
  const statistics::Estimate put_in = statistics::symmetric_estimate(q.put_in, q.half_width);
  const wording::RoundedEstimate rounded = wording::round_by_interval(put_in, scale);
  if (q.found == 0) {
    return {{name, rounded.estimate, tr("not found"), "–", "–", scale.unit, simulations_inside(q),
             tr("no")},
            false};
  }
  const wording::RoundedEstimate back =
      wording::round_by_interval(statistics::symmetric_estimate(q.came_back, q.half_width), scale);
  const double deviation = (q.came_back - q.put_in) * scale.factor;
  return {{name, rounded.estimate, back.estimate,
           wording::with_plus_sign(wording::significant(deviation, digits)),
           wording::significant(q.half_width * scale.factor, digits), scale.unit,
           simulations_inside(q), q.comes_back ? tr("yes") : tr("no")},
          false};
}

Table table_of(const calibration::TruthCheckResult& check) {
  Table table;
  table.id = "known-truth-results";
  table.caption =
      tr_count(check.runs, "Simulated and recovered values, means over {simulations} simulation",
               "Simulated and recovered values, means over {simulations} simulations",
               {{"simulations", check.runs}});
  table.columns = {{tr("Quantity"), "", false, true},     {tr("Simulated value"), "", true},
                   {tr("Recovered value"), "", true},     {tr("Deviation"), "", true},
                   {tr("Stated half width"), "", true},   {tr("Unit"), "", false},
                   {tr("Within the interval"), "", true}, {tr("Recovered"), "", false}};
  for (const calibration::ReturnedQuantity& q : check.quantities) table.rows.push_back(row_of(q));
  table.note =
      tr("A quantity is recovered if it is found in most simulations and in most of them lies "
         "within the stated interval, or is off by too little to matter: 0.1 % of a torque, 0.006° "
         "of the angle, 1 % of a parameter.");
  return table;
}

std::string noise_text(double value_Nm, const std::string& none) {
  if (!(value_Nm > 0)) return none;
  const wording::Scale scale = wording::torque_scale(value_Nm);
  return wording::with_unit(wording::significant(value_Nm * scale.factor, digits), scale.unit);
}

std::string joined(const std::vector<Statement>& statements) {
  Statement all;
  for (const Statement& one : statements) all.add(one);
  return wording::words(all);
}

}  // namespace

Section truth_check_section(const calibration::TruthCheckResult& check, int number) {
  Section section;
  section.number = number;
  section.id = "known-truth";
  section.title = tr("Self-consistency");
  section.explanation = "explain_known_truth.tpl";
  const bool nothing = check.quantities.empty();
  section.outcome = nothing                  ? Outcome::absent
                    : check.findings.empty() ? Outcome::good
                                             : Outcome::bad;
  section.status = nothing                  ? tr("not possible")
                   : check.findings.empty() ? tr("recovered")
                                            : tr("not recovered");
  std::vector<Statement> findings;
  for (const calibration::TruthFinding& one : check.findings) findings.push_back(one.finding);
  section.reason = wording::as_sentence(joined(findings));
  if (nothing) section.reason = wording::as_sentence(joined(check.left_out));
  section.facts = {
      {tr("Simulations"), std::to_string(check.runs)},
      {tr("White torque noise found"), noise_text(check.white_Nm, tr("none"))},
      {tr("Torque step found"), noise_text(check.torque_step_Nm, tr("none: continuous"))},
      {tr("Torque ripple found (standard deviation)"), noise_text(check.ripple_Nm, tr("none"))}};
  if (!nothing && !check.left_out.empty()) {
    section.facts.push_back({tr("Not simulated"), joined(check.left_out)});
  }
  section.tables.push_back(table_of(check));
  return section;
}

}  // namespace tribolog::report::document
