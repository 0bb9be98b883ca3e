#include "method/session/session_friction.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <Eigen/Core>

#include "joint/degrees.h"
#include "method/gravity/sweep_regression.h"
#include "method/session/condition_regression.h"
#include "method/session/oscillation_levels.h"
#include "method/session/session_times.h"
#include "method/session/stroke_pairs.h"
#include "statistics/distributions.h"
#include "statistics/linear_systems.h"

namespace tribolog::method::session {
namespace {

constexpr double largest_chance = 0.003;
// Half of what makes the Coulomb torque wrong: 1 % of friction.
constexpr double matters = 0.01;
// And of the gravity torque: 0.05 %.
constexpr double matters_of_gravity = 0.0005;
constexpr double least_change_of_load = 0.1;
constexpr double least_travel_rad = 0.5;
// Speeds that differ by this factor separate a lag from a torque that depends on the angle.
constexpr double lag_speed_ratio = 3;
constexpr std::size_t fewest_pairs_of_offsets = 3;

constexpr Code interval_method{"interval.least_squares_blocks"};

std::optional<GravityGuess> guess_of(const SessionInput& in) {
  if (in.rough.found) return GravityGuess{in.rough.q_peak_rad.value, in.rough.gravity_Nm.value};
  if (in.run_gravity.found) {
    return GravityGuess{in.run_gravity.q_peak_rad.value, in.run_gravity.gravity_Nm.value};
  }
  return std::nullopt;
}

struct Range {
  double low_rad{}, high_rad{}, least_load{1}, largest_load{0};
  ReferenceCondition reference;  ///< Of the runs; without any, of the sweep.
};

/// Angles, about the peak, and loads that the cells cover.
Range range_of(const StrokePairs& strokes, double q_peak) {
  Range range;
  range.low_rad = range.high_rad = strokes.cells.front().q_rad - q_peak;
  double counted = 0;
  const bool has_runs = std::any_of(strokes.pairs.begin(), strokes.pairs.end(),
                                    [](const StrokePair& p) { return !p.of_sweep; });
  for (const StrokeCell& cell : strokes.cells) {
    const double x = cell.q_rad - q_peak;
    const double load = std::abs(std::cos(x));
    range.low_rad = std::min(range.low_rad, x);
    range.high_rad = std::max(range.high_rad, x);
    range.least_load = std::min(range.least_load, load);
    range.largest_load = std::max(range.largest_load, load);
    if (has_runs && strokes.pairs[cell.pair].of_sweep) continue;
    range.reference.load += load;
    range.reference.angle += angle_terms(x);
    counted += 1;
  }
  range.reference.load /= counted;
  range.reference.angle /= counted;
  return range;
}

statistics::Estimate estimate(const ConditionFit& fit, Eigen::Index k, double factor) {
  return statistics::symmetric_estimate(factor * fit.regression.coefficients(k),
                                        std::abs(factor) * fit.regression.half_width(k),
                                        interval_method);
}

/// Angle-dependent part of friction at x, less what a constant and the load can imitate.
class AnglePattern {
 public:
  explicit AnglePattern(const Range& range) {
    constexpr Eigen::Index points = 61;
    x_ = Eigen::VectorXd::LinSpaced(points, range.low_rad, range.high_rad);
    Eigen::MatrixXd other(points, 2);
    rows_.resize(points, 3);
    for (Eigen::Index i = 0; i < points; ++i) {
      other.row(i) << 1, std::abs(std::cos(x_(i)));
      rows_.row(i) = angle_terms(x_(i));
    }
    // Where the load hardly changes it is equivalent to the constant.
    if (range.largest_load - range.least_load < least_change_of_load) other.col(1).setZero();
    rows_ = statistics::left_by_columns(other, rows_);
  }

  void read(const ConditionFit& fit, AngleEffect& out) const {
    const Eigen::VectorXd f = rows_ * fit.regression.coefficients.segment<3>(fit.angle);
    Eigen::Index most = 0;
    Eigen::Index least = 0;
    f.maxCoeff(&most);
    f.minCoeff(&least);
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(fit.regression.coefficients.size());
    gradient.segment<3>(fit.angle) = (rows_.row(most) - rows_.row(least)).transpose() / 2;
    out.amplitude = statistics::symmetric_estimate(
        (f(most) - f(least)) / 2, fit.regression.half_width_along(gradient), interval_method);
    out.largest_at_rad = x_(most);
    out.smallest_at_rad = x_(least);
  }

 private:
  Eigen::VectorXd x_;
  Eigen::MatrixXd rows_;
};

class Examination {
 public:
  Examination(const SessionInput& in, const GravityGuess& gravity, const SessionTimes& times,
              StrokePairs strokes)
      : in_(in),
        gravity_(gravity),
        times_(times),
        strokes_(std::move(strokes)),
        range_(range_of(strokes_, gravity.q_peak_rad)) {
    double slowest = strokes_.pairs.front().speed_rad_s;
    double fastest = slowest;
    for (const StrokePair& p : strokes_.pairs) {
      slowest = std::min(slowest, p.speed_rad_s);
      fastest = std::max(fastest, p.speed_rad_s);
    }
    const bool several = strokes_.pairs.size() >= fewest_pairs_of_offsets;
    can_load_ = range_.largest_load - range_.least_load > least_change_of_load;
    can_angle_ = range_.high_rad - range_.low_rad > least_travel_rad;
    terms_.load = can_load_;
    terms_.asymmetry = terms_.drift_of_offset = several;
    terms_.lag = several && fastest > lag_speed_ratio * slowest;
  }

  void run(SessionFriction& out) {
    terms_.second_of_angle = can_angle_;
    terms_.second_of_angle = can_angle_ && fit({}).chance_second < 0.01;
    ConditionFit first = full_fit({});
    // A share of friction refers to the level, not to the mean over what each pair covers.
    constexpr int rounds = 2;
    for (int k = 0; k == 0 || (k < rounds && shows_angle(first)); ++k) {
      for (std::size_t p = 0; p < strokes_.pairs.size(); ++p) {
        strokes_.pairs[p].friction_Nm = first.level_Nm[p];
      }
      first = full_fit({});
    }
    find_drift(first, out);
    std::vector<double> taken_off;
    if (out.drift.found) taken_off = torque_of_drift(first, out.drift);
    find_conditions(taken_off, out);
    if (!out.drift.found) return;
    out.rough_shift = shift_of(in_.rough_sweep, in_.rough, false, out);
    out.precise_shift = shift_of(in_.precise_sweep, in_.precise, in_.rough.found, out);
  }

 private:
  [[nodiscard]] bool shows_angle(const ConditionFit& fit) const {
    if (fit.angle < 0 || fit.chance_of(fit.angle, 3) >= largest_chance) return false;
    AngleEffect effect;
    AnglePattern(range_).read(fit, effect);
    return effect.amplitude.value > matters;
  }

  struct Tested {
    ConditionFit fit;
    double chance_second{1};
  };

  [[nodiscard]] Tested fit(const std::vector<double>& taken_off) const {
    Tested t{fit_conditions(strokes_, gravity_, range_.reference, terms_, taken_off)};
    if (t.fit.second >= 0) t.chance_second = t.fit.chance_of(t.fit.second, 2);
    return t;
  }

  /// With the angle's terms.
  [[nodiscard]] ConditionFit full_fit(const std::vector<double>& taken_off) const {
    ConditionTerms all = terms_;
    all.angle = can_angle_;
    return fit_conditions(strokes_, gravity_, range_.reference, all, taken_off);
  }

  void find_drift(const ConditionFit& fit, SessionFriction& out) const {
    std::vector<FrictionLevel> levels = oscillation_levels(in_.recordings, times_);
    for (std::size_t p = 0; p < strokes_.pairs.size(); ++p) {
      FrictionLevel level;
      level.speed_rad_s = strokes_.pairs[p].speed_rad_s;
      level.friction_Nm = fit.level_Nm[p];
      level.standard_error_Nm = fit.level_error_Nm[p];
      constexpr int points = 5;
      for (const std::size_t stroke : {0U, 2U}) {
        const double from = strokes_.pairs[p].session_share[stroke];
        const double to = strokes_.pairs[p].session_share[stroke + 1];
        for (int k = 0; k < points; ++k) {
          level.session_share.push_back(std::lerp(from, to, (k + 0.5) / points));
        }
      }
      if (level.friction_Nm > 0) levels.push_back(std::move(level));
    }
    out.drift = fit_friction_drift(levels);
  }

  [[nodiscard]] std::vector<double> torque_of_drift(const ConditionFit& fit,
                                                    const FrictionDrift& drift) const {
    std::vector<double> torque;
    for (const StrokeCell& cell : strokes_.cells) {
      const double g = progress(cell.session_share, drift.time_constant);
      const double level = fit.level_Nm[cell.pair] / (1 + drift.change * g);
      torque.push_back(cell.direction * level * drift.change * g);
    }
    return torque;
  }

  void find_conditions(const std::vector<double>& taken_off, SessionFriction& out) {
    const ConditionFit plain = fit(taken_off).fit;
    const ConditionFit with_angle = can_angle_ ? full_fit(taken_off) : plain;
    if (can_angle_) {
      out.angle.examined = true;
      AnglePattern(range_).read(with_angle, out.angle);
      out.angle.found = shows_angle(with_angle);
    }
    const ConditionFit& used = out.angle.found ? with_angle : plain;
    double mean = 0;
    for (const double level : used.level_Nm)
      mean += level / static_cast<double>(used.level_Nm.size());
    out.mean_friction_Nm = mean;
    if (can_load_) read_load(plain, used, out);
    if (terms_.asymmetry) read_direction(used, out);
  }

  void read_load(const ConditionFit& plain, const ConditionFit& used, SessionFriction& out) const {
    LoadEffect& load = out.load;
    load.examined = true;
    load.per_load = estimate(used, used.load, 1);
    load.friction_Nm = out.mean_friction_Nm;
    load.reference_load = range_.reference.load;
    const double per_load = load.per_load.value;
    load.unloaded_Nm =
        out.mean_friction_Nm - per_load * gravity_.gravity_Nm * range_.reference.load;
    load.at_peak_Nm = load.unloaded_Nm + per_load * gravity_.gravity_Nm;
    const double change = range_.largest_load - range_.least_load;
    const auto is_large = [&](double coefficient) {
      return std::abs(coefficient) * gravity_.gravity_Nm * std::max(change, range_.reference.load) >
             matters * out.mean_friction_Nm;
    };
    const double alone = plain.regression.coefficients(plain.load);
    const bool certain = plain.chance_of(plain.load, 1) < largest_chance;
    load.found =
        per_load > 0 && used.chance_of(used.load, 1) < largest_chance && is_large(per_load);
    // The angle can imitate it as well: friction that is least at the gravity peak is not due to
    // load.
    if (certain && alone < 0 && is_large(alone) && !out.angle.found) {
      out.angle.found = true;
      out.angle.amplitude = statistics::scaled(
          estimate(plain, plain.load, 1), -gravity_.gravity_Nm * change / 2 / out.mean_friction_Nm);
    }
    load.viscous_Nms_rad = viscous_of_load(per_load);
  }

  /// Slope over speed that the load causes in the runs.
  [[nodiscard]] double viscous_of_load(double per_load) const {
    std::vector<double> load(strokes_.pairs.size(), 0.0);
    std::vector<double> count(strokes_.pairs.size(), 0.0);
    for (const StrokeCell& cell : strokes_.cells) {
      load[cell.pair] += std::abs(std::cos(cell.q_rad - gravity_.q_peak_rad));
      count[cell.pair] += 1;
    }
    double n = 0;
    double v = 0;
    double l = 0;
    double vv = 0;
    double vl = 0;
    for (std::size_t p = 0; p < strokes_.pairs.size(); ++p) {
      if (strokes_.pairs[p].of_sweep) continue;
      const double speed = strokes_.pairs[p].speed_rad_s;
      const double mean = load[p] / count[p];
      n += 1;
      v += speed;
      l += mean;
      vv += speed * speed;
      vl += speed * mean;
    }
    const double spread = n * vv - v * v;
    return spread > 0 ? per_load * gravity_.gravity_Nm * (n * vl - v * l) / spread : 0.0;
  }

  void read_direction(const ConditionFit& used, SessionFriction& out) const {
    DirectionEffect& d = out.direction;
    d.examined = true;
    d.asymmetry = estimate(used, used.asymmetry, 1);
    d.offset_Nm = estimate(used, used.offset, 1);
    const bool asymmetric = used.chance_of(used.asymmetry, 1) < largest_chance &&
                            std::abs(d.asymmetry.value) > matters / 2;
    const bool has_offset = used.chance_of(used.offset, 1) < largest_chance &&
                            std::abs(d.offset_Nm.value) > matters_of_gravity * gravity_.gravity_Nm;
    // All of the offset as an asymmetry.
    const double as_asymmetry = d.offset_Nm.value / out.mean_friction_Nm;
    const double from_all = std::abs(d.asymmetry.value - as_asymmetry);
    const double slack =
        std::hypot(d.asymmetry.half_width(), d.offset_Nm.half_width() / out.mean_friction_Nm);
    const bool may_be_asymmetry = from_all < 1.5 * slack;
    d.told_apart = asymmetric || (has_offset && !may_be_asymmetry);
    d.asymmetry_found = asymmetric || (has_offset && may_be_asymmetry);
    d.offset_found = has_offset && !(asymmetric && may_be_asymmetry);

    OffsetDrift& drift = out.offset_drift;
    drift.examined = true;
    drift.change_Nm = estimate(used, used.offset_drift, 1);
    // The residual of a slightly wrong course of friction's change looks like a change of the
    // offset.
    constexpr double imitated = 0.15;
    const double by_friction =
        out.drift.found ? imitated * std::abs(out.drift.change) * out.mean_friction_Nm : 0;
    drift.found = used.chance_of(used.offset_drift, 1) < largest_chance &&
                  std::abs(drift.change_Nm.value) >
                      std::max(by_friction, matters_of_gravity * gravity_.gravity_Nm);
    const std::optional<double> sweep = mean_time(joint::Role::rough_sweep);
    const std::optional<double> loops = mean_time(joint::Role::oscillation);
    if (sweep && loops) drift.to_oscillations_Nm = drift.change_Nm.value * (*loops - *sweep);
  }

  /// Of all recordings of a role, as a share of the session.
  [[nodiscard]] std::optional<double> mean_time(joint::Role role) const {
    double sum = 0;
    double n = 0;
    for (std::size_t i = 0; i < in_.recordings.size(); ++i) {
      const joint::Recording& r = in_.recordings[i];
      if (r.role != role || r.size() < 2) continue;
      sum += times_.share(i, r, (r.t_s.front() + r.t_s.back()) / 2);
      n += 1;
    }
    if (n == 0) return std::nullopt;
    return sum / n;
  }

  /// Shift of a sweep's results where it ignores friction's change.
  [[nodiscard]] std::optional<SweepShift> shift_of(const motion::Sweep& sweep,
                                                   const gravity::CogSweepResult& found,
                                                   bool amplitude_known,
                                                   const SessionFriction& out) const {
    if (!found.found) return std::nullopt;
    const FrictionDrift& drift = out.drift;
    const double friction = found.coulomb_Nm ? found.coulomb_Nm->value : out.mean_friction_Nm;
    // Friction follows no curve of ours exactly; without a common clock, nor do we know when.
    const double least_slack = out.by_clock ? 0.4 : 0.7;
    SweepShift shift;
    const gravity::GravityShift best =
        effect_of(sweep, found, amplitude_known, friction, drift.change, drift.time_constant);
    shift.q_peak_rad = best.q_peak_rad;
    shift.gravity_Nm = best.gravity_Nm;
    shift.q_peak_slack_rad = least_slack * std::abs(best.q_peak_rad);
    shift.gravity_slack_Nm = least_slack * std::abs(best.gravity_Nm);
    for (std::size_t k = 0; k < drift.other_time_constants.size(); ++k) {
      const gravity::GravityShift other =
          effect_of(sweep, found, amplitude_known, friction, drift.other_changes[k],
                    drift.other_time_constants[k]);
      shift.q_peak_slack_rad =
          std::max(shift.q_peak_slack_rad, std::abs(other.q_peak_rad - best.q_peak_rad));
      shift.gravity_slack_Nm =
          std::max(shift.gravity_slack_Nm, std::abs(other.gravity_Nm - best.gravity_Nm));
    }
    // The size of the change is no more certain than its interval.
    const double share = (drift.high - drift.low) / 2 / std::abs(drift.change);
    shift.q_peak_slack_rad = std::hypot(shift.q_peak_slack_rad, share * best.q_peak_rad);
    shift.gravity_slack_Nm = std::hypot(shift.gravity_slack_Nm, share * best.gravity_Nm);
    return shift;
  }

  /// Of a sweep's recording among those of the session.
  [[nodiscard]] std::size_t number_of(const joint::Recording& recording) const {
    const auto at = std::find_if(in_.recordings.begin(), in_.recordings.end(),
                                 [&](const joint::Recording& r) { return &r == &recording; });
    if (at == in_.recordings.end()) throw std::logic_error("unknown recording");
    return static_cast<std::size_t>(at - in_.recordings.begin());
  }

  [[nodiscard]] gravity::GravityShift effect_of(const motion::Sweep& sweep,
                                                const gravity::CogSweepResult& found,
                                                bool amplitude_known, double friction_Nm,
                                                double change, double time_constant) const {
    const auto rows = static_cast<Eigen::Index>(sweep.samples.size());
    Eigen::VectorXd passed(rows);
    std::vector<std::size_t> numbers;
    for (const joint::Recording* recording : sweep.recordings) {
      numbers.push_back(number_of(*recording));
    }
    for (Eigen::Index row = 0; row < rows; ++row) {
      const auto i = static_cast<std::size_t>(row);
      const std::size_t of_sweep = sweep.samples.recording[i];
      const joint::Recording& recording = *sweep.recordings[of_sweep];
      passed(row) = progress(
          times_.share(numbers[of_sweep], recording, recording.t_s[sweep.samples.index[i]]),
          time_constant);
    }
    const double at_begin = friction_Nm / (1 + change * passed.mean());
    for (Eigen::Index row = 0; row < rows; ++row) {
      passed(row) *= sweep.samples.direction[static_cast<std::size_t>(row)] * at_begin * change;
    }
    return gravity::effect_on_gravity(sweep, found, amplitude_known, passed);
  }

  const SessionInput& in_;
  GravityGuess gravity_;
  const SessionTimes& times_;
  StrokePairs strokes_;
  Range range_;
  ConditionTerms terms_;
  bool can_load_{};
  bool can_angle_{};
};

}  // namespace

SessionFriction examine_session_friction(const SessionInput& in) {
  SessionFriction out;
  const SessionTimes times = session_times(in.recordings);
  out.by_clock = times.by_clock;
  out.whole_s = times.whole_s;
  const std::optional<GravityGuess> gravity = guess_of(in);
  StrokePairs strokes;
  if (gravity) strokes = find_stroke_pairs(in.recordings, times, in.gear_ratio, in.rough.ripple);
  out.pairs = strokes.pairs.size();
  constexpr std::size_t fewest_cells = 24;
  if (strokes.cells.size() < fewest_cells) {
    out.drift = fit_friction_drift(oscillation_levels(in.recordings, times));
    out.sentence = gravity ? Statement{"session.too_few_strokes", {{"pairs", out.pairs}}}
                           : Statement{"session.gravity_not_known"};
    return out;
  }
  out.examined = true;
  out.gravity_Nm = gravity->gravity_Nm;
  Examination(in, *gravity, times, std::move(strokes)).run(out);
  out.sentence = {"session.examined", {{"pairs", out.pairs}}};
  return out;
}

}  // namespace tribolog::method::session
