#include "report/html_report.h"

#include "calibration/calibration_json.h"
#include "report/page_style.h"
#include "report/report_values.h"
#include "report/report_view.h"
#include "report/review_json.h"
#include "report/template_engine.h"

namespace tribolog::report {
std::string html_report(const calibration::Calibration& calibration,
                        const std::vector<figures::ReportFigure>& figures,
                        const std::vector<render::workers::DrawnFigure>& drawn,
                        const calibration::Provenance& provenance,
                        const std::optional<history::Comparison>& since_last,
                        wording::Language language) {
  const wording::WordsIn words(language);
  const ReportView view = make_report_view(calibration, figures, drawn, provenance, since_last);
  TemplateValues values;
  const std::string loops = review_json(calibration);
  fill_report(view, !loops.empty(), values);
  if (loops.empty()) {
    fill_style(values);
  } else {
    fill_style_and_script(values);
    values.add_section("REVIEW_DATA").set_checked_by_modifier("LOOPS_JSON", loops);
  }
  values.set_checked_by_modifier("RESULT_JSON",
                                 calibration::calibration_json(calibration, provenance));
  return expand_template("report.tpl", values, language);
}

calibration::DrawingSoftware drawing_software(const render::figure::RendererInfo& info) {
  return {info.vtk_version, info.back_end, info.gl_version,
          info.gl_renderer, info.font,     info.freetype_version};
}

}  // namespace tribolog::report
