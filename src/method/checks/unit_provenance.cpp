// Are the units of the angle and of the clock stated, or only proposed by a program?

#include <initializer_list>
#include <numbers>
#include <utility>

#include "method/checks/check_list.h"

namespace tribolog::method::checks {

namespace {

/// The first column of a signal whose unit is proposed; null: all are stated.
const joint::ColumnConversion* first_proposed(const joint::InputFile& input,
                                              joint::LoggedSignal signal) {
  for (const joint::ColumnConversion& c : input.conversions) {
    if (c.signal == signal && c.is_proposed) return &c;
  }
  return nullptr;
}

/// A speed is read of friction points alone; the others' come from the angle and the clock.
bool is_read(const joint::InputFile& input, joint::LoggedSignal signal) {
  return signal != joint::LoggedSignal::speed ||
         input.role == joint::to_string(joint::Role::friction_points);
}

/// The check of some signals' units: passed where all are stated.
DataCheck check_units(CheckName name, const CheckedDataset& data,
                      std::initializer_list<joint::LoggedSignal> signals) {
  DataCheck check;
  check.name = name;
  for (const joint::InputFile& input : *data.inputs) {
    for (const joint::LoggedSignal signal : signals) {
      const auto* const proposed = is_read(input, signal) ? first_proposed(input, signal) : nullptr;
      if (proposed == nullptr) continue;
      check.recording = input.name;
      check.state = CheckState::fails;
      check.found = {"unit.proposed", {{"unit", proposed->unit}, {"column", proposed->column}}};
      return check;
    }
  }
  return passed_by_all(check, {"unit.stated"});
}

}  // namespace

DataCheck check_angle_provenance(const CheckedDataset& data) {
  // In any other unit a cosine would not fit over a whole turn.
  constexpr double whole_turn_rad = 0.97 * 2 * std::numbers::pi;
  DataCheck check = check_units(CheckName::angle_provenance, data, {joint::LoggedSignal::angle});
  if (check.state == CheckState::passed) return check;
  if (torque_follows_the_cosine(data, whole_turn_rad)) {
    Statement proof = Statement::with("unit.proved_by_gravity", check.found.values());
    return passed_by_all(std::move(check), std::move(proof));
  }
  check.consequence = {"unit.angle_wrong"};
  check.experiment = {"unit.state_angle"};
  return check;
}

DataCheck check_speed_provenance(const CheckedDataset& data) {
  DataCheck check = check_units(CheckName::speed_provenance, data,
                                {joint::LoggedSignal::time, joint::LoggedSignal::speed});
  if (check.state == CheckState::passed) return check;
  check.consequence = {"unit.speed_wrong"};
  check.experiment = {"unit.state_speed"};
  return check;
}

}  // namespace tribolog::method::checks
