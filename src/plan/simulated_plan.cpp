#include "plan/simulated_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "base/requirements.h"
#include "friction/lugre.h"
#include "simulate/bristle_integrator.h"
#include "simulate/forced_motion.h"
#include "simulate/motion.h"
#include "wording/language.h"
#include "wording/words.h"

namespace tribolog::plan {
namespace {

class Follower {
 public:
  Follower(const simulate::Scenario& joint, double sample_rate_Hz)
      : s_(joint),
        lugre_(dynamic_cast<const friction::LuGreFriction*>(joint.presliding.get())),
        rate_(sample_rate_Hz) {
    if (lugre_ == nullptr || !joint.sliding) {
      throw std::invalid_argument(
          "a plan is followed by a LuGre contact with a static sliding law");
    }
  }

  void follow(const ExperimentPlan& plan) {
    const auto samples = static_cast<std::size_t>(std::floor(plan.duration_s() * rate_)) + 1;
    for (const PlannedSegment& segment : plan.segments) {
      const auto first = log_.t_s.size();
      const bool is_last = &segment == &plan.segments.back();
      const auto last = is_last ? samples : std::min(samples, first_sample_from(segment.end_s()));
      for (std::size_t i = first; i < last; ++i) {
        const double t = static_cast<double>(i) / rate_;
        add(t, *segment.motion, t - segment.start_s);
      }
      if (segment.role == joint::Role::oscillation) replace_oscillation(segment, first, last);
      if (segment.ramp) replace_ramp(segment, first, last);
      note_direction(*segment.motion);
    }
    log_.rows_read = log_.size();
  }

  joint::Recording take() { return std::move(log_); }

 private:
  [[nodiscard]] std::size_t first_sample_from(double t_s) const {
    return static_cast<std::size_t>(std::ceil(t_s * rate_ - 1e-9));
  }

  [[nodiscard]] double torque(double q, double ddq, double friction) const {
    const double n = s_.gear_ratio;
    return s_.motor_inertia_kgm2 * n * ddq + friction +
           (s_.arm_inertia_kgm2 * ddq + s_.load.torque_Nm(q)) / n;
  }

  void add(double t, const simulate::Motion& motion, double within) {
    const double q = motion.angle(within);
    const double dq = motion.speed(within);
    log_.t_s.push_back(t);
    log_.q_rad.push_back(q);
    log_.dq_rad_s.push_back(dq);
    log_.torque_Nm.push_back(
        torque(q, motion.acceleration(within), s_.sliding->torque_Nm(s_.gear_ratio * dq)));
  }

  /// Which way the joint slid last.
  void note_direction(const PlannedMotion& motion) {
    const double middle = motion.duration_s() * 0.75;  // there and back: the way back
    const double speed = motion.speed(middle);
    if (speed != 0) direction_ = speed > 0 ? 1 : -1;
  }

  void replace_oscillation(const PlannedSegment& segment, std::size_t first, std::size_t last) {
    if (last <= first) return;
    const simulate::MotorSide motor(*segment.motion, s_.gear_ratio);
    const auto& p = lugre_->parameters();
    const double z0 = direction_ * p.static_Nm / p.bristle_stiffness_Nm_rad;
    std::vector<double> z(last - first);
    std::vector<double> dz(z.size());
    const double t0 = log_.t_s[first] - segment.start_s;
    simulate::integrate_bristle(*lugre_, motor, t0, 1 / rate_, z0, z, dz);
    for (std::size_t i = first; i < last; ++i) {
      const double t = log_.t_s[i] - segment.start_s;
      const double friction = lugre_->torque_Nm(z[i - first], dz[i - first], motor.speed(t));
      log_.torque_Nm[i] = torque(log_.q_rad[i], segment.motion->acceleration(t), friction);
    }
  }

  void replace_ramp(const PlannedSegment& segment, std::size_t first, std::size_t last) {
    const PlannedRamp& ramp = present(segment.ramp);
    simulate::BreakAwayExperiment e;
    e.centre_rad = segment.motion->angle(0);
    e.rate_Nm_s = ramp.rate_Nm_s;
    e.largest_torque_Nm = ramp.largest_change_Nm;
    e.largest_travel_rad = ramp.largest_travel_rad;
    e.sample_rate_Hz = rate_;
    const joint::Recording slid = simulate::simulate_break_away_ramp(s_, e, ramp.direction, "");
    const std::size_t begin = std::max(first, first_sample_from(segment.from_s));
    const std::size_t end = std::min(last, first_sample_from(segment.to_s));
    std::size_t k = begin;
    for (; k < std::min(end, begin + slid.size()); ++k) {
      log_.q_rad[k] = slid.q_rad[k - begin];
      log_.dq_rad_s[k] = slid.dq_rad_s[k - begin];
      log_.torque_Nm[k] = slid.torque_Nm[k - begin];
    }
    if (k == begin) return;
    // Caught where it slid to until the ramp's time is over, then led back along a raised cosine.
    const double caught = log_.q_rad[k - 1];
    for (std::size_t i = k; i < last; ++i) {
      const double x =
          i < end ? 0.0 : static_cast<double>(i - end) / static_cast<double>(last - end);
      const double away = caught - e.centre_rad;
      const double back_s = static_cast<double>(last - end) / rate_;
      log_.q_rad[i] = e.centre_rad + away * (1 + std::cos(std::numbers::pi * x)) / 2;
      log_.dq_rad_s[i] =
          i < end ? 0.0 : -away * std::numbers::pi / (2 * back_s) * std::sin(std::numbers::pi * x);
      log_.torque_Nm[i] =
          torque(log_.q_rad[i], 0, s_.sliding->torque_Nm(s_.gear_ratio * log_.dq_rad_s[i]));
    }
  }

  const simulate::Scenario& s_;
  const friction::LuGreFriction* lugre_;
  double rate_;
  double direction_{1};
  joint::Recording log_;
};

std::vector<double> cut(const std::vector<double>& all, std::size_t first, std::size_t last) {
  return {all.begin() + static_cast<std::ptrdiff_t>(first),
          all.begin() + static_cast<std::ptrdiff_t>(last)};
}

}  // namespace

joint::Recording simulate_plan(const ExperimentPlan& plan, const simulate::Scenario& joint,
                               double sample_rate_Hz) {
  if (plan.segments.empty()) throw std::invalid_argument("the plan holds nothing to simulate");
  Follower follower(joint, sample_rate_Hz);
  follower.follow(plan);
  joint::Recording log = follower.take();
  log.name = planned_log_name;
  return log;
}

std::vector<simulate::IdealRecording> cut_by_plan(const ExperimentPlan& plan,
                                                  const joint::Recording& log,
                                                  double sample_rate_Hz) {
  const wording::WordsIn english({});  // names of recordings are the same in every language
  std::vector<simulate::IdealRecording> all;
  for (const PlannedSegment& segment : plan.segments) {
    if (!segment.role) continue;
    const auto at = [&](double t) {
      return static_cast<std::size_t>(std::lower_bound(log.t_s.begin(), log.t_s.end(), t) -
                                      log.t_s.begin());
    };
    const std::size_t first = at(segment.from_s);
    const std::size_t last = at(std::nextafter(segment.to_s, 1e300));
    joint::Recording r;
    r.name = wording::words(segment.name);
    r.role = *segment.role;
    r.t_s = cut(log.t_s, first, last);
    r.q_rad = cut(log.q_rad, first, last);
    r.dq_rad_s = cut(log.dq_rad_s, first, last);
    r.torque_Nm = cut(log.torque_Nm, first, last);
    r.rows_read = r.size();
    all.push_back({std::move(r), sample_rate_Hz});
  }
  return all;
}

}  // namespace tribolog::plan
