#include "report/viewer/review_json.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/enum_text.h"
#include "base/shown_text.h"
#include "figures/estimator_style.h"
#include "figures/report_figure.h"
#include "figures/run_curves.h"
#include "report/elements/result_words.h"
#include "report/engine/page_style.h"
#include "report/viewer/review_parts.h"
#include "wording/labels.h"
#include "wording/number_text.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/translation.h"
#include "wording/visible_text.h"
#include "wording/words.h"

namespace tribolog::report::viewer {

Json script_texts() {
  Json says = Json::object();
  for (const std::string& message : engine::script_messages()) {
    std::string text = wording::translated(message);
    if (text != message) says[message] = std::move(text);
  }
  return says;
}

std::string review_text(const Json& all) {
  return json_without_hidden(all.dump(-1, ' ', false, Json::error_handler_t::replace));
}

wording::AxisScale friction_scale(const calibration::Calibration& c) {
  wording::Extent all;
  for (const method::viscous::ViscousCurve& curve : c.viscous.curves) all.add(curve.friction_Nm);
  return wording::prefixed("N·m", all.largest());
}

std::string review_json(const calibration::Calibration& c, const ReviewContext& context) {
  const method::hysteresis::HysteresisResult& h = c.hysteresis;
  const LoopScales scales = loop_scales(c);
  Json drawn = h.found ? loops(c, scales) : Json::array();
  const bool has_curves = !c.viscous.runs.empty() && !c.viscous.curves.empty();
  if (drawn.empty() && !has_curves) return {};

  Json all;
  all["schema"] = "tribolog-loops-1";
  if (!context.report.empty()) all["report"] = context.report;
  all["bristle"] = shown_text(wording::words(h.bristle_source));
  Json quantities;
  const bool from_first_sample =
      std::any_of(drawn.begin(), drawn.end(), [](const Json& loop) { return loop["t0_s"] != 0.0; });
  if (!drawn.empty()) {
    add_loop_quantities(scales, from_first_sample, quantities);
    // Work at the motor for a torque times an angle of the joint, in the units shown.
    if (c.manifest.torque_unit() == joint::TorqueUnit::newton_metre) {
      quantities["T"]["joules"] =
          std::abs(c.manifest.drive.gear_ratio()) / (scales.torque.factor * scales.angle.factor);
    }
  }
  if (has_curves) add_run_quantities(c, quantities);
  all["quantities"] = std::move(quantities);
  const figures::SeriesStyle fit = figures::estimator_style(method::hysteresis::Estimator::fit);
  all["fit_style"] = style(fit.colour, fit.line);
  all["points"] = points(c, scales);
  all["midline"] = midline(h, scales);
  all["loops"] = std::move(drawn);
  all["runs"] = has_curves ? runs(c) : Json(nullptr);
  all["candidates"] = candidates(c, scales.torque);
  if (Json tried = has_curves ? laws(c) : Json(nullptr); !tried.is_null()) {
    all["laws"] = std::move(tried);
  }
  if (context.earlier != nullptr && context.earlier->torque_unit == c.manifest.torque_unit()) {
    all["earlier"] =
        earlier_curves(*context.earlier, context.earlier_date, scales, friction_scale(c));
  }
  if (Json says = script_texts(); !says.empty()) all["says"] = std::move(says);
  return review_text(all);
}

namespace {

std::string name_of(render::figure::LineStyle line) { return own_name(line); }

}  // namespace

Json shown_text(const std::string& text) {
  return calibration::text_or_null(wording::visible_text(text));
}

Json quantity(const std::string& words, const std::string& symbol, const std::string& unit) {
  return {{"words", words}, {"symbol", symbol}, {"unit", unit}};
}

Json column(const std::vector<double>& si, const wording::AxisScale& scale) {
  return calibration::short_numbers(figures::shown(si, scale));
}

Json entry(double si, const wording::AxisScale& scale) { return column({si}, scale).front(); }

Json style(render::figure::Colour colour, render::figure::LineStyle line) {
  return {{"colour", fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue)},
          {"line", name_of(line)}};
}

// Candidate masses with their friction curves and quality errors.

namespace {

using wording::AxisScale;
using wording::tr;

const wording::AxisScale as_it_is{1.0, ""};

/// 95 % half width of the reference in % of the driving torque, where it has one.
Json reference_band(const calibration::Calibration& c) {
  const method::selection::QualityErrorsResult& q = c.quality;
  if (!(q.reference_rms_percent > 0.0) || q.errors.empty()) return nullptr;
  std::vector<double> percent;
  for (std::size_t i = 0; i < c.viscous.runs.size(); ++i) {
    const bool has_one = i < q.reference_half_width_Nm.size() &&
                         i < q.errors.front().percent.size() &&
                         std::isfinite(q.errors.front().percent[i]);
    percent.push_back(
        has_one ? std::abs(100.0 * q.reference_half_width_Nm[i] / c.viscous.runs[i].torque_Nm)
                : std::nan(""));
  }
  return column(percent, as_it_is);
}

}  // namespace

void add_run_quantities(const calibration::Calibration& c, Json& quantities) {
  quantities["w"] = quantity(
      wording::has_motor_side(c.manifest) ? wording::tr("motor speed") : wording::tr("joint speed"),
      wording::speed_symbol(c.manifest), "rad/s");
  quantities["f"] = quantity(wording::tr("friction torque"), "Tf", friction_scale(c).unit);
  quantities["e"] = quantity(wording::tr("error 100 (Tf − reference) / T"), "", "%");
}

Json runs(const calibration::Calibration& c) {
  std::vector<double> speed;
  Json torque = Json::array();
  Json names = Json::array();
  for (const method::viscous::ConstantSpeedRun& run : c.viscous.runs) {
    speed.push_back(run.speed_rad_s);
    const statistics::Estimate mean{run.torque_Nm,
                                    run.torque_Nm - run.torque_half_width_Nm,
                                    run.torque_Nm + run.torque_half_width_Nm,
                                    {}};
    torque.push_back(wording::with_unit(
        wording::round_by_interval(mean, wording::plain_scale("N·m")).plus_minus(), "N·m"));
    if (!c.viscous.from_sweep) names.push_back(shown_text(elements::log_name(run.recording)));
  }
  const bool has_reference = c.quality.reference != method::selection::CurveReference::none &&
                             c.quality.reference_Nm.size() == speed.size();
  Json out;
  out["from_sweep"] = c.viscous.from_sweep;
  out["reference"] =
      has_reference ? shown_text(figures::reference_words(c.quality.reference)) : Json(nullptr);
  out["w"] = column(speed, as_it_is);
  out["torque_texts"] = std::move(torque);
  out["names"] = std::move(names);
  out["f"] = has_reference ? column(c.quality.reference_Nm, friction_scale(c)) : Json(nullptr);
  out["band"] = reference_band(c);
  out["style"] = style(figures::reference_style.colour, render::figure::LineStyle::solid);
  return out;
}

Json candidates(const calibration::Calibration& c, const wording::AxisScale& torque) {
  Json list = Json::array();
  const wording::AxisScale friction = friction_scale(c);
  for (const method::hysteresis::SurrogateMass& mass : c.masses.masses) {
    const figures::SeriesStyle look = figures::estimator_style(mass.estimator);
    const wording::RoundedEstimate kg =
        wording::round_by_interval(mass.mass_kg, wording::plain_scale("kg"));
    Json one;
    one["name"] = to_string(mass.estimator);
    one["words"] = shown_text(figures::estimator_words(mass.estimator));
    one["what"] = elements::meaning_of(mass.estimator);
    one["mass"] = wording::with_unit(kg.plus_minus(), "kg");
    one["T"] = entry(mass.torque_Nm.value, torque);
    one["torque"] = wording::with_unit(
        wording::round_by_interval(mass.torque_Nm, wording::plain_scale("N·m")).plus_minus(),
        "N·m");
    one["recommended"] = mass.estimator == c.selection.recommended;
    one["papers"] = mass.estimator == c.selection.paper_rule;
    one["style"] = style(look.colour, look.line);
    const method::viscous::ViscousCurve* curve = c.viscous.find(mass.estimator);
    one["f"] = curve != nullptr ? column(curve->friction_Nm, friction) : Json(nullptr);
    const method::selection::QualityError* error = c.quality.find(mass.estimator);
    one["e"] = error != nullptr ? column(error->percent, as_it_is) : Json(nullptr);
    constexpr int digits = 3;  // as in the table of stage 6
    one["rms"] =
        error != nullptr ? Json(wording::significant(error->rms_percent, digits)) : Json(nullptr);
    list.push_back(std::move(one));
  }
  return list;
}

namespace {

/// Apart from the candidates' curves and from each other, by their dashes too.
Json law_style(std::size_t place) {
  namespace colour = render::figure::palette;
  using render::figure::LineStyle;
  const std::array styles{
      style(colour::black, LineStyle::dash), style(colour::green, LineStyle::dash_dot),
      style(colour::vermilion, LineStyle::dash_dot_dot), style(colour::grey, LineStyle::dot)};
  return styles[std::min(place, styles.size() - 1)];
}

}  // namespace

Json laws(const calibration::Calibration& c) {
  const method::model::ModelLaw& law = c.model.law;
  if (law.empty()) return nullptr;
  constexpr int points = 200;
  constexpr double worth_a_line = 0.01;
  const AxisScale friction = friction_scale(c);
  const std::vector<double> speed = law.speeds_rad_s(points);
  Json list = Json::array();
  for (const method::model::CandidateLaw& one : law.candidates) {
    if (one.probability < worth_a_line) continue;
    list.push_back({{"words", shown_text(wording::words(described(one.law)))},
                    {"f", column(one.law.friction_Nm(speed), friction)},
                    {"note", elements::share_in_words(one.probability)},
                    {"chosen", list.empty()},
                    {"style", law_style(list.size())}});
  }
  if (const auto waiboer = method::viscous::waiboer_of(c.friction.waiboer)) {
    std::vector<double> torque;
    for (const double w : speed) torque.push_back(waiboer->magnitude_Nm(w));
    list.push_back(
        {{"words", shown_text(tr("Waiboer's law, fitted"))},
         {"f", column(torque, friction)},
         {"note", tr("eq. (6)")},
         {"chosen", false},
         {"style", style(render::figure::palette::purple, render::figure::LineStyle::dash)}});
  }
  return {{"w", column(speed, as_it_is)}, {"list", std::move(list)}};
}

}  // namespace tribolog::report::viewer
