#include "method/hysteresis/break_away.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/requirements.h"
#include "method/hysteresis/break_away_ramp.h"
#include "method/hysteresis/loop_widening.h"
#include "method/hysteresis/position_mean.h"
#include "statistics/distributions.h"
#include "statistics/group_mean.h"

namespace tribolog::method::hysteresis {

namespace {

/// Of the ramps of one direction that broke away; absent with fewer than two.
struct RampMean {
  double value{};
  double scatter{};  ///< 95 % half width.
};

std::optional<RampMean> mean_over(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  if (n < 2) return std::nullopt;
  double mean = 0;
  for (const double v : values) mean += v / n;
  double squares = 0;
  for (const double v : values) squares += std::pow(v - mean, 2);
  return RampMean{mean, statistics::student_t_975(n - 1) * std::sqrt(squares / (n - 1) / n)};
}

/// The ramps of one direction as means over their angles.
class OverAngles {
 public:
  /// @param has_gravity ramps at different angles differ by it: none can then be compared.
  OverAngles(const std::vector<double>& motor_angle_rad, bool has_gravity,
             const gravity::CogSweepResult& sweep)
      : share_of_sweep_(share_of_friction_left(sweep, motor_angle_rad)) {
    if (has_gravity) return;
    position_ = position_numbers(motor_angle_rad);
    for (const std::size_t number : position_) positions_ = std::max(positions_, number + 1);
  }

  /// Takes the mean over angles where ramps differ by them.
  /// @return 95 % half width of what the angles leave, beside the scatter of the ramps.
  [[nodiscard]] double take(const std::vector<double>& values, RampMean& mean) {
    std::vector<std::vector<double>> by_angle(positions_);
    for (std::size_t i = 0; i < position_.size(); ++i) by_angle[position_[i]].push_back(values[i]);
    const auto over_angles = statistics::mean_of_groups_that_differ(by_angle);
    const double by_sweep = share_of_sweep_ * std::abs(mean.value);
    constexpr double matters = 0.002;
    if (!over_angles) return by_sweep;
    const double between = over_angles->between_sd / std::abs(over_angles->mean);
    if (!(between > matters)) return by_sweep;
    between_ = between;
    mean = {over_angles->mean, 0};
    // Two say that there is a difference, not how large it is elsewhere: the sweep does.
    const bool is_told_by_sweep = positions_ == 2 && by_sweep > 0;
    const double by_ramps = is_told_by_sweep ? over_angles->largest_off : over_angles->half_width;
    return std::max(by_ramps, by_sweep);
  }
  [[nodiscard]] std::size_t positions() const { return positions_; }
  [[nodiscard]] double between() const { return between_; }

 private:
  std::vector<std::size_t> position_;
  std::size_t positions_{0};
  double share_of_sweep_{};
  double between_{0};
};

/// Half widths of what may shift both directions alike.
struct InCommon {
  double by_angle_Nm{};
  double by_inertia_Nm{};  ///< And by damping.
  double by_contact_Nm{};  ///< Between reading and level: the interval holds both.
};

/// Of one direction.
struct DirectionMean {
  statistics::Estimate torque_Nm;  ///< All in.
  double own_Nm{};                 ///< Half width of what is this direction's own.
  InCommon in_common;
};

DirectionMean direction_mean(double value, double own_Nm, const InCommon& common, Code method) {
  const Statement plain{method};
  const Statement why = common.by_angle_Nm > 0 ? Statement{"interval.widened_by_friction_of_angle",
                                                           {{"interval", plain}}}
                                               : plain;
  const double half_width =
      std::hypot(own_Nm, common.by_angle_Nm, common.by_inertia_Nm) + common.by_contact_Nm;
  return {statistics::symmetric_estimate(value, half_width, why), own_Nm, common};
}

/// Whether the ramps of a direction that broke away, if there are any, bend far enough to show
/// their levels: two at least, and all but every third.
bool has_levels(const std::vector<BreakAwayRamp>& ramps, bool is_rising) {
  std::size_t broke_away = 0;
  std::size_t levels = 0;
  for (const BreakAwayRamp& ramp : ramps) {
    if (!ramp.broke_away || ramp.is_rising != is_rising) continue;
    ++broke_away;
    levels += ramp.level_Nm ? 1 : 0;
  }
  constexpr std::size_t fewest = 2;
  return levels == broke_away || (levels >= fewest && 3 * levels >= 2 * broke_away);
}

/// @param result says whether the levels at rest are the values, which are compared with the
/// readings; `apart` is raised to the difference of these two beyond their noise; it receives what
/// the positions show.
std::optional<DirectionMean> mean_of(bool is_rising, const KnownOfRamps& known,
                                     BreakAwayResult& result) {
  const bool is_level = result.is_level;
  std::vector<double> readings;
  std::vector<double> levels;
  std::vector<double> motor_angles;
  double by_gravity = 0;
  double by_inertia = 0;
  double by_damping = 0;
  for (const BreakAwayRamp& ramp : result.ramps) {
    if (!ramp.broke_away || ramp.is_rising != is_rising) continue;
    readings.push_back(ramp.friction_Nm);
    if (is_level && ramp.level_Nm) levels.push_back(*ramp.level_Nm);
    if (!is_level || ramp.level_Nm) motor_angles.push_back(known.gear_ratio * ramp.q_start_rad);
    by_inertia += ramp.inertia_half_width_Nm;
    if (!ramp.even_slide_rad_s) by_damping += known.behind.half_width_s * ramp.rate_Nm_s;
    if (known.gravity) {
      by_gravity += known.gravity->amplitude_Nm.half_width() *
                    std::abs(std::cos(ramp.q_start_rad - known.gravity->q_peak_rad));
    }
  }
  std::optional<RampMean> reading = mean_over(readings);
  if (!reading) return std::nullopt;
  OverAngles angles(motor_angles, !known.gravity, known.sweep);
  by_gravity /= static_cast<double>(readings.size());
  by_inertia /= static_cast<double>(readings.size());
  by_damping /= static_cast<double>(readings.size());
  const auto told = [&] {
    result.positions = std::max(result.positions, angles.positions());
    result.between_positions = std::max(result.between_positions, angles.between());
  };
  if (!is_level) {
    const double by_angle = angles.take(readings, *reading);
    told();
    return direction_mean(reading->value, std::hypot(reading->scatter, by_gravity),
                          {by_angle, by_inertia, 0}, "interval.scatter_of_ramps");
  }
  RampMean level = present(mean_over(levels));
  const double difference = std::abs(reading->value - share_at_reading * level.value);
  const double noise = std::hypot(reading->scatter, level.scatter);
  // Which of the two is the joint's, another contact decides: beyond their noise the interval holds
  // both.
  const double by_contact = difference > noise && !known.is_lugre ? difference : 0;
  result.apart = std::max(result.apart, by_contact / level.value);
  const double by_angle = angles.take(levels, level);
  told();
  return direction_mean(level.value, std::hypot(level.scatter, by_gravity),
                        {by_angle, by_damping, by_contact}, "interval.scatter_of_ramps_at_rest");
}

/// Of both directions: their own errors average, what they have in common does not.
statistics::Estimate mean_of_both(const DirectionMean& rising, const DirectionMean& falling) {
  const InCommon& up = rising.in_common;
  const InCommon& down = falling.in_common;
  return direction_mean(
             (rising.torque_Nm.value + falling.torque_Nm.value) / 2,
             std::hypot(rising.own_Nm, falling.own_Nm) / 2,
             {(up.by_angle_Nm + down.by_angle_Nm) / 2, (up.by_inertia_Nm + down.by_inertia_Nm) / 2,
              (up.by_contact_Nm + down.by_contact_Nm) / 2},
             "interval.scatter_of_ramps_both_directions")
      .torque_Nm;
}

void add_reason(statistics::StageReport& stage, const Statement& reason) {
  stage.state = statistics::StageState::partial;
  stage.reason.add(reason);
}

/// What the ramps that did not break away say: the largest of their bounds.
void add_censored(BreakAwayResult& result) {
  const BreakAwayRamp* largest = nullptr;
  for (const BreakAwayRamp& ramp : result.ramps) {
    if (ramp.broke_away) continue;
    if (largest == nullptr || ramp.friction_Nm > largest->friction_Nm) largest = &ramp;
  }
  if (largest == nullptr) return;
  if (!(largest->friction_Nm > 0)) {
    add_reason(result.stage, {"break_away.censored_without_bound",
                              {{"count", result.censored}, {"ramps", result.ramps.size()}}});
    return;
  }
  add_reason(result.stage,
             {result.censored == 1 ? Code{"break_away.censored"} : Code{"break_away.some_censored"},
              {{"count", result.censored},
               {"ramps", result.ramps.size()},
               {"recording", largest->recording},
               {"torque_Nm", largest->torque_Nm},
               {"friction_Nm", largest->friction_Nm}}});
}

/// In which direction fewer than two ramps broke away.
Code too_few_ramps(const BreakAwayResult& result) {
  if (result.rising_Nm) return {"break_away.too_few_towards_negative"};
  if (result.falling_Nm) return {"break_away.too_few_towards_positive"};
  return {"break_away.too_few_in_either_direction"};
}

}  // namespace

BreakAwayResult identify_break_away(const std::vector<const joint::Recording*>& ramps,
                                    const KnownOfRamps& known) {
  BreakAwayResult out;
  out.stage.name = "break_away";
  out.gravity = known.gravity;
  if (ramps.empty()) {
    out.stage.state = statistics::StageState::skipped;
    out.stage.reason = {"break_away.no_ramps"};
    return out;
  }
  for (const joint::Recording* r : ramps) {
    if (r->size() < 3) continue;
    out.ramps.push_back(read_ramp(*r, out, known.inertia_at_joint, known.behind.time_s));
    out.censored += out.ramps.back().broke_away ? 0 : 1;
  }
  out.is_level = known.gravity && out.censored < out.ramps.size() && has_levels(out.ramps, true) &&
                 has_levels(out.ramps, false);
  const auto rising = mean_of(true, known, out);
  const auto falling = mean_of(false, known, out);
  if (rising) out.rising_Nm = rising->torque_Nm;
  if (falling) out.falling_Nm = falling->torque_Nm;
  if (rising && falling) out.mean_Nm = mean_of_both(*rising, *falling);
  out.stage.state = statistics::StageState::done;
  add_censored(out);
  if (!out.rising_Nm || !out.falling_Nm) add_reason(out.stage, too_few_ramps(out));
  if (!known.gravity) add_reason(out.stage, {"break_away.gravity_not_taken_off"});
  if (!out.rising_Nm && !out.falling_Nm) out.stage.state = statistics::StageState::not_identifiable;
  return out;
}

namespace {

/// Friction that the joint holds in one direction, beyond the scatter of its ramps. Of single
/// readings the largest would be their noise.
double surely_held(const BreakAwayResult& ramps, bool is_rising) {
  const std::optional<statistics::Estimate>& mean = is_rising ? ramps.rising_Nm : ramps.falling_Nm;
  double held = mean ? mean->low : 0;
  for (const BreakAwayRamp& ramp : ramps.ramps) {
    const bool is_in_mean = mean && ramp.broke_away;
    if (ramp.is_rising == is_rising && !is_in_mean) held = std::max(held, ramp.friction_Nm);
  }
  return held;
}

/// How friction falls with speed is read relative to the level.
bool rests_on_level(LuGreParameterName name) {
  return name == LuGreParameterName::coulomb_torque || name == LuGreParameterName::stribeck_speed ||
         name == LuGreParameterName::speed_weakening;
}

void withdraw(LuGreParameter& parameter, Statement why_not, Statement experiment) {
  parameter.estimate.reset();
  parameter.why_not = std::move(why_not);
  parameter.experiment = std::move(experiment);
}

}  // namespace

void refer_to_runs(const std::optional<statistics::Estimate>& difference, BreakAwayResult& ramps) {
  if (!difference) return;
  for (std::optional<statistics::Estimate>* mean :
       {&ramps.rising_Nm, &ramps.falling_Nm, &ramps.mean_Nm}) {
    if (*mean) *mean = at_the_runs(**mean, *difference);
  }
}

LuGreFit against_ramps(LuGreFit fit, const BreakAwayResult& ramps) {
  const auto level = fit.shown(LuGreParameterName::static_torque);
  if (!level || ramps.ramps.empty()) return fit;
  // Gravity that was not taken off helps one direction by what it hinders the other: the smaller
  // of the two is held in any case.
  const double rising = surely_held(ramps, true);
  const double falling = surely_held(ramps, false);
  const double held = rising > 0 && falling > 0 ? std::min(rising, falling) : 0;
  if (!(level->high < held)) return fit;
  const Statement contradiction{"lugre.contradicted_by_ramps",
                                {{"level_Nm", level->value}, {"held_Nm", held}}};
  for (LuGreParameter& p : fit.parameters) {
    if (p.name == LuGreParameterName::static_torque) {
      withdraw(p, contradiction, {"lugre_experiment.ramps_that_slide"});
    } else if (p.estimate && rests_on_level(p.name)) {
      withdraw(p, {"lugre.rests_on_contradicted_level"}, {"lugre_experiment.runs"});
    }
  }
  fit.reason.add(contradiction);
  return fit;
}

}  // namespace tribolog::method::hysteresis
