#include "ingest/manifest/robot_joints.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/closest_match.h"
#include "base/error.h"

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

}  // namespace

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

}  // namespace tribolog::ingest::manifest
