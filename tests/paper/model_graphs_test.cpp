// What is drawn is what is computed: the graphs behind figures 4, 6, 7 and 8 against the program's
// own friction models and simulation.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "paper/drawings/paper_drawings.h"
#include "simulate/simulate_joint.h"
#include "statistics/random_stream.h"
#include "support/paper_joint.h"

namespace tribolog::paper::model_graphs_test {
namespace {

// Both sides round each of a handful of operations once.
constexpr double rounding = 1e-13;

double between(statistics::RandomStream& random, double low, double high) {
  return low + (high - low) * random.uniform();
}

friction::LuGreFriction any_friction(statistics::RandomStream& random) {
  friction::LuGreFriction::Parameters p;
  p.bristle_stiffness_Nm_rad = std::pow(10.0, between(random, 0, 5));
  p.bristle_damping_Nms_rad = between(random, 0, 300);
  p.viscous_Nms_rad = between(random, 0, 2);
  p.coulomb_Nm = between(random, 0.1, 2);
  p.static_Nm = p.coulomb_Nm + between(random, 0, 2);
  p.stribeck_speed_rad_s = std::pow(10.0, between(random, -3, 1));
  return friction::LuGreFriction(p);
}

TEST(LuGreDiagram, IsTheModelThatIsComputed) {
  statistics::RandomStream random(4, 0);
  for (int i = 0; i < 1000; ++i) {
    const friction::LuGreFriction friction = any_friction(random);
    const double speed = i % 50 == 0 ? 0.0 : between(random, -1, 1) * std::pow(10.0, i % 5 - 2);
    const double z = between(random, -2, 2) * friction.steady_deflection_rad(speed);
    const drawings::SignalValues values = drawings::evaluate(
        drawings::lugre_graph(friction), {{"speed", speed}}, {{"deflection", z}});
    const double rate = friction.deflection_rate_rad_s(z, speed);
    const double torque = friction.torque_Nm(z, rate, speed);
    const friction::LuGreFriction::Parameters& p = friction.parameters();
    const double scale = std::abs(p.bristle_stiffness_Nm_rad * z) +
                         (3 * p.bristle_damping_Nms_rad + p.viscous_Nms_rad) * std::abs(speed);
    EXPECT_NEAR(values.at("rate"), rate, rounding * 3 * std::abs(speed));
    EXPECT_NEAR(values.at("friction"), torque, rounding * scale);
  }
}

TEST(LuGreDiagram, RestsAtTheSteadyDeflection) {
  statistics::RandomStream random(4, 1);
  for (int i = 0; i < 100; ++i) {
    const friction::LuGreFriction friction = any_friction(random);
    const double speed = between(random, -5, 5);
    const double z = std::copysign(friction.steady_deflection_rad(speed), speed);
    const drawings::SignalValues values = drawings::evaluate(
        drawings::lugre_graph(friction), {{"speed", speed}}, {{"deflection", z}});
    EXPECT_NEAR(values.at("rate"), 0, rounding * std::abs(speed));
  }
}

/// The oscillation of the paper's joint, simulated without noise.
struct SimulatedOscillation {
  simulate::Scenario scenario = test::paper_joint();
  joint::Recording log;

  SimulatedOscillation() {
    simulate::Scenario only = scenario;
    only.rough_sweep.reset();
    only.precise_sweep.reset();
    only.constant_speed.reset();
    log = simulate::simulate_joint(only).at(0);
  }

  [[nodiscard]] double arm_acceleration(std::size_t i) const {
    const simulate::OscillationExperiment& motion = *scenario.oscillation;
    const double omega = 2 * std::numbers::pi * motion.frequency_Hz;
    return -omega * omega * (log.q_rad[i] - motion.centre_rad);
  }
  [[nodiscard]] double arm_speed(std::size_t i) const {
    const simulate::OscillationExperiment& motion = *scenario.oscillation;
    const double omega = 2 * std::numbers::pi * motion.frequency_Hz;
    return motion.amplitude_rad * omega * std::cos(omega * log.t_s[i]);
  }
  [[nodiscard]] double friction(std::size_t i, double motor_speed) const {
    return test::paper_contact().torque_Nm(log.z_rad[i], log.dz_rad_s[i], motor_speed);
  }
};

// Angles of about 0.4 rad are logged to 1e-16 of them; the acceleration has that times omega².
constexpr double torque_error_Nm = 1e-9;

TEST(DriveDiagram, GivesTheArmWhatGravityAndInertiaAskFor) {
  const SimulatedOscillation truth;
  const simulate::Scenario& s = truth.scenario;
  ASSERT_GT(truth.log.size(), 100U);
  for (std::size_t i = 0; i < truth.log.size(); i += 7) {
    const auto friction = [&](double motor_speed) { return truth.friction(i, motor_speed); };
    const drawings::SignalGraph graph =
        drawings::drive_graph({s.gear_ratio, s.motor_inertia_kgm2, friction});
    const drawings::SignalValues values = drawings::evaluate(
        graph, {{"motor torque", truth.log.torque_Nm[i]},
                {"motor speed", s.gear_ratio * truth.arm_speed(i)},
                {"motor acceleration", s.gear_ratio * truth.arm_acceleration(i)}});
    const double asked =
        s.arm_inertia_kgm2 * truth.arm_acceleration(i) + s.load.torque_Nm(truth.log.q_rad[i]);
    EXPECT_NEAR(values.at("arm torque"), asked, s.gear_ratio * torque_error_Nm) << i;
  }
}

TEST(JointDiagram, GivesTheTorqueThatTheSimulationLogs) {
  const SimulatedOscillation truth;
  const simulate::Scenario& s = truth.scenario;
  for (std::size_t i = 0; i < truth.log.size(); i += 7) {
    drawings::JointElements joint;
    joint.drive = {s.gear_ratio, s.motor_inertia_kgm2,
                   [&](double speed) { return s.sliding->torque_Nm(speed); }};
    joint.dynamic_friction_Nm = [&](double speed) { return truth.friction(i, speed); };
    joint.friction = drawings::FrictionChoice::dynamic;
    joint.arm_inertia_kgm2 = s.arm_inertia_kgm2;
    joint.load = s.load;
    const drawings::SignalValues values = drawings::evaluate(
        drawings::joint_graph(joint), {{"arm angle", truth.log.q_rad[i]},
                                       {"arm speed", truth.arm_speed(i)},
                                       {"arm acceleration", truth.arm_acceleration(i)}});
    EXPECT_NEAR(values.at("measured torque"), truth.log.torque_Nm[i], torque_error_Nm) << i;
    EXPECT_EQ(values.at("measured angle"), truth.log.q_rad[i]);
  }
}

TEST(JointDiagram, UsesTheStaticModelAtConstantSpeed) {
  const simulate::Scenario s = test::paper_joint();
  drawings::JointElements joint;
  joint.drive = {s.gear_ratio, s.motor_inertia_kgm2,
                 [&](double speed) { return s.sliding->torque_Nm(speed); }};
  joint.dynamic_friction_Nm = [](double) { return 1e6; };
  joint.arm_inertia_kgm2 = s.arm_inertia_kgm2;
  joint.load = s.load;
  const double speed = 2.0;
  const drawings::SignalValues values =
      drawings::evaluate(drawings::joint_graph(joint), {{"arm angle", s.load.q_peak_rad()},
                                                        {"arm speed", speed / s.gear_ratio},
                                                        {"arm acceleration", 0.0}});
  EXPECT_NEAR(values.at("measured torque"), test::true_gravity_Nm + s.sliding->torque_Nm(speed),
              1e-8);  // the scenario's mass has that many digits
  EXPECT_NEAR(values.at("measured speed"), speed, rounding * speed);
}

TEST(GearDiagram, LosesNoPower) {
  statistics::RandomStream random(8, 0);
  for (int i = 0; i < 100; ++i) {
    const double n = between(random, 1, 200);
    const double torque = between(random, -5, 5);
    const double turn = between(random, -5, 5);
    const drawings::SignalValues values = drawings::evaluate(
        drawings::gear_graph(n, between(random, 0, 1)),
        {{"shaft torque", torque}, {"motor angle", turn}, {"motor acceleration", 0.0}});
    EXPECT_NEAR(values.at("arm torque") * values.at("arm angle"), torque * turn,
                rounding * std::abs(torque * turn));
  }
}

TEST(GearDiagram, IsTheDriveWithoutItsFriction) {
  statistics::RandomStream random(8, 1);
  for (int i = 0; i < 100; ++i) {
    const double n = between(random, 1, 200);
    const double inertia = between(random, 0, 1e-2);
    const double torque = between(random, -5, 5);
    const double friction = between(random, -1, 1);
    const double acceleration = between(random, -100, 100);
    const drawings::SignalValues gear = drawings::evaluate(drawings::gear_graph(n, inertia),
                                                           {{"shaft torque", torque - friction},
                                                            {"motor angle", 0.0},
                                                            {"motor acceleration", acceleration}});
    const drawings::SignalValues drive = drawings::evaluate(
        drawings::drive_graph({n, inertia, [&](double) { return friction; }}),
        {{"motor torque", torque}, {"motor speed", 0.0}, {"motor acceleration", acceleration}});
    EXPECT_NEAR(gear.at("arm torque"), drive.at("arm torque"), rounding * n * 10);
  }
}

}  // namespace
}  // namespace tribolog::paper::model_graphs_test
