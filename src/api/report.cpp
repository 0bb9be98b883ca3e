#include "tribolog/report.h"

#include <stdexcept>
#include <utility>

#include "api/contents.h"
#include "api/drawing.h"
#include "api/guard.h"
#include "base/encodings.h"
#include "base/error.h"
#include "calibration/provenance.h"
#include "calibration/read_calibration.h"
#include "figures/figure_csv.h"
#include "figures/figure_set.h"
#include "history/comparison.h"
#include "paper/scenes/scene_figures.h"
#include "report/document/html_report.h"
#include "report/document/robot_page.h"
#if TRIBOLOG_EXPERIMENTS
#include "ingest/manifest/joint_file.h"
#include "plan/experiment_plan.h"
#endif

namespace tribolog::api {
namespace {

calibration::Measured measured(const Calibration& calibration, const std::string& id) {
  calibration::RecordedCalibration read =
      calibration::read_calibration(calibration.to_json(), "the calibration");
  calibration::Measured made;
  made.entry.id = id.empty() ? sha256_hex(calibration.to_json()) : id;
  made.entry.facts = std::move(read.facts);
  made.quantities = std::move(read.quantities);
  return made;
}

std::optional<history::Comparison> since(const std::optional<EarlierCalibration>& earlier,
                                         const Calibration& calibration,
                                         const std::string& kept_as) {
  if (!earlier) return std::nullopt;
  return history::compare(measured(earlier->calibration, earlier->id),
                          measured(calibration, kept_as), {}, false);
}

/// Within what the recordings show, for the quantities that are not usable; nothing where they show
/// no limits.
std::vector<report::document::NextPart> next_experiment(
    [[maybe_unused]] const calibration::Judgement& judgement,
    [[maybe_unused]] const std::string& json) {
  std::vector<report::document::NextPart> parts;
#if TRIBOLOG_EXPERIMENTS
  std::vector<joint::Quantity> wanted;
  for (const calibration::QuantityVerdict& q : judgement.quantities) {
    if (q.verdict != calibration::Verdict::usable) wanted.push_back(q.quantity);
  }
  if (wanted.empty()) return parts;
  try {
    plan::PlanOptions options;
    options.roles = plan::roles_that_show(wanted);
    const plan::ExperimentPlan plan =
        plan::plan_experiment(ingest::manifest::recorded_joint(json, "the calibration"), options);
    for (const plan::PlannedPart& part : plan.parts) {
      if (part.recordings > 0) parts.push_back({part.role, part.recordings, part.duration_s});
    }
  } catch (const InputError&) {
    return {};
  } catch (const std::invalid_argument&) {
    return {};
  }
#endif
  return parts;
}

}  // namespace
}  // namespace tribolog::api

namespace tribolog {

Report make_report(const Calibration& calibration, const ReportOptions& options,
                   Renderer* renderer) {
  return api::guarded([&] {
    const wording::Language language = api::language_of(options.language);
    const api::Identified& identified = api::Inside::of(calibration);
    const joint::Dataset& dataset = api::Inside::of(identified.dataset);
    const auto since_last = api::since(options.earlier, calibration, options.kept_as);
    calibration::Provenance provenance = identified.provenance;
    if (!options.kept_as.empty()) {
      provenance.configuration.push_back(
          {{"setting.archived_as"}, Statement::verbatim(options.kept_as)});
    }
    std::vector<figures::ReportFigure> figures;
    std::vector<render::workers::DrawnFigure> drawn;
    if (render::workers::FigureRenderer* const drawing = api::Inside::of(renderer)) {
      figures = figures::figures_in(language, [&] {
        return figures::for_a_report(
            paper::scenes::with_scene_figures(figures::figure_set(dataset, identified.calibration),
                                              dataset.robot.get(), identified.calibration));
      });
      drawn = api::draw(*drawing, figures, [&](std::size_t done, std::size_t all) {
        if (options.progress) options.progress("drawing figures", done, all);
      });
      provenance.drawing = api::software_that_drew(drawn);
    }
    if (options.progress) options.progress("writing the report", 1, 1);
    const report::document::PageContext context{
        since_last, language, options.kept_as,
        api::next_experiment(identified.calibration.judgement, calibration.to_json()),
        options.earlier ? calibration::read_curves(options.earlier->calibration.to_json())
                        : calibration::RecordedCurves{}};
    return Report{
        report::document::html_report(identified.calibration, figures, drawn, provenance, context),
        api::outcomes_of(drawn)};
  });
}

std::string make_robot_page(const std::vector<RobotJoint>& joints,
                            const RobotPageOptions& options) {
  return api::guarded([&] {
    const wording::Language language = api::language_of(options.language);
    if (joints.empty()) throw UsageError("a robot's page needs a joint");
    std::vector<report::document::RobotJoint> shown;
    for (const RobotJoint& joint : joints) {
      report::document::RobotJoint& one = shown.emplace_back();
      one.name = joint.name;
      one.refusal = joint.refusal;
      one.file = joint.report;
      if (!joint.calibration) continue;
      one.calibration = &api::Inside::of(*joint.calibration).calibration;
      one.since_last = api::since(joint.earlier, *joint.calibration, joint.kept_as);
    }
    return report::document::robot_page(shown, calibration::make_provenance(options.command_line),
                                        language);
  });
}

}  // namespace tribolog
