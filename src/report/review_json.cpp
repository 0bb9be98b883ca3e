#include "report/review_json.h"

#include <algorithm>

#include "base/shown_text.h"
#include "figures/estimator_style.h"
#include "report/page_texts.h"
#include "report/review_parts.h"

namespace tribolog::report {

namespace {

/// What the script looks things up by, and names that the user gave.
bool is_read_aloud(const std::string& key) {
  return key != "name" && key != "names" && key != "schema" && key != "style" && key != "fit_style";
}

void translate_texts(review::Json& value, const Catalogue& catalogue) {
  if (value.is_string()) {
    value = catalogue.translate(value.get<std::string>());
  } else if (value.is_object()) {
    for (auto& [key, part] : value.items()) {
      if (is_read_aloud(key)) translate_texts(part, catalogue);
    }
  } else if (value.is_array()) {
    for (review::Json& part : value) translate_texts(part, catalogue);
  }
}

/// What the script says by itself.
review::Json script_texts(const Catalogue& catalogue) {
  review::Json says = review::Json::object();
  for (const std::string& message : script_messages()) {
    std::string text = catalogue.find_in_templates(message);
    if (text.empty()) text = catalogue.find(message);
    if (!text.empty()) says[message] = text;
  }
  return says;
}

}  // namespace

std::string review_json(const Calibration& c, Language language) {
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
  if (const Catalogue* const catalogue = catalogue_of(language); catalogue != nullptr) {
    translate_texts(all, *catalogue);
    all["says"] = script_texts(*catalogue);
  }
  return json_without_hidden(all.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace tribolog::report
