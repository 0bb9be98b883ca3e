#include "method/hysteresis/ramp_mean.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "statistics/distributions.h"
#include "statistics/linear_systems.h"

namespace tribolog::method::hysteresis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using joint::effect::motor_turn;

constexpr std::size_t most_orders = 6;
constexpr Index common = 4;   // columns of what shifts all ramps
constexpr double never = 10;  // nats below the likeliest: less is left out

/// Of a geometric progression.
std::vector<double> geometric(double from, double to, int count) {
  std::vector<double> all;
  for (int k = 0; k < count; ++k) {
    all.push_back(from * std::pow(to / from, static_cast<double>(k) / (count - 1)));
  }
  return all;
}

/// Sums over the ramps that broke away at one position.
struct AtPosition {
  double count{};
  double held_Nm{};
  VectorXd columns;
};

/// The directions' means for given sizes of u and e; of one direction, the second says nothing.
struct Conditional {
  double log_weight{};  ///< Without the bounds.
  double log_bounds{};  ///< Their probability at the mean.
  [[nodiscard]] double log_likely() const { return log_weight + log_bounds; }
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();
  double scatter_Nm{};     ///< Size of e.
  double sd_Nm{};          ///< Of one ramp about the mean.
  double between_sd_Nm{};  ///< Of what the positions differ by.
};

/// A value of both directions (of one, where ramps have that alone) with its probability.
struct Node {
  double rising_Nm{};
  double falling_Nm{};
  double weight{};  ///< Its logarithm, until all nodes are known.
};

class RampModel {
 public:
  RampModel(const std::vector<RampRow>& rows, const FrictionOverTurn& over_turn);

  [[nodiscard]] bool empty() const { return directions_ == 0; }
  [[nodiscard]] RampMeans describe();

 private:
  void choose_directions();
  void put_up(const FrictionOverTurn& over_turn);
  [[nodiscard]] std::vector<Conditional> over_sizes() const;
  [[nodiscard]] std::vector<Conditional> on_grid(const std::vector<double>& scatters_Nm) const;
  [[nodiscard]] Conditional given(double scatter_Nm, double turn_Nm) const;
  [[nodiscard]] double between_sd_Nm(const VectorXd& found, double turn, double noise) const;
  void spread(const Conditional& one);
  void weigh_nodes();
  [[nodiscard]] Index column_of(const RampRow& row) const;
  [[nodiscard]] bool has(const RampRow& row) const;
  [[nodiscard]] double log_probability_of_bounds(double rising_Nm, double falling_Nm,
                                                 double sd_Nm) const;
  [[nodiscard]] statistics::Estimate estimate_of(double rising, double falling) const;

  std::vector<RampRow> broken_;  ///< Those that broke away, in a direction that has a mean.
  std::vector<RampRow> bounds_;
  bool has_rising_{};
  bool has_falling_{};
  Index directions_{};
  double size_Nm_{};  ///< Of the friction.
  double share_of_turn_{};
  VectorXd prior_precision_;  ///< Of each column.
  MatrixXd products_;         ///< Of columns and held torque with one another.
  std::vector<AtPosition> positions_;
  double variance_of_orders_Nm2_{};
  std::vector<Node> nodes_;
};

RampModel::RampModel(const std::vector<RampRow>& rows, const FrictionOverTurn& over_turn)
    : broken_(rows), share_of_turn_(over_turn.share) {
  choose_directions();
  if (!empty()) put_up(over_turn);
}

bool RampModel::has(const RampRow& row) const { return row.is_rising ? has_rising_ : has_falling_; }

Index RampModel::column_of(const RampRow& row) const {
  return row.is_rising || !has_rising_ ? 0 : 1;
}

void RampModel::choose_directions() {
  constexpr auto fewest = 2;
  const auto count = [&](bool is_rising) {
    return std::count_if(broken_.begin(), broken_.end(), [&](const RampRow& row) {
      return row.broke_away && row.is_rising == is_rising;
    });
  };
  has_rising_ = count(true) >= fewest;
  has_falling_ = count(false) >= fewest;
  directions_ = static_cast<Index>(has_rising_) + static_cast<Index>(has_falling_);
  std::vector<RampRow> all;
  all.swap(broken_);
  for (const RampRow& row : all) {
    if (has(row)) (row.broke_away ? broken_ : bounds_).push_back(row);
  }
}

void RampModel::put_up(const FrictionOverTurn& over_turn) {
  const auto n = static_cast<Index>(broken_.size());
  VectorXd held_Nm(n);
  for (Index i = 0; i < n; ++i) held_Nm(i) = broken_[static_cast<std::size_t>(i)].held_Nm;
  constexpr double least = 1e-3;  // of what they hold, where gravity is in it
  size_Nm_ = std::max(std::abs(held_Nm.mean()), least * held_Nm.cwiseAbs().maxCoeff());
  const std::size_t orders = std::min(over_turn.orders.size(), most_orders);
  const Index width = directions_ + 2 * static_cast<Index>(orders) + common;
  const double elsewhere_Nm = statistics::normal_975 * over_turn.elsewhere * size_Nm_;
  prior_precision_ = VectorXd::Zero(width);
  MatrixXd columns = MatrixXd::Zero(n, width);
  std::size_t last = 0;
  for (Index i = 0; i < n; ++i) {
    const RampRow& row = broken_[static_cast<std::size_t>(i)];
    last = std::max(last, row.position);
    columns(i, column_of(row)) = 1;
    for (std::size_t k = 0; k < orders; ++k) {
      const Index at = directions_ + 2 * static_cast<Index>(k);
      const double phase = over_turn.orders[k].periods_per_turn * row.motor_angle_rad;
      columns(i, at) = std::cos(phase);
      columns(i, at + 1) = std::sin(phase);
    }
    columns.row(i).tail<common>() << row.gravity_Nm, row.inertia_Nm, row.damping_Nm, elsewhere_Nm;
  }
  // A normal distribution that is as wide as all orders at phases of their own.
  std::vector<double> amplitudes;
  double squares = 0;
  for (std::size_t k = 0; k < orders; ++k) {
    amplitudes.push_back(over_turn.orders[k].amplitude_Nm * size_Nm_);
    squares += amplitudes.back() * amplitudes.back();
  }
  const double widest = gravity::random_phase_half_width(amplitudes, 0) / statistics::normal_975;
  variance_of_orders_Nm2_ = widest * widest;
  for (std::size_t k = 0; k < orders; ++k) {
    const double share = amplitudes[k] * amplitudes[k] / squares;
    prior_precision_.segment<2>(directions_ + 2 * static_cast<Index>(k))
        .setConstant(1 / (share * variance_of_orders_Nm2_));
  }
  prior_precision_.tail<common>().setConstant(std::pow(statistics::normal_975, 2));
  MatrixXd all(n, width + 1);
  all << columns, held_Nm;
  products_ = all.transpose() * all;
  positions_.assign(last + 1, {0, 0, VectorXd::Zero(width)});
  for (Index i = 0; i < n; ++i) {
    AtPosition& at = positions_[broken_[static_cast<std::size_t>(i)].position];
    at.count += 1;
    at.held_Nm += held_Nm(i);
    at.columns += columns.row(i).transpose();
  }
}

double RampModel::log_probability_of_bounds(double rising_Nm, double falling_Nm,
                                            double sd_Nm) const {
  double sum = 0;
  for (const RampRow& row : bounds_) {
    const double level_Nm = row.is_rising ? rising_Nm : falling_Nm;
    sum += statistics::log_normal_probability((level_Nm - row.held_Nm) / sd_Nm);
  }
  return sum;
}

/// Nodes of a normal distribution of the directions, with the probability of the bounds.
void RampModel::spread(const Conditional& one) {
  const Eigen::Matrix2d root = one.covariance.llt().matrixL();
  constexpr double widest = 4.2;  // standard deviations
  const int half = directions_ == 1 ? 40 : 12;
  const int across = directions_ == 1 ? 0 : half;
  const double step = widest / half;
  for (int a = -half; a <= half; ++a) {
    for (int b = -across; b <= across; ++b) {
      const Eigen::Vector2d off{step * a, step * b};
      const double log_weight = one.log_weight - off.squaredNorm() / 2;
      if (bounds_.empty() && log_weight < -never) continue;
      const Eigen::Vector2d at = one.mean + root * off;
      const double falling_Nm = directions_ == 1 ? at(0) : at(1);
      nodes_.push_back({at(0), falling_Nm,
                        log_weight + log_probability_of_bounds(at(0), falling_Nm, one.sd_Nm)});
    }
  }
}

/// Logarithms become weights; what is next to nothing goes.
void RampModel::weigh_nodes() {
  double largest = -std::numeric_limits<double>::infinity();
  for (const Node& node : nodes_) largest = std::max(largest, node.weight);
  std::vector<Node> likely;
  for (const Node& node : nodes_) {
    if (node.weight < largest - never) continue;
    likely.push_back({node.rising_Nm, node.falling_Nm, std::exp(node.weight - largest)});
  }
  nodes_.swap(likely);
}

/// The posterior of all coefficients, and its evidence.
Conditional RampModel::given(double scatter_Nm, double turn_Nm) const {
  const Index width = prior_precision_.size();
  const double noise = scatter_Nm * scatter_Nm;
  const double turn = turn_Nm * turn_Nm;
  // u of a position, taken out of its sums: what is left of them is known to its scatter.
  MatrixXd products = products_;
  double log_determinant = static_cast<double>(broken_.size()) * std::log(noise);
  VectorXd sums(width + 1);
  for (const AtPosition& at : positions_) {
    const double all = noise + at.count * turn;
    sums << at.columns, at.held_Nm;
    products.noalias() -= turn / all * sums * sums.transpose();
    log_determinant += std::log(all / noise);
  }
  products /= noise;
  MatrixXd precision = products.topLeftCorner(width, width);
  precision.diagonal() += prior_precision_;
  const statistics::CholeskyFactor factor(precision);
  const VectorXd right = products.col(width).head(width);
  const VectorXd found = factor.solve(right);
  log_determinant += 2 * factor.half_log_determinant();
  const MatrixXd covariance = factor.solve(MatrixXd::Identity(width, directions_));
  Conditional out;
  out.scatter_Nm = scatter_Nm;
  out.log_weight = -(log_determinant + products(width, width) - right.dot(found)) / 2;
  out.mean.head(directions_) = found.head(directions_);
  out.covariance.topLeftCorner(directions_, directions_) = covariance.topRows(directions_);
  out.sd_Nm = std::sqrt(noise + turn + variance_of_orders_Nm2_);
  out.log_bounds = log_probability_of_bounds(
      out.mean(0), directions_ == 1 ? out.mean(0) : out.mean(1), out.sd_Nm);
  out.between_sd_Nm = between_sd_Nm(found, turn, noise);
  return out;
}

/// By u and the orders, as far as the ramps show them.
double RampModel::between_sd_Nm(const VectorXd& found, double turn, double noise) const {
  const Index orders = prior_precision_.size() - directions_ - common;
  double count = 0;
  double sum = 0;
  double squares = 0;
  for (const AtPosition& at : positions_) {
    if (at.count == 0) continue;
    const double own = turn / (noise + at.count * turn) * (at.held_Nm - at.columns.dot(found));
    const double of_orders =
        at.columns.segment(directions_, orders).dot(found.segment(directions_, orders)) / at.count;
    count += 1;
    sum += own + of_orders;
    squares += std::pow(own + of_orders, 2);
  }
  return count < 2 ? 0 : std::sqrt(std::max(0.0, squares - sum * sum / count) / (count - 1));
}

/// For sizes of u and e on a grid: those that may be, the largest weight 1.
std::vector<Conditional> RampModel::on_grid(const std::vector<double>& scatters_Nm) const {
  std::vector<double> lambdas{0};
  if (share_of_turn_ > 0) lambdas = geometric(0.1, motor_turn.cap, 8);
  std::vector<Conditional> all;
  double largest = -std::numeric_limits<double>::infinity();
  for (const double lambda : lambdas) {
    const double log_prior =
        lambda == 0 ? 0 : -motor_turn.dof * (std::log(lambda) + 0.5 / (lambda * lambda));
    for (const double scatter : scatters_Nm) {
      all.push_back(given(scatter, lambda * share_of_turn_ * size_Nm_));
      all.back().log_weight += log_prior;
      largest = std::max(largest, all.back().log_likely());
    }
  }
  all.erase(
      std::remove_if(all.begin(), all.end(),
                     [&](const Conditional& one) { return one.log_likely() < largest - never; }),
      all.end());
  for (Conditional& one : all) one.log_weight -= largest;
  return all;
}

/// Scatter: by as much as data say; of ramps without any, next to none.
std::vector<Conditional> RampModel::over_sizes() const {
  constexpr int coarse = 10;
  constexpr int fine = 16;
  double largest_Nm = size_Nm_;
  for (const RampRow& row : bounds_) largest_Nm = std::max(largest_Nm, row.held_Nm);
  const std::vector<double> wide = geometric(1e-4 * size_Nm_, 0.3 * largest_Nm, coarse);
  double least = wide.back();
  double most = wide.front();
  for (const Conditional& one : on_grid(wide)) {
    least = std::min(least, one.scatter_Nm);
    most = std::max(most, one.scatter_Nm);
  }
  const double step = wide[1] / wide[0];  // what may be begins or ends within it
  return on_grid(
      geometric(std::max(wide.front(), least / step), std::min(wide.back(), most * step), fine));
}

statistics::Estimate RampModel::estimate_of(double rising, double falling) const {
  std::vector<std::pair<double, double>> all;
  double weights = 0;
  double mean = 0;
  for (const Node& node : nodes_) {
    all.emplace_back(rising * node.rising_Nm + falling * node.falling_Nm, node.weight);
    weights += node.weight;
    mean += node.weight * all.back().first;
  }
  std::sort(all.begin(), all.end());
  // A node's probability is about its value, half of it below.
  const auto quantile = [&](double share) {
    double sum = 0;
    double last = 0;
    double last_value = all.front().first;
    for (const auto& [value, weight] : all) {
      const double below = (sum + weight / 2) / weights;
      if (below >= share) {
        return below > last ? std::lerp(last_value, value, (share - last) / (below - last)) : value;
      }
      sum += weight;
      last = below;
      last_value = value;
    }
    return all.back().first;
  };
  constexpr double outside = 0.025;
  return {mean / weights, quantile(outside), quantile(1 - outside), {}};
}

RampMeans RampModel::describe() {
  RampMeans out;
  double weights = 0;
  for (const Conditional& one : over_sizes()) {
    spread(one);
    const double weight = std::exp(one.log_likely());
    weights += weight;
    out.between_positions += weight * one.between_sd_Nm / size_Nm_;
  }
  out.between_positions /= weights;
  weigh_nodes();
  if (has_rising_) out.rising_Nm = estimate_of(1, 0);
  if (has_falling_) out.falling_Nm = estimate_of(0, 1);
  if (has_rising_ && has_falling_) out.both_Nm = estimate_of(0.5, 0.5);
  for (const AtPosition& at : positions_) out.positions += at.count > 0 ? 1 : 0;
  return out;
}

}  // namespace

RampMeans mean_of_ramps(const std::vector<RampRow>& rows, const FrictionOverTurn& over_turn) {
  RampModel model(rows, over_turn);
  return model.empty() ? RampMeans{} : model.describe();
}

}  // namespace tribolog::method::hysteresis
