#pragma once
// A calibration as one HTML file: verdict, numbers with intervals, figures, and the embedded JSON.

#include <optional>
#include <string>
#include <vector>

#include "tribolog/calibration.h"
#include "tribolog/export.h"
#include "tribolog/figures.h"
#include "tribolog/values.h"

namespace tribolog {

/// The joint's previous calibration: the report then shows what has changed since.
struct EarlierCalibration {
  Calibration calibration;
  /// Its id where it is archived; ten characters are shown. Empty: the SHA-256 of its JSON.
  std::string id;
};

struct ReportOptions {
  std::string language{"en"};  ///< Of the page; the embedded JSON is the same in all.
  std::optional<EarlierCalibration> earlier;
  std::string kept_as;  ///< The id under which this one is archived; empty: it is not.
  Progress progress;
};

struct Report {
  std::string html;                    ///< UTF-8; needs no other file and no connection.
  std::vector<FigureOutcome> figures;  ///< One per figure; a missing picture is replaced by a note.
};

/// @param renderer null: numbers and tables only.
/// @throw Failure usage: no such language, a calibration without its recordings, or an earlier one
///        of another joint.
TRIBOLOG_EXPORT Report make_report(const Calibration& calibration,
                                   const ReportOptions& options = {}, Renderer* renderer = nullptr);

}  // namespace tribolog
