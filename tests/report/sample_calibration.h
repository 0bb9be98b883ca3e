#pragma once
// A calibration with the numbers of the paper's joint, written by hand, and one of a sweep alone.

#include <cstddef>
#include <string>
#include <vector>

#include "calibration/calibration.h"
#include "calibration/provenance.h"
#include "figures/report_figure.h"
#include "render/workers/renderer.h"

namespace tribolog::test {

inline constexpr double sample_mass_kg = 79.1679;
inline constexpr double sample_mass_half_width_kg = 0.088;

/// Every stage done.
calibration::Calibration complete_calibration();

/// A log in amperes with a rough sweep only: half of the stages have nothing.
calibration::Calibration sweep_only();

/// One figure per stage name, in the stages' order: "fig-1" to "fig-8".
std::vector<figures::ReportFigure> sample_figures(const calibration::Calibration& calibration);

/// A picture of a few bytes for each figure.
std::vector<render::workers::DrawnFigure> sample_pictures(
    const std::vector<figures::ReportFigure>& figures);

calibration::Provenance sample_provenance();

/// The report of a calibration with all its figures.
std::string report_of(const calibration::Calibration& calibration);

std::size_t occurrences(const std::string& text, const std::string& part);

}  // namespace tribolog::test
