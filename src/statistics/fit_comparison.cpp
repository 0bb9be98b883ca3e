#include "statistics/fit_comparison.h"

#include <cmath>
#include <map>

#include "statistics/distributions.h"

namespace tribolog::statistics {

bool leaves_less(const Eigen::VectorXd& first, const Eigen::VectorXd& second,
                 const std::vector<std::size_t>& block_of_row, double least_gain) {
  if (!(first.norm() < (1 - least_gain) * second.norm())) return false;
  struct Squares {
    double first{}, second{};
  };
  std::map<std::size_t, Squares> squares_of_block;
  for (Eigen::Index i = 0; i < first.size(); ++i) {
    Squares& of_block = squares_of_block[block_of_row[static_cast<std::size_t>(i)]];
    of_block.first += first(i) * first(i);
    of_block.second += second(i) * second(i);
  }
  std::vector<double> gains;
  for (const auto& [block, squares] : squares_of_block) {
    if (squares.first > 0 && squares.second > 0) {
      gains.push_back(std::log(squares.second / squares.first));
    }
  }
  const auto count = static_cast<double>(gains.size());
  if (count < 2) return false;
  double mean = 0;
  for (const double gain : gains) mean += gain / count;
  double variance = 0;
  for (const double gain : gains) variance += (gain - mean) * (gain - mean) / (count - 1);
  return mean > student_t_975(count - 1) * std::sqrt(variance / count);
}

}  // namespace tribolog::statistics
