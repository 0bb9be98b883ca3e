#include "figures/outliers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tribolog::figures {

namespace {

constexpr double far_out = 4.0;            // times the farthest of the others
constexpr double least_of_many = 2.0 / 3;  // of all

}  // namespace

double reach_of_the_many(std::vector<double> distances) {
  std::erase_if(distances, [](double one) { return !std::isfinite(one); });
  std::sort(distances.begin(), distances.end());
  const auto many =
      static_cast<std::size_t>(std::ceil(least_of_many * static_cast<double>(distances.size())));
  for (std::size_t i = std::max<std::size_t>(many, 1); i < distances.size(); ++i) {
    if (distances[i - 1] > 0.0 && distances[i] > far_out * distances[i - 1])
      return distances[i - 1];
  }
  return 0.0;
}

}  // namespace tribolog::figures
