#include "report/timeline/fleet_page.h"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

#include "calibration/archived_calibration.h"
#include "figures/timeline/history_axes.h"
#include "report/elements/element_values.h"
#include "report/elements/elements.h"
#include "report/elements/result_words.h"
#include "report/engine/page_style.h"
#include "report/engine/template_engine.h"
#include "report/timeline/fleet_values.h"
#include "report/timeline/sparkline.h"
#include "report/timeline/trend_page.h"
#include "wording/number_text.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::timeline {
namespace {

using wording::tr;
using wording::tr_count;

/// SVG path data that draws nothing.
constexpr char no_path[] = "M0 0";

std::string or_nothing(const std::string& path) { return path.empty() ? no_path : path; }

void fill_cell(const history::FleetCell& cell, const history::Fleet& fleet,
               engine::TemplateValues& values) {
  const history::FleetColumn& column = fleet.columns[cell.column];
  const statistics::Estimate& latest = cell.results.back().estimate;
  const std::string name = wording::or_dash(column_name(column));
  values.set("NAME", column.unit.empty() ? name : name + " [" + column.unit + "]");
  values.set("VALUE", wording::round_by_interval(latest, {1.0, column.unit}).estimate);
  if (cell.furthest() > fleet.limit) {
    values.set_optional("KIND", "out");
  } else if (cell.verdict != calibration::Verdict::usable) {
    values.set_optional("KIND", "doubt");
  }
  fill_sparkline(cell, fleet, values);
}

void fill_joint(const history::FleetJoint& joint, const history::Fleet& fleet,
                const FleetLinks& links, engine::TemplateValues& values) {
  fill_link(links, joint.latest.id, wording::or_dash(joint.latest.facts.of.joint), values);
  values.set("ID", joint.latest.id.substr(0, calibration::shown_digits));
  values.set("DAY", wording::or_dash(wording::date_of(joint.latest.facts.measured_at)));
  if (joint.decision) {
    values.set_optional("DECISION", wording::words_for("archived_decision",
                                                       calibration::to_string(*joint.decision)));
  }
  std::size_t column = 0;
  const auto leave_out_before = [&](std::size_t next) {
    for (; column < next; ++column) values.add_section("CELL").add_section("EMPTY");
  };
  for (const history::FleetCell& cell : joint.cells) {
    leave_out_before(cell.column);
    fill_cell(cell, fleet, values.add_section("CELL").add_section("FULL"));
    ++column;
  }
  leave_out_before(fleet.columns.size());
}

engine::TemplateValues& add_table(const history::Fleet& fleet, engine::TemplateValues& values) {
  engine::TemplateValues& table = values.add_section("TABLE");
  for (const history::FleetColumn& column : fleet.columns) {
    engine::TemplateValues& head = table.add_section("HEAD");
    head.set("WORDS", wording::or_dash(column_name(column)));
    head.set("UNIT", wording::or_dash(column.unit));
  }
  return table;
}

/// One table where it is not long; a browser lays out those in sight alone.
void fill_tables(const history::Fleet& fleet, const FleetLinks& links,
                 engine::TemplateValues& values) {
  constexpr std::size_t most_rows = 60;
  engine::TemplateValues* table = nullptr;
  std::size_t rows = 0;
  for (const history::FleetRobot& robot : fleet.robots) {
    const std::string trend = links.trend_href(robot);
    for (const history::FleetJoint& joint : robot.joints) {
      if (rows % most_rows == 0) table = &add_table(fleet, values);
      ++rows;
      engine::TemplateValues& row = table->add_section("JOINT");
      engine::TemplateValues& name = row.add_section(trend.empty() ? "NO_TREND" : "TREND");
      if (!trend.empty()) name.set("HREF", trend);
      name.set("ROBOT", robot_name(robot.robot, robot.serial));
      fill_joint(joint, fleet, links, row);
    }
  }
}

std::vector<elements::Fact> facts_of(const history::Fleet& fleet, const std::string& archive,
                                     std::size_t outliers) {
  std::string from;
  std::string to;
  for (const history::FleetRobot& robot : fleet.robots) {
    for (const history::FleetJoint& joint : robot.joints) {
      const std::string at = wording::date_of(joint.latest.facts.measured_at);
      if (from.empty() || at < from) from = at;
      to = std::max(to, at);
    }
  }
  const std::string latest =
      from.empty() ? tr("none")
      : from == to ? from
                   : tr("{first_date} to {last_date}", {{"first_date", from}, {"last_date", to}});
  return {{tr("Archive"), archive},
          {tr("Robots"), wording::count(fleet.robots.size())},
          {tr("Joints"), wording::count(fleet.joints)},
          {tr("Calibrations"), wording::count(fleet.calibrations)},
          {tr("Latest ones"), latest},
          {tr("Joints that stand out"), wording::count(outliers)}};
}

struct FleetOutcome {
  std::string word;
  std::string sentence;
  elements::Outcome outcome;
};

FleetOutcome outcome_of_outliers(const history::Fleet& fleet, std::size_t outliers) {
  if (fleet.distances == 0) {
    return {tr("NOTHING TO COMPARE"),
            tr("A joint is compared with at least {others} of the same name on other robots, or "
               "{earlier} earlier calibrations of its own.",
               {{"others", history::fewest_others}, {"earlier", history::fewest_earlier}}),
            elements::Outcome::absent};
  }
  if (outliers == 0) {
    return {tr("NO OUTLIER"),
            tr("No joint of {joints} stands out from the others or from its own history.",
               {{"joints", fleet.joints}}),
            elements::Outcome::good};
  }
  return {tr("OUTLIERS"),
          tr_count(static_cast<std::int64_t>(outliers),
                   "{outliers} of {joints} joints stands out from the others or from its own "
                   "history.",
                   "{outliers} of {joints} joints stand out from the others or from their own "
                   "history.",
                   {{"outliers", outliers}, {"joints", fleet.joints}}),
          elements::Outcome::partial};
}

/// Those that change over time come first: one that wears need not be far from the others yet.
FleetOutcome outcome_of(const history::Fleet& fleet, std::size_t outliers, std::size_t changing) {
  FleetOutcome found = outcome_of_outliers(fleet, outliers);
  if (changing == 0) return found;
  found.word = tr("CHANGES");
  found.sentence = tr_count(static_cast<std::int64_t>(changing),
                            "{changing} of {joints} joints changes over time.",
                            "{changing} of {joints} joints change over time.",
                            {{"changing", changing}, {"joints", fleet.joints}}) +
                   (fleet.distances == 0 ? "" : " " + found.sentence);
  found.outcome = elements::Outcome::partial;
  return found;
}

std::vector<const history::JointTrend*> changing_joints(
    const std::vector<history::JointTrend>& trends) {
  std::vector<const history::JointTrend*> changing;
  for (const history::JointTrend& trend : trends) {
    if (trend.state() == history::TrendState::warning) changing.push_back(&trend);
  }
  return changing;
}

void fill_changes(const std::vector<const history::JointTrend*>& changing,
                  engine::TemplateValues& values) {
  if (changing.empty()) return;
  engine::TemplateValues& section = values.add_section("CHANGES");
  for (std::size_t k = 0; k < std::min(changing.size(), most_cards); ++k) {
    const history::JointTrend& trend = *changing[k];
    engine::TemplateValues& one = section.add_section("CHANGE");
    one.set("ROBOT", robot_name(trend.of.robot, trend.of.serial));
    one.set("JOINT", wording::or_dash(trend.of.joint));
    one.set("TEXT", change_sentences(trend).front());
  }
  if (changing.size() <= most_cards) return;
  section.set_optional("MORE", tr("And {joints} more; each robot's trends have them.",
                                  {{"joints", changing.size() - most_cards}}));
}

void fill_outcome_of(const history::Fleet& fleet, std::size_t outliers, std::size_t changing,
                     engine::TemplateValues& values) {
  engine::TemplateValues& verdict = values.add_include("VERDICT", "verdict.tpl");
  const FleetOutcome found = outcome_of(fleet, outliers, changing);
  verdict.set("WORD", found.word);
  verdict.set("SENTENCE", found.sentence);
  elements::fill_outcome(found.outcome, verdict);
}

}  // namespace

std::string FleetLinks::href(const std::string& id) const {
  if (ids.count(id) > 0) return elements::link_to(directory + "/" + id + ".html");
  const auto file = found.find(id);
  return file == found.end() ? "" : elements::link_to(file->second);
}

std::string FleetLinks::trend_href(const history::FleetRobot& robot) const {
  const auto file = trends.find({robot.robot, robot.serial});
  return file == trends.end() ? "" : elements::link_to(file->second);
}

std::string column_name(const history::FleetColumn& column) {
  const std::string bare = calibration::without_side(column.words);
  return bare != column.words ? wording::words_for("quantity_without_side", column.name, bare)
                              : figures::timeline::quantity_words(column.name, bare);
}

std::string robot_name(const std::string& robot, const std::string& serial) {
  return serial.empty() ? wording::or_dash(robot) : wording::or_dash(robot) + " · " + serial;
}

void fill_sparkline(const history::FleetCell& cell, const history::Fleet& fleet,
                    engine::TemplateValues& values) {
  const Sparkline line = sparkline_of(cell, fleet);
  values.set("BAND", or_nothing(line.band));
  values.set("OTHERS", or_nothing(line.others));
  values.set("HISTORY", line.history);
  values.set("LATEST", line.latest);
}

void fill_link(const FleetLinks& links, const std::string& id, const std::string& text,
               engine::TemplateValues& values) {
  const std::string href = links.href(id);
  engine::TemplateValues& link = values.add_section(href.empty() ? "NO_LINK" : "LINK");
  if (!href.empty()) link.set("HREF", href);
  link.set("TEXT", text);
}

void fill_trend_link(const FleetLinks& links, const history::FleetRobot& robot,
                     engine::TemplateValues& values) {
  const std::string href = links.trend_href(robot);
  if (!href.empty()) values.add_section("TREND").set("HREF", href);
}

std::string fleet_page(const history::Fleet& fleet, const std::vector<history::JointTrend>& trends,
                       const FleetLinks& links, const std::string& archive,
                       const calibration::Provenance& provenance, wording::Language language) {
  const wording::WordsIn words(language);
  engine::TemplateValues values;
  engine::fill_head(provenance, values, engine::PageKind::fleet);
  engine::allow_script(values, engine::PageKind::fleet);
  const std::size_t outliers = count_outliers(fleet);
  elements::fill_facts(facts_of(fleet, archive, outliers), values);
  const std::vector<const history::JointTrend*> changing = changing_joints(trends);
  fill_outcome_of(fleet, outliers, changing.size(), values);
  fill_changes(changing, values);
  fill_outliers(fleet, links, values);
  values.set("LIMIT", fmt::format("{:.2f}", fleet.limit));
  values.set("DISTANCES", wording::count(fleet.distances));
  values.set("OTHERS_NEEDED", std::to_string(history::fewest_others));
  values.set("EARLIER_NEEDED", std::to_string(history::fewest_earlier));
  fill_tables(fleet, links, values);
  return engine::expand_template("fleet.tpl", values, language);
}

}  // namespace tribolog::report::timeline
