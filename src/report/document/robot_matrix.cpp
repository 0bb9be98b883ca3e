#include "report/document/robot_matrix.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "calibration/friction_speeds.h"
#include "joint/quantity.h"
#include "report/document/view_parts.h"
#include "report/elements/result_words.h"
#include "wording/rounding.h"
#include "wording/torques_in.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::document {
namespace {

using calibration::Verdict;
using wording::tr;

/// What one joint has of a row.
struct Number {
  std::optional<statistics::Estimate> estimate;
  Verdict verdict{Verdict::not_identifiable};
  std::string unit;  ///< SI.
};

/// Of a joint; nothing: neither identified nor asked for.
using Numbers = std::vector<std::optional<Number>>;

joint::TorqueUnit torque_unit_of(const RobotJoint& joint) {
  return joint.calibration->manifest.torque_unit();
}

bool is_shown(const Number& number) {
  return number.estimate && number.verdict != Verdict::not_identifiable;
}

struct RowScale {
  wording::Scale scale;
  joint::TorqueUnit torque{joint::TorqueUnit::newton_metre};
};

/// That of the largest number.
RowScale scale_of(const std::vector<RobotJoint>& joints, const Numbers& numbers) {
  RowScale row;
  double largest = -1;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    if (!numbers[k] || !is_shown(*numbers[k])) continue;
    const double size = std::abs(numbers[k]->estimate->value);
    if (!(size > largest)) continue;
    largest = size;
    row.torque = torque_unit_of(joints[k]);
    const wording::TorquesIn unit(row.torque);
    row.scale = wording::quantity_scale(numbers[k]->unit, size);
  }
  return row;
}

/// With its own unit where the row's is another, as of a joint whose torque is in amperes.
std::string shown(const RobotJoint& joint, const Number& number, const RowScale& of_row) {
  if (!is_shown(number)) return "";
  const wording::TorquesIn unit(torque_unit_of(joint));
  if (torque_unit_of(joint) != of_row.torque) {
    return wording::in_words(*number.estimate,
                             wording::quantity_scale(number.unit, number.estimate->value));
  }
  const wording::RoundedEstimate text = wording::round_by_interval(*number.estimate, of_row.scale);
  const bool is_lopsided = text.half_width.empty() && !text.low.empty();
  return is_lopsided ? text.estimate + " (" + text.range() + ")" : text.plus_minus();
}

MatrixRow row_of(const std::string& words, const std::vector<RobotJoint>& joints,
                 const Numbers& numbers) {
  MatrixRow row;
  row.words = words;
  const RowScale scale = scale_of(joints, numbers);
  row.unit = scale.scale.unit;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    MatrixCell& cell = row.cells.emplace_back();
    if (!numbers[k]) continue;
    cell.text = shown(joints[k], *numbers[k], scale);
    cell.outcome = elements::outcome_of(numbers[k]->verdict);
    cell.verdict_word = elements::verdict_in_words(numbers[k]->verdict);
  }
  return row;
}

std::optional<Number> number_of(const RobotJoint& joint, joint::Quantity quantity) {
  if (joint.calibration == nullptr) return std::nullopt;
  const calibration::QuantityVerdict* const q = joint.calibration->judgement.find(quantity);
  if (q == nullptr || q->unit.empty() || is_merely_absent(*q)) return std::nullopt;
  Number number{q->estimate, q->verdict, q->unit};
  if (q->budget && q->estimate) number.estimate = q->budget->expanded;
  return number;
}

/// @param name as archives call the quantity.
void add_changes(const std::string& name, const std::vector<RobotJoint>& joints, MatrixRow& row) {
  for (std::size_t k = 0; k < joints.size(); ++k) {
    if (!joints[k].since_last) continue;
    const auto& all = joints[k].since_last->quantities;
    const auto found = std::find_if(
        all.begin(), all.end(), [&](const history::ComparedQuantity& c) { return c.name == name; });
    if (found == all.end() || !found->change) continue;
    MatrixCell& cell = row.cells[k];
    // An angle, and a number near zero, have none in percent.
    const wording::TorquesIn unit(torque_unit_of(joints[k]));
    const statistics::Estimate change = found->change->percent.value_or(found->change->absolute);
    const wording::Scale scale = found->change->percent
                                     ? wording::plain_scale("%")
                                     : wording::quantity_scale(found->unit, change.value);
    cell.change = wording::with_unit(
        wording::with_plus_sign(wording::significant(change.value * scale.factor, 2)), scale.unit);
    cell.is_changed = found->word == history::ChangeWord::changed;
    if (cell.is_changed) cell.change_word = wording::words(history::statement_of(found->word));
  }
}

/// In the order of the verdicts, which all calibrations share.
std::vector<joint::Quantity> quantities_of(const std::vector<RobotJoint>& joints) {
  std::vector<joint::Quantity> quantities;
  const auto known = std::find_if(joints.begin(), joints.end(), [](const RobotJoint& joint) {
    return joint.calibration != nullptr;
  });
  if (known == joints.end()) return quantities;
  for (const calibration::QuantityVerdict& q : known->calibration->judgement.quantities) {
    quantities.push_back(q.quantity);
  }
  return quantities;
}

void add_quantities(const std::vector<RobotJoint>& joints, std::vector<MatrixRow>& rows) {
  for (const joint::Quantity quantity : quantities_of(joints)) {
    Numbers numbers;
    bool is_any = false;
    for (const RobotJoint& joint : joints) {
      numbers.push_back(number_of(joint, quantity));
      is_any |= numbers.back().has_value();
    }
    if (!is_any) continue;
    const std::string key = to_string(quantity);
    rows.push_back(row_of(wording::words_for("quantity", key), joints, numbers));
    add_changes(key, joints, rows.back());
  }
}

/// At the speeds that an archive keeps, a few of them.
void add_friction(const std::vector<RobotJoint>& joints, std::vector<MatrixRow>& rows) {
  std::map<double, Numbers> at;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    if (joints[k].calibration == nullptr) continue;
    for (const calibration::FrictionAtSpeed& f :
         calibration::at_standard_speeds(joints[k].calibration->judgement.friction_at_speed)) {
      Numbers& numbers = at.try_emplace(f.speed_rad_s, joints.size()).first->second;
      numbers[k] = Number{f.torque_Nm, f.verdict, "N·m"};
    }
  }
  std::vector<double> speeds;
  for (const auto& [speed, numbers] : at) speeds.push_back(speed);
  for (const std::size_t which :
       calibration::evenly_in_log(speeds, calibration::speeds_of_a_table)) {
    const std::string speed = wording::with_unit(wording::as_stated(speeds[which]), "rad/s");
    rows.push_back(
        row_of(tr("Friction at {speed}", {{"speed", speed}}), joints, at.at(speeds[which])));
    add_changes(calibration::friction_name(speeds[which]), joints, rows.back());
  }
}

}  // namespace

std::vector<MatrixRow> robot_matrix(const std::vector<RobotJoint>& joints) {
  std::vector<MatrixRow> rows;
  add_quantities(joints, rows);
  add_friction(joints, rows);
  return rows;
}

}  // namespace tribolog::report::document
