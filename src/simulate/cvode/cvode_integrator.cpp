#include <algorithm>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include <cvode/cvode.h>
#include <fmt/format.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include "base/statement.h"
#include "simulate/cvode_solver.h"
#include "simulate/sundials_versions.h"

namespace tribolog::simulate::cvode {
namespace {

void require(int flag, const char* function) {
  if (flag < 0) throw std::runtime_error(fmt::format("{}: {}", function, flag));
}

struct Parts {
  CvodeSolver::Rates rates;
  CvodeSolver::Events events;
  std::size_t event_count{};
  SunContext context;
  N_Vector y{};
  N_Vector tolerances{};
  void* solver{};
  SUNMatrix matrix{};
  SUNLinearSolver linear{};
  SUNNonlinearSolver fixed_point{};
  SunReal time{0};

  ~Parts() {
    if (solver != nullptr) CVodeFree(&solver);
    if (fixed_point != nullptr) SUNNonlinSolFree(fixed_point);
    if (linear != nullptr) SUNLinSolFree(linear);
    if (matrix != nullptr) SUNMatDestroy(matrix);
    if (tolerances != nullptr) N_VDestroy(tolerances);
    if (y != nullptr) N_VDestroy(y);
  }

  static std::span<double> values(N_Vector v) {
    return {NV_DATA_S(v), static_cast<std::size_t>(NV_LENGTH_S(v))};
  }
  static int rate(SunReal t, N_Vector y, N_Vector dy, void* self) {
    static_cast<Parts*>(self)->rates(t, values(y), values(dy));
    return 0;
  }
  static int event(SunReal t, N_Vector y, SunReal* out, void* self) {
    const auto* parts = static_cast<Parts*>(self);
    parts->events(t, values(y), {out, parts->event_count});
    return 0;
  }
  void iterate_by_newton(sunindextype n) {
    matrix = SUNDenseMatrix(n, n TRIBOLOG_SUN(context));
    linear = SUNLinSol_Dense(y, matrix TRIBOLOG_SUN(context));
    require(CVodeSetLinearSolver(solver, linear, matrix), "CVodeSetLinearSolver");
  }
  void iterate_by_fixed_point() {
    fixed_point = SUNNonlinSol_FixedPoint(y, 0 TRIBOLOG_SUN(context));
    require(CVodeSetNonlinearSolver(solver, fixed_point), "CVodeSetNonlinearSolver");
  }
  static void be_quiet(int /*code*/, const char* /*module*/, const char* /*function*/,
                       char* /*message*/, void* /*data*/) {}
};

class Integrator final : public CvodeIntegrator {
 public:
  Integrator(const std::vector<double>& start, CvodeSolver::Rates rates, CvodeSolver::Events events,
             const CvodeSolver::Options& options);
  CvodeSolver::Stop advance_to(double t, double limit) override;
  [[nodiscard]] double time() const override;
  [[nodiscard]] bool happened(std::size_t event) const override;
  [[nodiscard]] std::span<double> unknowns() override;
  void restart(double first_step) override;

 private:
  Parts parts_;
};

Integrator::Integrator(const std::vector<double>& start, CvodeSolver::Rates rates,
                       CvodeSolver::Events events, const CvodeSolver::Options& options) {
  Parts& p = parts_;
  p.rates = std::move(rates);
  p.events = std::move(events);
  p.event_count = options.events;
#if SUNDIALS_VERSION_MAJOR >= 7
  SUNContext_ClearErrHandlers(p.context.get());
#endif
  const auto n = static_cast<sunindextype>(start.size());
  p.y = N_VNew_Serial(n TRIBOLOG_SUN(p.context));
  p.tolerances = N_VNew_Serial(n TRIBOLOG_SUN(p.context));
  std::copy(start.begin(), start.end(), unknowns().begin());
  std::copy(options.absolute_tolerances.begin(), options.absolute_tolerances.end(),
            Parts::values(p.tolerances).begin());
  const bool is_bdf = options.method == CvodeSolver::Method::bdf;
  p.solver = CVodeCreate(is_bdf ? CV_BDF : CV_ADAMS TRIBOLOG_SUN(p.context));
#if SUNDIALS_VERSION_MAJOR < 7
  CVodeSetErrHandlerFn(p.solver, Parts::be_quiet, nullptr);
#endif
  require(CVodeInit(p.solver, Parts::rate, 0, p.y), "CVodeInit");
  require(CVodeSVtolerances(p.solver, options.relative_tolerance, p.tolerances),
          "CVodeSVtolerances");
  require(CVodeSetUserData(p.solver, &p), "CVodeSetUserData");
  require(CVodeSetMaxNumSteps(p.solver, 50'000'000), "CVodeSetMaxNumSteps");
  require(CVodeSetMaxStep(p.solver, options.largest_step), "CVodeSetMaxStep");
  if (is_bdf) {
    p.iterate_by_newton(n);
  } else {
    p.iterate_by_fixed_point();
  }
  if (options.events > 0) {
    require(CVodeRootInit(p.solver, static_cast<int>(options.events), Parts::event),
            "CVodeRootInit");
    require(CVodeSetNoInactiveRootWarn(p.solver), "CVodeSetNoInactiveRootWarn");
  }
}

CvodeSolver::Stop Integrator::advance_to(double t, double limit) {
  require(CVodeSetStopTime(parts_.solver, limit), "CVodeSetStopTime");
  const int flag = CVode(parts_.solver, t, parts_.y, &parts_.time, CV_NORMAL);
  if (flag < 0) {
    throw Refusal({"solver.too_stiff", {{"time_s", parts_.time}, {"flag", flag}}});
  }
  return flag == CV_ROOT_RETURN ? CvodeSolver::Stop::at_event : CvodeSolver::Stop::at_time;
}

bool Integrator::happened(std::size_t event) const {
  std::vector<int> found(parts_.event_count);
  require(CVodeGetRootInfo(parts_.solver, found.data()), "CVodeGetRootInfo");
  return found[event] != 0;
}

double Integrator::time() const { return parts_.time; }

std::span<double> Integrator::unknowns() { return Parts::values(parts_.y); }

void Integrator::restart(double first_step) {
  require(CVodeReInit(parts_.solver, parts_.time, parts_.y), "CVodeReInit");
  require(CVodeSetInitStep(parts_.solver, first_step), "CVodeSetInitStep");
}

}  // namespace
}  // namespace tribolog::simulate::cvode

tribolog::simulate::CvodeIntegrator* tribolog_cvode_integrator(
    const std::vector<double>& start, tribolog::simulate::CvodeSolver::Rates rates,
    tribolog::simulate::CvodeSolver::Events events,
    const tribolog::simulate::CvodeSolver::Options& options) {
  return new tribolog::simulate::cvode::Integrator(start, std::move(rates), std::move(events),
                                                   options);
}
