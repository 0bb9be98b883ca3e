#include "statistics/median.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace tribolog {

double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double median_interval(const std::vector<double>& rising) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < rising.size(); ++i) intervals.push_back(rising[i] - rising[i - 1]);
  return median(std::move(intervals));
}

}  // namespace tribolog
