#include "stages/data_checks/scale_causes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "joint/degrees.h"

namespace tribolog {
namespace {

constexpr double least_tolerance = 0.01;  // relative
constexpr double dead = 1e-3;             // of the true speed

struct Cause {
  double factor;
  std::string words;
};

std::vector<Cause> usual_causes(double n) {
  using std::numbers::pi;
  std::vector<Cause> causes{
      {2, "a difference over two samples divided by the time of one"},
      {0.5, "a difference over one sample divided by the time of two"},
      {5.0 / 3, "divided by a sampling time of 3/5 of the real one, such as 6 ms for 10 ms"},
      {3.0 / 5, "divided by a sampling time of 5/3 of the real one, such as 10 ms for 6 ms"},
      {degrees_per_rad, "degrees per second taken for radians per second"},
      {rad_per_degree, "radians per second taken for degrees per second"},
      {2 * pi / 60, "radians per second taken for revolutions per minute"},
      {60 / (2 * pi), "revolutions per minute taken for radians per second"},
      {2 * pi, "radians per second where the angle is in turns"},
      {1 / (2 * pi), "turns per second taken for radians per second"},
      {1000, "a clock in milliseconds taken for seconds, or milliradians for radians"},
      {1e-3, "a clock in seconds taken for milliseconds, or radians for milliradians"}};
  if (n != 1) {
    causes.push_back({n, "the motor's speed beside the joint's angle (the gear ratio)"});
    causes.push_back({1 / n,
                      "the joint's speed beside the motor's angle (one over the gear "
                      "ratio)"});
    causes.push_back({n * 60 / (2 * pi),
                      "the motor's speed in revolutions per minute taken for "
                      "the joint's in radians per second"});
  }
  return causes;
}

}  // namespace

std::string likely_cause_of_scale(double factor, double half_width, double gear_ratio) {
  const double size = std::abs(factor);
  if (size < dead) return "the column is dead: it does not change with the speed";
  const double tolerance = std::max(least_tolerance, half_width / size);
  std::string named;
  for (const Cause& cause : usual_causes(gear_ratio)) {
    if (std::abs(size / cause.factor - 1) > tolerance) continue;
    named += (named.empty() ? "likely " : ", or ") + cause.words;
  }
  if (factor < 0) {
    const std::string sign = "the sign is that of the other direction";
    if (std::abs(size - 1) <= tolerance) return sign;
    return sign + (named.empty() ? "" : "; " + named);
  }
  return named.empty() ? "no usual cause has this factor" : named;
}

}  // namespace tribolog
