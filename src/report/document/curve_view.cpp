// Stage 5.

#include <algorithm>
#include <cmath>

#include "base/enum_text.h"
#include "report/document/view_parts.h"
#include "report/elements/result_words.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::document {

namespace {

using wording::tr;
using wording::tr_count;

constexpr std::size_t most_rows = 48;  ///< A printed page; the rest is in the embedded result.

std::string at_run(const method::viscous::ViscousCurve* curve, std::size_t run) {
  if (curve == nullptr || run >= curve->friction_Nm.size()) return "–";
  constexpr int decimals = 4;
  return wording::fixed(curve->friction_Nm[run], decimals);
}

std::string mean_text(const method::viscous::ConstantSpeedRun& run) {
  const statistics::Estimate mean{run.torque_Nm,
                                  run.torque_Nm - run.torque_half_width_Nm,
                                  run.torque_Nm + run.torque_half_width_Nm,
                                  {}};
  return wording::round_by_interval(mean, wording::plain_scale("N·m")).plus_minus();
}

std::string runs_in_words(const method::viscous::ViscousCurvesResult& v) {
  const std::size_t runs = v.runs.size();
  if (v.from_sweep) {
    return tr_count(runs, "{bins} angle bin of a sweep in both directions",
                    "{bins} angle bins of a sweep in both directions",
                    {{"bins", wording::count(runs)}});
  }
  return tr_count(runs, "{plateaus} plateau of constant speed",
                  "{plateaus} plateaus of constant speed", {{"plateaus", wording::count(runs)}});
}

}  // namespace

void describe_viscous_curves(const calibration::Calibration& c, Section& section) {
  const method::viscous::ViscousCurvesResult& v = c.viscous;
  if (v.samples_used + v.samples_left_out > 0) {
    section.facts.push_back({tr("Samples used"), wording::count(v.samples_used)});
    section.facts.push_back(
        {tr("Samples left out"), tr("{samples} (rest, acceleration, reversal, settling)",
                                    {{"samples", wording::count(v.samples_left_out)}})});
  }
  if (v.recordings_without_plateau > 0) {
    section.facts.push_back(
        {tr("Recordings without a plateau"), wording::count(v.recordings_without_plateau)});
  }
  if (v.runs.empty()) return;
  section.facts.push_back({tr("Runs"), runs_in_words(v)});

  if (!v.from_sweep)
    section.facts.push_back({tr("Angles"), wording::as_sentence(v.angles.described())});

  const method::viscous::ViscousCurve* recommended = v.find(c.selection.recommended);
  const method::viscous::ViscousCurve* papers = v.find(c.selection.paper_rule);
  Table table;
  table.id = section.id + "-runs";
  table.caption =
      at_motor(tr("Driving torque and friction of each run"), c.manifest.drive.gear_ratio());
  table.columns = {{tr("Motor speed"), "rad/s", true},
                   {tr("Joint speed"), "°/s", true},
                   {tr("Joint angle"), "°", true},
                   {tr("Driving torque T"), "N·m", true},
                   {tr("Samples"), "", true}};
  if (recommended != nullptr) {
    table.columns.push_back(
        {"T_f, " + elements::estimator_name(recommended->estimator), "N·m", true});
  }
  if (papers != nullptr) {
    table.columns.push_back({"T_f, " + elements::estimator_name(papers->estimator), "N·m", true});
  }
  table.columns.push_back({tr("Recording"), "", false});

  const double n = c.manifest.drive.gear_ratio();
  const std::size_t step = (v.runs.size() + most_rows - 1) / most_rows;
  for (std::size_t i = 0; i < v.runs.size(); i += step) {
    const method::viscous::ConstantSpeedRun& run = v.runs[i];
    Row row{{wording::significant(run.speed_rad_s, 4),
             wording::significant(run.speed_rad_s / n * wording::degree_scale().factor, 4),
             wording::fixed(run.q_rad * wording::degree_scale().factor, 2), mean_text(run),
             wording::count(run.samples)},
            false};
    if (recommended != nullptr) row.cells.push_back(at_run(recommended, i));
    if (papers != nullptr) row.cells.push_back(at_run(papers, i));
    row.cells.push_back(wording::or_dash(elements::log_name(run.recording)));
    table.rows.push_back(row);
  }
  table.note = tr("T with the 95 % interval of its mean.");
  if (step > 1) {
    table.note += " " + tr("One row in {rows} is shown; all of them are in the result embedded in "
                           "this file.",
                           {{"rows", step}});
  }
  section.tables.push_back(table);
}

// Stage 6.

namespace {

std::string reference_in_words(method::selection::CurveReference reference) {
  return wording::words_for("reference_meaning", own_name(reference));
}

/// Index of the largest deviation, or the list's size if there is none.
std::size_t worst_run(const std::vector<double>& percent) {
  std::size_t worst = percent.size();
  for (std::size_t i = 0; i < percent.size(); ++i) {
    if (!std::isfinite(percent[i])) continue;
    if (worst == percent.size() || std::abs(percent[i]) > std::abs(percent[worst])) worst = i;
  }
  return worst;
}

}  // namespace

void describe_quality_errors(const calibration::Calibration& c, Section& section) {
  const method::selection::QualityErrorsResult& q = c.quality;
  if (q.errors.empty()) return;
  section.facts.push_back({tr("Reference"), reference_in_words(q.reference)});
  section.facts.push_back(
      {tr("Runs compared"), wording::count(c.viscous.runs.size() - q.runs_left_out)});
  section.facts.push_back(
      {tr("Runs left out"), tr("{runs} (no reference, or driving torque near zero)",
                               {{"runs", wording::count(q.runs_left_out)}})});

  if (!q.evidence.empty()) {
    section.facts.push_back({tr("What the reference can show"), wording::as_sentence(q.evidence)});
  }

  Table table;
  table.id = section.id + "-results";
  table.caption = tr("Deviation of each candidate's curve from the reference");
  table.columns = {{tr("Estimator"), "", false},
                   {tr("What it is"), "", false, true},
                   {tr("Root mean square"), tr("% of T"), true},
                   {tr("Largest"), tr("% of T"), true},
                   {tr("at motor speed"), "rad/s", true}};
  constexpr int digits = 3;
  for (const method::selection::QualityError& e : q.errors) {
    const std::size_t worst = worst_run(e.percent);
    const bool has_worst = worst < e.percent.size();
    const bool has_speed = has_worst && worst < c.viscous.runs.size();
    table.rows.push_back(
        {{elements::estimator_name(e.estimator), elements::meaning_of(e.estimator),
          wording::significant(e.rms_percent, digits),
          has_worst ? wording::significant(e.percent[worst], digits) : "–",
          has_speed ? wording::significant(c.viscous.runs[worst].speed_rad_s, digits) : "–"},
         e.estimator == c.selection.recommended});
  }
  table.note =
      tr("100 (T_f,candidate − T_f,reference) / T: the share of the total driving torque. The "
         "marked row is the recommended estimator.");
  section.tables.push_back(table);
}

// Stage 7.

namespace {

void add_choice(const calibration::Calibration& c, const std::string& label,
                std::optional<method::hysteresis::Estimator> estimator, bool is_chosen,
                Table& table) {
  const method::hysteresis::SurrogateMass* mass = c.masses.find(estimator);
  if (mass == nullptr) {
    table.rows.push_back({{label, tr("cannot be said"), "–", "–", "–", "–"}, false});
    return;
  }
  const method::selection::QualityError* error = c.quality.find(estimator);
  constexpr int digits = 3;
  table.rows.push_back(
      {{label,
        elements::estimator_name(mass->estimator) + ": " + elements::meaning_of(mass->estimator),
        wording::round_by_interval(mass->torque_Nm, wording::plain_scale("N·m")).plus_minus(),
        wording::round_by_interval(mass->mass_kg, wording::plain_scale("kg")).plus_minus(),
        wording::fixed(mass->q_rad * wording::degree_scale().factor, 4),
        error != nullptr ? wording::significant(error->rms_percent, digits) : "–"},
       is_chosen});
}

}  // namespace

void describe_selection(const calibration::Calibration& c, Section& section) {
  const method::selection::SelectionResult& s = c.selection;
  if (!s.why.empty()) section.facts.push_back({tr("Why"), wording::as_sentence(s.why)});
  if (s.paper_rule || s.recommended) {
    Table table;
    table.id = section.id + "-results";
    table.caption = tr("The choice");
    table.columns = {{tr("Rule"), "", false},       {tr("Estimator"), "", false},
                     {tr("Torque T"), "N·m", true}, {tr("Surrogate mass"), "kg", true},
                     {tr("Read at q"), "°", true},  {tr("Quality error, rms"), tr("% of T"), true}};
    add_choice(c, tr("Recommended by this program"), s.recommended, true, table);
    add_choice(c, tr("The paper's: smallest error among A to F"), s.paper_rule, false, table);
    section.tables.push_back(table);
  }
  Table angles = estimates_table(section.id + "-angle",
                                 tr("Angle of the centre of gravity in the link, q_c = −q_peak"));
  if (s.q_c_rad) {
    angles.rows.push_back(estimate_row("q_c", *s.q_c_rad, wording::degree_scale()));
    angles.rows.back().is_chosen = true;
    angles.rows.push_back(estimate_row("q_c", *s.q_c_rad, wording::radian_scale(s.q_c_rad->value)));
  }
  if (s.q_c_corrected_rad) {
    // As many places as q_c has: the correction is far smaller than its interval.
    const double corrected = *s.q_c_corrected_rad;
    const std::string from = tr("eq. (14) for the paper's choice");
    for (const wording::Scale& scale :
         {wording::degree_scale(), wording::radian_scale(corrected)}) {
      constexpr int digits = 7;
      angles.rows.push_back(
          {{tr("q_c minus the angle at which the torque was read"),
            wording::significant(corrected * scale.factor, digits), scale.unit, "–", from},
           false});
    }
  }
  if (!angles.rows.empty()) section.tables.push_back(angles);
}

}  // namespace tribolog::report::document
