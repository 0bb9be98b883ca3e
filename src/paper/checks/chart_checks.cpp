// Figures 1, 2 and 5: charts of friction laws, checked on the points that are drawn.

#include <algorithm>
#include <limits>

#include "paper/checks/figure_checks.h"
#include "paper/drawings/printed_paper.h"
#include "wording/axis_scale.h"

namespace tribolog::paper {
namespace {

constexpr double rounding_Nm = 1e-12;

/// Largest distance of a drawn law's points from the law. Series with markers are not of the law.
template <class Law>
double off_the_law(const render::Panel& panel, const std::string& label_of_law, const Law& law,
                   double speed_factor) {
  double largest = -1;
  for (const render::Series& series : panel.series) {
    const bool is_law = series.label.find(label_of_law) != std::string::npos;
    if (!is_law) continue;
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i])) continue;
      const double speed = series.x[i] / speed_factor;
      largest = std::max(largest, std::abs(series.y[i] - law.torque_Nm(speed)));
    }
  }
  return largest < 0 ? std::numeric_limits<double>::quiet_NaN() : largest;
}

}  // namespace

Checks check_static_chart(const PapersJoint& joint, const ReportFigure& drawn) {
  const StribeckFriction& law = joint.discontinuous;
  const render::Panel& panel = drawn.figure.panels.at(0);
  double at_rest_Nm = 0;
  for (const render::Series& series : panel.series) {
    if (series.marker == render::Marker::none) continue;
    const auto [low, high] = std::minmax_element(series.y.begin(), series.y.end());
    at_rest_Nm = std::max(at_rest_Nm, *high - *low);
  }
  return {vanishing("Points of the drawn line against eq. (1): largest difference",
                    off_the_law(panel, "eq. (1)", law, 1.0), rounding_Nm, "N·m", "rounding"),
          law_value("The range drawn at rest: from −T_brk to T_brk",
                    2 * law.curve().parameters().static_Nm, at_rest_Nm, 0, "N·m", "")};
}

Checks check_linear_zone_chart(const PapersJoint& joint, const ReportFigure& drawn) {
  const ThresholdSpeedFriction& law = joint.continuous;
  const double threshold = law.parameters().threshold_rad_s;
  const std::vector<render::Panel>& panels = drawn.figure.panels;
  const double milli = figures::prefixed("rad/s", threshold).factor;
  const bool is_in_range = threshold >= printed::smallest_threshold_rad_s &&
                           threshold <= printed::largest_threshold_rad_s;
  return {
      vanishing("Points of the drawn line against eq. (2): largest difference",
                off_the_law(panels.at(0), "eq. (2)", law, 1.0), rounding_Nm, "N·m", "rounding"),
      vanishing("The same in the close-up of the linear zone",
                off_the_law(panels.at(1), "eq. (2)", law, milli), rounding_Nm, "N·m", "rounding"),
      in_words("The threshold lies in the printed range of 10⁻⁵ to 10⁻³", Origin::printed, "within",
               is_in_range ? "within" : "outside"),
      law_value("Half of T_f(ω_th) does not hold the shaft: it creeps at this share of ω_th", 0.5,
                law.torque_Nm(threshold / 2) / law.torque_Nm(threshold), rounding_Nm, "",
                "rounding")};
}

Checks check_presliding_chart(const PapersJoint& joint) {
  constexpr double closed = 1e-6;
  constexpr double rounding = 1e-9;
  Checks out;
  for (std::size_t i = 0; i < printed::figure_5.size(); ++i) {
    const printed::Swing& swing = printed::figure_5.at(i);
    const PreslidingLoop& loop = joint.loops.at(i);
    const std::vector<double>& force = loop.cycle.applied_Nm;
    const std::string name = i == 0 ? "1st loop" : i == 1 ? "2nd loop" : "3rd loop";
    out.push_back(printed_value(name + ": amplitude of the force", swing.amplitude_N, 3,
                                *std::max_element(force.begin(), force.end()),
                                rounding * swing.amplitude_N, "N", "rounding"));
    out.push_back(printed_value(name + ": its frequency, from the cycle's duration",
                                swing.frequency_Hz, 0,
                                1 / (loop.cycle.t_s.back() - loop.cycle.t_s.front()),
                                rounding * swing.frequency_Hz, "Hz", "rounding"));
    out.push_back(vanishing(name + ": gap after the first cycle, as a share of its size", loop.gap,
                            closed, "", "closed to a millionth"));
    out.push_back(vanishing(name + ": largest change with the solver's tolerance halved",
                            loop.tolerance_shift, closed, "", "nothing that could be seen"));
  }
  return out;
}

}  // namespace tribolog::paper
