#pragma once
// identify, report and figures, each of one joint or of a whole robot.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "cli/archiving.h"
#include "cli/console.h"
#include "cli/given_data.h"
#include "cli/identification.h"
#include "tribolog/figures.h"
#include "tribolog/values.h"
#include "wording/language.h"

namespace tribolog::cli {

struct IdentifyArguments {
  GivenData given;
  DatasetChoice dataset;              ///< Found of what is given.
  std::string output;                 ///< Empty: beside the input.
  std::size_t truth_runs{0};          ///< Of the known-truth check; 0: none.
  std::optional<Verdict> fail_on;     ///< This verdict or a worse one is exit status 1.
  std::optional<std::uint64_t> seed;  ///< Wins over the manifest's.
  ArchivingOptions archiving;
};

struct FiguresOptions {
  DatasetChoice dataset;
  std::string directory;
  std::vector<FigureFormat> formats{FigureFormat::png};
  FigureStyle style{FigureStyle::report};
  wording::Language language;
  std::size_t truth_runs{0};  ///< Of the known-truth check, which has a figure of its own.
  int processes{2};
};

struct ReportOptions {
  GivenData given;
  DatasetChoice dataset;    ///< Found of what is given.
  std::string output;       ///< Empty: beside the input.
  std::string calibration;  ///< Empty: beside the report.
  std::size_t truth_runs{0};
  std::optional<Verdict> fail_on;
  std::optional<std::uint64_t> seed;  ///< Wins over the manifest's.
  int processes{2};
  bool figures{true};
  wording::Language language;
  ArchivingOptions archiving;
};

/// Each makes the files of all joints in the directory that the options' output names. A joint that
/// is refused does not stop the others. @param joints of the manifest.
ExitStatus identify_robot(const IdentifyArguments& options, const std::vector<std::string>& joints,
                          const std::vector<std::string>& arguments, Console& console);
/// Adds a page of the robot, which leads to the joints' reports.
ExitStatus report_robot(const ReportOptions& options, const std::vector<std::string>& joints,
                        const std::vector<std::string>& arguments, Console& console);
/// Each joint's figures in a directory of its own.
ExitStatus draw_robot(const FiguresOptions& options, const std::vector<std::string>& joints,
                      Console& console);

/// The figures of the one joint that the options choose, or of all.
ExitStatus run_figures(const FiguresOptions& options, Console& console);

}  // namespace tribolog::cli
