#include "report/document/html_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/encodings.h"
#include "calibration/calibration_json.h"
#include "report/document/report_values.h"
#include "report/document/report_view.h"
#include "report/engine/page_style.h"
#include "report/engine/template_engine.h"
#include "report/viewer/review_json.h"
#include "wording/rounding.h"
#include "wording/torques_in.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::document {
namespace {

using wording::tr;

/// Of what was found from which inputs, whenever and however the program was called.
std::string digest_of(const calibration::Calibration& calibration,
                      calibration::Provenance provenance) {
  provenance.created_utc.clear();
  provenance.command_line.clear();
  provenance.drawing.reset();
  return sha256_hex(calibration::calibration_json(calibration, provenance));
}

std::string minutes(double duration_s) {
  constexpr double seconds = 60;
  return wording::with_unit(wording::significant(duration_s / seconds, 2), "min");
}

/// "5.6 min: rough sweep (2.4 min), 20 runs at constant speed (3.2 min)"; empty: there are none.
std::string parts_in_words(const std::vector<NextPart>& parts) {
  if (parts.empty()) return "";
  double all_s = 0;
  std::vector<std::string> words;
  for (const NextPart& part : parts) {
    all_s += part.duration_s;
    const std::string name = wording::words_for("plan_part", to_string(part.role));
    words.push_back(
        tr("{part} ({duration})", {{"part", name}, {"duration", minutes(part.duration_s)}}));
  }
  return tr("{duration}: {parts}",
            {{"duration", minutes(all_s)}, {"parts", fmt::format("{}", fmt::join(words, ", "))}});
}

}  // namespace

std::string html_report(const calibration::Calibration& calibration,
                        const std::vector<figures::ReportFigure>& figures,
                        const std::vector<render::workers::DrawnFigure>& drawn,
                        const calibration::Provenance& provenance, const PageContext& context) {
  const wording::WordsIn words(context.language);
  const wording::TorquesIn unit(calibration.manifest.torque_unit());
  const std::string result = calibration::calibration_json(calibration, provenance);
  const std::string id = context.id.empty() ? digest_of(calibration, provenance) : context.id;
  ReportView view =
      make_report_view(calibration, figures, drawn, provenance, context.since_last, id);
  view.next_parts = parts_in_words(context.next);
  engine::TemplateValues values;
  const std::string loops = viewer::review_json(
      calibration,
      {view.number, context.since_last ? &context.last_curves : nullptr, view.last_day});
  fill_report(view, !loops.empty(), values);
  if (loops.empty()) {
    engine::fill_style(values, engine::PageKind::plain, view.number);
  } else {
    engine::fill_style_and_script(values, view.number);
    values.add_section("REVIEW_DATA").set_checked_by_modifier("LOOPS_JSON", loops);
  }
  values.set_checked_by_modifier("RESULT_JSON", result);
  return engine::expand_template("report.tpl", values, context.language);
}

calibration::DrawingSoftware drawing_software(const render::figure::RendererInfo& info) {
  return {info.vtk_version, info.back_end, info.gl_version,
          info.gl_renderer, info.font,     info.freetype_version};
}

}  // namespace tribolog::report::document
