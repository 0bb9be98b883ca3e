// Stage 3.

#include <algorithm>
#include <cmath>

#include "report/document/view_parts.h"
#include "report/elements/loop_points_table.h"
#include "report/elements/result_words.h"
#include "wording/axis_scale.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::document {
namespace {

using wording::tr;

/// The step of the angle; of one that the print sets, only a bound is known.
std::string step_text(const method::hysteresis::Oscillation& o, const wording::Scale& angle) {
  if (!(o.encoder_step_rad > 0.0)) return tr("continuous");
  return (o.step_is_of_print ? "≥ " : "") +
         wording::significant(o.encoder_step_rad * angle.factor, 3);
}

Table oscillations_table(const method::hysteresis::HysteresisResult& r, const Section& section) {
  Table table;
  table.id = section.id + "-oscillations";
  table.caption = tr("The oscillations that were used");
  double stroke = 0.0;
  for (const method::hysteresis::Oscillation& o : r.oscillations)
    stroke = std::max(stroke, std::abs(o.amplitude_rad));
  const wording::Scale angle = wording::radian_scale(stroke);
  table.columns = {{tr("No."), "", false},
                   {tr("Centre"), "°", true},
                   {tr("Amplitude"), angle.unit, true},
                   {tr("Frequency"), "Hz", true},
                   {tr("Cycles"), "", true},
                   {tr("Steady cycles"), "", true},
                   {tr("Encoder step"), angle.unit, true}};
  for (std::size_t i = 0; i < r.oscillations.size(); ++i) {
    const method::hysteresis::Oscillation& o = r.oscillations[i];
    table.rows.push_back(
        {{std::to_string(i + 1), wording::fixed(o.centre_rad * wording::degree_scale().factor, 4),
          wording::significant(o.amplitude_rad * angle.factor, 4),
          wording::significant(o.frequency_Hz, 4), wording::significant(o.cycles, 3),
          wording::significant(o.steady_cycles, 3), step_text(o, angle)},
         false});
  }
  table.note = tr("Angles are at the joint. Steady cycles are those after the start-up stroke.");
  if (std::any_of(r.oscillations.begin(), r.oscillations.end(),
                  [](const method::hysteresis::Oscillation& o) { return o.step_is_of_print; })) {
    table.note += " " + tr("Encoder step with ≥: the resolution of the log's decimals, which hide "
                           "anything finer; the encoder's own may be larger.");
  }
  return table;
}

void add_results(const method::hysteresis::HysteresisResult& r, double gear_ratio,
                 Section& section) {
  Table table = estimates_table(section.id + "-results",
                                tr("Results of stage {stage}", {{"stage", section.number}}));
  if (r.midline_Nm) {
    table.rows.push_back(estimate_row(at_motor(tr("Mid-line torque at q_peak"), gear_ratio),
                                      *r.midline_Nm, wording::torque_scale(r.midline_Nm->value)));
    table.rows.back().is_chosen = true;
  }
  if (r.found) {
    table.rows.push_back(number_row(at_motor(tr("Height of the loop"), gear_ratio),
                                    r.loop_height_Nm, wording::torque_scale(r.loop_height_Nm),
                                    tr("largest minus smallest torque")));
  }
  if (r.presliding_travel_rad) {
    table.rows.push_back(number_row(
        tr("Pre-sliding travel after a reversal"), *r.presliding_travel_rad,
        wording::radian_scale(*r.presliding_travel_rad), tr("reversals of the recordings")));
  }
  if (r.encoder_step_rad) {
    table.rows.push_back(number_row(
        tr("Encoder step"), *r.encoder_step_rad, wording::radian_scale(*r.encoder_step_rad),
        r.step_is_of_print ? tr("decimals of the log; the encoder's may be larger")
                           : tr("smallest step of the angle")));
  }
  if (!table.rows.empty()) section.tables.push_back(table);
}

}  // namespace

void describe_hysteresis(const method::hysteresis::HysteresisResult& r, double gear_ratio,
                         Section& section) {
  if (r.found) {
    section.facts.push_back({tr("Oscillations used"), wording::count(r.oscillations.size())});
    section.facts.push_back({tr("Bristle deflection z"), r.bristle_source.empty()
                                                             ? tr("not known")
                                                             : wording::words(r.bristle_source)});
  }
  add_results(r, gear_ratio, section);
  if (!r.oscillations.empty()) section.tables.push_back(oscillations_table(r, section));
  if (!r.points.empty()) {
    section.tables.push_back(
        elements::loop_points_table(r.points, section.id + "-points",
                                    at_motor(tr("Points A to F, read from the first strokes as the "
                                                "paper does"),
                                             gear_ratio)));
    section.tables.back().note = tr(
        "The first stroke starts from rest: A is read before the loop has closed, which is why A "
        "and B do not mirror each other here.");
  }
  if (!r.steady_points.empty()) {
    section.tables.push_back(elements::loop_points_table(
        r.steady_points, section.id + "-steady-points",
        at_motor(tr("Points A to F of the steady loop, mean of its cycles"), gear_ratio)));
  }
}

}  // namespace tribolog::report::document
