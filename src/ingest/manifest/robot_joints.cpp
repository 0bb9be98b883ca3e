#include "ingest/manifest/robot_joints.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/error.h"
#include "ingest/log/units.h"
#include "ingest/manifest/gear_ratio.h"

namespace tribolog::ingest::manifest {
namespace {

constexpr const char* joints_key = "joints";

const TomlArray* joints_of(const TomlNode& manifest) {
  const TomlNode* joints = manifest.member(joints_key);
  return joints == nullptr ? nullptr : joints->as<TomlArray>();
}

const std::string* name_of(const TomlNode& joint) {
  const TomlNode* name = joint.member("name");
  return name == nullptr ? nullptr : name->as<std::string>();
}

/// Adds what a joint has to what all share.
void add(TomlNode&& own, TomlNode& shared) {
  if (auto* members = std::get_if<TomlMembers>(&own.value)) {
    if (auto* common = std::get_if<TomlMembers>(&shared.value)) {
      for (auto& [key, value] : *members) (*common)[key] = std::move(value);
      return;
    }
  } else if (auto* elements = std::get_if<TomlArray>(&own.value)) {
    if (auto* common = std::get_if<TomlArray>(&shared.value)) {
      std::move(elements->begin(), elements->end(), std::back_inserter(*common));
      return;
    }
  }
  shared = std::move(own);
}

template <class Type>
const Type* value_in(const TomlNode* table, std::string_view key) {
  const TomlNode* node = table == nullptr ? nullptr : table->member(key);
  return node == nullptr ? nullptr : node->as<Type>();
}

std::optional<double> number_in(const TomlNode* table, std::string_view key) {
  if (const auto* whole = value_in<std::int64_t>(table, key)) return static_cast<double>(*whole);
  if (const auto* number = value_in<double>(table, key)) return *number;
  return std::nullopt;
}

/// A number, or a text such as "101:1".
std::optional<double> gear_ratio_in(const TomlNode* joint) {
  const auto* text = value_in<std::string>(joint, "gear_ratio");
  if (text == nullptr || text->find(':') == text->npos) return number_in(joint, "gear_ratio");
  try {
    return parse_gear_ratio(*text);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

/// The table of the angle's column, in the manifest of one joint.
const TomlNode* angle_column_in(const TomlNode& manifest) {
  const TomlNode* columns = manifest.member("columns");
  return columns == nullptr ? nullptr : columns->member("angle");
}

/// Nothing where what stands there is for its own reader to refuse, or stands in another file.
std::optional<joint::OtherJoint> other_joint_in(const TomlNode& manifest) {
  const TomlNode* angle = angle_column_in(manifest);
  const auto* column = value_in<std::string>(angle, "name");
  const auto* unit = value_in<std::string>(angle, "unit");
  const TomlNode* table = manifest.member("joint");
  const std::optional<double> gear_ratio = gear_ratio_in(table);
  const bool is_in_own_file = angle != nullptr && angle->member("file") != nullptr;
  if (column == nullptr || column->empty() || unit == nullptr || is_in_own_file) {
    return std::nullopt;
  }
  const std::optional<double> factor = log::find_si_factor(log::Quantity::angle, *unit);
  const double sign = number_in(angle, "sign").value_or(1);
  if (!factor || std::abs(sign) != 1 || !gear_ratio || !(*gear_ratio > 0)) return std::nullopt;
  const auto* side = value_in<std::string>(angle, "side");
  const bool is_at_motor = side != nullptr && *side == "motor";
  joint::OtherJoint other;
  other.name = *name_of(*table);
  other.angle = *column;
  other.radian_per_unit = sign * *factor / (is_at_motor ? *gear_ratio : 1);
  return other;
}

}  // namespace

std::vector<joint::OtherJoint> other_joints_of(const TomlNode& manifest, const std::string& file,
                                               const std::string& name) {
  const TomlNode own = manifest_of_joint(manifest, name);
  const auto* own_angle = value_in<std::string>(angle_column_in(own), "name");
  std::vector<joint::OtherJoint> others;
  for (const TomlNode& joint : *joints_of(manifest)) {
    if (*name_of(joint) == name) continue;
    std::optional<joint::OtherJoint> other =
        other_joint_in(manifest_of_joint(manifest, *name_of(joint)));
    if (!other || (own_angle != nullptr && other->angle == *own_angle)) continue;
    other->stated_at = fmt::format("{}:{}", file, joint.line);
    others.push_back(*std::move(other));
  }
  return others;
}

std::vector<std::string> joint_names(const TomlNode& manifest, const std::string& file) {
  const TomlNode* stated = manifest.member(joints_key);
  if (stated == nullptr) return {};
  const auto place_of = [&](const TomlNode& node) {
    return Location{file, node.line, node.column};
  };
  const TomlArray* joints = joints_of(manifest);
  if (joints == nullptr || joints->empty()) {
    throw InputError(place_of(*stated),
                     {"key 'joints': holds no joints", "", "[[joints]], once for each", ""});
  }
  if (const TomlNode* single = manifest.member("joint")) {
    throw InputError(place_of(*single), {"stands beside [[joints]]", "[joint]", "one of the two",
                                         "name and gear_ratio stand in each of [[joints]]"});
  }
  std::vector<std::string> names;
  for (const TomlNode& joint : *joints) {
    const std::string* name = name_of(joint);
    if (name == nullptr || name->find_first_not_of(' ') == std::string::npos) {
      throw InputError(place_of(joint), {"a joint has no name", "", "name = \"J1\"", ""});
    }
    if (const TomlNode* robot = joint.member("robot")) {
      throw InputError(place_of(*robot), {"a joint has no robot of its own", "", "",
                                          "[robot] stands once, and is of all joints"});
    }
    if (std::find(names.begin(), names.end(), *name) != names.end()) {
      throw InputError(place_of(joint), {"two joints have this name", in_quotes(*name),
                                         "a name of its own for each", ""});
    }
    names.push_back(*name);
  }
  return names;
}

TomlNode manifest_of_joint(TomlNode manifest, const std::string& name) {
  auto& top = std::get<TomlMembers>(manifest.value);
  const auto found = top.find(joints_key);
  auto& joints = std::get<TomlArray>(found->second.value);
  const auto own = std::find_if(joints.begin(), joints.end(),
                                [&](const TomlNode& joint) { return *name_of(joint) == name; });
  TomlNode joint{own->line, own->column, TomlMembers{}};
  for (auto& [key, value] : std::get<TomlMembers>(own->value)) {
    const bool is_of_joint = value.as<TomlMembers>() == nullptr && value.as<TomlArray>() == nullptr;
    if (is_of_joint) {
      std::get<TomlMembers>(joint.value)[key] = std::move(value);
    } else if (const auto shared = top.find(key); shared != top.end() && key != joints_key) {
      add(std::move(value), shared->second);
    } else {
      top[key] = std::move(value);
    }
  }
  top.erase(joints_key);
  top["joint"] = std::move(joint);
  return manifest;
}

TomlNode document_of_joint(TomlNode document, const std::string& file, const std::string& joint) {
  const std::vector<std::string> names = joint_names(document, file);
  if (names.empty() && joint.empty()) return document;
  const auto it = std::find(names.begin(), names.end(), joint);
  if (it != names.end()) return manifest_of_joint(std::move(document), joint);
  if (names.empty()) {
    throw InputError({file, 0, 0}, {"is of a single joint", "--joint " + joint, "",
                                    "[[joints]] are the joints of a whole robot"});
  }
  throw InputError({file, 0, 0}, {joint.empty() ? "holds several joints" : "has no such joint",
                                  joint.empty() ? "" : in_quotes(joint),
                                  "--joint NAME, of " + list_of_names(names), ""});
}

}  // namespace tribolog::ingest::manifest
