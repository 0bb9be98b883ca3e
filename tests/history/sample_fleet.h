#pragma once
// A fleet to compare, made up: every robot, joint and calibration scatters about the same truth.

#include <cmath>
#include <vector>

#include "archive/sample_calibration.h"
#include "archive/store/calibration_archive.h"
#include "archive/store/digest.h"
#include "statistics/random_stream.h"

namespace tribolog::test {

struct FleetSize {
  int robots{};
  int joints{};
  int calibrations{};
};

struct SampleQuantity {
  const char* name;
  const char* words;
  const char* unit;
  double value;
};

/// As `tribolog identify` gives them, of joint 1; the next ones are 10 % larger each.
inline constexpr SampleQuantity fleet_quantities[] = {
    {"cog_angle", "Angle of the centre of gravity", "rad", -0.38},
    {"gravity_torque", "Gravity torque", "N·m", 3.88},
    {"surrogate_mass", "Surrogate mass", "kg", 79.1},
    {"break_away_torque", "Break-away torque", "N·m", 0.885},
    {"bristle_stiffness", "Bristle stiffness", "N·m/rad", 465},
    {"bristle_damping", "Bristle damping", "N·m·s/rad", 0.84},
    {"inertia", "Inertia at the motor", "kg·m²", 0.00168},
    {"coulomb_torque", "Coulomb torque", "N·m", 0.45},
    {"stribeck_speed", "Stribeck velocity", "rad/s", 5.02},
    {"viscous_coefficient", "Viscous coefficient", "N·m·s/rad", 0.00262}};

/// Robots differ by 3 %, calibrations of one joint by 1 % (standard deviations); the intervals say
/// 1 %, too. Calls `take` with each calibration, by robot, joint and time.
template <class Take>
void sample_fleet(const FleetSize& size, std::uint64_t seed, const Take& take) {
  constexpr double between_robots = 0.03;
  constexpr double between_calibrations = 0.01;
  statistics::RandomStream random(seed, 0);
  for (int robot = 0; robot < size.robots; ++robot) {
    for (int joint = 1; joint <= size.joints; ++joint) {
      std::vector<double> own;
      for (const SampleQuantity& q : fleet_quantities) {
        own.push_back(q.value * (1 + 0.1 * (joint - 1)) * (1 + between_robots * random.normal()));
      }
      for (int k = 0; k < size.calibrations; ++k) {
        calibration::NewCalibration c = sample_calibration(1000 + robot, joint, 30 * k, 0.45);
        c.facts.measured_at =
            fmt::format("{}-{:02}-{:02}T10:00:00Z", 2024 + k / 4, 1 + 3 * (k % 4), 1 + robot % 28);
        c.inputs[0].sha256 = sha256_hex(fmt::format("{} {} {} {}", seed, robot, joint, k));
        c.quantities.clear();
        for (std::size_t i = 0; i < own.size(); ++i) {
          const SampleQuantity& q = fleet_quantities[i];
          const double value = own[i] * (1 + between_calibrations * random.normal());
          const double half = 1.96 * between_calibrations * std::abs(own[i]);
          c.quantities.push_back({q.name, q.words, q.unit, calibration::Verdict::usable,
                                  statistics::Estimate{value, value - half, value + half, {}}});
        }
        take(c);
      }
    }
  }
}

/// As the archive would give it back.
inline calibration::Measured measured_of(const calibration::NewCalibration& c) {
  calibration::Measured measured;
  measured.entry.identity = archive::store::identity_of(c.inputs);
  measured.entry.id = measured.entry.identity;
  measured.entry.facts = c.facts;
  measured.quantities = c.quantities;
  return measured;
}

inline std::vector<calibration::Measured> measured_fleet(const FleetSize& size,
                                                         std::uint64_t seed) {
  std::vector<calibration::Measured> all;
  sample_fleet(size, seed,
               [&](const calibration::NewCalibration& c) { all.push_back(measured_of(c)); });
  return all;
}

}  // namespace tribolog::test
