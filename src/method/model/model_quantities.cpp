#include "method/model/model_quantities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Dense>

#include "base/requirements.h"
#include "method/model/quantity_value.h"
#include "method/model/unlike_recordings.h"
#include "statistics/distributions.h"

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
constexpr double far_off_share = 0.01;  // of the friction: less matters to nobody
constexpr double far_off_weight = 0.3;

/// The angle, by whole turns, that is nearest to `about`.
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
std::vector<OtherSize> other_sizes(const JointModel& m, const LawPosterior& p) {
  std::vector<OtherSize> all;
  for (std::size_t e = 0; e < m.effects.size(); ++e) {
    const Effect& effect = *m.effects[e].effect;
    if (effect.kind != Kind::effect) continue;
    const Index at = m.first[e];
    const Index width = m.width(e);
    const double alpha = m.precision[static_cast<Index>(e)];
    const VectorXd typical = m.effects[e].scale.array().square().inverse().matrix();
    const MatrixXd own = p.covariance.block(at, at, width, width);
    const VectorXd here = p.mean.segment(at, width);
    double last = alpha;
    for (const double factor : {10.0, 100.0, 1000.0, 0.1}) {
      const double tried = std::max(alpha / factor, effect.least_precision());
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
      other.moved = p.mean - p.covariance.middleCols(at, width) * (other.less * here);
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

/// Where the cumulated probability of a mixture of Student's t is `probability`.
double quantile(const std::vector<MixturePart>& parts, double probability) {
  constexpr int freedom = 20;
  double low = parts[0].mean;
  double high = low;
  for (const MixturePart& p : parts) {
    low = std::min(low, p.mean - 8 * p.sd);
    high = std::max(high, p.mean + 8 * p.sd);
  }
  for (int k = 0; k < 50; ++k) {
    const double x = (low + high) / 2;
    double below = 0;
    for (const MixturePart& p : parts)
      below += p.weight * statistics::student_t_probability((x - p.mean) / p.sd, freedom);
    (below < probability ? low : high) = x;
  }
  return (low + high) / 2;
}

/// What all quantities of a model share, and each of them.
class Describer {
 public:
  explicit Describer(const JointModel& model)
      : m_(model),
        best_(model.posteriors[0]),
        sizes_(other_sizes(model, best_)),
        moments_(moments_of(model.cells)) {
    for (std::size_t e = 0; e < m_.effects.size(); ++e) {
      MatrixXd own = best_.covariance.block(m_.first[e], m_.first[e], m_.width(e), m_.width(e));
      own.diagonal().array() += 1e-12 * own.trace();
      effects_.emplace_back(own);
    }
    for (const LawPosterior& p : m_.posteriors) changes_.push_back(friction_changes(m_, p.mean));
  }

  [[nodiscard]] ModelQuantity describe(const Wanted& wanted) const;
  [[nodiscard]] ModelEffect describe_effect(std::size_t e) const;
  /// ModelResult::friction_of_loops
  [[nodiscard]] std::optional<statistics::Estimate> friction_of(const std::vector<Cell>& contacts,
                                                                const Effect* by_turn) const;
  /// ModelResult::gain_of_loops
  [[nodiscard]] std::optional<statistics::Estimate> gain_of(
      const std::vector<Cell>& contacts) const;

 private:
  /// Torques out of proportion: derivative of the logged torque, less one, per coefficient, mean
  /// over contacts.
  void put_gain(const std::vector<Cell>& contacts, VectorXd& row) const;
  /// Absent: nothing is there that could differ. @param by a standard deviation beside.
  [[nodiscard]] std::optional<statistics::Estimate> wider(const Wanted& share, double by) const;
  /// Of an effect's first coefficient, at the size found.
  [[nodiscard]] double deviation_of(std::size_t e) const {
    return m_.effects[e].scale[0] / std::sqrt(m_.precision[static_cast<Index>(e)]);
  }
  /// One standard deviation of the scale of recordings beside sweeps and runs.
  [[nodiscard]] double own_gain(const std::vector<Cell>& contacts) const;

  /// What effects add to a quantity.
  struct OfEffects {
    double shift{};
    double variance{};
    std::vector<double> shares;  ///< Of each effect, not yet by the whole variance.
  };
  [[nodiscard]] OfEffects of_effects(const Wanted& wanted, const Value& centre,
                                     const VectorXd& to_quantity, double variance) const;
  [[nodiscard]] VectorXd mean_of(std::size_t e) const {
    return best_.mean.segment(m_.first[e], m_.width(e));
  }

  const JointModel& m_;
  const LawPosterior& best_;
  std::vector<OtherSize> sizes_;
  std::array<double, 3> moments_;
  std::vector<Eigen::LDLT<MatrixXd>> effects_;  ///< Each effect's own covariance.
  std::vector<std::array<double, 3>> changes_;  ///< Of friction, under each law.
};

Describer::OfEffects Describer::of_effects(const Wanted& wanted, const Value& centre,
                                           const VectorXd& to_quantity, double variance) const {
  OfEffects all{0, 0, std::vector<double>(m_.effects.size(), 0)};
  for (std::size_t e = 0; e < m_.effects.size(); ++e) {
    const Effect& effect = *m_.effects[e].effect;
    if (effect.kind == Kind::core) continue;
    const VectorXd to_effect = to_quantity.segment(m_.first[e], m_.width(e));
    const VectorXd with = effects_[e].solve(to_effect);
    all.shares[e] = with.dot(to_effect);
    if (effect.kind != Kind::effect) continue;
    std::vector<std::array<double, 3>> points{{centre.value, variance, 0}};
    for (const OtherSize& other : sizes_) {
      if (other.effect != e) continue;
      const double value = value_of(m_, best_, other.moved, wanted, {}).value;
      points.push_back(
          {wanted.quantity == Quantity::cog_angle ? wrapped(value, centre.value) : value,
           variance - to_effect.dot(other.less * to_effect), other.evidence});
    }
    const OfUnknownSize unknown = of_unknown_size(points);
    double extra = unknown.variance;
    // An offset has but one form, and what the law misses of friction at a speed is friction there.
    // Nor has an effect's own size a form.
    const bool has_form = effect.key != "offset" &&
                          (wanted.quantity || effect.key != "law_misfit") &&
                          (wanted.row.size() == 0 || m_.width(e) > 1);
    if (has_form) extra += std::pow(form * with.dot(mean_of(e)), 2);
    all.shift += unknown.shift;
    all.variance += extra;
    all.shares[e] += extra + unknown.shift * unknown.shift;
  }
  return all;
}

ModelQuantity Describer::describe(const Wanted& wanted) const {
  const bool is_angle = wanted.quantity == Quantity::cog_angle;
  const Value centre = value_of(m_, best_, best_.mean, wanted, {});
  const VectorXd to_quantity = best_.covariance * centre.gradient;
  const double variance = centre.gradient.dot(to_quantity);
  OfEffects effects = of_effects(wanted, centre, to_quantity, variance);

  std::vector<MixturePart> parts;
  double estimate = 0;
  const std::size_t meanings =
      wanted.quantity && is_of_friction(wanted) ? best_.law.meanings.size() : 1;
  for (std::size_t law = 0; law < m_.posteriors.size(); ++law) {
    const LawPosterior& p = m_.posteriors[law];
    for (std::size_t k = 0; k < meanings; ++k) {
      for (std::size_t at = 0; at < moments_.size(); ++at) {
        const Value v = value_of(m_, p, p.mean, wanted, {k, moments_[at], changes_[law][at]});
        const double value = (is_angle ? wrapped(v.value, centre.value) : v.value) + effects.shift;
        const double sd = std::sqrt(v.gradient.dot(p.covariance * v.gradient) + effects.variance);
        const double weight = p.weight / static_cast<double>(meanings * moments_.size());
        parts.push_back({weight, value, std::max(sd, 1e-300)});
        estimate += weight * value;
      }
    }
  }
  double between = 0;
  for (const MixturePart& p : parts) between += p.weight * std::pow(p.mean - estimate, 2);
  double whole = variance + effects.variance;
  if (const std::size_t drift = m_.find("drift");
      drift < m_.effects.size() && is_of_friction(wanted)) {
    const auto& [begin, middle, end] = changes_[0];
    const double mean = (begin + middle + end) / 3;
    double square = 0;
    for (const double change : changes_[0]) square += std::pow(change - mean, 2) / 3;
    const double of_time = std::min(between, square * centre.value * centre.value);
    effects.shares[drift] += of_time;
    whole += of_time;
    between -= of_time;
  }
  ModelQuantity q{wanted.quantity,
                  wanted.speed_rad_s,
                  estimate,
                  quantile(parts, 0.025),
                  quantile(parts, 0.975),
                  {},
                  {},
                  {}};
  for (std::size_t e = 0; e < m_.effects.size(); ++e) {
    if (m_.effects[e].effect->kind == Kind::core) continue;
    q.shares.push_back({m_.effects[e].effect->key, effects.shares[e] / whole});
  }
  q.shares.push_back({"choice_of_law", between / (between + whole)});
  std::stable_sort(
      q.shares.begin(), q.shares.end(),
      [](const VarianceShare& a, const VarianceShare& b) { return a.share > b.share; });
  return q;
}

std::optional<statistics::Estimate> Describer::friction_of(const std::vector<Cell>& contacts,
                                                           const Effect* by_turn) const {
  const std::array of_friction{&joint::effect::load, &joint::effect::position,
                               &joint::effect::drift, by_turn};
  if (contacts.empty() || !(m_.point.friction_Nm > 0)) return std::nullopt;
  Cells there = m_.cells;
  there.rows.insert(there.rows.end(), contacts.begin(), contacts.end());
  const auto count = static_cast<Index>(contacts.size());
  // Any speed will do for effects that do not depend on it.
  const double speed = median(m_.cells.of(&Cell::speed_rad_s));
  for (std::size_t k = there.rows.size() - contacts.size(); k < there.rows.size(); ++k) {
    there.rows[k].speed_rad_s = speed;
    there.rows[k].interval_s = m_.cells.rows.front().interval_s;
  }
  Wanted share{{}, 0, VectorXd::Zero(m_.first.back())};
  const bool has_gravity = m_.find(joint::effect::gravity.key) < m_.effects.size();
  for (const EffectColumns& e : effect_columns(there, has_gravity, m_.point, m_.sizes)) {
    const bool is_asked =
        std::any_of(of_friction.begin(), of_friction.end(),
                    [&](const Effect* one) { return one != nullptr && one->key == e.effect->key; });
    const std::size_t at = m_.find(e.effect->key);
    if (!is_asked || at == m_.effects.size()) continue;
    share.row.segment(m_.first[at], m_.width(at)) =
        e.columns.bottomRows(count).colwise().mean().transpose() / m_.point.friction_Nm;
  }
  put_gain(contacts, share.row);
  double of_one = 0;
  if (const std::size_t own = m_.find(joint::effect::friction_of_recording.key);
      own < m_.effects.size()) {
    of_one = deviation_of(own) / m_.point.friction_Nm / std::sqrt(static_cast<double>(count));
  }
  return wider(share, std::hypot(of_one, own_gain(contacts)));
}

std::optional<statistics::Estimate> Describer::gain_of(const std::vector<Cell>& contacts) const {
  if (contacts.empty()) return std::nullopt;
  Wanted share{{}, 0, VectorXd::Zero(m_.first.back())};
  put_gain(contacts, share.row);
  return wider(share, own_gain(contacts));
}

void Describer::put_gain(const std::vector<Cell>& contacts, VectorXd& row) const {
  const std::size_t at = m_.find(joint::effect::torque_nonlinear.key);
  if (at == m_.effects.size()) return;
  const double count = static_cast<double>(contacts.size());
  for (const Cell& one : contacts) {
    const double load =
        std::abs(m_.point.gravity_cos_Nm * one.cos_q + m_.point.gravity_sin_Nm * one.sin_q) /
        m_.point.top_Nm;
    row.segment(m_.first[at], 2) += Eigen::Vector2d(2 * load, 3 * load * load) / count;
  }
}

double Describer::own_gain(const std::vector<Cell>& contacts) const {
  const Effect& gain = joint::effect::gain_of_runs;
  const std::size_t at = m_.find(gain.key);
  constexpr double of_percent = 0.01;
  const double own = at < m_.effects.size() ? deviation_of(at) : of_percent * m_.sizes.of(gain);
  // A slope depends on the form of what is taken off more than the torque does.
  constexpr double of_slope = 0.4;
  VectorXd row = VectorXd::Zero(m_.first.back());
  put_gain(contacts, row);
  return std::hypot(own, of_slope * row.dot(best_.mean.head(row.size())));
}

std::optional<statistics::Estimate> Describer::wider(const Wanted& share, double by) const {
  if (share.row.isZero() && by == 0) return std::nullopt;
  const statistics::Estimate found = describe(share).as_estimate();
  return statistics::symmetric_estimate(
      found.value, std::hypot(found.half_width(), statistics::normal_975 * by), found.method);
}

ModelEffect Describer::describe_effect(std::size_t e) const {
  const Effect& effect = *m_.effects[e].effect;
  const VectorXd mean = mean_of(e);
  std::optional<statistics::Estimate> coefficient;
  if (effect.kind == Kind::effect && m_.width(e) == 1) {
    Wanted own{{}, 0, VectorXd::Zero(m_.first.back())};
    own.row[m_.first[e]] = 1;
    coefficient = describe(own).as_estimate();
  }
  const ArrayXd torque = (m_.effects[e].columns * mean).array();
  Index at = 0;
  torque.abs().maxCoeff(&at);
  const VectorXd there = m_.effects[e].columns.row(at).transpose();
  const MatrixXd own = best_.covariance.block(m_.first[e], m_.first[e], m_.width(e), m_.width(e));
  return {effect.key,
          effect.kind == Kind::effect ? mean.dot(effects_[e].solve(mean)) : std::nan(""),
          static_cast<double>(m_.width(e)),
          std::sqrt(torque.square().mean()),
          statistics::symmetric_estimate(
              std::abs(torque[at]),
              statistics::normal_975 * std::sqrt(std::max(0.0, there.dot(own * there))),
              {"interval.of_model"}),
          1 / std::sqrt(m_.precision[static_cast<Index>(e)]) / effect.cap,
          coefficient};
}

}  // namespace

const ModelQuantity* ModelResult::find(Quantity quantity) const {
  const auto found = std::find_if(quantities.begin(), quantities.end(),
                                  [&](const ModelQuantity& q) { return q.quantity == quantity; });
  return found == quantities.end() ? nullptr : &*found;
}

const ModelEffect* ModelResult::find(std::string_view effect) const {
  const auto found = std::find_if(effects.begin(), effects.end(),
                                  [&](const ModelEffect& e) { return e.key == effect; });
  return found == effects.end() ? nullptr : &*found;
}

namespace {

/// Friction in both directions at a few of the speeds; between them what a direction has beside the
/// mean, which changes slowly with the speed, is that of its neighbours.
void describe_directions(const JointModel& model, const Describer& describer,
                         std::vector<ModelQuantity>& quantities) {
  std::vector<ModelQuantity*> all;
  for (ModelQuantity& q : quantities) {
    if (!q.quantity) all.push_back(&q);
  }
  const bool differ = model.find(joint::effect::offset.key) < model.effects.size() ||
                      model.find(joint::effect::asymmetry.key) < model.effects.size();
  if (!differ) {
    for (ModelQuantity* q : all) q->forward = q->backward = q->as_estimate();
    return;
  }
  constexpr std::size_t most = 24;
  const std::size_t step = std::max<std::size_t>(1, all.size() / most);
  std::vector<std::size_t> described;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (k % step != 0 && k + 1 != all.size()) continue;
    const double speed_rad_s = all[k]->speed_rad_s;
    all[k]->forward = describer.describe({{}, speed_rad_s, {}, false, 1}).as_estimate();
    all[k]->backward = describer.describe({{}, speed_rad_s, {}, false, -1}).as_estimate();
    described.push_back(k);
  }
  for (std::size_t i = 1; i < described.size(); ++i) {
    const ModelQuantity& a = *all[described[i - 1]];
    const ModelQuantity& b = *all[described[i]];
    for (std::size_t k = described[i - 1] + 1; k < described[i]; ++k) {
      ModelQuantity& q = *all[k];
      const double share =
          std::log(q.speed_rad_s / a.speed_rad_s) / std::log(b.speed_rad_s / a.speed_rad_s);
      const auto between = [&](const statistics::Estimate& before,
                               const statistics::Estimate& behind) {
        statistics::Estimate e = q.as_estimate();
        for (double statistics::Estimate::* const member :
             {&statistics::Estimate::value, &statistics::Estimate::low,
              &statistics::Estimate::high}) {
          e.*member = q.estimate + (1 - share) * (before.*member - a.estimate) +
                      share * (behind.*member - b.estimate);
        }
        return e;
      };
      q.forward = between(*a.forward, *b.forward);
      q.backward = between(*a.backward, *b.backward);
    }
  }
}

}  // namespace

ModelResult describe_joint_model(const JointModel& model, const std::vector<double>& speeds_rad_s) {
  ModelResult result;
  result.cells = model.cells.rows.size();
  result.left_out = model.left_out;
  if (model.empty()) return result;
  result.friction_Nm = model.point.friction_Nm;
  result.top_Nm = model.point.top_Nm;
  result.samples_per_independent = model.samples_per_independent;
  result.cells_far_off = (model.weight < far_off_weight &&
                          model.residual_Nm.abs() > far_off_share * model.point.friction_Nm)
                             .cast<double>()
                             .mean();
  result.unlike_left = unlike_recordings(model).size();
  std::vector<Wanted> wanted;
  if (model.find("gravity") < model.effects.size()) {
    wanted = {{Quantity::gravity_torque}, {Quantity::cog_angle}};
  }
  wanted.push_back({Quantity::coulomb_torque});
  wanted.push_back({Quantity::viscous_coefficient});
  if (model.find("inertia") < model.effects.size()) wanted.push_back({Quantity::inertia});
  const double slowest = slowest_stated(model.cells);
  const double fastest = model.cells.of(&Cell::speed_rad_s).maxCoeff();
  for (const double speed : speeds_rad_s) {
    if (speed >= 0.95 * slowest && speed <= 1.05 * fastest) wanted.push_back({{}, speed});
  }
  const Describer describer(model);
  const ArrayXd q = model.cells.of(&Cell::q_rad);
  const double middle = (q.minCoeff() + q.maxCoeff()) / 2;
  for (const Wanted& one : wanted) {
    ModelQuantity found = describer.describe(one);
    if (found.quantity == Quantity::cog_angle) {
      const double turns = wrapped(found.estimate, middle) - found.estimate;
      for (double* value : {&found.estimate, &found.low, &found.high}) *value += turns;
    }
    result.quantities.push_back(std::move(found));
  }
  describe_directions(model, describer, result.quantities);
  result.law = law_of(model);
  constexpr double seen_of_dip = 0.5;
  if (result.law.has_dip() && slowest <= seen_of_dip * result.law.dip_rad_s) {
    result.rest_Nm = describer.describe({{}, 0, {}, true}).as_estimate();
  }
  for (std::size_t e = 0; e < model.effects.size(); ++e) {
    result.effects.push_back(describer.describe_effect(e));
  }
  result.friction_of_loops = describer.friction_of(model.cells.contacts.loops, nullptr);
  result.friction_of_ramps =
      describer.friction_of(model.cells.contacts.ramps, &joint::effect::motor_turn);
  result.gain_of_loops = describer.gain_of(model.cells.contacts.loops);
  return result;
}

namespace {

/// The effect of a lag that a model shows beyond doubt. Absent: it shows none; or so large a one
/// that it is zero; or starts and stops do not show the inertia either, and no corner shows its
/// lag.
std::optional<ModelEffect> plain_lag_of(const JointModel& model) {
  constexpr double widest_inertia = 0.25;
  if (model.empty()) return std::nullopt;
  const std::size_t lag = model.find(joint::effect::lag.key);
  const bool has_inertia = model.find(joint::effect::inertia.key) < model.effects.size();
  if (lag == model.effects.size() || !has_inertia) return std::nullopt;
  const Describer describer(model);
  ModelEffect effect = describer.describe_effect(lag);
  if (!effect.is_plain() || effect.is_near_cap()) return std::nullopt;
  const statistics::Estimate inertia = describer.describe({Quantity::inertia}).as_estimate();
  if (!(inertia.half_width() < widest_inertia * inertia.value)) return std::nullopt;
  return effect;
}

/// A model of cells whose torque was moved back by the lag that it shows: the columns are linear in
/// the lag, and a corner of the speed is not.
struct AlignedModel {
  JointModel model;
  double taken_off_s{};
  std::optional<ModelEffect> shown;  ///< Before; absent: nothing was taken off.
};

AlignedModel aligned_model(const std::vector<const joint::Recording*>& recordings,
                           const std::vector<joint::FrictionPoints>& points, double gear_ratio,
                           bool has_gravity, const joint::EffectSizes& sizes) {
  constexpr int most_times = 3;
  AlignedModel made;
  for (int k = 0;; ++k) {
    made.model =
        fit_joint_model(make_cells(recordings, points, gear_ratio, has_gravity, made.taken_off_s),
                        has_gravity, sizes);
    const std::optional<ModelEffect> lag = plain_lag_of(made.model);
    if (k == most_times || !lag) return made;
    if (!made.shown) made.shown = lag;
    made.taken_off_s += present(lag->coefficient).value;
  }
}

}  // namespace

ModelResult identify_joint(const std::vector<const joint::Recording*>& recordings,
                           const std::vector<joint::FrictionPoints>& points, double gear_ratio,
                           bool has_gravity, const joint::EffectSizes& sizes) {
  constexpr double step = 0.039;  // of log speed: within 2 % of any
  const AlignedModel aligned = aligned_model(recordings, points, gear_ratio, has_gravity, sizes);
  const JointModel& model = aligned.model;
  std::vector<double> speeds;
  if (!model.empty()) {
    const double low = slowest_stated(model.cells);
    const double span = std::log(model.cells.of(&Cell::speed_rad_s).maxCoeff() / low);
    constexpr double one_speed = 1e-9;  // apart by rounding alone
    const auto steps = static_cast<int>(std::ceil((span - one_speed) / step));
    for (int k = 0; k <= steps; ++k) {
      speeds.push_back(low * std::exp(span * k / std::max(steps, 1)));
    }
  }
  ModelResult result = describe_joint_model(model, speeds);
  for (ModelEffect& effect : result.effects) {
    if (!aligned.shown || effect.key != joint::effect::lag.key) continue;
    statistics::Estimate lag = present(effect.coefficient);
    for (double* value : {&lag.value, &lag.low, &lag.high}) *value += aligned.taken_off_s;
    effect = *aligned.shown;
    effect.coefficient = lag;
  }
  return result;
}

}  // namespace tribolog::method::model
