// Figure 5: loops that are closed, converged, and those of another solver; and the limits that are
// known on paper.

#include "simulate/presliding_loops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace tribolog::presliding_loops_test {
namespace {

using std::numbers::pi;

const friction::ContactParameters table_1;

const std::vector<simulate::PreslidingLoop>& figure_5() {
  static const std::vector<simulate::PreslidingLoop> loops = simulate::presliding_loops(table_1);
  return loops;
}

std::string name_of(const simulate::PreslidingLoop& loop) {
  return std::to_string(loop.amplitude_N) + " N at " + std::to_string(loop.frequency_Hz) + " Hz";
}

simulate::PreslidingLoop one_loop(double amplitude_N, double frequency_Hz) {
  return simulate::presliding_loops(table_1, {{amplitude_N, frequency_Hz}}).at(0);
}

/// Work [J] of a force over a cycle.
double work_of(const std::vector<double>& force_N, const simulate::ForcedMotion& cycle) {
  double work = 0;
  for (std::size_t i = 1; i < cycle.t_s.size(); ++i) {
    work += (force_N[i] * cycle.speed_rad_s[i] + force_N[i - 1] * cycle.speed_rad_s[i - 1]) / 2 *
            (cycle.t_s[i] - cycle.t_s[i - 1]);
  }
  return work;
}

TEST(PreslidingLoops, AreClosedFromTheFirstCycleOn) {
  ASSERT_EQ(figure_5().size(), 3U);
  for (const simulate::PreslidingLoop& loop : figure_5()) {
    EXPECT_LE(loop.gap, 1e-6) << name_of(loop);
    const auto& x = loop.cycle.angle_rad;
    EXPECT_LE(std::abs(x.back() - x.front()), 1e-6 * loop.width_m) << name_of(loop);
    RecordProperty(name_of(loop) + ", gap", std::to_string(loop.gap * 1e6) + "e-6");
  }
}

TEST(PreslidingLoops, AreConverged) {
  for (const simulate::PreslidingLoop& loop : figure_5()) {
    EXPECT_LE(loop.tolerance_shift, 1e-6) << name_of(loop);
    EXPECT_GT(loop.tolerance_shift, 0) << "no other tolerance was tried";
    RecordProperty(name_of(loop) + ", shift", std::to_string(loop.tolerance_shift * 1e6) + "e-6");
  }
}

// No second loop hides behind the first: the cycle after is the same.
TEST(PreslidingLoops, RepeatInTheNextCycle) {
  const auto model = friction::dynamic_friction_model("lugre").matched(table_1);
  for (const simulate::PreslidingLoop& loop : figure_5()) {
    const simulate::ForcedMotion& first = loop.cycle;
    simulate::ForcedMotionSetup setup;
    setup.applied_Nm = [&](double t, double, double) {
      return loop.amplitude_N * std::sin(2 * pi * loop.frequency_Hz * t);
    };
    setup.duration_s = 1 / loop.frequency_Hz;
    setup.sample_s = setup.duration_s / static_cast<double>(first.t_s.size() - 1);
    setup.angle_rad = first.angle_rad.back();
    setup.speed_rad_s = first.speed_rad_s.back();
    setup.friction_state = first.end_state;
    const simulate::ForcedMotion second = simulate::simulate_forced_motion(*model, setup);
    ASSERT_EQ(second.angle_rad.size(), first.angle_rad.size());
    double apart = 0;
    for (std::size_t i = 0; i < first.angle_rad.size(); ++i) {
      apart = std::max(
          {apart, std::abs(second.angle_rad[i] - first.angle_rad[i]) / loop.width_m,
           std::abs(second.friction_Nm[i] - first.friction_Nm[i]) / (2 * loop.largest_friction_N)});
    }
    EXPECT_LT(apart, 1e-6) << name_of(loop);
  }
}

using State = std::array<double, 3>;  // x, v, z

State plus(const State& y, double factor, const State& rates) {
  return {y[0] + factor * rates[0], y[1] + factor * rates[1], y[2] + factor * rates[2]};
}

// The classical explicit method of fourth order in tiny equal steps shares nothing with CVODE's
// implicit one: neither steps nor events nor Newton's iteration. Where friction turns its corner it
// is of lower order, which is what the tolerance allows for beside CVODE's own 1e-7. It starts
// where the cycle ends, which on a closed one is where it began.
TEST(PreslidingLoops, AreThoseOfRungeKuttaInTinySteps) {
  constexpr double agreement = 1e-6;
  const auto model = friction::dynamic_friction_model("lugre").matched(table_1);
  for (const simulate::PreslidingLoop& loop : figure_5()) {
    const double omega = 2 * pi * loop.frequency_Hz;
    const auto rates = [&](double t, const State& y) {
      State out{};
      model->rates({&y[2], 1}, y[1], {&out[2], 1});
      out[0] = y[1];
      out[1] = loop.amplitude_N * std::sin(omega * t) - model->torque_Nm({&y[2], 1}, y[1]);
      return out;
    };
    const simulate::ForcedMotion& cycle = loop.cycle;
    State y{cycle.angle_rad.back(), cycle.speed_rad_s.back(), cycle.end_state.at(0)};
    const std::size_t intervals = cycle.t_s.size() - 1;
    constexpr int per_interval = 200;
    const double h = 1 / (loop.frequency_Hz * static_cast<double>(intervals * per_interval));
    double apart = 0;
    for (std::size_t i = 1; i <= intervals; ++i) {
      for (int k = 0; k < per_interval; ++k) {
        const double t =
            static_cast<double>((i - 1) * per_interval + static_cast<std::size_t>(k)) * h;
        const State k1 = rates(t, y);
        const State k2 = rates(t + h / 2, plus(y, h / 2, k1));
        const State k3 = rates(t + h / 2, plus(y, h / 2, k2));
        const State k4 = rates(t + h, plus(y, h, k3));
        y = plus(plus(plus(plus(y, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
      }
      const double friction = model->torque_Nm({&y[2], 1}, y[1]);
      apart = std::max({apart, std::abs(y[0] - cycle.angle_rad[i]) / loop.width_m,
                        std::abs(friction - cycle.friction_Nm[i]) / (2 * loop.largest_friction_N)});
    }
    EXPECT_LT(apart, agreement) << name_of(loop);
    RecordProperty(name_of(loop) + ", apart", std::to_string(apart * 1e6) + "e-6");
  }
}

// What the force puts in over a closed cycle, friction takes out.
TEST(PreslidingLoops, TakeTheWorkOfTheForce) {
  for (const simulate::PreslidingLoop& loop : figure_5()) {
    const double put_in = work_of(loop.cycle.applied_Nm, loop.cycle);
    const double taken = work_of(loop.cycle.friction_Nm, loop.cycle);
    EXPECT_GT(taken, 0) << name_of(loop);
    EXPECT_NEAR(put_in, taken, 1e-4 * taken) << name_of(loop);
    // No loop is larger than its bounding box.
    EXPECT_LT(taken, 2 * loop.largest_friction_N * loop.width_m) << name_of(loop);
  }
}

/// Work of a slow force in a cycle [J].
double slow_work_J(double amplitude_N) {
  const double a = amplitude_N / 1.5;
  return 2 * 1.5 * 1.5e-5 * (std::log((1 + a) / (1 - a)) - 2 * a);
}

// Slow and below break-away LuGre is rate independent. From dz/dx = 1 - z s0/Ts on the way up, with
// a = amplitude/Ts: width Ts/s0 ln((1 + a)/(1 - a)), area 2 Ts²/s0 (ln((1 + a)/(1 - a)) - 2 a).
TEST(PreslidingLoops, OfSlowForcesAreTheKnownOnes) {
  constexpr double slow_Hz = 2e-3;
  constexpr double near = 1e-3;  // what the damping of the bristles adds to the smallest area
  for (const double amplitude : {0.2, 0.5, 1.0, 1.425}) {
    const double a = amplitude / 1.5;
    const double width = 1.5e-5 * std::log((1 + a) / (1 - a));
    const simulate::PreslidingLoop loop = one_loop(amplitude, slow_Hz);
    EXPECT_NEAR(loop.width_m, width, near * width) << amplitude;
    EXPECT_NEAR(loop.slow_width_m, width, 1e-12 * width) << amplitude;
    const double area = slow_work_J(amplitude);
    EXPECT_NEAR(work_of(loop.cycle.friction_Nm, loop.cycle), area, near * area) << amplitude;
    EXPECT_NEAR(loop.largest_friction_N, amplitude, near * amplitude) << amplitude;
  }
}

// A small loop keeps its width at half the frequency. Its area has, beside that of the slow loop, a
// part from the damping of the bristles that grows with the frequency.
TEST(PreslidingLoops, OfSmallForcesTendToTheSlowOneAsTheFrequencyFalls) {
  const simulate::PreslidingLoop at_1_Hz = one_loop(0.5, 1);
  const simulate::PreslidingLoop at_half = one_loop(0.5, 0.5);
  EXPECT_NEAR(at_1_Hz.width_m, at_half.width_m, 1e-3 * at_half.width_m);
  const double work_at_1_Hz = work_of(at_1_Hz.cycle.friction_Nm, at_1_Hz.cycle);
  const double work_at_half = work_of(at_half.cycle.friction_Nm, at_half.cycle);
  EXPECT_GT(work_at_1_Hz, work_at_half);
  EXPECT_NEAR(2 * work_at_half - work_at_1_Hz, slow_work_J(0.5), 2e-3 * slow_work_J(0.5));
}

// The paper calls all three pre-sliding. In none does the speed stay below the Stribeck velocity.
TEST(PreslidingLoops, OfThePaperSlide) {
  for (const simulate::PreslidingLoop& loop : figure_5()) {
    EXPECT_GT(loop.largest_speed_m_s, 2 * loop.stribeck_speed_m_s) << name_of(loop);
    EXPECT_LT(loop.largest_presliding_N, loop.amplitude_N) << name_of(loop);
    EXPECT_GT(loop.width_m, loop.slow_width_m) << name_of(loop);
    EXPECT_LT(loop.largest_friction_N, 1.5) << name_of(loop);
  }
  EXPECT_GT(figure_5().front().width_m, 100 * figure_5().front().slow_width_m);
}

// At 1 Hz there is nothing between creeping and running away.
TEST(PreslidingLoops, RunAwayAboveTheLargestPreslidingAmplitude) {
  const double limit = simulate::largest_presliding_amplitude_N(table_1, 1);
  const simulate::PreslidingLoop below = one_loop(0.995 * limit, 1);
  const simulate::PreslidingLoop above = one_loop(1.005 * limit, 1);
  EXPECT_LT(below.largest_speed_m_s, table_1.stribeck_speed_rad_s);
  EXPECT_LT(below.width_m, 2 * below.slow_width_m);
  EXPECT_GT(above.largest_speed_m_s, 10 * table_1.stribeck_speed_rad_s);
  EXPECT_GT(above.width_m, 50 * above.slow_width_m);
}

TEST(PreslidingLoops, HoldLessTheFasterTheForce) {
  double before = table_1.static_Nm;
  for (const double frequency : {0.1, 1.0, 10.0, 25.0}) {
    const double limit = simulate::largest_presliding_amplitude_N(table_1, frequency);
    EXPECT_LT(limit, before) << frequency;
    before = limit;
  }
}

TEST(PreslidingLoops, HaveNoSlowWidthFromTheStaticForceOn) {
  EXPECT_TRUE(std::isinf(one_loop(1.5, 10).slow_width_m));
}

TEST(PreslidingLoops, RefuseWhatCannotBe) {
  EXPECT_THROW(one_loop(0, 1), std::invalid_argument);
  EXPECT_THROW(one_loop(1, -1), std::invalid_argument);
  EXPECT_THROW(simulate::largest_presliding_amplitude_N(table_1, 0), std::invalid_argument);
}

}  // namespace
}  // namespace tribolog::presliding_loops_test
