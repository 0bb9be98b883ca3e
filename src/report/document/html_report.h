#pragma once
// A calibration as one HTML file that needs nothing else: no link to the outside, and one script,
// that of the loop viewer, without which nothing is missing.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "calibration/calibration.h"
#include "calibration/provenance.h"
#include "calibration/read_calibration.h"
#include "figures/report_figure.h"
#include "history/comparison.h"
#include "joint/recording.h"
#include "render/workers/renderer.h"
#include "wording/language.h"

namespace tribolog::report::document {

/// One part of what to record next.
struct NextPart {
  joint::Role role{};
  std::size_t recordings{};
  double duration_s{};  ///< With the travels to and within it.
};

/// What a page says beside the calibration.
struct PageContext {
  std::optional<history::Comparison> since_last{};  ///< From the joint's calibration before.
  wording::Language language{};  ///< The embedded result is the same in every language.
  /// Hexadecimal, of the calibration in the archive: the report's number where the manifest states
  /// none. Without it, the digest of the embedded result but for the time, the command and the
  /// drawing software.
  std::string id{};
  /// What to record for the quantities that are not usable; empty: nothing, or it is not known.
  std::vector<NextPart> next{};
  calibration::RecordedCurves last_curves{};  ///< Of the joint's calibration before.
};

/// UTF-8 HTML. The style is inline and named by its hash in a content security policy, pictures
/// are data URIs, and the result as JSON stands in `<script type="application/json"
/// id="tribolog-result">`, which a browser does not run. Where there are loops or friction curves,
/// the viewer's data stand in `tribolog-loops`, and the policy names the viewer's script by its
/// hash. Same arguments, same bytes.
///
/// Figures and drawn pictures pair up by id. A figure that could not be drawn gets a placeholder
/// with the reason, and the banner says how many are missing.
std::string html_report(const calibration::Calibration& calibration,
                        const std::vector<figures::ReportFigure>& figures,
                        const std::vector<render::workers::DrawnFigure>& drawn,
                        const calibration::Provenance& provenance, const PageContext& context = {});

/// The graphics stack as the provenance keeps it.
calibration::DrawingSoftware drawing_software(const render::figure::RendererInfo& info);

}  // namespace tribolog::report::document
