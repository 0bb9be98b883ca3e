// The known-truth check.

#include <fmt/format.h>

#include "report/view_parts.h"
#include "truth/readings.h"
#include "wording/units.h"

namespace tribolog::report {
namespace {

constexpr int digits = 3;

/// An angle is read in degrees.
Scale scale_of(const ReturnedQuantity& q) {
  return q.unit == "rad" ? degree_scale() : plain_scale(q.unit);
}

Row row_of(const ReturnedQuantity& q) {
  const Scale scale = scale_of(q);
  const std::string words = as_sentence(reading_words(q.name));
  const std::string name = words.substr(0, words.size() - 1);
  const Estimate put_in = symmetric_estimate(q.put_in, q.half_width, "");
  const RoundedEstimate rounded = round_by_interval(put_in, scale);
  if (q.found == 0) {
    return {{name, rounded.estimate, "not found", "–", "–", scale.unit, "0 of 0", "no"}, false};
  }
  const RoundedEstimate back =
      round_by_interval(symmetric_estimate(q.came_back, q.half_width, ""), scale);
  const double deviation = (q.came_back - q.put_in) * scale.factor;
  return {{name, rounded.estimate, back.estimate, with_plus_sign(significant(deviation, digits)),
           significant(q.half_width * scale.factor, digits), scale.unit,
           fmt::format("{} of {}", q.inside, q.found), q.comes_back ? "yes" : "no"},
          false};
}

Table table_of(const TruthCheckResult& check) {
  Table table;
  table.id = "known-truth-results";
  table.caption =
      fmt::format("What was put in and what came back, means over {} simulations", check.runs);
  table.columns = {{"Quantity", "", false, true},     {"Put in", "", true},
                   {"Came back", "", true},           {"Deviation", "", true},
                   {"Stated half width", "", true},   {"Unit", "", false},
                   {"Inside the interval", "", true}, {"Comes back", "", false}};
  for (const ReturnedQuantity& q : check.quantities) table.rows.push_back(row_of(q));
  table.note =
      "It comes back if it is found in most simulations and in most of them is held by the stated "
      "interval, or is off by less than matters: 0.1 % of a torque, 0.006° of the angle, 1 % of a "
      "parameter.";
  return table;
}

std::string noise_text(double value_Nm, const char* none) {
  if (!(value_Nm > 0)) return none;
  const Scale scale = torque_scale(value_Nm);
  return with_unit(significant(value_Nm * scale.factor, digits), scale.unit);
}

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : "; ") + text;
  return all;
}

}  // namespace

Section truth_check_section(const TruthCheckResult& check, int number) {
  Section section;
  section.number = number;
  section.id = "known-truth";
  section.title = "Known-truth check";
  section.explanation = "explain_known_truth.tpl";
  const bool nothing = check.quantities.empty();
  section.outcome = nothing                  ? Outcome::absent
                    : check.findings.empty() ? Outcome::good
                                             : Outcome::bad;
  section.status = nothing                  ? "not possible"
                   : check.findings.empty() ? "comes back"
                                            : "does not come back";
  std::vector<std::string> findings;
  for (const TruthFinding& finding : check.findings) findings.push_back(finding.words);
  section.reason = as_sentence(joined(findings));
  if (nothing) section.reason = as_sentence(joined(check.left_out));
  section.facts = {
      {"Simulations", std::to_string(check.runs)},
      {"White torque noise found", noise_text(check.white_Nm, "none")},
      {"Torque step found", noise_text(check.torque_step_Nm, "none: continuous")},
      {"Torque ripple found (standard deviation)", noise_text(check.ripple_Nm, "none")}};
  if (!nothing && !check.left_out.empty()) {
    section.facts.push_back({"Not simulated", joined(check.left_out)});
  }
  section.tables.push_back(table_of(check));
  return section;
}

}  // namespace tribolog::report
