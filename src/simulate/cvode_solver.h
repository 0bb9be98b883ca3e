#pragma once
// SUNDIALS' CVODE with a C++ owner: BDF with dense Newton or Adams with fixed-point iteration, and
// root finding. The library is in a module that the first solver loads: Debian 13's brings MPI
// along.

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace tribolog::simulate {

class CvodeIntegrator;

class CvodeSolver {
 public:
  using Rates = std::function<void(double t, std::span<const double> y, std::span<double> rates)>;
  using Events = std::function<void(double t, std::span<const double> y, std::span<double> values)>;

  /// BDF is for stiff rates; Adams is the faster one where they are not, and needs no matrix.
  enum class Method { bdf, adams };

  struct Options {
    Method method{Method::bdf};
    double relative_tolerance{};
    std::vector<double> absolute_tolerances;  ///< One for each unknown.
    double largest_step{};
    std::size_t events{};  ///< Number of values whose zero crossings stop the solver.
  };

  /// @throw std::runtime_error if the library refuses. @throw MissingModule
  CvodeSolver(std::vector<double> start, Rates rates, Events events, const Options& options);
  ~CvodeSolver();
  CvodeSolver(const CvodeSolver&) = delete;
  CvodeSolver& operator=(const CvodeSolver&) = delete;

  enum class Stop { at_time, at_event };
  /// Goes on to a time or to the first event before it.
  /// @throw Refusal: equations that no step is small enough for.
  Stop advance_to(double t);
  /// The same without a step that ends at t: the solver steps on as it likes, but never beyond
  /// `limit` >= t, and the unknowns are interpolated.
  Stop advance_to(double t, double limit);

  [[nodiscard]] double time() const;
  /// Did this event stop the solver?
  [[nodiscard]] bool happened(std::size_t event) const;
  /// The unknowns at time(). After a change call restart().
  [[nodiscard]] std::span<double> unknowns();
  /// Forgets the history: what comes is not a smooth continuation.
  void restart(double first_step);

 private:
  std::unique_ptr<CvodeIntegrator> integrator_;
};

// What CvodeSolver has in the module tribolog_ode.

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

}  // namespace tribolog::simulate

/// The caller owns it. @throw std::runtime_error if the library refuses.
extern "C" __attribute__((visibility("default"))) tribolog::simulate::CvodeIntegrator*
tribolog_cvode_integrator(const std::vector<double>& start,
                          tribolog::simulate::CvodeSolver::Rates rates,
                          tribolog::simulate::CvodeSolver::Events events,
                          const tribolog::simulate::CvodeSolver::Options& options);
