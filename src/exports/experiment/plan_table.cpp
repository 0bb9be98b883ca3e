#include "exports/experiment/plan_table.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/requirements.h"
#include "joint/degrees.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::exports::experiment {
namespace {

using wording::tr;
using wording::tr_count;

std::int64_t count_in(const plan::ExperimentPlan& plan, plan::PartState state) {
  return std::count_if(plan.parts.begin(), plan.parts.end(),
                       [&](const plan::PlannedPart& p) { return p.state == state; });
}

/// Decimals that show a size with so many digits.
int decimals_for(double size, int digits) {
  if (!(size > 0)) return 0;
  constexpr int most = 9;
  return std::clamp(digits - 1 - static_cast<int>(std::floor(std::log10(size))), 0, most);
}

std::string with_minus(std::string text) {
  if (!text.empty() && text.front() == '-') text.replace(0, 1, "−");
  return text;
}

}  // namespace

std::string part_title(joint::Role role) {
  return wording::words_for("plan_part", to_string(role));
}

std::string duration_text(double seconds) {
  const auto whole = static_cast<long>(std::lround(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  return fmt::format("{} min {} s", whole / 60, whole % 60);
}

std::string next_plan_words() {
  return tr(
      "parts around the gravity peak have to wait for its angle: record this plan, identify it, "
      "and plan again with --calibration and the calibration");
}

std::string plan_sentence(const plan::ExperimentPlan& plan) {
  if (plan.segments.empty()) return tr("nothing can be measured within these limits");
  std::size_t recordings = 0;
  for (const plan::PlannedPart& part : plan.parts) recordings += part.recordings;
  std::string text =
      tr_count(static_cast<std::int64_t>(recordings), "{recordings} recording in {duration}",
               "{recordings} recordings in {duration}",
               {{"recordings", recordings}, {"duration", duration_text(plan.duration_s())}});
  if (plan.is_first_of_two()) {
    const std::int64_t parts = count_in(plan, plan::PartState::later);
    text += "; ";
    text += tr_count(parts, "{parts} part follows once the rough sweep has shown the gravity peak",
                     "{parts} parts follow once the rough sweep has shown the gravity peak",
                     {{"parts", parts}});
  }
  if (const std::int64_t parts = count_in(plan, plan::PartState::impossible); parts > 0) {
    text += "; ";
    text += tr_count(parts, "{parts} of 5 parts is not possible within the limits",
                     "{parts} of 5 parts are not possible within the limits", {{"parts", parts}});
  }
  return text;
}

std::vector<std::string> plan_lines(const plan::ExperimentPlan& plan) {
  std::vector<std::string> lines;
  for (const plan::PlannedPart& part : plan.parts) {
    const bool is_there = part.recordings > 0;
    const std::string state = wording::words(plan::stated(part.state));
    lines.push_back(fmt::format("  {:<24} {}", part_title(part.role),
                                is_there ? fmt::format("{}: {}", duration_text(part.duration_s),
                                                       wording::words(part.motion))
                                         : state));
    if (part.why.empty() || part.state == plan::PartState::later) continue;
    lines.push_back(fmt::format("  {:<24} {}{}; what would help: {}", "",
                                is_there ? state + ": " : "", wording::words(part.why),
                                wording::words(part.help)));
  }
  if (plan.is_first_of_two()) lines.push_back("  note: " + next_plan_words());
  for (const std::string& remark : wording::words(plan.remarks)) {
    lines.push_back("  note: " + remark);
  }
  return lines;
}

std::string quantity_text(double value_si, truth::ReadingKind quantity, int digits) {
  if (!std::isfinite(value_si)) return "–";
  const bool is_angle = quantity == truth::ReadingKind::peak_angle;
  const double value = is_angle ? value_si * joint::degrees_per_rad : value_si;
  const std::string text =
      with_minus(fmt::format("{:.{}f}", value, decimals_for(std::abs(value), digits)));
  if (is_angle) return text + "°";
  const std::string unit = truth::unit_of(quantity);
  return text + (unit.empty() ? "" : " " + unit);
}

std::string interval_text(double value_si, double half_width_si, truth::ReadingKind quantity) {
  if (!(half_width_si > 0) || !std::isfinite(value_si)) return "–";
  const bool is_angle = quantity == truth::ReadingKind::peak_angle;
  const double factor = is_angle ? joint::degrees_per_rad : 1;
  const double half_width = half_width_si * factor;
  const int decimals = decimals_for(half_width, 2);
  const std::string value = with_minus(fmt::format("{:.{}f}", value_si * factor, decimals));
  const std::string width = fmt::format("{:.{}f}", half_width, decimals);
  if (is_angle) return value + "° ± " + width + "°";
  const std::string unit = truth::unit_of(quantity);
  return value + " ± " + width + (unit.empty() ? "" : " " + unit);
}

std::vector<std::string> expectation_lines(const plan::ExpectedIntervals& expected) {
  std::vector<std::string> lines;
  for (const plan::ExpectedInterval& e : expected.quantities) {
    const std::string found =
        e.found == e.runs ? "" : fmt::format(", identified in {} of {} runs", e.found, e.runs);
    lines.push_back(fmt::format("  {:<38} {}{}", wording::words_for("expected", to_string(e.name)),
                                interval_text(e.truth, e.half_width, e.quantity), found));
  }
  return lines;
}

std::vector<std::string> plan_instructions(const plan::ExperimentPlan& plan) {
  if (plan.segments.empty()) return {};
  std::vector<std::string> all;
  all.push_back(
      tr("Before the first set point move the joint to {angle} and let it rest; the other joints "
         "are held still, in a pose in which this joint's axis is horizontal.",
         {{"angle", quantity_text(plan.angle_rad(0), truth::ReadingKind::peak_angle, 5)}}));
  all.push_back(
      tr("The drive follows setpoints.csv, {set_points:.4g} set points per second, and "
         "interpolates between them. No set point leaves the stated limits of angle, speed and "
         "acceleration; whether the path is clear must be checked at the machine.",
         {{"set_points", plan.joint.set_point_rate_Hz}}));
  all.push_back(
      tr("Log time, joint angle, speed and torque or current at {sample_rate:.4g} Hz as log.csv, "
         "with the clock starting at the first set point; then run tribolog report dataset.toml -o "
         "report.html.",
         {{"sample_rate", plan.joint.sample_rate_Hz}}));
  all.push_back(tr("Warm the joint up first: the friction of a cold gear drifts."));
  const auto ramp = std::find_if(plan.segments.begin(), plan.segments.end(),
                                 [](const plan::PlannedSegment& s) { return s.ramp.has_value(); });
  if (ramp != plan.segments.end()) {
    all.push_back(
        tr("Where torque_mode is 1 the torque is commanded: the motor torque that holds the arm at "
           "that moment, plus ramp_torque_Nm (at the motor). When the joint has slid {travel:.2g}° "
           "the drive switches to angle control, holds the angle until torque_mode is 0, and "
           "returns to the set point within the rest that follows. For a drive without torque "
           "control leave out the ramps, and their entries in dataset.toml.",
           {{"travel", present(ramp->ramp).largest_travel_rad * joint::degrees_per_rad}}));
  }
  return all;
}

}  // namespace tribolog::exports::experiment
