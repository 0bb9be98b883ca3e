#include "method/motion/traced_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "method/motion/encoder_resolution.h"
#include "method/motion/moving_part.h"
#include "statistics/sampled_signal.h"
#include "statistics/smoothing_spline.h"

namespace tribolog::method::motion {

// Where a recorded angle is known, and how well.
//
// A quantised angle that changes slowly is best known where it steps: between two samples there it
// is at the edge between two steps, to within its travel from one sample to the next. The samples
// on a step only show that the angle is within it; they count where the angle reverses or the
// recording begins or ends, and no edge shows more. Where it changes so fast that a step holds a
// single sample, each sample is a point: edges between them would share samples, and errors that
// are not independent would be taken for motion.

namespace {

/// Standard deviation of rounding, in steps.
const double rounding = 1 / std::sqrt(12.0);
/// Steps last for many samples where the motion all but stops; it is not known that well there.
constexpr double most_samples_on_step = 20;

/// Samples [first, last) of one value.
struct Tread {
  std::size_t first, last;
  [[nodiscard]] double samples() const { return static_cast<double>(last - first); }
};

std::vector<Tread> treads_of(const std::vector<double>& q, double step_rad) {
  std::vector<Tread> treads;
  for (std::size_t i = 0; i < q.size(); ++i) {
    if (treads.empty() || std::abs(q[i] - q[i - 1]) > step_rad / 2) treads.push_back({i, i});
    treads.back().last = i + 1;
  }
  return treads;
}

/// @param step_rad of the angle; 0: continuous, and all samples count alike.
statistics::CurvePoints angle_points(const std::vector<double>& t, const std::vector<double>& q,
                                     double step_rad) {
  if (!(step_rad > 0)) return {t, q, std::vector<double>(t.size(), 1.0)};
  const std::vector<Tread> treads = treads_of(q, step_rad);
  statistics::CurvePoints out;
  const auto add = [&](double time, double angle, double error) {
    if (!out.t.empty() && !(time > out.t.back())) return;
    out.t.push_back(time);
    out.y.push_back(angle);
    out.error.push_back(error);
  };
  const auto rise = [&](std::size_t k) { return q[treads[k + 1].first] - q[treads[k].first]; };
  const auto is_single = [&](std::size_t k) { return treads[k].last - treads[k].first == 1; };
  const auto has_edge_behind = [&](std::size_t k) { return !is_single(k) && !is_single(k + 1); };
  for (std::size_t k = 0; k < treads.size(); ++k) {
    const Tread& tread = treads[k];
    const bool at_end = k == 0 || k + 1 == treads.size();
    if (at_end || rise(k - 1) * rise(k) < 0 || !(has_edge_behind(k - 1) || has_edge_behind(k))) {
      const std::size_t last = tread.last - 1;
      const double time = k == 0 ? t.front() : at_end ? t.back() : (t[tread.first] + t[last]) / 2;
      add(time, q[tread.first], rounding * step_rad);
    }
    if (k + 1 == treads.size()) break;
    if (!has_edge_behind(k)) continue;
    const Tread& next = treads[k + 1];
    const double samples =
        std::clamp(std::min(tread.samples(), next.samples()), 1.0, most_samples_on_step);
    add((t[tread.last - 1] + t[next.first]) / 2, (q[tread.first] + q[next.first]) / 2,
        rounding * step_rad / samples);
  }
  return out;
}

constexpr std::size_t fewest_samples = 40;
/// A start and one loop.
constexpr std::size_t fewest_strokes = 3;
constexpr double fewest_samples_in_stroke = 20;
/// As for harmonics: the residual of the angle stays below a fiftieth of the amplitude.
constexpr double largest_noise_share = 0.02;
/// A reversal counts where the angle runs back by this many standard deviations of its noise, or by
/// this share of its range.
constexpr double turn_noises = 10;
constexpr double turn_share = 1e-3;
/// Travel to and fro within the noise, which bristles would take for motion, over that of the
/// strokes.
constexpr double largest_excess_way = 0.1;

class SplineMotion final : public simulate::Motion {
 public:
  SplineMotion(std::shared_ptr<const statistics::SmoothingSpline> spline, double origin_rad,
               double gear_ratio)
      : spline_(std::move(spline)), origin_rad_(origin_rad), gear_ratio_(gear_ratio) {}
  [[nodiscard]] double angle(double t_s) const override {
    return gear_ratio_ * (origin_rad_ + spline_->at(t_s).value);
  }
  [[nodiscard]] double speed(double t_s) const override {
    return gear_ratio_ * spline_->at(t_s).slope;
  }
  [[nodiscard]] double acceleration(double t_s) const override {
    return gear_ratio_ * spline_->at(t_s).curvature;
  }

 private:
  std::shared_ptr<const statistics::SmoothingSpline> spline_;
  double origin_rad_;
  double gear_ratio_;
};

double way_of(const std::vector<double>& q) {
  double way = 0;
  for (std::size_t i = 0; i + 1 < q.size(); ++i) way += std::abs(q[i + 1] - q[i]);
  return way;
}

MotionTrace refused(Statement why) { return {std::nullopt, std::move(why)}; }

}  // namespace

double noise_of_angle(const std::vector<double>& q_rad, double encoder_step_rad) {
  // Slow motion over steps has third differences that are not those of noise.
  const double white = statistics::white_sd_beside_jumps(statistics::third_differences(q_rad));
  return white < encoder_step_rad ? rounding * encoder_step_rad : white;
}

Statement TracedMotion::noise_source() const {
  if (is_stepped()) return {"motion.encoder_step", {{"step_rad", encoder_step_rad}}};
  return {"motion.sample_scatter", {{"noise_rad", noise_rad}}};
}

std::unique_ptr<simulate::Motion> TracedMotion::motor_motion(double gear_ratio) const {
  return std::make_unique<SplineMotion>(spline, origin_rad, gear_ratio);
}

MotionTrace trace_motion(const joint::Recording& r, const TracedMotion* found,
                         double weighed_from_s) {
  if (r.size() < fewest_samples) {
    return refused({"motion.too_few_samples", {{"samples", r.size()}, {"needed", fewest_samples}}});
  }
  const auto [low, high] = std::minmax_element(r.q_rad.begin(), r.q_rad.end());
  if (!(*high > *low)) return refused({"motion.angle_constant"});
  TracedMotion out;
  out.centre_rad = (*low + *high) / 2;
  out.amplitude_rad = (*high - *low) / 2;
  out.encoder_step_rad = common_step(r.q_rad);
  out.noise_rad = noise_of_angle(r.q_rad, out.encoder_step_rad);
  out.origin_rad = r.q_rad.front();
  if (out.noise_rad > largest_noise_share * out.amplitude_rad) {
    return refused({"motion.too_noisy",
                    {{"source", out.noise_source()},
                     {"noise_rad", out.noise_rad},
                     {"noise_percent", 100 * out.noise_rad / out.amplitude_rad},
                     {"amplitude_rad", out.amplitude_rad},
                     {"most_percent", 100 * largest_noise_share}}});
  }
  std::vector<double> t;
  std::vector<double> q;
  for (std::size_t i = 0; i < r.size(); ++i) {
    t.push_back(r.t_s[i] - r.t_s.front());
    q.push_back(r.q_rad[i] - out.origin_rad);
  }
  const statistics::CurvePoints points =
      angle_points(t, q, out.is_stepped() ? out.encoder_step_rad : 0.0);
  out.spline = found != nullptr
                   ? std::make_shared<statistics::SmoothingSpline>(points, *found->spline)
                   : std::make_shared<statistics::SmoothingSpline>(points, weighed_from_s);
  std::vector<double> smooth;
  double squares = 0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    smooth.push_back(out.spline->at(t[i]).value);
    squares += std::pow(q[i] - smooth[i], 2);
  }
  out.residual_rad = std::sqrt(squares / static_cast<double>(t.size()));
  const std::vector<Stroke> strokes = find_strokes(
      smooth, std::max(turn_noises * out.noise_rad, 2 * turn_share * out.amplitude_rad));
  if (strokes.size() < fewest_strokes) {
    return refused(
        {strokes.size() == 1 ? Code{"motion.one_stroke"} : Code{"motion.too_few_strokes"},
         {{"strokes", strokes.size()},
          {"reversals", std::max<std::size_t>(1, strokes.size()) - 1},
          {"needed", fewest_strokes}}});
  }
  const double in_stroke = static_cast<double>(r.size()) / static_cast<double>(strokes.size());
  if (in_stroke < fewest_samples_in_stroke) {
    return refused({"motion.too_few_samples_in_stroke",
                    {{"samples", in_stroke}, {"needed", fewest_samples_in_stroke}}});
  }
  double travel = 0;
  for (const Stroke& stroke : strokes) travel += stroke.travel_rad;
  const double excess = way_of(smooth) / travel - 1;
  if (excess > largest_excess_way) {
    return refused({"motion.to_and_fro",
                    {{"noise_rad", out.noise_rad},
                     {"excess_percent", 100 * excess},
                     {"most_percent", 100 * largest_excess_way}}});
  }
  for (std::size_t k = 1; k < strokes.size(); ++k) out.turns_s.push_back(t[strokes[k].first]);
  out.frequency_Hz = static_cast<double>(strokes.size()) / 2 / t.back();
  return {std::move(out), {}};
}

}  // namespace tribolog::method::motion
