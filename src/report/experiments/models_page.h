#pragma once
// The comparison of friction models as one HTML file that needs nothing else.

#include <string>
#include <vector>

#include "calibration/provenance.h"
#include "figures/experiments/model_figures.h"
#include "render/workers/renderer.h"
#include "wording/language.h"

namespace tribolog::report::experiments {

/// UTF-8 HTML without script or link to the outside, in the style of the report. Figures and drawn
/// pictures pair up by id; one that is missing or failed leaves a placeholder with the reason.
std::string models_page(const friction::ContactParameters& contact,
                        const std::vector<figures::experiments::ModelExperiment>& experiments,
                        const std::vector<render::workers::DrawnFigure>& drawn,
                        const calibration::Provenance& provenance,
                        wording::Language language = wording::Language{});

}  // namespace tribolog::report::experiments
