#pragma once
// The catalogue of what acts on a joint's torque, as it is logged, beside gravity, inertia and one
// law of friction. Each effect is a row: a prior of physically typical size with a heavy tail and a
// cap. A manifest may state another size, or that there is none of it:
//
//   [effects]
//   hoses_percent = 0        # key and unit of the row
//   lag_ms = 0.2

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tribolog::joint {

/// Coefficients are size x lambda x N(0,1); lambda^2 ~ inverse gamma(dof/2, dof/2), so that the
/// coefficients of an effect are Student-t together; lambda <= cap.
struct Effect {
  enum class Kind {
    core,    ///< Gravity, inertia: free.
    effect,  ///< Its size is asked of the data.
    fixed,   ///< Its size stays as stated or typical.
    random,  ///< One coefficient for each recording: what nothing explains.
  };
  std::string_view key;  ///< "lag"; of messages too.
  Kind kind{Kind::effect};
  double typical{};           ///< Size, in the unit.
  std::string_view unit{};    ///< "percent", "ms", "mrad"; empty: nobody can state it.
  std::string_view remedy{};  ///< Code of what to record where most of an interval comes from it.
  double dof{2};
  double cap{30};

  [[nodiscard]] constexpr double least_precision() const { return 1 / (cap * cap); }
  /// "lag_ms": of the manifest.
  [[nodiscard]] std::string stated_key() const;
};

// Percent of the largest torque, where nothing else is said.
namespace effect {
inline constexpr Effect gravity{"gravity", Effect::Kind::core};
inline constexpr Effect inertia{"inertia", Effect::Kind::core};
/// Gravity of a joint stated to have none.
inline constexpr Effect gravity_left{
    "gravity_left", Effect::Kind::effect, 2, "percent", "record.with_load", 2, 10};
inline constexpr Effect offset{
    "offset", Effect::Kind::effect, 0.5, "percent", "record.whole_turn", 2, 10};
inline constexpr Effect offset_drift{
    "offset_drift", Effect::Kind::effect, 0.2, "percent", "record.warmed_up", 2, 15};
// Gains: magnets and sensors change by parts in a thousand, never by more than 4 %. A real log
// always misfits somewhere, and without a cap a wrong gain of 40 % explains some of it.
/// Percent of the torque itself, as the next three.
inline constexpr Effect gain_drift{
    "gain_drift", Effect::Kind::effect, 0.2, "percent", "record.warmed_up", 4, 20};
inline constexpr Effect torque_nonlinear{
    "torque_nonlinear", Effect::Kind::effect, 0.15, "percent", "record.torque_at_loads", 3, 20};
inline constexpr Effect gain_of_speed{
    "gain_of_speed", Effect::Kind::effect, 0.1, "percent", "record.torque_measured", 4, 30};
inline constexpr Effect gain_of_runs{
    "gain_of_runs", Effect::Kind::effect, 0.2, "percent", "record.one_session", 4, 25};
/// Percent of gravity: by how much it is another in the runs, as with another tool.
inline constexpr Effect tool{"tool", Effect::Kind::effect, 0.05, "percent", "record.one_tool", 2,
                             300};
inline constexpr Effect lag{"lag", Effect::Kind::effect, 1, "ms", "record.no_lag", 2, 20};
/// Gravity that other joints change, of which nothing but their angles is known.
inline constexpr Effect others_gravity{"others_gravity",
                                       Effect::Kind::effect,
                                       30,
                                       "percent",
                                       "record.others_at_rest_or_described",
                                       2,
                                       5};
/// The torque that their acceleration takes.
inline constexpr Effect others_inertia{
    "others_inertia", Effect::Kind::effect, 30, "percent", "record.other_joints_at_rest", 2, 5};
/// Percent of the friction: by how much it differs with the direction.
inline constexpr Effect asymmetry{
    "asymmetry", Effect::Kind::effect, 5, "percent", "record.both_directions", 2, 15};
/// Friction's growth, in percent of the gravity torque.
inline constexpr Effect load{
    "load", Effect::Kind::effect, 1, "percent", "record.friction_without_load", 2, 10};
/// Percent of the friction: by how much it changes over the joint's angle.
inline constexpr Effect position{"position", Effect::Kind::effect, 2, "percent", "record.runs", 2,
                                 15};
/// Percent of the friction: by how much it changes over the motor's turn.
inline constexpr Effect motor_turn{
    "motor_turn", Effect::Kind::effect, 1, "percent", "record.runs", 2, 30};
inline constexpr Effect torque_over_turn{
    "torque_over_turn", Effect::Kind::effect, 0.5, "percent", "record.whole_turn", 2, 20};
/// From the middle to the end of the angles.
inline constexpr Effect hoses{"hoses", Effect::Kind::effect, 0.1, "percent", "record.whole_turn", 2,
                              50};
/// Percent of the angle.
inline constexpr Effect angle_scale{
    "angle_scale", Effect::Kind::effect, 0.1, "percent", "record.whole_turn", 4, 15};
inline constexpr Effect peak_drift{
    "peak_drift", Effect::Kind::effect, 1, "mrad", "record.one_homing", 2, 30};
/// Where the angle's zero is in each sweep, and in the runs.
inline constexpr Effect homing{"homing", Effect::Kind::effect, 0.3, "mrad", "record.one_homing", 2,
                               100};
inline constexpr Effect harmonics{
    "harmonics", Effect::Kind::effect, 0.05, "percent", "record.whole_turn", 2, 100};
inline constexpr Effect smooth_over_angle{
    "smooth_over_angle", Effect::Kind::effect, 0.05, "percent", "record.whole_turn", 2, 40};
/// Percent of the friction: by how much it changes over the session.
inline constexpr Effect drift{"drift", Effect::Kind::effect, 1, "percent", "record.warmed_up", 2,
                              50};
/// Percent of the friction: what no law of friction over the speed is exact about.
inline constexpr Effect law_misfit{
    "law_misfit", Effect::Kind::effect, 1, "percent", "record.runs", 2, 5};
/// The same, along Coulomb and viscous torque: as law_misfit is stated.
inline constexpr Effect law_at_its_ends{
    "law_at_its_ends", Effect::Kind::fixed, 0.2, {}, "record.runs"};
/// Percent of friction at rest: by how much the contact differs from LuGre's on the way after a
/// reversal.
inline constexpr Effect contact_misfit{
    "contact_misfit", Effect::Kind::effect, 0.3, "percent", "record.compare_reversals", 2, 30};
/// Percent of the friction: on another day it is another by temperature, lubricant, wear.
inline constexpr Effect friction_of_session{"friction_of_session", Effect::Kind::fixed, 2,
                                            "percent", "record.other_days"};
/// Of its own in each recording: a sensor tared between them.
inline constexpr Effect tare{"tare", Effect::Kind::effect, 0.03, "percent", "record.one_tare", 2,
                             300};
/// Percent of the friction: of its own in each recording.
inline constexpr Effect friction_of_recording{
    "friction_of_recording", Effect::Kind::random, 0.1, "percent", "record.repeated_runs", 2, 300};
}  // namespace effect

/// All but gravity and inertia.
const std::vector<Effect>& effects();
/// Those that a manifest can state.
const std::vector<Effect>& statable_effects();

/// Sizes that a manifest states, by the effects' keys; what is not stated is as typical.
class EffectSizes {
 public:
  void state(const Effect& effect, double size) { stated_[std::string(effect.key)] = size; }
  void forget(const Effect& effect) { stated_.erase(std::string(effect.key)); }
  [[nodiscard]] bool is_stated(const Effect& effect) const {
    return stated_.find(effect.key) != stated_.end();
  }
  /// In the effect's unit.
  [[nodiscard]] double of(const Effect& effect) const;
  [[nodiscard]] const std::map<std::string, double, std::less<>>& stated() const { return stated_; }

  bool operator==(const EffectSizes&) const = default;

 private:
  std::map<std::string, double, std::less<>> stated_;
};

}  // namespace tribolog::joint
