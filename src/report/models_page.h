#pragma once
// The comparison of friction models as one HTML file that needs nothing else.

#include <string>
#include <vector>

#include "calibration/provenance.h"
#include "figures/model_figures.h"
#include "render/workers/renderer.h"
#include "wording/language.h"

namespace tribolog {

/// UTF-8 HTML without script or link to the outside, in the style of the report. Figures and drawn
/// pictures pair up by id; one that is missing or failed leaves a placeholder with the reason.
std::string models_page(const ContactParameters& contact,
                        const std::vector<ModelExperiment>& experiments,
                        const std::vector<render::DrawnFigure>& drawn, const Provenance& provenance,
                        Language language = Language::english);

}  // namespace tribolog
