#include "ingest/manifest/urdf_file.h"

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/error.h"
#ifdef TRIBOLOG_MUJOCO
#include <mujoco/mujoco.h>
#endif

namespace tribolog::urdf_file_test {
namespace {

constexpr double g = 9.80665;
const Eigen::Vector3d gravity(0, 0, -g);

/// A turned base, two turning joints with axes that are not the frames' own, a tool that is fixed.
std::string arm() {
  return R"(<?xml version="1.0"?>
<!-- an arm -->
<robot name="two">
  <link name="world"/>
  <link name="base"><inertial><mass value="30"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <link name="upper">
    <inertial><origin xyz="0.3 0.02 0" rpy="0.1 0 0"/><mass value="8"/>
      <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.2"/></inertial>
  </link>
  <link name="fore">
    <inertial><origin xyz="0 0 -0.25"/><mass value="5"/>
      <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>
  </link>
  <link name="tool">
    <inertial><origin xyz="0 0.05 0"/><mass value="1.5"/>
      <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
  </link>
  <joint name="stand" type="fixed">
    <parent link="world"/><child link="base"/><origin rpy="0 0 0.7"/>
  </joint>
  <joint name="shoulder" type="revolute">
    <parent link="base"/><child link="upper"/><origin xyz="0 0 1" rpy="0 0.4 0"/>
    <axis xyz="0 -2 0"/><limit lower="-2" upper="2" effort="100" velocity="1"/>
  </joint>
  <joint name="elbow" type="continuous">
    <parent link="upper"/><child link="fore"/>
    <origin xyz="0.7 0.1 0" rpy="0.2 -1.2 0.5"/><axis xyz="0.3 -1 0.2"/>
  </joint>
  <joint name="flange" type="fixed">
    <parent link="fore"/><child link="tool"/><origin xyz="0 0 -0.5" rpy="1 0.5 -0.3"/>
  </joint>
</robot>
)";
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(Urdf, FixedLinksAreOneAndTheBaseCarriesNothing) {
  const robot::WeightedArm read = ingest::manifest::parse_urdf(arm(), "arm.urdf");
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read.joints()[0].name, "shoulder");
  EXPECT_EQ(read.joints()[1].name, "elbow");
  EXPECT_EQ(read.joints()[1].parent, 0U);
  EXPECT_EQ(read.joints()[0].mass_kg, 8);
  EXPECT_EQ(read.joints()[1].mass_kg, 6.5);
}

TEST(Urdf, PlanarArmIsHeldAsInClosedForm) {
  // Along the link, whose frame is turned by rpy = (0, 0.4, 0): 0.4 below the level at 0.
  const std::string text = R"(<robot name="r"><link name="b"/><link name="u"><inertial>
    <origin xyz="0.3 0 0"/><mass value="8"/></inertial></link>
    <link name="f"><inertial><origin xyz="0.25 0 0"/><mass value="5"/></inertial></link>
    <joint name="q1" type="revolute"><parent link="b"/><child link="u"/>
      <origin xyz="0 0 1" rpy="0 0.4 0"/><axis xyz="0 -1 0"/></joint>
    <joint name="q2" type="revolute"><parent link="u"/><child link="f"/>
      <origin xyz="0.7 0 0"/><axis xyz="0 -1 0"/></joint></robot>)";
  const robot::WeightedArm read = ingest::manifest::parse_urdf(text, "arm.urdf");
  const double q1 = 0.9;
  const double q2 = -1.7;
  EXPECT_NEAR(read.holding_torque_Nm(0, {q1, q2}, gravity),
              g * ((8 * 0.3 + 5 * 0.7) * std::cos(q1 - 0.4) + 5 * 0.25 * std::cos(q1 + q2 - 0.4)),
              1e-12 * 100);
}

TEST(Urdf, AgreesWithMuJoCo) {
#ifdef TRIBOLOG_MUJOCO
  const robot::WeightedArm read = ingest::manifest::parse_urdf(arm(), "arm.urdf");
  const std::string path = testing::TempDir() + "tribolog_urdf_test.urdf";
  FILE* file = std::fopen(path.c_str(), "w");
  ASSERT_NE(file, nullptr);
  const std::string text = arm();
  std::fwrite(text.data(), 1, text.size(), file);
  std::fclose(file);
  char error[1000] = "";
  mjModel* model = mj_loadXML(path.c_str(), nullptr, error, sizeof error);
  std::remove(path.c_str());
  ASSERT_NE(model, nullptr) << error;
  model->opt.gravity[2] = -g;
  mjData* data = mj_makeData(model);
  for (int k = 0; k < 20; ++k) {
    const std::vector<double> angles{1.9 * std::sin(1.1 * k), 3 * std::cos(2.3 * k)};
    data->qpos[0] = angles[0];
    data->qpos[1] = angles[1];
    mj_forward(model, data);  // at rest: the bias is gravity alone
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(read.holding_torque_Nm(i, angles, gravity), data->qfrc_bias[i], 1e-9);
    }
  }
  mj_deleteData(data);
  mj_deleteModel(model);
#else
  GTEST_SKIP() << "MuJoCo is not installed";
#endif
}

TEST(Urdf, AMimickedJointFollows) {
  const std::string text = with(
      arm(), "<axis xyz=\"0.3 -1 0.2\"/>",
      "<axis xyz=\"0.3 -1 0.2\"/><mimic joint=\"shoulder\" multiplier=\"-2\" offset=\"0.1\"/>");
  const robot::WeightedArm follows = ingest::manifest::parse_urdf(text, "arm.urdf");
  const robot::WeightedArm free = ingest::manifest::parse_urdf(arm(), "arm.urdf");
  EXPECT_EQ(follows.holding_torque_Nm(0, {0.4, 99}, gravity),
            free.holding_torque_Nm(0, {0.4, -2 * 0.4 + 0.1}, gravity));
}

/// "line:column: what" of the refusal.
std::string refusal(const std::string& text) {
  try {
    (void)ingest::manifest::parse_urdf(text, "arm.urdf");
  } catch (const InputError& error) {
    EXPECT_EQ(error.status(), ExitStatus::input_refused);
    return error.what();
  }
  return "accepted";
}

TEST(Urdf, WhatCannotBeUsedIsRefusedAtItsPlace) {
  struct Case {
    std::string from, to, place, word;
  };
  const Case cases[] = {
      {"<mass value=\"8\"/>", "<mass value=\"-8\"/>", ":7:", "kilograms"},
      {"<mass value=\"8\"/>", "<mass value=\"8 kg\"/>", ":7:", "'8 kg'"},
      {"<mass value=\"8\"/>", "<mass value=\"8e6\"/>", ":7:", "kilograms"},
      {"<mass value=\"8\"/>", "<mass value=\"nan\"/>", ":7:", "a number"},
      {"<mass value=\"8\"/>", "", ":7:", "<inertial> has no <mass>"},
      {"xyz=\"0.7 0.1 0\"", "xyz=\"700 100 0\"", ":27:", "metres"},
      {"xyz=\"0.7 0.1 0\"", "xyz=\"0.7 0.1\"", ":27:", "3 numbers"},
      {"xyz=\"0.3 -1 0.2\"", "xyz=\"0 0 0\"", ":27:", "a direction"},
      {"type=\"continuous\"", "type=\"floating\"", ":25:", "stands on its base"},
      {"type=\"continuous\"", "type=\"hinge\"", ":25:", "revolute"},
      {"type=\"continuous\"", "", ":25:", "has no type"},
      {"name=\"elbow\"", "name=\"shoulder\"", ":25:", "two joints have this name"},
      {"<link name=\"tool\">", "<link name=\"fore\">", ":14:", "two links have this name"},
      {"<child link=\"fore\"/>", "<child link=\"for\"/>", ":25:", "did you mean 'fore'"},
      {"<child link=\"fore\"/>", "<child link=\"upper\"/>", ":25:", "two joints carry one link"},
      {"<parent link=\"world\"/><child link=\"base\"/>",
       "<parent link=\"tool\"/><child link=\"base\"/>", ":3:", "ring"},
      {"<parent link=\"base\"/>", "", ":21:", "<joint> has no <parent>"},
      {"<link name=\"world\"/>", "<link name=\"world\"/><link name=\"other\"/>",
       ":4:", "carried by no joint"},
      {"<link name=\"world\"/>", "<xacro:include filename=\"a\"/>", ":4:", "xacro"},
      {"<robot name=\"two\">", "<!DOCTYPE robot [<!ENTITY a \"b\">]><robot name=\"two\">",
       ":3:", "document type"},
      {"<robot name=\"two\">", "<sdf name=\"two\"><a>", ":", "XML"},
      {"</robot>", "", ":", "XML"},
      {"type=\"revolute\"", "type=\"fixed\"", ":", "accepted"},
  };
  for (const Case& one : cases) {
    const std::string found = refusal(with(arm(), one.from, one.to));
    if (one.word != "accepted") {
      EXPECT_EQ(found.find("arm.urdf" + one.place), 0U) << one.to << '\n' << found;
    }
    EXPECT_NE(found.find(one.word), std::string::npos) << one.to << '\n' << found;
  }
  EXPECT_NE(refusal("<sdf/>").find("arm.urdf:1:1: is no URDF"), std::string::npos);
  EXPECT_NE(refusal("schema = 1").find("is no XML"), std::string::npos);
  EXPECT_NE(refusal("").find("is no XML"), std::string::npos);
  EXPECT_NE(refusal("<robot/>").find("holds no link"), std::string::npos);
  std::string weightless = arm();
  for (const char* mass : {"value=\"8\"", "value=\"5\"", "value=\"1.5\""}) {
    weightless = with(weightless, mass, "value=\"0\"");
  }
  EXPECT_NE(refusal(weightless).find("no link that moves has a mass"), std::string::npos);
}

TEST(Urdf, ADamagedFileIsReadOrRefused) {
  const std::string whole = arm();
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const bool is_cut_off = i + 1 < whole.size();
    const std::string cut = refusal(whole.substr(0, i));
    EXPECT_EQ(cut.starts_with("arm.urdf:"), is_cut_off) << i << cut;
    for (const char other : {'\0', '<', '"', '9', '\xff'}) {
      std::string damaged = whole;
      damaged[i] = other;
      const std::string found = refusal(damaged);
      EXPECT_TRUE(found == "accepted" || found.starts_with("arm.urdf:")) << found;
    }
  }
}

TEST(Urdf, ALongChainAndDeepElementsEndInARefusal) {
  std::string deep = "<robot>";
  for (int i = 0; i < 5000; ++i) deep += "<a>";
  EXPECT_NE(refusal(deep).find("too many elements"), std::string::npos);
  std::string chain = "<robot><link name=\"0\"/>";
  for (int i = 1; i < 5000; ++i) {
    chain += fmt::format(
        "<link name=\"{0}\"/><joint name=\"{0}\" type=\"fixed\"><parent link=\"{1}\"/>"
        "<child link=\"{0}\"/></joint>",
        i, i - 1);
  }
  EXPECT_NE(refusal(chain + "</robot>").find("too many links"), std::string::npos);
}

}  // namespace
}  // namespace tribolog::urdf_file_test
