// Figures 3, 4 and 6 to 8: drawings that are models.

#include <algorithm>

#include "base/present.h"
#include "paper/checks/figure_checks.h"
#include "paper/drawings/bristle_sketch.h"
#include "paper/drawings/drive_diagram.h"
#include "paper/drawings/joint_diagram.h"
#include "paper/drawings/lugre_diagram.h"
#include "paper/drawings/printed_paper.h"
#include "statistics/random_stream.h"

namespace tribolog::paper {
namespace {

constexpr int states = 1000;
constexpr double log_rounding_Nm = 1e-9;  ///< Angles are logged to 1e-16 rad.
constexpr const char* rounding_of_log = "rounding of the log";

double between(RandomStream& random, double low, double high) {
  return low + (high - low) * random.uniform();
}

}  // namespace

Checks check_bristle_sketch(const ReportFigure& drawn) {
  const render::Diagram& diagram = present(drawn.figure.diagram);
  double sum = 0;
  int bristles = 0;
  double enlarged = 0;
  for (const render::Stroke& stroke : diagram.strokes) {
    if (!(stroke.colour == bristle_colour)) continue;
    const double deflection = stroke.points.front().x - stroke.points.back().x;
    if (enlarged > 0) {  // the enlarged one is drawn last
      sum += enlarged;
      ++bristles;
    }
    enlarged = deflection;
  }
  const render::Dimension& z = diagram.dimensions.at(0);
  const double dimension = z.to.x - z.from.x;
  return {law_value("Mean deflection of the " + std::to_string(bristles) +
                        " bristles as drawn, against the z of the enlarged one",
                    dimension / enlargement_of_mean_bristle, sum / bristles, 0.01, "mm",
                    "the drawing's resolution"),
          law_value("The dimension z spans the enlarged bristle's deflection", enlarged, dimension,
                    1e-9, "mm", "rounding")};
}

Checks check_lugre_diagram(const PapersJoint& joint) {
  const LuGreFriction& friction = bristles_of(joint.scenario);
  const SignalGraph graph = lugre_graph(friction);
  RandomStream random(4, 0);
  double rate_apart = 0;
  double torque_apart = 0;
  for (int i = 0; i < states; ++i) {
    const double speed = between(random, -20, 20);
    const double z = between(random, -1, 1) * friction.steady_deflection_rad(0);
    const SignalValues values = evaluate(graph, {{"speed", speed}}, {{"deflection", z}});
    const double rate = friction.deflection_rate_rad_s(z, speed);
    rate_apart = std::max(rate_apart, std::abs(values.at("rate") - rate));
    torque_apart = std::max(torque_apart,
                            std::abs(values.at("friction") - friction.torque_Nm(z, rate, speed)));
  }
  return {vanishing("dz/dt through the drawn blocks against eq. (4), at 1000 states: largest",
                    rate_apart, 1e-12, "rad/s", "rounding"),
          vanishing("T_f through the drawn blocks against eq. (3): largest", torque_apart, 1e-12,
                    "N·m", "rounding")};
}

Checks check_drive_diagram(const PapersJoint& joint) {
  const double n = joint.scenario.gear_ratio;
  const double J = joint.scenario.motor_inertia_kgm2;
  RandomStream random(6, 0);
  double apart = 0;
  for (int i = 0; i < states; ++i) {
    const double torque = between(random, -5, 5);
    const double friction = between(random, -1, 1);
    const double acceleration = between(random, -100, 100);
    const double drawn =
        evaluate(
            drive_graph({n, J, [friction](double) { return friction; }}),
            {{"motor torque", torque}, {"motor speed", 0}, {"motor acceleration", acceleration}})
            .at("arm torque");
    apart = std::max(apart, std::abs(drawn - n * (torque - J * acceleration - friction)));
  }
  return {vanishing("Through the drawn blocks against eq. (8), at 1000 states: largest", apart,
                    1e-10, "N·m", "rounding")};
}

Checks check_joint_diagram(const PapersJoint& joint) {
  const Scenario& s = joint.scenario;
  const Recording& log = joint.recording(Role::oscillation);
  double apart = 0;
  for (std::size_t i = 0; i < log.size(); ++i) {
    const double t = log.t_s[i];
    JointElements elements;
    elements.drive = {s.gear_ratio, s.motor_inertia_kgm2,
                      [&](double speed) { return s.sliding->torque_Nm(speed); }};
    elements.dynamic_friction_Nm = [&](double speed) {
      return bristles_of(s).torque_Nm(log.z_rad[i], log.dz_rad_s[i], speed);
    };
    elements.friction = FrictionChoice::dynamic;
    elements.arm_inertia_kgm2 = s.arm_inertia_kgm2;
    elements.load = s.load;
    const double n = s.gear_ratio;
    const double drawn =
        evaluate(joint_graph(elements),
                 {{"arm angle", log.q_rad[i]},
                  {"arm speed", joint.oscillation_speed_rad_s(t) / n},
                  {"arm acceleration", joint.oscillation_acceleration_rad_s2(t) / n}})
            .at("measured torque");
    apart = std::max(apart, std::abs(drawn - log.torque_Nm[i]));
  }
  return {vanishing("Measured torque through the drawn blocks against the simulated log: largest",
                    apart, log_rounding_Nm, "N·m", rounding_of_log)};
}

Checks check_gear_diagram(const PapersJoint& joint) {
  RandomStream random(8, 0);
  double lost = 0;
  for (int i = 0; i < states; ++i) {
    const double torque = between(random, -5, 5);
    const double turn = between(random, -5, 5);
    const SignalValues values =
        evaluate(gear_graph(joint.scenario.gear_ratio, joint.scenario.motor_inertia_kgm2),
                 {{"shaft torque", torque}, {"motor angle", turn}, {"motor acceleration", 0}});
    lost =
        std::max(lost, std::abs(values.at("arm torque") * values.at("arm angle") - torque * turn));
  }
  return {
      printed_value("Gear ratio n₃", printed::gear_ratio, 0, joint.scenario.gear_ratio, 0, "", ""),
      vanishing("An ideal gear loses no work, at 1000 states: largest loss", lost, 1e-12, "J",
                "rounding")};
}

}  // namespace tribolog::paper
