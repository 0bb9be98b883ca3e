#include "figures/experiments/model_figures.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "simulate/model_portrait.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::figures::experiments {
namespace {

using wording::to_translate;
using wording::tr;

struct Portrait {
  const friction::FrictionModelEntry* entry;
  simulate::ModelPortrait curves;
};

std::string title_of(const friction::FrictionModelEntry& entry) {
  return wording::words_for("friction_model", entry.name);
}

/// One experiment: which curve, how it is drawn, and what its numbers say.
struct Sitting {
  const char* id;
  const char* title;
  const char* explanation;
  const char* x_title;
  double x_factor;  ///< From SI to the axis' unit.
  simulate::PortraitCurve simulate::ModelPortrait::* curve;
  std::string (*caption)(const simulate::ModelPortrait&);
  std::vector<double> arrows;
};

render::figure::Series series_of(const simulate::PortraitCurve& curve, double x_factor,
                                 const std::string& label) {
  render::figure::Series out;
  out.label = label;
  out.y = curve.torque_Nm;
  out.x.reserve(curve.x.size());
  for (const double x : curve.x) out.x.push_back(x * x_factor);
  return out;
}

struct Range {
  double low{0};
  double high{0};
  void add(const std::vector<double>& values) {
    for (const double v : values) {
      if (!std::isfinite(v)) continue;
      low = std::min(low, v);
      high = std::max(high, v);
    }
  }
  void set(render::figure::Axis& axis) const {
    constexpr double margin = 0.06;
    axis.minimum = low - margin * (high - low) * (low < 0 ? 1 : 0);
    axis.maximum = high + margin * (high - low);
  }
};

ReportFigure chart(const Portrait& portrait, const Portrait& lugre, const Sitting& sitting,
                   const Range& x, const Range& y) {
  const friction::FrictionModelEntry& entry = *portrait.entry;
  ReportFigure out;
  out.id = fmt::format("{}-{}", sitting.id, entry.name);
  std::replace(out.id.begin(), out.id.end(), '_', '-');
  out.title = title_of(entry);
  out.caption = sitting.caption(portrait.curves);
  out.alt =
      tr("{experiment} of {model}: {result}",
         {{"experiment", tr(sitting.title)}, {"model", title_of(entry)}, {"result", out.caption}});
  out.figure.id = out.id;
  out.figure.title = title_of(entry);
  out.figure.width_px = 1280;
  out.figure.height_px = 820;
  render::figure::Panel panel;
  panel.x.title = tr(sitting.x_title);
  panel.y.title = tr("friction T_{{f}} [N]");
  x.set(panel.x);
  y.set(panel.y);
  render::figure::Series own =
      series_of(portrait.curves.*sitting.curve, sitting.x_factor, title_of(entry));
  own.colour = render::figure::palette::blue;
  own.width_px = 4.0;
  own.direction_arrows_at = sitting.arrows;
  panel.series.push_back(std::move(own));
  if (portrait.entry != lugre.entry) {  // over it, in dashes: where they agree, both are seen
    render::figure::Series other =
        series_of(lugre.curves.*sitting.curve, sitting.x_factor, title_of(*lugre.entry));
    other.colour = render::figure::palette::black;
    other.style = render::figure::LineStyle::dash;
    other.width_px = 1.5;
    panel.series.push_back(std::move(other));
  }
  out.figure.panels.push_back(std::move(panel));
  return out;
}

/// "+0.0585", "−0.0493", "0.0000"
std::string signed_text(double value) {
  constexpr double half_of_last_place = 5e-5;
  if (std::abs(value) < half_of_last_place) return fmt::format("{:.4f}", 0.0);
  return (value < 0 ? "−" : "+") + fmt::format("{:.4f}", std::abs(value));
}

std::string break_away_words(const simulate::ModelPortrait& p) {
  return tr("largest {largest_force_N:.3f} N, then {sliding_force_N:.3f} N in sliding.",
            {{"largest_force_N", p.largest_Nm}, {"sliding_force_N", p.sliding_Nm}});
}

std::string static_words(const simulate::ModelPortrait& p) {
  const auto& torque = p.steady.torque_Nm;
  return tr("{force_at_rest_N:.3f} N close to rest, {force_N:.3f} N at five Stribeck velocities.",
            {{"force_at_rest_N", torque[torque.size() / 2]}, {"force_N", torque.back()}});
}

std::string loop_words(const simulate::ModelPortrait& p) {
  return tr("torque where a small inner loop closes: {gap_N} N away from where it began.",
            {{"gap_N", signed_text(p.inner_loop_gap_Nm)}});
}

std::string lag_words(const simulate::ModelPortrait& p) {
  return tr("at rising speed {difference_N} N more than at falling speed, on average.",
            {{"difference_N", signed_text(p.lag_Nm)}});
}

std::vector<Sitting> sittings() {
  return {
      {"static-curve",
       to_translate("Static curve"),
       to_translate(
           "Friction in steady sliding at each speed. The Stribeck effect is the fall from rest."),
       to_translate("speed [mm/s]"),
       1e3,
       &simulate::ModelPortrait::steady,
       static_words,
       {}},
      {"presliding-loop",
       to_translate("Pre-sliding loop"),
       to_translate(
           "A slow stroke of one and a half elastic deflections with a third harmonic, so that it "
           "turns back within itself; two periods from rest. With non-local memory an inner loop "
           "closes where it was left, and the outer curve continues as if nothing had happened."),
       to_translate("displacement [µm]"),
       1e6,
       &simulate::ModelPortrait::loop,
       loop_words,
       {0.55, 0.7, 0.85}},
      {"lag-loop",
       to_translate("Frictional lag"),
       to_translate(
           "Speed going up and down at 20 Hz between 0.3 and 2.1 Stribeck velocities, always "
           "forward. Friction that lags is larger at rising speed."),
       to_translate("speed [mm/s]"),
       1e3,
       &simulate::ModelPortrait::lag,
       lag_words,
       {0.25, 0.75}},
      {"break-away",
       to_translate("Break-away"),
       to_translate("Pushed from rest at a hundredth of the Stribeck velocity. The peak, if there "
                    "is one, is the break-away force."),
       to_translate("displacement [µm]"),
       1e6,
       &simulate::ModelPortrait::break_away,
       break_away_words,
       {}}};
}

}  // namespace

std::vector<ModelExperiment> model_experiments(const friction::ContactParameters& contact) {
  std::vector<Portrait> portraits;
  for (const friction::FrictionModelEntry& entry : friction::dynamic_friction_models()) {
    portraits.push_back({&entry, simulate::portrait_of(entry, contact)});
  }
  const auto lugre = std::find_if(portraits.begin(), portraits.end(),
                                  [](const Portrait& p) { return p.entry->name == "lugre"; });
  std::vector<ModelExperiment> out;
  for (const Sitting& sitting : sittings()) {
    Range x;
    Range y;
    for (const Portrait& one : portraits) {
      const simulate::PortraitCurve& curve = one.curves.*sitting.curve;
      std::vector<double> scaled = curve.x;
      for (double& value : scaled) value *= sitting.x_factor;
      x.add(scaled);
      y.add(curve.torque_Nm);
    }
    ModelExperiment experiment{sitting.id, tr(sitting.title), tr(sitting.explanation), {}};
    for (const Portrait& one : portraits) {
      experiment.figures.push_back(chart(one, *lugre, sitting, x, y));
    }
    out.push_back(std::move(experiment));
  }
  return out;
}

}  // namespace tribolog::figures::experiments
