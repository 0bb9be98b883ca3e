#pragma once
// Histories of a joint, made up with known truth and realistic noise.

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "archive/store/calibration_archive.h"
#include "calibration/read_calibration.h"
#include "statistics/random_stream.h"

namespace tribolog::test {

/// Which part of its value each quantity has at a calibration (number, days) beyond noise.
using Truth = std::function<double(const std::string& name, std::size_t calibration)>;

struct HistoryNoise {
  /// Standard deviation from calibration to calibration at one temperature, of the value. Repeated
  /// calibrations of one industrial joint on one day come back within 0.5 % to 1 % in Coulomb
  /// torque; the best of it is what a drift of 3 % can be told from in 20.
  double between{0.0045};
  /// Standard error that each calibration's own interval states, and adds. Together 0.5 %.
  double stated{0.0022};
};

struct HistoryShape {
  std::size_t calibrations{20};
  std::vector<double> temperature_C;  ///< Of each; empty: not stated.
  bool is_stated{true};               ///< The temperatures are in the entries too.
  double viscous_per_K{0};            ///< -0.01: one percent less for each kelvin.
  HistoryNoise noise;
};

inline std::string utc_of_day(std::size_t day) {
  return fmt::format("{}-{:02}-{:02}T10:00:00Z", 2024 + day / 336, 1 + day % 336 / 28,
                     1 + day % 28);
}

/// Six friction quantities and three others, each with its own noise.
inline std::vector<calibration::Measured> simulated_history(std::uint64_t seed, const Truth& share,
                                                            const HistoryShape& shape = {}) {
  struct Kind {
    const char* name;
    const char* unit;
    double value;
    double noisier;  ///< Than Coulomb torque.
  };
  static const Kind kinds[] = {{"coulomb_torque", "N·m", 0.45, 1},
                               {"viscous_coefficient", "N·m·s/rad", 1.4e-3, 2},
                               {"stribeck_speed", "rad/s", 9, 4},
                               {"break_away_torque", "N·m", 0.6, 2},
                               {"bristle_stiffness", "N·m/rad", 24000, 5},
                               {"bristle_damping", "N·m·s/rad", 12, 10},
                               {"gravity_torque", "N·m", 3.9, 0.3},
                               {"surrogate_mass", "kg", 77, 0.3},
                               {"inertia", "kg·m²", 2e-3, 3}};
  std::vector<calibration::Measured> all;
  statistics::RandomStream random(seed, 7);
  for (std::size_t k = 0; k < shape.calibrations; ++k) {
    calibration::Measured m;
    m.entry.number = static_cast<std::int64_t>(k + 1);
    m.entry.id = fmt::format("{:064x}", seed * 1000 + k + 1);
    calibration::Facts& f = m.entry.facts;
    f.of = {"R1", "S1", "J2"};
    f.measured_at = utc_of_day(14 * k);
    f.time_is_stated = true;
    f.gear_ratio = 100;
    f.sampling_Hz = 1000;
    const bool is_warm = k < shape.temperature_C.size();
    if (is_warm && shape.is_stated) f.temperature_C = shape.temperature_C[k];
    for (const Kind& kind : kinds) {
      const double stated = shape.noise.stated * kind.noisier;
      double value =
          kind.value * share(kind.name, k) *
          (1 + shape.noise.between * kind.noisier * random.normal() + stated * random.normal());
      if (is_warm && kind.name == std::string("viscous_coefficient")) {
        value *= std::exp(shape.viscous_per_K * (shape.temperature_C[k] - 25));
      }
      m.quantities.push_back({kind.name, kind.name, kind.unit, calibration::Verdict::usable,
                              statistics::symmetric_estimate(value, 1.96 * stated * kind.value)});
    }
    all.push_back(std::move(m));
  }
  return all;
}

/// A friction curve and a loop of a few points, both lifted at one point by `shift`.
inline calibration::RecordedCurves simple_curves(double shift) {
  calibration::RecordedCurves c;
  c.friction = {
      "midline", false, {-2, -1, 1, 2}, {-0.6, -0.5, 0.5, 0.6 + shift}, {0.01, 0.01, 0.01, 0.01}};
  c.loops = {{0.3, {-1e-5, 0, 1e-5, 0}, {3.8, 4.0 + shift, 3.9, 3.7}}};
  return c;
}

inline double unchanged(const std::string& /*name*/, std::size_t /*calibration*/) { return 1; }

}  // namespace tribolog::test
