// The archived loops and friction curves of two calibrations, for the viewer to lay over each
// other.

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <vector>

#include "joint/degrees.h"
#include "report/viewer/review_json.h"
#include "report/viewer/review_parts.h"
#include "wording/number_text.h"
#include "wording/rounding.h"
#include "wording/tr.h"

namespace tribolog::report::viewer {
namespace {

using calibration::RecordedCurves;
using calibration::RecordedFriction;
using calibration::RecordedLoop;
using wording::tr;

constexpr double whole_turn_deg = 360;

/// As in the figures of a comparison.
Json style_of(bool is_first) {
  namespace colour = render::figure::palette;
  using render::figure::LineStyle;
  return is_first ? style(colour::blue, LineStyle::solid)
                  : style(colour::vermilion, LineStyle::dash);
}

/// Loops from different starts begin alike, at the largest angle, and end where they began.
std::vector<double> from_largest_angle(const RecordedLoop& loop,
                                       const std::vector<double>& signal) {
  const auto start = std::max_element(loop.from_centre_rad.begin(), loop.from_centre_rad.end()) -
                     loop.from_centre_rad.begin();
  std::vector<double> turned(signal.begin() + start, signal.end());
  turned.insert(turned.end(), signal.begin(), signal.begin() + start + 1);
  return turned;
}

/// "A: 2026-01-31"
std::string label_of(const char* letter, const std::string& date) {
  return tr("{letter}: {date}", {{"letter", letter}, {"date", date}});
}

/// Of several loops "A 2: 2026-01-31, ± 100 µrad"
std::string label_of(const char* letter, std::size_t k, std::size_t loops, const std::string& date,
                     const std::string& amplitude) {
  if (loops == 1) return label_of(letter, date);
  return tr("{letter} {number}: {date}, ± {amplitude}",
            {{"letter", letter}, {"number", k + 1}, {"date", date}, {"amplitude", amplitude}});
}

const char* letter_of(bool is_first) { return is_first ? "A" : "B"; }

void add_loops(const std::vector<RecordedLoop>& loops, bool is_first, const std::string& date,
               const wording::AxisScale& angle, const wording::AxisScale& torque, Json& list) {
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const RecordedLoop& loop = loops[k];
    const auto [low, high] =
        std::minmax_element(loop.from_centre_rad.begin(), loop.from_centre_rad.end());
    constexpr int digits = 3;
    const std::string amplitude = wording::with_unit(
        wording::significant((*high - *low) / 2 * angle.factor, digits), angle.unit);
    std::vector<double> phase;
    const std::size_t size = loop.from_centre_rad.size();
    for (std::size_t i = 0; i <= size; ++i) {
      phase.push_back(whole_turn_deg * static_cast<double>(i) / static_cast<double>(size));
    }
    const std::string label = label_of(letter_of(is_first), k, loops.size(), date, amplitude);
    list.push_back({{"name", shown_text(label)},
                    {"label", shown_text(label)},
                    {"shown", k == 0},
                    {"style", style_of(is_first)},
                    {"samples", size},
                    {"t0_s", 0.0},
                    {"centre_deg", loop.centre_rad * joint::degrees_per_rad},
                    {"frequency_Hz", 1 / whole_turn_deg},
                    {"q_peak", nullptr},
                    {"t", calibration::short_numbers(phase)},
                    {"q", column(from_largest_angle(loop, loop.from_centre_rad), angle)},
                    {"T", column(from_largest_angle(loop, loop.torque_Nm), torque)},
                    {"midline", nullptr}});
  }
}

std::vector<std::size_t> by_speed(const RecordedFriction& friction) {
  std::vector<std::size_t> order(friction.speed_rad_s.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return friction.speed_rad_s[a] < friction.speed_rad_s[b];
  });
  return order;
}

/// The points of all curves behind each other.
struct CurvePoints {
  std::vector<double> speed_rad_s, friction_Nm, half_width_Nm;
  Json texts = Json::array();
  Json names = Json::array();
  Json curves = Json::array();

  void add(const RecordedFriction& friction, bool is_first, const std::string& date) {
    const std::string label = label_of(letter_of(is_first), date);
    const std::size_t from = speed_rad_s.size();
    for (const std::size_t i : by_speed(friction)) {
      speed_rad_s.push_back(friction.speed_rad_s[i]);
      friction_Nm.push_back(friction.friction_Nm[i]);
      half_width_Nm.push_back(friction.half_width_Nm[i]);
      texts.push_back(wording::in_words(
          statistics::symmetric_estimate(friction.friction_Nm[i], friction.half_width_Nm[i]),
          wording::plain_scale("N·m")));
      names.push_back(shown_text(label));
    }
    curves.push_back({{"label", shown_text(label)},
                      {"style", style_of(is_first)},
                      {"from", from},
                      {"to", speed_rad_s.size()}});
  }
};

void add_friction(const history::Comparison& comparison, const RecordedFriction& first,
                  const RecordedFriction& second, Json& quantities, Json& all) {
  CurvePoints points;
  points.add(first, true, wording::date_of(comparison.first.facts.measured_at));
  points.add(second, false, wording::date_of(comparison.second.facts.measured_at));
  const wording::AxisScale torque =
      wording::prefixed("N·m", wording::extent_of(points.friction_Nm).largest());
  quantities["w"] = quantity(tr("motor speed"), "dφ/dt", "rad/s");
  quantities["f"] = quantity(tr("friction torque"), "Tf", torque.unit);
  all["runs"] = {{"from_sweep", first.from_sweep && second.from_sweep},
                 {"w", column(points.speed_rad_s, {1.0, ""})},
                 {"value", column(points.friction_Nm, torque)},
                 {"half", column(points.half_width_Nm, torque)},
                 {"value_texts", std::move(points.texts)},
                 {"names", std::move(points.names)}};
  all["curves"] = std::move(points.curves);
}

LoopScales scales_of(const RecordedCurves& first, const RecordedCurves& second) {
  wording::Extent angles;
  wording::Extent torques;
  for (const RecordedCurves* curves : {&first, &second}) {
    for (const RecordedLoop& loop : curves->loops) {
      angles.add(loop.from_centre_rad);
      torques.add(loop.torque_Nm);
    }
  }
  return {wording::prefixed("rad", angles.largest()),
          wording::prefixed("N·m", torques.largest()),
          {},
          {}};
}

}  // namespace

Json earlier_curves(const RecordedCurves& curves, const std::string& date, const LoopScales& scales,
                    const wording::AxisScale& friction) {
  Json list = Json::array();
  for (const RecordedLoop& loop : curves.loops) {
    list.push_back({{"q", column(from_largest_angle(loop, loop.from_centre_rad), scales.angle)},
                    {"T", column(from_largest_angle(loop, loop.torque_Nm), scales.torque)}});
  }
  std::vector<double> speed_rad_s;
  std::vector<double> friction_Nm;
  for (const std::size_t i : by_speed(curves.friction)) {
    speed_rad_s.push_back(curves.friction.speed_rad_s[i]);
    friction_Nm.push_back(curves.friction.friction_Nm[i]);
  }
  return {{"words", shown_text(tr("calibration of {date}", {{"date", date}}))},
          {"style", style(render::figure::palette::green, render::figure::LineStyle::dash)},
          {"loops", std::move(list)},
          {"w", column(speed_rad_s, {1.0, ""})},
          {"f", column(friction_Nm, friction)}};
}

std::string compared_curves_json(const history::Comparison& comparison, const RecordedCurves& first,
                                 const RecordedCurves& second) {
  const bool has_loops = !first.loops.empty() && !second.loops.empty();
  const bool has_friction =
      !first.friction.speed_rad_s.empty() && !second.friction.speed_rad_s.empty();
  if (!has_loops && !has_friction) return {};
  Json all;
  Json quantities = Json::object();
  Json list = Json::array();
  all["schema"] = "tribolog-loops-1";
  all["bristle"] = nullptr;
  all["runs"] = nullptr;
  if (has_loops) {
    const LoopScales scales = scales_of(first, second);
    add_loop_quantities(scales, false, quantities);
    quantities["t"] = quantity(tr("phase from the largest angle"), "", "°");
    const auto add = [&](const RecordedCurves& curves, const calibration::Entry& of,
                         bool is_first) {
      add_loops(curves.loops, is_first, wording::date_of(of.facts.measured_at), scales.angle,
                scales.torque, list);
    };
    add(first, comparison.first, true);
    add(second, comparison.second, false);
  }
  if (has_friction) add_friction(comparison, first.friction, second.friction, quantities, all);
  all["quantities"] = std::move(quantities);
  all["fit_style"] = style(render::figure::palette::purple, render::figure::LineStyle::dash);
  all["points"] = {{"first", Json::array()}, {"steady", Json::array()}};
  all["midline"] = nullptr;
  all["loops"] = std::move(list);
  all["candidates"] = Json::array();
  if (Json says = script_texts(); !says.empty()) all["says"] = std::move(says);
  return review_text(all);
}

}  // namespace tribolog::report::viewer
