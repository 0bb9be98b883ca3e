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

/// One joint of a robot, as its page shows it.
struct RobotJoint {
  std::string name;
  std::optional<Calibration> calibration;  ///< Absent: it could not be identified,
  std::string refusal;                     ///< for this reason.
  std::optional<EarlierCalibration> earlier;
  std::string kept_as;  ///< As in ReportOptions.
  std::string report;   ///< File name of its report, beside the page; empty: there is none.
};

struct RobotPageOptions {
  std::string language{"en"};
  std::vector<std::string> command_line;  ///< As in IdentifyOptions.
};

/// All joints of a robot on one HTML page: each with its verdict, its numbers, what has changed,
/// its loop and its friction curve, and a link to its report.
/// @throw Failure usage: no joint, no such language, or a calibration as for make_report().
TRIBOLOG_EXPORT std::string make_robot_page(const std::vector<RobotJoint>& joints,
                                            const RobotPageOptions& options = {});

}  // namespace tribolog
