#pragma once
// The only reader of what calibration_json() writes: files of any age, to be archived, shown on a
// page or converted to another program's format.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "calibration/archived_calibration.h"
#include "calibration/quantity_verdict.h"
#include "calibration/uncertainty_budget.h"
#include "joint/certificate.h"

namespace tribolog::calibration {

/// Friction over speed with the recommended gravity removed, a point for each run at constant speed
/// or, without such runs, for each pair of a sweep's strokes. SI, motor side.
struct RecordedFriction {
  std::string estimator;  ///< Whose gravity torque was subtracted to give the friction.
  bool from_sweep{};
  std::vector<double> speed_rad_s;  ///< With the sign of the direction, like the friction.
  std::vector<double> friction_Nm;
  std::vector<double> half_width_Nm;  ///< Of the torque, 95 %; NaN: not recorded.
  /// Of the friction, 95 %, with the error of the gravity that was subtracted, which all points
  /// have in common; NaN: not recorded.
  std::vector<double> half_band_Nm{};
  /// Index among these of the run of the other direction at the same speed; -1: none.
  std::vector<int> partner{};
  /// Half the difference between both directions over the angles that they share, as the figure of
  /// the curve has it, of the speed's sign; NaN: not known.
  std::vector<double> direction_difference_Nm{};
};

/// One oscillation's steady loop.
struct RecordedLoop {
  double centre_rad{};                  ///< Joint.
  std::vector<double> from_centre_rad;  ///< Joint angle less the centre.
  std::vector<double> torque_Nm;        ///< Motor side.
};

struct RecordedCurves {
  RecordedFriction friction;            ///< Empty where there are no runs.
  std::optional<double> fastest_rad_s;  ///< Fastest speed of the straight line's fit, motor side.
  std::vector<RecordedLoop> loops;      ///< Empty where none was recorded, or by an older program.
  joint::TorqueUnit torque_unit{};      ///< Of all torques in them.
  /// Rising speed; empty where none was measured, or by an older program. Reasons are verbatim.
  std::vector<FrictionAtSpeed> friction_at_speed{};
};

/// A calibration as read from its file.
struct RecordedCalibration {
  Facts facts;
  std::vector<Quantity> quantities;
  std::vector<Input> inputs;
  RecordedCurves curves;
};

/// @param json the whole file. @param file its name, for messages.
/// @throw InputError: not JSON, not a calibration, or one with impossible values.
RecordedCalibration read_calibration(const std::string& json, const std::string& file);

/// The curves alone. Members that are missing or of another type count as not recorded.
RecordedCurves read_curves(const std::string& json);

/// What the quantities rest on, by their names; nothing where the file does not tell.
std::map<std::string, std::vector<StatedInfluence>> read_influences(const std::string& json);

/// What the manifest stated for a calibration certificate; what is missing or of another type
/// counts as not stated.
joint::Certificate read_certificate(const std::string& json);

/// What a limit of the manifest came to.
struct RecordedLimit {
  bool at_joint{};
  LimitState state{LimitState::unknown};
  std::string words;
};

/// What a quantity's number and verdict rest on.
struct RecordedEvidence {
  std::vector<std::string> reasons;         ///< Of the verdict, in English; the first is the most
                                            ///< important.
  std::optional<UncertaintyBudget> budget;  ///< Nothing where it is not there in full.
  std::vector<RecordedLimit> limits;
};

/// Of each quantity, by its name; nothing where the file does not tell.
std::map<std::string, RecordedEvidence> read_evidence(const std::string& json);

/// What an archive keeps: what read_calibration() finds, and the file itself. The only way into an
/// archive, so that `identify`, `report` and `archive add` archive the same.
/// @throw as read_calibration()
NewCalibration entry_of_calibration(const std::string& json, const std::string& file);

/// "2026-01-31", "2026-01-31 14:05", "2026-01-31T14:05:09+01:00" -> "2026-01-31T13:05:09Z". Without
/// an offset it is taken as UTC. @return empty for anything else.
std::string utc_of_iso_text(const std::string& text);

/// Seconds since 1970 of a time that utc_of_iso_text() gave; 0 for anything else.
double seconds_of_utc(const std::string& utc);

}  // namespace tribolog::calibration
