#include "ingest/dataset/arm_in_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/error.h"
#include "base/requirements.h"
#include "base/statement.h"
#include "ingest/manifest/urdf_file.h"

namespace tribolog::ingest::dataset {
namespace {

std::optional<std::size_t> place_of(const std::string& name,
                                    const std::vector<std::string>& names) {
  const auto it = std::find(names.begin(), names.end(), name);
  if (it == names.end()) return std::nullopt;
  return static_cast<std::size_t>(it - names.begin());
}

/// With what stands before and behind it where there are gaps; empty: nothing but gaps.
std::vector<double> without_gaps(std::vector<double> values) {
  std::size_t last = values.size();  // that was a number
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    const double before = last < values.size() ? values[last] : values[i];
    const std::size_t first = last < values.size() ? last + 1 : 0;
    for (std::size_t k = first; k < i; ++k) {
      const double share = last < values.size()
                               ? static_cast<double>(k - last) / static_cast<double>(i - last)
                               : 1.0;
      values[k] = before + share * (values[i] - before);
    }
    last = i;
  }
  if (last == values.size()) return {};
  for (std::size_t k = last + 1; k < values.size(); ++k) values[k] = values[last];
  return values;
}

constexpr double turn_rad = 2 * std::numbers::pi;
constexpr double standing_rad = 0.02;  // a joint that moves by less stands

/// On through the ends of a range of one turn: no joint turns by half a turn from sample to sample.
void go_on(std::vector<double>& angles_rad) {
  for (std::size_t i = 1; i < angles_rad.size(); ++i) {
    angles_rad[i] -= turn_rad * std::round((angles_rad[i] - angles_rad[i - 1]) / turn_rad);
  }
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

const log::LogColumn* column_of(const ReadLog& log, const std::string& name) {
  const auto apart = log.others.find(name);
  if (apart != log.others.end()) return &apart->second;
  for (const log::LogColumn& column : log.table.columns) {
    if (column.header.name == name || column.header.full == name) return &column;
  }
  return nullptr;
}

std::vector<std::string> names_in(const robot::WeightedArm& arm) {
  std::vector<std::string> names;
  for (const robot::WeightedJoint& joint : arm.joints()) {
    if (!joint.follows) names.push_back(joint.name);
  }
  return names;
}

}  // namespace

double gravity_of_others_Nm(const robot::WeightedArm& arm, std::size_t joint,
                            const std::vector<double>& positions, std::vector<double> held,
                            const Eigen::Vector3d& gravity_m_s2) {
  held[joint] = positions[joint];
  if (held == positions) return 0;
  return arm.holding_torque_Nm(joint, positions, gravity_m_s2) -
         arm.holding_torque_Nm(joint, held, gravity_m_s2);
}

ArmInMotion::ArmInMotion(const joint::Manifest& manifest) : tested_name_(manifest.joint) {
  for (const joint::OtherJoint& joint : manifest.other_joints) others_.push_back({joint});
}

void ArmInMotion::describe(std::string_view urdf, const std::string& path,
                           const std::vector<std::string>& joints) {
  arm_ = manifest::parse_urdf(urdf, path);
  const std::vector<std::string> described = names_in(*arm_);
  std::vector<std::string> named{tested_name_};
  for (const Other& other : others_) named.push_back(other.joint.name);
  const auto is_described = [&](const std::string& name) {
    return place_of(name, described).has_value();
  };
  const bool none_is_described = std::none_of(named.begin(), named.end(), is_described);
  is_by_order_ = none_is_described && joints.size() == described.size();
  const auto in_arm = [&](const std::string& name) {
    const std::optional<std::size_t> place =
        is_by_order_ ? place_of(name, joints) : place_of(name, described);
    if (!place) {
      throw InputError({path, 0, 0},
                       {"has no such joint", in_quotes(name), "one of " + list_of_names(described),
                        joints.empty() || joints.size() == described.size()
                            ? did_you_mean(name, described)
                            : fmt::format("the manifest has {} joints, the description {}: "
                                          "they are matched by their names",
                                          joints.size(), described.size())});
    }
    const auto it = std::find_if(
        arm_->joints().begin(), arm_->joints().end(),
        [&](const robot::WeightedJoint& one) { return one.name == described[*place]; });
    return static_cast<std::size_t>(it - arm_->joints().begin());
  };
  tested_ = in_arm(tested_name_);
  if (arm_->joints()[tested_].motion == robot::JointMotion::sliding) {
    throw InputError({path, 0, 0},
                     {"the tested joint slides", in_quotes(arm_->joints()[tested_].name),
                      "revolute or continuous", ""});
  }
  std::vector<bool> is_known(arm_->size(), false);
  is_known[tested_] = true;
  for (Other& other : others_) {
    other.in_arm = in_arm(other.joint.name);
    is_known[present(other.in_arm)] = true;
  }
  for (std::size_t k = 0; k < arm_->size(); ++k) {
    const robot::WeightedJoint& joint = arm_->joints()[k];
    if (is_known[k] || joint.follows) continue;
    Other other;
    other.joint.name = joint.name;
    other.joint.angle = joint.name + ".position";
    other.joint.stated_at = path;
    other.in_arm = k;
    other.is_looked_for = true;
    others_.push_back(std::move(other));
  }
}

std::vector<std::string> ArmInMotion::columns() const {
  std::vector<std::string> names;
  for (const Other& other : others_) names.push_back(other.joint.angle);
  return names;
}

void ArmInMotion::add_found(const ReadLog& log) {
  if (arm_) return;  // its joints are looked for by their names
  for (const joint::OtherJoint& found : log.found_others) {
    const auto is_known = [&](const Other& other) {
      return other.joint.name == found.name || other.joint.angle == found.angle;
    };
    if (std::any_of(others_.begin(), others_.end(), is_known)) continue;
    Other& other = others_.emplace_back();
    other.joint = found;
    other.is_looked_for = true;
    other.angles_rad.resize(recordings_);
  }
}

void ArmInMotion::keep(const ReadLog& log, const std::vector<std::size_t>& rows) {
  add_found(log);
  ++recordings_;
  for (Other& other : others_) {
    std::vector<double>& angles_rad = other.angles_rad.emplace_back();
    const log::LogColumn* column = column_of(log, other.joint.angle);
    if (column == nullptr) continue;
    angles_rad.reserve(rows.size());
    for (const std::size_t row : rows) {
      angles_rad.push_back(column->values[row] * other.joint.radian_per_unit);
    }
    angles_rad = without_gaps(std::move(angles_rad));
    go_on(angles_rad);
  }
}

void ArmInMotion::count_motions(joint::Dataset& dataset) const {
  std::vector<joint::OtherJoint>& counted = dataset.manifest.other_joints;
  counted.clear();
  for (const Other& other : others_) {
    joint::OtherJoint joint = other.joint;
    for (const std::vector<double>& angles_rad : other.angles_rad) {
      if (angles_rad.empty()) continue;
      const auto [lowest, highest] = std::minmax_element(angles_rad.begin(), angles_rad.end());
      // The same angle may be logged a turn apart.
      const double middle_rad = (joint.lowest_rad + joint.highest_rad) / 2;
      const double apart_rad =
          joint.samples > 0
              ? turn_rad * std::round(((*lowest + *highest) / 2 - middle_rad) / turn_rad)
              : 0.0;
      const double low_rad = *lowest - apart_rad;
      const double high_rad = *highest - apart_rad;
      joint.lowest_rad = joint.samples > 0 ? std::min(joint.lowest_rad, low_rad) : low_rad;
      joint.highest_rad = joint.samples > 0 ? std::max(joint.highest_rad, high_rad) : high_rad;
      joint.samples += angles_rad.size();
    }
    const bool moves = !arm_ && joint.travel_rad() > standing_rad;
    for (std::size_t k = 0; moves && k < dataset.recordings.size(); ++k) {
      dataset.recordings[k].others_q_rad.push_back(other.angles_rad[k]);
    }
    if (!other.is_looked_for || joint.samples > 0) counted.push_back(std::move(joint));
  }
}

std::size_t ArmInMotion::first_with_angles(const joint::Dataset& dataset) const {
  const auto has_angles = [&](std::size_t k) {
    return std::any_of(others_.begin(), others_.end(),
                       [&](const Other& other) { return !other.angles_rad[k].empty(); });
  };
  std::size_t first = dataset.recordings.size();
  for (std::size_t k = 0; k < dataset.recordings.size(); ++k) {
    if (!has_angles(k)) continue;
    if (dataset.recordings[k].role == joint::Role::rough_sweep) return k;
    first = std::min(first, k);
  }
  return first;
}

std::vector<double> ArmInMotion::held(const joint::Dataset& dataset) const {
  std::vector<double> positions(present(arm_).size(), 0.0);
  const std::size_t first = first_with_angles(dataset);
  if (first == dataset.recordings.size()) return positions;
  for (const Other& other : others_) {
    const std::vector<double>& angles_rad = other.angles_rad[first];
    if (!angles_rad.empty()) positions[present(other.in_arm)] = mean_of(angles_rad);
  }
  return positions;
}

void ArmInMotion::note_assumptions(joint::Dataset& dataset) const {
  const joint::ArmGravity& stated = present(dataset.manifest.arm_gravity);
  const std::string file = printable(stated.description);
  if (is_by_order_) {
    dataset.notes.push_back({"reading.arm_matched_by_order",
                             {{"file", file},
                              {"joint", in_quotes(tested_name_)},
                              {"described", in_quotes(stated.tested)}}});
  }
  std::vector<std::string> at_zero;
  for (const joint::HeldJoint& one : stated.held) {
    if (!one.is_logged) at_zero.push_back(one.name);
  }
  if (!at_zero.empty()) {
    dataset.notes.push_back(
        {"reading.arm_joints_at_zero", {{"file", file}, {"joints", list_of_names(at_zero)}}});
  }
  for (std::size_t k = 0; k < dataset.recordings.size(); ++k) {
    const bool is_logged = std::any_of(others_.begin(), others_.end(), [&](const Other& other) {
      return !other.angles_rad[k].empty();
    });
    const bool is_any = at_zero.size() < stated.held.size();
    if (is_logged || !is_any) continue;
    const Statement note{"reading.others_not_logged",
                         {{"file", printable(dataset.recordings[k].name)}, {"description", file}}};
    const auto& notes = dataset.notes;
    if (std::find(notes.begin(), notes.end(), note) == notes.end()) dataset.notes.push_back(note);
  }
}

void ArmInMotion::take_gravity_off(joint::Dataset& dataset) const {
  count_motions(dataset);
  if (!arm_) return;
  joint::ArmGravity& stated = present(dataset.manifest.arm_gravity);
  const std::vector<double> held_rad = held(dataset);
  const Eigen::Vector3d gravity(stated.gravity_m_s2[0], stated.gravity_m_s2[1],
                                stated.gravity_m_s2[2]);
  stated.tested = arm_->joints()[tested_].name;
  stated.is_by_order = is_by_order_;
  stated.own = arm_->gravity_of(tested_, held_rad, gravity);
  for (const Other& other : others_) {
    const bool is_logged =
        std::any_of(other.angles_rad.begin(), other.angles_rad.end(),
                    [](const std::vector<double>& angles_rad) { return !angles_rad.empty(); });
    stated.held.push_back(
        {arm_->joints()[present(other.in_arm)].name, held_rad[present(other.in_arm)], is_logged});
  }
  const double gear_ratio = dataset.manifest.drive.gear_ratio();
  for (std::size_t k = 0; k < dataset.recordings.size(); ++k) {
    joint::Recording& recording = dataset.recordings[k];
    const bool is_logged = std::any_of(others_.begin(), others_.end(), [&](const Other& other) {
      return !other.angles_rad[k].empty();
    });
    if (!is_logged || recording.torque_Nm.empty()) continue;
    recording.others_gravity_Nm.resize(recording.size());
    std::vector<double> positions = held_rad;
    for (std::size_t i = 0; i < recording.size(); ++i) {
      positions[tested_] = recording.q_rad[i];
      for (const Other& other : others_) {
        const std::vector<double>& angles_rad = other.angles_rad[k];
        if (!angles_rad.empty()) positions[present(other.in_arm)] = angles_rad[i];
      }
      const double torque_Nm = gravity_of_others_Nm(*arm_, tested_, positions, held_rad, gravity);
      recording.others_gravity_Nm[i] = torque_Nm / gear_ratio;
      recording.torque_Nm[i] -= recording.others_gravity_Nm[i];
      stated.largest_Nm = std::max(stated.largest_Nm, std::abs(torque_Nm));
    }
    stated.samples += recording.size();
  }
  note_assumptions(dataset);
}

}  // namespace tribolog::ingest::dataset
