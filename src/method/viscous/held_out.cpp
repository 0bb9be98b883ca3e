#include "method/viscous/held_out.h"

#include <cmath>
#include <limits>

namespace tribolog {
namespace {

constexpr std::size_t enough_to_keep_the_ends = 6;

}  // namespace

std::vector<std::size_t> groups_to_hold_out(const std::vector<CurveSample>& samples) {
  const std::size_t all = group_count(samples);
  const std::size_t end = all >= enough_to_keep_the_ends ? 1 : 0;
  std::vector<std::size_t> groups;
  for (std::size_t g = end; g + end < all; ++g) groups.push_back(g);
  return groups;
}

std::vector<double> held_out_errors(const CurveFit& all, const std::vector<CurveSample>& samples,
                                    const std::vector<std::size_t>& groups) {
  std::vector<double> errors;
  std::vector<CurveSample> kept;
  for (const std::size_t group : groups) {
    kept.clear();
    for (const CurveSample& s : samples) {
      if (s.group != group) kept.push_back(s);
    }
    const auto fit = fit_curve(all.model, kept, &all);
    if (!fit) return {};
    double squares = 0;
    double count = 0;
    for (const CurveSample& s : samples) {
      if (s.group != group) continue;
      squares += std::pow(fit->friction_Nm(s) - s.friction_Nm, 2);
      count += 1;
    }
    errors.push_back(squares / count);
  }
  return errors;
}

ErrorDifference difference(const std::vector<double>& one, const std::vector<double>& other) {
  const auto n = static_cast<double>(one.size());
  ErrorDifference out;
  for (std::size_t i = 0; i < one.size(); ++i) out.mean += (one[i] - other[i]) / n;
  double squares = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    squares += std::pow(one[i] - other[i] - out.mean, 2);
  }
  out.standard_error =
      n > 1 ? std::sqrt(squares / (n * (n - 1))) : std::numeric_limits<double>::infinity();
  return out;
}

double root_mean(const std::vector<double>& squares) {
  double sum = 0;
  for (const double s : squares) sum += s;
  return std::sqrt(sum / static_cast<double>(squares.size()));
}

}  // namespace tribolog
