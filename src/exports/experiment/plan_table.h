#pragma once
// A plan in words: the same for the console, the page and JSON.

#include <string>
#include <vector>

#include "plan/expected_intervals.h"
#include "plan/experiment_plan.h"

namespace tribolog::exports::experiment {

/// "rough sweep", "runs at constant speed"
std::string part_title(joint::Role role);

/// "8 min 58 s", "42 s"
std::string duration_text(double seconds);

/// What is planned and for how long, or that nothing can be: one sentence.
std::string plan_sentence(const plan::ExperimentPlan& plan);

/// Of a first plan of two: how the second is made.
std::string next_plan_words();

/// The plan as lines of text: its parts, why some are limited or not there, and remarks.
std::vector<std::string> plan_lines(const plan::ExperimentPlan& plan);

/// What to expect of each quantity, as lines of text; none without runs.
std::vector<std::string> expectation_lines(const plan::ExpectedIntervals& expected);

/// A number of a quantity with its unit; angles in degrees: "3.883 N·m", "−22.23°".
std::string quantity_text(double value_si, truth::ReadingKind quantity, int digits);

/// "3.88319 ± 0.00021 N·m": the interval to two digits, the value to the same place. "–" where the
/// half width is not known.
std::string interval_text(double value_si, double half_width_si, truth::ReadingKind quantity);

/// What the one who runs the experiment must know: sentences.
std::vector<std::string> plan_instructions(const plan::ExperimentPlan& plan);

}  // namespace tribolog::exports::experiment
