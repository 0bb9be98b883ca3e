#include "paper/checks/loop_torques.h"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "base/requirements.h"
#include "paper/checks/papers_joint.h"
#include "paper/drawings/printed_paper.h"
#include "wording/tr.h"

namespace tribolog::paper::checks {

// The loop's six torques in closed form, for the joint without inertia and Stribeck effect.
//
// With g constant, eq. (4) is linear along the way: between reversals z goes to ±g like
// exp(-way/g). The points follow without a solver and without samples.

using method::hysteresis::Estimator;
using wording::tr;

std::array<double, 6> plain_loop_torques_Nm(const simulate::Scenario& scenario) {
  const friction::LuGreFriction::Parameters& p = bristles_of(scenario).parameters();
  const simulate::OscillationExperiment& e = present(scenario.oscillation);
  const double g = p.static_Nm / p.bristle_stiffness_Nm_rad;
  const double swing = scenario.gear_ratio * e.amplitude_rad;
  const double top_speed = 2 * std::numbers::pi * e.frequency_Hz * swing;
  const double gravity_Nm = scenario.load.amplitude_Nm() / scenario.gear_ratio;

  // `way` from the middle of the swing, upwards, or from the reversal before.
  const auto torque = [&](double angle, double speed, double z) {
    const double rate = speed - std::abs(speed) * z / g;
    return gravity_Nm * std::cos(angle / scenario.gear_ratio) + p.bristle_stiffness_Nm_rad * z +
           p.bristle_damping_Nms_rad * rate + p.viscous_Nms_rad * speed;
  };
  const auto speed_after = [&](double way) {
    const double angle = swing - way;
    return top_speed * std::sqrt(1 - angle * angle / (swing * swing));
  };
  const double z_C = g * (1 - std::exp(-swing / g));
  const auto dropping = [&](double way) {
    return torque(swing - way, -speed_after(way), -g + (z_C + g) * std::exp(-way / g));
  };
  const double z_D = -g + (z_C + g) * std::exp(-2 * swing / g);
  const auto rising = [&](double way) {
    return torque(way - swing, speed_after(way), g - (g - z_D) * std::exp(-way / g));
  };
  const double way_B = g * std::log((z_C + g) / g);
  // |dz/dt| ~ sqrt(2u - u²) exp(-N u) is largest where N u² - (2N + 1) u + 1 = 0; u: way/swing.
  const double N = swing / g;
  const double half = (2 * N + 1) / (2 * N);
  const double way_F = swing * (half - std::sqrt(half * half - 1 / N));
  return {torque(0, top_speed, 0), dropping(way_B), torque(swing, 0, z_C),
          torque(-swing, 0, z_D),  rising(way_F),   dropping(way_F)};
}

namespace {

constexpr double half_last_place_Nm = 5e-6;  ///< Of torques given to five decimals.
constexpr auto names = method::hysteresis::loop_points;
/// With inertia and Stribeck effect, by an implicit solver from another library.
constexpr double whole[] = {3.93168, 3.85868, 4.76230, 2.99954, 3.69472, 4.06883};

/// How fast torque changes where a point is read [N·m/s].
double torque_rate(const PapersJoint& joint, Estimator name) {
  const method::hysteresis::LoopTrace& trace = joint.calibration.curves.loops.at(0);
  const double t = joint.point(name).t_s;
  const double dt = trace.t_s.at(1) - trace.t_s.at(0);
  const auto i = static_cast<std::size_t>(t / dt);
  return std::abs(trace.torque_Nm.at(i + 1) - trace.torque_Nm.at(i)) / dt;
}

/// Where torque moves fast, an instant read late by `late_s` shows.
Check given_torque(const PapersJoint& joint, Estimator name, std::string what, double given,
                   double ours, double late_s) {
  const double rate_Nm_s = torque_rate(joint, name);
  return known_value(std::move(what), given, 5, ours, half_last_place_Nm + late_s * rate_Nm_s,
                     "N·m",
                     tr("half the last digit, and {late_ms:g} ms of reading where T "
                        "changes by {rate_Nm_s:.2g} N·m/s",
                        {{"late_ms", late_s * 1e3}, {"rate_Nm_s", rate_Nm_s}}));
}

}  // namespace

Checks check_loop_torques(const PapersJoint& joint) {
  const std::array<double, 6> closed_form = plain_loop_torques_Nm(joint.scenario);
  constexpr double fine_s = 1e-5;
  constexpr double between_samples_s = 5e-6;
  const auto plain_ours = [&](Estimator name) {
    for (const method::hysteresis::LoopPoint& p : joint.plain_points) {
      if (p.name == name) return p.torque_Nm;
    }
    return std::nan("");
  };
  Checks out;
  for (std::size_t i = 0; i < std::size(names); ++i) {
    out.push_back(other_way(tr("T at {point} without inertia and Stribeck effect, in closed form",
                               {{"point", to_string(names[i])}}),
                            closed_form[i], plain_ours(names[i]),
                            half_last_place_Nm + between_samples_s * torque_rate(joint, names[i]),
                            "N·m", tr("0.005 ms of reading between samples 1 ms apart")));
  }
  for (std::size_t i = 0; i < std::size(names); ++i) {
    out.push_back(
        given_torque(joint, names[i],
                     tr("T at {point} with both included, by an independent implicit solver",
                        {{"point", to_string(names[i])}}),
                     whole[i], joint.point(names[i]).torque_Nm, fine_s));
  }
  return out;
}

}  // namespace tribolog::paper::checks
