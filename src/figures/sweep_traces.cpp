#include "figures/sweep_traces.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "method/motion/plateaus.h"

namespace tribolog::figures {
namespace {

constexpr std::size_t fewest_for_slope = 3;
constexpr std::size_t most_stretches = 60;

std::vector<double> joint_speed(const joint::Recording& recording) {
  if (recording.size() >= fewest_for_slope) {
    std::vector<double> slope = method::motion::find_plateaus(recording).speed_rad_s;
    if (slope.size() == recording.size()) return slope;
  }
  std::vector<double> logged = recording.dq_rad_s;
  logged.resize(recording.size(), 0.0);
  return logged;
}

Stroke stroke_of(double speed) {
  if (speed > 0.0) return Stroke::rising;
  return speed < 0.0 ? Stroke::falling : Stroke::left_out;
}

bool complete(const joint::Recording& recording) {
  return recording.size() > 0 && recording.q_rad.size() == recording.size() &&
         recording.torque_Nm.size() == recording.size();
}

SweepTrace samples_of(const joint::Recording& recording, const std::vector<bool>& used,
                      double start_s, double gear_ratio) {
  SweepTrace samples;
  samples.q_rad = recording.q_rad;
  samples.torque_Nm = recording.torque_Nm;
  for (const double t : recording.t_s) {
    samples.t_s.push_back(start_s + t - recording.t_s.front());
  }
  const std::vector<double> speed = joint_speed(recording);
  for (std::size_t i = 0; i < speed.size(); ++i) {
    samples.motor_speed_rad_s.push_back(speed[i] * gear_ratio);
    const bool taken = used.size() == speed.size() && used[i];
    samples.stroke.push_back(taken ? stroke_of(speed[i]) : Stroke::left_out);
  }
  return samples;
}

std::vector<Stretch> joined(const std::vector<Stretch>& stretches) {
  Stretch all;
  for (const Stretch& stretch : stretches) {
    if (!all.x.empty()) {
      all.x.push_back(std::numeric_limits<double>::quiet_NaN());
      all.y.push_back(std::numeric_limits<double>::quiet_NaN());
    }
    all.x.insert(all.x.end(), stretch.x.begin(), stretch.x.end());
    all.y.insert(all.y.end(), stretch.y.begin(), stretch.y.end());
  }
  return {all};
}

}  // namespace

std::vector<SweepTrace> sweep_traces(const method::gravity::SweepCurves& sweep,
                                     const joint::Dataset& dataset, joint::Role role) {
  const std::vector<const joint::Recording*> recordings = dataset.with_role(role);
  std::vector<SweepTrace> all;
  double start_s = 0.0;
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    if (recordings[i] == nullptr || !complete(*recordings[i])) continue;
    const std::vector<bool> used = i < sweep.used.size() ? sweep.used[i] : std::vector<bool>{};
    all.push_back(samples_of(*recordings[i], used, start_s, dataset.manifest.drive.gear_ratio()));
    start_s = all.back().t_s.back();
  }
  return all;
}

std::size_t count(const std::vector<SweepTrace>& sweeps, Stroke stroke) {
  std::size_t sum = 0;
  for (const SweepTrace& sweep : sweeps) {
    sum += static_cast<std::size_t>(std::count(sweep.stroke.begin(), sweep.stroke.end(), stroke));
  }
  return sum;
}

std::vector<double> signal_of(const std::vector<SweepTrace>& sweeps, Stroke stroke, Signal signal) {
  std::vector<double> all;
  for (const SweepTrace& sweep : sweeps) {
    for (std::size_t i = 0; i < sweep.stroke.size(); ++i) {
      if (sweep.stroke[i] == stroke) all.push_back((sweep.*signal)[i]);
    }
  }
  return all;
}

std::vector<double> signal_of(const std::vector<SweepTrace>& sweeps, Signal signal) {
  std::vector<double> all;
  for (const SweepTrace& sweep : sweeps) {
    all.insert(all.end(), (sweep.*signal).begin(), (sweep.*signal).end());
  }
  return all;
}

std::vector<Stretch> stretches_of(const std::vector<SweepTrace>& sweeps, Stroke stroke, Signal x,
                                  Signal y) {
  std::vector<Stretch> stretches;
  for (const SweepTrace& sweep : sweeps) {
    bool within = false;
    for (std::size_t i = 0; i < sweep.stroke.size(); ++i) {
      const bool before = std::exchange(within, sweep.stroke[i] == stroke);
      if (!within) continue;
      if (!before) stretches.emplace_back();
      stretches.back().x.push_back((sweep.*x)[i]);
      stretches.back().y.push_back((sweep.*y)[i]);
    }
  }
  return stretches.size() > most_stretches ? joined(stretches) : stretches;
}

}  // namespace tribolog::figures
