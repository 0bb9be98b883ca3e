#pragma once
// The plan of one joint and its files, of a joint alone or of a robot's.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "calibration/provenance.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "render/workers/renderer.h"
#include "report/experiments/plan_page.h"
#include "wording/language.h"

namespace tribolog::cli {

inline constexpr const char* plan_page_name = "plan.html";

/// @param text of the file that the options name. @param joint of a robot's, by name; empty: the
///        file is a single joint's.
/// @param simulates called once the plan is made and its simulation begins.
/// @throw InputError as parse_joint() and with_calibration(), and for numbers of which each is
///        possible, and of which together no plan comes.
report::experiments::PlanReport plan_of_joint(const PlanCommandOptions& options,
                                              const std::string& text, const std::string& joint,
                                              const calibration::Provenance& provenance,
                                              const std::function<void()>& simulates);

/// What add_plan() writes to the directory.
const std::vector<std::string>& plan_file_names();

/// Adds page, numbers, set points and manifest. @param report gets what drew its figures.
/// @return how many figures failed, each of which is warned of.
std::size_t add_plan(report::experiments::PlanReport& report, const std::string& directory,
                     const wording::Language& language, render::workers::FigureRenderer& renderer,
                     AtomicFiles& files, Console& console);

}  // namespace tribolog::cli
