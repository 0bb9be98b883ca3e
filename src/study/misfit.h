#pragma once
// What becomes of each quantity on joints and logs that the method's model does not describe.
//
// Four joints of very different gear, gravity and friction; on each one effect at a time is laid,
// in three sizes (simulate/unmodelled_effects.h, other contacts than LuGre's, motions that do not
// show what they should). Every run is identified with the whole chain and judged by the verdict.
// Counted is what must not be: a number that is wrong and called usable. A number is wrong where
// the truth lies outside its 95 % interval and it is off by more than matters (bound_of()).

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "joint/quantity.h"
#include "joint/recording.h"
#include "simulate/scenario.h"

namespace tribolog::study {

/// One thing that the model of the method does not have, at three sizes from small to large.
struct Disturbance {
  std::string key;  ///< Stable: "torque_delay".
  std::vector<double> sizes;
  std::function<void(simulate::Scenario& scenario, double size)> lay;
  /// Codes of findings that name it: one that begins with any of these.
  std::vector<std::string> named_by;
  /// Size at which neither joint nor log is wrong: there is nothing to name.
  std::optional<double> sound_at{};
  /// No log can show it: the uncertainty budget has to name it instead.
  bool is_hidden{};
};

const std::vector<Disturbance>& disturbances();

/// Less data than one would wish, of sound joints: one size each.
const std::vector<Disturbance>& lacks();

struct MisfitJoint {
  std::string key;  ///< Stable: "geared_arm".
  simulate::Scenario scenario;
};

/// Twelve joints, without noise of their own seed; each with rough sweep, oscillations, runs and
/// ramps. Disturbances are laid on the first four where nobody chooses.
std::vector<MisfitJoint> misfit_joints();

/// How a quantity fared over the runs of one case.
struct MisfitQuantity {
  joint::Quantity quantity{};
  double truth{};  ///< SI, motor side; NaN: it has none on this joint, or one in each run.
  std::size_t found{};
  std::size_t judged{};  ///< Of those found, where there is a truth.
  std::size_t usable{};
  std::size_t inside{};        ///< Runs whose interval holds the truth, of those judged.
  std::size_t wrong{};         ///< Outside the interval and off by more than matters.
  std::size_t wrong_usable{};  ///< And called usable: must be 0.
  /// Of the usable, how many would be wrong by chance: where 95 % intervals are wider than what
  /// matters, one of twenty is, if each holds what it states and errors are normal.
  double by_chance{};
  double worst_usable{};  ///< Largest error of a usable number, as a share of bound_of().
  /// Of those judged, as shares of bound_of(): root mean square of the errors, and mean half width.
  double rms_error{};
  double half_width{};
};

struct MisfitCase {
  std::string joint;
  std::string disturbance;  ///< Empty: none; what is sound.
  double size{};
  std::size_t runs{};
  bool has_cause{};     ///< Something is wrong that the findings should name.
  std::size_t named{};  ///< Runs whose findings, or reasons against a quantity, name the cause.
  /// Runs in which a number is wrong, or less usable than on the sound joint; and named in them.
  std::size_t harmed{};
  std::size_t harmed_and_named{};
  std::vector<MisfitQuantity> quantities;
};

/// Given logs with the scenario behind them.
using KeepLogs = std::function<void(const MisfitCase& of, const simulate::Scenario& laid,
                                    const std::vector<joint::Recording>& logs)>;

struct MisfitOptions {
  std::size_t runs{50};
  std::uint64_t seed{1};
  std::size_t threads{0};
  std::vector<std::string> disturbances;  ///< Keys of those to lay; none: all.
  std::vector<std::string> joints;        ///< Keys; none: the first four, or all if only_sound.
  bool only_sound{};                      ///< Nothing is laid: what sound joints and logs give.
  bool unstated{};     ///< The manifest does not say which effects the joint does not have.
  bool lacks{};        ///< lacks() are laid, on all joints where none is chosen.
  KeepLogs keep_logs;  ///< Of each case's first run; may be empty.
};

using MisfitProgress =
    std::function<void(const std::string& case_name, std::size_t done, std::size_t all)>;

/// @throw std::invalid_argument for a key that there is not, naming those there are.
std::vector<MisfitCase> run_misfit_study(const MisfitOptions& options = {},
                                         const MisfitProgress& progress = {});

struct MixedOptions {
  std::size_t joints{100};
  std::uint64_t seed{1};  ///< Of the joints, their effects and their noise.
  std::size_t threads{0};
  /// Of each joint, in a case of that one alone; may be empty, and called from several threads.
  KeepLogs keep_logs;
};

/// Joints drawn at random about misfit_joints(), one run each, with more than a dozen small effects
/// at once of which the manifest says nothing: what most real joints are. All are run twice, with
/// effects of the usual sizes and of twice those; each is one case, whose runs are the joints.
std::vector<MisfitCase> run_mixed_study(const MixedOptions& options = {},
                                        const MisfitProgress& progress = {});

/// Error of a quantity from which on it matters: 0.05° of the angle, shares of the others.
double bound_of(joint::Quantity quantity, double truth);

}  // namespace tribolog::study
