// Stage 6.

#include <cmath>

#include "report/estimator_words.h"
#include "report/view_parts.h"
#include "wording/units.h"

namespace tribolog::report {
namespace {

std::string reference_in_words(const std::string& reference) {
  if (reference == "analytic") return "the analytic curve that the simulation was made with";
  if (reference == "direction_difference") {
    return "half the difference of the two directions at the same angle, which gravity cannot "
           "enter";
  }
  return reference.empty() ? "none" : reference;
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

void describe_quality_errors(const Calibration& c, Section& section) {
  const QualityErrorsResult& q = c.quality;
  if (q.errors.empty()) return;
  section.facts.push_back({"Reference", reference_in_words(q.reference)});
  section.facts.push_back({"Runs compared", count(c.viscous.runs.size() - q.runs_left_out)});
  section.facts.push_back(
      {"Runs left out", count(q.runs_left_out) + " (no reference, or driving torque near zero)"});

  if (!q.evidence.empty()) {
    section.facts.push_back({"What the reference can tell", as_sentence(q.evidence)});
  }

  Table table;
  table.id = section.id + "-results";
  table.caption = "Deviation of each candidate's curve from the reference";
  table.columns = {{"Estimator", "", false},
                   {"What it is", "", false, true},
                   {"Root mean square", "% of T", true},
                   {"Largest", "% of T", true},
                   {"at motor speed", "rad/s", true}};
  constexpr int digits = 3;
  for (const QualityError& e : q.errors) {
    const std::size_t worst = worst_run(e.percent);
    const bool has_worst = worst < e.percent.size();
    const bool has_speed = has_worst && worst < c.viscous.runs.size();
    table.rows.push_back(
        {{estimator_name(e.estimator), point_meaning(e.estimator),
          significant(e.rms_percent, digits),
          has_worst ? significant(e.percent[worst], digits) : "–",
          has_speed ? significant(c.viscous.runs[worst].speed_rad_s, digits) : "–"},
         e.estimator == c.selection.recommended});
  }
  table.note =
      "100 (T_f,candidate − T_f,reference) / T: the share of the total driving torque. The "
      "marked row is the recommended estimator.";
  section.tables.push_back(table);
}

}  // namespace tribolog::report
