#include "simulate/cvode_solver.h"

#include <utility>

#include "base/program_module.h"

namespace tribolog::simulate {

CvodeSolver::CvodeSolver(std::vector<double> start, Rates rates, Events events,
                         const Options& options) {
  void* const make =
      function_of({"tribolog_ode", TRIBOLOG_ODE_PACKAGES}, "tribolog_cvode_integrator");
  integrator_.reset(reinterpret_cast<decltype(&tribolog_cvode_integrator)>(make)(
      start, std::move(rates), std::move(events), options));
}

CvodeSolver::~CvodeSolver() = default;

CvodeSolver::Stop CvodeSolver::advance_to(double t) { return advance_to(t, t); }

CvodeSolver::Stop CvodeSolver::advance_to(double t, double limit) {
  return integrator_->advance_to(t, limit);
}

bool CvodeSolver::happened(std::size_t event) const { return integrator_->happened(event); }

double CvodeSolver::time() const { return integrator_->time(); }

std::span<double> CvodeSolver::unknowns() { return integrator_->unknowns(); }

void CvodeSolver::restart(double first_step) { integrator_->restart(first_step); }

}  // namespace tribolog::simulate
