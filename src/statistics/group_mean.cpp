#include "statistics/group_mean.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "statistics/distributions.h"

namespace tribolog::statistics {
namespace {

constexpr double differ = 0.05;  // chance at which groups are taken to be alike

/// Means of the groups, and what their members scatter.
struct Variances {
  std::vector<double> means;
  std::vector<double> counts;
  double within{};   ///< Of single members.
  double freedom{};  ///< Of that.
};

Variances variances_of(const std::vector<std::vector<double>>& groups) {
  Variances out;
  double squares = 0;
  for (const std::vector<double>& group : groups) {
    const auto n = static_cast<double>(group.size());
    double mean = 0;
    for (const double v : group) mean += v / n;
    for (const double v : group) squares += (v - mean) * (v - mean);
    out.means.push_back(mean);
    out.counts.push_back(n);
    out.freedom += n - 1;
  }
  if (out.freedom > 0) out.within = squares / out.freedom;
  return out;
}

struct Weighted {
  double mean{}, weights{}, squares{};
};

/// @param between variance of the groups' effects.
Weighted weighted_mean(const Variances& v, double between) {
  Weighted out;
  const auto weight = [&](std::size_t j) { return 1 / (v.within / v.counts[j] + between); };
  for (std::size_t j = 0; j < v.means.size(); ++j) {
    out.weights += weight(j);
    out.mean += weight(j) * v.means[j];
  }
  out.mean /= out.weights;
  for (std::size_t j = 0; j < v.means.size(); ++j) {
    out.squares += weight(j) * std::pow(v.means[j] - out.mean, 2);
  }
  return out;
}

}  // namespace

std::optional<GroupMean> mean_of_groups_that_differ(
    const std::vector<std::vector<double>>& groups) {
  const Variances v = variances_of(groups);
  const auto freedom = static_cast<double>(groups.size()) - 1;
  if (groups.size() < 2 || !(v.freedom > 0) || !(v.within > 0)) return std::nullopt;
  const Weighted alike = weighted_mean(v, 0);
  if (f_upper_tail(alike.squares / freedom, freedom, v.freedom) >= differ) return std::nullopt;
  double of_weights = 0;
  for (const double n : v.counts) of_weights += std::pow(n / v.within, 2);
  const double between = (alike.squares - freedom) / (alike.weights - of_weights / alike.weights);
  if (!(between > 0)) return std::nullopt;
  const Weighted mean = weighted_mean(v, between);
  GroupMean out;
  out.mean = mean.mean;
  out.between_sd = std::sqrt(between);
  out.half_width =
      student_t_975(freedom) * std::sqrt(std::max(1.0, mean.squares / freedom) / mean.weights);
  for (const double one : v.means) {
    out.largest_off = std::max(out.largest_off, std::abs(one - out.mean));
  }
  return out;
}

}  // namespace tribolog::statistics
