#include "report/document/key_pictures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "joint/degrees.h"
#include "report/document/view_parts.h"
#include "report/elements/kept_samples.h"
#include "wording/axis_scale.h"
#include "wording/labels.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::document {
namespace {

using wording::AxisScale;
using wording::Extent;
using wording::tr;

struct Points {
  std::vector<double> x, y;

  void add(double at, double value) {
    if (!std::isfinite(at) || !std::isfinite(value)) return;
    x.push_back(at);
    y.push_back(value);
  }
};

/// 1, 2 or 5 times a power of ten, so that about `wanted` of them make up the span.
double step_for(double span, int wanted) {
  const double raw = span / wanted;
  const double decade = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * decade >= raw) return factor * decade;
  }
  return 10 * decade;
}

/// One axis, from shown values to pixels.
class Axis {
 public:
  Axis(Extent shown, bool is_logarithmic, double first_px, double last_px)
      : is_logarithmic_(is_logarithmic), first_(first_px), last_(last_px) {
    low_ = is_logarithmic ? std::log10(shown.low) : shown.low;
    high_ = is_logarithmic ? std::log10(shown.high) : shown.high;
    const double margin = 0.05 * (high_ - low_);
    low_ -= margin;
    high_ += margin;
  }

  [[nodiscard]] double at(double shown) const {
    const double value = is_logarithmic_ ? std::log10(shown) : shown;
    return first_ + (value - low_) / (high_ - low_) * (last_ - first_);
  }

  [[nodiscard]] std::vector<KeyPicture::Tick> ticks(int wanted) const {
    std::vector<KeyPicture::Tick> ticks;
    const auto add = [&](double value) {
      ticks.push_back({at(value), wording::with_minus_sign(wording::as_stated(value))});
    };
    if (is_logarithmic_) {
      constexpr double two_decades = 2;
      const bool is_short = high_ - low_ < two_decades;
      for (double decade = std::floor(low_); decade <= high_; decade += 1) {
        for (const double factor : {1.0, 2.0, 5.0}) {
          if (factor != 1.0 && !is_short) continue;
          const double value = factor * std::pow(10.0, decade);
          if (std::log10(value) >= low_ && std::log10(value) <= high_) add(value);
        }
      }
      return ticks;
    }
    const double step = step_for(high_ - low_, wanted);
    for (double k = std::ceil(low_ / step); k * step <= high_; k += 1) add(k * step);
    return ticks;
  }

 private:
  bool is_logarithmic_;
  double first_, last_, low_{}, high_{};
};

constexpr double left_px = 56;
constexpr double right_px = picture_width - 8;
constexpr double top_px = 8;
constexpr double bottom_px = picture_height - 44;

class Frame {
 public:
  Frame(const Extent& x, bool x_is_logarithmic, const Extent& y)
      : x_(x, x_is_logarithmic, left_px, right_px), y_(y, false, bottom_px, top_px) {}

  [[nodiscard]] std::string line(const Points& points) const {
    std::string path;
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x_.at(points.x[i]),
                          y_.at(points.y[i]));
    }
    return path;
  }
  /// A dot each, which the style makes round.
  [[nodiscard]] std::string dots(const Points& points) const {
    std::string path;
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      path += fmt::format("M{:.1f} {:.1f}h0", x_.at(points.x[i]), y_.at(points.y[i]));
    }
    return path;
  }
  [[nodiscard]] std::string bars(const Points& points,
                                 const std::vector<double>& half_widths) const {
    std::string path;
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      path += fmt::format("M{:.1f} {:.1f}V{:.1f}", x_.at(points.x[i]),
                          y_.at(points.y[i] - half_widths[i]), y_.at(points.y[i] + half_widths[i]));
    }
    return path;
  }
  /// Between two curves over the same places.
  [[nodiscard]] std::string band(const Points& low, const Points& high) const {
    if (low.x.empty() || high.x.empty()) return "";
    std::string path = line(low);
    for (std::size_t i = high.x.size(); i-- > 0;) {
      path += fmt::format("L{:.1f} {:.1f}", x_.at(high.x[i]), y_.at(high.y[i]));
    }
    return path + "Z";
  }
  [[nodiscard]] std::string level(double shown) const {
    return fmt::format("M{} {:.1f}H{}", left_px, y_.at(shown), right_px);
  }
  [[nodiscard]] std::string strip_across(double low, double high) const {
    return fmt::format("M{0} {1:.1f}H{2}V{3:.1f}H{0}Z", left_px, y_.at(low), right_px, y_.at(high));
  }
  [[nodiscard]] std::string strip_up(double low, double high) const {
    return fmt::format("M{0:.1f} {1}V{2}H{3:.1f}V{1}Z", x_.at(low), top_px, bottom_px, x_.at(high));
  }

  void draw_axes(KeyPicture& picture) const {
    constexpr int x_ticks = 5;
    constexpr int y_ticks = 5;
    picture.x_ticks = x_.ticks(x_ticks);
    picture.y_ticks = y_.ticks(y_ticks);
    for (const KeyPicture::Tick& tick : picture.x_ticks) {
      picture.grid += fmt::format("M{:.1f} {}V{}", tick.at, top_px, bottom_px);
    }
    for (const KeyPicture::Tick& tick : picture.y_ticks) {
      picture.grid += fmt::format("M{} {:.1f}H{}", left_px, tick.at, right_px);
    }
  }

 private:
  Axis x_, y_;
};

/// With its axes; nothing is drawn in it yet.
KeyPicture begun(const std::string& id, const std::string& title, const std::string& x_title,
                 const std::string& y_title, const Frame& frame) {
  KeyPicture picture;
  picture.id = id;
  picture.title = title;
  picture.x_title = x_title;
  picture.y_title = y_title;
  frame.draw_axes(picture);
  return picture;
}

/// With its expanded interval; nullptr where there is nothing to state.
const statistics::Estimate* known(const calibration::Calibration& c, joint::Quantity quantity) {
  const calibration::QuantityVerdict* q = c.judgement.find(quantity);
  const calibration::UncertaintyBudget* budget = q == nullptr ? nullptr : stated_budget(*q);
  return budget == nullptr ? nullptr : &budget->expanded;
}

/// Without one, motor and joint are the same, and all is said of the joint.
bool has_gear(const calibration::Calibration& c) { return c.manifest.drive.gear_ratio() != 1.0; }

std::string torque_side(const calibration::Calibration& c) {
  return has_gear(c) ? tr("torque at the motor") : tr("torque at the joint");
}

std::optional<KeyPicture> loop_picture(const calibration::Calibration& c) {
  if (!c.hysteresis.found || c.curves.loops.empty() || c.hysteresis.oscillations.empty()) {
    return std::nullopt;
  }
  const method::hysteresis::LoopTrace& trace = c.curves.loops.front();
  const method::hysteresis::Oscillation& motion = c.hysteresis.oscillations.front();
  if (trace.t_s.empty()) return std::nullopt;
  const bool is_fitted = trace.model_torque_Nm.size() == trace.t_s.size();
  const std::vector<std::size_t> kept =
      elements::last_cycles(trace.t_s, motion.frequency_Hz, 1, 500);
  Extent torque;
  Extent angle;
  for (const std::size_t i : kept) {
    angle.add(trace.q_rad[i] - motion.centre_rad);
    torque.add(trace.torque_Nm[i]);
    if (is_fitted) torque.add(trace.model_torque_Nm[i]);
  }
  if (!(angle.span() > 0) || !(torque.span() > 0)) return std::nullopt;
  const AxisScale x = angle.largest() * joint::degrees_per_rad > 1
                          ? wording::degrees()
                          : wording::prefixed("rad", angle.largest());
  const AxisScale y = wording::prefixed("N·m", torque.largest());
  Points measured;
  Points fitted;
  for (const std::size_t i : kept) {
    measured.add(x(trace.q_rad[i] - motion.centre_rad), y(trace.torque_Nm[i]));
    if (is_fitted) fitted.add(x(trace.q_rad[i] - motion.centre_rad), y(trace.model_torque_Nm[i]));
  }
  Extent shown_x;
  Extent shown_y;
  shown_x.add(measured.x);
  shown_y.add(measured.y);
  shown_y.add(fitted.y);
  const Frame frame(shown_x, false, shown_y);
  KeyPicture picture = begun("picture-loop", tr("Hysteresis loop"),
                             wording::axis_title(tr("joint angle from the loop's centre"), x),
                             wording::axis_title(torque_side(c), y), frame);
  picture.measured = frame.line(measured);
  picture.fitted = frame.line(fitted);
  picture.caption = fitted.x.empty() ? tr("Dark: the last cycle as measured.")
                                     : tr("Dark: the last cycle as measured; blue: the LuGre fit.");
  const statistics::Estimate* gravity = known(c, joint::Quantity::gravity_torque);
  if (gravity != nullptr && c.q_peak_rad) {
    const double cosine = std::cos(motion.centre_rad - c.q_peak_rad->value);
    const statistics::Estimate at_centre = statistics::scaled(*gravity, cosine);
    const double middle = y(at_centre.value);
    if (middle > shown_y.low && middle < shown_y.high) {
      picture.level = frame.level(middle);
      picture.band = frame.strip_across(std::max(y(at_centre.low), shown_y.low),
                                        std::min(y(at_centre.high), shown_y.high));
      picture.caption += " " + tr("Dashed: the gravity torque, with its interval as a band.");
    }
  }
  return picture;
}

std::optional<KeyPicture> sweep_picture(const calibration::Calibration& c) {
  const method::gravity::SweepCurves& sweep = c.curves.rough;
  if (!c.rough.found || sweep.fit_q_rad.size() < 2) return std::nullopt;
  Extent torque;
  torque.add(sweep.fit_rising_Nm);
  torque.add(sweep.fit_falling_Nm);
  if (!(torque.span() > 0)) return std::nullopt;
  const AxisScale x = wording::degrees();
  const AxisScale y = wording::prefixed("N·m", torque.largest());
  Points rising;
  Points falling;
  for (std::size_t i = 0; i < sweep.fit_q_rad.size(); ++i) {
    if (i < sweep.fit_rising_Nm.size())
      rising.add(x(sweep.fit_q_rad[i]), y(sweep.fit_rising_Nm[i]));
    if (i < sweep.fit_falling_Nm.size()) {
      falling.add(x(sweep.fit_q_rad[i]), y(sweep.fit_falling_Nm[i]));
    }
  }
  Extent shown_x;
  Extent shown_y;
  for (const Points* points : {&rising, &falling}) {
    shown_x.add(points->x);
    shown_y.add(points->y);
  }
  if (!(shown_x.span() > 0)) return std::nullopt;
  const Frame frame(shown_x, false, shown_y);
  KeyPicture picture =
      begun("picture-sweep", tr("Sweep"), wording::axis_title(tr("joint angle"), x),
            wording::axis_title(torque_side(c), y), frame);
  picture.fitted = frame.line(rising) + frame.line(falling);
  picture.caption = tr("The sweep's torque as fitted, with the angle rising and falling.");
  const statistics::Estimate* angle = known(c, joint::Quantity::cog_angle);
  if (angle != nullptr) {
    const statistics::Estimate& at = *angle;
    if (x(at.low) > shown_x.low && x(at.high) < shown_x.high) {
      // At least as wide as can be seen.
      const double middle = x(at.value);
      const double half = std::max(x(at.half_width()), 0.002 * shown_x.span());
      picture.band = frame.strip_up(middle - half, middle + half);
      picture.caption += " " + tr("Band: the angle of largest gravity torque.");
    }
  }
  return picture;
}

/// Friction along the motion, each direction on its own.
std::optional<KeyPicture> curve_picture(const calibration::Calibration& c) {
  const method::viscous::ViscousCurve* curve = c.viscous.find(c.selection.recommended);
  const std::vector<method::viscous::ConstantSpeedRun>& runs = c.viscous.runs;
  if (curve == nullptr || curve->friction_Nm.size() != runs.size()) return std::nullopt;
  Extent speed;
  Extent torque;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i].speed_rad_s == 0.0 || !std::isfinite(curve->friction_Nm[i])) continue;
    speed.add(std::abs(runs[i].speed_rad_s));
    const double friction_Nm = std::copysign(1.0, runs[i].speed_rad_s) * curve->friction_Nm[i];
    torque.add(friction_Nm - runs[i].torque_half_width_Nm);
    torque.add(friction_Nm + runs[i].torque_half_width_Nm);
    torque.add(friction_Nm);
  }
  if (!(speed.span() > 0) || !(torque.span() > 0)) return std::nullopt;
  // Read upwards from zero, as friction is, unless it hardly differs.
  constexpr double half = 0.5;
  if (torque.low > 0 && torque.low < half * torque.high) torque.add(0.0);
  constexpr double wide = 20;
  const bool is_logarithmic = speed.high > wide * speed.low;
  const AxisScale x = wording::prefixed("rad/s", speed.largest());
  const AxisScale y = wording::prefixed("N·m", torque.largest());
  Points forward;
  Points backward;
  std::vector<double> forward_bars;
  std::vector<double> backward_bars;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const double velocity = runs[i].speed_rad_s;
    if (velocity == 0.0 || !std::isfinite(curve->friction_Nm[i])) continue;
    const bool is_forward = velocity > 0;
    (is_forward ? forward : backward)
        .add(x(std::abs(velocity)), y(std::copysign(1.0, velocity) * curve->friction_Nm[i]));
    const double bar = y.factor * runs[i].torque_half_width_Nm;
    (is_forward ? forward_bars : backward_bars).push_back(std::isfinite(bar) ? bar : 0.0);
  }
  Points law;
  Points low;
  Points high;
  const method::model::ModelLaw& model = c.model.law;
  if (!model.empty()) {
    constexpr int points = 100;
    for (const double at : model.speeds_rad_s(points)) {
      if (!(at >= speed.low && at <= speed.high)) continue;
      const double friction_Nm = model.friction_Nm(at);
      law.add(x(at), y(friction_Nm));
      torque.add(friction_Nm);
    }
  }
  for (const calibration::FrictionAtSpeed& f : c.judgement.friction_at_speed) {
    if (!(f.speed_rad_s >= speed.low && f.speed_rad_s <= speed.high)) continue;
    low.add(x(f.speed_rad_s), y(f.torque_Nm.low));
    high.add(x(f.speed_rad_s), y(f.torque_Nm.high));
  }
  Extent shown_x;
  Extent shown_y;
  shown_x.add(x(speed.low));
  shown_x.add(x(speed.high));
  shown_y.add(y(torque.low));
  shown_y.add(y(torque.high));
  for (double& value : low.y) value = std::max(value, shown_y.low);
  for (double& value : high.y) value = std::min(value, shown_y.high);
  const Frame frame(shown_x, is_logarithmic, shown_y);
  KeyPicture picture =
      begun("picture-curve", tr("Friction curve"),
            wording::axis_title(has_gear(c) ? tr("motor speed") : tr("joint speed"), x),
            wording::axis_title(
                has_gear(c) ? tr("friction at the motor") : tr("friction at the joint"), y),
            frame);
  picture.forward = frame.dots(forward);
  picture.backward = frame.dots(backward);
  picture.bars = frame.bars(forward, forward_bars) + frame.bars(backward, backward_bars);
  picture.fitted = frame.line(law);
  picture.band = frame.band(low, high);
  picture.caption = c.viscous.from_sweep
                        ? tr("Parts of the sweep, forward as dots and backward as rings.")
                        : tr("Runs, forward as dots and backward as rings, with 95 % bars.");
  if (!picture.fitted.empty()) {
    picture.caption += " " + tr("Blue: {law}; band: friction, 95 %.", {{"law", described(model)}});
  }
  return picture;
}

}  // namespace

std::vector<KeyPicture> key_pictures(const calibration::Calibration& c) {
  std::vector<KeyPicture> pictures;
  std::optional<KeyPicture> loop = loop_picture(c);
  if (!loop) loop = sweep_picture(c);
  if (loop) pictures.push_back(std::move(*loop));
  if (std::optional<KeyPicture> curve = curve_picture(c)) pictures.push_back(std::move(*curve));
  return pictures;
}

}  // namespace tribolog::report::document
