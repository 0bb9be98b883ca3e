#pragma once
// All joints of an archive beside each other: the latest calibration of each, and how far it is
// from those of the same joint of other robots and from its own history.
//
// Both distances are robust: t = (x - m) / max(s sqrt(1 + pi/(2 n)), h / 1.96).
//   x, h  the latest result and the half width of its 95 % interval;
//   m, n  median and number of what it is held against: the latest of the others, or the joint's
//         own earlier ones;
//   s     scatter (pairwise_scatter()) of the latest of all of the group, or of the earlier ones of
//         all of the group about the median of their own joint.
// z is the normal deviate as improbable as t, so that few values make no outlier by themselves.
// A group: joints of one name and gear ratio, of robots of one name where six or more are there,
// else of all robots. Temperature and payload are not taken into account.

#include <optional>
#include <string>
#include <vector>

#include "calibration/archived_calibration.h"

namespace tribolog::history {

/// How far the latest result is from what it is held against.
struct Distance {
  double z{};
  double median{};
  double scatter{};  ///< s sqrt(1 + pi/(2 n)).
  std::size_t count{};
};

struct PastResult {
  double time_s{};  ///< Since 1970.
  statistics::Estimate estimate;
};

/// One quantity of one joint.
struct FleetCell {
  std::size_t column{};             ///< Of Fleet::columns.
  std::vector<PastResult> results;  ///< In time; the last is the latest calibration's.
  calibration::Verdict verdict{calibration::Verdict::usable};  ///< Of the latest.
  std::optional<Distance> to_others;
  std::optional<Distance> to_history;

  /// Largest |z|; 0 where there is none.
  [[nodiscard]] double furthest() const;
};

struct FleetJoint {
  calibration::Entry latest;
  std::optional<calibration::Review::Decision> decision;  ///< The last one on it.
  std::size_t calibrations{};
  std::vector<FleetCell> cells;  ///< By column; what the latest does not show is left out.
  double furthest{};
};

struct FleetRobot {
  std::string robot;
  std::string serial;
  std::vector<FleetJoint> joints;  ///< By name.
  double furthest{};
};

struct FleetColumn {
  std::string name;
  std::string words;
  std::string unit;
};

struct Fleet {
  std::vector<FleetColumn> columns;
  std::vector<FleetRobot> robots;  ///< The one furthest off first.
  std::size_t joints{};
  std::size_t calibrations{};
  std::size_t distances{};  ///< How many were computed.
  /// |z| beyond which a joint is an outlier: 3.5, or so much that of all the distances half a one
  /// is beyond it by chance.
  double limit{};
  double first_s{};  ///< Times of the first and last calibration.
  double last_s{};
};

/// What a comparison needs at least.
inline constexpr std::size_t fewest_others = 5;
inline constexpr std::size_t fewest_earlier = 4;

/// @param measured as CalibrationArchive::measured() gives them: by joint and time.
/// @param decisions of reviewers on the entries.
Fleet fleet_of(const std::vector<calibration::Measured>& measured,
               const calibration::Decisions& decisions = {});

}  // namespace tribolog::history
