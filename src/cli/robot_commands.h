#pragma once
// plan, identify, report and figures of a whole robot.

#include <string>
#include <vector>

#include "cli/commands.h"

namespace tribolog::cli {

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

/// Each joint's plan in a directory of its own, and a page of the robot, which leads to them.
/// @param joints of the robot's file.
ExitStatus plan_robot(const PlanCommandOptions& options, const std::vector<std::string>& joints,
                      const std::vector<std::string>& arguments, Console& console);

}  // namespace tribolog::cli
