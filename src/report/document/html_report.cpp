#include "report/document/html_report.h"

#include "base/encodings.h"
#include "calibration/calibration_json.h"
#include "report/document/report_values.h"
#include "report/document/report_view.h"
#include "report/engine/page_style.h"
#include "report/engine/template_engine.h"
#include "report/viewer/review_json.h"
#include "wording/torques_in.h"

namespace tribolog::report::document {
namespace {

/// Of what was found from which inputs, whenever and however the program was called.
std::string digest_of(const calibration::Calibration& calibration,
                      calibration::Provenance provenance) {
  provenance.created_utc.clear();
  provenance.command_line.clear();
  provenance.drawing.reset();
  return sha256_hex(calibration::calibration_json(calibration, provenance));
}

}  // namespace

std::string html_report(const calibration::Calibration& calibration,
                        const std::vector<figures::ReportFigure>& figures,
                        const std::vector<render::workers::DrawnFigure>& drawn,
                        const calibration::Provenance& provenance,
                        const std::optional<history::Comparison>& since_last,
                        wording::Language language, const std::string& id) {
  const wording::WordsIn words(language);
  const wording::TorquesIn unit(calibration.manifest.torque_unit());
  const std::string result = calibration::calibration_json(calibration, provenance);
  const ReportView view = make_report_view(calibration, figures, drawn, provenance, since_last,
                                           id.empty() ? digest_of(calibration, provenance) : id);
  engine::TemplateValues values;
  const std::string loops = viewer::review_json(calibration);
  fill_report(view, !loops.empty(), values);
  if (loops.empty()) {
    engine::fill_style(values, engine::PageKind::plain, view.number);
  } else {
    engine::fill_style_and_script(values, view.number);
    values.add_section("REVIEW_DATA").set_checked_by_modifier("LOOPS_JSON", loops);
  }
  values.set_checked_by_modifier("RESULT_JSON", result);
  return engine::expand_template("report.tpl", values, language);
}

calibration::DrawingSoftware drawing_software(const render::figure::RendererInfo& info) {
  return {info.vtk_version, info.back_end, info.gl_version,
          info.gl_renderer, info.font,     info.freetype_version};
}

}  // namespace tribolog::report::document
