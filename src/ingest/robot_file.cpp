#include "ingest/robot_file.h"

#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "error.h"
#include "files/file_contents.h"
#include "ingest/experiment_tables.h"
#include "ingest/key_guard.h"

namespace tribolog {
namespace {

constexpr std::uint64_t largest_robot_bytes = 1 << 20;
constexpr std::size_t most_joints = 64;

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

LinkShape read_shape(const TomlTable& joint) {
  LinkShape shape;
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
  std::vector<ArmJoint> joints;
  std::vector<double> portrait_rad;
  std::vector<double> held_rad;
};

/// Refused at the joint itself, though the chain would refuse it too.
void check_alone(const TomlTable& table, const ArmJoint& joint, double portrait, double held) {
  const SerialArm alone = guarded(table, "name", [&] {
    return SerialArm(joint.name, {joint}, {0, 0, 0});
  });
  const auto check_angle = [&](const std::string& name, double angle) {
    const std::string key = table.has(name + "_rad") ? name + "_rad" : name + "_deg";
    static_cast<void>(guarded(table, key, [&] { return alone.pose({angle}); }));
  };
  check_angle("portrait", portrait);
  check_angle("held_at", held);
}

Chain read_chain(const std::vector<TomlTable>& tables) {
  Chain chain;
  for (const TomlTable& table : tables) {
    ArmJoint joint;
    joint.name = table.text("name");
    joint.axis = read_point(table, "axis");
    joint.offset_m = read_point(table, "offset_m");
    joint.lowest_rad = read_angle(table, "lowest");
    joint.highest_rad = read_angle(table, "highest");
    if (table.has("bends_m")) joint.link_bends_m = read_points(table, "bends_m");
    joint.shape = read_shape(table);
    chain.portrait_rad.push_back(read_angle_or(table, "portrait", 0.0));
    chain.held_rad.push_back(read_angle_or(table, "held_at", 0.0));
    table.refuse_unknown_keys();
    check_alone(table, joint, chain.portrait_rad.back(), chain.held_rad.back());
    chain.joints.push_back(std::move(joint));
  }
  return chain;
}

GravityLoad read_load(const TomlTable& load) {
  const double mass_kg = load.number("mass_kg", Sign::positive);
  const double distance_m = load.number("distance_m", Sign::positive);
  const double q_peak_rad = read_angle(load, "q_peak");
  const double gravity_m_s2 = load.number_or("gravity_m_s2", 9.81, Sign::positive);
  load.refuse_unknown_keys();
  return guarded(load, "mass_kg",
                 [&] { return GravityLoad(mass_kg, distance_m, q_peak_rad, gravity_m_s2); });
}

}  // namespace

RobotDescription parse_robot(std::string_view text, const std::string& file) {
  const TomlTable top = TomlTable::parse(text, file);
  (void)top.choice("schema", {"tribolog-robot-1"});
  const std::string name = top.text("name");
  const bool approximate = top.choice("dimensions", {"approximate", "exact"}) == 0;
  const Eigen::Vector3d flange = read_point(top, "flange_m");
  const std::vector<TomlTable> tables = top.tables("joints");
  if (tables.empty() || tables.size() > most_joints) {
    throw InputError({file, 0, 0}, {"the arm has " + std::to_string(tables.size()) + " joints", "",
                                    "1 to 64 tables [[joints]]", ""});
  }
  Chain chain = read_chain(tables);
  SerialArm arm = guarded(tables.back(), "name",
                          [&] { return SerialArm(name, std::move(chain.joints), flange); });

  const TomlTable test = top.table("under_test");
  JointUnderTest::Setting setting;
  const std::string joint = test.text("joint");
  setting.joint = guarded(test, "joint", [&] { return arm.index_of(joint); });
  setting.lowest_rad = read_angle(test, "lowest");
  setting.highest_rad = read_angle(test, "highest");
  test.refuse_unknown_keys();
  setting.held_rad = std::move(chain.held_rad);
  setting.load = read_load(top.table("load"));
  setting.surrogate_distance_m = 0.5;
  if (const auto surrogate = top.find_table("surrogate")) {
    setting.surrogate_distance_m = surrogate->number_or("distance_m", 0.5, Sign::positive);
    surrogate->refuse_unknown_keys();
  }
  top.refuse_unknown_keys();
  return {guarded(test, "joint", [&] { return JointUnderTest(std::move(arm), setting); }),
          std::move(chain.portrait_rad), approximate};
}

RobotDescription read_robot(const std::string& path) {
  return parse_robot(read_file(path, largest_robot_bytes), path);
}

}  // namespace tribolog
