#pragma once
// What CvodeSolver has in the module tribolog_ode.

#include <cstddef>
#include <span>
#include <vector>

#include "simulate/cvode_solver.h"

namespace tribolog {

/// As the functions of CvodeSolver.
class CvodeIntegrator {
 public:
  CvodeIntegrator() = default;
  virtual ~CvodeIntegrator() = default;
  CvodeIntegrator(const CvodeIntegrator&) = delete;
  CvodeIntegrator& operator=(const CvodeIntegrator&) = delete;

  virtual CvodeSolver::Stop advance_to(double t, double limit) = 0;
  [[nodiscard]] virtual double time() const = 0;
  [[nodiscard]] virtual bool happened(std::size_t event) const = 0;
  [[nodiscard]] virtual std::span<double> unknowns() = 0;
  virtual void restart(double first_step) = 0;
};

}  // namespace tribolog

/// The caller owns it. @throw std::runtime_error if the library refuses.
extern "C" __attribute__((visibility("default"))) tribolog::CvodeIntegrator*
tribolog_cvode_integrator(const std::vector<double>& start, tribolog::CvodeSolver::Rates rates,
                          tribolog::CvodeSolver::Events events,
                          const tribolog::CvodeSolver::Options& options);
