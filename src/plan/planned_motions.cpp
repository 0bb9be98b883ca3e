#include "plan/planned_motions.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "base/requirements.h"

namespace tribolog::plan {
namespace {

using std::numbers::pi;

class Hold final : public PlannedMotion {
 public:
  Hold(double angle_rad, double duration_s) : angle_rad_(angle_rad), duration_s_(duration_s) {}
  [[nodiscard]] double angle(double) const override { return angle_rad_; }
  [[nodiscard]] double speed(double) const override { return 0; }
  [[nodiscard]] double acceleration(double) const override { return 0; }
  [[nodiscard]] double duration_s() const override { return duration_s_; }

 private:
  double angle_rad_;
  double duration_s_;
};

class Travel final : public PlannedMotion {
 public:
  explicit Travel(const simulate::TravelMotion::Plan& plan) : motion_(plan) {}
  [[nodiscard]] double angle(double t) const override { return motion_.angle(t); }
  [[nodiscard]] double speed(double t) const override { return motion_.speed(t); }
  [[nodiscard]] double acceleration(double t) const override { return motion_.acceleration(t); }
  [[nodiscard]] double duration_s() const override { return motion_.duration_s(); }

 private:
  simulate::TravelMotion motion_;
};

}  // namespace

std::shared_ptr<const PlannedMotion> hold(double angle_rad, double duration_s) {
  return std::make_shared<Hold>(angle_rad, duration_s);
}

std::shared_ptr<const PlannedMotion> travel(double from_rad, double to_rad, double speed_rad_s,
                                            double acceleration_rad_s2, bool back, double rest_s) {
  require_positive(speed_rad_s, "travel speed", "rad/s");
  require_positive(acceleration_rad_s2, "travel acceleration", "rad/s²");
  constexpr double most_on_ramps = 0.8;  // of the way
  const double way = std::abs(to_rad - from_rad);
  // Both ramps together take v^2 pi/(2 a).
  const double reachable = std::sqrt(most_on_ramps * way * 2 * acceleration_rad_s2 / pi);
  return std::make_shared<Travel>(simulate::TravelMotion::Plan{
      from_rad, to_rad, std::min(speed_rad_s, reachable), acceleration_rad_s2, back, rest_s});
}

EasedSine::EasedSine(double centre_rad, double amplitude_rad, double frequency_Hz, int cycles,
                     double ease_s)
    : centre_rad_(centre_rad),
      amplitude_rad_(amplitude_rad),
      omega_rad_s_(2 * pi * frequency_Hz),
      ease_s_(ease_s),
      duration_s_(2 * ease_s + cycles / frequency_Hz) {
  require_positive(amplitude_rad, "amplitude", "rad");
  require_positive(frequency_Hz, "frequency", "Hz");
  require_positive(ease_s, "transition of an oscillation", "s");
  constexpr double longest_share = 0.2;  // of a period; at half of one the integral has a pole
  if (ease_s * frequency_Hz > longest_share * (1 + 1e-9)) {
    throw std::invalid_argument(
        fmt::format("a transition of {} s is longer than a fifth of a period of {} s", ease_s,
                    1 / frequency_Hz));
  }
  if (cycles < 1) {
    throw std::invalid_argument(fmt::format("{} cycles are not allowed; it must be >= 1", cycles));
  }
}

double EasedSine::eased_way(double t_s) const {
  // Integral of (1 - cos(pi t/e))/2 * a w cos(w (t - e)) from 0 to t.
  const double w = omega_rad_s_;
  const double p = pi / ease_s_;
  const double start = -w * ease_s_;
  const auto antiderivative = [&](double t) {
    return std::sin(w * t + start) / (2 * w) - std::sin((p + w) * t + start) / (4 * (p + w)) -
           std::sin((p - w) * t - start) / (4 * (p - w));
  };
  return amplitude_rad_ * w * (antiderivative(t_s) - antiderivative(0));
}

double EasedSine::start_rad() const { return centre_rad_ - eased_way(ease_s_); }
double EasedSine::end_rad() const { return centre_rad_ + eased_way(ease_s_); }

double EasedSine::angle(double t_s) const {
  const double t = std::clamp(t_s, 0.0, duration_s_);
  if (t < ease_s_) return start_rad() + eased_way(t);
  if (t > duration_s_ - ease_s_) return end_rad() - eased_way(duration_s_ - t);
  return centre_rad_ + amplitude_rad_ * std::sin(omega_rad_s_ * (t - ease_s_));
}

double EasedSine::speed(double t_s) const {
  if (t_s <= 0 || t_s >= duration_s_) return 0;
  const double sine = amplitude_rad_ * omega_rad_s_ * std::cos(omega_rad_s_ * (t_s - ease_s_));
  const double from_end = std::min(t_s, duration_s_ - t_s);
  return from_end < ease_s_ ? sine * (1 - std::cos(pi * from_end / ease_s_)) / 2 : sine;
}

double EasedSine::acceleration(double t_s) const {
  if (t_s <= 0 || t_s >= duration_s_) return 0;
  const double w = omega_rad_s_;
  const double x = w * (t_s - ease_s_);
  const double sine = -amplitude_rad_ * w * w * std::sin(x);
  const double from_end = std::min(t_s, duration_s_ - t_s);
  if (from_end >= ease_s_) return sine;
  const double p = pi / ease_s_;
  const double share = (1 - std::cos(p * from_end)) / 2;
  const double rate = p / 2 * std::sin(p * from_end) * (t_s < duration_s_ / 2 ? 1 : -1);
  return share * sine + rate * amplitude_rad_ * w * std::cos(x);
}

double EasedSine::largest_acceleration_rad_s2(double amplitude_rad, double frequency_Hz,
                                              double ease_s) {
  const double w = 2 * pi * frequency_Hz;
  return amplitude_rad * w * (w + pi / (2 * ease_s));
}

}  // namespace tribolog::plan
