#include "figures/peak_marks.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "figures/estimator_style.h"
#include "figures/plot_data.h"
#include "wording/number_text.h"

namespace tribolog::figures {
namespace {

constexpr double visible_share = 0.004;  // of the angle range: a narrower interval is not drawn

bool wide_enough(const CogSweepResult& sweep, double low, double high) {
  return high - low > visible_share * (sweep.highest_rad - sweep.lowest_rad);
}

}  // namespace

void add_argmax(render::Panel& panel, const CogSweepResult& sweep, const AxisScale& torque) {
  const AxisScale deg = degrees();
  const double level = torque(sweep.argmax_torque_Nm);
  render::Series interval =
      line("interval of the largest T", {deg(sweep.argmax_low_rad), deg(sweep.argmax_high_rad)},
           {level, level}, render::palette::black, 2.5);
  interval.marker = render::Marker::plus;
  if (wide_enough(sweep, sweep.argmax_low_rad, sweep.argmax_high_rad)) {
    add_visible(panel, std::move(interval));
  }
  add_visible(panel, render::PointLabel{deg(sweep.argmax_rad), level,
                                        "largest T at " + with_unit(sweep.argmax_rad, deg, 4),
                                        render::palette::black, render::Marker::diamond});
}

void add_peak(render::Panel& panel, const CogSweepResult& sweep, const Extent& torques,
              const AxisScale& torque) {
  if (!std::isfinite(sweep.q_peak_rad.value)) return;
  const AxisScale deg = degrees();

  const Estimate& peak = sweep.q_peak_rad;
  if (wide_enough(sweep, peak.low, peak.high) && !torques.empty) {
    render::Band band;
    band.label = "95 % interval of q_{peak}";
    band.x = {deg(peak.low), deg(peak.high)};
    band.low = {torque(torques.low), torque(torques.low)};
    band.high = {torque(torques.high), torque(torques.high)};
    band.colour = faded(peak_colour, 50);
    panel.bands.push_back(std::move(band));
  }
  panel.reference_lines.push_back({render::ReferenceLine::Direction::vertical, deg(peak.value),
                                   "q_{peak} = " + with_interval(peak, deg), peak_colour,
                                   render::LineStyle::dash_dot});
}

std::string argmax_words(const CogSweepResult& sweep) {
  const AxisScale deg = degrees();
  std::string text = fmt::format("the largest torque, {}, stands at {}",
                                 with_unit(sweep.argmax_torque_Nm, AxisScale{1.0, "N·m"}, 4),
                                 with_unit(sweep.argmax_rad, deg, 4));
  if (wide_enough(sweep, sweep.argmax_low_rad, sweep.argmax_high_rad)) {
    text += fmt::format(" (noise allows {} to {})", with_unit(sweep.argmax_low_rad, deg, 4),
                        with_unit(sweep.argmax_high_rad, deg, 4));
  }
  if (sweep.argmax_at_end) text += ", the end of the sweep: no peak was crossed there";
  return text;
}

}  // namespace tribolog::figures
