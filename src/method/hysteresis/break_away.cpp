#include "method/hysteresis/break_away.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "method/hysteresis/break_away_ramp.h"
#include "method/hysteresis/loop_widening.h"
#include "method/hysteresis/position_mean.h"
#include "method/hysteresis/ramp_mean.h"
#include "statistics/distributions.h"

namespace tribolog::method::hysteresis {

namespace {

/// A mean of ramps with what they scatter.
struct PlainMean {
  double value{};
  double half_width{};
};

/// Absent with fewer than two.
std::optional<PlainMean> plain_mean(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  if (n < 2) return std::nullopt;
  double mean = 0;
  for (const double v : values) mean += v / n;
  double squares = 0;
  for (const double v : values) squares += std::pow(v - mean, 2);
  return PlainMean{mean, statistics::student_t_975(n - 1) * std::sqrt(squares / (n - 1) / n)};
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

/// Difference of readings and levels of one direction beyond their scatter: which of the two is the
/// joint's, another contact decides.
double difference_beyond_scatter_Nm(const BreakAwayResult& result, bool is_rising) {
  std::vector<double> readings;
  std::vector<double> levels;
  for (const BreakAwayRamp& ramp : result.ramps) {
    if (!ramp.broke_away || ramp.is_rising != is_rising) continue;
    readings.push_back(ramp.friction_Nm);
    if (ramp.level_Nm) levels.push_back(*ramp.level_Nm);
  }
  const std::optional<PlainMean> reading = plain_mean(readings);
  const std::optional<PlainMean> level = plain_mean(levels);
  if (!reading || !level) return 0;
  const double difference = std::abs(reading->value - share_at_reading * level->value);
  return difference > std::hypot(reading->half_width, level->half_width) ? difference : 0;
}

/// What the sweep shows of friction over the motor's turn, in shares of friction.
FrictionOverTurn friction_over_turn(const KnownOfRamps& known) {
  const gravity::CogSweepResult& sweep = known.sweep;
  const bool is_shown = sweep.found && sweep.coulomb_Nm && sweep.coulomb_Nm->value > 0;
  // A sweep that shows a motor's turn leaves little that it does not.
  constexpr double not_shown = 0.3;
  FrictionOverTurn out;
  out.share = known.gravity ? known.friction_of_turn * (is_shown ? not_shown : 1) : 0;
  if (!is_shown || !(sweep.friction_by_angle_Nm > 0)) return out;
  // What holds a joint need not change by the same share as what slides.
  constexpr double more_than_sliding = 1.25;
  constexpr double most = 0.9;
  double share = more_than_sliding / sweep.coulomb_Nm->value;
  // Of what was read, which may be the smallest.
  share /= 1 - std::min(most, statistics::normal_975 * share * sweep.friction_by_angle_Nm);
  for (gravity::RippleLine line : sweep.friction_of_angle.lines) {
    line.amplitude_Nm *= share;
    out.orders.push_back(line);
  }
  out.elsewhere = share * sweep.friction_of_angle.rest_Nm;
  return out;
}

/// Those ramps that the values are of, and the bounds.
std::vector<RampRow> rows_of(const BreakAwayResult& result, const KnownOfRamps& known) {
  std::vector<RampRow> rows;
  std::vector<double> angles;
  for (const BreakAwayRamp& ramp : result.ramps) {
    const bool has_value = !result.is_level || ramp.level_Nm;
    // Without gravity taken off it bounds friction and gravity together.
    if (ramp.broke_away ? !has_value : !known.gravity) continue;
    RampRow row;
    row.is_rising = ramp.is_rising;
    row.broke_away = ramp.broke_away;
    const bool is_level = ramp.broke_away && result.is_level;
    row.held_Nm = is_level ? *ramp.level_Nm : ramp.friction_Nm;
    row.motor_angle_rad = known.gear_ratio * ramp.q_start_rad;
    if (known.gravity) {
      row.gravity_Nm = (ramp.is_rising ? 1 : -1) * known.gravity->amplitude_Nm.half_width() *
                       std::cos(ramp.q_start_rad - known.gravity->q_peak_rad);
    }
    if (!is_level) row.inertia_Nm = ramp.inertia_half_width_Nm;
    if (is_level && !ramp.even_slide_rad_s) {
      row.damping_Nm = known.behind.half_width_s * ramp.rate_Nm_s;
    }
    angles.push_back(row.motor_angle_rad);
    rows.push_back(row);
  }
  const std::vector<std::size_t> positions = position_numbers(angles);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].position = positions[i];
  return rows;
}

/// What the contact leaves open is added: it is no matter of chance.
std::optional<statistics::Estimate> with_contact(const std::optional<statistics::Estimate>& mean,
                                                 double by_contact_Nm, Code method) {
  if (!mean) return std::nullopt;
  return statistics::Estimate{
      mean->value, mean->low - by_contact_Nm, mean->high + by_contact_Nm, {method}};
}

void take_means(const KnownOfRamps& known, BreakAwayResult& result) {
  const RampMeans means = mean_of_ramps(rows_of(result, known), friction_over_turn(known));
  result.positions = means.positions;
  result.between_positions = means.between_positions;
  const bool is_open = result.is_level && !known.is_lugre;
  const double rising = is_open ? difference_beyond_scatter_Nm(result, true) : 0;
  const double falling = is_open ? difference_beyond_scatter_Nm(result, false) : 0;
  if (means.rising_Nm) result.apart = rising / means.rising_Nm->value;
  if (means.falling_Nm) {
    result.apart = std::max(result.apart, falling / means.falling_Nm->value);
  }
  const Code of_one{result.is_level ? Code{"interval.scatter_of_ramps_at_rest"}
                                    : Code{"interval.scatter_of_ramps"}};
  result.rising_Nm = with_contact(means.rising_Nm, rising, of_one);
  result.falling_Nm = with_contact(means.falling_Nm, falling, of_one);
  result.mean_Nm = with_contact(means.both_Nm, (rising + falling) / 2,
                                "interval.scatter_of_ramps_both_directions");
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
  take_means(known, out);
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
