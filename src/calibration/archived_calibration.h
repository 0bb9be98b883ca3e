#pragma once
// A calibration as stored in an archive.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "calibration/quantity_verdict.h"
#include "joint/drive.h"
#include "statistics/estimate.h"

namespace tribolog::calibration {

/// These three texts, as the manifests state them, identify a joint. They are shown and compared,
/// never used as a path or as part of an SQL statement.
struct JointName {
  std::string robot;
  std::string serial;
  std::string joint;
  auto operator<=>(const JointName&) const = default;
};

/// What was measured, when and how. Texts are empty, and numbers absent, where nothing is stated.
struct Facts {
  JointName of;
  std::string measured_at;  ///< "2026-01-31T12:00:00Z", for sorting by time.
  std::string measured_on;  ///< As the manifest states it.
  bool time_is_stated{};    ///< false: no readable time is stated; measured_at is created_utc.
  std::string created_utc;  ///< When it was identified.
  std::string operator_name;
  std::string note;
  std::string payload;
  std::optional<double> payload_kg;
  std::optional<double> payload_distance_m;
  std::optional<double> temperature_C;
  double gear_ratio{1};
  std::optional<double> sampling_Hz;  ///< Median of the recordings' rates.
  Verdict verdict{Verdict::not_identifiable};
  std::string sentence;
  std::string configuration;  ///< "Resamples: 1000\nSeed of the resamples: 1\n"
  std::string tool_version;
  std::string git_revision;
};

/// What the manifest states of an error that no recording shows, in a result.
struct StatedInfluence {
  std::string name;               ///< Stable: "torque_constant".
  std::string id;                 ///< What it comes from; empty: by a program that did not keep it.
  double standard_uncertainty{};  ///< In the result's unit.
};

/// A result: SI, motor side.
struct Quantity {
  std::string name;   ///< Stable: "coulomb_torque".
  std::string words;  ///< In English: "Coulomb torque".
  std::string unit;   ///< Empty for a curve.
  Verdict verdict{Verdict::not_identifiable};
  std::optional<statistics::Estimate> estimate;
  std::vector<StatedInfluence> influences{};  ///< In the calibration's file, not in tables.
};

/// An input file of the calibration.
struct Input {
  std::string name;
  std::string role;
  std::uint64_t bytes{};
  std::string sha256;
};

enum class DocumentKind { calibration, report, input };

struct Document {
  DocumentKind kind{};
  std::string name;  ///< Of an input; else empty.
  std::string bytes;
};

/// What is to be archived.
struct NewCalibration {
  Facts facts;
  std::vector<Quantity> quantities;
  std::vector<Input> inputs;
  std::vector<Document> documents;  ///< The calibration (JSON); its report and inputs if wanted.
};

/// An archived calibration.
struct Entry {
  std::int64_t number{};  ///< Within this archive.
  std::string id;         ///< 64 hex digits, the same in every archive.
  std::string identity;
  int revision{1};  ///< 2 or more: archived again although it was already there.
  Facts facts;
  std::string digest;  ///< SHA-256 over the whole content.
};

/// An entry and its results.
struct Measured {
  Entry entry;
  std::vector<Quantity> quantities;
};

/// What a reviewer decided on an entry. The latest one counts; none is ever changed.
struct Review {
  enum class Decision { approved, rejected };
  std::string at_utc;
  std::string reviewer;
  Decision decision{Decision::rejected};
  std::string note;  ///< May be empty.
};

/// "approved", "rejected"
std::string to_string(Review::Decision decision);

/// From either of these two words.
Review::Decision decision_of(const std::string& word);

/// The last decision on each entry that was reviewed, by its id.
using Decisions = std::map<std::string, Review::Decision>;

/// Number of an id's hex digits that are shown; commands accept any unambiguous prefix.
inline constexpr std::size_t shown_digits = 10;

// Results on either side of the gear [SI]. With the gear ratio n = motor angle / joint angle:
// torque at the joint = n times that at the motor; speed and angle 1/n; coefficients of torque per
// angle, per speed and per acceleration (stiffness, damping, inertia) n².

/// What the torques among the results are numbers of, by their units.
joint::TorqueUnit torque_unit_of(const std::vector<Quantity>& quantities);

/// A result on a stated side.
struct SidedQuantity {
  Quantity quantity;
  joint::Side side{joint::Side::motor};
  int gear_power{};  ///< The archived number is multiplied by n to this power.
};

/// Power of the gear ratio that converts from the motor's side to the joint's; 0: the quantity is
/// the joint's alone (angle of the centre of gravity, surrogate mass).
/// @return nothing for an unknown quantity.
std::optional<int> gear_power(const std::string& quantity);

/// Each quantity that has a unit, on both sides or on the one to which it belongs; but friction at
/// speeds, whose speeds have sides too (friction_speeds.h).
std::vector<SidedQuantity> on_both_sides(const std::vector<Quantity>& quantities,
                                         double gear_ratio);

/// The quantity at the joint.
statistics::Estimate at_joint(const Quantity& quantity, double gear_ratio);

/// "Inertia at the motor" becomes "Inertia": the side is stated beside it.
std::string without_side(const std::string& words);

/// "as archived", "archived × n²", "archived / n".
std::string conversion_words(int gear_power);

}  // namespace tribolog::calibration
