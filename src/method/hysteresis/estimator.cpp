#include "method/hysteresis/estimator.h"

#include <algorithm>

#include "base/enum_text.h"
#include "base/requirements.h"

namespace tribolog::method::hysteresis {

std::string to_string(Estimator estimator) { return own_name(estimator); }

std::string to_string(std::optional<Estimator> estimator) {
  return estimator ? to_string(*estimator) : std::string();
}

std::optional<Estimator> estimator_of(const std::string& key) {
  return own_names<Estimator>.find(key);
}

std::optional<std::size_t> point_index(Estimator estimator) {
  const auto* const at = std::find(loop_points.begin(), loop_points.end(), estimator);
  if (at == loop_points.end()) return std::nullopt;
  return static_cast<std::size_t>(at - loop_points.begin());
}

std::optional<std::pair<Estimator, Estimator>> points_of_pair(Estimator estimator) {
  switch (estimator) {
    case Estimator::AB:
      return std::pair{Estimator::A, Estimator::B};
    case Estimator::CD:
      return std::pair{Estimator::C, Estimator::D};
    case Estimator::EF:
      return std::pair{Estimator::E, Estimator::F};
    default:
      return std::nullopt;
  }
}

Estimator opposite_point(Estimator point) {
  for (const Estimator pair : pair_means) {
    const auto [first, second] = present(points_of_pair(pair));
    if (point == first) return second;
    if (point == second) return first;
  }
  return point;
}

}  // namespace tribolog::method::hysteresis
