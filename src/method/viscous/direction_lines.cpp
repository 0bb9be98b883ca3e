#include "method/viscous/direction_lines.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "method/hysteresis/surrogate_masses.h"
#include "statistics/block_regression.h"
#include "statistics/distributions.h"

namespace tribolog::method::viscous {

namespace {

constexpr double least_travel_share = 0.25;
constexpr std::size_t fewest_runs = 4;

/// One run, of one plateau or of several.
struct Point {
  std::string recording;
  double speed_rad_s, friction_Nm, samples, lowest_rad, highest_rad;
  [[nodiscard]] double travel_rad() const { return highest_rad - lowest_rad; }
};

void merge(const ConstantSpeedRun& run, double friction, Point& p) {
  const auto n = static_cast<double>(run.samples);
  const double all = p.samples + n;
  p.speed_rad_s = (p.speed_rad_s * p.samples + std::abs(run.speed_rad_s) * n) / all;
  p.friction_Nm = (p.friction_Nm * p.samples + friction * n) / all;
  p.samples = all;
  p.lowest_rad = std::min(p.lowest_rad, run.lowest_rad);
  p.highest_rad = std::max(p.highest_rad, run.highest_rad);
}

std::vector<Point> points_of(const ViscousCurvesResult& curves, const ViscousCurve& curve,
                             double sign) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < curves.runs.size(); ++i) {
    const ConstantSpeedRun& run = curves.runs[i];
    if (run.speed_rad_s * sign <= 0) continue;
    const double speed = std::abs(run.speed_rad_s);
    const double friction = sign * curve.friction_Nm[i];
    const auto same = std::find_if(points.begin(), points.end(), [&](const Point& p) {
      return !curves.from_sweep && p.recording == run.recording &&
             std::abs(p.speed_rad_s - speed) <= same_speed * speed;
    });
    if (same != points.end()) {
      merge(run, friction, *same);
    } else {
      points.push_back({run.recording, speed, friction, static_cast<double>(run.samples),
                        run.lowest_rad, run.highest_rad});
    }
  }
  return points;
}

void keep_long_ways(std::vector<Point>& points, double widest) {
  const auto is_short = [&](const Point& p) {
    return p.travel_rad() < least_travel_share * widest;
  };
  const auto kept =
      std::count_if(points.begin(), points.end(), [&](const Point& p) { return !is_short(p); });
  if (static_cast<std::size_t>(kept) < fewest_runs) return;
  points.erase(std::remove_if(points.begin(), points.end(), is_short), points.end());
}

statistics::BlockRegression line_through(const std::vector<Point>& points, std::size_t first) {
  const auto n = static_cast<Eigen::Index>(points.size() - first);
  Eigen::MatrixXd x(n, 2);
  Eigen::VectorXd y(n);
  std::vector<std::size_t> blocks;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Point& p = points[first + static_cast<std::size_t>(i)];
    x.row(i) << 1, p.speed_rad_s;
    y(i) = p.friction_Nm;
    blocks.push_back(static_cast<std::size_t>(i));
  }
  return statistics::block_regression(x, y, blocks);
}

/// First run beyond the Stribeck dip. There is a dip where the slowest run lies above the line
/// through the runs from the least friction on by more than their scatter allows; friction that
/// falls throughout has none.
std::size_t first_beyond_dip(const std::vector<Point>& points) {
  const auto least = std::min_element(
      points.begin(), points.end(),
      [](const Point& a, const Point& b) { return a.friction_Nm < b.friction_Nm; });
  const auto dip = static_cast<std::size_t>(least - points.begin());
  if (dip == 0 || dip > points.size() / 2 || points.size() - dip < fewest_runs) return 0;
  const statistics::BlockRegression line = line_through(points, dip);
  const double there = line.coefficients(0) + line.coefficients(1) * points.front().speed_rad_s;
  const double above = points.front().friction_Nm - there;
  return above > statistics::student_t_975(static_cast<double>(points.size() - dip - 2)) *
                     line.residual_sd
             ? dip
             : 0;
}

std::optional<DirectionLine> fit_line(std::vector<Point> points, double widest, bool may_dip) {
  const std::size_t all = points.size();
  keep_long_ways(points, widest);
  std::sort(points.begin(), points.end(),
            [](const Point& a, const Point& b) { return a.speed_rad_s < b.speed_rad_s; });
  if (points.size() < fewest_runs) return std::nullopt;
  if (may_dip) {
    points.erase(points.begin(),
                 points.begin() + static_cast<std::ptrdiff_t>(first_beyond_dip(points)));
  }
  const statistics::BlockRegression fit = line_through(points, 0);
  const auto estimate = [&](int k) {
    return statistics::symmetric_estimate(fit.coefficients(k), fit.half_width(k),
                                          {"interval.line_of_direction"});
  };
  return DirectionLine{estimate(0),
                       estimate(1),
                       fit.residual_sd,
                       points.front().speed_rad_s,
                       points.back().speed_rad_s,
                       points.size(),
                       all - points.size()};
}

}  // namespace

const CurveDirectionLines* DirectionLinesResult::find(
    std::optional<hysteresis::Estimator> estimator) const {
  const auto it = std::find_if(curves.begin(), curves.end(), [&](const CurveDirectionLines& c) {
    return c.estimator == estimator;
  });
  return it == curves.end() ? nullptr : &*it;
}

DirectionLinesResult fit_direction_lines(const ViscousCurvesResult& curves,
                                         std::optional<hysteresis::Estimator> recommended) {
  DirectionLinesResult out;
  std::vector<hysteresis::Estimator> wanted;
  if (recommended) wanted.push_back(*recommended);
  if (recommended != hysteresis::Estimator::stated) {
    wanted.push_back(hysteresis::Estimator::stated);
  }
  for (const hysteresis::Estimator estimator : wanted) {
    const ViscousCurve* curve = curves.find(estimator);
    if (curve == nullptr) continue;
    const std::vector<Point> rising = points_of(curves, *curve, 1);
    const std::vector<Point> falling = points_of(curves, *curve, -1);
    double widest = 0;
    for (const auto* points : {&rising, &falling}) {
      for (const Point& p : *points) widest = std::max(widest, p.travel_rad());
    }
    const bool may_dip = !curves.from_sweep;
    out.curves.push_back(
        {estimator, fit_line(rising, widest, may_dip), fit_line(falling, widest, may_dip)});
  }
  return out;
}

namespace {

constexpr std::size_t fewest_pairs = 3;

}  // namespace

DirectionAsymmetryResult identify_direction_asymmetry(const ViscousCurvesResult& curves,
                                                      const hysteresis::SurrogateMass* mass,
                                                      double sweep_offset_Nm) {
  DirectionAsymmetryResult out;
  if (curves.from_sweep) {
    out.sentence = {"direction_asymmetry.offset_of_sweep", {{"offset_Nm", sweep_offset_Nm}}};
    return out;
  }
  double sum = 0;
  double cosines = 0;
  for (const ConstantSpeedRun& run : curves.runs) {
    if (mass == nullptr || run.speed_rad_s < 0 || run.partner < 0 ||
        !std::isfinite(run.direction_mean_Nm)) {
      continue;
    }
    out.speed_rad_s.push_back(run.speed_rad_s);
    out.asymmetry_Nm.push_back(run.direction_mean_Nm -
                               mass->gravity_Nm.value * run.direction_mean_cos);
    sum += out.asymmetry_Nm.back();
    cosines += run.direction_mean_cos;
  }
  const auto n = static_cast<double>(out.speed_rad_s.size());
  if (out.speed_rad_s.size() < fewest_pairs) {
    out.sentence = {"direction_asymmetry.too_few_pairs"};
    return out;
  }
  double squares = 0;
  for (const double a : out.asymmetry_Nm) squares += std::pow(a - sum / n, 2);
  out.mean_Nm = statistics::symmetric_estimate(
      sum / n, statistics::student_t_975(n - 1) * std::sqrt(squares / (n - 1) / n),
      {"interval.scatter_of_pairs"});
  out.gravity_could_explain_Nm = std::abs(mass->gravity_Nm.half_width() * cosines / n);
  out.examined = true;
  const double size = std::abs(out.mean_Nm.value);
  // The computer's own rounding is no asymmetry.
  constexpr double rounding = 1e-6;
  const double explained = std::hypot(out.mean_Nm.half_width(), out.gravity_could_explain_Nm);
  out.found = size > explained && size > rounding * mass->gravity_Nm.value;
  const bool is_without_gravity = mass->gravity_Nm.value == 0 && out.gravity_could_explain_Nm == 0;
  if (is_without_gravity) {
    out.sentence = {
        out.found ? Code{"direction_asymmetry.found_without_gravity"}
                  : Code{"direction_asymmetry.does_not_show_without_gravity"},
        {{"half_difference_Nm", out.mean_Nm.value}, {"half_width_Nm", out.mean_Nm.half_width()}}};
  } else {
    out.sentence = {
        out.found ? Code{"direction_asymmetry.found"} : Code{"direction_asymmetry.does_not_show"},
        {{"half_difference_Nm", out.mean_Nm.value},
         {"half_width_Nm", out.mean_Nm.half_width()},
         {"gravity_error_Nm", out.gravity_could_explain_Nm}}};
  }
  return out;
}

}  // namespace tribolog::method::viscous
