#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "figures/report_figure.h"
#include "paper/charts/paper_charts.h"
#include "paper/drawings/printed_paper.h"
#include "wording/axis_scale.h"
#include "wording/number_text.h"
#include "wording/tr.h"

namespace tribolog::paper::charts {
namespace {

using wording::AxisScale;
using wording::listed;
using wording::prefixed;
using wording::significant;
using wording::tr;
using wording::tr_count;
using wording::with_unit;

constexpr int head_px = 120;
constexpr int panel_px = 560;

std::string length_text(double length_m) {
  return wording::with_unit(length_m, wording::prefixed("m", length_m), 3);
}

std::string length_4(double length_m) { return with_unit(length_m, prefixed("m", length_m), 4); }

std::string force_text(const simulate::PreslidingLoop& loop) {
  return tr("{force_amplitude_N} N at {frequency_Hz} Hz",
            {{"force_amplitude_N", loop.amplitude_N}, {"frequency_Hz", loop.frequency_Hz}});
}

render::figure::Panel panel_of(const simulate::PreslidingLoop& loop, double largest_N) {
  constexpr double margin = 1.15;
  const wording::AxisScale lengths = wording::prefixed("m", loop.width_m / 2);
  render::figure::Panel panel;
  panel.title = tr("{force}: {loop_width} wide, up to {largest_speed_mm_s} mm/s",
                   {{"force", force_text(loop)},
                    {"loop_width", length_text(loop.width_m)},
                    {"largest_speed_mm_s", wording::significant(loop.largest_speed_m_s * 1e3, 3)}});
  panel.x.title = wording::axis_title(tr("displacement x"), lengths);
  panel.y.title = tr("force [N]");
  panel.y.minimum = -margin * largest_N;
  panel.y.maximum = margin * largest_N;
  const std::vector<double> x = figures::shown(loop.cycle.angle_rad, lengths);
  panel.series.push_back(figures::line(tr("applied force"), x, loop.cycle.applied_Nm,
                                       render::figure::palette::grey, 1.5,
                                       render::figure::LineStyle::dash));
  render::figure::Series friction = figures::line(tr("friction T_{{f}}"), x, loop.cycle.friction_Nm,
                                                  render::figure::palette::blue, 3.5);
  friction.direction_arrows_at = {0.1, 0.35, 0.6, 0.85};
  panel.series.push_back(std::move(friction));
  return panel;
}

template <class Loop, class Text>
std::string for_each_loop(const std::vector<Loop>& loops, const Text& text) {
  std::vector<std::string> words;
  for (const Loop& loop : loops) words.push_back(text(loop));
  return wording::listed(words);
}

/// Whether the loops are what the paper calls them.
std::string regime_sentence(const std::vector<simulate::PreslidingLoop>& loops) {
  const std::string speeds = for_each_loop(loops, [](const simulate::PreslidingLoop& loop) {
    return wording::significant(loop.largest_speed_m_s / loop.stribeck_speed_m_s, 2);
  });
  const auto holding =
      std::count_if(loops.begin(), loops.end(), [](const simulate::PreslidingLoop& loop) {
        return loop.largest_speed_m_s <= loop.stribeck_speed_m_s;
      });
  const auto all = static_cast<std::ptrdiff_t>(loops.size());
  if (holding == all) {
    return tr("Speeds reach {speeds} times the Stribeck velocity: the loops are pure pre-sliding.",
              {{"speeds", speeds}});
  }
  if (holding == 0) {
    return tr(
        "Speeds reach {speeds} times the Stribeck velocity: none of the loops is pure "
        "pre-sliding.",
        {{"speeds", speeds}});
  }
  return tr_count(holding,
                  "Speeds reach {speeds} times the Stribeck velocity: {presliding_loops} of the "
                  "{loops} loops is pure pre-sliding.",
                  "Speeds reach {speeds} times the Stribeck velocity: {presliding_loops} of the "
                  "{loops} loops are pure pre-sliding.",
                  {{"speeds", speeds}, {"presliding_loops", holding}, {"loops", all}});
}

std::string caption(const PreslidingLoops& all) {
  const std::vector<simulate::PreslidingLoop>& loops = all.by_force;
  const std::string travels = for_each_loop(
      all.by_friction, [](const simulate::PresetLoop& loop) { return length_4(loop.travel_m); });
  const std::string widths = for_each_loop(loops, [](const simulate::PreslidingLoop& loop) {
    return length_text(loop.width_m) + " (" + force_text(loop) + ")";
  });
  const std::string limits = for_each_loop(loops, [](const simulate::PreslidingLoop& loop) {
    return tr("{force_amplitude_N} N at {frequency_Hz} Hz",
              {{"force_amplitude_N", wording::significant(loop.largest_presliding_N, 3)},
               {"frequency_Hz", loop.frequency_Hz}});
  });
  return tr("LuGre friction, Table 1 as meant. Above: friction of the printed amplitudes over "
            "travels of {travels}, as in print on one pair of axes. Below: the force has these "
            "amplitudes, at the printed frequencies, and moves a unit mass; one period of the "
            "periodic motion. Widths are {loop_widths}.",
            {{"travels", travels}, {"loop_widths", widths}}) +
         " " + regime_sentence(loops) + " " +
         tr("Amplitudes up to {force_amplitudes} stay below that velocity.",
            {{"force_amplitudes", limits}});
}

std::string how_to_read(const std::vector<simulate::PreslidingLoop>& loops) {
  const std::string slow = for_each_loop(loops, [](const simulate::PreslidingLoop& loop) {
    return std::isfinite(loop.slow_width_m) ? length_text(loop.slow_width_m) : tr("no bound");
  });
  const std::string peaks = for_each_loop(loops, [](const simulate::PreslidingLoop& loop) {
    return wording::with_unit(loop.largest_friction_N, {1.0, "N"}, 4);
  });
  double gap = 0;
  double shift = 0;
  for (const simulate::PreslidingLoop& loop : loops) {
    gap = std::max(gap, loop.gap);
    shift = std::max(shift, loop.tolerance_shift);
  }
  return tr(
      "Note the displacement axes: each panel of a force has its own. After a reversal friction "
      "climbs while "
      "the bristles bend, which is pre-sliding; where it is level the mass slides, driven by the "
      "excess of the applied force (dashed) over friction. Friction peaks at {friction_peaks}; "
      "where the mass breaks away that is below the static force, the more so the faster the force "
      "rises. Forces of the same amplitudes but so slow that neither rate nor inertia matters "
      "would give widths of {slow_widths}. The loops close to {gap_millionths} millionths of their "
      "size, and halving the solver's tolerance moves them by at most {shift_millionths} "
      "millionths; a loop with a gap has not reached the periodic motion.",
      {{"friction_peaks", peaks},
       {"slow_widths", slow},
       {"gap_millionths", wording::significant(gap * 1e6, 1)},
       {"shift_millionths", wording::significant(shift * 1e6, 1)}});
}

std::string alt(const std::vector<simulate::PreslidingLoop>& loops) {
  const std::string each = for_each_loop(loops, [](const simulate::PreslidingLoop& loop) {
    return tr("{force} ({loop_width} wide, friction up to {largest_friction})",
              {{"force", force_text(loop)},
               {"loop_width", length_text(loop.width_m)},
               {"largest_friction", wording::with_unit(loop.largest_friction_N, {1.0, "N"}, 4)}});
  });
  return tr(
      "Closed loops of friction force against displacement, run through clockwise, one panel "
      "each: {loops}.",
      {{"loops", each}});
}

/// The loops as printed: one pair of axes, friction of the printed amplitudes.
render::figure::Panel common_panel(const std::vector<simulate::PresetLoop>& loops) {
  const AxisScale lengths = prefixed("m", loops.front().travel_m / 2);
  render::figure::Panel panel;
  panel.title = tr("Friction of the printed amplitudes, too slow for its rate to count");
  panel.x.title = wording::axis_title(tr("displacement x"), lengths);
  panel.y.title = tr("friction [N]");
  const render::figure::Colour colours[] = {render::figure::palette::blue,
                                            render::figure::palette::vermilion,
                                            render::figure::palette::green};
  const render::figure::LineStyle styles[] = {render::figure::LineStyle::solid,
                                              render::figure::LineStyle::dash,
                                              render::figure::LineStyle::dash_dot};
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const simulate::PresetLoop& loop = loops[i];
    render::figure::Series series =
        figures::line(tr("±{friction_N} N, travel {travel}",
                         {{"friction_N", significant(loop.largest_friction_N, 4)},
                          {"travel", length_4(loop.travel_m)}}),
                      figures::shown(loop.displacement_m, lengths), loop.friction_N,
                      colours[i % std::size(colours)], 3.0, styles[i % std::size(styles)]);
    series.direction_arrows_at = {0.1, 0.6};
    panel.series.push_back(std::move(series));
  }
  return panel;
}

/// Where print contradicts itself: the same motion at the printed frequencies.
std::string contradiction(const PreslidingLoops& loops) {
  const std::string asked =
      for_each_loop(loops.at_printed_rate, [](const simulate::PresetLoop& loop) {
        return tr("{friction_N} N at {frequency_Hz} Hz",
                  {{"friction_N", significant(loop.largest_friction_N, 4)},
                   {"frequency_Hz", loop.frequency_Hz}});
      });
  return tr(
      "Print gives these amplitudes to the friction, and frequencies with them. Both cannot "
      "hold with table 1: the same motion at those frequencies makes its rate count, and "
      "friction reaches only {frictions}.",
      {{"frictions", asked}});
}

}  // namespace

PreslidingLoops loops_of_figure_5(const friction::ContactParameters& contact) {
  constexpr double slow_Hz = 1e-4;  // damping then adds less than a ten-millionth of the force
  PreslidingLoops out;
  for (const drawings::Swing& swing : drawings::figure_5) {
    const double travel_m = drawings::presliding_travel_m(swing.amplitude_N);
    out.by_friction.push_back(simulate::preset_loop(contact, travel_m, slow_Hz));
    out.at_printed_rate.push_back(simulate::preset_loop(contact, travel_m, swing.frequency_Hz));
  }
  out.by_force = simulate::presliding_loops(contact);
  return out;
}

figures::ReportFigure presliding_hysteresis_figure(const PreslidingLoops& loops) {
  if (loops.by_force.empty() || loops.by_friction.empty()) {
    throw std::invalid_argument("there is no loop to draw");
  }
  figures::ReportFigure out;
  out.paper_number = 5;
  out.id = "fig-05-presliding-hysteresis";
  out.title = tr("Hysteresis of friction in pre-sliding");
  out.caption = caption(loops);
  out.how_to_read = contradiction(loops) + " " + how_to_read(loops.by_force);
  out.alt = alt(loops.by_force);
  out.figure.id = out.id;
  out.figure.title = out.title;
  out.figure.height_px = head_px + panel_px * static_cast<int>(loops.by_force.size() + 1);
  out.figure.panels.push_back(common_panel(loops.by_friction));
  double largest = 0;
  for (const simulate::PreslidingLoop& loop : loops.by_force) {
    largest = std::max({largest, loop.amplitude_N, loop.largest_friction_N});
  }
  for (const simulate::PreslidingLoop& loop : loops.by_force) {
    out.figure.panels.push_back(panel_of(loop, largest));
    out.figure.panels.back().show_legend = &loop == &loops.by_force.front();
  }
  return out;
}

}  // namespace tribolog::paper::charts
