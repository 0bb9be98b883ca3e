#include "support/cvode_bristle.h"

#include <cmath>
#include <stdexcept>

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_config.h>
#include <sundials/sundials_types.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

namespace tribolog::test {
namespace {

// SUNDIALS 6 brought a context to every constructor; 5 (Ubuntu 22.04) has none.
#if SUNDIALS_VERSION_MAJOR >= 6
using Real = sunrealtype;
#define TRIBOLOG_SUN(context) , context
#else
using Real = realtype;
#define TRIBOLOG_SUN(context)
#endif

struct Equation {
  const LuGreFriction& friction;
  const Motion& motion;
};

int rate(Real t, N_Vector z, N_Vector dz, void* data) {
  const auto* e = static_cast<const Equation*>(data);
  NV_Ith_S(dz, 0) = e->friction.deflection_rate_rad_s(NV_Ith_S(z, 0), e->motion.speed(t));
  return 0;
}

void require(int flag) {
  if (flag < 0) throw std::runtime_error("CVODE failed");
}

}  // namespace

std::vector<double> sine_reversals(double frequency_Hz, double end_s) {
  std::vector<double> times;
  for (int k = 0; (0.25 + 0.5 * k) / frequency_Hz < end_s; ++k) {
    times.push_back((0.25 + 0.5 * k) / frequency_Hz);
  }
  return times;
}

void solve_bristle_with_cvode(const LuGreFriction& friction, const Motion& motion, double dt_s,
                              const CvodeOptions& options, std::span<double> z_rad) {
#if SUNDIALS_VERSION_MAJOR >= 7
  SUNContext context = nullptr;
  SUNContext_Create(SUN_COMM_NULL, &context);
#elif SUNDIALS_VERSION_MAJOR == 6
  SUNContext context = nullptr;
  SUNContext_Create(nullptr, &context);
#endif
  Equation equation{friction, motion};
  N_Vector z = N_VNew_Serial(1 TRIBOLOG_SUN(context));
  NV_Ith_S(z, 0) = 0;
  void* solver = CVodeCreate(CV_BDF TRIBOLOG_SUN(context));
  require(CVodeInit(solver, rate, 0, z));
  require(CVodeSStolerances(solver, options.relative_tolerance, options.absolute_tolerance_rad));
  require(CVodeSetUserData(solver, &equation));
  require(CVodeSetMaxNumSteps(solver, 10'000'000));
  require(CVodeSetMaxStep(solver, options.largest_step_s));
  SUNMatrix matrix = SUNDenseMatrix(1, 1 TRIBOLOG_SUN(context));
  SUNLinearSolver linear = SUNLinSol_Dense(z, matrix TRIBOLOG_SUN(context));
  require(CVodeSetLinearSolver(solver, linear, matrix));

  constexpr double together_s = 1e-9;  // a reversal this close to a sample counts as on it
  std::size_t next = 0;
  const auto& reversals = options.reversals_s;
  const auto set_stop = [&] {
    constexpr double never = 1e30;
    require(CVodeSetStopTime(solver, next < reversals.size() ? reversals[next] : never));
  };
  set_stop();
  Real reached = 0;
  if (!z_rad.empty()) z_rad[0] = 0;
  for (std::size_t i = 1; i < z_rad.size(); ++i) {
    const double t = static_cast<double>(i) * dt_s;
    while (next < reversals.size() && reversals[next] < t + together_s) {
      const bool on_sample = std::abs(reversals[next] - t) <= together_s;
      if (reached < reversals[next]) {
        require(CVode(solver, reversals[next], z, &reached, CV_NORMAL));
      }
      reached = on_sample ? t : reversals[next];
      require(CVodeReInit(solver, reached, z));
      require(CVodeSetInitStep(solver, 1e-4 * options.largest_step_s));
      ++next;
      set_stop();
      if (on_sample) break;
    }
    if (reached < t) require(CVode(solver, t, z, &reached, CV_NORMAL));
    z_rad[i] = NV_Ith_S(z, 0);
  }
  CVodeFree(&solver);
  SUNLinSolFree(linear);
  SUNMatDestroy(matrix);
  N_VDestroy(z);
#if SUNDIALS_VERSION_MAJOR >= 6
  SUNContext_Free(&context);
#endif
}

}  // namespace tribolog::test
