#include "report/timeline/quantity_names.h"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

#include "calibration/friction_speeds.h"
#include "wording/number_text.h"
#include "wording/rounding.h"
#include "wording/tr.h"

namespace tribolog::report::timeline {

std::string friction_at_speeds(const std::vector<std::string>& names) {
  constexpr std::size_t many = 3;
  std::vector<double> speeds;
  for (const std::string& name : names) {
    if (const auto speed = calibration::speed_of_friction(name)) speeds.push_back(*speed);
  }
  if (speeds.size() < many) return "";
  const auto [lowest, highest] = std::minmax_element(speeds.begin(), speeds.end());
  return wording::tr("friction at {speeds} speeds from {lowest} to {highest}",
                     {{"speeds", speeds.size()},
                      {"lowest", fmt::format("{:g}", *lowest)},
                      {"highest", wording::with_unit(fmt::format("{:g}", *highest), "rad/s")}});
}

std::string listed_quantities(const std::vector<NamedQuantity>& quantities) {
  std::vector<std::string> names;
  for (const NamedQuantity& q : quantities) names.push_back(q.name);
  std::string friction = friction_at_speeds(names);
  const bool is_one = !friction.empty();
  std::vector<std::string> texts;
  for (const NamedQuantity& q : quantities) {
    if (!is_one || !calibration::speed_of_friction(q.name)) {
      texts.push_back(q.text);
    } else if (!friction.empty()) {
      texts.push_back(std::move(friction));
      friction.clear();
    }
  }
  return wording::listed(texts);
}

}  // namespace tribolog::report::timeline
