#include "figures/torque_choice.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/requirements.h"
#include "calibration/calibration.h"
#include "figures/estimator_style.h"
#include "figures/loop_panels.h"
#include "figures/report_figure.h"
#include "wording/axis_scale.h"
#include "wording/number_text.h"
#include "wording/tr.h"

namespace tribolog::figures {

// The point that the paper's rule chose on the loop, beside the mid-line: data and words.

namespace {

using method::hysteresis::Estimator;
using wording::tr;

/// Pointers into the calibration, null where there is none; must not outlive it.
struct Choice {
  const method::hysteresis::LoopPoint* chosen{};  ///< The paper's, in the first strokes.
  const method::hysteresis::LoopPoint* other{};   ///< Its opposite there.
  const method::hysteresis::LoopPoint* chosen_steady{};
  const method::hysteresis::LoopPoint* other_steady{};
  const statistics::Estimate* midline{};
};

constexpr double worth_saying = 0.01;  // of the shift: a peak known better needs no word

const method::hysteresis::LoopPoint* find(const std::vector<method::hysteresis::LoopPoint>& points,
                                          Estimator name) {
  for (const method::hysteresis::LoopPoint& point : points) {
    if (point.name == name) return &point;
  }
  return nullptr;
}

std::string mass_words(const calibration::Calibration& calibration, Estimator estimator) {
  const method::hysteresis::SurrogateMass* mass = calibration.masses.find(estimator);
  if (mass == nullptr) return {};
  return " (" + wording::with_interval(mass->mass_kg, wording::AxisScale{1.0, "kg"}) + ")";
}

Choice choice_of(const calibration::Calibration& calibration) {
  const method::hysteresis::HysteresisResult& loop = calibration.hysteresis;
  Choice choice;
  if (const std::optional<Estimator> name = calibration.selection.paper_rule) {
    const Estimator opposite = method::hysteresis::opposite_point(*name);
    choice.chosen = find(loop.points, *name);
    choice.other = find(loop.points, opposite);
    choice.chosen_steady = find(loop.steady_points, *name);
    choice.other_steady = find(loop.steady_points, opposite);
  }
  if (loop.midline_Nm) choice.midline = &*loop.midline_Nm;
  return choice;
}

/// What the caption and the alternative text say; empty where there is no such reading.
struct ChoiceWords {
  std::string torque;   ///< "3.866 N·m", by the paper's rule.
  std::string point;    ///< "B (78.81 kg)"
  std::string midline;  ///< "3.874 ± 0.004 N·m (79.01 kg)"
};

ChoiceWords choice_words(const calibration::Calibration& calibration, const Choice& choice,
                         const wording::AxisScale& torque) {
  ChoiceWords words;
  if (choice.chosen != nullptr) {
    const Estimator name = choice.chosen->name;
    words.torque = wording::with_unit(choice.chosen->torque_Nm, torque, 4);
    words.point = to_string(name) + mass_words(calibration, name);
  }
  if (choice.midline != nullptr) {
    words.midline = wording::with_interval(*choice.midline, torque) +
                    mass_words(calibration, Estimator::midline);
  }
  return words;
}

std::string caption_of(const ChoiceWords& choice) {
  if (choice.midline.empty()) {
    return tr("On the loop the paper's rule reads {torque} at {point}.",
              {{"torque", choice.torque}, {"point", choice.point}});
  }
  if (choice.torque.empty()) {
    return tr("On the loop the mean of the mid-line is {midline}.", {{"midline", choice.midline}});
  }
  return tr(
      "On the loop the paper's rule reads {torque} at {point}; the mean of the mid-line is "
      "{midline}.",
      {{"torque", choice.torque}, {"point", choice.point}, {"midline", choice.midline}});
}

std::string alt_of(const ChoiceWords& choice) {
  if (choice.midline.empty()) {
    return tr(
        "Hysteresis loop with the choice of torque: the paper's rule reads {torque} at {point}.",
        {{"torque", choice.torque}, {"point", choice.point}});
  }
  if (choice.torque.empty()) {
    return tr("Hysteresis loop with the choice of torque: the mean of the mid-line is {midline}.",
              {{"midline", choice.midline}});
  }
  return tr(
      "Hysteresis loop with the choice of torque: the paper's rule reads {torque} at {point}; the "
      "mean of the mid-line is {midline}.",
      {{"torque", choice.torque}, {"point", choice.point}, {"midline", choice.midline}});
}

/// Eq. (14) in a sentence with a space before it, and the uncertainty of the peak itself. Empty
/// without a chosen point or a peak.
std::string shift_words(const calibration::Calibration& calibration, const Choice& choice) {
  if (choice.chosen == nullptr || !calibration.q_peak_rad) return {};
  const statistics::Estimate& peak = *calibration.q_peak_rad;
  const double shift = choice.chosen->q_rad - peak.value;
  const double half = peak.half_width();
  if (!std::isfinite(shift)) return {};
  const wording::AxisScale scale = wording::prefixed("rad", shift);
  const std::string angle = wording::with_unit(shift, scale, 3);
  if (!(half > worth_saying * std::abs(shift)) || !std::isfinite(half)) {
    return " " + tr("Eq. (14) shifts the angle by {angle}.", {{"angle", angle}});
  }
  const std::string half_width = wording::with_unit(half, scale, 2);
  return " " + (half > std::abs(shift)
                    ? tr("Eq. (14) shifts the angle by {angle}, but the peak itself is only known "
                         "to ± {half_width}.",
                         {{"angle", angle}, {"half_width", half_width}})
                    : tr("Eq. (14) shifts the angle by {angle}; the peak itself is known to ± "
                         "{half_width}.",
                         {{"angle", angle}, {"half_width", half_width}}));
}

constexpr double zoom = 1.7;           // of the farthest reading's distance from the mid-line
constexpr double same_share = 0.08;    // of the close-up's reach: one reading, not two
constexpr double side_room = 0.14;     // of the loop's width
constexpr double dimension_at = 0.22;  // of the loop's height, above its lowest torque

/// Whether two readings of a point would lie on each other in the close-up.
bool coincide(const method::hysteresis::LoopPoint* first,
              const method::hysteresis::LoopPoint* steady, double same_Nm) {
  return first != nullptr && steady != nullptr &&
         std::abs(first->torque_Nm - steady->torque_Nm) <= same_Nm;
}

void add_loop(render::figure::Panel& panel, const calibration::Calibration& calibration,
              const LoopView& view, const wording::AxisScale& torque, bool legend) {
  const method::hysteresis::LoopTrace& trace = *view.trace;
  const bool model = view.model_torque_Nm != nullptr &&
                     !calibration.hysteresis.bristle_source.is("loop.bristle_recorded");
  const auto& strokes = model ? *view.model_torque_Nm : trace.torque_Nm;
  add_visible(panel, line(legend ? tr("measured") : "", shown(trace.q_rad, view.angle),
                          shown(trace.torque_Nm, torque), cloud, cloud_px));
  render::figure::Series first =
      line(legend ? (model ? tr("first strokes, LuGre fit") : tr("first strokes")) : "",
           shown(view.until(view.first_strokes_end_s, trace.q_rad), view.angle),
           shown(view.until(view.first_strokes_end_s, strokes), torque),
           render::figure::palette::blue, strokes_px);
  first.direction_arrows_at = {0.1, 0.3, 0.5, 0.7, 0.95};
  add_visible(panel, std::move(first));
  add_visible(panel, line(legend ? tr("mid-line of the steady loop") : "",
                          shown(trace.midline_q_rad, view.angle), shown(trace.midline_Nm, torque),
                          render::figure::palette::black, 3.0, render::figure::LineStyle::dash));
}

/// A dimension line with an arrow head at each end.
/// @param width of the loop: of an arrow that is short against it the text stands at the end `to`,
/// which lies inside.
void add_dimension(render::figure::Panel& panel, double from, double to, double level, double width,
                   render::figure::Colour colour, const std::string& text) {
  const double middle = (from + to) / 2;
  for (const double end : {from, to}) {
    render::figure::Series half = line("", {middle, end}, {level, level}, colour, 2.5);
    half.direction_arrows_at = {1.0};
    add_visible(panel, std::move(half));
  }
  constexpr double long_share = 0.4;  // about as long as the text
  const double at = std::abs(to - from) < long_share * width ? to : middle;
  add_visible(panel, render::figure::PointLabel{at, level, text, render::figure::palette::black,
                                                render::figure::Marker::none});
}

void add_reading(render::figure::Panel& panel, const method::hysteresis::LoopPoint* point,
                 bool is_steady, const LoopView& view, const wording::AxisScale& torque) {
  if (point == nullptr) return;
  const std::string name = to_string(point->name);
  const SeriesStyle style = estimator_style(point->name);
  const double x = view.angle(point->q_rad);
  if (point->torque_high_Nm > point->torque_low_Nm && std::isfinite(x)) {
    panel.error_bars.push_back(
        {x, torque(point->torque_low_Nm), torque(point->torque_high_Nm), style.colour});
  }
  const std::string read = wording::with_unit(point->torque_Nm, torque, 4);
  add_visible(panel, render::figure::PointLabel{x, torque(point->torque_Nm),
                                                is_steady ? tr("{point} steady: {torque}",
                                                               {{"point", name}, {"torque", read}})
                                                          : name + ": " + read,
                                                render::figure::palette::black, style.marker});
}

/// Left and right of the loop, for the names of its points: the axis of both panels.
void leave_room_at_sides(render::figure::Panel& panel) {
  wording::Extent angles;
  for (const render::figure::Series& one : panel.series) angles.add(one.x);
  for (const render::figure::ReferenceLine& one : panel.reference_lines) {
    if (one.direction == render::figure::ReferenceLine::Direction::vertical) angles.add(one.at);
  }
  if (!(angles.span() > 0.0)) return;
  panel.x.minimum = angles.low - side_room * angles.span();
  panel.x.maximum = angles.high + side_room * angles.span();
}

render::figure::Panel whole_loop(const calibration::Calibration& calibration, LoopView view,
                                 const Choice& choice, const wording::AxisScale& torque) {
  render::figure::Panel panel;
  add_loop(panel, calibration, view, torque, true);
  const bool at_peak = add_gravity_peak(panel, calibration, view);
  panel.x.title =
      wording::axis_title(at_peak ? tr("joint angle from the gravity peak q − q_{{peak}}")
                                  : tr("joint angle from the loop's centre q − q_{{0}}"),
                          wording::AxisScale{view.angle.factor, view.angle.unit});
  panel.y.title = wording::axis_title(tr("driving torque T"), torque);
  leave_room_at_sides(panel);
  if (choice.chosen == nullptr) return panel;
  const std::string name = to_string(choice.chosen->name);
  const SeriesStyle style = estimator_style(choice.chosen->name);
  const double x = view.angle(choice.chosen->q_rad);
  add_visible(panel,
              render::figure::PointLabel{x, torque(choice.chosen->torque_Nm),
                                         tr("{point}, the paper's choice", {{"point", name}}),
                                         render::figure::palette::black, style.marker});
  if (!at_peak || !std::isfinite(x)) return panel;
  const double peak = view.angle(present(calibration.q_peak_rad).value);
  panel.reference_lines.push_back({render::figure::ReferenceLine::Direction::vertical, x,
                                   "q_{" + name + "}", style.colour,
                                   render::figure::LineStyle::dot});
  const wording::Extent torques = wording::extent_of(view.trace->torque_Nm);
  add_dimension(panel, peak, x, torque(torques.low + dimension_at * torques.span()),
                view.angle.factor * wording::extent_of(view.trace->q_rad).span(), style.colour,
                tr("eq. (14): {angle} = {shift}",
                   {{"angle", "q_{" + name + "} − q_{peak}"},
                    {"shift", wording::significant(x - peak, 3) + " " + view.angle.unit}}));
  return panel;
}

render::figure::Panel around_midline(const calibration::Calibration& calibration,
                                     const LoopView& view, const Choice& choice,
                                     const wording::AxisScale& torque) {
  render::figure::Panel panel;
  panel.title = tr("Close-up around the mid-line");
  panel.show_legend = false;
  panel.x.title = wording::axis_title(tr("joint angle from the loop's centre q − q_{{0}}"),
                                      wording::AxisScale{view.angle.factor, view.angle.unit});
  panel.y.title = wording::axis_title(tr("driving torque T"), torque);
  const double middle = choice.midline->value;
  wording::Extent distances;
  distances.add(choice.midline->half_width());
  for (const method::hysteresis::LoopPoint* point :
       {choice.chosen, choice.other, choice.chosen_steady, choice.other_steady}) {
    if (point != nullptr) distances.add(point->torque_Nm - middle);
  }
  const double reach = zoom * distances.largest();
  if (reach > 0.0 && std::isfinite(middle)) {
    panel.y.minimum = torque(middle - reach);
    panel.y.maximum = torque(middle + reach);
  }
  const wording::Extent angles = wording::extent_of(shown(view.trace->q_rad, view.angle));
  if (choice.midline->half_width() > 0.0 && !angles.empty) {
    panel.bands.push_back({"",
                           {angles.low, angles.high},
                           {torque(choice.midline->low), torque(choice.midline->low)},
                           {torque(choice.midline->high), torque(choice.midline->high)},
                           faded(peak_colour, 60)});
  }
  add_loop(panel, calibration, view, torque, false);
  panel.reference_lines.push_back(
      {render::figure::ReferenceLine::Direction::horizontal, torque(middle),
       tr("mean of the mid-line {torque}", {{"torque", wording::rounded(*choice.midline, torque)}}),
       peak_colour, render::figure::LineStyle::dash});
  add_reading(panel, choice.chosen, false, view, torque);
  add_reading(panel, choice.other, false, view, torque);
  const double same_Nm = same_share * reach;
  if (!coincide(choice.chosen, choice.chosen_steady, same_Nm)) {
    add_reading(panel, choice.chosen_steady, true, view, torque);
  }
  if (!coincide(choice.other, choice.other_steady, same_Nm)) {
    add_reading(panel, choice.other_steady, true, view, torque);
  }

  return panel;
}

}  // namespace

std::optional<ReportFigure> torque_choice_figure(const calibration::Calibration& calibration) {
  auto view = loop_view(calibration);
  const Choice choice = choice_of(calibration);
  if (!view || (choice.chosen == nullptr && choice.midline == nullptr)) return std::nullopt;
  const wording::AxisScale torque =
      wording::prefixed("N·m", wording::extent_of(view->trace->torque_Nm).largest());

  ReportFigure out;
  out.paper_number = 22;
  out.id = "fig-22-torque-choice";
  out.title = tr("Choice of torque and angle on the loop");
  out.stage = "selection";
  render::figure::Panel probe;
  if (add_gravity_peak(probe, calibration, *view)) {
    view->angle.offset = present(calibration.q_peak_rad).value;
  }
  out.figure.panels.push_back(whole_loop(calibration, *view, choice, torque));
  if (choice.midline != nullptr && std::isfinite(choice.midline->value)) {
    render::figure::Panel near = around_midline(calibration, *view, choice, torque);
    near.x = out.figure.panels.front().x;
    out.figure.panels.push_back(std::move(near));
    out.figure.panels_share_x = true;
    out.figure.height_px = 1500;
  }
  if (out.figure.panels.front().series.empty()) return std::nullopt;
  const ChoiceWords words = choice_words(calibration, choice, torque);
  const std::string shift = shift_words(calibration, choice);
  out.caption = caption_of(words) + shift;
  out.how_to_read =
      tr("In the steady loop opposite points lie equally far above and below gravity, so that "
         "friction drops out of their mean, and of the mean of the mid-line; it does not drop out "
         "of the mid-line point by point, nor of a single reading. Do not trust a choice that lies "
         "outside the interval of that mean.");
  out.alt = alt_of(words) + shift;
  return out;
}

}  // namespace tribolog::figures
