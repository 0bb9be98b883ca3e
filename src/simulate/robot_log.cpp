#include "simulate/robot_log.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "base/statement.h"
#include "simulate/drive_noise.h"
#include "simulate/simulate_joint.h"

namespace tribolog::simulate {
namespace {

constexpr double rest_s = 1;

/// From one angle to another, accelerating and braking smoothly, between two rests.
class Move {
 public:
  Move(double from_rad, double to_rad) : from_(from_rad), way_(to_rad - from_rad) {
    constexpr double mean_speed_rad_s = 0.3;
    constexpr double shortest_s = 1;
    duration_ = std::max(std::abs(way_) / mean_speed_rad_s, shortest_s);
  }
  [[nodiscard]] double whole_s() const { return duration_ + 2 * rest_s; }

  struct State {
    double q, dq, ddq;
  };
  [[nodiscard]] State at(double t) const {
    const double s = std::clamp((t - rest_s) / duration_, 0.0, 1.0);
    const double rest = 1 - s;
    return {from_ + way_ * s * s * s * (10 - 15 * s + 6 * s * s),
            way_ / duration_ * 30 * s * s * rest * rest,
            way_ / (duration_ * duration_) * 60 * s * rest * (1 - 2 * s)};
  }

 private:
  double from_, way_, duration_{};
};

double held_torque_Nm(const Scenario& s, double q_rad) {
  return s.load.torque_Nm(q_rad) / s.gear_ratio;
}

IdealRecording moved(const Scenario& s, const Move& move, double rate_Hz) {
  IdealRecording out;
  out.sample_rate_Hz = rate_Hz;
  joint::Recording& r = out.recording;
  const double n = s.gear_ratio;
  const double inertia = s.motor_inertia_kgm2 * n + s.arm_inertia_kgm2 / n;
  const auto samples = static_cast<std::size_t>(move.whole_s() * rate_Hz);
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) / rate_Hz;
    const Move::State at = move.at(t);
    const double friction = at.dq == 0 ? 0 : s.presliding->steady_torque_Nm(n * at.dq);
    r.t_s.push_back(t);
    r.q_rad.push_back(at.q);
    r.torque_Nm.push_back(held_torque_Nm(s, at.q) + friction + inertia * at.ddq);
  }
  return out;
}

/// Every other part is an experiment; before each there is the move to it.
std::vector<IdealRecording> with_moves(const Scenario& s) {
  std::vector<IdealRecording> out;
  for (IdealRecording& one : simulate_ideal_joint(s)) {
    const double to = one.recording.q_rad.front();
    const double from = out.empty() ? to : out.back().recording.q_rad.back();
    out.push_back(moved(s, Move(from, to), one.sample_rate_Hz));
    one.recording.dq_rad_s.clear();
    out.push_back(std::move(one));
  }
  return out;
}

void append(const std::vector<double>& values, std::vector<double>& to) {
  to.insert(to.end(), values.begin(), values.end());
}

/// A joint that holds its place, over the times of another.
joint::Recording held(const Scenario& s, double q_rad, const std::vector<double>& t_s,
                      double rate_Hz, std::uint64_t stream) {
  joint::Recording r;
  r.t_s = t_s;
  r.q_rad.assign(t_s.size(), q_rad);
  r.torque_Nm.assign(t_s.size(), held_torque_Nm(s, q_rad));
  add_drive_noise(r, s.noise, s.gear_ratio, rate_Hz, stream);
  return r;
}

void require_one_clock(const Noise& noise) {
  if (noise.lost_percent != 0 || noise.clock_jitter_s != 0) {
    throw Refusal({"scenario.joints_share_their_clock"});
  }
}

}  // namespace

RobotLog simulate_robot(const std::vector<Scenario>& scenarios) {
  std::vector<std::vector<IdealRecording>> parts;
  std::vector<double> places_rad;  // where each joint is
  for (const Scenario& s : scenarios) {
    require_one_clock(s.noise);
    parts.push_back(with_moves(s));
    places_rad.push_back(parts.back().front().recording.q_rad.front());
  }
  RobotLog log;
  log.joints.resize(scenarios.size());
  double start_s = 0;
  std::uint64_t stream = 0;
  for (std::size_t mover = 0; mover < scenarios.size(); ++mover) {
    for (std::size_t k = 0; k < parts[mover].size(); ++k) {
      IdealRecording& part = parts[mover][k];
      const double rate_Hz = part.sample_rate_Hz;
      places_rad[mover] = part.recording.q_rad.back();
      const std::vector<double> t_s = part.recording.t_s;
      add_drive_noise(part.recording, scenarios[mover].noise, scenarios[mover].gear_ratio, rate_Hz,
                      stream++);
      for (std::size_t j = 0; j < scenarios.size(); ++j) {
        const joint::Recording r = j == mover
                                       ? std::move(part.recording)
                                       : held(scenarios[j], places_rad[j], t_s, rate_Hz, stream++);
        append(r.q_rad, log.joints[j].q_rad);
        append(r.torque_Nm, log.joints[j].torque_Nm);
        if (j == mover && k % 2 == 1) {
          log.joints[j].parts.push_back({r.role, start_s, start_s + t_s.back()});
        }
      }
      for (const double t : t_s) log.t_s.push_back(start_s + t);
      start_s += t_s.back() + 1 / rate_Hz;
    }
  }
  return log;
}

}  // namespace tribolog::simulate
