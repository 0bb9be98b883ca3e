#pragma once
// A calibration as one HTML file: verdict, numbers with intervals, figures, and the JSON within.

#include <optional>
#include <string>
#include <vector>

#include "tribolog/calibration.h"
#include "tribolog/export.h"
#include "tribolog/figures.h"
#include "tribolog/values.h"

namespace tribolog {

/// The joint's calibration before: the report then shows what has changed since.
struct EarlierCalibration {
  Calibration calibration;
  /// What it is called where it is kept; ten characters are shown. Empty: its JSON's SHA-256.
  std::string id;
};

struct ReportOptions {
  std::string language{"en"};  ///< Of the page; the JSON within is the same in each.
  std::optional<EarlierCalibration> earlier;
  std::string kept_as;  ///< What this one is called where it is kept; empty: it is not kept.
  Progress progress;
};

struct Report {
  std::string html;                    ///< UTF-8; needs no other file and no connection.
  std::vector<FigureOutcome> figures;  ///< Of each; one without a picture has a note in its place.
};

/// @param renderer null: numbers and tables alone.
/// @throw Failure usage: no such language, a calibration without its recordings, or an earlier one
///        of another joint.
TRIBOLOG_EXPORT Report make_report(const Calibration& calibration,
                                   const ReportOptions& options = {}, Renderer* renderer = nullptr);

}  // namespace tribolog
