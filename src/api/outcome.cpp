#include "api/outcome.h"

#include <cstddef>
#include <utility>

#include "calibration/archived_calibration.h"
#include "calibration/friction_speeds.h"
#include "wording/language.h"
#include "wording/torques_in.h"
#include "wording/words.h"

namespace tribolog::api {
namespace {

Check::State state_of(method::checks::CheckState state) {
  switch (state) {
    case method::checks::CheckState::passed:
      return Check::State::passed;
    case method::checks::CheckState::warns:
      return Check::State::warns;
    case method::checks::CheckState::fails:
      return Check::State::fails;
    case method::checks::CheckState::not_applicable:
      break;
  }
  return Check::State::not_applicable;
}

Stage::State state_of(statistics::StageState state) {
  switch (state) {
    case statistics::StageState::done:
      return Stage::State::done;
    case statistics::StageState::partial:
      return Stage::State::partial;
    case statistics::StageState::not_identifiable:
      return Stage::State::not_identifiable;
    case statistics::StageState::skipped:
      break;
  }
  return Stage::State::skipped;
}

std::vector<Said> all_said(const std::vector<Statement>& statements) {
  std::vector<Said> all;
  for (const Statement& one : statements) all.push_back(said(one));
  return all;
}

JudgedQuantity judged(const calibration::QuantityVerdict& q, double gear_ratio) {
  JudgedQuantity made;
  made.quantity.name = to_string(q.quantity);
  made.quantity.words = wording::words_for("quantity", made.quantity.name);
  made.quantity.unit = q.unit;
  made.quantity.verdict = verdict_of(q.verdict);
  made.quantity.decides = q.decides;
  if (q.estimate) set_estimate(made.quantity, *q.estimate, gear_ratio);
  made.reasons = all_said(q.reasons);
  made.experiment = said(q.experiment);
  return made;
}

MadeCheck made_check(const method::checks::DataCheck& c) {
  MadeCheck made;
  made.check.name = to_string(c.name);
  made.check.words = wording::words_for("check", made.check.name);
  made.check.state = state_of(c.state);
  made.check.recording = c.recording + (c.is_of_whole_role ? ", all" : "");
  made.check.measured = c.measured;
  made.check.at_least = c.at_least;
  made.check.at_most = c.at_most;
  made.check.unit = wording::shown_units(c.unit);
  made.found = said(c.found);
  made.consequence = said(c.consequence);
  made.experiment = said(c.experiment);
  return made;
}

ReadFile read_file_of(const joint::InputFile& f) {
  ReadFile made{{f.name, f.role, f.bytes, f.sha256, f.rows_read, f.rows_used, {}, false}, {}};
  for (const joint::SkippedRows& rows : f.skipped) {
    made.file.skipped.push_back({{}, rows.count});
    made.why_skipped.push_back(said(rows.reason));
  }
  made.file.is_recording = !f.conversions.empty();
  return made;
}

}  // namespace

Verdict verdict_of(calibration::Verdict verdict) {
  switch (verdict) {
    case calibration::Verdict::usable:
      return Verdict::usable;
    case calibration::Verdict::doubtful:
      return Verdict::doubtful;
    case calibration::Verdict::not_identifiable:
      break;
  }
  return Verdict::not_identifiable;
}

Joint joint_of(const joint::Manifest& m) {
  return {m.robot,
          m.serial,
          m.joint,
          m.measured_on,
          m.operator_name,
          m.note,
          m.payload,
          m.payload_kg,
          m.payload_distance_m,
          m.temperature_C,
          m.drive.gear_ratio(),
          m.torque_is_in_amperes};
}

joint::TorqueUnit torque_unit_of(const Joint& joint) {
  return joint.torque_is_in_amperes ? joint::TorqueUnit::ampere : joint::TorqueUnit::newton_metre;
}

Outcome outcome_of(const calibration::Calibration& c) {
  const wording::WordsIn english({});
  const wording::TorquesIn unit(c.manifest.torque_unit());
  Outcome made;
  made.joint = joint_of(c.manifest);
  made.verdict = verdict_of(c.judgement.verdict);
  made.sentence = said(c.judgement.sentence);
  made.findings = all_said(c.judgement.findings);
  for (const calibration::QuantityVerdict& q : c.judgement.quantities) {
    made.quantities.push_back(judged(q, made.joint.gear_ratio));
  }
  for (const calibration::FrictionAtSpeed& f : c.judgement.friction_at_speed) {
    made.friction_at_speeds.push_back(judged_friction(f, made.joint.gear_ratio, said(f.reason)));
  }
  for (const method::checks::DataCheck& check : c.data_checks.checks) {
    made.checks.push_back(made_check(check));
  }
  for (const statistics::StageReport& stage : c.stages()) {
    made.stages.push_back({{stage.name, state_of(stage.state), {}}, said(stage.reason)});
  }
  for (const joint::InputFile& file : c.inputs) made.inputs.push_back(read_file_of(file));
  made.estimator = to_string(c.selection.recommended);
  return made;
}

Said said(const Statement& statement) { return {statement, std::string(statement.code().text())}; }

void set_estimate(Quantity& quantity, const statistics::Estimate& at_motor, double gear_ratio) {
  quantity.estimate = {at_motor.value, at_motor.low, at_motor.high};
  if (!calibration::gear_power(quantity.name)) return;
  const statistics::Estimate there = calibration::at_joint(
      {quantity.name, "", quantity.unit, calibration::Verdict::usable, at_motor}, gear_ratio);
  quantity.at_joint = {there.value, there.low, there.high};
}

JudgedFriction judged_friction(const calibration::FrictionAtSpeed& at_motor, double gear_ratio,
                               Said reason) {
  const calibration::FrictionAtSpeed there = calibration::at_joint(at_motor, gear_ratio);
  const auto estimate = [](const statistics::Estimate& e) {
    return Estimate{e.value, e.low, e.high};
  };
  JudgedFriction judged{{at_motor.speed_rad_s,
                         estimate(at_motor.torque_Nm),
                         there.speed_rad_s,
                         estimate(there.torque_Nm),
                         verdict_of(at_motor.verdict),
                         {},
                         at_motor.is_stated,
                         {},
                         {}},
                        std::move(reason)};
  if (at_motor.forward_Nm) judged.friction.forward = estimate(*at_motor.forward_Nm);
  if (at_motor.backward_Nm) judged.friction.backward = estimate(*at_motor.backward_Nm);
  return judged;
}

Message message_of(const Said& one) { return {one.code, wording::words(one.statement)}; }

std::vector<Message> messages_of(const std::vector<Said>& all) {
  std::vector<Message> messages;
  for (const Said& one : all) messages.push_back(message_of(one));
  return messages;
}

Quantity worded(const JudgedQuantity& judged) {
  Quantity made = judged.quantity;
  made.words = wording::words_for("quantity", made.name, made.words);
  made.reasons = messages_of(judged.reasons);
  made.experiment = message_of(judged.experiment);
  return made;
}

FrictionAtSpeed worded(const JudgedFriction& judged) {
  FrictionAtSpeed made = judged.friction;
  made.reason = message_of(judged.reason);
  return made;
}

Check worded(const MadeCheck& one) {
  Check made = one.check;
  made.words = wording::words_for("check", made.name, made.words);
  made.found = message_of(one.found);
  made.consequence = message_of(one.consequence);
  made.experiment = message_of(one.experiment);
  return made;
}

Stage worded(const EndedStage& ended) {
  Stage made = ended.stage;
  made.reason = message_of(ended.reason);
  return made;
}

InputFile worded(const ReadFile& read) {
  InputFile made = read.file;
  for (std::size_t k = 0; k < made.skipped.size(); ++k) {
    made.skipped[k].reason = message_of(read.why_skipped[k]);
  }
  return made;
}

}  // namespace tribolog::api
