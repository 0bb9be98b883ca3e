#pragma once
// What a calibration says, whether it was identified just now or read from JSON: what the door's
// values are made of, their texts apart, which have a language.

#include <string>
#include <vector>

#include "base/statement.h"
#include "calibration/calibration.h"
#include "joint/dataset.h"
#include "tribolog/values.h"

namespace tribolog::api {

/// Something stated. What an older program wrote has words alone.
struct Said {
  Statement statement;  ///< Verbatim where the code is not known here.
  std::string code;     ///< Empty: it has none.
};

struct JudgedQuantity {
  Quantity quantity;
  std::vector<Said> reasons;
  Said experiment;
};

struct JudgedFriction {
  FrictionAtSpeed friction;
  Said reason;
};

struct MadeCheck {
  Check check;
  Said found;
  Said consequence;
  Said experiment;
};

struct EndedStage {
  Stage stage;
  Said reason;
};

struct ReadFile {
  InputFile file;
  std::vector<Said> why_skipped;  ///< One for each of the file's `skipped`.
};

struct Outcome {
  Joint joint;
  Verdict verdict{Verdict::not_identifiable};
  Said sentence;
  std::vector<Said> findings;
  std::vector<JudgedQuantity> quantities;
  std::vector<JudgedFriction> friction_at_speeds;
  std::vector<MadeCheck> checks;
  std::vector<EndedStage> stages;
  std::vector<ReadFile> inputs;
  std::string estimator;
};

Joint joint_of(const joint::Manifest& manifest);
Verdict verdict_of(calibration::Verdict verdict);

Outcome outcome_of(const calibration::Calibration& calibration);

/// Of the text that calibration_json() gives, of any age.
/// @param file its name, for messages. @throw InputError as calibration::read_calibration().
Outcome read_outcome(const std::string& json, const std::string& file);

Said said(const Statement& statement);

joint::TorqueUnit torque_unit_of(const Joint& joint);

/// Sets the estimate on both sides of the gear.
void set_estimate(Quantity& quantity, const statistics::Estimate& at_motor, double gear_ratio);

/// On both sides of the gear. @param reason as it is said.
JudgedFriction judged_friction(const calibration::FrictionAtSpeed& at_motor, double gear_ratio,
                               Said reason);

// The values with their texts, in the language of this thread's words.

Message message_of(const Said& one);
std::vector<Message> messages_of(const std::vector<Said>& all);
Quantity worded(const JudgedQuantity& judged);
FrictionAtSpeed worded(const JudgedFriction& judged);
Check worded(const MadeCheck& made);
Stage worded(const EndedStage& ended);
InputFile worded(const ReadFile& read);

}  // namespace tribolog::api
