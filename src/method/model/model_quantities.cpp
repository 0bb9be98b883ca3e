#include "method/model/model_quantities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <Eigen/Dense>

#include "statistics/order_statistics.h"

namespace tribolog::method::model {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using joint::Quantity;
using Kind = Effect::Kind;

/// What an effect takes off a quantity is known no better than the effect's form: one standard
/// deviation of it.
constexpr double form = 0.2;
constexpr double far_off_weight = 0.3;

/// A value and its derivatives by the effects' and the law's coefficients.
struct Value {
  double value{};
  VectorXd gradient;
};

/// Which meaning of Coulomb and viscous torque, and at which moment of the session the
/// torque's gain was right: nobody knows.
struct Meaning {
  std::size_t of_law{1};  ///< FrictionLaw::meanings
  double moment{};
  double friction_change{};  ///< Of friction at that moment, by its mean over the runs.
};

struct Wanted {
  std::optional<Quantity> quantity;
  double speed_rad_s{};
};

bool is_of_friction(const Wanted& wanted) {
  return !wanted.quantity || *wanted.quantity == Quantity::coulomb_torque ||
         *wanted.quantity == Quantity::viscous_coefficient;
}

Value value_of(const JointModel& m, const LawPosterior& p, const VectorXd& theta,
               const Wanted& wanted, const Meaning& meaning) {
  const Index effects = m.first.back();
  Value v{0, VectorXd::Zero(theta.size())};
  const auto law = theta.tail(theta.size() - effects);
  const auto of_law = [&](const Eigen::RowVectorXd& weights) {
    v.gradient.tail(weights.size()) = weights.transpose();
    v.value = weights * law;
  };
  if (!wanted.quantity) {
    Eigen::RowVectorXd weights(law.size());
    for (Index k = 0; k < law.size(); ++k) {
      const LawColumn& column =
          m.laws.columns[static_cast<std::size_t>(p.law.index[static_cast<std::size_t>(k)])];
      weights[k] = column.at(wanted.speed_rad_s, m.laws.fastest_rad_s);
    }
    of_law(weights);
    for (const char* key : {"law_misfit", "law_at_its_ends"}) {
      const std::size_t e = m.find(key);
      if (e == m.effects.size()) continue;
      const Eigen::RowVectorXd hats = key == std::string_view("law_misfit")
                                          ? m.hats.bent(wanted.speed_rad_s)
                                          : m.hats.whole(wanted.speed_rad_s);
      v.gradient.segment(m.first[e], hats.size()) = hats.transpose();
      v.value += hats * theta.segment(m.first[e], hats.size());
    }
  } else if (*wanted.quantity == Quantity::gravity_torque ||
             *wanted.quantity == Quantity::cog_angle) {
    const Index i = m.first[m.find("gravity")];
    const double c = theta[i];
    const double s = theta[i + 1];
    const double size = std::hypot(c, s);
    if (*wanted.quantity == Quantity::gravity_torque) {
      v.value = size;
      v.gradient[i] = c / size;
      v.gradient[i + 1] = s / size;
    } else {
      v.value = std::atan2(s, c);
      v.gradient[i] = -s / (size * size);
      v.gradient[i + 1] = c / (size * size);
      return v;
    }
  } else if (*wanted.quantity == Quantity::inertia) {
    const Index i = m.first[m.find("inertia")];
    v.value = theta[i];
    v.gradient[i] = 1;
  } else {
    const Index row = *wanted.quantity == Quantity::coulomb_torque ? 0 : 1;
    of_law(p.law.meanings[meaning.of_law].row(row));
  }
  if (is_of_friction(wanted)) {
    v.value *= 1 + meaning.friction_change;
    v.gradient *= 1 + meaning.friction_change;
  }
  const std::size_t gain = m.find("gain_drift");
  if (gain < m.effects.size() && meaning.moment != 0) {
    const double change = meaning.moment * theta[m.first[gain]];
    const double before = v.value;
    v.value *= 1 + change;
    v.gradient *= 1 + change;
    v.gradient[m.first[gain]] += meaning.moment * before;
  }
  return v;
}

/// Begin, mean time and end of the runs' place in the session, from where the gain counts.
std::array<double, 3> moments_of(const Cells& cells) {
  const ArrayXd t = cells.of(&Cell::time_s);
  const ArrayXd run = cells.of(&Cell::is_run);
  const ArrayXd share = cells.of(&Cell::count) * ((run > 0).any() ? run : ArrayXd::Ones(t.size()));
  const double span = std::max(t.maxCoeff() - t.minCoeff(), 1e-9);
  const double there = 2 * (share * t).sum() / share.sum() / span - 2 * t.minCoeff() / span - 1;
  return {-1 - there, 0, 1 - there};
}

/// By which share of itself friction differs at the session's begin and end from its mean over the
/// runs: who asks for friction asks for none of these moments.
std::array<double, 3> friction_changes(const JointModel& m, const VectorXd& theta) {
  const std::size_t drift = m.find("drift");
  if (drift == m.effects.size()) return {0, 0, 0};
  const ArrayXd changed =
      (m.effects[drift].columns * theta.segment(m.first[drift], m.width(drift))).array() *
      m.cells.of(&Cell::direction) / m.point.friction_Nm;
  Index begin = 0;
  Index end = 0;
  const ArrayXd t = m.cells.of(&Cell::time_s);
  t.minCoeff(&begin);
  t.maxCoeff(&end);
  return {changed[begin], 0, changed[end]};
}

VectorXd coefficients_of(const LawPosterior& p) {
  VectorXd theta(p.effects.size() + p.friction.size());
  theta << p.effects, p.friction;
  return theta;
}

double wrapped(double angle, double about) {
  return about + std::remainder(angle - about, 2 * std::numbers::pi);
}

/// The posterior with another size of one effect.
struct OtherSize {
  std::size_t effect{};
  VectorXd moved;     ///< Means of all coefficients.
  MatrixXd less;      ///< Covariance less C less C^T, with C the covariance with the effect.
  double evidence{};  ///< log, over that of the size found.
};

/// The size of no effect is known: its precision in turn from ten times to a thousandth.
std::vector<OtherSize> other_sizes(const JointModel& m, const LawPosterior& p,
                                   const VectorXd& theta) {
  std::vector<OtherSize> all;
  for (std::size_t e = 0; e < m.effects.size(); ++e) {
    const Effect& effect = *m.effects[e].effect;
    if (effect.kind != Kind::effect) continue;
    const Index at = m.first[e];
    const Index width = m.width(e);
    const double alpha = m.precision[static_cast<Index>(e)];
    const double least = 1 / (effect.cap * effect.cap);
    const VectorXd typical = m.effects[e].scale.array().square().inverse().matrix();
    const MatrixXd own = p.covariance.block(at, at, width, width);
    const VectorXd here = theta.segment(at, width);
    double last = alpha;
    for (const double factor : {10.0, 100.0, 1000.0, 0.1}) {
      const double tried = std::max(alpha / factor, least);
      if (factor > 1 && tried >= last) continue;
      if (factor > 1) last = tried;
      const VectorXd change = (tried - alpha) * typical;
      const MatrixXd mixed = MatrixXd::Identity(width, width) + change.asDiagonal() * own;
      const Eigen::PartialPivLU<MatrixXd> factorised(mixed);
      const double determinant = factorised.determinant();
      if (!(determinant > 0)) continue;
      OtherSize other;
      other.effect = e;
      other.less = factorised.solve(MatrixXd(change.asDiagonal()));
      other.moved = theta - p.covariance.middleCols(at, width) * (other.less * here);
      other.evidence = 0.5 * static_cast<double>(width) * std::log(tried / alpha) -
                       0.5 * std::log(determinant) - 0.5 * here.dot(other.less * here) +
                       effect.dof / 2 * (std::log(tried / alpha) - (tried - alpha));
      all.push_back(std::move(other));
    }
  }
  return all;
}

/// What it adds to a quantity that the size of an effect is not known.
struct OfUnknownSize {
  double shift{};
  double variance{};
};

/// Of one effect. @param points value, variance and log evidence, the size found first.
OfUnknownSize of_unknown_size(const std::vector<std::array<double, 3>>& points) {
  double most = 0;
  for (const auto& point : points) most = std::max(most, point[2]);
  double total = 0;
  double mean = 0;
  for (const auto& point : points) {
    total += std::exp(point[2] - most);
    mean += std::exp(point[2] - most) * point[0];
  }
  mean /= total;
  double variance = 0;
  for (const auto& point : points) {
    variance +=
        std::exp(point[2] - most) / total * (point[1] + (point[0] - mean) * (point[0] - mean));
  }
  return {mean - points[0][0], std::max(0.0, variance - points[0][1])};
}

struct MixturePart {
  double weight{};
  double mean{};
  double sd{};
};

/// Probability below `t` in Student's distribution of 20 degrees of freedom, a finite sum for an
/// even number of them (Abramowitz and Stegun, 26.7.4).
double probability_below(double t) {
  constexpr int freedom = 20;
  const double cos2 = freedom / (freedom + t * t);
  double term = 1;
  double sum = 1;
  for (int k = 1; k < freedom / 2; ++k) {
    term *= cos2 * (2 * k - 1) / (2 * k);
    sum += term;
  }
  return 0.5 + 0.5 * t / std::sqrt(freedom + t * t) * sum;
}

/// Where the cumulated probability of a mixture of Student's t is `probability`.
double quantile(const std::vector<MixturePart>& parts, double probability) {
  double low = parts[0].mean;
  double high = low;
  for (const MixturePart& p : parts) {
    low = std::min(low, p.mean - 8 * p.sd);
    high = std::max(high, p.mean + 8 * p.sd);
  }
  for (int k = 0; k < 50; ++k) {
    const double x = (low + high) / 2;
    double below = 0;
    for (const MixturePart& p : parts) below += p.weight * probability_below((x - p.mean) / p.sd);
    (below < probability ? low : high) = x;
  }
  return (low + high) / 2;
}

ModelQuantity describe(const JointModel& m, const std::vector<OtherSize>& sizes,
                       const Wanted& wanted) {
  const LawPosterior& best = m.posteriors[0];
  const std::array<double, 3> moments = moments_of(m.cells);
  const bool is_angle = wanted.quantity == Quantity::cog_angle;
  const VectorXd theta = coefficients_of(best);
  const Value centre = value_of(m, best, theta, wanted, {});
  const VectorXd to_quantity = best.covariance * centre.gradient;
  const double variance = centre.gradient.dot(to_quantity);
  double shift = 0;
  double added = 0;
  std::vector<double> own(m.effects.size(), 0);
  for (std::size_t e = 0; e < m.effects.size(); ++e) {
    const Effect& effect = *m.effects[e].effect;
    if (effect.kind == Kind::core) continue;
    const Index at = m.first[e];
    const Index width = m.width(e);
    MatrixXd block = best.covariance.block(at, at, width, width);
    block.diagonal().array() += 1e-12 * block.trace();
    const VectorXd with = block.ldlt().solve(to_quantity.segment(at, width));
    own[e] = with.dot(to_quantity.segment(at, width));
    if (effect.kind != Kind::effect) continue;
    std::vector<std::array<double, 3>> points{{centre.value, variance, 0}};
    const VectorXd to_effect = to_quantity.segment(at, width);
    for (const OtherSize& other : sizes) {
      if (other.effect != e) continue;
      const double value = value_of(m, best, other.moved, wanted, {}).value;
      points.push_back({is_angle ? wrapped(value, centre.value) : value,
                        variance - to_effect.dot(other.less * to_effect), other.evidence});
    }
    const OfUnknownSize unknown = of_unknown_size(points);
    shift += unknown.shift;
    double extra = unknown.variance;
    // An offset has but one form, and what the law misses of friction at a speed is friction there.
    const bool has_form = effect.key != "offset" && (wanted.quantity || effect.key != "law_misfit");
    if (has_form) extra += std::pow(form * with.dot(theta.segment(at, width)), 2);
    added += extra;
    own[e] += extra + unknown.shift * unknown.shift;
  }
  std::vector<MixturePart> parts;
  double estimate = 0;
  const bool is_of_law = wanted.quantity == Quantity::coulomb_torque ||
                         wanted.quantity == Quantity::viscous_coefficient;
  const std::size_t meanings = is_of_law ? best.law.meanings.size() : 1;
  for (const LawPosterior& p : m.posteriors) {
    const VectorXd t = coefficients_of(p);
    const std::array<double, 3> changes = friction_changes(m, t);
    for (std::size_t k = 0; k < meanings; ++k) {
      for (std::size_t at = 0; at < moments.size(); ++at) {
        const Value v = value_of(m, p, t, wanted, {k, moments[at], changes[at]});
        const double value = (is_angle ? wrapped(v.value, centre.value) : v.value) + shift;
        const double sd = std::sqrt(v.gradient.dot(p.covariance * v.gradient) + added);
        const double weight = p.weight / static_cast<double>(meanings * moments.size());
        parts.push_back({weight, value, std::max(sd, 1e-300)});
        estimate += weight * value;
      }
    }
  }
  double between = 0;
  for (const MixturePart& p : parts) between += p.weight * std::pow(p.mean - estimate, 2);
  if (const std::size_t drift = m.find("drift");
      drift < m.effects.size() && is_of_friction(wanted)) {
    const std::array<double, 3> changes = friction_changes(m, theta);
    const double mean = (changes[0] + changes[1] + changes[2]) / 3;
    double square = 0;
    for (const double change : changes) square += std::pow(change - mean, 2) / 3;
    const double of_time = std::min(between, square * centre.value * centre.value);
    own[drift] += of_time;
    added += of_time;
    between -= of_time;
  }
  ModelQuantity q{wanted.quantity,        wanted.speed_rad_s,     estimate,
                  quantile(parts, 0.025), quantile(parts, 0.975), {}};
  for (std::size_t e = 0; e < m.effects.size(); ++e) {
    if (m.effects[e].effect->kind == Kind::core) continue;
    q.shares.push_back({m.effects[e].effect->key, own[e] / (variance + added)});
  }
  q.shares.push_back({"choice_of_law", between / (between + variance + added)});
  std::stable_sort(
      q.shares.begin(), q.shares.end(),
      [](const VarianceShare& a, const VarianceShare& b) { return a.share > b.share; });
  return q;
}

}  // namespace

std::vector<int> unlike_recordings(const JointModel& m) {
  std::map<int, std::pair<double, double>> sums;
  ArrayXd own = m.residual_Nm;
  const std::size_t e = m.find("friction_of_recording");
  if (e < m.effects.size()) {
    own += (m.effects[e].columns * m.posteriors[0].effects.segment(m.first[e], m.width(e))).array();
  }
  for (Index i = 0; i < m.cells.size(); ++i) {
    const Cell& row = m.cells.rows[static_cast<std::size_t>(i)];
    auto& [square, count] = sums[row.recording];
    square += row.count * own[i] * own[i];
    count += row.count;
  }
  if (sums.size() < 6) return {};
  std::vector<double> sizes;
  for (const auto& [key, sum] : sums) sizes.push_back(std::sqrt(sum.first / sum.second));
  const double limit = std::max(6 * statistics::median(sizes), 0.1 * m.point.friction_Nm);
  std::vector<int> unlike;
  for (const auto& [key, sum] : sums) {
    if (std::sqrt(sum.first / sum.second) > limit) unlike.push_back(key);
  }
  return unlike;
}

const ModelQuantity* ModelResult::find(Quantity quantity) const {
  const auto found = std::find_if(quantities.begin(), quantities.end(),
                                  [&](const ModelQuantity& q) { return q.quantity == quantity; });
  return found == quantities.end() ? nullptr : &*found;
}

ModelResult describe_joint_model(const JointModel& model, const std::vector<double>& speeds_rad_s) {
  ModelResult result;
  result.cells = model.cells.rows.size();
  result.left_out = model.left_out;
  if (model.empty()) return result;
  result.samples_per_independent = model.samples_per_independent;
  result.cells_far_off = (model.weight < far_off_weight).cast<double>().mean();
  result.unlike_left = unlike_recordings(model).size();
  std::vector<Wanted> wanted;
  if (model.find("gravity") < model.effects.size()) {
    wanted = {{Quantity::gravity_torque}, {Quantity::cog_angle}};
  }
  wanted.push_back({Quantity::coulomb_torque});
  wanted.push_back({Quantity::viscous_coefficient});
  if (model.find("inertia") < model.effects.size()) wanted.push_back({Quantity::inertia});
  const ArrayXd v = model.cells.of(&Cell::speed_rad_s);
  for (const double speed : speeds_rad_s) {
    if (speed >= 0.95 * v.minCoeff() && speed <= 1.05 * v.maxCoeff()) wanted.push_back({{}, speed});
  }
  const LawPosterior& best = model.posteriors[0];
  const std::vector<OtherSize> sizes = other_sizes(model, best, coefficients_of(best));
  for (const Wanted& one : wanted) result.quantities.push_back(describe(model, sizes, one));
  for (std::size_t e = 0; e < model.effects.size(); ++e) {
    const Index at = model.first[e];
    const Index width = model.width(e);
    const VectorXd mean = best.effects.segment(at, width);
    MatrixXd block = best.covariance.block(at, at, width, width);
    block.diagonal().array() += 1e-12 * block.trace();
    const bool is_asked = model.effects[e].effect->kind == Kind::effect;
    result.effects.push_back(
        {model.effects[e].effect->key, is_asked ? mean.dot(block.ldlt().solve(mean)) : std::nan(""),
         static_cast<double>(width),
         std::sqrt((model.effects[e].columns * mean).array().square().mean()),
         1 / std::sqrt(model.precision[static_cast<Index>(e)]) / model.effects[e].effect->cap});
  }
  return result;
}

ModelResult identify_joint(const std::vector<const joint::Recording*>& recordings,
                           const std::vector<joint::FrictionPoints>& points, double gear_ratio,
                           bool has_gravity) {
  constexpr double step = 0.039;  // of log speed: within 2 % of any
  const Cells cells = make_cells(recordings, points, gear_ratio, has_gravity);
  const JointModel model = fit_joint_model(cells, has_gravity);
  std::vector<double> speeds;
  if (!model.empty()) {
    const ArrayXd v = model.cells.of(&Cell::speed_rad_s);
    const double low = v.minCoeff();
    const double span = std::log(v.maxCoeff() / low);
    constexpr double one_speed = 1e-9;  // apart by rounding alone
    const auto steps = static_cast<int>(std::ceil((span - one_speed) / step));
    for (int k = 0; k <= steps; ++k) {
      speeds.push_back(low * std::exp(span * k / std::max(steps, 1)));
    }
  }
  return describe_joint_model(model, speeds);
}

}  // namespace tribolog::method::model
