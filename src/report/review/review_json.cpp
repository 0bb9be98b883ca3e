#include "report/review/review_json.h"

#include <algorithm>

#include "figures/estimator_style.h"
#include "report/review/review_parts.h"

namespace tribolog::report {

std::string review_json(const Calibration& c) {
  using namespace review;
  const HysteresisResult& h = c.hysteresis;
  const LoopScales scales = loop_scales(h);
  Json drawn = h.found ? loops(h, scales, c.q_peak_rad) : Json::array();
  const bool has_curves = !c.viscous.runs.empty() && !c.viscous.curves.empty();
  if (drawn.empty() && !has_curves) return {};

  Json all;
  all["schema"] = "tribolog-loops-1";
  all["bristle"] = shown_text(h.bristle_source);
  Json quantities;
  const bool from_first_sample =
      std::any_of(drawn.begin(), drawn.end(), [](const Json& loop) { return loop["t0_s"] != 0.0; });
  if (!drawn.empty()) add_loop_quantities(scales, from_first_sample, quantities);
  if (has_curves) add_run_quantities(c, quantities);
  all["quantities"] = std::move(quantities);
  const figures::SeriesStyle fit = figures::estimator_style("fit");
  all["fit_style"] = style(fit.colour, fit.line);
  all["points"] = points(h, scales);
  all["midline"] = midline(h, scales);
  all["loops"] = std::move(drawn);
  all["runs"] = has_curves ? runs(c) : Json(nullptr);
  all["candidates"] = candidates(c, scales.torque);
  return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace tribolog::report
