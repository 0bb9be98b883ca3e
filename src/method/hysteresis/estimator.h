#pragma once
// The estimators of the gravity torque, and with it of the surrogate mass.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace tribolog::method::hysteresis {

/// In the order of the surrogate masses.
enum class Estimator {
  A,  ///< A to F: the points of the paper's table 2, read on the first strokes.
  B,
  C,
  D,
  E,
  F,
  AB,  ///< AB, CD, EF: means of opposite points of the steady loop.
  CD,
  EF,
  midline,  ///< Mean of the steady loop.
  fit,      ///< Of LuGre fitted to all loops.
  sweep,    ///< Gravity amplitude of the rough sweep.
  model,    ///< Gravity of the one model of sweeps and runs.
  stated,   ///< That of the manifest, which decides nothing where anything was identified.
};

inline constexpr std::array all_estimators{
    Estimator::A,   Estimator::B,     Estimator::C,     Estimator::D,     Estimator::E,
    Estimator::F,   Estimator::AB,    Estimator::CD,    Estimator::EF,    Estimator::midline,
    Estimator::fit, Estimator::sweep, Estimator::model, Estimator::stated};
inline constexpr std::array loop_points{Estimator::A, Estimator::B, Estimator::C,
                                        Estimator::D, Estimator::E, Estimator::F};
inline constexpr std::array pair_means{Estimator::AB, Estimator::CD, Estimator::EF};

/// Stable, in files and in message codes: "A", "CD", "midline".
std::string to_string(Estimator estimator);

/// The same; empty without one.
std::string to_string(std::optional<Estimator> estimator);

/// The inverse of to_string(); nothing for any other text.
std::optional<Estimator> estimator_of(const std::string& key);

/// Index of a point in loop_points; nothing for other estimators.
std::optional<std::size_t> point_index(Estimator estimator);

/// The two points of a pair mean; nothing for other estimators.
std::optional<std::pair<Estimator, Estimator>> points_of_pair(Estimator estimator);

/// The point on the opposite side of the steady loop: B for A. @param point one of loop_points.
Estimator opposite_point(Estimator point);

}  // namespace tribolog::method::hysteresis
