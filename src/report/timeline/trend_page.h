#pragma once
// Joints over time, in words for the console and as one HTML file.

#include <string>
#include <vector>

#include "calibration/provenance.h"
#include "figures/report_figure.h"
#include "history/joint_trend.h"
#include "render/workers/renderer.h"
#include "report/elements/elements.h"
#include "wording/language.h"

namespace tribolog::report::timeline {

/// "R1 S1, joint J2: 20 calibrations from 2025-01-01 to 2026-01-01"
std::string joint_words(const history::JointTrend& trend);

/// "Coulomb torque has risen by 2.9 %, visible from 2025-09-14 (alarm 2025-12-07)", one for each
/// warning that stands and each change that is over; as sentences.
std::vector<std::string> change_sentences(const history::JointTrend& trend);

/// A row for each quantity: how many were used, reference, scatter, effect of temperature, state.
elements::Table trend_table(const history::JointTrend& trend, const std::string& id);

/// What was left out and why, how temperature was treated, cautions; each a sentence.
std::vector<std::string> trend_notes(const history::JointTrend& trend);

/// How the chart works, with its numbers.
std::string chart_words(const history::JointTrend& trend);

// Joints over time as one HTML file that needs nothing else.

/// UTF-8 HTML without script or link to the outside, in the style of the report; a section for
/// each joint. Figures belong to joints by their ids, as trend_figures() makes them.
std::string trend_page(const std::vector<history::JointTrend>& trends,
                       const calibration::Provenance& provenance,
                       const std::vector<figures::ReportFigure>& figures,
                       const std::vector<render::workers::DrawnFigure>& drawn,
                       wording::Language language = wording::Language{});

}  // namespace tribolog::report::timeline
