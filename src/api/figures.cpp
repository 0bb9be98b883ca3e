#include "tribolog/figures.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "api/contents.h"
#include "api/figure_files.h"
#include "api/guard.h"
#include "base/atomic_file.h"
#include "base/error.h"
#include "figures/figure_set.h"
#include "ingest/dataset/dataset_file.h"
#include "ingest/manifest/manifest_file.h"
#include "paper/scenes/scene_figures.h"
#include "tribolog/files.h"
#include "wording/language.h"

namespace tribolog::api {
namespace {

using render::workers::Prepared;

/// Scenes too, if the manifest names a description of the robot.
Prepared drawings_of(const std::string& manifest) {
  // A robot's is the same for all of its joints.
  const std::vector<std::string> joints = ingest::dataset::joints_of_robot(manifest);
  const std::string joint = joints.empty() ? std::string() : joints.front();
  return ingest::manifest::read_manifest(manifest, joint).manifest.robot_description.empty()
             ? Prepared::charts
             : Prepared::charts_and_scenes;
}

bool has_pictures(const std::vector<FigureFormat>& formats) {
  return std::find(formats.begin(), formats.end(), FigureFormat::png) != formats.end();
}

bool has_scenes(const std::vector<figures::ReportFigure>& figures) {
  return std::any_of(figures.begin(), figures.end(),
                     [](const figures::ReportFigure& one) { return one.figure.scene.has_value(); });
}

}  // namespace

render::workers::FigureRenderer* Inside::of(Renderer* renderer) {
  return renderer == nullptr || !renderer->processes_ ? nullptr : &renderer->processes_->renderer;
}

}  // namespace tribolog::api

namespace tribolog {

bool needs_renderer(const std::string& manifest, const std::vector<FigureFormat>& formats) {
  return api::guarded([&] {
    return api::drawings_of(manifest) == api::Prepared::charts_and_scenes ||
           api::has_pictures(formats);
  });
}

Renderer::Renderer(const RendererOptions& options)
    : processes_(api::guarded([&] {
        const auto prepared =
            options.manifest.empty() ? api::Prepared::charts : api::drawings_of(options.manifest);
        return std::make_unique<Processes>(options.processes, prepared);
      })) {}

Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

std::size_t Figures::drawn() const {
  return static_cast<std::size_t>(
      std::count_if(outcomes.begin(), outcomes.end(),
                    [](const FigureOutcome& one) { return one.error.empty(); }));
}

Figures draw_figures(const Calibration& calibration, const FigureOptions& options,
                     Renderer* renderer) {
  return api::guarded([&] {
    const wording::Language language = api::language_of(options.language);
    const api::Identified& identified = api::Inside::of(calibration);
    const joint::Dataset& dataset = api::Inside::of(identified.dataset);
    std::vector<figures::ReportFigure> figures = [&] {
      const wording::WordsIn words(language);
      return paper::scenes::with_scene_figures(figures::figure_set(dataset, identified.calibration),
                                               dataset.robot.get(), identified.calibration);
    }();
    render::workers::FigureRenderer* const drawing = api::Inside::of(renderer);
    if (drawing == nullptr && (api::has_pictures(options.formats) || api::has_scenes(figures))) {
      throw UsageError("pictures, and the drawings of a robot, need a renderer");
    }
    if (options.style == FigureStyle::paper) figures = api::for_publication(std::move(figures));
    return api::figure_files(figures, options.formats, drawing, options.progress);
  });
}

void write_files(const std::vector<File>& files, const std::string& directory) {
  api::guarded([&] {
    AtomicFiles written;
    if (!directory.empty()) written.make_directory(directory);
    for (const File& one : files) {
      written.add(directory.empty() ? one.name : directory + "/" + one.name, one.bytes);
    }
    written.commit();
  });
}

}  // namespace tribolog
