#pragma once
// Internal to the fleet sheet: values of its templates.

#include <string>

#include "report/fleet_page.h"
#include "report/template_engine.h"

namespace tribolog::archive {

/// BAND, OTHERS, HISTORY and LATEST of a sparkline.
void fill_sparkline(const FleetCell& cell, const Fleet& fleet, report::TemplateValues& values);

/// LINK with HREF and TEXT, or NO_LINK with TEXT.
void fill_link(const FleetLinks& links, const std::string& id, const std::string& text,
               report::TemplateValues& values);

/// The section OUTLIERS with its cards; nothing where there is no outlier.
void fill_outliers(const Fleet& fleet, const FleetLinks& links, report::TemplateValues& values);

/// "R1 · S1"
std::string robot_name(const std::string& robot, const std::string& serial);

/// Joints beyond the limit.
std::size_t count_outliers(const Fleet& fleet);

}  // namespace tribolog::archive
