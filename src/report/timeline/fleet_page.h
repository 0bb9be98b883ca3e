#pragma once
// The fleet sheet: all joints on one page, outliers first. One HTML file; its script sorts and
// finds, and without it nothing is missing.

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "calibration/provenance.h"
#include "history/fleet.h"
#include "history/joint_trend.h"
#include "wording/language.h"

namespace tribolog::report::timeline {

/// Where the reports and trends are that were written with the page, or lay beside it.
struct FleetLinks {
  std::set<std::string> ids;  ///< Of the latest calibrations that have one in `directory`.
  std::string directory;      ///< From the page; "reports". Names are any bytes.
  std::map<std::string, std::string> found{};  ///< Of others by id; the file, from the page.
  /// Pages with the trends of a robot's joints, by robot and serial number; from the page.
  std::map<std::pair<std::string, std::string>, std::string> trends{};

  /// The link to a report. @return empty: there is none.
  [[nodiscard]] std::string href(const std::string& id) const;
  /// The link to a robot's trends. @return empty: there is none.
  [[nodiscard]] std::string trend_href(const history::FleetRobot& robot) const;
};

/// Cards of the page; joints beyond them stand in their robot's table alone.
inline constexpr std::size_t most_cards = 120;

/// @param trends of the same joints: those that change are listed first. @param archive its name,
/// to show.
std::string fleet_page(const history::Fleet& fleet, const std::vector<history::JointTrend>& trends,
                       const FleetLinks& links, const std::string& archive,
                       const calibration::Provenance& provenance,
                       wording::Language language = wording::Language{});

}  // namespace tribolog::report::timeline
