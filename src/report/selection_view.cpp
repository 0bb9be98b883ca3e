// Stage 7.

#include "report/estimator_words.h"
#include "report/view_parts.h"
#include "wording/units.h"

namespace tribolog::report {
namespace {

void add_choice(const Calibration& c, const std::string& label, const std::string& estimator,
                bool is_chosen, Table& table) {
  const SurrogateMass* mass = estimator.empty() ? nullptr : c.masses.find(estimator);
  if (mass == nullptr) {
    table.rows.push_back({{label, "cannot be said", "–", "–", "–", "–"}, false});
    return;
  }
  const QualityError* error = c.quality.find(estimator);
  constexpr int digits = 3;
  table.rows.push_back({{label, estimator_name(estimator) + ": " + point_meaning(estimator),
                         round_by_interval(mass->torque_Nm, plain_scale("N·m")).plus_minus(),
                         round_by_interval(mass->mass_kg, plain_scale("kg")).plus_minus(),
                         fixed(mass->q_rad * degree_scale().factor, 4),
                         error != nullptr ? significant(error->rms_percent, digits) : "–"},
                        is_chosen});
}

}  // namespace

void describe_selection(const Calibration& c, Section& section) {
  const SelectionResult& s = c.selection;
  if (!s.why.empty()) section.facts.push_back({"Why", as_sentence(s.why)});
  if (!s.paper_rule.empty() || !s.recommended.empty()) {
    Table table;
    table.id = section.id + "-results";
    table.caption = "The choice";
    table.columns = {{"Rule", "", false},       {"Estimator", "", false},
                     {"Torque T", "N·m", true}, {"Surrogate mass", "kg", true},
                     {"Read at q", "°", true},  {"Quality error, rms", "% of T", true}};
    add_choice(c, "Recommended by this program", s.recommended, true, table);
    add_choice(c, "The paper's: smallest error among A to F", s.paper_rule, false, table);
    section.tables.push_back(table);
  }
  Table angles;
  angles.id = section.id + "-angle";
  angles.caption = "Angle of the centre of gravity in the link, q_c = −q_peak";
  angles.columns = estimate_columns();
  if (s.q_c_rad) {
    angles.rows.push_back(estimate_row("q_c", *s.q_c_rad, degree_scale()));
    angles.rows.back().is_chosen = true;
    angles.rows.push_back(estimate_row("q_c", *s.q_c_rad, radian_scale(s.q_c_rad->value)));
  }
  if (s.q_c_corrected_rad) {
    // As many places as q_c has: the correction is far smaller than its interval.
    const double corrected = *s.q_c_corrected_rad;
    const std::string from = "eq. (14) for the paper's choice";
    for (const Scale& scale : {degree_scale(), radian_scale(corrected)}) {
      constexpr int digits = 7;
      angles.rows.push_back({{"q_c less the angle at which the torque was read",
                              significant(corrected * scale.factor, digits), scale.unit, "–", from},
                             false});
    }
  }
  if (!angles.rows.empty()) section.tables.push_back(angles);
}

}  // namespace tribolog::report
