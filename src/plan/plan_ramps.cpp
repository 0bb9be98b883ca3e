// Break-away ramps: the joint stands at the gravity peak, the torque rises until it slides.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "joint/degrees.h"
#include "plan/plan_builder.h"

namespace tribolog::planning {
namespace {

constexpr double seconds_to_break_away = 4;
constexpr double usual_change = 1.6;  // of the break-away torque
constexpr double least_change = 1.2;
constexpr double usable_torque = 0.95;
constexpr double return_s = 2;
constexpr double usual_repeats = 5;
constexpr double fewest_repeats = 3;
constexpr double most_repeats = 10;
/// Travel at which a ramp is over, as a multiple of the deflection at break-away.
constexpr double travel_over_breakaway = 100;
/// The travel to break-away must show in so many steps of the encoder (stages/break_away.h).
constexpr double fewest_steps = 20;

}  // namespace

void add_ramps(const WorkingRange& range, Timeline& timeline, ExperimentPlan& plan) {
  using std::numbers::pi;
  const AssumedJoint& j = plan.joint;
  const double n = j.facts.gear_ratio;
  PlannedPart part = part_about_the_peak(Role::break_away, range, plan);
  part.gives = "break-away torque without any model";
  const double spare = usable_torque * j.facts.torque_limit_Nm - j.gravity_Nm;
  const double change = std::min(usual_change * j.static_Nm, spare);
  const double steps = j.breakaway_deflection_rad() * j.noise.encoder_counts_per_turn / (2 * pi);
  // Thrown off by all of the change it must not pass the speed limit within its travel.
  const double speed_limit = j.facts.speed_limit_rad_s * n;
  const double by_speed = speed_limit * speed_limit * j.inertia_kgm2 / (2 * change) / n;
  const double travel = std::min(
      {travel_over_breakaway * j.breakaway_deflection_rad() / n, by_speed, range.span_rad() / 2});
  if (part.state == PartState::planned && change < least_change * j.static_Nm) {
    part.state = PartState::impossible;
    part.why = fmt::format(
        "holding gravity of {:.4g} N·m, the torque limit of {:.4g} N·m leaves {:.3g} N·m; {:.3g} "
        "N·m are needed to pass the break-away torque of {:.3g} N·m",
        j.gravity_Nm, j.facts.torque_limit_Nm, spare, least_change * j.static_Nm, j.static_Nm);
    part.help = "a lighter load";
  } else if (part.state == PartState::planned && steps < fewest_steps) {
    part.state = PartState::impossible;
    part.why = fmt::format(
        "the {:.2g} rad of the motor up to break-away are {:.2g} steps of the encoder, {:.0f} are "
        "needed",
        j.breakaway_deflection_rad(), steps, fewest_steps);
    part.help = "a finer encoder";
  }
  if (part.state == PartState::planned) {
    const PlannedRamp up{1, j.static_Nm / seconds_to_break_away, change, travel};
    const double ramp_s = change / up.rate_Nm_s;
    const double q = range.with_room(j.q_peak_rad, travel);
    const auto repeats = static_cast<int>(std::clamp(
        std::round(usual_repeats * std::sqrt(plan.effort)), fewest_repeats, most_repeats));
    const double begins_s = timeline.now_s();
    timeline.go_to(q);
    for (int k = 0; k < 2 * repeats; ++k) {
      PlannedRamp ramp = up;
      ramp.direction = k % 2 == 0 ? 1 : -1;
      timeline.record(fmt::format("break-away {} of {}, torque {}", k + 1, 2 * repeats,
                                  k % 2 == 0 ? "rising" : "falling"),
                      Role::break_away, hold(q, rest_s + ramp_s + return_s), rest_s,
                      rest_s + ramp_s, ramp);
    }
    part.recordings = static_cast<std::size_t>(2 * repeats);
    part.duration_s = timeline.now_s() - begins_s;
    part.motion = fmt::format(
        "at {}, {} ramps up and {} down at {:.3g} N·m/s, by up to {:.3g} N·m at the motor from "
        "what holds the arm; a ramp ends when the joint has slid {:.2g}°",
        degrees_text(q), repeats, repeats, up.rate_Nm_s, change, travel * degrees_per_rad);
  }
  plan.parts.push_back(std::move(part));
}

}  // namespace tribolog::planning
