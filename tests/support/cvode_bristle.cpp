#include "support/cvode_bristle.h"

#include <cmath>
#include <stdexcept>

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include "simulate/sundials_versions.h"

namespace tribolog::test {
namespace {

struct Equation {
  const friction::LuGreFriction& friction;
  const simulate::Motion& motion;
};

int rate(simulate::SunReal t, N_Vector z, N_Vector dz, void* data) {
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

void solve_bristle_with_cvode(const friction::LuGreFriction& friction,
                              const simulate::Motion& motion, double dt_s,
                              const CvodeOptions& options, std::span<double> z_rad) {
  const simulate::SunContext context;
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
  simulate::SunReal reached = 0;
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
}

}  // namespace tribolog::test
