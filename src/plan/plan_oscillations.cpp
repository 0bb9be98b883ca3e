// Oscillations about the gravity peak, at motor positions over which torque ripple averages out.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "joint/degrees.h"
#include "method/hysteresis/position_mean.h"
#include "method/motion/encoder_resolution.h"
#include "plan/plan_builder.h"

namespace tribolog::plan {
namespace {

using std::numbers::pi;

/// Amplitude over the deflection at break-away: the loop's ends are flat then (the paper's 5.26).
constexpr double amplitude_over_breakaway = 5.26;
/// Where the deflection at break-away is assumed, further amplitudes by these factors: one of them
/// bends the loop as it should.
constexpr std::array other_amplitudes{1 / 3.0, 3.0};
constexpr double usual_frequency_Hz = 1;
constexpr double least_samples_per_cycle = 100;
constexpr double least_set_points_per_cycle = 50;
constexpr double set_points_per_ease = 10;
constexpr double usual_cycles = 10;
constexpr double fewest_cycles = 5;
constexpr std::size_t usual_positions = 8;
constexpr std::size_t few_positions = 5;
constexpr std::size_t many_positions = 12;
/// Joint angle over which the positions may spread: gravity falls by 1.5 % at its ends.
constexpr double largest_spread_rad = 20 * joint::rad_per_degree;
constexpr double ripple_of_no_matter = 0.05;  // of its amplitude, left in the mean

struct Shape {
  double amplitude_rad{};
  double frequency_Hz{};
  double ease_s{};
};

/// The usual oscillation or a wider one, slowed down until set points, log and limits can follow.
Shape oscillation_shape(const AssumedJoint& j, const WorkingRange& range, double widening = 1) {
  Shape s;
  s.amplitude_rad =
      widening * amplitude_over_breakaway * j.breakaway_deflection_rad() / j.facts.gear_ratio;
  s.frequency_Hz = std::min({usual_frequency_Hz, j.sample_rate_Hz / least_samples_per_cycle,
                             j.set_point_rate_Hz / least_set_points_per_cycle});
  constexpr double longest_ease = 0.2;
  const auto ease = [&] {
    return std::min(set_points_per_ease / j.set_point_rate_Hz, longest_ease / s.frequency_Hz);
  };
  const auto is_too_fast = [&] {
    return 2 * pi * s.frequency_Hz * s.amplitude_rad > j.facts.speed_limit_rad_s ||
           EasedSine::largest_acceleration_rad_s2(s.amplitude_rad, s.frequency_Hz, ease()) >
               range.acceleration_rad_s2;
  };
  while (is_too_fast()) s.frequency_Hz /= 2;
  s.ease_s = ease();
  return s;
}

/// Steps of the motor's encoder across the loop.
double steps_across(const AssumedJoint& j, const Shape& s) {
  return 2 * s.amplitude_rad * j.facts.gear_ratio * j.noise.encoder_counts_per_turn / (2 * pi);
}

std::vector<double> spread(double centre_rad, double over_rad, std::size_t count) {
  std::vector<double> angles;
  const auto n = static_cast<double>(count);
  for (std::size_t k = 0; k < count; ++k) {
    angles.push_back(centre_rad + (static_cast<double>(k) - (n - 1) / 2) * over_rad / n);
  }
  return angles;
}

/// Largest share of a known period's amplitude that the mean over the joint angles leaves.
double ripple_left(const AssumedJoint& j, const std::vector<double>& q_rad) {
  std::vector<double> motor;
  for (const double q : q_rad) motor.push_back(q * j.facts.gear_ratio);
  double worst = 0;
  for (const simulate::Noise::Ripple& one : j.noise.ripple) {
    worst = std::max(worst,
                     method::hysteresis::share_left_in_mean({one.periods_per_turn, 1, 0}, motor));
  }
  return worst;
}

struct Positions {
  std::vector<double> q_rad;
  double left{1};  ///< As ripple_left().
};

/// So many positions or a few more, over a motor turn or a period of the ripple: what leaves least.
Positions choose_positions(const AssumedJoint& j, const WorkingRange& range, double amplitude_rad,
                           std::size_t wanted) {
  constexpr std::size_t few_more = 5;
  constexpr double clearly = 0.5;
  const double n = j.facts.gear_ratio;
  const double room = std::min(largest_spread_rad, range.span_rad() - 2 * amplitude_rad);
  std::vector<double> lengths{2 * pi / n};
  for (const simulate::Noise::Ripple& one : j.noise.ripple) {
    lengths.push_back(2 * pi / one.periods_per_turn / n);
  }
  Positions best{{range.with_room(j.q_peak_rad, amplitude_rad)}, 1};
  for (const double over : lengths) {
    if (over > room) continue;
    const double centre = range.with_room(j.q_peak_rad, over / 2 + amplitude_rad);
    for (std::size_t count = wanted; count <= wanted + few_more; ++count) {
      Positions p{spread(centre, over, count), 0};
      p.left = ripple_left(j, p.q_rad);
      const bool is_first = best.q_rad.size() == 1;
      if (is_first || p.left < clearly * best.left - 1e-9) best = std::move(p);
    }
  }
  return best;
}

/// Narrowest first; none where stiffness and break-away torque are stated.
std::vector<Shape> other_shapes(const AssumedJoint& j, const WorkingRange& range) {
  std::vector<Shape> shapes;
  if (j.facts.static_Nm && j.facts.bristle_stiffness_Nm_rad) return shapes;
  for (const double factor : other_amplitudes) {
    const Shape s = oscillation_shape(j, range, factor);
    const bool fits = 2 * s.amplitude_rad < range.span_rad();
    if (fits && steps_across(j, s) >= method::motion::fewest_steps_in_presliding)
      shapes.push_back(s);
  }
  return shapes;
}

Statement motion_of(const std::vector<Shape>& others) {
  if (others.empty()) return {};
  const double first = others.front().amplitude_rad * 1e6;
  if (others.size() == 1) return {"plan_motion.other_amplitude", {{"amplitude", first}}};
  return {"plan_motion.other_amplitudes",
          {{"smaller", first}, {"larger", others.back().amplitude_rad * 1e6}}};
}

Statement ripple_that_stays(const AssumedJoint& j, const Positions& positions) {
  const double amplitude = j.noise.ripple.front().amplitude_Nm;
  const std::string motor_turn = degrees_text(2 * pi / j.facts.gear_ratio, 1);
  if (positions.q_rad.size() == 1) {
    return {"plan_limit.all_ripple_stays",
            {{"ripple_amplitude", amplitude}, {"motor_turn", motor_turn}}};
  }
  return {"plan_limit.ripple_stays",
          {{"left_percent", 100 * positions.left},
           {"ripple_amplitude", amplitude},
           {"motor_turn", motor_turn}}};
}

std::size_t wanted_positions(double effort) {
  return effort < 0.5 ? few_positions : effort < 2 ? usual_positions : many_positions;
}

}  // namespace

void add_oscillations(const WorkingRange& range, Timeline& timeline, ExperimentPlan& plan) {
  const AssumedJoint& j = plan.joint;
  PlannedPart part = part_about_the_peak(joint::Role::oscillation, range, plan);
  part.gives = {"plan_gives.oscillations"};
  const Shape shape = oscillation_shape(j, range);
  const double steps = steps_across(j, shape);
  if (steps < method::motion::fewest_steps_in_presliding) {
    part.state = PartState::impossible;
    constexpr double steps_needed = method::motion::fewest_steps_in_presliding;
    part.why = {"plan_limit.encoder_in_presliding",
                {{"counts", j.noise.encoder_counts_per_turn},
                 {"steps", steps},
                 {"loop_width", 2 * shape.amplitude_rad * j.facts.gear_ratio},
                 {"steps_needed", steps_needed}}};
    part.help = {"plan_help.finer_encoder_for_loop",
                 {{"counts", std::ceil(j.noise.encoder_counts_per_turn * steps_needed / steps)}}};
  } else if (part.state == PartState::planned && 2 * shape.amplitude_rad > range.span_rad()) {
    part.state = PartState::impossible;
    part.why = {"plan_limit.oscillation_too_wide",
                {{"width", 2 * shape.amplitude_rad}, {"range", range.span_rad()}}};
    part.help = {"plan_help.wider_angle_limits"};
  }
  if (part.state == PartState::planned) {
    const std::vector<Shape> others = other_shapes(j, range);
    double widest = shape.amplitude_rad;
    for (const Shape& other : others) widest = std::max(widest, other.amplitude_rad);
    const Positions positions = choose_positions(j, range, widest, wanted_positions(plan.effort));
    plan.positions_rad = positions.q_rad;
    plan.ripple_left_share = positions.left;
    plan.amplitude_rad = shape.amplitude_rad;
    plan.frequency_Hz = shape.frequency_Hz;
    if (positions.left > ripple_of_no_matter) {
      part.state = PartState::limited;
      part.why = ripple_that_stays(j, positions);
      part.help = {"plan_help.wider_range_about_peak"};
    }
    const int cycles =
        static_cast<int>(std::round(std::max(fewest_cycles, usual_cycles * plan.effort)));
    const double begins_s = timeline.now_s();
    const std::size_t count = positions.q_rad.size();
    const auto oscillate = [&](const Statement& name, const Shape& s, double centre_rad) {
      const auto motion = std::make_shared<EasedSine>(centre_rad, s.amplitude_rad, s.frequency_Hz,
                                                      cycles, s.ease_s);
      timeline.go_to(motion->start_rad());
      timeline.record(name, joint::Role::oscillation, motion, s.ease_s,
                      motion->duration_s() - s.ease_s);
    };
    for (std::size_t k = 0; k < count; ++k) {
      oscillate({"plan_segment.oscillation", {{"number", k + 1}, {"oscillations", count}}}, shape,
                positions.q_rad[k]);
      if (k != count / 2) continue;
      for (const Shape& other : others) {
        oscillate({"plan_segment.other_oscillation", {{"amplitude", other.amplitude_rad * 1e6}}},
                  other, positions.q_rad[k]);
      }
    }
    part.recordings = count + others.size();
    part.duration_s = timeline.now_s() - begins_s;
    part.motion = {"plan_motion.oscillations",
                   {{"cycles", Statement{"plan_motion.cycles", {{"cycles", cycles}}}},
                    {"frequency", shape.frequency_Hz},
                    {"amplitude", shape.amplitude_rad * 1e6},
                    {"motor_amplitude", shape.amplitude_rad * j.facts.gear_ratio * 1e3},
                    {"positions", count},
                    {"first", degrees_text(positions.q_rad.front(), 3)},
                    {"last", degrees_text(positions.q_rad.back(), 3)}}};
    part.motion.add(motion_of(others));
  }
  plan.parts.push_back(std::move(part));
}

}  // namespace tribolog::plan
