#include "ingest/manifest/robot_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/error.h"
#include "base/input_file.h"
#include "ingest/manifest/scenario_tables.h"
#include "ingest/manifest/toml_table.h"
#include "joint/degrees.h"

namespace tribolog::ingest::manifest {
namespace {

constexpr std::size_t most_joints = 64;
constexpr double farthest_m = 100;        // of an arm's parts: more are millimetres
constexpr double angle_slack_rad = 1e-9;  // degrees in a file, turned into radians

std::vector<Eigen::Vector3d> read_points(const TomlTable& table, const std::string& key) {
  const std::vector<double> numbers = table.numbers(key);
  if (numbers.empty() || numbers.size() % 3 != 0) {
    table.refuse(key, {"is no list of points", fmt::format("{} numbers", numbers.size()),
                       "three numbers for each: x, y, z", ""});
  }
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < numbers.size(); i += 3) {
    points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  }
  return points;
}

Eigen::Vector3d read_point(const TomlTable& table, const std::string& key) {
  const auto points = read_points(table, key);
  if (points.size() != 1) {
    table.refuse(key, {"is not one point", fmt::format("{} numbers", 3 * points.size()),
                       "three: x, y, z", ""});
  }
  return points.front();
}

void refuse_millimetres(const TomlTable& table, const std::string& key,
                        const std::vector<Eigen::Vector3d>& points_m) {
  for (const Eigen::Vector3d& point : points_m) {
    const double largest = point.cwiseAbs().maxCoeff();
    if (largest <= farthest_m) continue;
    table.refuse(key, {"not usable", fmt::format("{}", largest),
                       fmt::format("at most {} m to each side", farthest_m), "lengths are metres"});
  }
}

robot::LinkShape read_shape(const TomlTable& joint) {
  robot::LinkShape shape;
  const auto size = [&](const char* key, double otherwise) {
    return joint.number_or(key, otherwise, Sign::positive);
  };
  shape.radius_m = size("radius_m", shape.radius_m);
  shape.end_radius_m = size("end_radius_m", shape.radius_m);
  shape.bar_thickness_m = joint.number_or("bar_thickness_m", 0.0, Sign::not_negative);
  shape.drum_radius_m = size("drum_radius_m", shape.drum_radius_m);
  shape.drum_length_m = size("drum_length_m", shape.drum_length_m);
  return shape;
}

struct Chain {
  std::vector<robot::ArmJoint> joints;
  std::vector<double> portrait_rad;
  std::vector<double> held_rad;
};

std::string angle_key(const TomlTable& table, const std::string& name) {
  return table.has(name + "_rad") ? name + "_rad" : name + "_deg";
}

/// Refused at the joint itself, though the chain would refuse it too.
void check_alone(const TomlTable& table, const robot::ArmJoint& joint, double portrait,
                 double held) {
  const robot::SerialArm alone =
      guarded(table, "name", [&] { return robot::SerialArm(joint.name, {joint}, {1, 0, 0}); });
  const auto check_angle = [&](const std::string& name, double angle) {
    static_cast<void>(guarded(table, angle_key(table, name), [&] { return alone.pose({angle}); }));
  };
  check_angle("portrait", portrait);
  check_angle("held_at", held);
}

Chain read_chain(const std::vector<TomlTable>& tables) {
  Chain chain;
  for (const TomlTable& table : tables) {
    robot::ArmJoint joint;
    joint.name = table.text("name");
    for (const robot::ArmJoint& other : chain.joints) {
      if (other.name != joint.name) continue;
      table.refuse("name", {"is given twice", in_quotes(joint.name), "a name of its own", ""});
    }
    joint.axis = read_point(table, "axis");
    joint.offset_m = read_point(table, "offset_m");
    refuse_millimetres(table, "offset_m", {joint.offset_m});
    joint.lowest_rad = read_angle(table, "lowest");
    joint.highest_rad = read_angle(table, "highest");
    if (table.has("bends_m")) joint.link_bends_m = read_points(table, "bends_m");
    refuse_millimetres(table, "bends_m", joint.link_bends_m);
    joint.shape = read_shape(table);
    const double nearest_to_0 = std::max(joint.lowest_rad, std::min(0.0, joint.highest_rad));
    chain.portrait_rad.push_back(read_angle_or(table, "portrait", nearest_to_0));
    chain.held_rad.push_back(read_angle_or(table, "held_at", nearest_to_0));
    table.refuse_unknown_keys();
    check_alone(table, joint, chain.portrait_rad.back(), chain.held_rad.back());
    chain.joints.push_back(std::move(joint));
  }
  return chain;
}

/// Nothing where neither end is stated.
std::optional<robot::AngleRange> read_range(const TomlTable& test, const robot::ArmJoint& joint) {
  const auto has = [&](const std::string& name) {
    return test.has(name + "_rad") || test.has(name + "_deg");
  };
  if (!has("lowest") && !has("highest")) return std::nullopt;
  const robot::AngleRange range{read_angle(test, "lowest"), read_angle(test, "highest")};
  const auto refuse = [&](const char* end, double angle_rad, const std::string& expected) {
    test.refuse(
        angle_key(test, end),
        {"not usable", fmt::format("{:.6g}°", angle_rad * joint::degrees_per_rad), expected, ""});
  };
  const std::string inside = fmt::format(
      "an angle inside the range of motion of joint {}, {:.6g}° to {:.6g}°", in_quotes(joint.name),
      joint.lowest_rad * joint::degrees_per_rad, joint.highest_rad * joint::degrees_per_rad);
  const auto is_inside = [&](double angle_rad) {
    return angle_rad >= joint.lowest_rad - angle_slack_rad &&
           angle_rad <= joint.highest_rad + angle_slack_rad;
  };
  if (!is_inside(range.lowest_rad)) refuse("lowest", range.lowest_rad, inside);
  if (!is_inside(range.highest_rad)) refuse("highest", range.highest_rad, inside);
  if (!(range.lowest_rad < range.highest_rad)) {
    refuse("highest", range.highest_rad,
           fmt::format("more than the lowest, {:.6g}°", range.lowest_rad * joint::degrees_per_rad));
  }
  return range;
}

}  // namespace

robot::RobotDescription parse_robot(std::string_view text, const std::string& file) {
  const TomlTable top = TomlTable::parse(text, file);
  (void)top.choice("schema", {"tribolog-robot-1"});
  const std::string name = top.text("name");
  const bool approximate = top.choice("dimensions", {"approximate", "exact"}) == 0;
  const Eigen::Vector3d flange = read_point(top, "flange_m");
  refuse_millimetres(top, "flange_m", {flange});
  const std::vector<TomlTable> tables = top.tables("joints");
  if (tables.empty() || tables.size() > most_joints) {
    throw InputError({file, 0, 0}, {"the arm has " + std::to_string(tables.size()) + " joints", "",
                                    "1 to 64 tables [[joints]]", ""});
  }
  Chain chain = read_chain(tables);
  robot::SerialArm arm = guarded(
      top, "flange_m", [&] { return robot::SerialArm(name, std::move(chain.joints), flange); });

  const TomlTable test = top.table("under_test", "[under_test] with the name of the tested joint");
  robot::JointUnderTest::Setting setting;
  const std::string joint = test.text("joint");
  setting.joint = guarded(test, "joint", [&] { return arm.index_of(joint); });
  setting.held_rad = std::move(chain.held_rad);
  robot::RobotDescription robot{
      guarded(test, "joint",
              [&] { return robot::JointUnderTest(std::move(arm), std::move(setting)); }),
      std::move(chain.portrait_rad),
      approximate,
      {},
      {}};
  robot.range = read_range(test, robot.under_test.joint());
  test.refuse_unknown_keys();
  if (const auto load = top.find_table("load")) robot.load = read_load(*load);
  if (const auto surrogate = top.find_table("surrogate")) {
    robot.surrogate_distance_m =
        surrogate->number_or("distance_m", robot.surrogate_distance_m, Sign::positive);
    surrogate->refuse_unknown_keys();
  }
  top.refuse_unknown_keys();
  return robot;
}

std::string read_description_name(const TomlTable& robot) {
  if (!robot.has("description")) return {};
  std::string name = robot.text("description");
  const bool is_file = !name.empty() && name.find('\0') == std::string::npos;
  if (!is_file) {
    robot.refuse("description",
                 {"is no name of a file", in_quotes(name), "the file that describes the arm",
                  "examples/paper/am100ib.toml is one"});
  }
  return name;
}

robot::RobotDescription read_robot(const std::string& path) {
  return parse_robot(read_file(path, largest_robot_bytes), path);
}

}  // namespace tribolog::ingest::manifest
