#include "support/torque_driven_loop.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "simulate/forced_motion.h"
#include "support/loop_fit.h"
#include "support/paper_joint.h"

namespace tribolog::test {

DrivingTorque growing_sine(double first_Nm, double last_Nm, double frequency_Hz,
                           double duration_s) {
  return [=](double t) {
    return (first_Nm + (last_Nm - first_Nm) * t / duration_s) *
           std::sin(2 * std::numbers::pi * frequency_Hz * t);
  };
}

DrivingTorque growing_triangle(double first_Nm, double last_Nm, double frequency_Hz,
                               double duration_s) {
  return [=](double t) {
    const double sine = std::sin(2 * std::numbers::pi * frequency_Hz * t);
    return (first_Nm + (last_Nm - first_Nm) * t / duration_s) * 2 / std::numbers::pi *
           std::asin(sine);
  };
}

joint::Recording torque_driven_loop(const simulate::Scenario& s, const DrivingTorque& torque,
                                    double duration_s, double sample_rate_Hz) {
  const double n = s.gear_ratio;
  const double centre = true_q_peak_rad();
  const double held = s.load.torque_Nm(centre) / n;
  simulate::ForcedMotionSetup setup;
  setup.inertia_kgm2 = s.motor_inertia_kgm2 + s.arm_inertia_kgm2 / (n * n);
  setup.angle_rad = n * centre;
  setup.applied_Nm = [&](double t, double motor_rad, double) {
    return held + torque(t) - s.load.torque_Nm(motor_rad / n) / n;
  };
  setup.duration_s = duration_s;
  setup.sample_s = 1 / sample_rate_Hz;
  setup.relative_tolerance = 1e-8;
  const simulate::ForcedMotion motion = simulate::simulate_forced_motion(*s.presliding, setup);
  joint::Recording r;
  r.name = "torque-driven";
  r.role = joint::Role::oscillation;
  r.t_s = motion.t_s;
  for (std::size_t i = 0; i < motion.t_s.size(); ++i) {
    r.q_rad.push_back(motion.angle_rad[i] / n);
    r.torque_Nm.push_back(held + torque(motion.t_s[i]));
  }
  r.rows_read = r.size();
  return r;
}

method::hysteresis::LuGreFit fit_traced(const std::vector<joint::Recording>& loops) {
  constexpr double gear_ratio = 100;
  std::vector<method::motion::TracedMotion> motions;
  for (const joint::Recording& r : loops) {
    method::motion::MotionTrace trace = method::motion::trace_motion(r);
    if (!trace.motion) throw Refusal(trace.refusal);
    motions.push_back(std::move(*trace.motion));
  }
  std::vector<method::hysteresis::LuGreInput> inputs;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    inputs.push_back({&loops[k], nullptr, &motions[k]});
  }
  return method::hysteresis::fit_lugre(inputs, gear_ratio, true_q_peak_rad(), {}, contact_alone())
      .fit;
}

}  // namespace tribolog::test
