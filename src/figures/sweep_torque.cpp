#include "figures/sweep_torque.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "figures/estimator_style.h"
#include "figures/report_figure.h"
#include "figures/sweep_traces.h"
#include "method/gravity/cog_sweep.h"
#include "render/figure/figure.h"
#include "wording/axis_scale.h"
#include "wording/labels.h"
#include "wording/number_text.h"
#include "wording/tr.h"

namespace tribolog::figures {

// The gravity peak on a torque curve: the largest torque (the paper's way) and the fitted vertex.

namespace {

using wording::tr;

constexpr double visible_share = 0.004;  // of the angle range: a narrower interval is not drawn

bool wide_enough(const method::gravity::CogSweepResult& sweep, double low, double high) {
  return high - low > visible_share * (sweep.highest_rad - sweep.lowest_rad);
}

/// The arg-max as a labelled point, with a bar over the angles that noise cannot tell from it.
void add_argmax(render::figure::Panel& panel, const method::gravity::CogSweepResult& sweep,
                const wording::AxisScale& torque) {
  const wording::AxisScale deg = wording::degrees();
  const double level = torque(sweep.argmax_torque_Nm);
  render::figure::Series interval =
      line(tr("interval of the largest T"), {deg(sweep.argmax_low_rad), deg(sweep.argmax_high_rad)},
           {level, level}, render::figure::palette::black, 2.5);
  interval.marker = render::figure::Marker::plus;
  if (wide_enough(sweep, sweep.argmax_low_rad, sweep.argmax_high_rad)) {
    add_visible(panel, std::move(interval));
  }
  add_visible(panel, render::figure::PointLabel{
                         deg(sweep.argmax_rad), level,
                         tr("largest T at {angle}",
                            {{"angle", wording::with_unit(sweep.argmax_rad, deg, 4)}}),
                         render::figure::palette::black, render::figure::Marker::diamond});
}

/// The fitted q_peak as a vertical line; its interval as a band where it is wide enough to see.
/// @param torques what the panel shows: the height of the band.
void add_peak(render::figure::Panel& panel, const method::gravity::CogSweepResult& sweep,
              const wording::Extent& torques, const wording::AxisScale& torque) {
  if (!std::isfinite(sweep.q_peak_rad.value)) return;
  const wording::AxisScale deg = wording::degrees();

  const statistics::Estimate& peak = sweep.q_peak_rad;
  if (wide_enough(sweep, peak.low, peak.high) && !torques.empty) {
    render::figure::Band band;
    band.label = tr("95 % interval of q_{{peak}}");
    band.x = {deg(peak.low), deg(peak.high)};
    band.low = {torque(torques.low), torque(torques.low)};
    band.high = {torque(torques.high), torque(torques.high)};
    band.colour = faded(peak_colour, 50);
    panel.bands.push_back(std::move(band));
  }
  panel.reference_lines.push_back({render::figure::ReferenceLine::Direction::vertical,
                                   deg(peak.value),
                                   "q_{peak} = " + wording::with_interval(peak, deg), peak_colour,
                                   render::figure::LineStyle::dash_dot});
}

/// "the largest torque, 4.77 N·m, stands at −22.2° (noise allows −22.9° to −21.6°)"
std::string argmax_words(const method::gravity::CogSweepResult& sweep) {
  const wording::AxisScale deg = wording::degrees();
  const std::string torque =
      wording::with_unit(sweep.argmax_torque_Nm, wording::AxisScale{1.0, "N·m"}, 4);
  const std::string angle = wording::with_unit(sweep.argmax_rad, deg, 4);
  if (!wide_enough(sweep, sweep.argmax_low_rad, sweep.argmax_high_rad)) {
    return sweep.argmax_at_end ? tr("the largest torque, {torque}, is at {angle}, the end of the "
                                    "sweep: no peak was crossed there",
                                    {{"torque", torque}, {"angle", angle}})
                               : tr("the largest torque, {torque}, is at {angle}",
                                    {{"torque", torque}, {"angle", angle}});
  }
  const std::string low = wording::with_unit(sweep.argmax_low_rad, deg, 4);
  const std::string high = wording::with_unit(sweep.argmax_high_rad, deg, 4);
  return sweep.argmax_at_end
             ? tr("the largest torque, {torque}, is at {angle} (noise allows {low} to {high}), the "
                  "end of the sweep: no peak was crossed there",
                  {{"torque", torque}, {"angle", angle}, {"low", low}, {"high", high}})
             : tr("the largest torque, {torque}, is at {angle} (noise allows {low} to {high})",
                  {{"torque", torque}, {"angle", angle}, {"low", low}, {"high", high}});
}

constexpr double dot_px = 7.0;  // wider than the fit, to be seen beside it in a clean log
constexpr double paleness = 0.6;

struct SweptDirection {
  Stroke stroke;
  const std::vector<double>& fit_q_rad;
  const std::vector<double>& fit_Nm;  // of another length where the direction was not recorded
  std::string label;
  std::string fit_label;
  render::figure::Colour colour;
  render::figure::LineStyle fit_style;
};

std::vector<SweptDirection> directions_of(const method::gravity::SweepCurves& sweep) {
  return {{Stroke::rising, sweep.fit_q_rad, sweep.fit_rising_Nm, tr("q rising"),
           tr("fit, q rising"), rising_colour, render::figure::LineStyle::solid},
          {Stroke::falling, sweep.fit_q_rad, sweep.fit_falling_Nm, tr("q falling"),
           tr("fit, q falling"), falling_colour, render::figure::LineStyle::dash}};
}

wording::Extent torques_of(const std::vector<SweepTrace>& samples,
                           const SweptDirection& direction) {
  wording::Extent extent =
      wording::extent_of(signal_of(samples, direction.stroke, &SweepTrace::torque_Nm));
  if (direction.fit_Nm.size() == direction.fit_q_rad.size()) extent.add(direction.fit_Nm);
  return extent;
}

void add_samples(render::figure::Panel& panel, const std::vector<SweepTrace>& sweeps,
                 const SweptDirection& direction, const wording::AxisScale& torque) {
  render::figure::Series samples =
      line(direction.label,
           shown(signal_of(sweeps, direction.stroke, &SweepTrace::q_rad), wording::degrees()),
           shown(signal_of(sweeps, direction.stroke, &SweepTrace::torque_Nm), torque),
           lightened(direction.colour, paleness), 1.0, render::figure::LineStyle::none);
  samples.marker = render::figure::Marker::circle;
  samples.marker_size_px = dot_px;
  add_visible(panel, std::move(samples));
}

constexpr std::size_t angle_bins = 40;
constexpr std::size_t fewest_in_bins = 10;  // of samples in a bin, on average
constexpr double label_room = 0.16;         // of the height of what is drawn, above it

/// The samples as means over bins of the angle, with bars of one standard deviation: quantised or
/// noisy ones would be a cloud. Few are drawn as they are.
void add_binned(render::figure::Panel& panel, const std::vector<SweepTrace>& sweeps,
                const SweptDirection& direction, const wording::AxisScale& torque) {
  const std::vector<double> q = signal_of(sweeps, direction.stroke, &SweepTrace::q_rad);
  const std::vector<double> t = signal_of(sweeps, direction.stroke, &SweepTrace::torque_Nm);
  const wording::Extent angles = wording::extent_of(q);
  if (q.size() < fewest_in_bins * angle_bins || !(angles.span() > 0.0)) {
    add_samples(panel, sweeps, direction, torque);
    return;
  }
  struct Bin {
    double count{};
    double angle{};
    double sum{};
    double squares{};
  };
  std::vector<Bin> bins(angle_bins);
  const double level = wording::extent_of(t).low;
  for (std::size_t i = 0; i < std::min(q.size(), t.size()); ++i) {
    if (!std::isfinite(q[i]) || !std::isfinite(t[i])) continue;
    const double at = (q[i] - angles.low) / angles.span() * static_cast<double>(angle_bins);
    Bin& bin = bins[std::min(static_cast<std::size_t>(at), angle_bins - 1)];
    const double above = t[i] - level;
    bin.count += 1.0;
    bin.angle += q[i];
    bin.sum += above;
    bin.squares += above * above;
  }
  render::figure::Series means =
      line(tr("{direction}: mean ± standard deviation", {{"direction", direction.label}}), {}, {},
           direction.colour, 1.0, render::figure::LineStyle::none);
  means.marker = render::figure::Marker::circle;
  means.marker_size_px = 10.0;
  for (const Bin& bin : bins) {
    if (!(bin.count > 1.0)) continue;
    const double mean = bin.sum / bin.count;
    const double spread = std::sqrt(std::max(0.0, bin.squares / bin.count - mean * mean));
    const double x = wording::degrees()(bin.angle / bin.count);
    means.x.push_back(x);
    means.y.push_back(torque(level + mean));
    panel.error_bars.push_back({x, torque(level + mean - spread), torque(level + mean + spread),
                                lightened(direction.colour, 0.35)});
  }
  add_visible(panel, std::move(means));
}

void add_fit(render::figure::Panel& panel, const SweptDirection& direction,
             const wording::AxisScale& torque) {
  if (direction.fit_Nm.size() != direction.fit_q_rad.size()) return;
  add_visible(panel,
              line(direction.fit_label, shown(direction.fit_q_rad, wording::degrees()),
                   shown(direction.fit_Nm, torque), direction.colour, 3.5, direction.fit_style));
}

/// Room above all that the panel shows, for the names of the peak.
void leave_room_for_labels(render::figure::Panel& panel) {
  wording::Extent heights;
  for (const render::figure::Series& one : panel.series) heights.add(one.y);
  for (const render::figure::ErrorBar& one : panel.error_bars) heights.add({one.low, one.high});
  for (const render::figure::PointLabel& one : panel.point_labels) heights.add(one.y);
  if (heights.span() > 0.0) panel.y.maximum = heights.high + label_room * heights.span();
}

/// What a panel shows of a torque: the height of its band.
wording::Extent heights_of(const render::figure::Panel& panel, const wording::AxisScale& torque) {
  wording::Extent heights;
  const auto add = [&](double y) { heights.add(y / torque.factor + torque.offset); };
  for (const render::figure::Series& one : panel.series) {
    for (const double y : one.y) add(y);
  }
  for (const render::figure::ErrorBar& one : panel.error_bars) {
    add(one.low);
    add(one.high);
  }
  return heights;
}

/// How far the fitted curve is from the arg-max; shows in which direction it was found in.
double distance_to_argmax(const method::gravity::CogSweepResult& sweep,
                          const SweptDirection& direction) {
  double nearest = std::numeric_limits<double>::infinity();
  double distance = nearest;
  for (std::size_t i = 0; i < direction.fit_q_rad.size() && i < direction.fit_Nm.size(); ++i) {
    const double along = std::abs(direction.fit_q_rad[i] - sweep.argmax_rad);
    if (!(along < nearest)) continue;
    nearest = along;
    distance = std::abs(direction.fit_Nm[i] - sweep.argmax_torque_Nm);
  }
  return distance;
}

std::string peak_words(const method::gravity::CogSweepResult& sweep) {
  return wording::with_interval(sweep.q_peak_rad, wording::degrees());
}

/// A sentence with a space before it; empty for a sweep in one direction.
std::string friction_words(const method::gravity::CogSweepResult& sweep) {
  if (!sweep.coulomb_Nm) return {};
  const std::string friction =
      wording::with_interval(*sweep.coulomb_Nm, wording::prefixed("N·m", sweep.coulomb_Nm->value));
  return " " + tr("Half the distance between the directions is {friction} of friction.",
                  {{"friction", friction}});
}

std::string rough_caption(const method::gravity::CogSweepResult& sweep, bool at_motor) {
  const std::string peak = peak_words(sweep);
  const std::string gravity =
      wording::with_interval(sweep.gravity_Nm, wording::prefixed("N·m", sweep.gravity_Nm.value));
  const std::string largest = argmax_words(sweep);
  const std::string caption =
      at_motor ? tr("Rough sweep: least squares puts the gravity peak at {q_peak}, with a gravity "
                    "torque of {gravity} at the motor; {largest_torque}.",
                    {{"q_peak", peak}, {"gravity", gravity}, {"largest_torque", largest}})
               : tr("Rough sweep: least squares puts the gravity peak at {q_peak}, with a gravity "
                    "torque of {gravity} at the joint; {largest_torque}.",
                    {{"q_peak", peak}, {"gravity", gravity}, {"largest_torque", largest}});
  return caption + friction_words(sweep);
}

std::string precise_caption(const method::gravity::CogSweepResult& sweep) {
  return tr("Precise sweep: least squares puts the gravity peak at {q_peak}; {largest_torque}.",
            {{"q_peak", peak_words(sweep)}, {"largest_torque", argmax_words(sweep)}}) +
         friction_words(sweep);
}

std::string alt_of(const method::gravity::CogSweepResult& sweep) {
  return tr(
      "Driving torque against joint angle, {low} to {high}: gravity peak at {q_peak}, "
      "{largest_torque}.",
      {{"low", wording::with_unit(sweep.lowest_rad, wording::degrees(), 3)},
       {"high", wording::with_unit(sweep.highest_rad, wording::degrees(), 3)},
       {"q_peak", peak_words(sweep)},
       {"largest_torque", argmax_words(sweep)}});
}

}  // namespace

std::optional<ReportFigure> rough_torque_figure(const joint::Dataset& dataset,
                                                const calibration::Calibration& calibration) {
  const method::gravity::CogSweepResult& sweep = calibration.rough;
  if (!sweep.found) return std::nullopt;
  const auto samples = sweep_traces(calibration.curves.rough, dataset, joint::Role::rough_sweep);
  const auto directions = directions_of(calibration.curves.rough);
  wording::Extent torques;
  for (const SweptDirection& direction : directions) {
    const wording::Extent one = torques_of(samples, direction);
    if (!one.empty) torques.add({one.low, one.high});
  }
  const wording::AxisScale torque = wording::levelled("N·m", torques);

  ReportFigure out;
  out.paper_number = 13;
  out.id = "fig-13-rough-torque";
  out.title = tr("Rough sweep: driving torque against angle");
  out.stage = "cog_rough";
  out.is_primary = true;
  render::figure::Panel panel;
  panel.x.title = wording::axis_title(tr("joint angle q"), wording::degrees());
  panel.y.title = wording::axis_title(tr("driving torque T"), torque, "N·m");
  for (const SweptDirection& direction : directions) {
    add_samples(panel, samples, direction, torque);
    add_fit(panel, direction, torque);
  }
  add_peak(panel, sweep, torques, torque);
  add_argmax(panel, sweep, torque);
  leave_room_for_labels(panel);
  if (panel.series.empty()) return std::nullopt;
  out.figure.panels.push_back(std::move(panel));
  out.caption = rough_caption(sweep, wording::has_motor_side(dataset.manifest));
  out.alt = alt_of(sweep);
  out.how_to_read =
      tr("The two directions should be the same cosine, one friction torque above and below "
         "gravity, and the fit should run through the middle of the samples everywhere. A fit that "
         "departs from the samples at the ends, or directions that converge along the stroke, mean "
         "friction that depends on load or angle, or a payload that moved.");
  return out;
}

std::optional<ReportFigure> precise_torque_figure(const joint::Dataset& dataset,
                                                  const calibration::Calibration& calibration) {
  const method::gravity::CogSweepResult& sweep = calibration.precise;
  if (!sweep.found) return std::nullopt;
  const auto samples =
      sweep_traces(calibration.curves.precise, dataset, joint::Role::precise_sweep);
  const auto directions = directions_of(calibration.curves.precise);
  const bool falling_has_it =
      distance_to_argmax(sweep, directions[1]) < distance_to_argmax(sweep, directions[0]);

  ReportFigure out;
  out.paper_number = 14;
  out.id = "fig-14-precise-torque";
  out.title = tr("Precise sweep: driving torque near its maximum");
  out.stage = "cog_precise";
  out.is_primary = true;
  for (const SweptDirection& direction : directions) {
    const wording::Extent torques = torques_of(samples, direction);
    const wording::AxisScale torque = wording::levelled("N·m", torques);
    render::figure::Panel panel;
    panel.x.title = wording::axis_title(tr("joint angle q"), wording::degrees());
    panel.y.title = wording::axis_title(tr("driving torque T"), torque, "N·m");
    add_binned(panel, samples, direction, torque);
    add_fit(panel, direction, torque);
    if (panel.series.empty()) continue;
    add_peak(panel, sweep, heights_of(panel, torque), torque);
    if ((direction.stroke == Stroke::falling) == falling_has_it) add_argmax(panel, sweep, torque);
    leave_room_for_labels(panel);
    out.figure.panels.push_back(std::move(panel));
  }
  if (out.figure.panels.empty()) return std::nullopt;
  out.figure.panels_share_x = true;
  if (out.figure.panels.size() > 1) out.figure.height_px = 1200;
  out.caption = precise_caption(sweep);
  out.alt = alt_of(sweep);
  out.how_to_read =
      tr("Near its peak the torque is flat: one degree away it is only 0.015 % lower. Trust the "
         "fitted peak and the width of its interval, not the single highest sample; if the black "
         "bar is about as wide as the sweep, the log cannot locate the peak. Dots are means of "
         "neighbouring samples, bars the standard deviation of these.");
  return out;
}

}  // namespace tribolog::figures
