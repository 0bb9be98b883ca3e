// Equations (3), (4) and (5): LuGre.

#include <algorithm>

#include "friction/catalogue.h"
#include "paper/checks/equation_checks.h"
#include "paper/checks/solved_bristle.h"
#include "paper/checks/speed_grid.h"
#include "paper/drawings/lugre_diagram.h"

namespace tribolog::paper {
namespace {

constexpr double rounding_Nm = 1e-13;
constexpr const char* rounding = "rounding";

std::vector<double> grid() { return speeds_of_both_signs(1e-4, 300); }

/// Deflections up to the largest that the model allows.
double some_deflection(const LuGreFriction& friction, std::size_t i) {
  constexpr std::size_t kinds = 9;
  const double share = 2 * static_cast<double>(i % kinds) / (kinds - 1) - 1;
  return share * friction.steady_deflection_rad(0);
}

}  // namespace

Checks check_equation_3(const PapersJoint& joint) {
  const LuGreFriction& friction = bristles_of(joint.scenario);
  const LuGreFriction::Parameters& p = friction.parameters();
  const SignalGraph graph = lugre_graph(friction);
  double from_equation = 0;
  double from_diagram = 0;
  std::size_t i = 0;
  for (const double w : grid()) {
    const double z = some_deflection(friction, i++);
    const double rate = friction.deflection_rate_rad_s(z, w);
    const double ours = friction.torque_Nm(z, rate, w);
    const double printed =
        p.bristle_stiffness_Nm_rad * z + p.bristle_damping_Nms_rad * rate + p.viscous_Nms_rad * w;
    from_equation = std::max(from_equation, std::abs(ours - printed));
    const double drawn = evaluate(graph, {{"speed", w}}, {{"deflection", z}}).at("friction");
    from_diagram = std::max(from_diagram, std::abs(ours - drawn));
  }
  const LuGreFriction table_1 =
      *dynamic_cast<const LuGreFriction*>(dynamic_friction_model("lugre").matched({}).get());
  const double steady = 0.01;
  return {
      vanishing("Equation against program, at 1000 states: largest difference", from_equation,
                rounding_Nm, "N·m", rounding),
      vanishing("Block diagram of figure 4 against program, at the same states", from_diagram,
                1e-10, "N·m", "rounding, where σ₁ dz/dt reaches 1000 N·m"),
      law_value("Steady sliding with table 1 at ten Stribeck velocities: T_c + σ₂ ω",
                1.0 + 0.4 * steady, table_1.steady_torque_Nm(steady), rounding_Nm, "N", rounding)};
}

Checks check_equation_4(const PapersJoint& joint) {
  const LuGreFriction& friction = bristles_of(joint.scenario);
  const Recording& log = joint.recording(Role::oscillation);
  const std::vector<double> solved = solved_deflection_rad(joint);
  double largest = 0;
  double apart = 0;
  for (std::size_t i = 0; i < solved.size(); ++i) {
    largest = std::max(largest, std::abs(solved[i]));
    apart = std::max(apart, std::abs(solved[i] - log.z_rad.at(i)));
  }
  return {
      vanishing(
          "Equation against program, at 1000 states: largest difference",
          [&] {
            std::size_t i = 0;
            return largest_over(grid(), [&](double w) {
              const double z = some_deflection(friction, i++);
              const double g = friction.steady_deflection_rad(w);
              const double printed = w - std::abs(w) / g * z;
              return friction.deflection_rate_rad_s(z, w) - printed;
            });
          }(),
          1e-12, "rad/s", rounding),
      vanishing("In steady sliding z = g(ω) sgn(ω) stays: largest dz/dt",
                largest_over(grid(),
                             [&](double w) {
                               const double g = friction.steady_deflection_rad(w);
                               return friction.deflection_rate_rad_s(std::copysign(g, w), w);
                             }),
                1e-12, "rad/s", rounding),
      vanishing("The oscillation's z(t), program against CVODE: largest difference by largest z",
                apart / largest, 1e-8, "", "what the program promises"),
      vanishing("z never exceeds g(0): by how much, as a share of it",
                std::max(0.0, largest / friction.steady_deflection_rad(0) - 1), 0, "",
                "proved for LuGre")};
}

Checks check_equation_5(const PapersJoint& joint) {
  const LuGreFriction& friction = bristles_of(joint.scenario);
  const LuGreFriction::Parameters& p = friction.parameters();
  const auto level = [&](double w) {
    return p.bristle_stiffness_Nm_rad * friction.steady_deflection_rad(w);
  };
  const double ws = p.stribeck_speed_rad_s;
  return {
      vanishing("Equation against program, at 1000 speeds: largest difference",
                largest_over(grid(),
                             [&](double w) {
                               const double ratio = w / ws;
                               const double printed = p.coulomb_Nm + (p.static_Nm - p.coulomb_Nm) *
                                                                         std::exp(-ratio * ratio);
                               return level(w) - printed;
                             }),
                rounding_Nm, "N·m", rounding),
      law_value("At rest: T_s", p.static_Nm, level(0), rounding_Nm, "N·m", rounding),
      law_value("Far beyond ω_s: T_c", p.coulomb_Nm, level(10 * ws), rounding_Nm, "N·m", rounding)};
}

}  // namespace tribolog::paper
