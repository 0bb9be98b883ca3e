#include "method/viscous/viscous_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "joint/degrees.h"
#include "method/motion/plateaus.h"
#include "method/viscous/paired_sweep.h"
#include "method/viscous/plateau_samples.h"
#include "statistics/distributions.h"

namespace tribolog::method::viscous {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A run with the samples it came from, needed to pair directions over common angles.
struct RunSource {
  const joint::Recording* recording;
  PlateauSamples samples;
};

struct BlockMean {
  double mean{};
  double half_width{};  // 95 %, from the scatter of the blocks
  double standard_error{};
};

/// Mean of a signal over the samples that count.
template <class Signal>
BlockMean block_mean(const PlateauSamples& samples, std::size_t first, std::size_t last,
                     Signal signal) {
  constexpr std::size_t most_blocks = 10;
  const std::size_t n = last - first;
  const std::size_t blocks = std::clamp<std::size_t>(n / 5, 1, most_blocks);
  double mean = 0;
  double all = 0;
  std::vector<double> means;
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::size_t from = first + n * b / blocks;
    const std::size_t to = first + n * (b + 1) / blocks;
    double sum = 0;
    double count = 0;
    for (std::size_t i = from; i < to; ++i) {
      if (!samples.has(i)) continue;
      sum += signal(i);
      count += 1;
    }
    if (count == 0) continue;
    means.push_back(sum / count);
    mean += sum;
    all += count;
  }
  mean /= all;
  if (means.size() < 2) return {mean, std::numeric_limits<double>::infinity(), 0};
  double squares = 0;
  for (double m : means) squares += (m - mean) * (m - mean);
  const auto b = static_cast<double>(means.size());
  const double standard_error = std::sqrt(squares / (b - 1) / b);
  return {mean, statistics::student_t_975(b - 1) * standard_error, standard_error};
}

/// Friction that changes with the motor's angle, as the sweep shows it: its lines, and the friction
/// of which they are a part.
struct FrictionOfAngle {
  gravity::Ripple lines;  ///< None: it changes with no angle.
  double friction_Nm{};
  double gear_ratio{};
  double q_peak_rad{};
  double gravity_Nm{};

  /// Of each sample of a plateau, signed as the torque is: the same share of friction as in the
  /// sweep.
  [[nodiscard]] std::vector<double> torque_Nm(const joint::Recording& r,
                                              const motion::Plateau& plateau) const {
    std::vector<double> torque(plateau.size(), 0.0);
    if (lines.lines.empty()) return torque;
    double mean = 0;
    for (std::size_t i = plateau.first; i < plateau.last; ++i) {
      mean += r.torque_Nm[i] - gravity_Nm * std::cos(r.q_rad[i] - q_peak_rad);
    }
    mean /= static_cast<double>(plateau.size());
    for (std::size_t k = 0; k < torque.size(); ++k) {
      const double motor_rad = gear_ratio * r.q_rad[plateau.first + k];
      torque[k] = mean / friction_Nm * lines.torque_Nm(motor_rad);
    }
    return torque;
  }
};

/// Where the runs follow the sweep's lines too: without them less is left. None where a run lies
/// outside the sweep's angles.
FrictionOfAngle friction_of_runs(const std::vector<const joint::Recording*>& recordings,
                                 const gravity::CogSweepResult& sweep, double gear_ratio) {
  if (!sweep.found || !sweep.coulomb_Nm || !(sweep.coulomb_Nm->value > 0)) return {};
  const FrictionOfAngle known{sweep.friction_of_angle, sweep.coulomb_Nm->value, gear_ratio,
                              sweep.q_peak_rad.value, sweep.gravity_Nm.value};
  if (known.lines.lines.empty()) return {};
  double gain = 0;
  for (const joint::Recording* r : recordings) {
    for (const motion::Plateau& plateau : motion::find_plateaus(*r).plateaus) {
      const std::vector<double> line = known.torque_Nm(*r, plateau);
      double sum = 0, lines = 0, product = 0, square = 0;
      for (std::size_t k = 0; k < line.size(); ++k) {
        const double q = r->q_rad[plateau.first + k];
        if (q < sweep.lowest_rad || q > sweep.highest_rad) return {};
        const double rest =
            r->torque_Nm[plateau.first + k] - known.gravity_Nm * std::cos(q - known.q_peak_rad);
        sum += rest;
        lines += line[k];
        product += rest * line[k];
        square += line[k] * line[k];
      }
      const auto n = static_cast<double>(line.size());
      gain += 2 * (product - sum * lines / n) - (square - lines * lines / n);
    }
  }
  return gain > 0 ? known : FrictionOfAngle{};
}

/// T less gravity, so that the scatter is of friction and noise alone. The sweep's ripple, at the
/// same motor angles, is subtracted from the run where that reduces the scatter. Friction that
/// changes with the motor's angle is subtracted too: a slow run crosses only part of its period.
/// @param torque_step_Nm that the torque is rounded to; 0: it is not.
/// @param taken_off_Nm of the recording's torque, for the inertia (SteadyRuns).
/// @param samples receives those of the plateau that count.
ConstantSpeedRun make_run(const joint::Recording& r, const motion::Plateau& plateau,
                          double gear_ratio, double q_peak, double gravity,
                          const gravity::CogSweepResult& sweep,
                          const FrictionOfAngle& friction_of_angle, double torque_step_Nm,
                          const std::vector<double>& taken_off_Nm, PlateauSamples& samples) {
  const std::vector<double> of_angle = friction_of_angle.torque_Nm(r, plateau);
  const gravity::Ripple& ripple = sweep.ripple;
  const auto torque_at = [&](std::size_t i) {
    return r.torque_Nm[i] - of_angle[i - plateau.first];
  };
  const auto friction_at = [&](std::size_t i) {
    return torque_at(i) - gravity * std::cos(r.q_rad[i] - q_peak);
  };
  std::vector<double> friction_Nm;
  friction_Nm.reserve(plateau.size());
  for (std::size_t i = plateau.first; i < plateau.last; ++i) friction_Nm.push_back(friction_at(i));
  samples = samples_that_count(r, plateau, friction_Nm, taken_off_Nm, torque_step_Nm);

  ConstantSpeedRun run;
  run.recording = r.name;
  run.speed_rad_s = gear_ratio * plateau.speed_rad_s;
  run.samples = samples.size();
  double q = 0;
  double cosine = 0;
  double sine = 0;
  double load = 0;
  double torque = 0;
  double taken_off = 0;
  run.lowest_rad = run.highest_rad = r.q_rad[plateau.first];
  for (std::size_t i = plateau.first; i < plateau.last; ++i) {
    run.lowest_rad = std::min(run.lowest_rad, r.q_rad[i]);
    run.highest_rad = std::max(run.highest_rad, r.q_rad[i]);
    if (!samples.has(i)) continue;
    q += r.q_rad[i];
    cosine += std::cos(r.q_rad[i] - q_peak);
    sine += std::sin(r.q_rad[i] - q_peak);
    load += std::abs(std::cos(r.q_rad[i] - q_peak));
    torque += torque_at(i);
    taken_off += of_angle[i - plateau.first];
  }
  const auto n = static_cast<double>(samples.size());
  run.q_rad = q / n;
  run.mean_cos = cosine / n;
  run.mean_sin = sine / n;
  run.mean_load = load / n;
  run.torque_Nm = torque / n;
  BlockMean friction = block_mean(samples, plateau.first, plateau.last, friction_at);
  if (!ripple.lines.empty()) {
    const BlockMean without = block_mean(samples, plateau.first, plateau.last, [&](std::size_t i) {
      return friction_at(i) - ripple.torque_Nm(gear_ratio * r.q_rad[i]);
    });
    if (without.half_width < friction.half_width) {
      run.torque_Nm += without.mean - friction.mean;
      friction = without;
    }
  }
  // What was taken off is known but for a part.
  constexpr double left = 0.1;
  const double of_angle_Nm = left * std::abs(taken_off / n);
  run.torque_half_width_Nm = std::hypot(friction.half_width, statistics::normal_975 * of_angle_Nm);
  run.torque_standard_error_Nm =
      std::hypot(std::hypot(friction.standard_error, samples.rounding_error_Nm), of_angle_Nm);
  run.direction_difference_Nm = nan;
  run.direction_difference_half_width_Nm = nan;
  run.direction_mean_Nm = nan;
  run.direction_mean_cos = nan;
  return run;
}

/// Gravity, to be subtracted before scatter is estimated.
struct GravityShape {
  double q_peak_rad, gravity_Nm;
  [[nodiscard]] double torque_Nm(double q_rad) const {
    return gravity_Nm * std::cos(q_rad - q_peak_rad);
  }
};

struct MeanTorque {
  double torque_Nm, half_width_Nm, cosine;
};

/// Mean torque of a run within [low, high], including gravity, with the interval due to friction
/// and noise; NaN if it has too few samples there.
MeanTorque torque_between(const RunSource& s, double low, double high, const GravityShape& shape) {
  std::size_t from = s.samples.last;
  std::size_t to = s.samples.first;
  for (std::size_t i = s.samples.first; i < s.samples.last; ++i) {
    if (s.recording->q_rad[i] < low || s.recording->q_rad[i] > high) continue;
    from = std::min(from, i);
    to = i + 1;
  }
  if (from + 5 > to) return {nan, nan, nan};
  MeanTorque mean{0, 0, 0};
  double count = 0;
  for (std::size_t i = from; i < to; ++i) {
    if (!s.samples.has(i)) continue;
    mean.torque_Nm += s.recording->torque_Nm[i];
    mean.cosine += std::cos(s.recording->q_rad[i] - shape.q_peak_rad);
    count += 1;
  }
  if (count == 0) return {nan, nan, nan};
  mean.torque_Nm /= count;
  mean.cosine /= count;
  mean.half_width_Nm = block_mean(s.samples, from, to, [&](std::size_t i) {
                         return s.recording->torque_Nm[i] - shape.torque_Nm(s.recording->q_rad[i]);
                       }).half_width;
  return mean;
}

/// Pairs each rising run with the falling one of the same speed that shares most of its angles.
void pair_directions(std::vector<ConstantSpeedRun>& runs, const std::vector<RunSource>& sources,
                     const GravityShape& shape) {
  constexpr double least_overlap = 0.2;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i].speed_rad_s < 0) continue;
    double best = least_overlap;
    for (std::size_t k = 0; k < runs.size(); ++k) {
      const double ratio = -runs[k].speed_rad_s / runs[i].speed_rad_s;
      if (runs[k].partner >= 0 || std::abs(ratio - 1) > motion::same_speed) continue;
      const double low = std::max(runs[i].lowest_rad, runs[k].lowest_rad);
      const double high = std::min(runs[i].highest_rad, runs[k].highest_rad);
      const double overlap = (high - low) / (runs[i].highest_rad - runs[i].lowest_rad);
      if (overlap > best) {
        best = overlap;
        runs[i].partner = static_cast<int>(k);
      }
    }
    if (runs[i].partner < 0) continue;
    const auto k = static_cast<std::size_t>(runs[i].partner);
    runs[k].partner = static_cast<int>(i);
    const double low = std::max(runs[i].lowest_rad, runs[k].lowest_rad);
    const double high = std::min(runs[i].highest_rad, runs[k].highest_rad);
    const MeanTorque up = torque_between(sources[i], low, high, shape);
    const MeanTorque down = torque_between(sources[k], low, high, shape);
    const double difference = (up.torque_Nm - down.torque_Nm) / 2;
    for (const std::size_t run : {i, k}) {
      runs[run].direction_difference_Nm = run == i ? difference : -difference;
      runs[run].direction_difference_half_width_Nm =
          std::hypot(up.half_width_Nm, down.half_width_Nm) / 2;
      runs[run].direction_mean_Nm = (up.torque_Nm + down.torque_Nm) / 2;
      runs[run].direction_mean_cos = (up.cosine + down.cosine) / 2;
    }
  }
}

/// Indices of the points at each speed and direction.
std::vector<std::vector<std::size_t>> repeated_points(const joint::FrictionPoints& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points.speed_rad_s[a] < points.speed_rad_s[b];
  });
  std::vector<std::vector<std::size_t>> groups;
  for (const std::size_t i : order) {
    const double speed = points.speed_rad_s[i];
    const double first = groups.empty() ? nan : points.speed_rad_s[groups.back().front()];
    if (!(std::abs(speed - first) <= motion::same_speed * std::abs(first))) groups.emplace_back();
    groups.back().push_back(i);
  }
  return groups;
}

/// Each point is a run of one sample; the two directions at one speed are partners.
/// @param gravity_Nm amplitude, motor side, of which loads are shares; 0: they are shares of the
/// largest load.
std::vector<ConstantSpeedRun> runs_of_points(const joint::FrictionPoints& points,
                                             double gravity_Nm) {
  const std::vector<std::vector<std::size_t>> groups = repeated_points(points);
  double squares = 0;
  double freedom = 0;
  for (const std::vector<std::size_t>& group : groups) {
    double mean = 0;
    for (const std::size_t i : group)
      mean += points.torque_Nm[i] / static_cast<double>(group.size());
    for (const std::size_t i : group) squares += std::pow(points.torque_Nm[i] - mean, 2);
    freedom += static_cast<double>(group.size()) - 1;
  }
  const double sd = freedom > 0 ? std::sqrt(squares / freedom) : 0;
  double whole_load = gravity_Nm;
  for (const double load : points.load_Nm) {
    if (!(gravity_Nm > 0)) whole_load = std::max(whole_load, std::abs(load));
  }
  std::vector<ConstantSpeedRun> runs;
  for (std::size_t i = 0; i < points.size(); ++i) {
    ConstantSpeedRun run;
    run.recording = points.name;
    run.speed_rad_s = points.speed_rad_s[i];
    run.torque_Nm = points.torque_Nm[i];
    run.torque_standard_error_Nm = sd;
    run.torque_half_width_Nm = freedom > 0 ? statistics::student_t_975(freedom) * sd
                                           : std::numeric_limits<double>::infinity();
    run.q_rad = run.lowest_rad = run.highest_rad = nan;
    run.samples = 1;
    if (!points.load_Nm.empty() && whole_load > 0) {
      run.mean_load = std::abs(points.load_Nm[i]) / whole_load;
    }
    run.direction_difference_Nm = run.direction_difference_half_width_Nm = nan;
    run.direction_mean_Nm = run.direction_mean_cos = nan;
    runs.push_back(std::move(run));
  }
  return runs;
}

/// Pairs each rising run of a speed with a falling one, where the angle does not matter: friction
/// points and, for a joint without gravity, the runs too.
void pair_by_speed(std::vector<ConstantSpeedRun>& runs, bool is_free) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    ConstantSpeedRun& rising = runs[i];
    if ((rising.has_angle() && !is_free) || rising.speed_rad_s < 0) continue;
    double nearest = motion::same_speed;
    for (std::size_t k = 0; k < runs.size(); ++k) {
      const ConstantSpeedRun& other = runs[k];
      if (other.has_angle() != rising.has_angle() || other.partner >= 0) continue;
      const double apart = std::abs(-other.speed_rad_s / rising.speed_rad_s - 1);
      if (apart > nearest) continue;
      nearest = apart;
      rising.partner = static_cast<int>(k);
    }
    if (rising.partner < 0) continue;
    ConstantSpeedRun& falling = runs[static_cast<std::size_t>(rising.partner)];
    falling.partner = static_cast<int>(i);
    const double difference = (rising.torque_Nm - falling.torque_Nm) / 2;
    for (ConstantSpeedRun* run : {&rising, &falling}) {
      run->direction_difference_Nm = run == &rising ? difference : -difference;
      run->direction_difference_half_width_Nm =
          std::hypot(rising.torque_half_width_Nm, falling.torque_half_width_Nm) / 2;
      run->direction_mean_Nm = (rising.torque_Nm + falling.torque_Nm) / 2;
      run->direction_mean_cos = 0;
    }
  }
}

DirectionAngles direction_angles(const std::vector<ConstantSpeedRun>& runs) {
  constexpr double least_travel_share = 0.25;
  double widest = 0;
  for (const ConstantSpeedRun& run : runs) {
    if (run.has_angle()) widest = std::max(widest, run.highest_rad - run.lowest_rad);
  }
  DirectionAngles out;
  for (const ConstantSpeedRun& run : runs) {
    if (!run.has_angle()) continue;
    if (run.highest_rad - run.lowest_rad < least_travel_share * widest) continue;
    const bool is_rising = run.speed_rad_s > 0;
    bool& has = is_rising ? out.has_rising : out.has_falling;
    double& low = is_rising ? out.rising_low_rad : out.falling_low_rad;
    double& high = is_rising ? out.rising_high_rad : out.falling_high_rad;
    low = has ? std::min(low, run.lowest_rad) : run.lowest_rad;
    high = has ? std::max(high, run.highest_rad) : run.highest_rad;
    has = true;
  }
  return out;
}

void sort_by_speed(std::vector<ConstantSpeedRun>& runs) {
  std::vector<std::size_t> order(runs.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return runs[a].speed_rad_s < runs[b].speed_rad_s;
  });
  std::vector<int> place(runs.size());
  for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = static_cast<int>(i);
  std::vector<ConstantSpeedRun> sorted;
  sorted.reserve(runs.size());
  for (const std::size_t i : order) {
    sorted.push_back(runs[i]);
    if (sorted.back().partner >= 0) {
      sorted.back().partner = place[static_cast<std::size_t>(sorted.back().partner)];
    }
  }
  runs = std::move(sorted);
}

}  // namespace

bool DirectionAngles::share_angles() const {
  return has_rising && has_falling &&
         std::max(rising_low_rad, falling_low_rad) < std::min(rising_high_rad, falling_high_rad);
}

Statement DirectionAngles::described() const {
  if (!has_rising && !has_falling) return {"run_angles.unknown"};
  if (!has_falling) return {"run_angles.rising_only"};
  if (!has_rising) return {"run_angles.falling_only"};
  return {share_angles() ? Code{"run_angles.covered"} : Code{"run_angles.none_shared"},
          {{"rising_low_deg", joint::degrees_per_rad * rising_low_rad},
           {"rising_high_deg", joint::degrees_per_rad * rising_high_rad},
           {"falling_low_deg", joint::degrees_per_rad * falling_low_rad},
           {"falling_high_deg", joint::degrees_per_rad * falling_high_rad}}};
}

const ViscousCurve* ViscousCurvesResult::find(
    std::optional<hysteresis::Estimator> estimator) const {
  const auto it = std::find_if(curves.begin(), curves.end(),
                               [&](const ViscousCurve& c) { return c.estimator == estimator; });
  return it == curves.end() ? nullptr : &*it;
}

ViscousCurvesResult identify_viscous_curves(const motion::SteadyRuns& steady,
                                            const std::vector<joint::FrictionPoints>& points,
                                            const motion::Sweep& sweep,
                                            const gravity::CogSweepResult& rough,
                                            const hysteresis::SurrogateMassesResult& masses,
                                            const std::optional<statistics::Estimate>& q_peak_rad,
                                            double gear_ratio,
                                            const std::optional<joint::StatedGravity>& stated) {
  ViscousCurvesResult out;
  out.stage = {"viscous_curves", statistics::StageState::skipped, {}};
  const double q_peak = q_peak_rad ? q_peak_rad->value : 0.0;
  const hysteresis::SurrogateMass* of_model = masses.find(hysteresis::Estimator::model);
  const double gravity = of_model != nullptr ? of_model->gravity_Nm.value
                         : rough.found       ? rough.gravity_Nm.value
                                             : 0.0;
  std::vector<RunSource> sources;
  const std::vector<const joint::Recording*> recordings = steady.recordings();
  const FrictionOfAngle of_angle = friction_of_runs(recordings, rough, gear_ratio);
  for (std::size_t k = 0; k < recordings.size(); ++k) {
    const joint::Recording* r = recordings[k];
    const motion::MotionSegments motion = motion::find_plateaus(*r);
    for (const motion::Plateau& plateau : motion.plateaus) {
      sources.push_back({r, {}});
      PlateauSamples& samples = sources.back().samples;
      out.runs.push_back(make_run(*r, plateau, gear_ratio, q_peak, gravity, rough, of_angle,
                                  steady.torque_step_Nm(), steady.taken_off_Nm(k), samples));
      out.samples_used += samples.size();
      out.samples_left_out += samples.left_out;
    }
    out.samples_left_out += r->size() - motion.samples_on_plateaus;
    if (motion.plateaus.empty()) ++out.recordings_without_plateau;
  }
  const bool is_free = stated && stated->amplitude_Nm() == 0;
  if (!out.runs.empty()) {
    if (!is_free) pair_directions(out.runs, sources, {q_peak, gravity});
  } else if (is_free && rough.coulomb_Nm && rough.both_directions && !rough.constant_speed) {
    out.runs = bin_sweep_by_speed(sweep, rough, gear_ratio);
    for (const ConstantSpeedRun& run : out.runs) out.samples_used += run.samples;
    out.samples_left_out += rough.samples_used + rough.samples_left_out - out.samples_used;
  } else if (rough.found && rough.both_directions && !rough.constant_speed && q_peak_rad) {
    out.runs = pair_sweep_by_angle(sweep, rough, gear_ratio, q_peak);
    out.from_sweep = !out.runs.empty();
    for (const ConstantSpeedRun& run : out.runs) out.samples_used += run.samples;
    out.samples_left_out += rough.samples_used + rough.samples_left_out - out.samples_used;
  }
  for (const joint::FrictionPoints& read : points) {
    const std::vector<ConstantSpeedRun> runs = runs_of_points(read, gravity);
    out.samples_used += runs.size();
    out.runs.insert(out.runs.end(), runs.begin(), runs.end());
  }
  pair_by_speed(out.runs, is_free && !out.from_sweep);
  sort_by_speed(out.runs);
  out.angles = direction_angles(out.runs);
  for (const hysteresis::SurrogateMass& mass : masses.masses) {
    ViscousCurve curve{mass.estimator, {}};
    const bool is_stated = stated && mass.estimator == hysteresis::Estimator::stated;
    const double away = is_stated ? stated->q_peak_rad() - q_peak : 0.0;
    for (const ConstantSpeedRun& run : out.runs) {
      const double cosine = std::cos(away) * run.mean_cos + std::sin(away) * run.mean_sin;
      curve.friction_Nm.push_back(run.torque_Nm - mass.gravity_Nm.value * cosine);
    }
    out.curves.push_back(std::move(curve));
  }

  if (out.runs.empty()) {
    out.stage.reason = recordings.empty() ? Code{"viscous.no_runs"} : Code{"viscous.no_plateau"};
    if (!recordings.empty()) out.stage.state = statistics::StageState::not_identifiable;
  } else if (out.curves.empty()) {
    out.stage.state = statistics::StageState::partial;
    out.stage.reason = {"viscous.gravity_not_known"};
  } else if (out.from_sweep) {
    out.stage.state = statistics::StageState::partial;
    out.stage.reason = {"viscous.friction_from_sweep"};
  } else if (out.recordings_without_plateau > 0) {
    out.stage.state = statistics::StageState::partial;
    out.stage.reason = {
        "viscous.runs_without_plateau",
        {{"without_plateau", out.recordings_without_plateau}, {"runs", recordings.size()}}};
  } else {
    out.stage.state = statistics::StageState::done;
  }
  return out;
}

}  // namespace tribolog::method::viscous
