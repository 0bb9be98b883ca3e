#include "report/plan_page.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "exports/experiment/plan_files.h"
#include "exports/experiment/plan_table.h"
#include "joint/degrees.h"
#include "report/element_values.h"
#include "report/page_style.h"
#include "report/view_parts.h"
#include "wording/rounding.h"

namespace tribolog::report {
namespace {

std::string capital(const std::string& words) {
  const std::string sentence = as_sentence(words);
  return sentence.substr(0, sentence.size() - 1);
}

Table parts_table(const plan::ExperimentPlan& plan) {
  Table table;
  table.id = "table-parts";
  table.is_stacked = true;
  table.caption = "Its parts, in their order";
  table.columns = {{"Part", "", false},
                   {"State", "", false},
                   {"Recordings", "", true},
                   {"Time", "", true},
                   {"What to do", "", false, true},
                   {"What it gives", "", false, true}};
  for (const plan::PlannedPart& part : plan.parts) {
    const bool is_there = part.recordings > 0;
    table.rows.push_back(
        {{capital(exports::experiment::part_title(part.role)), plan::to_string(part.state),
          is_there ? std::to_string(part.recordings) : "",
          is_there ? exports::experiment::duration_text(part.duration_s) : "",
          part.motion.empty() ? "" : capital(part.motion), capital(part.gives)},
         false});
  }
  return table;
}

Table positions_table(const plan::ExperimentPlan& plan) {
  Table table;
  table.id = "table-positions";
  table.caption = "Centres of the oscillations";
  table.columns = {
      {"Position", "", true}, {"Joint", "°", true}, {"Motor, from the first", "°", true}};
  for (std::size_t k = 0; k < plan.positions_rad.size(); ++k) {
    const double away = plan.positions_rad[k] - plan.positions_rad.front();
    table.rows.push_back(
        {{std::to_string(k + 1), wording::fixed(plan.positions_rad[k] * joint::degrees_per_rad, 4),
          wording::fixed(away * plan.joint.facts.gear_ratio * joint::degrees_per_rad, 1)},
         false});
  }
  constexpr double nothing = 5e-4;
  const std::string left = plan.ripple_left_share < nothing
                               ? "nothing"
                               : wording::fixed(100 * plan.ripple_left_share, 1) + " %";
  table.note = fmt::format(
      "Torque ripple is a constant over one oscillation. In the mean over these positions {} of "
      "the amplitude of any period known or assumed is left.",
      left);
  return table;
}

Table segments_table(const plan::ExperimentPlan& plan) {
  Table table;
  table.id = "table-windows";
  table.caption = "Recordings and their time windows";
  table.columns = {{"Recording", "", false, true},
                   {"Role", "", false},
                   {"From", "s", true},
                   {"To", "s", true},
                   {"Joint angle", "°", true}};
  constexpr int decimals = 3;
  for (const plan::PlannedSegment& s : plan.segments) {
    if (!s.role) continue;
    table.rows.push_back(
        {{capital(s.name), joint::to_string(*s.role), wording::fixed(s.from_s, decimals),
          wording::fixed(s.to_s, decimals),
          wording::fixed(plan.angle_rad(s.from_s) * joint::degrees_per_rad, decimals)},
         false});
  }
  table.note = "As in dataset.toml; the angle is that at the start of the window.";
  return table;
}

Table expected_table(const plan::ExpectedIntervals& expected) {
  Table table;
  table.id = "table-expected";
  table.is_stacked = true;
  table.caption = "Intervals to expect, by simulation";
  table.columns = {{"Quantity", "", false, true},
                   {"95 % interval to expect", "", true},
                   {"Scatter that came back", "", true},
                   {"Identified", "", true},
                   {"Interval holds the truth", "", true}};
  for (const plan::ExpectedInterval& e : expected.quantities) {
    table.rows.push_back(
        {{capital(e.words), exports::experiment::interval_text(e.truth, e.half_width, e.quantity),
          exports::experiment::quantity_text(e.scatter, e.quantity, 2),
          fmt::format("{} of {}", e.found, e.runs), fmt::format("{} of {}", e.inside, e.found)},
         e.name == "midline"});
  }
  table.note = fmt::format(
      "{} simulations of this plan on the assumed joint at the assumed noise, each identified. The "
      "value is the assumed one, the "
      "interval is the median half width of those stated, in closed form; the scatter is the "
      "standard deviation of the estimates, about half the interval where that is honest. A real "
      "joint adds what no model has in it.",
      expected.runs);
  return table;
}

Table assumptions_table(const plan::AssumedJoint& joint) {
  Table table;
  table.id = "table-assumptions";
  table.caption = "What the plan rests on";
  table.columns = {{"Quantity", "", false, true}, {"Value", "", true}, {"From", "", false, true}};
  constexpr int digits = 6;
  for (const plan::Assumption& a : joint.assumptions) {
    const std::string shown = wording::with_minus_sign(fmt::format("{:.{}g}", a.value, digits));
    const std::string unit = a.unit.empty() || a.unit == "°" ? a.unit : " " + a.unit;
    table.rows.push_back(
        {{a.what, shown + unit, a.is_known ? a.source : "assumed: " + a.source}, false});
  }
  return table;
}

std::vector<Fact> facts_of(const plan::ExperimentPlan& plan) {
  const joint::JointFacts& f = plan.joint.facts;
  const auto deg = [](double rad) {
    return wording::with_minus_sign(fmt::format("{:.4g}", rad * joint::degrees_per_rad));
  };
  return {{"Robot", or_dash(f.robot)},
          {"Joint", or_dash(f.joint)},
          {"Gear ratio", fmt::format("{:.6g}", f.gear_ratio)},
          {"Angle limits", deg(f.lowest_rad) + "° to " + deg(f.highest_rad) + "°"},
          {"Speed limit", deg(f.speed_limit_rad_s) + "°/s"},
          {"Acceleration limit", deg(f.acceleration_limit_rad_s2) + "°/s²"},
          {"Torque limit at the motor", fmt::format("{:.4g} N·m", f.torque_limit_Nm)},
          {"Time budget",
           f.time_budget_s ? exports::experiment::duration_text(*f.time_budget_s) : "none stated"}};
}

void fill_verdict(const plan::ExperimentPlan& plan, TemplateValues& values) {
  TemplateValues& verdict = values.add_include("VERDICT", "verdict.tpl");
  const bool is_all =
      std::all_of(plan.parts.begin(), plan.parts.end(),
                  [](const plan::PlannedPart& p) { return p.state == plan::PartState::planned; });
  const Outcome outcome = plan.segments.empty()            ? Outcome::bad
                          : is_all && plan.remarks.empty() ? Outcome::good
                                                           : Outcome::partial;
  verdict.set("WORD", plan.segments.empty()      ? "NOT POSSIBLE"
                      : plan.is_first_of_two()   ? "FIRST PART OF TWO"
                      : outcome == Outcome::good ? "PLAN"
                                                 : "PLAN, WITH LIMITS");
  verdict.set("SENTENCE", as_sentence(exports::experiment::plan_sentence(plan)));
  fill_outcome(outcome, verdict);
  TemplateValues& findings = verdict.add_section("FINDINGS");
  const auto add = [&](const std::string& text) {
    findings.add_section("FINDING").set("TEXT", text);
  };
  for (const plan::PlannedPart& part : plan.parts) {
    if (part.why.empty() || part.state == plan::PartState::later) continue;
    add(fmt::format("{}: {}: {}. What would help: {}.",
                    capital(exports::experiment::part_title(part.role)),
                    plan::to_string(part.state), part.why, part.help));
  }
  if (plan.is_first_of_two()) add(as_sentence(exports::experiment::next_plan_words()));
  for (const std::string& remark : plan.remarks) add(as_sentence(remark));
}

}  // namespace

std::string plan_page(const PlanReport& report, const std::vector<figures::ReportFigure>& figures,
                      const std::vector<render::workers::DrawnFigure>& drawn,
                      wording::Language language) {
  const plan::ExperimentPlan& plan = report.plan;
  TemplateValues values;
  fill_head(report.provenance, values);
  values.set("JOINT_FILE", or_dash(report.joint_file));
  values.set("JOINT_TEXT", or_dash(report.joint_text));
  values.set("TITLE", fmt::format("{}, joint {}", or_dash(plan.joint.facts.robot),
                                  or_dash(plan.joint.facts.joint)));
  fill_facts(facts_of(plan), values);
  fill_verdict(plan, values);
  fill_table(parts_table(plan), "PARTS", values);
  for (const FigureCard& card : figure_cards(figures, drawn)) fill_figure(card, values);
  if (!plan.segments.empty()) {
    TemplateValues& how = values.add_section("HOW");
    for (const std::string& text : exports::experiment::plan_instructions(plan)) {
      how.add_section("INSTRUCTION").set("TEXT", text);
    }
    fill_table(segments_table(plan), "WINDOWS", how);
    fill_table(positions_table(plan), "POSITIONS", how);
  }
  if (!report.expected.quantities.empty()) {
    fill_table(expected_table(report.expected), "EXPECTED", values.add_section("EXPECTATION"));
  }
  fill_table(assumptions_table(plan.joint), "ASSUMPTIONS", values);
  values.set_checked_by_modifier(
      "RESULT_JSON", exports::experiment::plan_json(plan, report.expected, report.provenance));
  return expand_template("plan.tpl", values, language);
}

}  // namespace tribolog::report
