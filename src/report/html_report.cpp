#include "report/html_report.h"

#include "calibration_json.h"
#include "files/sha256.h"
#include "report/base64.h"
#include "report/embedded_files.h"
#include "report/report_values.h"
#include "report/report_view.h"
#include "report/template_engine.h"
#include "report/template_modifiers.h"

namespace tribolog {
namespace {

std::string content_security_policy(const std::string& style) {
  return "default-src 'none'; img-src data:; style-src 'sha256-" +
         report::base64_of_hex(sha256_hex(style)) + "'; base-uri 'none'; form-action 'none'";
}

}  // namespace

std::string html_report(const Calibration& calibration, const std::vector<ReportFigure>& figures,
                        const std::vector<render::DrawnFigure>& drawn,
                        const Provenance& provenance) {
  using namespace report;
  const ReportView view = make_report_view(calibration, figures, drawn, provenance);
  TemplateValues values;
  fill_report(view, values);
  const std::string style(embedded_file(style_sheet_name));
  values.set_checked_by_modifier("CSS", style);
  values.set("CSP", content_security_policy(style));
  values.set_checked_by_modifier("RESULT_JSON", calibration_json(calibration, provenance));
  return expand_template("report.tpl", values);
}

DrawingSoftware drawing_software(const render::RendererInfo& info) {
  return {info.vtk_version, info.back_end, info.gl_version,
          info.gl_renderer, info.font,     info.freetype_version};
}

}  // namespace tribolog
