#include "verdict/mass_agreement.h"

#include <cmath>

#include <fmt/format.h>

namespace tribolog {
namespace {

/// Disagreement of two estimates in units of their joint 95 % interval; above 1 it is a finding.
double disagreement(const Estimate& a, const Estimate& b) {
  const double joint = std::hypot(a.half_width(), b.half_width());
  return joint > 0 ? std::abs(a.value - b.value) / joint : 0.0;
}

}  // namespace

std::vector<std::string> mass_disagreements(const Calibration& c) {
  const SurrogateMass* midline = c.masses.find("midline");
  const SurrogateMass* sweep = c.masses.find("sweep");
  if (midline == nullptr || sweep == nullptr) return {};
  const double difference = midline->mass_kg.value - sweep->mass_kg.value;
  // A tenth of a percent is of no consequence, however narrow the intervals.
  if (disagreement(midline->mass_kg, sweep->mass_kg) <= 1 ||
      std::abs(difference) <= 1e-3 * sweep->mass_kg.value) {
    return {};
  }
  return {
      fmt::format("mid-line and sweep disagree: {:.3f} kg against {:.3f} kg, more than their "
                  "intervals allow; "
                  "torque ripple or friction that depends on the load would do that",
                  midline->mass_kg.value, sweep->mass_kg.value)};
}

}  // namespace tribolog
