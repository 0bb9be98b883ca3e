#pragma once
// What acts on the torque of loops beside their contact: effects of the catalogue (joint/effects.h)
// as columns at the loops' rows, with the priors that they have in the model of sweeps and runs.
// What the loops show of an effect is taken off their torque; what they cannot exclude is in the
// intervals.
//
//   motor_turn          friction of its own at each motor angle; and along a loop     F; F x
//   friction_of_recording  what nothing explains of a loop's friction                 F
//   load                friction of the gear under gravity, which turns at once       sgn(w) |g|
//   smooth_over_angle   torque that rises along a loop; what is left of ripple        x
//   asymmetry           friction of the two directions                                |F|
//   contact_misfit      another contact than LuGre's, hats over the way since the reversal
//
// A lag that sweeps and runs leave unknown, dT/dt, and a filter in its place are in the intervals
// alone: a contact that is not quite LuGre's would be taken for them.
//
// F: friction by LuGre; x: from -1 to 1 along the loop. Given the fit linearised about its solution
// it is one conjugate solve with the fit's parameters free; sizes follow by fixed-point steps of
// the evidence, as in the model (method/model/joint_model.h).

#include <cstddef>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "joint/effects.h"
#include "method/gravity/ripple_spectrum.h"
#include "method/hysteresis/loop_timing.h"
#include "method/hysteresis/lugre_ladder.h"
#include "method/hysteresis/lugre_problem.h"

namespace tribolog::method::hysteresis {

/// What sweeps, runs and the manifest say of what acts on the loops.
struct KnownEffects {
  joint::EffectSizes sizes;
  LoopTiming timing;        ///< Of the torque; its lag is removed already.
  double friction_share{};  ///< Of friction: its change over the motor's turn, standard deviation.
};

/// Part of a parameter's variance that would go if the effect were known; they may overlap.
struct EffectShare {
  std::string_view effect;  ///< Its key.
  double share{};
};

class LoopEffects {
 public:
  /// @param climb the solution for LuGre, linearised at the problem's rows.
  /// @param ripple that the sweep shows; its phase in it was taken off the loops.
  LoopEffects(const LuGreProblem& problem, const LuGreClimb& climb, const gravity::Ripple& ripple,
              KnownEffects known);

  /// Nothing acts.
  [[nodiscard]] bool empty() const { return all_.empty() && by_lag_.cols() == 0; }
  /// The problem without the torque that was found; the same loops, of any grain.
  /// @param with_contact false: what another contact would do stays in it.
  [[nodiscard]] LuGreProblem taken_off(const LuGreProblem& problem, bool with_contact = true) const;
  /// What another contact makes of the torque, all loops one after the other; zero where it was not
  /// asked.
  [[nodiscard]] Eigen::VectorXd contact_Nm(const LuGreProblem& problem) const;
  /// The same, root mean square over a loop.
  [[nodiscard]] double misfit_Nm(std::size_t loop) const {
    return misfit_Nm_.empty() ? 0 : misfit_Nm_[loop];
  }
  /// Shifts of the fit's parameters by what is not known of the effects: one column for each
  /// coefficient's standard deviation, effects one after the other.
  [[nodiscard]] const Eigen::MatrixXd& shifts() const { return shifts_; }
  /// Of the variance of a parameter along a gradient, largest first.
  /// @param variance of it as a whole.
  [[nodiscard]] std::vector<EffectShare> shares(const Eigen::VectorXd& gradient,
                                                double variance) const;

 private:
  enum class Each { all, loop, position };
  struct OfEffect {
    const joint::Effect* effect{};
    double scale{};
    Each each{Each::all};   ///< What has coefficients of its own.
    bool is_along{false};   ///< Changes along the loop.
    Eigen::Index first{};   ///< Of the coefficients.
    Eigen::Index width{1};  ///< Columns at a loop.
    Eigen::Index count{};   ///< Coefficients altogether.
    double precision{1};
  };
  [[nodiscard]] Eigen::MatrixXd columns_of(const LuGreLoopModel& model, std::size_t loop) const;
  /// Coefficients of a loop's columns.
  [[nodiscard]] std::vector<Eigen::Index> places_of(std::size_t loop) const;
  void add(const joint::Effect& effect, double scale, Each each, Eigen::Index width = 1,
           bool is_along = false);
  void put_up(const LuGreProblem& problem, const LuGreClimb& climb, const gravity::Ripple& ripple);
  struct Stack;
  [[nodiscard]] Stack stacked(const LuGreProblem& problem, const LuGreClimb& climb) const;
  void solve(const LuGreProblem& problem, const LuGreClimb& climb);
  void improve_sizes(const Eigen::VectorXd& mean, const Eigen::VectorXd& variance);
  void note_misfits(const Stack& stack);
  [[nodiscard]] bool asks_contact() const;
  void add_lag(const LuGreProblem& problem, const LuGreClimb& climb);

  KnownEffects known_;
  LuGrePoint point_;
  std::vector<OfEffect> all_;
  Eigen::Index coefficients_{0};
  Eigen::VectorXd mean_;
  Eigen::MatrixXd covariance_;
  Eigen::MatrixXd by_effects_;  ///< Shift of the fit's parameters per coefficient.
  Eigen::MatrixXd shifts_;
  std::vector<double> misfit_Nm_;       ///< Of each loop.
  std::vector<Eigen::Index> position_;  ///< Motor angle of each loop, numbered.
  Eigen::MatrixXd by_lag_;              ///< Shift of the fit's parameters, standard deviations.
};

}  // namespace tribolog::method::hysteresis
