// Stage 5.

#include <algorithm>
#include <cmath>

#include "report/view_parts.h"
#include "wording/units.h"

namespace tribolog::report {
namespace {

constexpr std::size_t most_rows = 48;  ///< A printed page; the rest is in the embedded result.

std::string at_run(const ViscousCurve* curve, std::size_t run) {
  if (curve == nullptr || run >= curve->friction_Nm.size()) return "–";
  constexpr int decimals = 4;
  return fixed(curve->friction_Nm[run], decimals);
}

std::string mean_text(const ConstantSpeedRun& run) {
  const Estimate mean{run.torque_Nm, run.torque_Nm - run.torque_half_width_Nm,
                      run.torque_Nm + run.torque_half_width_Nm, ""};
  return round_by_interval(mean, plain_scale("N·m")).plus_minus();
}

void describe_run_gravity(const Calibration& c, Section& section) {
  const RunGravityResult& r = c.run_gravity;
  if (c.viscous.from_sweep) return;
  if (!r.found && r.reason.empty()) return;
  if (!r.found) {
    if (!r.reason.empty()) {
      section.facts.push_back({"Gravity from the runs", as_sentence(r.reason)});
    }
    return;
  }
  const Estimate gravity = scaled(r.gravity_Nm, c.manifest.drive.gear_ratio());
  section.facts.push_back(
      {"Gravity from the runs",
       in_words(gravity, torque_scale(gravity.value)) + " at the joint, largest at " +
           in_words(r.q_peak_rad, degree_scale()) + "; one offset for each of " +
           count(r.runs_used) + " runs, " + count(r.runs_left_out) + " travel too short a way." +
           (r.always_lifts ? " The drive lifts the load all the way: friction that grows with the "
                             "load is in it."
                           : "")});
}

}  // namespace

void describe_viscous_curves(const Calibration& c, Section& section) {
  const ViscousCurvesResult& v = c.viscous;
  if (v.samples_used + v.samples_left_out > 0) {
    section.facts.push_back({"Samples used", count(v.samples_used)});
    section.facts.push_back({"Samples left out", count(v.samples_left_out) +
                                                     " (rest, acceleration, reversal, settling)"});
  }
  if (v.recordings_without_plateau > 0) {
    section.facts.push_back({"Recordings without a plateau", count(v.recordings_without_plateau)});
  }
  if (v.runs.empty()) return;
  section.facts.push_back(
      {"Runs", count(v.runs.size()) + (v.from_sweep ? " angle bins of a sweep in both directions"
                                                    : " plateaus of constant speed")});

  if (!v.from_sweep) section.facts.push_back({"Angles", as_sentence(v.angles.in_words())});
  describe_run_gravity(c, section);

  const ViscousCurve* recommended = v.find(c.selection.recommended);
  const ViscousCurve* papers =
      c.selection.paper_rule.empty() ? nullptr : v.find(c.selection.paper_rule);
  Table table;
  table.id = section.id + "-runs";
  table.caption = "Driving torque and friction of each run, at the motor";
  table.columns = {{"Motor speed", "rad/s", true},
                   {"Joint speed", "°/s", true},
                   {"Joint angle", "°", true},
                   {"Driving torque T", "N·m", true},
                   {"Samples", "", true}};
  if (recommended != nullptr) {
    table.columns.push_back({"T_f, " + estimator_name(recommended->estimator), "N·m", true});
  }
  if (papers != nullptr) {
    table.columns.push_back({"T_f, " + estimator_name(papers->estimator), "N·m", true});
  }
  table.columns.push_back({"Recording", "", false});

  const double n = c.manifest.drive.gear_ratio();
  const std::size_t step = (v.runs.size() + most_rows - 1) / most_rows;
  for (std::size_t i = 0; i < v.runs.size(); i += step) {
    const ConstantSpeedRun& run = v.runs[i];
    Row row{{significant(run.speed_rad_s, 4),
             significant(run.speed_rad_s / n * degree_scale().factor, 4),
             fixed(run.q_rad * degree_scale().factor, 2), mean_text(run), count(run.samples)},
            false};
    if (recommended != nullptr) row.cells.push_back(at_run(recommended, i));
    if (papers != nullptr) row.cells.push_back(at_run(papers, i));
    row.cells.push_back(or_dash(log_name(run.recording)));
    table.rows.push_back(row);
  }
  table.note = "T with the 95 % interval of its mean.";
  if (step > 1) {
    table.note += " One row in " + std::to_string(step) +
                  " is shown; all of them are in the result embedded in this file.";
  }
  section.tables.push_back(table);
}

}  // namespace tribolog::report
