// A user's own model gets the joint's numbers, and keeps every other byte.

#include "exports/results/robot_model.h"

#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "exports/export_sample.h"

namespace tribolog::exports::results::robot_model_test {
namespace {

PatchedModel patched(const std::string& model, const SimulatorOptions& options = {}) {
  return with_friction(model, "arm.xml", "J2", test::export_sample(), options);
}

std::string refused(const std::string& model) {
  return test::refusal_of<InputError>([&] { return patched(model).text; });
}

constexpr const char* urdf_head =
    "<?xml version='1.0'?>\r\n<!-- <joint name=\"J2\"> -->\n<robot name=\"r\">\n"
    "  <joint name=\"J1\" type=\"revolute\"><dynamics damping=\"1\"/></joint>\n";

TEST(RobotModel, UrdfKeepsEveryOtherByte) {
  const std::string head = urdf_head;
  const std::string before = "  <joint type='revolute' name='J2'  >\n    <parent link=\"a\"/>\n";
  const std::string behind = "  </joint>\n  <material name=\"&#x41;&amp;é\"/>\n</robot>\n";
  const PatchedModel made =
      patched(head + before + "    <dynamics  damping = '0.1' friction=\"0\" />\n" + behind);
  EXPECT_EQ(made.text,
            head + before + "    <dynamics  damping = '5' friction=\"15.5\" />\n" + behind);
  EXPECT_EQ(made.format, "URDF");
  ASSERT_EQ(made.changes.size(), 2U);
  EXPECT_EQ(made.changes[0], "damping: 0.1 -> 5");
  EXPECT_EQ(made.changes[1], "friction: 0 -> 15.5");
  // An attribute that was not there, and an element that was not.
  EXPECT_EQ(patched(head + before + "    <dynamics damping=\"0.1\" />\n" + behind).text,
            head + before + "    <dynamics damping=\"5\" friction=\"15.5\" />\n" + behind);
  EXPECT_EQ(patched(head + before + behind).text,
            head +
                "  <joint type='revolute' name='J2'  >\n    <dynamics damping=\"5\" "
                "friction=\"15.5\"/>\n    <parent link=\"a\"/>\n" +
                behind);
}

TEST(RobotModel, SdfGetsItsElements) {
  const auto model = [](const std::string& dynamics) {
    return "<sdf version='1.7'><model name='m'><joint name='J2' type='revolute'>\n <axis>\n  "
           "<xyz>0 0 1</xyz>" +
           dynamics + "\n </axis></joint></model></sdf>";
  };
  EXPECT_EQ(patched(model("<dynamics><friction> 1 </friction><damping/></dynamics>")).text,
            model("<dynamics><friction>15.5</friction><damping>5</damping></dynamics>"));
  EXPECT_EQ(patched(model("<dynamics/>")).text,
            model("<dynamics><damping>5</damping><friction>15.5</friction></dynamics>"));
  EXPECT_EQ(patched(model("")).text,
            "<sdf version='1.7'><model name='m'><joint name='J2' type='revolute'>\n <axis>\n  "
            "<dynamics><damping>5</damping><friction>15.5</friction></dynamics>\n  <xyz>0 0 1</xyz>"
            "\n </axis></joint></model></sdf>");
}

TEST(RobotModel, MjcfGetsItsAttributesOfTheBodysJointAlone) {
  const std::string head =
      "<mujoco><default><joint name='J2' damping='7'/></default><worldbody><body>";
  const std::string behind =
      "</body></worldbody><equality><joint name=\"J2\"/></equality></mujoco>";
  SimulatorOptions options;
  options.arm_inertia_kgm2 = 4.5;
  EXPECT_EQ(
      patched(head + "<joint name='J2' frictionloss='0.1' type='hinge'/>" + behind, options).text,
      head +
          "<joint name='J2' frictionloss='15.5' type='hinge' damping=\"5\" "
          "solimpfriction=\"0.9999 0.9999 0.001 0.5 2\" armature=\"0.5\"/>" +
          behind);
  // What the model says of it stays.
  const std::string own = "<joint name='J2' frictionloss='0.1' solimpfriction='0.95'/>";
  EXPECT_NE(patched(head + own + behind, options).text.find("solimpfriction='0.95'"),
            std::string::npos);
}

TEST(RobotModel, IsUnchangedByASecondApplication) {
  const std::string once =
      patched(std::string(urdf_head) + "<joint name=\"J2\" type=\"continuous\"></joint></robot>")
          .text;
  EXPECT_EQ(patched(once).text, once);
}

TEST(RobotModel, RefusesWithPlaceAndHint) {
  EXPECT_EQ(refused("<robot><joint name=\"J1\" type=\"fixed\"/><joint name=\"arm\"/></robot>"),
            "arm.xml: has no joint of this name, found 'J2', expected one of 'J1', 'arm'; hint: "
            "--joint says which it is in the model");
  EXPECT_EQ(
      refused("<robot>\n <joint name=\"J2\" type=\"prismatic\"/></robot>"),
      "arm.xml:2:2: has another kind of joint of this name, found prismatic, expected a joint "
      "that turns");
  EXPECT_EQ(refused("<robot><joint name=\"J2\"/><joint name=\"J2\"/></robot>"),
            "arm.xml:1:26: has two joints of this name, found 'J2', expected one");
  EXPECT_NE(refused("<html/>").find("is no model of a robot"), std::string::npos);
  EXPECT_NE(refused("<robot><joint").find("is no XML"), std::string::npos);
  EXPECT_NE(refused("<!DOCTYPE a [<!ENTITY e 'x'>]><robot/>").find("has a document type"),
            std::string::npos);
  EXPECT_NE(refused("").find("is no XML"), std::string::npos);
}

}  // namespace
}  // namespace tribolog::exports::results::robot_model_test
