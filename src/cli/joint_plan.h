#pragma once
// The plan of one joint and its files, of a joint alone or of a robot's.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "base/error.h"
#include "calibration/provenance.h"
#include "cli/console.h"
#include "joint/joint_facts.h"
#include "joint/recording.h"
#include "render/workers/renderer.h"
#include "report/experiments/plan_page.h"
#include "wording/language.h"

namespace tribolog::cli {

struct PlanCommandOptions {
  std::string joint;     ///< File of the joint, or of a robot's joints (TOML).
  std::string of_robot;  ///< One joint of a robot's file, by name; empty: all, or the only one.
  std::string directory;
  /// Of the joint, from an earlier plan; of a robot the directory with its joints'; empty: none.
  std::string calibration;
  std::size_t runs{20};  ///< Simulations behind the expected intervals; 0: none.
  unsigned long long seed{1};
  std::size_t threads{0};  ///< 0: all cores.
  int processes{2};
  wording::Language language;
};

inline constexpr const char* plan_page_name = "plan.html";

/// What a plan is made from.
struct JointInput {
  joint::JointFacts facts;
  std::vector<joint::Role> roles;  ///< That are asked for; empty: all.
  std::string file;                ///< The user's, for messages.
  std::string text;                ///< The joint's file (TOML).
  bool is_from_recordings{};       ///< The text is made of a calibration, and is no file yet.

  /// In which the place of a number can be named; empty: it is no file yet.
  [[nodiscard]] std::string stated_text() const { return is_from_recordings ? "" : text; }
};

/// Of a joint's file. @param text of the file that the options name.
/// @param joint of a robot's, by name; empty: the file is a single joint's.
/// @throw InputError as parse_joint() and with_calibration().
JointInput joint_in_file(const PlanCommandOptions& options, const std::string& text,
                         const std::string& joint);

/// Of a calibration or a report: within what was recorded, what the quantities need that are not
/// usable; all where each is. @throw InputError as recorded_joint().
JointInput joint_of_calibration(const std::string& file);

/// @param simulates called once the plan is made and its simulation begins.
/// @throw InputError for numbers of which each is possible, and of which together no plan comes.
report::experiments::PlanReport plan_of_joint(const PlanCommandOptions& options,
                                              const JointInput& joint,
                                              const calibration::Provenance& provenance,
                                              const std::function<void()>& simulates);

inline constexpr const char* planned_joint_name = "joint.toml";

/// What add_plan_files() writes to the directory.
const std::vector<std::string>& plan_file_names();

/// Adds page, numbers, set points and manifest. @param report gets what drew its figures.
/// @return how many figures failed, each of which is warned of.
std::size_t add_plan_files(report::experiments::PlanReport& report, const std::string& directory,
                           const wording::Language& language,
                           render::workers::FigureRenderer& renderer, AtomicFiles& files,
                           Console& console);

/// Each joint's plan in a directory of its own, and a page of the robot, which leads to them.
/// @param joints of the robot's file.
ExitStatus plan_robot(const PlanCommandOptions& options, const std::vector<std::string>& joints,
                      const std::vector<std::string>& arguments, Console& console);

}  // namespace tribolog::cli
