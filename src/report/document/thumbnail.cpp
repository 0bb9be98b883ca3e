#include "report/document/thumbnail.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "report/elements/kept_samples.h"
#include "wording/rounding.h"
#include "wording/tr.h"

namespace tribolog::report::document {
namespace {

using wording::tr;

constexpr double frame_margin = 6;

struct Range {
  double low{std::numeric_limits<double>::infinity()};
  double high{-std::numeric_limits<double>::infinity()};

  void add(const std::vector<double>& values) {
    for (const double value : values) {
      if (!std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  [[nodiscard]] bool is_empty() const { return !(high > low); }
  [[nodiscard]] double share(double value) const {
    return std::clamp((value - low) / (high - low), 0.0, 1.0);
  }
};

struct Points {
  std::vector<double> x, y;
};

/// From values to pixels.
class Frame {
 public:
  Frame(const Range& x, const Range& y) : x_(x), y_(y) {}

  [[nodiscard]] double across(double value) const {
    return frame_margin + x_.share(value) * (thumbnail_width - 2 * frame_margin);
  }
  [[nodiscard]] double down(double value) const {
    return thumbnail_height - frame_margin -
           y_.share(value) * (thumbnail_height - 2 * frame_margin);
  }
  [[nodiscard]] std::string line(const Points& points) const {
    std::string path;
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      if (!std::isfinite(points.x[i]) || !std::isfinite(points.y[i])) continue;
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", across(points.x[i]),
                          down(points.y[i]));
    }
    return path;
  }
  /// A dot each, which the style makes round.
  [[nodiscard]] std::string dots(const Points& points) const {
    std::string path;
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      if (!std::isfinite(points.x[i]) || !std::isfinite(points.y[i])) continue;
      path += fmt::format("M{:.1f} {:.1f}h0", across(points.x[i]), down(points.y[i]));
    }
    return path;
  }
  [[nodiscard]] std::string zero() const {
    return fmt::format("M0 {:.1f}h{}", down(0), thumbnail_width);
  }

 private:
  Range x_, y_;
};

/// The other direction's, of a curve that is the same in both.
Points mirrored(Points points) {
  for (double& x : points.x) x = -x;
  for (double& y : points.y) y = -y;
  return points;
}

/// The likeliest law; empty where there is none.
Points likeliest_law(const method::model::ModelLaw& law) {
  constexpr int points = 100;
  if (law.empty()) return {};
  const std::vector<double> speeds = law.speeds_rad_s(points);
  return {speeds, law.friction_Nm(speeds)};
}

/// The curve over the speeds that were run; below them it is a guess.
Points from_slowest(const Points& fit, const std::vector<double>& runs) {
  double slowest = std::numeric_limits<double>::infinity();
  for (const double speed : runs) slowest = std::min(slowest, std::abs(speed));
  Points points;
  for (std::size_t i = 0; i < fit.x.size(); ++i) {
    if (fit.x[i] < slowest) continue;
    points.x.push_back(fit.x[i]);
    points.y.push_back(fit.y[i]);
  }
  return points;
}

std::string size_in_words(double size, const wording::Scale& scale) {
  constexpr int digits = 3;
  return wording::with_unit(wording::significant(size * scale.factor, digits), scale.unit);
}

}  // namespace

std::optional<Thumbnail> loop_thumbnail(const calibration::Calibration& c) {
  if (!c.hysteresis.found || c.curves.loops.empty()) return std::nullopt;
  const method::hysteresis::LoopTrace& trace = c.curves.loops.front();
  if (trace.t_s.empty()) return std::nullopt;
  const bool is_fitted = trace.model_torque_Nm.size() == trace.t_s.size();
  const double frequency =
      c.hysteresis.oscillations.empty() ? 0.0 : c.hysteresis.oscillations.front().frequency_Hz;
  Points measured;
  Points fitted;
  for (const std::size_t i : elements::last_cycles(trace.t_s, frequency, 2, 400)) {
    measured.x.push_back(trace.q_rad[i]);
    measured.y.push_back(trace.torque_Nm[i]);
    if (!is_fitted) continue;
    fitted.x.push_back(trace.q_rad[i]);
    fitted.y.push_back(trace.model_torque_Nm[i]);
  }
  Range x;
  Range y;
  x.add(measured.x);
  y.add(measured.y);
  y.add(fitted.y);
  if (x.is_empty() || y.is_empty()) return std::nullopt;
  const Frame frame(x, y);
  Thumbnail out;
  out.measured = frame.line(measured);
  out.fitted = frame.line(fitted);
  out.zero = frame.zero();
  out.across =
      tr("{angle} wide", {{"angle", size_in_words(x.high - x.low, wording::degree_scale())}});
  out.up = tr(
      "{torque} high",
      {{"torque", size_in_words(y.high - y.low, wording::quantity_scale("N·m", y.high - y.low))}});
  return out;
}

std::optional<Thumbnail> curve_thumbnail(const calibration::Calibration& c) {
  const method::viscous::ViscousCurve* curve = c.viscous.find(c.selection.recommended);
  if (curve == nullptr || curve->friction_Nm.size() != c.viscous.runs.size()) return std::nullopt;
  Points measured;
  for (const method::viscous::ConstantSpeedRun& run : c.viscous.runs) {
    measured.x.push_back(run.speed_rad_s);
  }
  measured.y = curve->friction_Nm;
  Range x;
  Range y;
  x.add(measured.x);
  y.add(measured.y);
  if (x.is_empty() || y.is_empty()) return std::nullopt;
  const double fastest = std::max(std::abs(x.low), std::abs(x.high));
  const double largest = std::max(std::abs(y.low), std::abs(y.high));
  const Frame frame(x, y);
  Thumbnail out;
  out.measured = frame.dots(measured);
  out.is_of_points = true;
  const Points forwards = from_slowest(likeliest_law(c.model.law), measured.x);
  out.fitted =
      (x.high > 0 ? frame.line(forwards) : "") + (x.low < 0 ? frame.line(mirrored(forwards)) : "");
  out.zero = frame.zero();
  out.across = tr("up to {speed}",
                  {{"speed", size_in_words(fastest, wording::quantity_scale("rad/s", fastest))}});
  out.up = tr("at most {torque}",
              {{"torque", size_in_words(largest, wording::quantity_scale("N·m", largest))}});
  return out;
}

}  // namespace tribolog::report::document
