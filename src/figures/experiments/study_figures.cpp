#include "figures/experiments/study_figures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "figures/estimator_style.h"
#include "figures/report_figure.h"
#include "joint/degrees.h"
#include "wording/labels.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::figures::experiments {
namespace {

namespace colour = render::figure::palette;
using render::figure::LineStyle;
using render::figure::Marker;
using truth::ReadingName;
using wording::tr;
using wording::tr_count;

constexpr int panel_height_px = 560;
constexpr render::figure::Colour colour_of_promise{0, 158, 115, 60};

SeriesStyle style_of(ReadingName reading) {
  switch (reading) {
    case ReadingName::A_steady:
      return {colour::sky_blue, LineStyle::dot, Marker::circle, 2.5, 9.0};
    case ReadingName::B_steady:
      return {colour::vermilion, LineStyle::dot, Marker::diamond, 2.5, 11.0};
    case ReadingName::fit:
      return {colour::purple, LineStyle::dash_dot, Marker::cross, 2.5, 12.0};
    case ReadingName::bristle_stiffness:
      return {colour::blue, LineStyle::solid, Marker::circle, 2.5, 10.0};
    case ReadingName::static_torque:
      return {colour::vermilion, LineStyle::dash, Marker::square, 2.5, 10.0};
    case ReadingName::sweep_friction:
      return {colour::grey, LineStyle::dot, Marker::plus, 2.5, 12.0};
    case ReadingName::coulomb:
      return {colour::green, LineStyle::dash_dot, Marker::triangle, 2.5, 11.0};
    case ReadingName::viscous:
      return {colour::orange, LineStyle::dash_dot_dot, Marker::diamond, 2.5, 11.0};
    case ReadingName::q_peak:
      return {colour::black, LineStyle::solid, Marker::circle, 2.5, 10.0};
    default:
      break;
  }
  const auto estimator = calibration::estimator_of(reading);
  return estimator ? estimator_style(*estimator)
                   : SeriesStyle{colour::grey, LineStyle::dot, Marker::none, 2.5};
}

/// A number of an estimator's errors, as the axis shows it.
using Shown = std::function<double(const study::ErrorStatistics&)>;

double bias_percent(const study::ErrorStatistics& e) { return 100 * e.bias / std::abs(e.truth); }
double scatter_percent(const study::ErrorStatistics& e) {
  return 100 * e.scatter / std::abs(e.truth);
}
double coverage_percent(const study::ErrorStatistics& e) {
  return e.all_alike() ? std::nan("") : 100 * e.coverage.value;
}
double bias_millidegree(const study::ErrorStatistics& e) {
  return 1e3 * e.bias * joint::degrees_per_rad;
}

std::string title_of(const study::StudyFactor& factor) {
  return wording::words_for("factor", factor.key);
}

std::string axis_of(const study::StudyFactor& factor) {
  return wording::words_for("factor_axis", factor.key);
}

render::figure::Panel panel_of(const study::StudyResult& study, const study::StudyFactor& factor,
                               const std::vector<ReadingName>& readings, const std::string& y_title,
                               const Shown& shown) {
  render::figure::Panel panel;
  panel.x.title = axis_of(factor);
  panel.x.logarithmic = factor.logarithmic;
  panel.y.title = y_title;
  for (const ReadingName reading : readings) {
    render::figure::Series series;
    series.label = wording::reading_label(to_string(reading));
    for (const study::StudyLevel& level : factor.levels) {
      const study::StudiedReading* r = study.case_of(level).find(reading);
      if (r == nullptr) continue;  // not found at this level: the table says so
      const double y = shown(r->errors);
      if (!std::isfinite(y)) continue;
      series.x.push_back(level.value);
      series.y.push_back(y);
    }
    apply(style_of(reading), series);
    // Marks of one size class: no curve may hide the others.
    series.width_px = 2.5;
    series.marker_size_px = std::min(series.marker_size_px, 12.0);
    add_visible(panel, std::move(series));
  }
  return panel;
}

void add_line(render::figure::Panel& panel, double at, const std::string& text) {
  render::figure::ReferenceLine line;
  line.direction = render::figure::ReferenceLine::Direction::horizontal;
  line.at = at;
  line.text = text;
  panel.reference_lines.push_back(std::move(line));
}

render::figure::Panel coverage_panel(const study::StudyResult& study,
                                     const study::StudyFactor& factor,
                                     const std::vector<ReadingName>& readings) {
  render::figure::Panel panel = panel_of(
      study, factor, readings, tr("intervals that contain the true value [%]"), coverage_percent);
  panel.y.minimum = -4;
  panel.y.maximum = 104;
  const double first = factor.levels.front().value;
  const double last = factor.levels.back().value;
  panel.bands.push_back({tr("91 to 99 %"), {first, last}, {91, 91}, {99, 99}, colour_of_promise});
  panel.show_legend = false;
  return panel;
}

void add_panel(render::figure::Panel panel, ReportFigure& out) {
  if (!panel.series.empty()) out.figure.panels.push_back(std::move(panel));
}

ReportFigure empty_figure(const study::StudyFactor& factor, const char* kind,
                          const std::string& title) {
  ReportFigure out;
  out.id = fmt::format("study-{}-{}", kind, factor.key);
  std::replace(out.id.begin(), out.id.end(), '_', '-');
  out.title = title;
  out.stage = factor.key;
  return out;
}

std::optional<ReportFigure> finished(ReportFigure out) {
  if (out.figure.panels.empty()) return std::nullopt;
  out.figure.id = out.id;
  out.figure.title = out.title;
  out.figure.panels_share_x = true;
  out.figure.height_px =
      140 + panel_height_px * static_cast<int>(std::max<std::size_t>(1, out.figure.panels.size()));
  return out;
}

/// "point B −0.61 to −0.59 %": the range of a reading's bias over the levels.
std::string bias_range(const study::StudyResult& study, const study::StudyFactor& factor,
                       ReadingName reading) {
  wording::Extent extent;
  for (const study::StudyLevel& level : factor.levels) {
    const study::StudiedReading* r = study.case_of(level).find(reading);
    if (r != nullptr) extent.add(bias_percent(r->errors));
  }
  if (extent.empty) return {};
  return tr("{estimator} {lowest_percent:+.3f} to {highest_percent:+.3f} %",
            {{"estimator", wording::words_for("reading", to_string(reading))},
             {"lowest_percent", extent.low},
             {"highest_percent", extent.high}});
}

std::string bias_words(const study::StudyResult& study, const study::StudyFactor& factor,
                       const std::vector<ReadingName>& readings) {
  std::string words;
  for (const ReadingName reading : readings) {
    const std::string range = bias_range(study, factor, reading);
    if (!range.empty()) words += (words.empty() ? "" : ", ") + range;
  }
  return words.empty() ? tr("no estimator was found at any level") : words;
}

std::optional<ReportFigure> gravity_figure(const study::StudyResult& study,
                                           const study::StudyFactor& factor) {
  using enum ReadingName;
  const std::vector<ReadingName> readings_of_points{A, B, A_steady, B_steady, midline};
  const std::vector<ReadingName> averages{AB, CD, EF, model, fit, midline};
  std::vector<ReadingName> all{A, B, A_steady, B_steady};
  all.insert(all.end(), averages.begin(), averages.end());
  ReportFigure out = empty_figure(factor, "gravity",
                                  tr("{factor}: gravity torque", {{"factor", title_of(factor)}}));
  render::figure::Panel points =
      panel_of(study, factor, readings_of_points, tr("bias [%]"), bias_percent);
  points.title = tr("single points and the mid-line");
  add_line(points, 0, "");
  add_panel(std::move(points), out);
  render::figure::Panel means = panel_of(study, factor, averages, tr("bias [%]"), bias_percent);
  means.title = tr("estimators that average");
  add_line(means, 0, "");
  add_panel(std::move(means), out);
  render::figure::Panel scatter =
      panel_of(study, factor, all, tr("standard deviation [%]"), scatter_percent);
  scatter.title = tr("scatter from run to run");
  scatter.show_legend = false;
  add_panel(std::move(scatter), out);
  render::figure::Panel coverage = coverage_panel(study, factor, all);
  coverage.title = tr("coverage of the stated 95 % intervals");
  add_panel(std::move(coverage), out);
  out.caption = tr_count(
      static_cast<std::int64_t>(study.options.runs),
      "Errors of the gravity torque in % of the true value, {runs} run per level. Bias: {biases}",
      "Errors of the gravity torque in % of the true value, {runs} runs per level. Bias: {biases}",
      {{"runs", study.options.runs},
       {"biases", bias_words(study, factor, {A, B, midline, fit, model})}});
  out.how_to_read =
      tr("A curve on the zero line is free of bias. A and B lie off it whatever the factor; in the "
         "steady loop they lie symmetrically, so that their mean, the other pair means and the "
         "mid-line lie on it. The coverage of an interval is as stated within the green band of "
         "the lowest panel, 91 to 99 %; below it the interval is too narrow.");
  out.alt = tr(
      "Bias, scatter and coverage of the gravity torque against {factor_axis}: {biases}.",
      {{"factor_axis", axis_of(factor)}, {"biases", bias_words(study, factor, {A, B, midline})}});
  return finished(std::move(out));
}

std::optional<ReportFigure> friction_figure(const study::StudyResult& study,
                                            const study::StudyFactor& factor) {
  const std::vector<ReadingName> parameters{ReadingName::bristle_stiffness,
                                            ReadingName::static_torque, ReadingName::sweep_friction,
                                            ReadingName::coulomb, ReadingName::viscous};
  std::vector<ReadingName> all = parameters;
  all.push_back(ReadingName::q_peak);
  ReportFigure out =
      empty_figure(factor, "friction",
                   tr("{factor}: angle and friction parameters", {{"factor", title_of(factor)}}));
  render::figure::Panel bias = panel_of(study, factor, parameters, tr("bias [%]"), bias_percent);
  add_line(bias, 0, "");
  add_panel(std::move(bias), out);
  render::figure::Panel scatter =
      panel_of(study, factor, parameters, tr("standard deviation [%]"), scatter_percent);
  scatter.show_legend = false;
  add_panel(std::move(scatter), out);
  render::figure::Panel angle = panel_of(study, factor, {ReadingName::q_peak},
                                         tr("bias of q_{{peak}} [10^{{−3}} °]"), bias_millidegree);
  add_line(angle, 0, "");
  angle.show_legend = false;
  add_panel(std::move(angle), out);
  render::figure::Panel coverage = coverage_panel(study, factor, all);
  coverage.show_legend = true;
  add_panel(std::move(coverage), out);
  const std::string biases = bias_words(study, factor, parameters);
  out.caption = tr_count(static_cast<std::int64_t>(study.options.runs),
                         "Errors of the angle of the gravity peak and of the friction parameters, "
                         "{runs} run per level. Bias: {biases}",
                         "Errors of the angle of the gravity peak and of the friction parameters, "
                         "{runs} runs per level. Bias: {biases}",
                         {{"runs", study.options.runs}, {"biases", biases}});
  out.how_to_read =
      tr("As above. Coulomb torque and viscous coefficient are those of the straight line that the "
         "same motions give without noise; where there are no runs at constant speed, they are "
         "absent.");
  out.alt =
      tr("Bias, scatter and coverage of angle and friction parameters against {factor_axis}: "
         "{biases}.",
         {{"factor_axis", axis_of(factor)}, {"biases", biases}});
  return finished(std::move(out));
}

}  // namespace

std::vector<ReportFigure> study_figures(const study::StudyResult& study) {
  std::vector<ReportFigure> out;
  for (const study::StudyFactor& factor : study.factors) {
    for (auto* const make : {gravity_figure, friction_figure}) {
      if (auto figure = make(study, factor)) out.push_back(std::move(*figure));
    }
  }
  return out;
}

}  // namespace tribolog::figures::experiments
