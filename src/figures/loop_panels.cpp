#include "figures/loop_panels.h"

#include <utility>

#include "figures/plot_data.h"

namespace tribolog::figures {
namespace {

constexpr int two_panels_px = 1500;

render::Panel over_angle(const Calibration& calibration, const LoopView& view,
                         const LoopCurves& curves) {
  render::Panel panel;
  panel.x.title = axis_title("joint angle from the loop's centre q − q_{0}",
                             AxisScale{view.angle.factor, view.angle.unit});
  panel.y.title = axis_title(curves.title, curves.scale);
  if (curves.all != nullptr) {
    add_visible(panel, line(curves.all_label, shown(view.trace->q_rad, view.angle),
                            shown(*curves.all, curves.scale), cloud, cloud_px));
  }
  render::Series strokes =
      line(curves.strokes_label,
           shown(view.until(view.first_strokes_end_s, view.trace->q_rad), view.angle),
           shown(view.until(view.first_strokes_end_s, *curves.strokes), curves.scale),
           render::palette::blue, strokes_px);
  strokes.direction_arrows_at = {0.1, 0.3, 0.5, 0.7, 0.95};
  add_visible(panel, std::move(strokes));
  add_gravity_peak(panel, calibration, view);
  add_loop_points(panel, calibration.hysteresis.points, curves.signal, false, view, curves.scale);
  return panel;
}

render::Panel over_time(const Calibration& calibration, const LoopView& view,
                        const LoopCurves& curves) {
  render::Panel panel;
  panel.x.title = "time t [s]";
  panel.y.title = axis_title(curves.title, curves.scale);
  panel.show_legend = false;
  const AxisScale time = view.time();
  const auto add = [&](const std::vector<double>& signal, render::Colour colour, double width) {
    add_visible(panel,
                line("", shown(view.until(view.shown_end_s, view.trace->t_s), time),
                     shown(view.until(view.shown_end_s, signal), curves.scale), colour, width));
  };
  // Over time the strokes hide what they were taken from.
  if (curves.all != nullptr && curves.all != curves.strokes) add(*curves.all, cloud, cloud_px);
  add(*curves.strokes, render::palette::blue, strokes_px);
  add_loop_points(panel, calibration.hysteresis.points, curves.signal, true, view, curves.scale);
  return panel;
}

}  // namespace

ReportFigure two_panels(const Calibration& calibration, const LoopView& view,
                        const LoopCurves& curves) {
  ReportFigure out;
  out.stage = "hysteresis";
  out.figure.panels = {over_angle(calibration, view, curves), over_time(calibration, view, curves)};
  out.figure.height_px = two_panels_px;
  return out;
}

}  // namespace tribolog::figures
