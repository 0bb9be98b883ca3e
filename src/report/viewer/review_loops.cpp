// Loops of the oscillations, their points and their mid-line.

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "figures/estimator_style.h"
#include "figures/report_figure.h"
#include "joint/degrees.h"
#include "report/elements/elements.h"
#include "report/elements/kept_samples.h"
#include "report/elements/loop_points_table.h"
#include "report/elements/result_words.h"
#include "report/viewer/review_json.h"
#include "report/viewer/review_parts.h"
#include "wording/rounding.h"
#include "wording/tr.h"

namespace tribolog::report::viewer {
namespace {

using wording::AxisScale;

constexpr std::size_t loops_at_full_length = 5;
constexpr std::size_t fewest_samples = 100;
constexpr std::size_t most_midline_points = 200;
constexpr double first_strokes = 1.25;  // periods; the readings A to F come from them

/// Lines of the loops: dark enough on white, and told apart by their dashes too.
Json loop_style(std::size_t k) {
  namespace colour = render::figure::palette;
  using render::figure::LineStyle;
  constexpr std::array colours{colour::blue, colour::vermilion, colour::green, colour::purple,
                               colour::grey};
  constexpr std::array lines{render::figure::LineStyle::solid, render::figure::LineStyle::dash,
                             render::figure::LineStyle::dash_dot, render::figure::LineStyle::dot,
                             render::figure::LineStyle::dash_dot_dot};
  // From the second round on each colour meets another dash.
  const std::size_t round = k / colours.size();
  return style(colours[k % colours.size()], lines[(k + round) % lines.size()]);
}

std::size_t samples_of_each(std::size_t loops) {
  const std::size_t share =
      loops_at_full_length * most_loop_samples / std::max<std::size_t>(loops, 1);
  return std::clamp(share, fewest_samples, most_loop_samples);
}

/// The fitted torque on the trace's samples; null: none.
const std::vector<double>* fitted_torque(const method::hysteresis::LoopTrace& trace) {
  return trace.model_torque_Nm.size() == trace.t_s.size() ? &trace.model_torque_Nm : nullptr;
}

/// Evenly spread samples over the whole trace, more closely over the first strokes: however noisy
/// the torque is, z and dz/dt stay round. The rest of the room is for what sticks out.
void add_even(const std::vector<double>& t, double first_strokes_s, std::size_t most,
              std::vector<std::size_t>& needed) {
  const auto add = [&](std::size_t size, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) needed.push_back(i * size / count);
  };
  const auto end = std::upper_bound(t.begin(), t.end(), t.front() + first_strokes_s) - t.begin();
  add(t.size(), most / 2);
  add(static_cast<std::size_t>(end), most / 4);
}

/// Samples around an instant.
void add_neighbours(const std::vector<double>& t, double at, std::vector<std::size_t>& needed) {
  if (!std::isfinite(at)) return;
  const auto after = static_cast<std::size_t>(std::upper_bound(t.begin(), t.end(), at) - t.begin());
  if (after > 0) needed.push_back(after - 1);
  if (after < t.size()) needed.push_back(after);
}

std::vector<std::size_t> every_so_many(std::size_t size, std::size_t most) {
  std::vector<std::size_t> kept;
  const std::size_t step = std::max<std::size_t>(1, (size + most - 1) / most);
  for (std::size_t i = 0; i < size; i += step) kept.push_back(i);
  if (size > 0 && kept.back() + 1 != size) kept.push_back(size - 1);
  return kept;
}

Json midline_curve(const method::hysteresis::LoopTrace& trace, const wording::AxisScale& angle,
                   const wording::AxisScale& torque) {
  if (trace.midline_q_rad.empty() || trace.midline_q_rad.size() != trace.midline_Nm.size()) {
    return nullptr;
  }
  const auto kept = every_so_many(trace.midline_q_rad.size(), most_midline_points);
  return {{"q", column(elements::picked(trace.midline_q_rad, kept), angle)},
          {"T", column(elements::picked(trace.midline_Nm, kept), torque)}};
}

double centre_of(const method::hysteresis::HysteresisResult& r, std::size_t k) {
  const double centre = k < r.oscillations.size() ? r.oscillations[k].centre_rad : r.midline_q_rad;
  return std::isfinite(centre) ? centre : 0.0;
}

Json loop(const calibration::Calibration& c, std::size_t k, const LoopScales& scales) {
  const method::hysteresis::HysteresisResult& r = c.hysteresis;
  const method::hysteresis::LoopTrace& trace = c.curves.loops[k];
  const std::size_t size = trace.t_s.size();
  wording::AxisScale angle = scales.angle;
  angle.offset = centre_of(r, k);
  struct Column {
    const char* name;
    const std::vector<double>* signal;
    const wording::AxisScale* scale;
  };
  std::vector<Column> columns{{"q", &trace.q_rad, &angle}, {"T", &trace.torque_Nm, &scales.torque}};
  if (!trace.z_rad.empty()) columns.push_back({"z", &trace.z_rad, &scales.deflection});
  if (!trace.dz_rad_s.empty()) columns.push_back({"dz", &trace.dz_rad_s, &scales.rate});
  const std::vector<double>* fit =
      r.bristle_source.is("loop.bristle_recorded") ? nullptr : fitted_torque(trace);
  if (fit != nullptr) columns.push_back({"fit", fit, &scales.torque});

  std::vector<const std::vector<double>*> signals;
  for (const Column& one : columns) signals.push_back(one.signal);
  std::vector<std::size_t> needed;
  if (k == 0) {
    for (const auto* points : {&r.points, &r.steady_points}) {
      for (const method::hysteresis::LoopPoint& p : *points)
        add_neighbours(trace.t_s, p.t_s, needed);
    }
  }
  const std::size_t most = samples_of_each(c.curves.loops.size());
  const double frequency = k < r.oscillations.size() ? r.oscillations[k].frequency_Hz : 0.0;
  if (size > most) {
    add_even(trace.t_s, frequency > 0.0 ? first_strokes / frequency : 0.0, most, needed);
  }
  const auto kept = elements::kept_samples(trace.t_s, signals, needed, most);
  const wording::AxisScale time{1.0, "s", trace.t_s.front()};

  Json out;
  out["name"] = shown_text(elements::log_name(trace.recording));
  out["style"] = loop_style(k);
  out["samples"] = size;
  out["t0_s"] = trace.t_s.front();
  out["centre_deg"] = angle.offset * joint::degrees_per_rad;
  out["frequency_Hz"] = nullptr;
  if (k < r.oscillations.size()) {
    if (frequency > 0.0) out["frequency_Hz"] = calibration::short_numbers({frequency}).front();
    out["amplitude"] = wording::with_unit(
        wording::significant(r.oscillations[k].amplitude_rad * angle.factor, 4), angle.unit);
  }
  const bool has_peak = c.q_peak_rad && std::isfinite(c.q_peak_rad->value);
  out["q_peak"] = has_peak ? entry(c.q_peak_rad->value, angle) : Json(nullptr);
  out["t"] = column(elements::picked(trace.t_s, kept), time);
  for (const Column& one : columns) {
    out[one.name] = column(elements::picked(*one.signal, kept), *one.scale);
  }
  out["midline"] = midline_curve(trace, angle, scales.torque);
  return out;
}

bool is_drawable(const method::hysteresis::LoopTrace& trace) {
  const std::size_t size = trace.t_s.size();
  const auto fits = [&](const std::vector<double>& signal) {
    return signal.empty() || signal.size() == size;
  };
  return size >= 2 && trace.q_rad.size() == size && trace.torque_Nm.size() == size &&
         fits(trace.z_rad) && fits(trace.dz_rad_s);
}

double largest_of(const std::vector<method::hysteresis::LoopTrace>& traces,
                  std::vector<double> method::hysteresis::LoopTrace::* signal) {
  wording::Extent all;
  for (const method::hysteresis::LoopTrace& trace : traces) all.add(trace.*signal);
  return all.largest();
}

/// The texts of the report's table of points, by the table's headings.
Json table_texts(const elements::Table& table, std::size_t row) {
  Json texts = Json::array();
  for (std::size_t i = 2; i < table.columns.size(); ++i) {
    const elements::Column& column = table.columns[i];
    const std::string& cell = table.rows[row].cells[i];
    if (cell != "–") texts.push_back({column.heading, wording::with_unit(cell, column.unit)});
  }
  return texts;
}

Json point_list(const std::vector<method::hysteresis::LoopPoint>& list,
                const calibration::Calibration& c, const LoopScales& scales) {
  const std::vector<method::hysteresis::LoopTrace>& traces = c.curves.loops;
  if (traces.empty() || !is_drawable(traces.front())) return Json::array();
  wording::AxisScale angle = scales.angle;
  angle.offset = centre_of(c.hysteresis, 0);
  const wording::AxisScale time{1.0, "s", traces.front().t_s.front()};
  const elements::Table table = elements::loop_points_table(list, "points", "points");
  Json out = Json::array();
  for (std::size_t i = 0; i < list.size(); ++i) {
    const method::hysteresis::LoopPoint& p = list[i];
    out.push_back({{"name", to_string(p.name)},
                   {"where", elements::meaning_of(p.name)},
                   {"t", entry(p.t_s, time)},
                   {"q", entry(p.q_rad, angle)},
                   {"T", entry(p.torque_Nm, scales.torque)},
                   {"z", entry(p.z_rad, scales.deflection)},
                   {"dz", entry(p.dz_rad_s, scales.rate)},
                   {"texts", table_texts(table, i)}});
  }
  return out;
}

}  // namespace

LoopScales loop_scales(const calibration::Calibration& c) {
  const std::vector<method::hysteresis::LoopTrace>& traces = c.curves.loops;
  double largest = 0.0;
  for (std::size_t k = 0; k < traces.size(); ++k) {
    for (const double q : traces[k].q_rad) {
      if (std::isfinite(q)) largest = std::max(largest, std::abs(q - centre_of(c.hysteresis, k)));
    }
  }
  return {wording::prefixed("rad", largest),
          wording::prefixed("N·m", largest_of(traces, &method::hysteresis::LoopTrace::torque_Nm)),
          wording::prefixed("rad", largest_of(traces, &method::hysteresis::LoopTrace::z_rad)),
          wording::prefixed("rad/s", largest_of(traces, &method::hysteresis::LoopTrace::dz_rad_s))};
}

void add_loop_quantities(const LoopScales& scales, bool from_first_sample, Json& quantities) {
  quantities["t"] =
      quantity(from_first_sample ? wording::tr("time from the first sample") : wording::tr("time"),
               from_first_sample ? "t − t₀" : "t", "s");
  quantities["q"] =
      quantity(wording::tr("joint angle from the loop's centre"), "q − q₀", scales.angle.unit);
  quantities["q"]["degrees"] = joint::degrees_per_rad / scales.angle.factor;
  quantities["T"] = quantity(wording::tr("driving torque"), "T", scales.torque.unit);
  quantities["z"] = quantity(wording::tr("bristle deflection"), "z", scales.deflection.unit);
  quantities["dz"] = quantity(wording::tr("bristle rate"), "dz/dt", scales.rate.unit);
}

Json loops(const calibration::Calibration& c, const LoopScales& scales) {
  Json list = Json::array();
  for (std::size_t k = 0; k < c.curves.loops.size(); ++k) {
    if (is_drawable(c.curves.loops[k])) list.push_back(loop(c, k, scales));
  }
  return list;
}

Json points(const calibration::Calibration& c, const LoopScales& scales) {
  return {{"first", point_list(c.hysteresis.points, c, scales)},
          {"steady", point_list(c.hysteresis.steady_points, c, scales)}};
}

Json midline(const method::hysteresis::HysteresisResult& r, const LoopScales& scales) {
  if (!r.midline_Nm) return nullptr;
  return {{"T", entry(r.midline_Nm->value, scales.torque)},
          {"text", wording::in_words(*r.midline_Nm, wording::torque_scale(r.midline_Nm->value))}};
}

}  // namespace tribolog::report::viewer
