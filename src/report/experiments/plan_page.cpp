#include "report/experiments/plan_page.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "exports/experiment/plan_files.h"
#include "exports/experiment/plan_table.h"
#include "joint/degrees.h"
#include "report/elements/element_values.h"
#include "report/elements/elements.h"
#include "report/elements/figure_cards.h"
#include "report/engine/page_style.h"
#include "report/engine/template_engine.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::experiments {
namespace {

using wording::tr;
using wording::tr_count;

elements::Table parts_table(const plan::ExperimentPlan& plan) {
  elements::Table table;
  table.id = "table-parts";
  table.is_stacked = true;
  table.caption = tr("Its parts, in order");
  table.columns = {{tr("Part"), "", false},
                   {tr("State"), "", false},
                   {tr("Recordings"), "", true},
                   {tr("Time"), "", true},
                   {tr("What to do"), "", false, true},
                   {tr("What it gives"), "", false, true}};
  for (const plan::PlannedPart& part : plan.parts) {
    const bool is_there = part.recordings > 0;
    table.rows.push_back(
        {{wording::capitalised(exports::experiment::part_title(part.role)),
          wording::words(plan::stated(part.state)), is_there ? std::to_string(part.recordings) : "",
          is_there ? exports::experiment::duration_text(part.duration_s) : "",
          part.motion.empty() ? "" : wording::capitalised(part.motion),
          wording::capitalised(part.gives)},
         false});
  }
  return table;
}

elements::Table positions_table(const plan::ExperimentPlan& plan) {
  elements::Table table;
  table.id = "table-positions";
  table.caption = tr("Centres of the oscillations");
  table.columns = {{tr("Position"), "", true},
                   {tr("Joint"), "°", true},
                   {tr("Motor, from the first"), "°", true}};
  for (std::size_t k = 0; k < plan.positions_rad.size(); ++k) {
    const double away = plan.positions_rad[k] - plan.positions_rad.front();
    table.rows.push_back(
        {{std::to_string(k + 1), wording::fixed(plan.positions_rad[k] * joint::degrees_per_rad, 4),
          wording::fixed(away * plan.joint.facts.gear_ratio * joint::degrees_per_rad, 1)},
         false});
  }
  constexpr double nothing = 5e-4;
  table.note = tr("Torque ripple is a constant over one oscillation.") + " " +
               (plan.ripple_left_share < nothing
                    ? tr("In the mean over these positions nothing remains of the amplitude of any "
                         "known or assumed period.")
                    : tr("In the mean over these positions {left_percent:.1f} % of the amplitude "
                         "of any known or assumed period remains.",
                         {{"left_percent", 100 * plan.ripple_left_share}}));
  return table;
}

elements::Table segments_table(const plan::ExperimentPlan& plan) {
  elements::Table table;
  table.id = "table-windows";
  table.caption = tr("Recordings and their time windows");
  table.columns = {{tr("Recording"), "", false, true},
                   {tr("Role"), "", false},
                   {tr("From"), "s", true},
                   {tr("To"), "s", true},
                   {tr("Joint angle"), "°", true}};
  constexpr int decimals = 3;
  for (const plan::PlannedSegment& s : plan.segments) {
    if (!s.role) continue;
    table.rows.push_back(
        {{wording::capitalised(s.name), joint::to_string(*s.role),
          wording::fixed(s.from_s, decimals), wording::fixed(s.to_s, decimals),
          wording::fixed(plan.angle_rad(s.from_s) * joint::degrees_per_rad, decimals)},
         false});
  }
  table.note = tr("As in dataset.toml; the angle is that at the start of the window.");
  return table;
}

elements::Table expected_table(const plan::ExpectedIntervals& expected) {
  elements::Table table;
  table.id = "table-expected";
  table.is_stacked = true;
  table.caption = tr("Intervals to expect, by simulation");
  table.columns = {{tr("Quantity"), "", false, true},
                   {tr("95 % interval to expect"), "", true},
                   {tr("Scatter of the estimates"), "", true},
                   {tr("Identified"), "", true},
                   {tr("Interval contains the true value"), "", true}};
  for (const plan::ExpectedInterval& e : expected.quantities) {
    table.rows.push_back({{wording::capitalised(wording::words_for("expected", to_string(e.name))),
                           exports::experiment::interval_text(e.truth, e.half_width, e.quantity),
                           exports::experiment::quantity_text(e.scatter, e.quantity, 2),
                           tr("{runs} of {all_runs}", {{"runs", e.found}, {"all_runs", e.runs}}),
                           tr("{runs} of {all_runs}", {{"runs", e.inside}, {"all_runs", e.found}})},
                          e.name == truth::ReadingName::midline});
  }
  table.note =
      tr_count(static_cast<std::int64_t>(expected.runs),
               "{runs} simulation of this plan on the assumed joint at the assumed noise, each "
               "identified.",
               "{runs} simulations of this plan on the assumed joint at the assumed noise, each "
               "identified.",
               {{"runs", expected.runs}}) +
      " " +
      tr("The value is the assumed one; the interval is the median stated half width, in closed "
         "form; the scatter is the standard deviation of the estimates, about half the interval if "
         "its coverage is right. A real joint adds effects that no model contains.");
  return table;
}

elements::Table assumptions_table(const plan::AssumedJoint& joint) {
  elements::Table table;
  table.id = "table-assumptions";
  table.caption = tr("What the plan is based on");
  table.columns = {
      {tr("Quantity"), "", false, true}, {tr("Value"), "", true}, {tr("From"), "", false, true}};
  constexpr int digits = 6;
  for (const plan::Assumption& a : joint.assumptions) {
    const std::string shown = wording::with_minus_sign(fmt::format("{:.{}g}", a.value, digits));
    const std::string unit = a.unit.empty() || a.unit == "°" ? a.unit : " " + a.unit;
    table.rows.push_back(
        {{wording::words(a.what), shown + unit,
          a.is_known ? wording::words(a.source) : tr("assumed: {reason}", {{"reason", a.source}})},
         false});
  }
  return table;
}

std::vector<elements::Fact> facts_of(const plan::ExperimentPlan& plan) {
  const joint::JointFacts& f = plan.joint.facts;
  const auto deg = [](double rad) {
    return wording::with_minus_sign(fmt::format("{:.4g}", rad * joint::degrees_per_rad));
  };
  return {{tr("Robot"), wording::or_dash(f.robot)},
          {tr("Joint"), wording::or_dash(f.joint)},
          {tr("Gear ratio"), fmt::format("{:.6g}", f.gear_ratio)},
          {tr("Angle limits"), tr("{lowest}° to {highest}°", {{"lowest", deg(f.lowest_rad)},
                                                              {"highest", deg(f.highest_rad)}})},
          {tr("Speed limit"), deg(f.speed_limit_rad_s) + "°/s"},
          {tr("Acceleration limit"), deg(f.acceleration_limit_rad_s2) + "°/s²"},
          {tr("Torque limit at the motor"), fmt::format("{:.4g} N·m", f.torque_limit_Nm)},
          {tr("Time budget"), f.time_budget_s ? exports::experiment::duration_text(*f.time_budget_s)
                                              : tr("none stated")}};
}

void fill_verdict(const plan::ExperimentPlan& plan, engine::TemplateValues& values) {
  engine::TemplateValues& verdict = values.add_include("VERDICT", "verdict.tpl");
  const bool is_all = std::all_of(plan.parts.begin(), plan.parts.end(),
                                  [](const plan::PlannedPart& p) { return p.is_as_asked(); });
  const elements::Outcome outcome = plan.segments.empty()            ? elements::Outcome::bad
                                    : is_all && plan.remarks.empty() ? elements::Outcome::good
                                                                     : elements::Outcome::partial;
  verdict.set("WORD", plan.segments.empty()                ? tr("NOT POSSIBLE")
                      : plan.is_first_of_two()             ? tr("FIRST PART OF TWO")
                      : outcome == elements::Outcome::good ? tr("PLAN")
                                                           : tr("PLAN, WITH LIMITS"));
  verdict.set("SENTENCE", wording::as_sentence(exports::experiment::plan_sentence(plan)));
  elements::fill_outcome(outcome, verdict);
  engine::TemplateValues& findings = verdict.add_section("FINDINGS");
  const auto add = [&](const std::string& text) {
    findings.add_section("FINDING").set("TEXT", text);
  };
  for (const plan::PlannedPart& part : plan.parts) {
    if (part.why.empty() || part.state == plan::PartState::later) continue;
    add(tr("{part}: {state}: {reason}. What would help: {help}.",
           {{"part", wording::capitalised(exports::experiment::part_title(part.role))},
            {"state", plan::stated(part.state)},
            {"reason", part.why},
            {"help", part.help}}));
  }
  if (plan.is_first_of_two()) add(wording::as_sentence(exports::experiment::next_plan_words()));
  for (const Statement& remark : plan.remarks) add(wording::as_sentence(remark));
}

}  // namespace

std::string plan_page(const PlanReport& report, const std::vector<figures::ReportFigure>& figures,
                      const std::vector<render::workers::DrawnFigure>& drawn,
                      wording::Language language) {
  const plan::ExperimentPlan& plan = report.plan;
  engine::TemplateValues values;
  engine::fill_head(report.provenance, values);
  values.set("JOINT_FILE", wording::or_dash(report.joint_file));
  values.set("JOINT_TEXT", wording::or_dash(report.joint_text));
  values.set("TITLE",
             tr("{robot}, joint {joint}", {{"robot", wording::or_dash(plan.joint.facts.robot)},
                                           {"joint", wording::or_dash(plan.joint.facts.joint)}}));
  elements::fill_facts(facts_of(plan), values);
  fill_verdict(plan, values);
  elements::fill_table(parts_table(plan), "PARTS", values);
  // The plan as a whole in sight, its details behind a click.
  const std::vector<elements::FigureCard> cards = elements::figure_cards(figures, drawn);
  if (!cards.empty()) elements::fill_figure(cards.front(), values.add_section("OVERVIEW"));
  if (cards.size() > 1) {
    engine::TemplateValues& details = values.add_section("DETAILS");
    for (std::size_t k = 1; k < cards.size(); ++k) elements::fill_figure(cards[k], details);
  }
  if (!plan.segments.empty()) {
    engine::TemplateValues& how = values.add_section("HOW");
    for (const std::string& text : exports::experiment::plan_instructions(plan)) {
      how.add_section("INSTRUCTION").set("TEXT", text);
    }
    elements::fill_table(segments_table(plan), "WINDOWS", how);
    elements::fill_table(positions_table(plan), "POSITIONS", how);
  }
  if (!report.expected.quantities.empty()) {
    elements::fill_table(expected_table(report.expected), "EXPECTED",
                         values.add_section("EXPECTATION"));
  }
  elements::fill_table(assumptions_table(plan.joint), "ASSUMPTIONS", values);
  values.set_checked_by_modifier(
      "RESULT_JSON", exports::experiment::plan_json(plan, report.expected, report.provenance));
  return engine::expand_template("plan.tpl", values, language);
}

}  // namespace tribolog::report::experiments
