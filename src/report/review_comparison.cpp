// The archived loops of two calibrations, for the viewer to lay over each other.

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

#include "joint/degrees.h"
#include "report/review_json.h"
#include "report/review_parts.h"
#include "wording/rounding.h"
#include "wording/tr.h"

namespace tribolog::report {
namespace {

using calibration::RecordedCurves;
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

/// "A: 2026-01-31", of several "A 2: 2026-01-31, ± 100 µrad"
std::string label_of(const char* letter, std::size_t k, std::size_t loops, const std::string& date,
                     const std::string& amplitude) {
  if (loops == 1) return tr("{letter}: {date}", {{"letter", letter}, {"date", date}});
  return tr("{letter} {number}: {date}, ± {amplitude}",
            {{"letter", letter}, {"number", k + 1}, {"date", date}, {"amplitude", amplitude}});
}

void add_loops(const std::vector<RecordedLoop>& loops, bool is_first, const std::string& date,
               const wording::AxisScale& angle, const wording::AxisScale& torque, Json& list) {
  const char* const letter = is_first ? "A" : "B";
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
    const std::string label = label_of(letter, k, loops.size(), date, amplitude);
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

std::string date_of(const calibration::Entry& entry) {
  return entry.facts.measured_at.substr(0, std::string("2026-01-31").size());
}

}  // namespace

std::string compared_loops_json(const history::Comparison& comparison, const RecordedCurves& first,
                                const RecordedCurves& second) {
  if (first.loops.empty() || second.loops.empty()) return {};
  wording::Extent angles;
  wording::Extent torques;
  for (const RecordedCurves* curves : {&first, &second}) {
    for (const RecordedLoop& loop : curves->loops) {
      angles.add(loop.from_centre_rad);
      torques.add(loop.torque_Nm);
    }
  }
  const LoopScales scales{wording::prefixed("rad", angles.largest()),
                          wording::prefixed("N·m", torques.largest()),
                          {},
                          {}};
  Json quantities;
  add_loop_quantities(scales, false, quantities);
  quantities["t"] = quantity(tr("phase from the largest angle"), "", "°");
  Json list = Json::array();
  add_loops(first.loops, true, date_of(comparison.first), scales.angle, scales.torque, list);
  add_loops(second.loops, false, date_of(comparison.second), scales.angle, scales.torque, list);
  Json all;
  all["schema"] = "tribolog-loops-1";
  all["bristle"] = nullptr;
  all["quantities"] = std::move(quantities);
  all["fit_style"] = style(render::figure::palette::purple, render::figure::LineStyle::dash);
  all["points"] = {{"first", Json::array()}, {"steady", Json::array()}};
  all["midline"] = nullptr;
  all["loops"] = std::move(list);
  all["runs"] = nullptr;
  all["candidates"] = Json::array();
  if (Json says = script_texts(); !says.empty()) all["says"] = std::move(says);
  return review_text(all);
}

}  // namespace tribolog::report
