#pragma once
// The Monte-Carlo study: bias, scatter and coverage of every estimator against each factor.
//
// Each run lays its own noise on the ideal recordings of a case, identifies them with the whole
// chain, and holds what comes out against the scenario. Run r has the same random numbers in every
// case (common random numbers), so that neighbouring levels differ by the factor and not by luck.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "study/factors.h"
#include "study/statistics.h"
#include "truth/readings.h"

namespace tribolog::study {

struct StudyOptions {
  std::size_t runs{200};             ///< Of each case; >= 2.
  std::uint64_t seed{1};             ///< The same seed gives the same numbers.
  std::size_t threads{0};            ///< 0: as many as the machine has cores. Changes no number.
  std::size_t resamples{0};          ///< Of the bootstrap in each run; 0: intervals in closed form.
  std::vector<std::string> factors;  ///< Keys of those to study; none: all.
};

/// One estimator in one case.
struct StudiedReading {
  std::string name;  ///< Of the reading, readings.h.
  truth::ReadingKind quantity{truth::ReadingKind::gravity};
  ErrorStatistics errors;
};

struct StudiedCase {
  std::string name;
  std::vector<StudiedReading> readings;  ///< Those found in at least one run, in their order.
  [[nodiscard]] const StudiedReading* find(const std::string& reading) const;
};

struct StudyResult {
  StudyOptions options;
  simulate::Scenario base;
  std::vector<StudyFactor> factors;
  std::vector<StudiedCase> cases;  ///< Each once; levels refer to them by name.

  /// The case of a level. @throw std::out_of_range if the level is none of this study's.
  [[nodiscard]] const StudiedCase& case_of(const StudyLevel& level) const;
  /// The first level that is the base case.
  [[nodiscard]] const StudiedCase& base_case() const;
};

/// What must come out of an error-free identification of the scenario: gravity torque at the motor,
/// angle of the peak, the pre-sliding parameters of LuGre, the curve's. The straight line
/// (Coulomb, viscous), the sweep's friction and eq. (6) where another law was simulated have no
/// truth of their own: theirs is what the chain finds without any noise in the same motions, so
/// that noise alone is judged. A name that has no truth is absent.
std::vector<truth::Reading> true_readings(const simulate::Scenario& scenario);
/// The same from other motions of that joint: the dataset is of the scenario's joint, without
/// noise.
std::vector<truth::Reading> true_readings(const simulate::Scenario& scenario,
                                          const joint::Dataset& ideal);

/// The noise of one run: a seed of its own, and ripple at phases of its own.
simulate::Noise noise_of_run(const simulate::Noise& stated, std::uint64_t seed, std::size_t run);

/// Called before each case with (done, all).
using StudyProgress =
    std::function<void(const std::string& case_name, std::size_t done, std::size_t all)>;

/// @throw std::invalid_argument for fewer than two runs, for a factor that the scenario does not
/// have (naming those it has), or as simulate_joint().
StudyResult run_study(const simulate::Scenario& scenario, const StudyOptions& options = {},
                      const StudyProgress& progress = {});

}  // namespace tribolog::study
