#pragma once
// What every friction model provides: its parameters by name, and its torque, as a function of
// speed alone or through a state that the motion changes.

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace tribolog::friction {

// Springs in parallel, each with a slider of its own: hysteresis with non-local memory.

/// One spring and slider.
struct MaxwellElement {
  double stiffness_Nm_rad{};  ///< > 0
  double share{};             ///< Share of the total torque at which it slips, > 0; all add up to
                              ///< 1.
  friend bool operator==(const MaxwellElement&, const MaxwellElement&) = default;
};

/// Elements that slip one after another in virgin loading, at equally spaced deflections: the
/// virgin curve is the polygon through points of T(x) = Ts (1 - (1 - x/xs)^2).
/// @param stiffness_Nm_rad of all together before the first slip, > 0
/// @param static_Nm torque at which the last one slips, > 0
/// @throw Refusal stating the value and the rule.
std::vector<MaxwellElement> maxwell_elements(double stiffness_Nm_rad, double static_Nm, int count);

/// @throw Refusal if there are no elements, a value is not > 0 or the shares do not add up to 1.
void require_maxwell_elements(const std::vector<MaxwellElement>& elements);

// Parameters of a friction model by name: as files state them and listings show them.
//
// A model's Parameters say once, in by_name(), what each of their members is called in a file. Code
// that reads, writes or lists parameters uses that and knows no model.

/// A physical number, a count, or the elements of a Maxwell-slip model.
using ParameterValue = std::variant<double, std::uint64_t, std::vector<MaxwellElement>>;

struct NamedParameter {
  std::string key;   ///< With its unit: "attraction_Nm_s".
  bool has_usual{};  ///< The literature has a usual value, the default of `value`.
  ParameterValue value;
  friend bool operator==(const NamedParameter&, const NamedParameter&) = default;
};
using NamedParameters = std::vector<NamedParameter>;

/// Where a model's Parameters keep one of them.
struct ParameterSlot {
  const char* key;
  std::variant<double*, std::uint64_t*, std::vector<MaxwellElement>*> place;
  bool has_usual{false};
};
using ParameterSlots = std::vector<ParameterSlot>;

/// One list after the other.
ParameterSlots joined(std::initializer_list<ParameterSlots> parts);

NamedParameters values_of(const ParameterSlots& slots);

/// Of a model's Parameters.
template <class Parameters>
NamedParameters named(Parameters parameters) {
  return values_of(parameters.by_name());
}

/// Puts each value into the slot of its key.
/// @throw Refusal for a key or a kind of value that the slots do not have.
void set_values(const ParameterSlots& slots, const NamedParameters& values);

/// A model with memory or without: its name and named parameters.
class FrictionModel {
 public:
  virtual ~FrictionModel() = default;
  /// As in files: "gms".
  [[nodiscard]] virtual std::string name() const = 0;
  /// As files state them, in the header's order.
  [[nodiscard]] virtual NamedParameters named_parameters() const = 0;
};

// A short piece of prescribed motion, as friction models advance over it.

/// -1, 0 or 1.
inline double direction_of(double speed_rad_s) {
  return speed_rad_s > 0 ? 1.0 : speed_rad_s < 0 ? -1.0 : 0.0;
}

/// Speed over a step, as the parabola through its start, middle and end. No two of these have
/// opposite signs: a motion is cut at its reversals before models see it.
struct SpeedStep {
  double start_rad_s{};
  double middle_rad_s{};
  double end_rad_s{};
  double duration_s{};

  /// Signed travel [rad]; exact for the parabola.
  [[nodiscard]] double path_rad() const {
    return duration_s / 6 * (start_rad_s + 4 * middle_rad_s + end_rad_s);
  }
  /// -1, 0 or 1.
  [[nodiscard]] double direction() const {
    return direction_of(start_rad_s + middle_rad_s + end_rad_s);
  }
  /// At a share (0..1) of the duration.
  [[nodiscard]] double speed_rad_s(double share) const {
    const double rise = end_rad_s - start_rad_s;
    const double bend = 2 * (start_rad_s + end_rad_s - 2 * middle_rad_s);
    const double inside = share * (share - 1);
    return start_rad_s + rise * share + bend * inside;
  }
  /// The piece between two shares of the duration.
  [[nodiscard]] SpeedStep part(double from, double to) const {
    return {speed_rad_s(from), speed_rad_s((from + to) / 2), speed_rad_s(to),
            (to - from) * duration_s};
  }
};

// Models with memory.
//
// A model turns the motion of the shaft into a friction torque through a state that the motion
// changes: deflections of bristles, torques of elements, a lagged speed. Angle and torque may
// equally be displacement [m] and force [N]: the equations are the same.

class DynamicFriction : public FrictionModel {
 public:
  /// How many numbers the state has.
  [[nodiscard]] virtual std::size_t states() const = 0;

  /// The state of a contact that has never been loaded: all zero unless the model says otherwise.
  [[nodiscard]] virtual std::vector<double> unloaded() const {
    return std::vector<double>(states(), 0.0);
  }

  /// d(state)/dt at a speed. Discrete members of a state (an element slips or sticks) have rate 0
  /// and are changed by settle() only.
  virtual void rates(std::span<const double> state, double speed_rad_s,
                     std::span<double> rates) const = 0;

  /// Brings the discrete members of a state in line with its continuous ones and the speed: what a
  /// solver of ordinary differential equations calls after each of its steps. Most models have
  /// none.
  virtual void settle(std::span<double> /*state*/, double /*speed_rad_s*/) const {}

  /// How many values event_values() gives.
  [[nodiscard]] virtual std::size_t events() const { return 0; }
  /// Values whose zeros are the instants at which settle() would change the state; a solver stops
  /// there. A reversal of the speed is always such an instant and is not among them.
  virtual void event_values(std::span<const double> /*state*/, double /*speed_rad_s*/,
                            std::span<double> /*values*/) const {}

  /// The usual magnitude of each member of a state: the scale of a solver's error tolerance.
  virtual void state_scales(std::span<double> scales) const = 0;

  /// Friction torque [N·m], positive where it resists a positive speed.
  [[nodiscard]] virtual double torque_Nm(std::span<const double> state,
                                         double speed_rad_s) const = 0;

  /// Torque [N·m] to which sliding at this constant speed settles; 0 at rest.
  [[nodiscard]] virtual double steady_torque_Nm(double speed_rad_s) const = 0;

  /// Advances the state over a piece of prescribed motion, with the model's own method: exact where
  /// the model allows it, and never limited by its stiffness.
  virtual void advance(std::span<double> state, const SpeedStep& step) const = 0;

  /// Advances over consecutive steps and reads the torque [N·m] at the end of each. Equivalent to
  /// advance() and torque_Nm() in turn; a model that needs the same numbers for a step's end and
  /// the next one's start can do better.
  /// @param torque_Nm out: one per step.
  virtual void respond(std::span<double> state, std::span<const SpeedStep> steps,
                       std::span<double> torque_Nm) const {
    for (std::size_t i = 0; i < steps.size(); ++i) {
      advance(state, steps[i]);
      torque_Nm[i] = this->torque_Nm(state, steps[i].end_rad_s);
    }
  }
};

// Friction without memory: torque as a function of speed.

class StaticFriction : public FrictionModel {
 public:
  /// Friction torque [N·m] at signed speed [rad/s]; odd. 0 at rest, where a law that is
  /// discontinuous there leaves it open (static_laws.h).
  [[nodiscard]] virtual double torque_Nm(double speed_rad_s) const = 0;
};

/// The steady state of a model with memory at constant speed; has that model's name and parameters.
class SteadyFriction final : public StaticFriction {
 public:
  /// @throw std::invalid_argument if there is no model.
  explicit SteadyFriction(std::shared_ptr<const DynamicFriction> model);

  [[nodiscard]] std::string name() const override { return model_->name(); }
  [[nodiscard]] NamedParameters named_parameters() const override {
    return model_->named_parameters();
  }
  [[nodiscard]] double torque_Nm(double speed_rad_s) const override {
    return model_->steady_torque_Nm(speed_rad_s);
  }

 private:
  std::shared_ptr<const DynamicFriction> model_;
};

}  // namespace tribolog::friction
