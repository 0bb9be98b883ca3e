#include "figures/candidate_figures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/requirements.h"
#include "figures/close_up.h"
#include "figures/estimator_style.h"
#include "figures/outliers.h"
#include "figures/run_curves.h"
#include "wording/labels.h"
#include "wording/number_text.h"
#include "wording/tr.h"

namespace tribolog::figures {

namespace {

using method::hysteresis::Estimator;
using method::selection::CurveReference;
using wording::tr;
using wording::tr_count;

wording::AxisScale friction_scale(const calibration::Calibration& calibration) {
  wording::Extent all;
  for (const method::viscous::ViscousCurve& curve : calibration.viscous.curves)
    all.add(curve.friction_Nm);
  return wording::prefixed("N·m", all.largest());
}

render::figure::Panel all_candidates(const calibration::Calibration& calibration,
                                     const wording::AxisScale& scale, bool with_reference) {
  render::figure::Panel panel;
  panel.x.title = wording::speed_quantity(calibration.manifest) + " [rad/s]";
  panel.y.title = wording::axis_title(tr("friction T_{{f}}"), scale);
  std::vector<NamedValues> curves;
  wording::Extent friction;
  for (const method::viscous::ViscousCurve& curve : calibration.viscous.curves) {
    curves.push_back({curve.estimator, curve.friction_Nm});
    friction.add(curve.friction_Nm);
  }
  for (const NamedValues& curve : in_drawing_order(std::move(curves), friction.span())) {
    add_run_curve(panel, calibration.viscous, estimator_style(curve.estimator),
                  legend_words(calibration, curve), curve.values, scale);
  }
  if (with_reference) add_reference(panel, calibration, scale);
  return panel;
}

/// "40 runs (20 in each direction) from 1.00 to 300 rad/s"
std::string runs_words(const method::viscous::ViscousCurvesResult& viscous) {
  std::size_t forward = 0;
  std::size_t backward = 0;
  wording::Extent speeds;
  for (const method::viscous::ConstantSpeedRun& run : viscous.runs) {
    ++(run.speed_rad_s > 0.0 ? forward : backward);
    speeds.add(std::abs(run.speed_rad_s));
  }
  const auto count = static_cast<std::int64_t>(viscous.runs.size());
  const std::string slowest = wording::significant(speeds.low, 3);
  const std::string fastest = wording::with_unit(speeds.high, wording::AxisScale{1.0, "rad/s"}, 3);
  if (viscous.from_sweep) {
    return tr_count(
        count,
        "{bins} angle bin ({forward} forward, {backward} backward) from {slowest} to {fastest}",
        "{bins} angle bins ({forward} forward, {backward} backward) from {slowest} to {fastest}",
        {{"bins", count},
         {"forward", forward},
         {"backward", backward},
         {"slowest", slowest},
         {"fastest", fastest}});
  }
  return tr_count(
      count, "{runs} run ({forward} forward, {backward} backward) from {slowest} to {fastest}",
      "{runs} runs ({forward} forward, {backward} backward) from {slowest} to {fastest}",
      {{"runs", count},
       {"forward", forward},
       {"backward", backward},
       {"slowest", slowest},
       {"fastest", fastest}});
}

/// @param runs of runs_words()
std::string caption_of_curves(const calibration::Calibration& calibration,
                              const std::string& runs) {
  wording::Extent masses;
  for (const method::hysteresis::SurrogateMass& mass : calibration.masses.masses) {
    masses.add(mass.mass_kg.value);
  }
  if (!(masses.span() > 0.0)) {
    return tr(
        "Driving torque minus the gravity torque of the candidate mass ({mass_kg} kg), over "
        "{runs_and_speeds}.",
        {{"mass_kg", wording::significant(masses.low, 4)}, {"runs_and_speeds", runs}});
  }
  const std::size_t candidates = calibration.viscous.curves.size();
  return tr(
      "Driving torque minus the gravity torque of each of {candidates} candidate masses "
      "({lightest_kg} to {heaviest_kg} kg), over {runs_and_speeds}.",
      {{"candidates", candidates},
       {"lightest_kg", wording::significant(masses.low, 3)},
       {"heaviest_kg", wording::significant(masses.high, 3)},
       {"runs_and_speeds", runs}});
}

/// @param runs of runs_words()
std::string alt_of_curves(const calibration::Calibration& calibration, const std::string& runs) {
  const auto count = static_cast<std::int64_t>(calibration.viscous.curves.size());
  if (wording::has_motor_side(calibration.manifest)) {
    return tr_count(count,
                    "Friction torque against signed motor speed for {candidates} candidate, over "
                    "{runs_and_speeds}.",
                    "Friction torque against signed motor speed for {candidates} candidates, over "
                    "{runs_and_speeds}.",
                    {{"candidates", count}, {"runs_and_speeds", runs}});
  }
  return tr_count(count,
                  "Friction torque against signed joint speed for {candidates} candidate, over "
                  "{runs_and_speeds}.",
                  "Friction torque against signed joint speed for {candidates} candidates, over "
                  "{runs_and_speeds}.",
                  {{"candidates", count}, {"runs_and_speeds", runs}});
}

std::vector<NamedValues> differences(const calibration::Calibration& calibration) {
  std::vector<NamedValues> all;
  const auto& reference = calibration.quality.reference_Nm;
  for (const method::viscous::ViscousCurve& curve : calibration.viscous.curves) {
    NamedValues difference{curve.estimator, {}};
    for (std::size_t i = 0; i < std::min(curve.friction_Nm.size(), reference.size()); ++i) {
      difference.values.push_back(curve.friction_Nm[i] - reference[i]);
    }
    all.push_back(std::move(difference));
  }
  return all;
}

}  // namespace

std::optional<ReportFigure> friction_curves_figure(const calibration::Calibration& calibration) {
  const method::viscous::ViscousCurvesResult& viscous = calibration.viscous;
  if (viscous.runs.empty()) return std::nullopt;
  ReportFigure out;
  out.paper_number = 18;
  out.id = "fig-18-friction-curves";
  out.title = tr("Friction against speed, all candidates");
  out.stage = "viscous_curves";
  const wording::AxisScale scale = friction_scale(calibration);
  out.figure.panels.push_back(all_candidates(calibration, scale, false));
  if (out.figure.panels.front().series.empty()) return std::nullopt;
  const std::string runs = runs_words(viscous);
  out.caption = caption_of_curves(calibration, runs);
  out.how_to_read =
      tr("Friction is odd: the right mass gives a curve of equal height on both sides of zero. A "
         "wrong mass shifts its curve up or down as a whole, so that friction is larger in one "
         "direction than in the other, or even drives the joint.");
  out.alt = alt_of_curves(calibration, runs);
  return out;
}

std::optional<ReportFigure> friction_against_reference_figure(
    const calibration::Calibration& calibration) {
  if (calibration.viscous.runs.empty() || calibration.quality.reference == CurveReference::none) {
    return std::nullopt;
  }
  ReportFigure out;
  out.paper_number = 19;
  out.id = "fig-19-friction-against-reference";
  out.title = tr("Friction against speed, with the reference");
  out.stage = "quality_errors";
  const wording::AxisScale scale = friction_scale(calibration);
  render::figure::Panel curves = all_candidates(calibration, scale, true);
  if (curves.series.empty()) return std::nullopt;
  const auto difference = differences(calibration);
  const double limit = close_up_limit(difference, calibration.selection);
  render::figure::Panel below =
      close_up_panel(calibration, difference, limit, tr("T_{{f}} − reference"), "N·m");
  share_legend(curves, below);
  out.figure.panels.push_back(std::move(curves));
  if (!below.series.empty()) {
    out.figure.panels.push_back(std::move(below));
    out.figure.panels_share_x = true;
    out.figure.height_px = 1400;
  }

  const std::optional<Estimator> recommended = calibration.selection.recommended;
  wording::Extent chosen;
  for (const NamedValues& one : difference) {
    if (one.estimator == recommended) chosen.add(one.values);
  }
  const std::string reference = reference_words(calibration.quality.reference);
  const std::string away =
      chosen.empty
          ? std::string()
          : " " + tr("The largest difference of the recommended candidate, {candidate}, is "
                     "{difference}.",
                     {{"candidate", candidate_words(calibration, present(recommended))},
                      {"difference",
                       wording::size_words(chosen.largest(), wording::torque_floor_Nm, "N·m")}});
  out.caption = tr("The candidates of figure 18 against the reference ({reference}).",
                   {{"reference", reference}}) +
                away;
  out.how_to_read =
      tr("Above, the reference is in black; AB, CD and EF are the means of opposite points. Below, "
         "the difference from it: a wrong mass gives a level line off zero; a line that bends with "
         "speed would be an error of the friction measurement itself, which no choice of mass can "
         "correct.");
  out.alt =
      (wording::has_motor_side(calibration.manifest)
           ? tr("Candidate friction curves and the reference ({reference}) against motor speed.",
                {{"reference", reference}})
           : tr("Candidate friction curves and the reference ({reference}) against joint speed.",
                {{"reference", reference}})) +
      away;
  return out;
}

namespace {

std::string rms_words(const method::selection::QualityErrorsResult& quality,
                      std::optional<Estimator> estimator) {
  const method::selection::QualityError* error = quality.find(estimator);
  if (error == nullptr) return {};
  return fmt::format("{} {}", estimator_words(error->estimator),
                     wording::size_words(error->rms_percent, wording::percent_floor, "%"));
}

/// How well the reference itself is known, as a bar about zero at each run.
void add_interval_of_reference(render::figure::Panel& panel,
                               const calibration::Calibration& calibration) {
  const method::selection::QualityErrorsResult& quality = calibration.quality;
  if (!(quality.reference_rms_percent > 0.0)) return;
  const std::vector<double>& errors = quality.errors.front().percent;
  const std::size_t size = std::min(
      {quality.reference_half_width_Nm.size(), calibration.viscous.runs.size(), errors.size()});
  for (std::size_t i = 0; i < size; ++i) {
    const method::viscous::ConstantSpeedRun& run = calibration.viscous.runs[i];
    const double percent = std::abs(100 * quality.reference_half_width_Nm[i] / run.torque_Nm);
    if (!std::isfinite(errors[i] + percent)) continue;
    panel.error_bars.push_back({run.speed_rad_s, -percent, percent, render::figure::palette::grey});
  }
}

/// Root mean square of the selected candidates; empty without any.
std::string rms_of_selected(const calibration::Calibration& calibration) {
  const std::optional<Estimator> paper_rule = calibration.selection.paper_rule;
  const std::optional<Estimator> recommended = calibration.selection.recommended;
  std::vector<std::string> words{rms_words(calibration.quality, paper_rule)};
  if (recommended != paper_rule) words.push_back(rms_words(calibration.quality, recommended));
  std::erase(words, "");
  if (words.empty()) return {};
  return " " +
         tr("Root mean square over the runs: {errors}.", {{"errors", wording::listed(words)}});
}

std::string caption_of_errors(const method::selection::QualityErrorsResult& quality,
                              const std::string& rms) {
  std::string caption = tr("Error of each candidate against the reference ({reference}).",
                           {{"reference", reference_words(quality.reference)}}) +
                        rms;
  if (quality.reference_rms_percent > 0.0) {
    const std::string interval =
        wording::size_words(quality.reference_rms_percent, wording::percent_floor, "%");
    caption += " " + tr("Bars about zero: 95 % interval of the reference itself, ± {interval} rms.",
                        {{"interval", interval}});
  }
  if (quality.runs_left_out == 0) return caption;
  return caption + " " +
         tr_count(static_cast<std::int64_t>(quality.runs_left_out),
                  "{runs} run without a reference, or with a driving torque near zero, left out.",
                  "{runs} runs without a reference, or with a driving torque near zero, left out.",
                  {{"runs", quality.runs_left_out}});
}

std::string alt_of_errors(const calibration::Calibration& calibration) {
  const auto count = static_cast<std::int64_t>(calibration.quality.errors.size());
  if (wording::has_motor_side(calibration.manifest)) {
    return tr_count(
        count,
        "Error of {candidates} candidate in per cent of the driving torque against motor speed.",
        "Error of {candidates} candidates in per cent of the driving torque against motor speed.",
        {{"candidates", count}});
  }
  return tr_count(
      count,
      "Error of {candidates} candidate in per cent of the driving torque against joint speed.",
      "Error of {candidates} candidates in per cent of the driving torque against joint speed.",
      {{"candidates", count}});
}

std::vector<NamedValues> errors_of(const method::selection::QualityErrorsResult& quality) {
  std::vector<NamedValues> errors;
  for (const method::selection::QualityError& error : quality.errors) {
    errors.push_back({error.estimator, error.percent});
  }
  return errors;
}

}  // namespace

std::optional<ReportFigure> quality_error_figure(const calibration::Calibration& calibration) {
  const method::selection::QualityErrorsResult& quality = calibration.quality;
  if (quality.reference == CurveReference::none || quality.errors.empty()) return std::nullopt;
  const std::vector<NamedValues> errors = errors_of(quality);

  ReportFigure out;
  out.paper_number = 20;
  out.id = "fig-20-quality-error";
  out.title = tr("Error in % of the driving torque");
  out.stage = "quality_errors";
  const std::string symbol = tr("error 100 (T_{{f}} − T_{{f,ref}}) / T");
  render::figure::Panel all = close_up_panel(calibration, errors, 0.0, symbol, "%");
  if (all.series.empty()) return std::nullopt;
  add_interval_of_reference(all, calibration);
  out.figure.panels.push_back(std::move(all));
  const double limit = close_up_limit(errors, calibration.selection);
  if (limit > 0.0) {
    render::figure::Panel near = close_up_panel(calibration, errors, limit, symbol, "%");
    add_interval_of_reference(near, calibration);
    share_legend(out.figure.panels.front(), near);
    out.figure.panels.push_back(std::move(near));
    out.figure.panels_share_x = true;
    out.figure.height_px = 1400;
  }

  const std::string rms = rms_of_selected(calibration);
  out.caption = caption_of_errors(quality, rms);
  out.how_to_read =
      tr("The closer to zero over all speeds, the better the mass. A wrong mass gives a level line "
         "in each direction, with a step between them because the driving torque differs; scatter "
         "as large as the distance between two candidates means that the runs cannot decide "
         "between them.");
  if (quality.reference_rms_percent > 0.0) {
    out.how_to_read +=
        " " +
        tr("An error within its bar is not significant: the reference is not known any better.");
  }
  out.alt = alt_of_errors(calibration) + rms;
  return out;
}

namespace {

constexpr double chosen_width = 1.4;  // times the usual
constexpr double other_width = 0.7;   // times the usual

/// The curve that is drawn for the estimator, itself or one that coincides with it.
Estimator drawn_for(const std::vector<NamedValues>& curves, Estimator estimator) {
  const auto stands_for = [&](const NamedValues& curve) {
    return std::find(curve.same.begin(), curve.same.end(), estimator_words(estimator)) !=
               curve.same.end() ||
           std::find(curve.same.begin(), curve.same.end(), to_string(estimator)) !=
               curve.same.end();
  };
  const auto found = std::find_if(curves.begin(), curves.end(), stands_for);
  return found == curves.end() ? estimator : found->estimator;
}

/// The curves below have the names that those above have.
void name_as_above(const render::figure::Panel& above, render::figure::Panel& below) {
  for (render::figure::Series& series : below.series) {
    const auto same = std::find_if(above.series.begin(), above.series.end(), [&](const auto& one) {
      return !one.label.empty() && series.label.starts_with(one.label);
    });
    if (same != above.series.end()) series.label = same->label;
  }
  below.labels_at_ends = below.show_legend = above.labels_at_ends;
}

/// Strengthens the candidate's curve, and makes the others thin.
void emphasise(render::figure::Panel& panel, const std::string& candidate,
               const std::string& reference) {
  bool is_chosen = false;
  bool is_reference = false;
  for (render::figure::Series& series : panel.series) {
    // The second half of a curve has no label.
    if (!series.label.empty()) {
      is_chosen = series.label.starts_with(candidate);
      is_reference = series.label == reference;
    }
    if (is_reference) continue;
    series.width_px *= is_chosen ? chosen_width : other_width;
    series.marker_size_px *= other_width;
  }
}

/// "The curve of A also stands for B and C."; empty: each is drawn. @param curves in drawing order
std::string coinciding_in_words(const calibration::Calibration& calibration,
                                const std::vector<NamedValues>& curves) {
  std::string words;
  for (const NamedValues& curve : curves) {
    if (curve.same.empty()) continue;
    words += " " + tr("The curve of {candidate} also stands for {others}.",
                      {{"candidate", candidate_words(calibration, curve.estimator)},
                       {"others", wording::listed(curve.same)}});
  }
  return words;
}

/// Decades of speed in both directions, where it spans more than one.
void spread_speeds(const calibration::Calibration& calibration, render::figure::Figure& figure) {
  double slowest = INFINITY;
  double fastest = 0;
  for (const method::viscous::ConstantSpeedRun& run : calibration.viscous.runs) {
    const double speed = run.speed_rad_s;
    if (speed == 0) continue;
    slowest = std::min(slowest, std::abs(speed));
    fastest = std::max(fastest, std::abs(speed));
  }
  if (!(fastest > 10 * slowest)) return;
  for (render::figure::Panel& panel : figure.panels) panel.x.linear_within = slowest;
}

/// Friction of the candidates that the errors are drawn for. Those that lie far off all others are
/// left out.
/// @param curves in drawing order, each with its error
render::figure::Panel candidates_panel(const calibration::Calibration& calibration,
                                       const std::vector<NamedValues>& curves,
                                       const wording::AxisScale& scale) {
  render::figure::Panel panel;
  panel.x.title = wording::speed_quantity(calibration.manifest) + " [rad/s]";
  panel.y.title = wording::axis_title(tr("friction T_{{f}}"), scale);
  std::vector<double> distances;
  distances.reserve(curves.size());
  for (const NamedValues& curve : curves) {
    distances.push_back(wording::extent_of(curve.values).largest());
  }
  const double reach = reach_of_the_many(distances);
  std::vector<std::string> outside;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const method::viscous::ViscousCurve* friction = calibration.viscous.find(curves[i].estimator);
    if (friction == nullptr) continue;
    if (reach > 0.0 && distances[i] > reach) {
      outside.push_back(candidate_words(calibration, curves[i].estimator));
      continue;
    }
    add_run_curve(panel, calibration.viscous, estimator_style(curves[i].estimator),
                  candidate_words(calibration, curves[i].estimator), friction->friction_Nm, scale);
  }
  panel.labels_at_ends = !calibration.viscous.from_sweep;  // points have no ends
  if (!outside.empty()) {
    panel.title = tr("outside: {candidates}", {{"candidates", wording::listed(outside)}});
  }
  return panel;
}

}  // namespace

std::optional<ReportFigure> friction_candidates_figure(
    const calibration::Calibration& calibration) {
  const method::selection::QualityErrorsResult& quality = calibration.quality;
  if (calibration.viscous.runs.empty()) return std::nullopt;
  const bool has_errors = quality.reference != CurveReference::none && !quality.errors.empty();
  ReportFigure out;
  out.id = "fig-friction-candidates";
  out.is_primary = true;
  out.title = calibration.viscous.curves.size() > 1 ? tr("Friction by each candidate mass")
                                                    : tr("Friction against speed");
  out.stage = has_errors ? "quality_errors" : "viscous_curves";
  const wording::AxisScale scale = friction_scale(calibration);
  const std::string runs = runs_words(calibration.viscous);
  const std::vector<NamedValues> errors = errors_of(quality);
  const double limit = has_errors ? close_up_limit(errors, calibration.selection) : 0.0;
  const std::string reference = has_errors ? reference_label(calibration) : std::string();
  std::string coinciding;
  render::figure::Panel upper;
  std::optional<std::string> chosen;
  if (has_errors) {
    wording::Extent all;
    for (const NamedValues& error : errors) all.add(error.values);
    const std::vector<NamedValues> curves =
        in_drawing_order(errors, limit > 0.0 ? 2 * limit : all.span());
    upper = candidates_panel(calibration, curves, scale);
    coinciding = coinciding_in_words(calibration, curves);
    add_reference(upper, calibration, scale);
    if (calibration.selection.recommended) {
      chosen = candidate_words(calibration, drawn_for(curves, *calibration.selection.recommended));
    }
  } else {
    upper = all_candidates(calibration, scale, false);
    if (calibration.selection.recommended) {
      chosen = candidate_words(calibration, *calibration.selection.recommended);
    }
  }
  if (upper.series.empty()) return std::nullopt;
  if (chosen) emphasise(upper, *chosen, reference);
  out.figure.panels.push_back(std::move(upper));
  out.how_to_read =
      tr("Friction is odd: the right mass gives a curve of equal height on both sides of zero; a "
         "wrong one shifts its curve up or down as a whole. The strong curve is the recommended "
         "candidate's.");
  if (!has_errors) {
    spread_speeds(calibration, out.figure);
    out.caption = caption_of_curves(calibration, runs);
    out.alt = alt_of_curves(calibration, runs);
    return out;
  }
  render::figure::Panel below =
      close_up_panel(calibration, errors, limit, tr("error 100 (T_{{f}} − T_{{f,ref}}) / T"), "%");
  if (!below.series.empty()) {
    add_interval_of_reference(below, calibration);
    if (chosen) emphasise(below, *chosen, reference);
    name_as_above(out.figure.panels.front(), below);
    out.figure.panels.push_back(std::move(below));
    out.figure.panels_share_x = true;
    out.figure.height_px = 1300;
  }
  spread_speeds(calibration, out.figure);
  const std::string rms = rms_of_selected(calibration);
  out.caption =
      caption_of_curves(calibration, runs) + coinciding + " " + caption_of_errors(quality, rms);
  out.how_to_read +=
      " " + tr("Below, its error in per cent of the driving torque: the closer to zero over all "
               "speeds, the better the mass. Scatter as large as the distance between two "
               "candidates means that the runs cannot decide between them.");
  out.alt = alt_of_curves(calibration, runs) + " " + alt_of_errors(calibration) + rms;
  return out;
}

}  // namespace tribolog::figures
