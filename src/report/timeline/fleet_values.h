#pragma once
// Internal to the fleet sheet: values of its templates.

#include <string>

#include "report/engine/template_engine.h"
#include "report/timeline/fleet_page.h"

namespace tribolog::report::timeline {

/// BAND, OTHERS, HISTORY and LATEST of a sparkline.
void fill_sparkline(const history::FleetCell& cell, const history::Fleet& fleet,
                    engine::TemplateValues& values);

/// LINK with HREF and TEXT, or NO_LINK with TEXT.
void fill_link(const FleetLinks& links, const std::string& id, const std::string& text,
               engine::TemplateValues& values);

/// The section TREND with its HREF, where the robot has a page of trends.
void fill_trend_link(const FleetLinks& links, const history::FleetRobot& robot,
                     engine::TemplateValues& values);

/// The section OUTLIERS with its cards; nothing where there is no outlier.
void fill_outliers(const history::Fleet& fleet, const FleetLinks& links,
                   engine::TemplateValues& values);

/// "Inertia": the side of the gear stands beside it.
std::string column_name(const history::FleetColumn& column);

/// "R1 · S1"
std::string robot_name(const std::string& robot, const std::string& serial);

/// Joints beyond the limit.
std::size_t count_outliers(const history::Fleet& fleet);

}  // namespace tribolog::report::timeline
