#include "paper/checks/solved_bristle.h"

#include <memory>
#include <stdexcept>

#include "base/requirements.h"
#include "simulate/cvode_solver.h"

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

}  // namespace tribolog::paper::checks
