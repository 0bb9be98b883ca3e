#include "method/model/joint_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include <Eigen/Dense>

#include "method/model/unlike_recordings.h"
#include "statistics/distributions.h"
#include "statistics/evidence.h"
#include "statistics/order_statistics.h"

namespace tribolog::method::model {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Kind = Effect::Kind;

constexpr Index fewest_cells = 12;
constexpr double cell_freedom = 6;  // of Student's t of a cell's noise
/// By which a Student's location is less certain than its weights, taken as known, say.
constexpr double beyond_weights = (cell_freedom + 3) / (cell_freedom + 1);
constexpr int rounds = 14;
// Sizes start at eighteen times their typical one: from small ones a large effect stays hidden
// behind others. What the laws miss starts at its typical one: a large one is rather another law.
constexpr double open = 0.003;
/// Rounds before which effects and laws are put up about what was found.
constexpr std::array put_up_at{0, 2, 4, 6, 8, 10, 12};

bool asks_size(const Effect& effect) {
  return effect.kind == Kind::effect || effect.kind == Kind::random;
}

/// Variance of a cell's noise: white per sample, and the same in each cell however many samples.
struct Noise {
  double white2{};
  double cell2{};
  double floor2{};
  double usual_white2{};  ///< From the samples' scatter: the centre of a prior.

  [[nodiscard]] ArrayXd of(const ArrayXd& count) const { return white2 / count + cell2 + floor2; }

  /// Towards the largest likelihood of Student cells with these mean squares.
  void improve(const ArrayXd& square, const ArrayXd& count) {
    constexpr int steps = 25;
    constexpr double prior_sd = 0.7;  // of log white
    for (int k = 0; k < steps; ++k) {
      const ArrayXd variance = of(count);
      const ArrayXd u = (cell_freedom + 1) / (cell_freedom + square / variance);
      const ArrayXd a = u * square / variance.square();
      const ArrayXd b = variance.inverse();
      const double pull =
          0.25 * std::log(white2 / usual_white2) / (prior_sd * prior_sd);  // by log variance
      const double up = 0.5 * white2 * (a / count).sum() + std::max(0.0, -pull);
      const double down = 0.5 * white2 * (b / count).sum() + std::max(0.0, pull);
      white2 *= std::clamp(std::sqrt(up / down), 0.3, 3.0);
      cell2 = std::max(cell2 * std::clamp(std::sqrt(a.sum() / b.sum()), 0.3, 3.0), 1e-6 * floor2);
    }
  }
};

/// Everything of one round: given sizes and noise, the evidence of each law.
class Solve {
 public:
  Solve(const JointModel& model, const MatrixXd& x, const MatrixXd& law_columns, const VectorXd& y,
        const ArrayXd& weight)
      : model_(model) {
    const Index p = x.cols();
    const ArrayXd root = weight.sqrt();
    const MatrixXd xw = root.matrix().asDiagonal() * x;
    const MatrixXd lw = root.matrix().asDiagonal() * law_columns;
    const VectorXd yw = (root * y.array()).matrix();
    MatrixXd gram = MatrixXd::Zero(p, p);
    gram.selfadjointView<Eigen::Lower>().rankUpdate(xw.transpose());
    for (std::size_t e = 0; e < model.effects.size(); ++e) {
      const EffectColumns& effect = model.effects[e];
      const double alpha = model.precision[static_cast<Index>(e)];
      for (Index k = 0; k < effect.scale.size(); ++k) {
        gram(model.first[e] + k, model.first[e] + k) += alpha / (effect.scale[k] * effect.scale[k]);
      }
    }
    const Eigen::LLT<MatrixXd> factor(gram.selfadjointView<Eigen::Lower>());
    b_ = xw.transpose() * yw;
    cross_ = xw.transpose() * lw;
    const MatrixXd half = factor.matrixL().solve(cross_);
    const VectorXd half_b = factor.matrixL().solve(b_);
    const Index plain = model.laws.dips_from;
    plain_ = lw.leftCols(plain).transpose() * lw - half.leftCols(plain).transpose() * half;
    own_ = (lw.colwise().squaredNorm() - half.colwise().squaredNorm()).transpose();
    right_ = lw.transpose() * yw - half.transpose() * half_b;
    inverse_ = factor.solve(MatrixXd::Identity(p, p));
    evidence_.reserve(model.laws.laws.size());
    for (const FrictionLaw& law : model.laws.laws) evidence_.push_back(evidence_of(law));
  }

  [[nodiscard]] const std::vector<double>& evidence() const { return evidence_; }
  [[nodiscard]] std::size_t likeliest() const {
    return static_cast<std::size_t>(std::max_element(evidence_.begin(), evidence_.end()) -
                                    evidence_.begin());
  }

  [[nodiscard]] LawPosterior posterior(std::size_t index) const {
    const FrictionLaw& law = model_.laws.laws[index];
    const auto count = static_cast<Index>(law.index.size());
    const Index p = inverse_.rows();
    MatrixXd b(p, count);
    for (Index k = 0; k < count; ++k) b.col(k) = cross_.col(law.index[static_cast<std::size_t>(k)]);
    const MatrixXd own = block_of(law).inverse();
    LawPosterior found;
    found.law = law;
    const VectorXd friction = own * right_of(law);
    const MatrixXd k = inverse_ * b;
    found.mean.resize(p + count);
    found.mean << inverse_ * b_ - k * friction, friction;
    found.covariance.resize(p + count, p + count);
    const MatrixXd between = -k * own;
    found.covariance.topLeftCorner(p, p) = inverse_ - between * k.transpose();
    found.covariance.topRightCorner(p, count) = between;
    found.covariance.bottomLeftCorner(count, p) = between.transpose();
    found.covariance.bottomRightCorner(count, count) = own;
    return found;
  }

 private:
  [[nodiscard]] MatrixXd block_of(const FrictionLaw& law) const {
    const auto count = static_cast<Index>(law.index.size());
    MatrixXd block(count, count);
    for (Index i = 0; i < count; ++i) {
      for (Index j = 0; j < count; ++j) {
        const auto [from, to] = std::minmax(law.index[static_cast<std::size_t>(i)],
                                            law.index[static_cast<std::size_t>(j)]);
        block(i, j) = from < plain_.rows() ? plain_(from, to) : own_[from];
      }
    }
    block.diagonal().array() += law.scale.array().square().inverse();
    return block;
  }
  [[nodiscard]] VectorXd right_of(const FrictionLaw& law) const { return right_(law.index); }

  [[nodiscard]] double evidence_of(const FrictionLaw& law) const {
    const MatrixXd block = block_of(law);
    const Eigen::LLT<MatrixXd> factor(block);
    const VectorXd right = right_of(law);
    const MatrixXd own = factor.solve(MatrixXd::Identity(block.rows(), block.cols()));
    const VectorXd mean = own * right;
    double sum = law.log_prior - law.scale.array().log().sum() -
                 factor.matrixLLT().diagonal().array().log().sum() + 0.5 * right.dot(mean);
    for (Index k = 0; k < mean.size(); ++k) {
      if (!law.is_positive[static_cast<std::size_t>(k)]) continue;
      sum += statistics::log_normal_probability(mean[k] / std::sqrt(own(k, k)));
    }
    return std::isfinite(sum) ? sum : -1e300;
  }

  const JointModel& model_;
  VectorXd b_;
  MatrixXd cross_;
  // Of the laws' columns, what effects do not explain: products of plain ones with all, and of each
  // with itself; no law has two dips.
  MatrixXd plain_;
  VectorXd own_;
  VectorXd right_;
  MatrixXd inverse_;
  std::vector<double> evidence_;
};

/// The cells' noise at first, from the scatter of their samples.
Noise first_noise(const Cells& cells, double top_Nm) {
  std::vector<double> scatter;
  for (const Cell& row : cells.rows) {
    if (std::isfinite(row.scatter_Nm)) scatter.push_back(row.scatter_Nm);
  }
  const double white =
      std::max(scatter.size() > 5 ? statistics::median(scatter) : 0.02 * top_Nm, 1e-4 * top_Nm);
  const double dark = 0.05 * white + 1e-4 * top_Nm;
  return {white * white, dark * dark, 1e-10 * top_Nm * top_Nm, white * white};
}

/// The likeliest laws' posteriors.
std::vector<LawPosterior> likely_posteriors(const Solve& solve) {
  constexpr std::size_t most_laws = 48;
  constexpr double least_share = 0.003;
  const double most = solve.evidence()[solve.likeliest()];
  std::vector<std::pair<double, std::size_t>> likely;
  double total = 0;
  for (std::size_t k = 0; k < solve.evidence().size(); ++k) {
    const double share = std::exp(solve.evidence()[k] - most);
    total += share;
    likely.emplace_back(share, k);
  }
  std::sort(likely.rbegin(), likely.rend());
  std::vector<LawPosterior> posteriors;
  double kept = 0;
  for (const auto& [share, k] : likely) {
    if (posteriors.size() >= most_laws || share < least_share * total) break;
    posteriors.push_back(solve.posterior(k));
    posteriors.back().weight = share;
    kept += share;
  }
  for (LawPosterior& one : posteriors) one.weight /= kept;
  return posteriors;
}

/// The fit of one joint, round by round.
class Fit {
 public:
  Fit(const Cells& cells, bool has_gravity, const joint::EffectSizes& sizes)
      : has_gravity_(has_gravity) {
    m_.cells = cells;
    m_.sizes = sizes;
    // Cells of a stroke one after the other: neighbours' noise is correlated.
    std::stable_sort(m_.cells.rows.begin(), m_.cells.rows.end(), [](const Cell& a, const Cell& b) {
      return std::pair(a.stroke, a.time_s) < std::pair(b.stroke, b.time_s);
    });
    m_.point = first_point(m_.cells, has_gravity);
    count_ = m_.cells.of(&Cell::count);
    y_ = m_.cells.of(&Cell::torque_Nm).matrix();
    for (const Cell& row : m_.cells.rows) stroke_.push_back(row.stroke);
    noise_ = first_noise(m_.cells, m_.point.top_Nm);
    m_.weight = ArrayXd::Ones(y_.size());
  }

  JointModel run() {
    for (int round = 0;; ++round) {
      if (std::find(put_up_at.begin(), put_up_at.end(), round) != put_up_at.end()) put_up();
      const ArrayXd variance = noise_.of(count_);
      const Solve solve(m_, x_, law_columns_, y_,
                        m_.weight / (variance * m_.samples_per_independent * beyond_weights));
      const LawPosterior found = solve.posterior(solve.likeliest());
      MatrixXd full(y_.size(), found.mean.size());
      full << x_, law_columns_(Eigen::all, found.law.index);
      m_.residual_Nm = (y_ - full * found.mean).array();
      if (round == rounds - 1) {
        m_.posteriors = likely_posteriors(solve);
        return std::move(m_);
      }
      if (std::find(put_up_at.begin(), put_up_at.end(), round + 1) != put_up_at.end()) {
        look_nearer(solve);
      }
      improve_noise(m_.residual_Nm.square() +
                    ((full * found.covariance).array() * full.array()).rowwise().sum());
      improve_sizes(found);
      move_point(found);
    }
  }

 private:
  /// Effects and laws about the present point.
  void put_up() {
    m_.effects = effect_columns(m_.cells, has_gravity_, m_.point, m_.sizes);
    m_.hats = law_hats(m_.cells, m_.point);
    m_.laws = candidate_laws(m_.cells, m_.point, dips_);
    law_columns_ = m_.laws.torque(m_.cells);
    m_.first = {0};
    for (const EffectColumns& e : m_.effects) {
      m_.first.push_back(m_.first.back() + e.columns.cols());
    }
    x_.resize(y_.size(), m_.first.back());
    m_.precision.resize(static_cast<Index>(m_.effects.size()));
    for (std::size_t e = 0; e < m_.effects.size(); ++e) {
      const Effect& effect = *m_.effects[e].effect;
      x_.middleCols(m_.first[e], m_.width(e)) = m_.effects[e].columns;
      const auto known = known_precision_.find(effect.key);
      m_.precision[static_cast<Index>(e)] = !asks_size(effect)                ? 1
                                            : known != known_precision_.end() ? known->second
                                            : effect.key == joint::effect::law_misfit.key
                                                ? 1
                                                : std::max(open, effect.least_precision());
    }
  }

  /// Mean and standard deviation of the logarithm of a dip's parameter, by the evidence.
  struct LogMean {
    double mean{};
    double sd{};
  };
  /// Absent: of none. @param laws a place each.
  [[nodiscard]] std::optional<LogMean> log_mean_of_dips(const Solve& solve,
                                                        const std::vector<std::size_t>& laws,
                                                        double LawColumn::* parameter) const {
    if (laws.empty()) return std::nullopt;
    double most = -std::numeric_limits<double>::infinity();
    for (const std::size_t k : laws) most = std::max(most, solve.evidence()[k]);
    double total = 0;
    double sum = 0;
    double square = 0;
    for (const std::size_t k : laws) {
      const double share = std::exp(solve.evidence()[k] - most);
      const double value = std::log(m_.laws.laws[k].dip.*parameter);
      total += share;
      sum += share * value;
      square += share * value * value;
    }
    const double mean = sum / total;
    return LogMean{mean, std::sqrt(std::max(0.0, square / total - mean * mean))};
  }

  /// Of the speeds of one grid, where the evidence is narrower than the grid: by the parabola
  /// through the likeliest and its neighbours. Absent: it lies at an end.
  [[nodiscard]] std::optional<LogMean> between_dips(const Solve& solve,
                                                    const std::vector<std::size_t>& laws) const {
    std::map<double, double> evidence;  // over the logarithm of the speed
    for (const std::size_t k : laws) {
      evidence[std::log(m_.laws.laws[k].dip.dip_speed)] = solve.evidence()[k];
    }
    const auto at =
        std::max_element(evidence.begin(), evidence.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    if (at == evidence.end() || at == evidence.begin() || std::next(at) == evidence.end()) {
      return std::nullopt;
    }
    const double step = std::next(at)->first - at->first;
    const double before = std::prev(at)->second - at->second;
    const double after = std::next(at)->second - at->second;
    const double bend = before + after;
    if (!(bend < 0)) return std::nullopt;
    return LogMean{at->first + step * (before - after) / (2 * bend), step / std::sqrt(-bend)};
  }

  /// Dips of a grid about the likeliest, as far as their evidence reaches.
  /// @param laws those of the grid. @param is_resolved false where the grid is coarser than that.
  [[nodiscard]] DipGrid nearer(const Solve& solve, const DipGrid& grid,
                               const std::vector<std::size_t>& laws, bool& is_resolved) const {
    auto found = log_mean_of_dips(solve, laws, &LawColumn::dip_speed);
    if (!found) return grid;
    if (found->sd > coarse_dip_step) return {grid.power};
    const double step = grid.step();
    double half_span = std::max(dips_each_side * found->sd, step);
    if (found->sd < step / 3) {
      is_resolved = false;
      if (const auto between = between_dips(solve, laws)) {
        found = between;
        constexpr double most = 6;  // a parabola no further
        half_span = dips_each_side * std::max(between->sd, step / most);
      } else if (grid.near_rad_s > 0) {
        half_span = grid.half_span;  // at an end, and perhaps beyond
      }
    }
    return {grid.power, std::exp(found->mean), half_span};
  }

  /// Speeds of dips, and their powers once the speeds are found.
  void look_nearer(const Solve& solve) {
    const FrictionLaw& best = m_.laws.laws[solve.likeliest()];
    if (!best.has_dip) {
      dips_ = coarse_dips();
      return;
    }
    bool is_resolved = true;
    std::vector<std::size_t> all;
    for (std::size_t form = 0; form < dips_.size(); ++form) {
      for (DipGrid& grid : dips_[form]) {
        std::vector<std::size_t> laws;
        for (std::size_t k = 0; k < m_.laws.laws.size(); ++k) {
          const FrictionLaw& law = m_.laws.laws[k];
          if (law.has_dip && law.form == form && law.dip.dip_power == grid.power) laws.push_back(k);
        }
        all.insert(all.end(), laws.begin(), laws.end());
        const bool is_best = form == best.form && grid.power == best.dip.dip_power;
        bool is_near = true;
        grid = nearer(solve, grid, laws, is_near);
        if (is_best && !is_near) is_resolved = false;
      }
    }
    constexpr double coarse_step = 0.35;
    constexpr double finest_step = 0.06;
    constexpr int each_side = 2;
    const auto of_power = log_mean_of_dips(solve, all, &LawColumn::dip_power);
    if (!is_resolved || !of_power || of_power->sd > coarse_step) return;
    const double finer_step =
        std::clamp(of_power->sd, std::max(finest_step, power_step_ / 3), coarse_step);
    const std::vector<DipGrid>& found = dips_[best.form];
    const bool is_in_the_middle =
        found.size() == 2 * each_side + 1 && found[each_side].power == best.dip.dip_power;
    constexpr double alike = 1.5;
    if (is_in_the_middle && power_step_ < alike * finer_step && finer_step < alike * power_step_) {
      return;
    }
    power_step_ = finer_step;
    for (std::vector<DipGrid>& grids : dips_) {
      std::vector<DipGrid> finer;
      for (int k = -each_side; k <= each_side; ++k) {
        const double power = best.dip.dip_power * std::exp(k * power_step_);
        if (least_dip_power < power && power < most_dip_power) {
          finer.push_back(between_powers(grids, k == 0 ? best.dip.dip_power : power));
        }
      }
      grids = std::move(finer);
    }
  }

  /// A grid for this power, its speeds between those of the powers about it.
  [[nodiscard]] static DipGrid between_powers(const std::vector<DipGrid>& grids, double power) {
    // Ascending powers; beyond the last one as it is between the last two.
    const auto same = std::find_if(grids.begin(), grids.end(),
                                   [&](const DipGrid& one) { return one.power == power; });
    if (same != grids.end()) return *same;
    std::size_t above = 1;
    while (above + 1 < grids.size() && grids[above].power < power) ++above;
    const DipGrid& a = grids[above - 1];
    const DipGrid& b = grids[above];
    if (!(a.near_rad_s > 0 && b.near_rad_s > 0)) return {power};
    constexpr double of_the_way = 0.2;  // speeds are no straight line over powers
    const double way = std::log(b.near_rad_s / a.near_rad_s);
    const double share = std::log(power / a.power) / std::log(b.power / a.power);
    return {power, a.near_rad_s * std::exp(share * way),
            std::max(std::min(a.half_span, b.half_span), of_the_way * std::abs(way))};
  }

  /// And the cells' weights and correlation. @param square mean squares of the residuals.
  void improve_noise(const ArrayXd& square) {
    noise_.improve(square, count_);
    const ArrayXd variance = noise_.of(count_);
    m_.weight = (cell_freedom + 1) / (cell_freedom + square / variance);
    ArrayXd standardised = m_.residual_Nm / variance.sqrt();
    const std::size_t random = m_.find("friction_of_recording");
    if (random < m_.effects.size()) {  // its own: no correlation of neighbours
      const MatrixXd& own = m_.effects[random].columns;
      const ArrayXd of_each = own.array().square().colwise().sum().max(1e-12).transpose();
      standardised -=
          (own * ((own.transpose() * standardised.matrix()).array() / of_each).matrix()).array();
    }
    constexpr Index most = 12;    // cells of a stroke
    constexpr Index fewest = 20;  // pairs
    m_.samples_per_independent = statistics::integrated_autocorrelation(
        standardised.max(-4.0).min(4.0).matrix(), most, fewest, [&](Index i, Index lag) {
          return stroke_[static_cast<std::size_t>(i)] == stroke_[static_cast<std::size_t>(i - lag)];
        });
  }

  void improve_sizes(const LawPosterior& found) {
    for (std::size_t e = 0; e < m_.effects.size(); ++e) {
      const Effect& effect = *m_.effects[e].effect;
      if (!asks_size(effect)) continue;
      const Index own = m_.width(e);
      double& alpha = m_.precision[static_cast<Index>(e)];
      alpha = statistics::next_precision(found.mean.segment(m_.first[e], own),
                                         found.covariance.diagonal().segment(m_.first[e], own),
                                         m_.effects[e].scale, alpha, effect.dof,
                                         effect.least_precision());
      known_precision_[effect.key] = alpha;
    }
  }

  /// To what was found.
  void move_point(const LawPosterior& found) {
    const auto value_of = [&](std::string_view key, Index k) {
      const std::size_t e = m_.find(key);
      return e < m_.effects.size() ? found.mean[m_.first[e] + k] : 0.0;
    };
    Point& p = m_.point;
    if (has_gravity_) {
      p.gravity_cos_Nm = value_of("gravity", 0);
      p.gravity_sin_Nm = value_of("gravity", 1);
    }
    p.inertia_kgm2 = value_of("inertia", 0);
    // One that no acceleration shows is none: else jumps of the acceleration would tell of a lag.
    if (const std::size_t e = m_.find("inertia"); e < m_.effects.size()) {
      constexpr double least_certainty = 2;
      const double unknown = std::pow(least_certainty / p.inertia_kgm2, 2) *
                             found.covariance(m_.first[e], m_.first[e]);
      p.inertia_kgm2 *= std::max(0.0, 1 - unknown);
    }
    const VectorXd law = found.friction();
    p.coulomb_Nm = law[0];
    p.viscous_Nms_rad = found.law.meanings[1].row(1) * law;
    p.dip_Nm = found.law.has_dip ? law[law.size() - 1] : 0;
    p.dip_speed_rad_s = found.law.has_dip ? found.law.dip.dip_speed : 0;
    p.dip_power = found.law.has_dip ? found.law.dip.dip_power : 1;
    const ArrayXd friction = (law_columns_(Eigen::all, found.law.index) * law).array().abs();
    p.friction_Nm = std::clamp(median(friction), 0.03 * p.top_Nm, p.top_Nm);
  }

  bool has_gravity_;
  JointModel m_;
  ArrayXd count_;
  VectorXd y_;
  std::vector<int> stroke_;
  Noise noise_;
  std::map<std::string_view, double> known_precision_;
  std::vector<std::vector<DipGrid>> dips_{coarse_dips()};
  double power_step_{0.35};  // of their logarithm
  MatrixXd x_;
  MatrixXd law_columns_;
};

}  // namespace

std::size_t JointModel::find(std::string_view key) const {
  for (std::size_t e = 0; e < effects.size(); ++e) {
    if (effects[e].effect->key == key) return e;
  }
  return effects.size();
}

bool JointModel::is_finite() const {
  return precision.allFinite() && residual_Nm.allFinite() && weight.allFinite() &&
         std::isfinite(samples_per_independent) &&
         std::all_of(posteriors.begin(), posteriors.end(), [](const LawPosterior& p) {
           return std::isfinite(p.weight) && p.mean.allFinite() && p.covariance.allFinite();
         });
}

JointModel fit_joint_model(const Cells& cells, bool has_gravity, const joint::EffectSizes& sizes) {
  if (cells.size() < fewest_cells) return {};
  std::set<int> recordings;
  for (const Cell& row : cells.rows) recordings.insert(row.recording);
  const auto without = [&](const std::vector<int>& out) {
    return cells.select([&](const Cell& row) {
      return std::find(out.begin(), out.end(), row.recording) == out.end();
    });
  };
  std::vector<int> out = foreign_recordings(cells);
  if (out.size() > recordings.size() / 3) out.clear();
  JointModel m = Fit(without(out), has_gravity, sizes).run();
  if (!m.is_finite()) return {};
  constexpr int most_times = 3;
  for (int k = 0; k < most_times; ++k) {
    const std::vector<int> unlike = unlike_recordings(m);
    if (unlike.empty() || out.size() + unlike.size() > recordings.size() / 3) break;
    out.insert(out.end(), unlike.begin(), unlike.end());
    m = Fit(without(out), has_gravity, sizes).run();
  }
  if (!m.is_finite()) return {};
  m.left_out = std::move(out);
  return m;
}

}  // namespace tribolog::method::model
