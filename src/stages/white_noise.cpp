#include "stages/white_noise.h"

#include <cmath>
#include <utility>

#include "stages/median.h"

namespace tribolog {

double white_noise_of(const std::vector<double>& y) {
  std::vector<double> third;
  for (std::size_t i = 3; i < y.size(); ++i) {
    third.push_back(std::abs(y[i] - 3 * y[i - 1] + 3 * y[i - 2] - y[i - 3]));
  }
  if (third.empty()) return 0;
  return 1.4826 * median(std::move(third)) / std::sqrt(20.0);
}

}  // namespace tribolog
