#include "method/model/joint_model.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>

#include <Eigen/Dense>

#include "method/model/model_quantities.h"
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
constexpr int rounds = 14;
// Sizes start ten times their typical one: from small ones a large effect stays hidden behind
// others.
constexpr double open = 0.01;

double least_precision(const Effect& effect) { return 1 / (effect.cap * effect.cap); }
bool asks_size(const Effect& effect) {
  return effect.kind == Kind::effect || effect.kind == Kind::random;
}

/// log of the normal cumulative probability.
double log_normal_cdf(double x) {
  if (x < -30) return -0.5 * x * x - std::log(-x * std::sqrt(2 * std::numbers::pi));
  return std::log(0.5 * std::erfc(-x / std::numbers::sqrt2));
}

double median_of_array(const ArrayXd& x) {
  return statistics::median(std::vector<double>(x.begin(), x.end()));
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

/// As how many cells of a stroke one independent cell counts: integrated autocorrelation.
double correlation(const ArrayXd& standardised, const std::vector<int>& stroke) {
  constexpr Index most = 12;
  const double power = standardised.square().mean() + 1e-12;
  double total = 1;
  const Index n = standardised.size();
  for (Index k = 1; k <= most && k < n; ++k) {
    double sum = 0;
    double count = 0;
    for (Index i = k; i < n; ++i) {
      if (stroke[static_cast<std::size_t>(i)] != stroke[static_cast<std::size_t>(i - k)]) continue;
      sum += standardised[i] * standardised[i - k];
      ++count;
    }
    if (count < 20 || sum / count / power < 0.03) break;
    total += 2 * sum / count / power;
  }
  return total;
}

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
    schur_ = lw.transpose() * lw - half.transpose() * half;
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
    found.friction = own * right_of(law);
    const MatrixXd k = inverse_ * b;
    found.effects = inverse_ * b_ - k * found.friction;
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
    MatrixXd block = schur_(law.index, law.index);
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
      sum += log_normal_cdf(mean[k] / std::sqrt(own(k, k)));
    }
    return std::isfinite(sum) ? sum : -1e300;
  }

  const JointModel& model_;
  VectorXd b_;
  MatrixXd cross_;
  MatrixXd schur_;
  VectorXd right_;
  MatrixXd inverse_;
  std::vector<double> evidence_;
};

/// Recordings of which a model that suits the others explains next to nothing, as with the
/// torque's sign turned.
std::vector<int> foreign_recordings(const Cells& cells) {
  std::map<int, std::vector<Index>> rows;
  for (Index i = 0; i < cells.size(); ++i) {
    rows[cells.rows[static_cast<std::size_t>(i)].recording].push_back(i);
  }
  if (rows.size() < 6) return {};
  const ArrayXd y = cells.of(&Cell::torque_Nm);
  const ArrayXd count = cells.of(&Cell::count);
  const ArrayXd s = cells.of(&Cell::direction);
  MatrixXd x(cells.size(), 6);
  x << cells.of(&Cell::cos_q).matrix(), cells.of(&Cell::sin_q).matrix(),
      VectorXd::Ones(cells.size()), cells.of(&Cell::acceleration_rad_s2).matrix(), s.matrix(),
      (s * cells.of(&Cell::speed_rad_s)).matrix();
  x.array().rowwise() /= (x.array().square().colwise().mean().sqrt() + 1e-12);
  const double some = 0.05 * median_of_array(y.abs());
  ArrayXd weight(cells.size());
  std::map<int, double> misfit;
  std::map<int, double> size;
  for (const auto& [key, of] : rows) {
    const double samples = count(of).sum();
    weight(of) = count(of) / samples;
    size[key] = std::sqrt((count(of) * y(of).square()).sum() / samples);
  }
  const ArrayXd by_recording = weight;
  constexpr int steps = 15;
  for (int k = 0; k < steps; ++k) {
    MatrixXd gram = x.transpose() * weight.matrix().asDiagonal() * x;
    gram.diagonal().array() += 1e-6 * weight.sum();
    const ArrayXd r = y - (x * gram.ldlt().solve(x.transpose() * (weight * y).matrix())).array();
    for (const auto& [key, of] : rows) {
      misfit[key] = std::sqrt((by_recording(of) * r(of).square()).sum());
      weight(of) = by_recording(of) / (misfit[key] + some);
    }
  }
  std::vector<double> all;
  for (const auto& [key, value] : misfit) all.push_back(value);
  const double usual = statistics::median(all);
  std::vector<int> foreign;
  for (const auto& [key, value] : misfit) {
    if (value > 0.7 * size[key] && value > 6 * usual) foreign.push_back(key);
  }
  return foreign;
}

JointModel fit_all(const Cells& cells, bool has_gravity) {
  JointModel m;
  m.cells = cells;
  // Cells of a stroke one after the other: neighbours' noise is correlated.
  std::stable_sort(m.cells.rows.begin(), m.cells.rows.end(), [](const Cell& a, const Cell& b) {
    return std::pair(a.stroke, a.time_s) < std::pair(b.stroke, b.time_s);
  });
  m.point = first_point(m.cells, has_gravity);
  const ArrayXd count = m.cells.of(&Cell::count);
  const VectorXd y = m.cells.of(&Cell::torque_Nm).matrix();
  std::vector<int> stroke;
  std::vector<double> scatter;
  for (const Cell& row : m.cells.rows) {
    stroke.push_back(row.stroke);
    if (std::isfinite(row.scatter_Nm)) scatter.push_back(row.scatter_Nm);
  }
  const double top = m.point.top_Nm;
  const double white =
      std::max(scatter.size() > 5 ? statistics::median(scatter) : 0.02 * top, 1e-4 * top);
  const double dark = 0.05 * white + 1e-4 * top;
  Noise noise{white * white, dark * dark, 1e-10 * top * top, white * white};
  ArrayXd variance = noise.of(count);
  m.weight = ArrayXd::Ones(y.size());
  double near_speed = 0;
  double near_span = 0;
  std::map<std::string_view, double> sizes;
  MatrixXd x;
  MatrixXd law_columns;
  for (int round = 0; round < rounds; ++round) {
    if (round == 0 || round == 3 || round == 7) {
      m.effects = effect_columns(m.cells, has_gravity, m.point);
      m.hats = law_hats(m.cells, m.point);
      m.laws = candidate_laws(m.cells, m.point, near_speed, near_span);
      law_columns = m.laws.torque(m.cells);
      m.first = {0};
      for (const EffectColumns& e : m.effects) m.first.push_back(m.first.back() + e.columns.cols());
      x.resize(y.size(), m.first.back());
      m.precision.resize(static_cast<Index>(m.effects.size()));
      for (std::size_t e = 0; e < m.effects.size(); ++e) {
        const Effect& effect = *m.effects[e].effect;
        x.middleCols(m.first[e], m.width(e)) = m.effects[e].columns;
        const auto known = sizes.find(effect.key);
        m.precision[static_cast<Index>(e)] = !asks_size(effect) ? 1
                                             : known != sizes.end()
                                                 ? known->second
                                                 : std::max(open, least_precision(effect));
      }
    }
    const Solve solve(m, x, law_columns, y, m.weight / (variance * m.samples_per_independent));
    const std::size_t best = solve.likeliest();
    const LawPosterior found = solve.posterior(best);
    const Index p = x.cols();
    const auto own = static_cast<Index>(found.law.index.size());
    MatrixXd full(y.size(), p + own);
    full << x, law_columns(Eigen::all, found.law.index);
    VectorXd theta(p + own);
    theta << found.effects, found.friction;
    m.residual_Nm = (y - full * theta).array();
    if (round == 2 || round == 6) {
      near_speed = found.law.has_dip ? found.law.dip.dip_speed : 0;
      near_span = round == 2 ? 0.35 : 0.12;
    }
    if (round == rounds - 1) {
      const double most = solve.evidence()[best];
      std::vector<std::pair<double, std::size_t>> likely;
      double total = 0;
      for (std::size_t k = 0; k < solve.evidence().size(); ++k) {
        const double share = std::exp(solve.evidence()[k] - most);
        total += share;
        likely.emplace_back(share, k);
      }
      std::sort(likely.rbegin(), likely.rend());
      constexpr std::size_t most_laws = 12;
      constexpr double least_share = 0.003;
      double kept = 0;
      for (const auto& [share, k] : likely) {
        if (m.posteriors.size() >= most_laws || share < least_share * total) break;
        m.posteriors.push_back(solve.posterior(k));
        m.posteriors.back().weight = share;
        kept += share;
      }
      for (LawPosterior& one : m.posteriors) one.weight /= kept;
      break;
    }
    const ArrayXd square =
        m.residual_Nm.square() + ((full * found.covariance).array() * full.array()).rowwise().sum();
    noise.improve(square, count);
    variance = noise.of(count);
    m.weight = (cell_freedom + 1) / (cell_freedom + square / variance);
    ArrayXd standardised = m.residual_Nm / variance.sqrt();
    const std::size_t random = m.find("friction_of_recording");
    if (random < m.effects.size()) {  // its own: no correlation of neighbours
      const MatrixXd& own_columns = m.effects[random].columns;
      const ArrayXd sizes_of = own_columns.array().square().colwise().sum().max(1e-12).transpose();
      standardised -=
          (own_columns *
           ((own_columns.transpose() * standardised.matrix()).array() / sizes_of).matrix())
              .array();
    }
    m.samples_per_independent = correlation(standardised.max(-4.0).min(4.0), stroke);
    for (std::size_t e = 0; e < m.effects.size(); ++e) {
      const Effect& effect = *m.effects[e].effect;
      if (!asks_size(effect)) continue;
      const VectorXd& scale = m.effects[e].scale;
      double unknown = 0;
      double size = 0;
      for (Index k = 0; k < scale.size(); ++k) {
        const Index i = m.first[e] + k;
        unknown += found.covariance(i, i) / (scale[k] * scale[k]);
        size += theta[i] * theta[i] / (scale[k] * scale[k]);
      }
      double& alpha = m.precision[static_cast<Index>(e)];
      const double known = std::max(0.0, static_cast<double>(scale.size()) - alpha * unknown);
      alpha = std::max((effect.dof + known) / (effect.dof + size), least_precision(effect));
      sizes[effect.key] = alpha;
    }
    const auto value_of = [&](std::string_view key, Index k) {
      const std::size_t e = m.find(key);
      return e < m.effects.size() ? theta[m.first[e] + k] : 0.0;
    };
    if (has_gravity) {
      m.point.gravity_cos_Nm = value_of("gravity", 0);
      m.point.gravity_sin_Nm = value_of("gravity", 1);
    }
    m.point.inertia_kgm2 = value_of("inertia", 0);
    m.point.coulomb_Nm = found.friction[0];
    m.point.viscous_Nms_rad = found.law.meanings[1].row(1) * found.friction;
    m.point.dip_Nm = found.law.has_dip ? found.friction[own - 1] : 0;
    m.point.dip_speed_rad_s = found.law.has_dip ? found.law.dip.dip_speed : 0;
    m.point.dip_power = found.law.has_dip ? found.law.dip.dip_power : 1;
    const ArrayXd friction =
        (law_columns(Eigen::all, found.law.index) * found.friction).array().abs();
    m.point.friction_Nm = std::clamp(median_of_array(friction), 0.03 * top, top);
  }
  return m;
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
           return std::isfinite(p.weight) && p.effects.allFinite() && p.friction.allFinite() &&
                  p.covariance.allFinite();
         });
}

JointModel fit_joint_model(const Cells& cells, bool has_gravity) {
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
  JointModel m = fit_all(without(out), has_gravity);
  if (!m.is_finite()) return {};
  constexpr int most_times = 3;
  for (int k = 0; k < most_times; ++k) {
    const std::vector<int> unlike = unlike_recordings(m);
    if (unlike.empty() || out.size() + unlike.size() > recordings.size() / 3) break;
    out.insert(out.end(), unlike.begin(), unlike.end());
    m = fit_all(without(out), has_gravity);
  }
  if (!m.is_finite()) return {};
  m.left_out = std::move(out);
  return m;
}

}  // namespace tribolog::method::model
