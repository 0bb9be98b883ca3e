#include "export/dataset_toml.h"

#include <gtest/gtest.h>

#include "ingest/manifest_file.h"

namespace tribolog {
namespace {

Recording recording(const std::string& name, Role role, bool has_speed, bool has_bristle) {
  Recording r;
  r.name = name;
  r.role = role;
  r.t_s = r.q_rad = r.torque_Nm = {0, 1};
  if (has_speed) r.dq_rad_s = {0, 1};
  if (has_bristle) r.z_rad = r.dz_rad_s = {0, 1};
  return r;
}

ManifestFile written_and_read(const Scenario& scenario, const std::vector<Recording>& recordings) {
  return parse_manifest(dataset_toml(scenario, recordings), "dataset.toml");
}

Scenario named_scenario() {
  Scenario s;
  s.name = std::string("name");
  s.robot = std::string("robot");
  s.joint = std::string("3");
  return s;
}

TEST(DatasetToml, SaysWhatTheScenarioSays) {
  Scenario s = named_scenario();
  s.serial = std::string("S");
  s.gear_ratio = 100.5;
  s.load = GravityLoad(1, 1, 0, 9.80665);
  s.surrogate_distance_m = 0.4;
  s.sliding = WaiboerFriction({0.8844, 5, 0.7, 0.12, 0.6, 1e5});
  const ManifestFile m = written_and_read(s, {recording("a.csv", Role::rough_sweep, true, false)});
  EXPECT_EQ(m.manifest.robot, "robot");
  EXPECT_EQ(m.manifest.serial, "S");
  EXPECT_EQ(m.manifest.joint, "3");
  EXPECT_EQ(m.manifest.note, "simulated: name");
  EXPECT_EQ(m.manifest.drive.gear_ratio(), 100.5);
  EXPECT_EQ(m.manifest.drive.motor_torque_per_effort(), 1.0);
  EXPECT_EQ(m.manifest.surrogate_distance_m, 0.4);
  EXPECT_EQ(m.manifest.gravity_m_s2, 9.80665);
  const auto& p = m.manifest.reference.value().parameters();
  EXPECT_EQ(p.asperity_torque_Nm, 0.8844);
  EXPECT_EQ(p.stribeck_speed_rad_s, 5);
  EXPECT_EQ(p.stribeck_power, 0.7);
  EXPECT_EQ(p.viscous_coefficient, 0.12);
  EXPECT_EQ(p.viscous_power, 0.6);
  EXPECT_EQ(p.smoothing_s_rad, 1e5);
}

TEST(DatasetToml, StatesTheColumnsThatEachRecordingHas) {
  const auto rough = recording("a.csv", Role::rough_sweep, true, false);
  const auto loop = recording("b.csv", Role::oscillation, true, true);
  const auto run = recording("c.csv", Role::constant_speed, false, false);
  const ManifestFile m = written_and_read(named_scenario(), {rough, loop, run});
  ASSERT_EQ(m.recordings.size(), 3U);
  EXPECT_TRUE(m.recordings[0].columns.speed.has_value());
  EXPECT_FALSE(m.recordings[0].columns.bristle.has_value());
  EXPECT_TRUE(m.recordings[1].columns.bristle.has_value());
  EXPECT_TRUE(m.recordings[1].columns.bristle_rate.has_value());
  EXPECT_FALSE(m.recordings[2].columns.speed.has_value());
  EXPECT_EQ(m.recordings[1].role, Role::oscillation);
}

TEST(DatasetToml, KeepsHostileTextsAsTexts) {
  Scenario s = named_scenario();
  s.robot = std::string("a\"b\\c\n[joint]\x01\x7f Größe <script>");
  s.joint = std::string("'''\"\"\"");
  const ManifestFile m = written_and_read(s, {recording("a.csv", Role::rough_sweep, true, false)});
  EXPECT_EQ(m.manifest.robot, s.robot);
  EXPECT_EQ(m.manifest.joint, s.joint);
}

}  // namespace
}  // namespace tribolog
