#include <algorithm>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "report/engine/template_engine.h"
#include "report/timeline/fleet_values.h"
#include "report/timeline/sparkline.h"
#include "wording/number_text.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::timeline {
namespace {

using wording::tr;
using wording::tr_count;

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

bool is_beyond(const std::optional<history::Distance>& d, double limit) {
  return d && std::abs(d->z) > limit;
}

std::string z_text(double z) {
  constexpr double shown_in_full = 100;
  return std::abs(z) > shown_in_full ? tr("beyond 100")
                                     : wording::with_minus_sign(fmt::format("{:.1f}", z));
}

std::string median_text(double median, const statistics::Estimate& latest,
                        const std::string& unit) {
  const statistics::Estimate as_sure{
      median, median - latest.half_width(), median + latest.half_width(), {}};
  return wording::with_unit(wording::round_by_interval(as_sure, {1.0, unit}).estimate, unit);
}

/// "+3.2 %"; empty of an angle, of which a share says nothing: its zero is a convention.
std::string difference_text(double median, const statistics::Estimate& latest,
                            const std::string& unit) {
  constexpr double shown_with_decimal = 10;
  if (unit == "rad" || median == 0) return {};
  const double percent = 100 * std::abs(latest.value / median - 1);
  return fmt::format("{}{:.{}f}\u00a0%", latest.value > median ? "+" : "−", percent,
                     percent < shown_with_decimal ? 1 : 0);
}

std::string words_to_others(const history::Distance& d, const statistics::Estimate& latest,
                            const std::string& unit) {
  const std::string difference = difference_text(d.median, latest, unit);
  const std::initializer_list<StatedValue> values{{"z", z_text(d.z)},
                                                  {"robots", d.count},
                                                  {"median", median_text(d.median, latest, unit)},
                                                  {"difference", difference}};
  return difference.empty()
             ? tr_count(d.count, "z {z} against {robots} other robot, median {median}",
                        "z {z} against {robots} other robots, median {median}", values)
             : tr_count(
                   d.count, "z {z} against {robots} other robot, median {median}, {difference}",
                   "z {z} against {robots} other robots, median {median}, {difference}", values);
}

std::string words_to_history(const history::Distance& d, const statistics::Estimate& latest,
                             const std::string& unit) {
  const std::string difference = difference_text(d.median, latest, unit);
  const std::initializer_list<StatedValue> values{{"z", z_text(d.z)},
                                                  {"earlier", d.count},
                                                  {"median", median_text(d.median, latest, unit)},
                                                  {"difference", difference}};
  return difference.empty()
             ? tr_count(d.count, "z {z} against {earlier} earlier one of its own, median {median}",
                        "z {z} against {earlier} earlier ones of its own, median {median}", values)
             : tr_count(
                   d.count,
                   "z {z} against {earlier} earlier one of its own, median {median}, {difference}",
                   "z {z} against {earlier} earlier ones of its own, median {median}, {difference}",
                   values);
}

void fill_card(const OutlyingJoint& outlying, const history::Fleet& fleet, const FleetLinks& links,
               engine::TemplateValues& values) {
  const history::FleetJoint& joint = *outlying.joint;
  fill_link(links, joint.latest.id, wording::or_dash(joint.latest.facts.of.joint), values);
  values.set("ROBOT", robot_name(outlying.robot->robot, outlying.robot->serial));
  fill_trend_link(links, *outlying.robot, values);
  values.set("ID", joint.latest.id.substr(0, calibration::shown_digits));
  values.set("MEASURED", wording::or_dash(wording::date_of(joint.latest.facts.measured_at)));
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
    engine::TemplateValues& one = values.add_section("QUANTITY");
    one.set("NAME", wording::or_dash(column_name(column)));
    one.set("VALUE", wording::in_words(latest, {1.0, column.unit}));
    one.set_optional("VERDICT", cell->verdict == calibration::Verdict::usable
                                    ? ""
                                    : wording::words_for("archived_verdict",
                                                         calibration::to_string(cell->verdict)));
    if (is_beyond(cell->to_others, fleet.limit)) {
      one.set_optional("OTHERS_WORDS", words_to_others(*cell->to_others, latest, column.unit));
    }
    if (is_beyond(cell->to_history, fleet.limit)) {
      one.set_optional("HISTORY_WORDS", words_to_history(*cell->to_history, latest, column.unit));
    }
    fill_sparkline(*cell, fleet, one);
  }
}

}  // namespace

std::size_t count_outliers(const history::Fleet& fleet) { return outlying_joints(fleet).size(); }

void fill_outliers(const history::Fleet& fleet, const FleetLinks& links,
                   engine::TemplateValues& values) {
  const std::vector<OutlyingJoint> all = outlying_joints(fleet);
  if (all.empty()) return;
  engine::TemplateValues& section = values.add_section("OUTLIERS");
  const std::size_t shown = std::min(all.size(), most_cards);
  for (std::size_t k = 0; k < shown; ++k) {
    fill_card(all[k], fleet, links, section.add_section("CARD"));
  }
  if (shown < all.size()) {
    const std::size_t more = all.size() - shown;
    section.set_optional(
        "MORE",
        tr_count(static_cast<std::int64_t>(more),
                 "{joints} more joint beyond the limit is marked in the table of its robot.",
                 "{joints} more joints beyond the limit are marked in the tables of their robots.",
                 {{"joints", more}}));
  }
}

}  // namespace tribolog::report::timeline
