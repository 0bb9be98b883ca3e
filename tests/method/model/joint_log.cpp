#include "method/model/joint_log.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "statistics/random_stream.h"

namespace tribolog::test {
namespace {

using joint::Recording;
using method::model::ModelEffect;
using method::model::ModelQuantity;
using method::model::ModelResult;
using std::numbers::pi;

/// State of the motion at one moment; joint side.
struct Moment {
  double q{}, dq{}, ddq{};
  double along{};  ///< Direction of the stroke.
};

/// From one end to the other with a trapezoid of speed, and back; at rest before and after.
class Strokes {
 public:
  Strokes(double from, double to, double speed, double acceleration, bool up, bool down)
      : from_(from), way_(to - from), acceleration_(acceleration), up_(up), down_(down) {
    speed_ = std::min(speed, std::sqrt(way_ * acceleration));
    ramp_s_ = speed_ / acceleration;
    stroke_s_ = way_ / speed_ + ramp_s_;
  }
  [[nodiscard]] double length_s() const {
    return (up_ ? stroke_s_ + rest_s : 0) + (down_ ? stroke_s_ + rest_s : 0) + rest_s;
  }
  [[nodiscard]] Moment at(double t) const {
    double since = t - rest_s;
    if (!up_) return mirrored(stroke(since));
    if (!down_ || since < stroke_s_ + rest_s / 2) return stroke(since);
    return mirrored(stroke(since - stroke_s_ - rest_s));
  }

 private:
  static constexpr double rest_s = 0.3;

  [[nodiscard]] Moment mirrored(Moment m) const {
    return {2 * from_ + way_ - m.q, -m.dq, -m.ddq, -m.along};
  }
  [[nodiscard]] Moment stroke(double t) const {
    if (t <= 0) return {from_, 0, 0, 1};
    if (t >= stroke_s_) return {from_ + way_, 0, 0, 1};
    if (t < ramp_s_) {
      return {from_ + acceleration_ * t * t / 2, acceleration_ * t, acceleration_, 1};
    }
    const double left = stroke_s_ - t;
    if (left < ramp_s_) {
      return {from_ + way_ - acceleration_ * left * left / 2, acceleration_ * left, -acceleration_,
              1};
    }
    return {from_ + speed_ * (t - ramp_s_ / 2), speed_, 0, 1};
  }

  double from_, way_, acceleration_;
  bool up_, down_;
  double speed_{}, ramp_s_{}, stroke_s_{};
};

struct Plan {
  std::string name;
  joint::Role role{};
  Strokes motion;
  double begin_s{};  ///< In the session.
};

std::vector<Plan> plan(const Session& s) {
  std::vector<Plan> all;
  for (int k = 0; k < s.sweeps; ++k) {
    all.push_back(
        {"sweep" + std::to_string(k), joint::Role::rough_sweep,
         Strokes(s.low_rad, s.high_rad, s.sweep_speed_rad_s, s.acceleration_rad_s2, s.up, s.down)});
  }
  const double middle = (s.low_rad + s.high_rad) / 2;
  for (const double speed : s.run_speeds_rad_s) {
    // Far enough for half a second at the speed.
    const double way = std::min(s.high_rad - s.low_rad,
                                std::max(std::min(s.run_way_rad, 8 * speed),
                                         speed * speed / s.acceleration_rad_s2 + 0.5 * speed));
    all.push_back(
        {"run" + std::to_string(all.size()), joint::Role::constant_speed,
         Strokes(middle - way / 2, middle + way / 2, speed, s.acceleration_rad_s2, s.up, s.down)});
  }
  double now = 0;
  for (Plan& p : all) {
    p.begin_s = now;
    now += p.motion.length_s() + 5;
  }
  return all;
}

}  // namespace

SmallEffects SmallEffects::draw(std::uint64_t seed, double friction_of_top) {
  statistics::RandomStream random(seed, 77);
  SmallEffects e;
  const auto drawn = [&](double scale) { return scale * random.normal(); };
  e.offset = drawn(std::hypot(0.005, 0.05 * friction_of_top));
  e.offset_drift = drawn(0.002);
  e.gain_drift = drawn(0.002);
  e.square = drawn(0.001);
  e.cube = drawn(0.001);
  e.gain_of_speed = drawn(0.001);
  e.gain_of_runs = drawn(0.002);
  e.tool = drawn(0.0005);
  e.lag_s = drawn(0.001);
  e.asymmetry_of_speed = drawn(0.02);
  e.asymmetry_of_dip = drawn(0.02);
  e.load = drawn(0.01);
  for (std::size_t k = 0; k < e.place.size(); ++k) {
    e.place[k] = drawn(0.02 / static_cast<double>(k + 1));
  }
  e.spring = drawn(0.001);
  e.angle_scale = drawn(0.001);
  e.peak_drift_rad = drawn(0.001);
  for (double& one : e.harmonics) one = drawn(0.0005);
  for (std::size_t k = 0; k < e.waves.size(); ++k) {
    e.waves[k] = drawn(0.0005 / static_cast<double>(k + 1));
  }
  for (double& one : e.warm_up) one = drawn(0.01);
  e.session = drawn(0.02);
  e.recording = 0.001;
  e.tare = 0.0003;
  e.motor_turn = drawn(0.01);
  return e;
}

double KnownJoint::friction_Nm(double speed_rad_s) const {
  return coulomb_Nm + viscous_Nms_rad * speed_rad_s + bend_Nm * std::sqrt(speed_rad_s / 45) +
         dip_Nm * std::exp(-speed_rad_s / dip_speed_rad_s);
}

std::vector<const Recording*> JointLog::all() const {
  std::vector<const Recording*> each;
  for (const Recording& r : recordings) each.push_back(&r);
  return each;
}

ModelResult JointLog::identified(double gear_ratio, bool has_gravity) const {
  return method::model::identify_joint(all(), {}, gear_ratio, has_gravity);
}

JointLog record(const KnownJoint& joint, const Session& session, std::uint64_t seed) {
  const SmallEffects& e = joint.effects;
  const double n = joint.gear_ratio;
  const std::vector<Plan> plans = plan(session);
  double fastest = session.sweeps > 0 ? n * session.sweep_speed_rad_s : 0;
  for (const double speed : session.run_speeds_rad_s) fastest = std::max(fastest, n * speed);
  const double usual_friction = joint.friction_Nm(fastest / 3);
  const double top = joint.gravity_Nm + joint.friction_Nm(fastest / 2);
  const double middle = (session.low_rad + session.high_rad) / 2;
  const double reach = (session.high_rad - session.low_rad) / 2;
  const double end_s = plans.back().begin_s + plans.back().motion.length_s();

  const auto gravity = [&](double q) { return joint.gravity_Nm * std::cos(q - joint.q_peak_rad); };
  const auto wave = [&](double q, double k) {
    return std::cos(pi * k * ((q - middle) / reach + 1) / 2);
  };
  // Means over the runs: the law of friction is that at their load, place and time.
  const bool has_runs = !session.run_speeds_rad_s.empty();
  const auto mean_of_runs = [&](const std::function<double(double q, double age)>& f) {
    double sum = 0;
    double count = 0;
    for (const Plan& p : plans) {
      if (has_runs && p.role != joint::Role::constant_speed) continue;
      for (double t = 0; t < p.motion.length_s(); t += session.dt_s) {
        const Moment m = p.motion.at(t);
        if (m.dq == 0) continue;
        sum += f(m.q, (p.begin_s + t) / end_s);
        ++count;
      }
    }
    return sum / count;
  };
  const double usual_load = mean_of_runs([&](double q, double) { return std::abs(gravity(q)); });
  const double usual_age = mean_of_runs([&](double, double age) { return age; });
  std::array<double, 5> usual_wave{};
  for (std::size_t k = 0; k < usual_wave.size(); ++k) {
    usual_wave[k] =
        mean_of_runs([&](double q, double) { return wave(q, static_cast<double>(k + 1)); });
  }
  constexpr std::array decays{0.12, 0.4};
  std::array<double, 2> usual_decay{};
  for (std::size_t k = 0; k < decays.size(); ++k) {
    usual_decay[k] = mean_of_runs([&](double, double age) { return std::exp(-age / decays[k]); });
  }

  JointLog log;
  std::uint64_t stream = 0;
  for (const Plan& p : plans) {
    statistics::RandomStream random(seed, stream++);
    const bool is_run = p.role == joint::Role::constant_speed;
    const double of_recording = e.recording * random.normal();
    const double tare = e.tare != 0 ? e.tare * random.normal() : 0;
    const auto torque = [&](double t) {
      const Moment m = p.motion.at(t);
      const double v = n * std::abs(m.dq);
      const double s = m.along;
      const double age = (p.begin_s + t) / end_s;
      double friction = joint.friction_Nm(v) * (1 + e.session);
      double of_place = 0;
      for (std::size_t k = 0; k < e.place.size(); ++k) {
        of_place += e.place[k] * (wave(m.q, static_cast<double>(k + 1)) - usual_wave[k]);
      }
      friction += usual_friction * (of_place + of_recording + e.motor_turn * std::cos(n * m.q));
      friction += e.load * (std::abs(gravity(m.q)) - usual_load);
      friction += usual_friction * (e.warm_up[0] * (std::exp(-age / decays[0]) - usual_decay[0]) +
                                    e.warm_up[1] * (std::exp(-age / decays[1]) - usual_decay[1]) +
                                    e.warm_up[2] * (age - usual_age));
      const double asymmetry =
          usual_friction * (e.asymmetry_of_speed * v / fastest +
                            e.asymmetry_of_dip * std::exp(-v / joint.dip_speed_rad_s));
      const double from_peak = m.q - joint.q_peak_rad;
      const double steep = -joint.gravity_Nm * std::sin(from_peak);
      double whole = gravity(m.q) * (1 + 2 * e.gain_drift * (age - usual_age)) +
                     steep * (e.angle_scale * (m.q - middle) - e.peak_drift_rad * (2 * age - 1)) +
                     n * joint.inertia_kgm2 * m.ddq + s * friction + asymmetry;
      whole += e.square * whole * std::abs(whole) / top +
               e.cube * std::pow(whole, 3) / (top * top) + e.gain_of_speed * whole * v / fastest +
               (is_run ? e.gain_of_runs * whole + e.tool * gravity(m.q) : 0);
      double of_angle = e.spring * (m.q - middle) / reach;
      for (std::size_t k = 0; k < 2; ++k) {
        const auto order = static_cast<double>(k + 2);
        of_angle += e.harmonics[2 * k] * std::cos(order * from_peak) +
                    e.harmonics[2 * k + 1] * std::sin(order * from_peak);
      }
      for (std::size_t k = 0; k < e.waves.size(); ++k) {
        of_angle += e.waves[k] * wave(m.q, static_cast<double>(k + 3));
      }
      return whole + top * (of_angle + e.offset + e.offset_drift * (2 * age - 1) + tare);
    };
    Recording r;
    r.name = p.name;
    r.role = p.role;
    const auto count = static_cast<std::size_t>(p.motion.length_s() / session.dt_s);
    for (std::size_t i = 0; i < count; ++i) {
      const double t = session.dt_s * static_cast<double>(i);
      r.t_s.push_back(t);
      r.q_rad.push_back(p.motion.at(t).q);
      r.torque_Nm.push_back(torque(t - e.lag_s) + joint.noise_Nm * random.normal());
    }
    r.rows_read = count;
    log.recordings.push_back(std::move(r));
  }
  return log;
}

const ModelQuantity& friction_at(const ModelResult& result, double speed_rad_s) {
  const ModelQuantity* nearest = nullptr;
  for (const ModelQuantity& q : result.quantities) {
    if (q.quantity) continue;
    if (nearest == nullptr ||
        std::abs(q.speed_rad_s - speed_rad_s) < std::abs(nearest->speed_rad_s - speed_rad_s)) {
      nearest = &q;
    }
  }
  if (nearest == nullptr) throw std::out_of_range("no friction at a speed");
  return *nearest;
}

const ModelQuantity& found(const ModelResult& result, joint::Quantity quantity) {
  const ModelQuantity* q = result.find(quantity);
  if (q == nullptr) throw std::out_of_range("no " + to_string(quantity));
  return *q;
}

const ModelEffect& found(const ModelResult& result, const std::string& effect) {
  for (const ModelEffect& one : result.effects) {
    if (one.key == effect) return one;
  }
  throw std::out_of_range("no effect " + effect);
}

}  // namespace tribolog::test
