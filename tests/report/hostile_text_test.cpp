// Text of strangers in every field: the document keeps its shape, and nothing hides.

#include <gtest/gtest.h>

#include "render/figure/figure.h"
#include "report/document/html_report.h"
#include "report/document_checks.h"
#include "report/run_python.h"
#include "report/sample_calibration.h"

namespace tribolog::test::hostile_text_test {
namespace {

/// Every text that a manifest, a log or a library can bring in.
calibration::Calibration filled_with(const std::string& text) {
  calibration::Calibration c = complete_calibration();
  joint::Manifest& m = c.manifest;
  for (std::string* field :
       {&m.robot, &m.serial, &m.joint, &m.operator_name, &m.measured_on, &m.note, &m.payload}) {
    *field = text;
  }
  const Statement said = Statement::verbatim(text);
  for (Statement* statement :
       {&c.rough.method, &c.precise.method, &c.rough.q_peak_rad.method,
        &c.hysteresis.bristle_source, &c.selection.why, &c.judgement.sentence, &c.lugre->reason,
        &c.lugre->identifiability.weakest_statement}) {
    *statement = said;
  }
  for (statistics::StageReport* stage :
       {&c.rough.stage, &c.precise.stage, &c.hysteresis.stage, &c.masses.stage, &c.viscous.stage,
        &c.quality.stage, &c.selection.stage, &c.friction.stage}) {
    stage->state = statistics::StageState::partial;
    stage->reason = said;
  }
  c.lugre->loops.front().recording = text;
  for (method::hysteresis::LuGreParameter& p : c.lugre->parameters) p.why_not = p.experiment = said;
  c.judgement.findings = {said};
  for (calibration::QuantityVerdict& quantity : c.judgement.quantities) {
    quantity.experiment = said;
    quantity.reasons = {said};
    for (calibration::LimitOutcome& limit : quantity.limits) {
      limit.outcome = said;
      limit.unit = limit.key = text;
    }
  }
  for (method::checks::DataCheck& check : c.data_checks.checks) {
    check.recording = text;
    check.measure = check.found = check.consequence = check.experiment = said;
  }
  c.notes = {Statement::verbatim(text)};
  for (joint::InputFile& file : c.inputs) {
    file.name = file.role = file.sha256 = text;
    file.skipped = {{Statement::verbatim(text), 3}};
    for (joint::ColumnConversion& conversion : file.conversions)
      conversion.column = conversion.unit = text;
  }
  for (method::motion::SpeedSource& source : c.speed_sources) source.recording = text;
  for (method::viscous::ConstantSpeedRun& run : c.viscous.runs) run.recording = text;
  c.truth_check.runs = 1;
  c.truth_check.quantities = {
      {calibration::ReadingName::q_peak, text, 1, 2, 0, 1, 1, 0, {1}, false}};
  c.truth_check.left_out = {said};
  c.truth_check.findings = {{calibration::ReadingName::q_peak, said}};
  for (method::hysteresis::SurrogateMass& mass : c.masses.masses)
    mass.torque_Nm.method = mass.mass_kg.method = said;
  return c;
}

std::string report_with(const std::string& text) {
  const calibration::Calibration c = filled_with(text);
  auto figures = sample_figures(c);
  for (figures::ReportFigure& figure : figures) {
    figure.title = figure.caption = figure.how_to_read = figure.alt = text;
  }
  auto drawn = sample_pictures(figures);
  for (render::workers::DrawnFigure& picture : drawn) {
    picture.warnings = {
        Statement::verbatim(text),
        {"drawing.no_sample", {{"series", render::figure::name_of_series(text, 0)}}}};
  }
  drawn.back().png.clear();
  drawn.back().error = Statement::verbatim(text);
  calibration::Provenance p = sample_provenance();
  p.tool_version = p.git_revision = p.compiler = p.eigen_version = p.command_line = text;
  p.created_utc = text;
  p.drawing = calibration::DrawingSoftware{text, text, text, text, text, text};
  p.configuration = {{Statement::verbatim(text), Statement::verbatim(text)}};
  return report::document::html_report(c, figures, drawn, p);
}

TEST(HostileText, LeavesTheDocumentAsItIs) {
  if (!has_python_module("html.parser")) GTEST_SKIP() << "python3 is not installed";
  const auto plain = run_python(skeleton, report_with("x"));
  const auto attacked = run_python(skeleton, report_with(hostile));
  ASSERT_TRUE(plain && attacked);
  EXPECT_EQ(*plain, *attacked);
}

TEST(HostileText, IsShownNotRun) {
  const std::string html = report_with(hostile);
  EXPECT_EQ(occurrences(html, "<script"), 3U);
  EXPECT_EQ(occurrences(html, "<img src=x"), 0U);
  EXPECT_EQ(occurrences(html, "<style>"), 1U);
  EXPECT_GT(occurrences(html, "&lt;script&gt;alert(1)"), 20U);
}

TEST(HostileText, NothingHides) {
  const std::string html = report_with(hostile);
  const std::string body = html.substr(0, html.find("<script type"));
  EXPECT_EQ(body.find('\x1b'), std::string::npos);
  EXPECT_EQ(body.find("\u202E"), std::string::npos);
  EXPECT_EQ(body.find('\xff'), std::string::npos);
  EXPECT_NE(body.find("\\x1b[31m"), std::string::npos);
  EXPECT_NE(body.find("[U+202E]"), std::string::npos);
  EXPECT_NE(body.find("\\xff\\xc3"), std::string::npos);
}

TEST(HostileText, AVeryLongWordStaysText) {
  EXPECT_GT(report_with(std::string(100000, 'A')).size(), 1000000U);
}

}  // namespace
}  // namespace tribolog::test::hostile_text_test
