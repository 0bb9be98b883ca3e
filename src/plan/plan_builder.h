#pragma once
// Internal to the plan: what its parts share, and the parts, one source file each.

#include <string>

#include "plan/experiment_plan.h"

namespace tribolog::plan {

/// Where the joint may go and how fast.
struct WorkingRange {
  double low_rad{};
  double high_rad{};
  double travel_speed_rad_s{};   ///< Between the experiments.
  double acceleration_rad_s2{};  ///< Largest of all smooth ramps.
  bool holds_peak{};             ///< The peak is known and lies inside.
  [[nodiscard]] double span_rad() const { return high_rad - low_rad; }
  /// The angle, moved as little as needed for so much room on either side.
  [[nodiscard]] double with_room(double angle_rad, double room_rad) const;
};

/// Of the drive's torque limit, what a plan uses.
inline constexpr double usable_torque = 0.95;

/// Limits less a margin, and of that the stretch over which the drive can hold gravity and
/// friction. What the torque takes away becomes a remark.
WorkingRange working_range(const AssumedJoint& joint, std::vector<Statement>& remarks);

/// Puts segments one behind the other, with the travels between them.
class Timeline {
 public:
  Timeline(ExperimentPlan& plan, const WorkingRange& range) : plan_(plan), range_(range) {}

  /// Travels there; the first target is where the plan starts.
  void go_to(double angle_rad);
  /// The motion begins where the joint stands.
  /// @param from_s, to_s window of the recording within the motion.
  void record(Statement name, joint::Role role, std::shared_ptr<const PlannedMotion> motion,
              double from_s, double to_s, const std::optional<PlannedRamp>& ramp = {});
  [[nodiscard]] double now_s() const { return plan_.duration_s(); }

 private:
  ExperimentPlan& plan_;
  const WorkingRange& range_;
  bool has_place_{false};
  double angle_rad_{};
};

/// Rest of the joint before, between and after the strokes of a motion.
inline constexpr double rest_s = 0.5;

// Each adds its row, and its segments where it can be carried out.
void add_rough_sweep(const WorkingRange& range, Timeline& timeline, ExperimentPlan& plan);
void add_precise_sweep(const WorkingRange& range, Timeline& timeline, ExperimentPlan& plan);
void add_oscillations(const WorkingRange& range, Timeline& timeline, ExperimentPlan& plan);
void add_runs(const WorkingRange& range, Timeline& timeline, ExperimentPlan& plan);
void add_ramps(const WorkingRange& range, Timeline& timeline, ExperimentPlan& plan);

/// "−22.23°", with as many decimals as asked for.
std::string degrees_text(double angle_rad, int decimals = 2);

/// Why a part about the gravity peak has to wait or cannot be; PartState::planned: it can.
PlannedPart part_about_the_peak(joint::Role role, const WorkingRange& range,
                                const ExperimentPlan& plan);

}  // namespace tribolog::plan
