#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "calibration/gear_side.h"
#include "report/fleet_values.h"
#include "report/sparkline.h"
#include "report/view_parts.h"
#include "wording/rounding.h"

namespace tribolog::report {
namespace {

struct OutlyingJoint {
  const history::FleetRobot* robot;
  const history::FleetJoint* joint;
};

std::vector<OutlyingJoint> outlying_joints(const history::Fleet& fleet) {
  std::vector<OutlyingJoint> all;
  for (const history::FleetRobot& robot : fleet.robots) {
    for (const history::FleetJoint& joint : robot.joints) {
      if (joint.furthest > fleet.limit) all.push_back({&robot, &joint});
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const OutlyingJoint& a, const OutlyingJoint& b) {
    return a.joint->furthest > b.joint->furthest;
  });
  return all;
}

std::string distance_words(const std::optional<history::Distance>& d, const std::string& of,
                           const statistics::Estimate& latest, const std::string& unit,
                           double limit) {
  if (!d || std::abs(d->z) <= limit) return "";
  constexpr double shown_in_full = 100;
  constexpr double shown_with_decimal = 10;
  const statistics::Estimate median{
      d->median, d->median - latest.half_width(), d->median + latest.half_width(), {}};
  const std::string z = std::abs(d->z) > shown_in_full
                            ? std::string("beyond 100")
                            : wording::with_minus_sign(fmt::format("{:.1f}", d->z));
  // A share of an angle says nothing: its zero is a convention.
  std::string share;
  if (unit != "rad" && d->median != 0) {
    const double percent = 100 * std::abs(latest.value / d->median - 1);
    share = fmt::format(", {}{:.{}f}\u00a0%", latest.value > d->median ? "+" : "−", percent,
                        percent < shown_with_decimal ? 1 : 0);
  }
  return fmt::format(
      "z {} against {} {}, median {}{}", z, d->count, of,
      wording::with_unit(wording::round_by_interval(median, {1.0, unit}).estimate, unit), share);
}

void fill_card(const OutlyingJoint& outlying, const history::Fleet& fleet, const FleetLinks& links,
               TemplateValues& values) {
  const history::FleetJoint& joint = *outlying.joint;
  fill_link(links, joint.latest.id, or_dash(joint.latest.facts.of.joint), values);
  values.set("ROBOT", robot_name(outlying.robot->robot, outlying.robot->serial));
  values.set("ID", joint.latest.id.substr(0, calibration::shown_digits));
  values.set("MEASURED", or_dash(joint.latest.facts.measured_at));
  std::vector<const history::FleetCell*> cells;
  for (const history::FleetCell& cell : joint.cells) {
    if (cell.furthest() > fleet.limit) cells.push_back(&cell);
  }
  std::stable_sort(cells.begin(), cells.end(),
                   [](const history::FleetCell* a, const history::FleetCell* b) {
                     return a->furthest() > b->furthest();
                   });
  for (const history::FleetCell* cell : cells) {
    const history::FleetColumn& column = fleet.columns[cell->column];
    const statistics::Estimate& latest = cell->results.back().estimate;
    TemplateValues& one = values.add_section("QUANTITY");
    one.set("NAME", or_dash(calibration::without_side(column.words)));
    one.set("VALUE", wording::in_words(latest, {1.0, column.unit}));
    one.set_optional("VERDICT", cell->verdict == calibration::Verdict::usable
                                    ? ""
                                    : calibration::to_string(cell->verdict));
    one.set_optional("OTHERS_WORDS", distance_words(cell->to_others, "other robots", latest,
                                                    column.unit, fleet.limit));
    one.set_optional("HISTORY_WORDS", distance_words(cell->to_history, "earlier ones of its own",
                                                     latest, column.unit, fleet.limit));
    fill_sparkline(*cell, fleet, one);
  }
}

}  // namespace

std::size_t count_outliers(const history::Fleet& fleet) { return outlying_joints(fleet).size(); }

void fill_outliers(const history::Fleet& fleet, const FleetLinks& links, TemplateValues& values) {
  const std::vector<OutlyingJoint> all = outlying_joints(fleet);
  if (all.empty()) return;
  TemplateValues& section = values.add_section("OUTLIERS");
  const std::size_t shown = std::min(all.size(), most_cards);
  for (std::size_t k = 0; k < shown; ++k) {
    fill_card(all[k], fleet, links, section.add_section("CARD"));
  }
  if (shown < all.size()) {
    section.set_optional("MORE", fmt::format("{} more joints beyond the limit are marked in the "
                                             "tables of their robots.",
                                             all.size() - shown));
  }
}

}  // namespace tribolog::report
