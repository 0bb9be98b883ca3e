#include "method/gravity/sweep_load.h"

#include <cmath>

#include <Eigen/Dense>

namespace tribolog {
namespace {

constexpr std::size_t fewest_strokes = 4;
constexpr double standard_errors = 2.0;

void fill_load_column(const std::vector<const Recording*>& recordings, const SweepSamples& samples,
                      double q_peak, SweepDesign& d) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    d.x(static_cast<Eigen::Index>(i), d.load) =
        samples.direction[i] * std::abs(std::cos(angle_of(recordings, samples, i) - q_peak));
  }
}

/// Mean squared error of each stroke, from a fit to the other strokes. Normal equations of scaled
/// columns: a sweep has few, and they differ.
std::vector<double> held_out_strokes(const Eigen::MatrixXd& x, const Eigen::VectorXd& y,
                                     const std::vector<std::size_t>& stroke) {
  const Eigen::VectorXd norms =
      x.colwise().norm().transpose().unaryExpr([](double n) { return n > 0 ? n : 1.0; });
  const Eigen::MatrixXd scaled = x * norms.cwiseInverse().asDiagonal();
  const Eigen::MatrixXd all = scaled.transpose() * scaled;
  const Eigen::VectorXd all_y = scaled.transpose() * y;
  std::vector<double> errors;
  for (std::size_t first = 0; first < stroke.size();) {
    std::size_t last = first;
    while (last < stroke.size() && stroke[last] == stroke[first]) ++last;
    const auto from = static_cast<Eigen::Index>(first);
    const auto rows = static_cast<Eigen::Index>(last - first);
    const Eigen::MatrixXd part = scaled.middleRows(from, rows);
    const Eigen::VectorXd c = (all - part.transpose() * part)
                                  .ldlt()
                                  .solve(all_y - part.transpose() * y.segment(from, rows));
    errors.push_back((y.segment(from, rows) - part * c).squaredNorm() / static_cast<double>(rows));
    first = last;
  }
  return errors;
}

bool pays(const std::vector<double>& without, const std::vector<double>& with) {
  const auto n = static_cast<double>(with.size());
  double mean = 0;
  for (std::size_t k = 0; k < with.size(); ++k) mean += (without[k] - with[k]) / n;
  double squares = 0;
  for (std::size_t k = 0; k < with.size(); ++k) squares += std::pow(without[k] - with[k] - mean, 2);
  return mean > standard_errors * std::sqrt(squares / (n * (n - 1)));
}

}  // namespace

SweepGravityFit with_load_where_it_pays(const std::vector<const Recording*>& recordings,
                                        const SweepSamples& samples, SweepDesign& design,
                                        double middle_rad, const std::vector<std::size_t>& blocks,
                                        const SweepGravityFit& fit) {
  const bool has_strokes = !samples.stroke.empty() && samples.stroke.back() + 1 >= fewest_strokes;
  if (design.direction < 0 || samples.constant_speed || !has_strokes) return fit;
  SweepDesign with = design;
  with.load = with.x.cols();
  with.x.conservativeResize(Eigen::NoChange, with.load + 1);
  double q_peak = fit.q_peak_rad.value;
  SweepGravityFit better;
  for (int iteration = 0; iteration < 10; ++iteration) {
    fill_load_column(recordings, samples, q_peak, with);
    better = fit_amplitude_and_angle(recordings, samples, with, middle_rad, blocks);
    const double step = better.q_peak_rad.value - q_peak;
    q_peak = better.q_peak_rad.value;
    if (std::abs(step) < 1e-9) break;
  }
  if (!(better.regression.coefficients(with.load) > 0)) return fit;
  if (!pays(held_out_strokes(design.x, design.y, samples.stroke),
            held_out_strokes(with.x, with.y, samples.stroke))) {
    return fit;
  }
  design = with;
  return better;
}

}  // namespace tribolog
