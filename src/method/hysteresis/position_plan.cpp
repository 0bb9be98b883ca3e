#include "method/hysteresis/position_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "method/hysteresis/position_mean.h"
#include "statistics/distributions.h"

namespace tribolog::method::hysteresis {
namespace {

using std::numbers::pi;

/// Motor angles of evenly spread positions: the first at the centre, then to its right and left.
std::vector<double> spread(double centre, double over) {
  std::vector<double> angles;
  for (std::size_t k = 0; k < planned_positions; ++k) {
    const double places = static_cast<double>((k + 1) / 2) * (k % 2 == 1 ? 1 : -1);
    angles.push_back(centre + places * over / static_cast<double>(planned_positions));
  }
  return angles;
}

/// Standard deviation of the mean due to the lines, each at any phase.
double ripple_left(const gravity::Ripple& ripple, const std::vector<double>& angles) {
  double variance = 0;
  for (const gravity::RippleLine& line : ripple.lines) {
    variance += std::pow(line.amplitude_Nm * share_left_in_mean(line, angles), 2) / 2;
  }
  return std::sqrt(variance);
}

}  // namespace

std::optional<PositionPlan> plan_positions(const gravity::CogSweepResult& rough,
                                           const HysteresisResult& hysteresis, std::size_t cycles,
                                           double gear_ratio) {
  if (!hysteresis.found || !hysteresis.midline_Nm || !(rough.ripple.half_width_Nm() > 0)) {
    return std::nullopt;
  }
  if (hysteresis.positions_hold_ripple) return std::nullopt;
  const double centre = gear_ratio * hysteresis.oscillations.front().centre_rad;
  // One motor turn, or whole periods of a line where they leave clearly less of all of them.
  PositionPlan plan;
  plan.spread_motor_rad = 2 * pi;
  double least = ripple_left(rough.ripple, spread(centre, plan.spread_motor_rad));
  constexpr double clearly = 0.5;
  for (const gravity::RippleLine& line : rough.ripple.lines) {
    const double over = 2 * pi / line.periods_per_turn;
    const double left = ripple_left(rough.ripple, spread(centre, over));
    if (left < clearly * least) {
      least = left;
      plan.spread_motor_rad = over;
    }
  }
  const std::vector<double> angles = spread(centre, plan.spread_motor_rad);
  for (std::size_t k = 1; k < angles.size(); ++k) {
    plan.further_rad.push_back(angles[k] / gear_ratio);
  }
  // The scatter of eight mid-lines like this one about a mean and the lines of the ripple; ripple
  // that is no line stays, averaged.
  const double own = hysteresis.midline_Nm->half_width();
  plan.ripple_half_width_Nm = rough.ripple.half_width_Nm();
  plan.half_width_now_Nm = std::hypot(own, plan.ripple_half_width_Nm);
  const double sd = own / statistics::student_t_975(std::max(1.0, static_cast<double>(cycles) - 1));
  const auto positions = static_cast<double>(planned_positions);
  const double fitted =
      2 * static_cast<double>(std::min<std::size_t>(rough.ripple.lines.size(), 2));
  const double scatter = std::hypot(sd, rough.ripple.rest_Nm);
  plan.expected_half_width_Nm =
      std::hypot(statistics::student_t_975(positions - 1 - fitted) * scatter / std::sqrt(positions),
                 2 * least);
  return plan;
}

Statement why_more_positions(const PositionPlan& plan, const gravity::Ripple& ripple) {
  const StatedValue now{"half_width_now_Nm", plan.half_width_now_Nm};
  const StatedValue further{"further", plan.further_rad.size()};
  const StatedValue expected{"expected_half_width_Nm", plan.expected_half_width_Nm};
  if (ripple.lines.empty()) {
    return {"positions.ripple_without_period",
            {{"standard_deviation_Nm", ripple.rest_Nm}, now, further, expected}};
  }
  std::vector<Statement> lines;
  for (const gravity::RippleLine& line : ripple.lines) {
    lines.push_back(
        {"positions.ripple_line",
         {{"amplitude_Nm", line.amplitude_Nm}, {"periods_per_turn", line.periods_per_turn}}});
  }
  return {"positions.ripple_with_periods", {{"lines", lines}, now, further, expected}};
}

}  // namespace tribolog::method::hysteresis
