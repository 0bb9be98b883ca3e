#pragma once
// What a Monte-Carlo study varies: one factor at a time about the base case, at stated levels.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/statement.h"
#include "simulate/scenario.h"
#include "statistics/estimate.h"
#include "truth/readings.h"

namespace tribolog::study {

/// One setting of a factor.
struct StudyLevel {
  double value{};  ///< In the axis' unit.
  Statement text;  ///< "20 mN·m", "131072 counts"
  bool is_base{};
  std::string case_name;  ///< Levels of one name, of any factors, are one case: it is run once.
  simulate::Scenario scenario;
};

/// Its words, by the key: "factor" is its title, "factor_axis" that of an axis, "factor_note" what
/// is varied, and what is left out of the recordings.
struct StudyFactor {
  std::string key;  ///< Stable: "torque_noise", "ripple_one_position", ...
  bool logarithmic{};
  std::vector<StudyLevel> levels;  ///< Ascending; one is the base case.
};

/// The factors that the scenario's experiments allow, in the order of the report: white torque
/// noise, torque step, encoder; with an oscillation also ripple from one and from eight positions,
/// amplitude, cycles. Levels are multiples of the scenario's own value, or where it states none, of
/// that of method.md section 8 by its share of the gravity torque.
///
/// Recordings that the factor does not touch are left out where no estimator of that factor needs
/// them: the precise sweep and the runs at constant speed take no part where the oscillation alone
/// is changed. The rough sweep always does: the angle of the peak and the ripple that widens the
/// intervals come from it.
std::vector<StudyFactor> study_factors(const simulate::Scenario& base);

/// The scenario as the study takes it: no bristle deflection in the log, which no drive measures,
/// no break-away ramps, which none of its estimators reads, and noise as above where none is
/// stated.
simulate::Scenario study_base(const simulate::Scenario& scenario);

// Bias, scatter and coverage of an estimator over many runs of known truth.
//
// Bias is the mean error, known to scatter / sqrt(runs). Coverage is the share of the runs whose
// stated 95 % interval holds the truth; its own interval is Wilson's, which stays within 0 to 1 and
// is right at the shares near 1 that matter here, where the usual p +- 1.96 sqrt(p(1-p)/n) is not.

/// A share with its 95 % interval; 0 <= low <= value <= high <= 1.
struct Share {
  double value{};
  double low{};
  double high{};
};

/// Wilson's interval of `hits` out of `trials` (Wilson 1927).
/// @throw std::invalid_argument if hits > trials or there is no trial.
Share wilson_share(std::size_t hits, std::size_t trials);

struct ErrorStatistics {
  std::size_t runs{};   ///< Of the study.
  std::size_t found{};  ///< Those in which the estimator gave a number.
  double truth{};
  double bias{};                 ///< Mean error; NaN if never found.
  double bias_standard_error{};  ///< NaN with fewer than two.
  double scatter{};              ///< Standard deviation of the errors; NaN with fewer than two.
  double error_95{};             ///< 95 of 100 errors are no larger (by size, nearest rank).
  double half_width{};           ///< Mean half width of the stated intervals.
  Share coverage;                ///< Of those found.

  /// The bias is more than three of its standard errors, and larger than what matters.
  [[nodiscard]] bool is_biased(double practical_bound) const;
  /// The runs are all the same, for want of noise: they count as one, and their coverage says
  /// nothing.
  [[nodiscard]] bool all_alike() const;
  /// The coverage is below or above what 91 to 99 % allows, beyond its own uncertainty.
  [[nodiscard]] bool intervals_too_narrow() const;
  [[nodiscard]] bool intervals_too_wide() const;
};

/// @param estimates one per run in which the quantity was found. @param runs as many or more.
ErrorStatistics error_statistics(const std::vector<statistics::Estimate>& estimates, double truth,
                                 std::size_t runs);

// The Monte-Carlo study: bias, scatter and coverage of every estimator against each factor.
//
// Each run lays its own noise on the ideal recordings of a case, identifies them with the whole
// chain, and holds what comes out against the scenario. Run r has the same random numbers in every
// case (common random numbers), so that neighbouring levels differ by the factor and not by luck.

struct StudyOptions {
  std::size_t runs{200};             ///< Of each case; >= 2.
  std::uint64_t seed{1};             ///< The same seed gives the same numbers.
  std::size_t threads{0};            ///< 0: as many as the machine has cores. Changes no number.
  std::vector<std::string> factors;  ///< Keys of those to study; none: all.
};

/// One estimator in one case.
struct StudiedReading {
  truth::ReadingName name{};
  truth::ReadingKind quantity{truth::ReadingKind::gravity};
  ErrorStatistics errors;
};

struct StudiedCase {
  std::string name;
  std::vector<StudiedReading> readings;  ///< Those found in at least one run, in their order.
  [[nodiscard]] const StudiedReading* find(truth::ReadingName reading) const;
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
/// that noise alone is judged. What has no truth is absent.
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
