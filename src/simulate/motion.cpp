#include "simulate/motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "base/requirements.h"
#include "base/statement.h"
#include "friction/sign_change.h"

namespace tribolog::simulate {

using std::numbers::pi;

void Motion::speeds(double t0_s, double dt_s, std::span<double> out) const {
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = speed(t0_s + static_cast<double>(i) * dt_s);
}

HarmonicMotion::HarmonicMotion(double centre_rad, double frequency_Hz,
                               std::vector<Harmonic> harmonics)
    : centre_rad_(centre_rad),
      omega_rad_s_(2 * pi * frequency_Hz),
      harmonics_(std::move(harmonics)) {
  require_positive(frequency_Hz, "frequency", "Hz");
  if (harmonics_.empty()) throw std::invalid_argument("no harmonic");
}

HarmonicMotion HarmonicMotion::sine(double centre_rad, double amplitude_rad, double frequency_Hz) {
  return {centre_rad, frequency_Hz, {{0.0, amplitude_rad}}};
}

namespace {

/// Visits each harmonic with its order, cos(k x) and sin(k x): one trigonometric function each for
/// few, for many by multiplication from order to order.
template <class Visit>
void over_orders(const std::vector<HarmonicMotion::Harmonic>& harmonics, double x, Visit visit) {
  constexpr std::size_t few = 4;
  const std::complex<double> first = std::polar(1.0, x);
  std::complex<double> order = 1.0;
  for (std::size_t i = 0; i < harmonics.size(); ++i) {
    const auto k = static_cast<double>(i + 1);
    order = i < few ? std::polar(1.0, k * x) : order * first;
    visit(harmonics[i], k, order.real(), order.imag());
  }
}

}  // namespace

double HarmonicMotion::angle(double t_s) const {
  double sum = centre_rad_;
  over_orders(harmonics_, omega_rad_s_ * t_s,
              [&](const Harmonic& h, double /*order*/, double cosine, double sine) {
                sum += h.cosine * cosine + h.sine * sine;
              });
  return sum;
}

double HarmonicMotion::speed(double t_s) const {
  double sum = 0;
  over_orders(harmonics_, omega_rad_s_ * t_s,
              [&](const Harmonic& h, double order, double cosine, double sine) {
                sum += order * omega_rad_s_ * (h.sine * cosine - h.cosine * sine);
              });
  return sum;
}

double HarmonicMotion::acceleration(double t_s) const {
  double sum = 0;
  over_orders(harmonics_, omega_rad_s_ * t_s,
              [&](const Harmonic& h, double order, double cosine, double sine) {
                const double w = order * omega_rad_s_;
                sum -= w * w * (h.cosine * cosine + h.sine * sine);
              });
  return sum;
}

namespace {

/// cos(j d) and sin(j d) for j = 0, 1, ..., each from two earlier ones by the addition theorem with
/// the index halved, so that rounding grows with the logarithm of j only.
struct RotationTable {
  static constexpr std::size_t size = 64;
  std::array<double, size> cosine;
  std::array<double, size> sine;

  explicit RotationTable(double d) {
    cosine[0] = 1;
    sine[0] = 0;
    for (std::size_t half = 1; half < size; half *= 2) {
      const double c = std::cos(d * static_cast<double>(half));
      const double s = std::sin(d * static_cast<double>(half));
      for (std::size_t j = 0; j < half; ++j) {
        cosine[half + j] = c * cosine[j] - s * sine[j];
        sine[half + j] = s * cosine[j] + c * sine[j];
      }
    }
  }
};

}  // namespace

void HarmonicMotion::speeds(double t0_s, double dt_s, std::span<double> out) const {
  // cos(x + d) and sin(x + d) from one pair at a block's start and a table of d: two products for
  // each sample instead of a trigonometric function.
  std::fill(out.begin(), out.end(), 0.0);
  for (std::size_t k = 0; k < harmonics_.size(); ++k) {
    const double w = static_cast<double>(k + 1) * omega_rad_s_;
    const double a = w * harmonics_[k].sine;
    const double b = -w * harmonics_[k].cosine;
    if (a == 0 && b == 0) continue;
    const RotationTable table(w * dt_s);
    for (std::size_t first = 0; first < out.size(); first += RotationTable::size) {
      const double x = w * (t0_s + static_cast<double>(first) * dt_s);
      const double c = std::cos(x);
      const double s = std::sin(x);
      const double along = a * c + b * s;
      const double across = b * c - a * s;
      const std::size_t count = std::min(RotationTable::size, out.size() - first);
      for (std::size_t j = 0; j < count; ++j) {
        out[first + j] += along * table.cosine[j] + across * table.sine[j];
      }
    }
  }
}

double TravelMotion::ramp_way_rad(double speed_rad_s, double acceleration_rad_s2) {
  const double ramp_s = speed_rad_s * pi / (2 * acceleration_rad_s2);
  return speed_rad_s * ramp_s / 2;
}

TravelMotion::TravelMotion(const Plan& plan) : plan_(plan) {
  require_positive(plan.speed_rad_s, "travel speed", "rad/s");
  require_positive(plan.acceleration_rad_s2, "travel acceleration", "rad/s²");
  ramp_s_ = plan.speed_rad_s * pi / (2 * plan.acceleration_rad_s2);
  const double way = std::abs(plan.to_rad - plan.from_rad);
  const double ramps = 2 * ramp_way_rad(plan.speed_rad_s, plan.acceleration_rad_s2);
  if (!(way > ramps)) {
    throw Refusal({"travel.way_too_short",
                   {{"way_rad", way},
                    {"speed_rad_s", plan.speed_rad_s},
                    {"acceleration_rad_s2", plan.acceleration_rad_s2},
                    {"ramps_rad", ramps}}});
  }
  cruise_s_ = (way - ramps) / plan.speed_rad_s;
}

double TravelMotion::duration_s() const {
  const double stroke = 2 * ramp_s_ + cruise_s_;
  return plan_.back ? 3 * plan_.rest_s + 2 * stroke : 2 * plan_.rest_s + stroke;
}

struct TravelMotion::Phase {
  double way{};           // travelled along the stroke [rad]
  double speed{};         // along the stroke
  double acceleration{};  // along the stroke
  bool returning{};
};

TravelMotion::Phase TravelMotion::at(double t_s) const {
  const double stroke = 2 * ramp_s_ + cruise_s_;
  double t = t_s - plan_.rest_s;
  bool returning = false;
  if (plan_.back && t > stroke) {
    if (t < stroke + plan_.rest_s)
      t = stroke;
    else {
      t -= stroke + plan_.rest_s;
      returning = true;
    }
  }
  t = std::clamp(t, 0.0, stroke);
  const double v = plan_.speed_rad_s;
  // A raised cosine from 0 to v over the ramp, tau counted from its slow end.
  const auto ramp = [&](double tau) {
    const double x = pi * tau / ramp_s_;
    return Phase{v / 2 * (tau - ramp_s_ / pi * std::sin(x)), v / 2 * (1 - std::cos(x)),
                 v * pi / (2 * ramp_s_) * std::sin(x), false};
  };
  Phase phase;
  if (t < ramp_s_) {
    phase = ramp(t);
  } else if (t <= ramp_s_ + cruise_s_) {
    phase = {v * ramp_s_ / 2 + v * (t - ramp_s_), v, 0.0, false};
  } else {
    phase = ramp(stroke - t);
    phase.way = v * ramp_s_ + v * cruise_s_ - phase.way;
    phase.acceleration = -phase.acceleration;
  }
  phase.returning = returning;
  return phase;
}

double TravelMotion::angle(double t_s) const {
  const Phase phase = at(t_s);
  const double sign = plan_.to_rad > plan_.from_rad ? 1.0 : -1.0;
  return phase.returning ? plan_.to_rad - sign * phase.way : plan_.from_rad + sign * phase.way;
}

double TravelMotion::speed(double t_s) const {
  const Phase phase = at(t_s);
  const double sign = plan_.to_rad > plan_.from_rad ? 1.0 : -1.0;
  return (phase.returning ? -sign : sign) * phase.speed;
}

double TravelMotion::acceleration(double t_s) const {
  const Phase phase = at(t_s);
  const double sign = plan_.to_rad > plan_.from_rad ? 1.0 : -1.0;
  return (phase.returning ? -sign : sign) * phase.acceleration;
}

namespace {

/// Around a reversal: where rounding may give the speed either sign.
struct Uncertain {
  double from_s;
  double to_s;
};

/// All of [a, b] if the speeds at its ends are not of opposite sign.
Uncertain uncertain_within(const Motion& motion, double a_s, double b_s, bool negative_first) {
  const double sign = negative_first ? -1.0 : 1.0;
  const auto speed = [&](double t) { return sign * motion.speed(t); };
  if (!(speed(a_s) > 0 && speed(b_s) < 0)) return {a_s, b_s};
  const double few_units = 64 * std::numeric_limits<double>::epsilon() * std::abs(b_s);
  const double near = friction::sign_change(speed, a_s, b_s, few_units);
  return {near - 2 * few_units, near + few_units};
}

}  // namespace

double reversal_time(const Motion& motion, double a_s, double b_s, bool negative_first) {
  const Uncertain uncertain = uncertain_within(motion, a_s, b_s, negative_first);
  double a = a_s;
  double b = b_s;
  constexpr int most_halvings = 80;
  for (int i = 0; i < most_halvings; ++i) {
    const double middle = a + (b - a) / 2;
    if (middle <= a || middle >= b) break;
    if (middle < uncertain.from_s) {
      a = middle;
    } else if (middle > uncertain.to_s) {
      b = middle;
    } else {
      const double w = motion.speed(middle);
      if (w == 0) return middle;
      ((w < 0) == negative_first ? a : b) = middle;
    }
  }
  return b;
}

}  // namespace tribolog::simulate
