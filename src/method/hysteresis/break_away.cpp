#include "method/hysteresis/break_away.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "statistics/distributions.h"
#include "statistics/order_statistics.h"
#include "statistics/sampled_signal.h"

namespace tribolog::method::hysteresis {

namespace {

constexpr double fewest_steps = 20;      // across which a speed is taken
constexpr double share_of_travel = 0.1;  // so that creep and slip are seen at their own scale
constexpr double torque_on = 0.1;        // share of the largest torque that tells the direction

/// Sign of the ramp: that of the torque when it has first left its rest.
double direction_of(const joint::Recording& r) {
  double largest = 0;
  for (const double torque : r.torque_Nm) {
    largest = std::max(largest, std::abs(torque - r.torque_Nm.front()));
  }
  for (const double torque : r.torque_Nm) {
    const double change = torque - r.torque_Nm.front();
    if (std::abs(change) > torque_on * largest) return change < 0 ? -1.0 : 1.0;
  }
  return 1.0;
}

/// The usual step of the angle from sample to sample, standing still left out: the encoder's step
/// or its noise, whichever is seen.
double usual_step_rad(const std::vector<double>& q_rad) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < q_rad.size(); ++i) {
    if (q_rad[i] != q_rad[i - 1]) steps.push_back(std::abs(q_rad[i] - q_rad[i - 1]));
  }
  return steps.empty() ? 0.0 : statistics::median(std::move(steps));
}

/// Where the joint has moved `need` on from sample i, or the end.
std::size_t moved_on(const statistics::Summits& travel, std::size_t i, double need) {
  const double here = travel.signal()[i];
  return travel.first(i + 1, [&](double there) { return there - here >= need; });
}

/// Travel from break-away at sample `at` to where the joint has slowed down to a third of the speed
/// by which break-away was told.
std::optional<double> slip_until_stop(const joint::Recording& r, const statistics::Summits& summits,
                                      std::size_t at, std::size_t end, double least) {
  const std::vector<double>& travel = summits.signal();
  const double need = std::max(least, share_of_travel * travel[at]);
  const double mean_speed = std::max(travel[at], least) / (r.t_s[at] - r.t_s.front());
  const double stopped = yield_at_break_away / 3 * mean_speed;
  for (std::size_t i = at + 1; i < end; ++i) {
    const std::size_t j = std::min(moved_on(summits, i, need), end);
    if (need <= stopped * (r.t_s[j] - r.t_s[i])) return travel[i] - travel[at];
  }
  return std::nullopt;
}

double gravity_torque(const std::optional<KnownGravity>& gravity, double q_rad) {
  return gravity ? gravity->amplitude_Nm.value * std::cos(q_rad - gravity->q_peak_rad) : 0.0;
}

BreakAwayRamp read_ramp(const joint::Recording& r, const std::optional<KnownGravity>& gravity) {
  BreakAwayRamp ramp;
  ramp.recording = r.name;
  const double sign = direction_of(r);
  ramp.is_rising = sign > 0;
  ramp.q_start_rad = r.q_rad.front();
  std::vector<double> way(r.size());
  std::size_t furthest = 0;  // the largest torque in the ramp's direction, where it never slips
  for (std::size_t i = 0; i < r.size(); ++i) {
    way[i] = sign * (r.q_rad[i] - r.q_rad.front());
    if (sign * (r.torque_Nm[i] - r.torque_Nm[furthest]) > 0) furthest = i;
  }
  const statistics::Summits summits(std::move(way));
  const std::vector<double>& travel = summits.signal();
  const double least = fewest_steps * usual_step_rad(r.q_rad);
  std::size_t at = furthest;
  for (std::size_t i = 1; i < furthest; ++i) {
    const double need = std::max(least, share_of_travel * travel[i]);
    const std::size_t j = moved_on(summits, i, need);
    if (j == r.size()) break;
    const double mean_speed = std::max(travel[i], least) / (r.t_s[i] - r.t_s.front());
    if (!(mean_speed > 0)) continue;
    const double yield = need / (r.t_s[j] - r.t_s[i]) / mean_speed;
    ramp.largest_yield = std::max(ramp.largest_yield, yield);
    if (yield > yield_at_break_away) {
      ramp.broke_away = true;
      at = i;
      break;
    }
  }
  ramp.torque_Nm = r.torque_Nm[at];
  ramp.friction_Nm = sign * (ramp.torque_Nm - gravity_torque(gravity, r.q_rad[at]));
  ramp.travel_rad = travel[at];
  if (ramp.broke_away) ramp.first_slip_rad = slip_until_stop(r, summits, at, furthest, least);
  const double duration = r.t_s[at] - r.t_s.front();
  ramp.rate_Nm_s = duration > 0 ? sign * (ramp.torque_Nm - r.torque_Nm.front()) / duration : 0.0;
  ramp.samples_used = at + 1;
  ramp.samples_left_out = r.size() - ramp.samples_used;
  return ramp;
}

std::optional<statistics::Estimate> mean_of(const std::vector<BreakAwayRamp>& ramps, bool is_rising,
                                            const std::optional<KnownGravity>& gravity) {
  double mean = 0;
  double n = 0;
  double by_gravity = 0;
  for (const BreakAwayRamp& ramp : ramps) {
    if (!ramp.broke_away || ramp.is_rising != is_rising) continue;
    mean += ramp.friction_Nm;
    n += 1;
    if (gravity) {
      by_gravity += gravity->amplitude_Nm.half_width() *
                    std::abs(std::cos(ramp.q_start_rad - gravity->q_peak_rad));
    }
  }
  if (n < 2) return std::nullopt;
  mean /= n;
  by_gravity /= n;
  double squares = 0;
  for (const BreakAwayRamp& ramp : ramps) {
    if (ramp.broke_away && ramp.is_rising == is_rising)
      squares += std::pow(ramp.friction_Nm - mean, 2);
  }
  const double scatter = statistics::student_t_975(n - 1) * std::sqrt(squares / (n - 1) / n);
  return statistics::symmetric_estimate(mean, std::hypot(scatter, by_gravity),
                                        {"interval.scatter_of_ramps"});
}

void add_reason(statistics::StageReport& stage, const Statement& reason) {
  stage.state = statistics::StageState::partial;
  stage.reason.add(reason);
}

/// The bounds of the ramps that did not break away.
void add_censored(BreakAwayResult& result) {
  for (const BreakAwayRamp& ramp : result.ramps) {
    if (ramp.broke_away) continue;
    add_reason(result.stage, {"break_away.censored",
                              {{"recording", ramp.recording},
                               {"torque_Nm", ramp.torque_Nm},
                               {"friction_Nm", ramp.friction_Nm}}});
  }
}

/// In which direction fewer than two ramps broke away.
Code too_few_ramps(const BreakAwayResult& result) {
  if (result.rising_Nm) return {"break_away.too_few_towards_negative"};
  if (result.falling_Nm) return {"break_away.too_few_towards_positive"};
  return {"break_away.too_few_in_either_direction"};
}

}  // namespace

BreakAwayResult identify_break_away(const std::vector<const joint::Recording*>& ramps,
                                    const std::optional<KnownGravity>& gravity) {
  BreakAwayResult out;
  out.stage.name = "break_away";
  out.gravity_taken_off = gravity.has_value();
  if (ramps.empty()) {
    out.stage.state = statistics::StageState::skipped;
    out.stage.reason = {"break_away.no_ramps"};
    return out;
  }
  for (const joint::Recording* r : ramps) {
    if (r->size() < 3) continue;
    out.ramps.push_back(read_ramp(*r, gravity));
    out.censored += out.ramps.back().broke_away ? 0 : 1;
  }
  out.rising_Nm = mean_of(out.ramps, true, gravity);
  out.falling_Nm = mean_of(out.ramps, false, gravity);
  if (out.rising_Nm && out.falling_Nm) {
    out.mean_Nm = statistics::symmetric_estimate(
        (out.rising_Nm->value + out.falling_Nm->value) / 2,
        std::hypot(out.rising_Nm->half_width(), out.falling_Nm->half_width()) / 2,
        {"interval.scatter_of_ramps_both_directions"});
  }
  out.stage.state = statistics::StageState::done;
  add_censored(out);
  if (!out.rising_Nm || !out.falling_Nm) add_reason(out.stage, too_few_ramps(out));
  if (!gravity) add_reason(out.stage, {"break_away.gravity_not_taken_off"});
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
