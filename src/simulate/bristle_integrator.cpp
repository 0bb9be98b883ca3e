#include "simulate/bristle_integrator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "base/requirements.h"
#include "base/statement.h"
#include "friction/exponential_step.h"
#include "simulate/motion.h"

// The loop over a block's steps is compiled for AVX2 too and chosen at run time. Without fused
// multiply-add both give the same bits.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define TRIBOLOG_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define TRIBOLOG_WIDE
#endif

namespace tribolog::simulate {
namespace {

constexpr std::size_t block_steps = 1024;

struct Block {
  // Motor speed and g at the start of each step (one more: the end of the last) and at its middle.
  std::array<double, block_steps + 1> w;
  std::array<double, block_steps> w_middle;
  std::array<double, block_steps + 1> g;
  std::array<double, block_steps> g_middle;
  std::array<double, block_steps + 1> inverse_g;
  std::array<double, block_steps> length;
  std::array<double, block_steps> c0;
  std::array<double, block_steps> c1;
  std::array<double, block_steps> c2;
  std::array<double, block_steps> decay;
  std::array<double, block_steps> source;
};

/// Where the dip is a Gaussian of the speed, d = 2.
struct GaussianDeflection {
  double coulomb_rad;
  double excess_rad;
  double per_speed;
  explicit GaussianDeflection(const friction::LuGreFriction::Parameters& p)
      : coulomb_rad(p.coulomb_Nm / p.bristle_stiffness_Nm_rad),
        excess_rad((p.static_Nm - p.coulomb_Nm) / p.bristle_stiffness_Nm_rad),
        per_speed(1 / p.stribeck_speed_rad_s) {}
  [[gnu::always_inline]] double operator()(double w) const {
    const double x = w * per_speed;
    return coulomb_rad + excess_rad * friction::exp_nonpositive(-(x * x));
  }
  /// The same for speeds far below the Stribeck velocity, where the exponential is almost 1.
  [[gnu::always_inline]] double at_micro_speed(double w) const {
    const double x = w * per_speed;
    return coulomb_rad + excess_rad * friction::exp_near_zero(-(x * x));
  }
};

/// What a pass over a block's speeds shows before any step is taken. Counts, because those
/// vectorise where a minimum would not.
struct SpeedCounts {
  std::int64_t forward{};
  std::int64_t backward{};
  std::int64_t fast{};  ///< Not far below the Stribeck velocity.
};

TRIBOLOG_WIDE SpeedCounts count_speeds(const Block& b, std::size_t steps, double micro_speed) {
  SpeedCounts counts;
  const auto count = [&](double w) {
    counts.forward += w > 0 ? 1 : 0;
    counts.backward += w < 0 ? 1 : 0;
    counts.fast += std::abs(w) > micro_speed ? 1 : 0;
  };
  for (std::size_t i = 0; i <= steps; ++i) count(b.w[i]);
  for (std::size_t i = 0; i < steps; ++i) count(b.w_middle[i]);
  return counts;
}

template <class Deflection>
[[gnu::always_inline]] inline void shape(Block& b, std::size_t steps, double dt, Deflection g) {
  for (std::size_t i = 0; i <= steps; ++i) {
    b.g[i] = g(b.w[i]);
    b.inverse_g[i] = 1.0 / b.g[i];
  }
  for (std::size_t i = 0; i < steps; ++i) {
    const double g_middle = g(b.w_middle[i]);
    const friction::StepShape<double> shape = friction::step_shape<double>(
        b.w[i], b.w_middle[i], b.w[i + 1], b.g[i], g_middle, b.g[i + 1], b.inverse_g[i],
        1.0 / g_middle, b.inverse_g[i + 1], dt);
    b.g_middle[i] = g_middle;
    b.length[i] = shape.length;
    b.c0[i] = shape.c0;
    b.c1[i] = shape.c1;
    b.c2[i] = shape.c2;
  }
}

TRIBOLOG_WIDE void shape_gaussian_block(const GaussianDeflection& g, Block& b, std::size_t steps,
                                        double dt, bool micro_speed) {
  if (micro_speed) {
    shape(b, steps, dt, [g](double w) { return g.at_micro_speed(w); });
  } else {
    shape(b, steps, dt, [g](double w) { return g(w); });
  }
}

/// Whether some step of the block bends too sharply for one parabola.
TRIBOLOG_WIDE bool is_rough(const Block& b, std::size_t steps) {
  std::int64_t rough = 0;
  for (std::size_t i = 0; i < steps; ++i) {
    rough += std::abs(b.c2[i]) > roughest_step * b.g_middle[i] ? 1 : 0;
  }
  return rough > 0;
}

template <class Moments>
[[gnu::always_inline]] inline void weigh(Block& b, std::size_t steps, Moments moments) {
  for (std::size_t i = 0; i < steps; ++i) {
    const friction::StepMoments<double> m = moments(b.length[i]);
    b.decay[i] = m.decay;
    b.source[i] = friction::step_source<double>({b.length[i], b.c0[i], b.c1[i], b.c2[i]}, m);
  }
}

/// In a block that has long steps too, the short ones are weighed again by the series.
void weigh_short_steps(Block& b, std::size_t steps) {
  for (std::size_t i = 0; i < steps; ++i) {
    if (b.length[i] >= friction::series_below) continue;
    const friction::StepMoments<double> m = friction::moments_by_series<10>(b.length[i]);
    b.decay[i] = m.decay;
    b.source[i] = friction::step_source<double>({b.length[i], b.c0[i], b.c1[i], b.c2[i]}, m);
  }
}

TRIBOLOG_WIDE void weigh_block(Block& b, std::size_t steps) {
  double longest = 0;
  for (std::size_t i = 0; i < steps; ++i) longest = std::max(longest, b.length[i]);
  if (longest < 0.01) {
    weigh(b, steps, [](double length) { return friction::moments_by_series<5>(length); });
  } else if (longest < friction::series_below) {
    weigh(b, steps, [](double length) { return friction::moments_by_series<10>(length); });
  } else {
    weigh(b, steps, [](double length) {
      return friction::moments_by_exponential(
          length < friction::series_below ? friction::series_below : length);
    });
    weigh_short_steps(b, steps);
  }
}

}  // namespace

void integrate_bristle(const friction::LuGreFriction& friction, const Motion& motion, double t0_s,
                       double dt_s, double z0_rad, std::span<double> z_rad,
                       std::span<double> dz_rad_s) {
  require_positive(dt_s, "sampling interval", "s");
  if (!std::isfinite(z0_rad)) throw Refusal({"bristle.initial_deflection_not_finite"});
  if (z_rad.size() != dz_rad_s.size()) throw std::invalid_argument("unequal sizes");
  const std::size_t count = z_rad.size();
  if (count == 0) return;

  const GaussianDeflection gaussian(friction.parameters());
  const bool is_gaussian = friction.parameters().stribeck_power == 2.0;
  const auto g = [&](double w) {
    return is_gaussian ? gaussian(w) : friction.steady_deflection_rad(w);
  };
  const double micro_speed =
      std::sqrt(friction::near_zero) * friction.parameters().stribeck_speed_rad_s;
  Block b;
  double z = z0_rad;
  z_rad[0] = z;
  const double w0 = motion.speed(t0_s);
  dz_rad_s[0] = w0 - std::abs(w0) * z / g(w0);
  for (std::size_t first = 0; first + 1 < count; first += block_steps) {
    const std::size_t steps = std::min(block_steps, count - 1 - first);
    const double t = t0_s + static_cast<double>(first) * dt_s;
    motion.speeds(t, dt_s, std::span(b.w).first(steps + 1));
    motion.speeds(t + dt_s / 2, dt_s, std::span(b.w_middle).first(steps));
    const SpeedCounts speeds = count_speeds(b, steps, micro_speed);
    if (is_gaussian) {
      shape_gaussian_block(gaussian, b, steps, dt_s, speeds.fast == 0);
    } else {
      shape(b, steps, dt_s, g);
    }
    weigh_block(b, steps);
    const bool some_need_care = (speeds.forward > 0 && speeds.backward > 0) || is_rough(b, steps);
    const auto needs_care = [&](std::size_t i) {
      return std::abs(b.c2[i]) > roughest_step * b.g_middle[i] ||
             reverses(b.w[i], b.w_middle[i], b.w[i + 1]);
    };
    for (std::size_t i = 0; i < steps; ++i) {
      if (some_need_care && needs_care(i)) {
        const double a = t0_s + static_cast<double>(first + i) * dt_s;
        z = careful_step<double>(g, motion, a, a + dt_s, b.w[i], b.w[i + 1], z);
      } else {
        z = b.decay[i] * z + b.source[i];
      }
      z_rad[first + i + 1] = z;
    }
    for (std::size_t i = 1; i <= steps; ++i) {
      dz_rad_s[first + i] = b.w[i] - std::abs(b.w[i]) * z_rad[first + i] * b.inverse_g[i];
    }
  }
}

}  // namespace tribolog::simulate
