#include "method/model/joint_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include <Eigen/Core>

#include "method/model/dip_search.h"
#include "method/model/unlike_recordings.h"
#include "statistics/distributions.h"
#include "statistics/evidence.h"
#include "statistics/linear_systems.h"
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
/// Round after which residuals may be correlated. What effects and laws explain only once their
/// sizes are found correlates at first, and would count for less and less as noise.
constexpr int correlated_from = 5;
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

/// Of the effects' sizes, and of the coefficients' scales at these.
double log_prior_of_sizes(const JointModel& model) {
  double sum = 0;
  for (std::size_t e = 0; e < model.effects.size(); ++e) {
    const Effect& effect = *model.effects[e].effect;
    const double alpha = model.precision[static_cast<Index>(e)];
    sum += 0.5 * static_cast<double>(model.width(e)) * std::log(alpha);
    if (asks_size(effect)) sum += 0.5 * effect.dof * (std::log(alpha) - alpha);
  }
  return sum;
}

/// Everything of one round: given sizes and noise, the evidence of each law.
class Solve {
 public:
  Solve(const JointModel& model, const MatrixXd& x, const MatrixXd& law_columns, const VectorXd& y,
        const ArrayXd& weight)
      : model_(&model) {
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
    const statistics::CholeskyFactor factor(gram);
    b_ = xw.transpose() * yw;
    cross_ = xw.transpose() * lw;
    const MatrixXd half = factor.solve_half(cross_);
    const VectorXd half_b = factor.solve_half(b_);
    const Index plain = model.laws.dips_from;
    plain_ = lw.leftCols(plain).transpose() * lw - half.leftCols(plain).transpose() * half;
    own_ = (lw.colwise().squaredNorm() - half.colwise().squaredNorm()).transpose();
    right_ = lw.transpose() * yw - half.transpose() * half_b;
    inverse_ = factor.solve(MatrixXd::Identity(p, p));
    const double common =
        -factor.half_log_determinant() + 0.5 * half_b.squaredNorm() + log_prior_of_sizes(model);
    evidence_.reserve(model.laws.laws.size());
    for (const FrictionLaw& law : model.laws.laws) evidence_.push_back(common + evidence_of(law));
  }

  [[nodiscard]] const std::vector<double>& evidence() const { return evidence_; }
  [[nodiscard]] std::size_t likeliest() const {
    return static_cast<std::size_t>(std::max_element(evidence_.begin(), evidence_.end()) -
                                    evidence_.begin());
  }

  [[nodiscard]] LawPosterior posterior(std::size_t index) const {
    const FrictionLaw& law = model_->laws.laws[index];
    const auto count = static_cast<Index>(law.index.size());
    const Index p = inverse_.rows();
    MatrixXd b(p, count);
    for (Index k = 0; k < count; ++k) b.col(k) = cross_.col(law.index[static_cast<std::size_t>(k)]);
    const MatrixXd own = statistics::inverse(block_of(law));
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
    const statistics::CholeskyFactor factor(block);
    const VectorXd right = right_of(law);
    const MatrixXd own = factor.solve(MatrixXd::Identity(block.rows(), block.cols()));
    const VectorXd mean = own * right;
    double sum = law.log_prior - law.scale.array().log().sum() - factor.half_log_determinant() +
                 0.5 * right.dot(mean);
    for (Index k = 0; k < mean.size(); ++k) {
      if (!law.is_positive[static_cast<std::size_t>(k)]) continue;
      sum += statistics::log_normal_probability(mean[k] / std::sqrt(own(k, k)));
    }
    return std::isfinite(sum) ? sum : -1e300;
  }

  const JointModel* model_;
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

/// The likeliest laws' posteriors, of all solves together.
std::vector<LawPosterior> likely_posteriors(const std::vector<Solve>& solves) {
  constexpr std::size_t most_laws = 48;
  constexpr double least_share = 0.003;
  struct Likely {
    double share{};
    const Solve* solve{};
    std::size_t law{};
  };
  double most = -std::numeric_limits<double>::infinity();
  for (const Solve& solve : solves) most = std::max(most, solve.evidence()[solve.likeliest()]);
  std::vector<Likely> likely;
  double total = 0;
  for (const Solve& solve : solves) {
    for (std::size_t k = 0; k < solve.evidence().size(); ++k) {
      likely.push_back({std::exp(solve.evidence()[k] - most), &solve, k});
      total += likely.back().share;
    }
  }
  std::stable_sort(likely.begin(), likely.end(),
                   [](const Likely& a, const Likely& b) { return a.share > b.share; });
  std::vector<LawPosterior> posteriors;
  double kept = 0;
  for (const Likely& one : likely) {
    if (posteriors.size() >= most_laws || one.share < least_share * total) break;
    posteriors.push_back(one.solve->posterior(one.law));
    posteriors.back().weight = one.share;
    kept += one.share;
  }
  for (LawPosterior& one : posteriors) one.weight /= kept;
  return posteriors;
}

/// How well a fit is supported: the evidence at its sizes, and the probability of these.
struct Support {
  double log_likelihood{};  ///< Of all cells as if independent.
  double log_of_sizes{};    ///< Priors of coefficients and sizes, and the posterior's volume.
  double laws{};            ///< Evidence of all laws over that of the likeliest.

  /// @param alike cells that say as much as one.
  [[nodiscard]] double log_evidence(double alike) const {
    return log_likelihood / alike + log_of_sizes + std::log(laws);
  }
};

/// The fit of one joint, round by round.
class Fit {
 public:
  /// @param random precision at which the recordings' own friction starts.
  Fit(const Cells& cells, bool has_gravity, const joint::EffectSizes& sizes, double random)
      : has_gravity_(has_gravity), random_(random) {
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

  /// Of what run() made.
  [[nodiscard]] const Support& support() const { return support_; }

  JointModel run() {
    for (int round = 0;; ++round) {
      if (std::find(put_up_at.begin(), put_up_at.end(), round) != put_up_at.end()) put_up();
      const Solve solve = solved();
      const LawPosterior found = solve.posterior(solve.likeliest());
      MatrixXd full(y_.size(), found.mean.size());
      full << x_, law_columns_(Eigen::all, found.law.index);
      m_.residual_Nm = (y_ - full * found.mean).array();
      if (round == rounds - 1) {
        support_ = support_of(found);
        for (const double one : solve.evidence()) {
          support_.laws += std::exp(one - solve.evidence()[solve.likeliest()]);
        }
        m_.posteriors = likely_posteriors(with_smaller_misfit(solve));
        return std::move(m_);
      }
      if (std::find(put_up_at.begin(), put_up_at.end(), round + 1) != put_up_at.end()) {
        dips_.look_nearer({m_.laws.laws, solve.evidence()});
      }
      improve_noise(m_.residual_Nm.square() +
                    ((full * found.covariance).array() * full.array()).rowwise().sum());
      if (round >= correlated_from) improve_correlation();
      improve_sizes(found);
      move_point(found);
    }
  }

 private:
  [[nodiscard]] Solve solved() const {
    return {m_, x_, law_columns_, y_,
            m_.weight / (noise_.of(count_) * m_.samples_per_independent * beyond_weights)};
  }

  /// What no law describes may have become so large that it stands for another law: laws are
  /// weighed at a smaller size of it, too.
  [[nodiscard]] std::vector<Solve> with_smaller_misfit(const Solve& found) {
    std::vector<Solve> all{found};
    const std::size_t misfit = m_.find(joint::effect::law_misfit.key);
    if (misfit == m_.effects.size()) return all;
    constexpr double smaller = 8;
    double& precision = m_.precision[static_cast<Index>(misfit)];
    const double alpha = precision;
    precision = smaller * alpha;
    all.push_back(solved());
    precision = alpha;
    return all;
  }

  /// Effects and laws about the present point.
  void put_up() {
    m_.effects = effect_columns(m_.cells, has_gravity_, m_.point, m_.sizes);
    m_.hats = law_hats(m_.cells, m_.point);
    m_.laws = candidate_laws(m_.cells, m_.point, dips_.grids());
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
      m_.precision[static_cast<Index>(e)] =
          !asks_size(effect)                ? 1
          : known != known_precision_.end() ? known->second
          : effect.key == joint::effect::law_misfit.key
              ? 1
              : std::max(effect.kind == Kind::random ? random_ : open, effect.least_precision());
    }
  }

  /// By Laplace's approximation at the likeliest law's posterior.
  [[nodiscard]] Support support_of(const LawPosterior& found) const {
    Support out;
    const ArrayXd variance = noise_.of(count_);
    const ArrayXd ratio = m_.residual_Nm.square() / (cell_freedom * variance);
    out.log_likelihood = -0.5 * (variance.log() + (cell_freedom + 1) * (1 + ratio).log()).sum();
    double& sum = out.log_of_sizes;
    sum = log_prior_of_sizes(m_);
    for (std::size_t e = 0; e < m_.effects.size(); ++e) {
      const double alpha = m_.precision[static_cast<Index>(e)];
      const ArrayXd scale = m_.effects[e].scale.array();
      const ArrayXd mean = found.mean.segment(m_.first[e], m_.width(e)).array();
      sum -= (scale.log() + 0.5 * alpha * (mean / scale).square()).sum();
    }
    const ArrayXd law_scale = found.law.scale.array();
    sum += found.law.log_prior -
           (law_scale.log() + 0.5 * (found.friction().array() / law_scale).square()).sum();
    sum += statistics::CholeskyFactor(found.covariance).half_log_determinant();
    return out;
  }

  /// And the cells' weights. @param square mean squares of the residuals.
  void improve_noise(const ArrayXd& square) {
    noise_.improve(square, count_);
    const ArrayXd variance = noise_.of(count_);
    m_.weight = (cell_freedom + 1) / (cell_freedom + square / variance);
  }

  /// Of the residuals of a stroke's cells.
  void improve_correlation() {
    ArrayXd standardised = m_.residual_Nm / noise_.of(count_).sqrt();
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
    // An inertia that no acceleration shows is set to zero: else jumps of the acceleration would
    // look like a lag.
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
  double random_;
  JointModel m_;
  ArrayXd count_;
  VectorXd y_;
  std::vector<int> stroke_;
  Noise noise_;
  std::map<std::string_view, double> known_precision_;
  DipSearch dips_;
  MatrixXd x_;
  MatrixXd law_columns_;
  Support support_;
};

/// The better supported of two fits. Friction that each recording has of its own may be large from
/// the start of one, so that no other effect has to stand for it; in the other it is typical, so
/// that it does not stand for a law of friction.
JointModel better_fit(const Cells& cells, bool has_gravity, const joint::EffectSizes& sizes) {
  Fit large(cells, has_gravity, sizes, open);
  JointModel by_large = large.run();
  if (by_large.find(joint::effect::friction_of_recording.key) == by_large.effects.size()) {
    return by_large;
  }
  Fit typical(cells, has_gravity, sizes, 1);
  JointModel by_typical = typical.run();
  if (!by_typical.is_finite()) return by_large;
  if (!by_large.is_finite()) return by_typical;
  const double alike = (by_large.samples_per_independent + by_typical.samples_per_independent) / 2;
  const bool is_large = large.support().log_evidence(alike) > typical.support().log_evidence(alike);
  return std::move(is_large ? by_large : by_typical);
}

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
  JointModel m = better_fit(without(out), has_gravity, sizes);
  if (!m.is_finite()) return {};
  constexpr int most_times = 3;
  for (int k = 0; k < most_times; ++k) {
    const std::vector<int> unlike = unlike_recordings(m);
    if (unlike.empty() || out.size() + unlike.size() > recordings.size() / 3) break;
    out.insert(out.end(), unlike.begin(), unlike.end());
    m = better_fit(without(out), has_gravity, sizes);
  }
  if (!m.is_finite()) return {};
  m.left_out = std::move(out);
  return m;
}

}  // namespace tribolog::method::model
