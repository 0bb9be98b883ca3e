#include "method/viscous/direction_asymmetry.h"

#include <cmath>

#include <fmt/format.h>

#include "statistics/student_t.h"

namespace tribolog {
namespace {

constexpr std::size_t fewest_pairs = 3;

}  // namespace

DirectionAsymmetryResult identify_direction_asymmetry(const ViscousCurvesResult& curves,
                                                      const SurrogateMass* mass,
                                                      double sweep_offset_Nm) {
  DirectionAsymmetryResult out;
  if (curves.from_sweep) {
    out.sentence = fmt::format(
        "the sweep's offset of {:.3g} N·m was taken out of both directions: half the difference of "
        "their friction, or an offset of the torque signal",
        sweep_offset_Nm);
    return out;
  }
  double sum = 0;
  double cosines = 0;
  for (const ConstantSpeedRun& run : curves.runs) {
    if (mass == nullptr || run.speed_rad_s < 0 || run.partner < 0 ||
        !std::isfinite(run.direction_mean_Nm)) {
      continue;
    }
    out.speed_rad_s.push_back(run.speed_rad_s);
    out.asymmetry_Nm.push_back(run.direction_mean_Nm -
                               mass->gravity_Nm.value * run.direction_mean_cos);
    sum += out.asymmetry_Nm.back();
    cosines += run.direction_mean_cos;
  }
  const auto n = static_cast<double>(out.speed_rad_s.size());
  if (out.speed_rad_s.size() < fewest_pairs) {
    out.sentence =
        "whether friction is the same in both directions cannot be seen without gravity: too few "
        "speeds were run in both directions over the same angles";
    return out;
  }
  double squares = 0;
  for (const double a : out.asymmetry_Nm) squares += std::pow(a - sum / n, 2);
  out.mean_Nm = symmetric_estimate(sum / n, student_t_975(n - 1) * std::sqrt(squares / (n - 1) / n),
                                   "scatter of the pairs");
  out.gravity_could_explain_Nm = std::abs(mass->gravity_Nm.half_width() * cosines / n);
  out.examined = true;
  const double size = std::abs(out.mean_Nm.value);
  // The computer's own rounding is no asymmetry.
  constexpr double rounding = 1e-6;
  const double explained = std::hypot(out.mean_Nm.half_width(), out.gravity_could_explain_Nm);
  out.found = size > explained && size > rounding * mass->gravity_Nm.value;
  const std::string numbers = fmt::format(
      "half the difference of rising and falling is {:.3g} ± {:.2g} N·m, of which an "
      "error of the gravity torque within its interval could be {:.2g} N·m",
      out.mean_Nm.value, out.mean_Nm.half_width(), out.gravity_could_explain_Nm);
  out.sentence = out.found
                     ? "friction is not the same in both directions, or the torque signal has an "
                       "offset, or gravity is off: " +
                           numbers
                     : "no asymmetry of the directions shows: " + numbers;
  return out;
}

}  // namespace tribolog
