#include "paper/checks/bristle_checks.h"

#include <algorithm>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "base/requirements.h"
#include "friction/catalogue.h"
#include "paper/checks/check.h"
#include "paper/drawings/paper_drawings.h"
#include "paper/drawings/printed_paper.h"
#include "paper/scenes/scene_words.h"
#include "simulate/cvode_solver.h"
#include "wording/tr.h"

namespace tribolog::paper::checks {

namespace {

constexpr double tolerance = 1e-12;

/// Stops where the motion reverses (event 0) and where z crosses zero (event 1).
std::unique_ptr<simulate::CvodeSolver> solver_of(const PapersJoint& joint) {
  const friction::LuGreFriction& friction = bristles_of(joint.scenario);
  const friction::LuGreFriction::Parameters& p = friction.parameters();
  simulate::CvodeSolver::Options options;
  options.relative_tolerance = tolerance;
  options.absolute_tolerances = {tolerance * p.static_Nm / p.bristle_stiffness_Nm_rad};
  options.largest_step = 0.005 / present(joint.scenario.oscillation).frequency_Hz;
  options.events = 2;
  return std::make_unique<simulate::CvodeSolver>(
      std::vector<double>{0.0},
      [&](double t, std::span<const double> z, std::span<double> rate) {
        rate[0] = friction.deflection_rate_rad_s(z[0], joint.oscillation_speed_rad_s(t));
      },
      [&](double t, std::span<const double> z, std::span<double> values) {
        values[0] = joint.oscillation_speed_rad_s(t);
        values[1] = z[0];
      },
      options);
}

void start_anew(simulate::CvodeSolver& solver) {
  constexpr double first_step_s = 1e-9;
  solver.restart(first_step_s);
}

}  // namespace

std::vector<double> solved_deflection_rad(const PapersJoint& joint) {
  const auto solver = solver_of(joint);
  std::vector<double> z;
  for (const double t : joint.recording(joint::Role::oscillation).t_s) {
    while (solver->time() < t && solver->advance_to(t) == simulate::CvodeSolver::Stop::at_event) {
      start_anew(*solver);
    }
    z.push_back(solver->unknowns()[0]);
  }
  return z;
}

double solved_time_of_B_s(const PapersJoint& joint) {
  const auto solver = solver_of(joint);
  const double end = 1 / present(joint.scenario.oscillation).frequency_Hz;
  while (solver->time() < end && solver->advance_to(end) == simulate::CvodeSolver::Stop::at_event) {
    const bool is_dropping = joint.oscillation_speed_rad_s(solver->time()) < 0;
    if (solver->happened(1) && is_dropping) return solver->time();
    start_anew(*solver);
  }
  throw std::runtime_error("the paper's oscillation has no point B");
}

// Equations (3), (4) and (5): LuGre.

namespace {

using wording::tr;

std::vector<double> grid() { return speeds_of_both_signs(1e-4, 300); }

/// Deflections up to the largest that the model allows.
double some_deflection(const friction::LuGreFriction& friction, std::size_t i) {
  constexpr std::size_t kinds = 9;
  const double share = 2 * static_cast<double>(i % kinds) / (kinds - 1) - 1;
  return share * friction.steady_deflection_rad(0);
}

}  // namespace

Checks check_equation_3(const PapersJoint& joint) {
  const friction::LuGreFriction& friction = bristles_of(joint.scenario);
  const friction::LuGreFriction::Parameters& p = friction.parameters();
  const drawings::SignalGraph graph = drawings::lugre_graph(friction);
  double from_equation = 0;
  double from_diagram = 0;
  std::size_t i = 0;
  for (const double w : grid()) {
    const double z = some_deflection(friction, i++);
    const double rate = friction.deflection_rate_rad_s(z, w);
    const double ours = friction.torque_Nm(z, rate, w);
    const double printed =
        p.bristle_stiffness_Nm_rad * z + p.bristle_damping_Nms_rad * rate + p.viscous_Nms_rad * w;
    from_equation = larger_size(from_equation, ours - printed);
    const double drawn =
        drawings::evaluate(graph, {{"speed", w}}, {{"deflection", z}}).at("friction");
    from_diagram = larger_size(from_diagram, ours - drawn);
  }
  const friction::LuGreFriction table_1 = *dynamic_cast<const friction::LuGreFriction*>(
      friction::dynamic_friction_model("lugre").matched({}).get());
  const double steady = 0.01;
  return {vanishing(tr("Equation against the program, at 1000 states: largest difference"),
                    from_equation, law_rounding_Nm, "N·m", tr(law_rounding)),
          vanishing(tr("Block diagram of figure 4 against the program, at the same states"),
                    from_diagram, 1e-10, "N·m", tr("rounding, where σ₁ dz/dt reaches 1000 N·m")),
          other_way(tr("Steady sliding with table 1 at ten Stribeck velocities: T_c + σ₂ ω"),
                    1.0 + 0.4 * steady, table_1.steady_torque_Nm(steady), law_rounding_Nm, "N",
                    tr(law_rounding))};
}

Checks check_equation_4(const PapersJoint& joint) {
  const friction::LuGreFriction& friction = bristles_of(joint.scenario);
  const joint::Recording& log = joint.recording(joint::Role::oscillation);
  const std::vector<double> solved = solved_deflection_rad(joint);
  double largest = 0;
  double apart = 0;
  for (std::size_t i = 0; i < solved.size(); ++i) {
    largest = std::max(largest, std::abs(solved[i]));
    apart = larger_size(apart, solved[i] - log.z_rad.at(i));
  }
  return {
      vanishing(
          tr("Equation against the program, at 1000 states: largest difference"),
          [&] {
            std::size_t i = 0;
            return largest_over(grid(), [&](double w) {
              const double z = some_deflection(friction, i++);
              const double g = friction.steady_deflection_rad(w);
              const double printed = w - std::abs(w) / g * z;
              return friction.deflection_rate_rad_s(z, w) - printed;
            });
          }(),
          1e-12, "rad/s", tr(law_rounding)),
      vanishing(tr("In steady sliding z stays at g(ω) sgn(ω): largest dz/dt"),
                largest_over(grid(),
                             [&](double w) {
                               const double g = friction.steady_deflection_rad(w);
                               return friction.deflection_rate_rad_s(std::copysign(g, w), w);
                             }),
                1e-12, "rad/s", tr(law_rounding)),
      vanishing(tr("The oscillation's z(t), program against CVODE: largest difference / largest z"),
                apart / largest, 1e-8, "", tr("what the program promises")),
      vanishing(tr("z never exceeds g(0): by how much, as a share of it"),
                std::max(0.0, largest / friction.steady_deflection_rad(0) - 1), 0, "",
                tr("proved for LuGre"))};
}

Checks check_equation_5(const PapersJoint& joint) {
  const friction::LuGreFriction& friction = bristles_of(joint.scenario);
  const friction::LuGreFriction::Parameters& p = friction.parameters();
  const auto level = [&](double w) {
    return p.bristle_stiffness_Nm_rad * friction.steady_deflection_rad(w);
  };
  const double ws = p.stribeck_speed_rad_s;
  return {vanishing(tr("Equation against the program, at 1000 speeds: largest difference"),
                    largest_over(grid(),
                                 [&](double w) {
                                   const double ratio = w / ws;
                                   const double printed =
                                       p.coulomb_Nm +
                                       (p.static_Nm - p.coulomb_Nm) * std::exp(-ratio * ratio);
                                   return level(w) - printed;
                                 }),
                    law_rounding_Nm, "N·m", tr(law_rounding)),
          other_way(tr("At rest: T_s"), p.static_Nm, level(0), law_rounding_Nm, "N·m",
                    tr(law_rounding)),
          other_way(tr("Far beyond ω_s: T_c"), p.coulomb_Nm, level(10 * ws), law_rounding_Nm, "N·m",
                    tr(law_rounding))};
}

// Equations (12) and (14): surrogate mass, and the corrected angle.

Checks check_equation_12(const PapersJoint& joint) {
  const joint::GravityLoad& load = joint.scenario.load;
  const double truth = load.mass_kg() * load.distance_m() / drawings::distance_m;
  const method::hysteresis::SurrogateMass* midline =
      joint.calibration.masses.find(method::hysteresis::Estimator::midline);
  Checks out{
      known_value(tr("Surrogate mass of the joint's gravity torque"), 79.1679, 4,
                  joint::surrogate_mass_kg(joint.true_gravity_Nm(), joint.scenario.gear_ratio,
                                           drawings::distance_m, load.gravity_m_s2(), 1.0),
                  5e-5, "kg", tr("digits of the method's number")),
      other_way(tr("The same torque at every angle: its m r relative to that of the arm"), 1.0,
                present(scenes::stated_numbers(joint.robot).surrogate_mass_kg).value *
                    drawings::distance_m / (load.mass_kg() * load.distance_m()),
                1e-12, "", tr("rounding"))};
  if (midline != nullptr) {
    out.push_back(other_way(tr("Mid-line of the loop, an estimate free of friction"), truth,
                            midline->mass_kg.value, 1e-4 * truth, "kg",
                            tr("what the program promises")));
  }
  return out;
}

Checks check_equation_14(const PapersJoint& joint) {
  const simulate::OscillationExperiment& e = present(joint.scenario.oscillation);
  const double t_B = solved_time_of_B_s(joint);
  const double q_3 = e.amplitude_rad * std::sin(2 * std::numbers::pi * e.frequency_Hz * t_B);
  const double q_c = -joint.scenario.load.q_peak_rad();
  const method::selection::SelectionResult& selection = joint.calibration.selection;
  const double found = selection.q_c_corrected_rad.value_or(std::nan(""));
  return {other_way(tr("q_c,f = q_c − q₃ with q₃ where CVODE's z(t) is zero while the arm drops"),
                    q_c - q_3, found, 1e-6, "rad", tr("q_peak is identified to 10⁻⁶ rad")),
          other_way(tr("The angle q₃ that is subtracted"), q_3,
                    selection.q_c_rad ? selection.q_c_rad->value - found : std::nan(""), 1e-6,
                    "rad", tr("q_peak is identified to 10⁻⁶ rad")),
          in_words(tr("Sign: less than q_c, “less of the value”"), Kind::print, found < q_c,
                   tr("less"), tr("not less"))};
}

}  // namespace tribolog::paper::checks
