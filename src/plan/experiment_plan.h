#pragma once
// The experiment to run: what the joint shall do from the first second to the last, which stretches
// of its log are which recording, and what cannot be done, with the reason.
//
// Order: rough sweep, precise sweep about the gravity peak, oscillations at several motor
// positions, runs at constant speed, break-away ramps. Between them the joint travels and rests.
// Where the angle of the gravity peak is not known, the plan holds the rough sweep and the runs
// alone: all else follows from what they give.

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/statement.h"
#include "joint/quantity.h"
#include "joint/recording.h"
#include "plan/assumed_joint.h"
#include "plan/planned_motions.h"

namespace tribolog::plan {

/// A stretch in which the torque leads: it changes by rate_Nm_s from what the drive holds at its
/// start. The joint stands until it slides; there, or after largest_travel_rad, the drive has to
/// take the angle over and return to where the ramp began.
struct PlannedRamp {
  double direction{1};          ///< +1 or -1
  double rate_Nm_s{};           ///< > 0, motor side.
  double largest_change_Nm{};   ///< > 0, motor side.
  double largest_travel_rad{};  ///< Joint side.
};

struct PlannedSegment {
  Statement name;                   ///< "oscillation 3 of 8", "travel"
  std::optional<joint::Role> role;  ///< Absent: travel and rest, which are no recording.
  double start_s{};
  double from_s{};  ///< Window of the recording, absolute times.
  double to_s{};
  std::shared_ptr<const PlannedMotion> motion;  ///< Joint side; time counts from start_s.
  std::optional<PlannedRamp> ramp;              ///< From from_s to to_s.

  [[nodiscard]] double end_s() const { return start_s + motion->duration_s(); }
};

/// What comes of one part of the experiment.
enum class PartState {
  planned,
  later,    ///< Follows from the result of this plan's rough sweep.
  limited,  ///< Planned, but it will not show everything.
  impossible,
  not_asked,  ///< Nobody asked for what it shows.
};

/// "planned", "follows from the rough sweep", "planned, limited", "not possible", "not needed"
Statement stated(PartState state);

/// One row of the plan's table.
struct PlannedPart {
  joint::Role role{};
  PartState state{PartState::planned};
  std::size_t recordings{};
  double duration_s{};  ///< With the travels to and within it.
  Statement motion;     ///< "from −80° to 60° and back at 2°/s"; empty: not planned.
  Statement gives;      ///< What it is for.
  Statement why;        ///< Why it is limited or impossible, with numbers; else empty.
  Statement help;       ///< What would change that; else empty.

  [[nodiscard]] bool is_as_asked() const {
    return state == PartState::planned || state == PartState::not_asked;
  }
};

/// How much work is put in; 1 is usual. Sweeps take so much longer, the oscillation has so many
/// more cycles, and speeds, positions and ramps grow with it, more slowly.
struct PlanOptions {
  std::optional<double> effort;  ///< > 0; absent: the most that the time budget allows, or 1.
  /// Parts to plan; the others are not asked for. Empty: all.
  std::vector<joint::Role> roles{};
};

/// The parts that show the quantities, each once.
std::vector<joint::Role> roles_that_show(const std::vector<joint::Quantity>& quantities);

struct ExperimentPlan {
  AssumedJoint joint;
  double effort{1};
  std::vector<PlannedPart> parts;        ///< In the order of the method, all five.
  std::vector<PlannedSegment> segments;  ///< In time, without gaps; empty: nothing can be done.
  /// Angles of the oscillations, and largest share of a known ripple period's amplitude that the
  /// mean over them leaves.
  std::vector<double> positions_rad;
  double ripple_left_share{};
  double amplitude_rad{};  ///< Of the oscillations, joint side.
  double frequency_Hz{};
  std::vector<double> motor_speeds_rad_s;  ///< Of the runs.
  std::vector<Statement> remarks;          ///< Whole plan: budget, range that the torque leaves.

  [[nodiscard]] double duration_s() const;
  [[nodiscard]] const PlannedPart& part(joint::Role role) const;
  [[nodiscard]] bool is_first_of_two() const;  ///< Some parts follow from its result.
  /// The joint's angle, speed [rad, rad/s] at a time of the plan; before and behind it stands.
  [[nodiscard]] double angle_rad(double t_s) const;
  [[nodiscard]] double speed_rad_s(double t_s) const;
  /// Index of the segment at a time from 0 to duration_s().
  [[nodiscard]] std::size_t segment_at(double t_s) const;
};

/// @throw std::invalid_argument as assume_joint(), or for an effort that is not > 0.
ExperimentPlan plan_experiment(const joint::JointFacts& facts, const PlanOptions& options = {});

}  // namespace tribolog::plan
