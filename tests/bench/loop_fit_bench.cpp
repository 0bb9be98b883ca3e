// The loop fit on 2,000 samples of the paper's joint with noise. Writes them (time, motor speed,
// motor acceleration, torque) for the peer, which fits the same; prints milliseconds of a fit
// (median), its cost and its number of evaluations.
//   loop_fit_bench DATA.csv

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>
#include <vector>

#include "method/hysteresis/lugre_problem.h"
#include "support/loop_fit.h"
#include "support/paper_joint.h"

using namespace tribolog;

namespace {

constexpr double gear_ratio = 100;
constexpr int fits = 41;

/// Four cycles at 500 Hz.
tribolog::joint::Recording data() {
  tribolog::simulate::Scenario s = tribolog::test::noisy_paper_joint(1);
  s.noise.encoder_counts_per_turn = 0;
  s.oscillation->cycles = 4;
  s.oscillation->sample_rate_Hz = 500;
  tribolog::joint::Recording r = tribolog::test::oscillations_of(s).front();
  for (auto* signal : {&r.t_s, &r.q_rad, &r.torque_Nm}) signal->resize(2000);
  r.dq_rad_s.clear();
  return r;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const tribolog::joint::Recording r = data();
  const auto sine =
      std::make_shared<tribolog::simulate::HarmonicMotion>(tribolog::simulate::HarmonicMotion::sine(
          gear_ratio * tribolog::test::true_q_peak_rad(), 0.01, 1.0));
  std::ofstream out(argv[1]);
  out.precision(17);
  for (std::size_t i = 0; i < r.size(); ++i) {
    out << r.t_s[i] << ',' << sine->speed(r.t_s[i]) << ',' << sine->acceleration(r.t_s[i]) << ','
        << r.torque_Nm[i] << '\n';
  }
  out.close();

  // Six parameters: stiffness, static torque, both dampings, inertia and gravity; z = 0 at the
  // start, as in the peer.
  const tribolog::method::hysteresis::LuGreFreedom free{
      {tribolog::method::hysteresis::LuGreShared::log_stiffness,
       tribolog::method::hysteresis::LuGreShared::log_static,
       tribolog::method::hysteresis::LuGreShared::damping,
       tribolog::method::hysteresis::LuGreShared::viscous,
       tribolog::method::hysteresis::LuGreShared::inertia},
      false};
  tribolog::method::hysteresis::LuGrePoint start;
  start.shared(tribolog::method::hysteresis::LuGreShared::log_stiffness) = std::log(530.0);
  start.shared(tribolog::method::hysteresis::LuGreShared::log_static) = std::log(0.9);
  start.shared(tribolog::method::hysteresis::LuGreShared::damping) = 0.5;
  start.locals = {{3.9, 0}};
  // What depends on the motion alone is made once, in the peer too.
  std::vector<tribolog::method::hysteresis::LuGreLoopModel> models;
  models.emplace_back(r, sine, gear_ratio, tribolog::test::true_q_peak_rad());
  const tribolog::method::hysteresis::LuGreProblem problem(std::move(models));
  const tribolog::statistics::LeastSquaresLimits as_the_peer{1e-12, 1e-12, 200};
  tribolog::method::hysteresis::LuGreProblem::Solution found;
  std::vector<double> milliseconds;
  for (int k = 0; k < fits; ++k) {
    const auto begin = std::chrono::steady_clock::now();
    found = problem.solve(free, start, as_the_peer);
    milliseconds.push_back(
        1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  std::nth_element(milliseconds.begin(), milliseconds.begin() + fits / 2, milliseconds.end());
  std::printf("%.4f %.12g %d\n", milliseconds[fits / 2], found.squares / 2, found.evaluations);
  return found.converged ? 0 : 1;
}
