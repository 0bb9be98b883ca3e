#include <gtest/gtest.h>

#include "exports/simulation/simulation_files.h"
#include "friction/catalogue.h"
#include "friction/static_laws.h"
#include "ingest/manifest/manifest_file.h"

namespace tribolog::dataset_toml_test {
namespace {

joint::Recording recording(const std::string& name, joint::Role role, bool has_speed,
                           bool has_bristle) {
  joint::Recording r;
  r.name = name;
  r.role = role;
  r.t_s = r.q_rad = r.torque_Nm = {0, 1};
  if (has_speed) r.dq_rad_s = {0, 1};
  if (has_bristle) r.z_rad = r.dz_rad_s = {0, 1};
  return r;
}

ingest::manifest::ManifestFile written_and_read(const simulate::Scenario& scenario,
                                                const std::vector<joint::Recording>& recordings) {
  return ingest::manifest::parse_manifest(exports::simulation::dataset_toml(scenario, recordings),
                                          "dataset.toml");
}

simulate::Scenario named_scenario() {
  simulate::Scenario s;
  s.name = std::string("name");
  s.robot = std::string("robot");
  s.joint = std::string("3");
  return s;
}

TEST(DatasetToml, SaysWhatTheScenarioSays) {
  simulate::Scenario s = named_scenario();
  s.serial = std::string("S");
  s.gear_ratio = 100.5;
  s.load = joint::GravityLoad(1, 1, 0, 9.80665);
  s.surrogate_distance_m = 0.4;
  s.sliding = std::make_shared<friction::WaiboerFriction>(
      friction::WaiboerFriction::Parameters{0.8844, 5, 0.7, 0.12, 0.6, 1e5});
  const ingest::manifest::ManifestFile m =
      written_and_read(s, {recording("a.csv", joint::Role::rough_sweep, true, false)});
  EXPECT_EQ(m.manifest.robot, "robot");
  EXPECT_EQ(m.manifest.serial, "S");
  EXPECT_EQ(m.manifest.joint, "3");
  EXPECT_EQ(m.manifest.note, "simulated: name");
  EXPECT_EQ(m.manifest.drive.gear_ratio(), 100.5);
  EXPECT_EQ(m.manifest.drive.motor_torque_per_effort(), 1.0);
  EXPECT_EQ(m.manifest.surrogate_distance_m, 0.4);
  EXPECT_EQ(m.manifest.gravity_m_s2, 9.80665);
  ASSERT_TRUE(m.manifest.reference);
  EXPECT_EQ(m.manifest.reference->name(), "waiboer");
  EXPECT_EQ(m.manifest.reference->named_parameters(), s.sliding->named_parameters());
}

TEST(DatasetToml, StatesACurrentWithItsConstant) {
  simulate::Scenario s = named_scenario();
  s.log.torque_constant_Nm_A = 0.1059;
  const ingest::manifest::ManifestFile m =
      written_and_read(s, {recording("a.csv", joint::Role::rough_sweep, true, false)});
  EXPECT_EQ(m.manifest.drive.kind(), joint::EffortKind::motor_current);
  EXPECT_EQ(m.manifest.drive.torque_constant_Nm_A(), 0.1059);
  EXPECT_EQ(m.recordings[0].columns.effort->name, "i_A");
}

// Whatever friction was simulated, the manifest says it to the last digit.
TEST(DatasetToml, StatesEveryModelsFriction) {
  const auto states = [](const simulate::Scenario& s) {
    const auto simulated = s.known_curve();
    ASSERT_TRUE(simulated);
    const auto stated =
        written_and_read(s, {recording("a.csv", joint::Role::rough_sweep, true, false)})
            .manifest.reference;
    ASSERT_TRUE(stated);
    EXPECT_EQ(stated->name(), simulated->name());
    EXPECT_EQ(stated->named_parameters(), simulated->named_parameters());
    for (const double speed : {-30.0, -0.1, 0.0, 1e-3, 2.0}) {
      EXPECT_EQ(stated->torque_Nm(speed), simulated->torque_Nm(speed)) << stated->name();
    }
  };
  simulate::Scenario s = named_scenario();
  const friction::ContactParameters contact{465.42, 0.7708, 0.001, 0.6, 0.88437633, 5.0};
  for (const friction::FrictionModelEntry& model : friction::dynamic_friction_models()) {
    s.presliding = model.matched(contact);
    if (!model.traits.remembers_rest) states(s);
  }
  s.sliding = std::make_shared<friction::StribeckFriction>(
      friction::StribeckFriction::Parameters{{0.6, 0.9, 1.0 / 3, 1.5}, 0.01});
  states(s);
  s.sliding = std::make_shared<friction::ThresholdSpeedFriction>(
      friction::ThresholdSpeedFriction::Parameters{0.6, 0.9, 1.0 / 3, 0.01, 1e-5});
  states(s);
}

// After a short rest it slides with less torque than after a long one: no curve is the true one.
TEST(DatasetToml, StatesNoCurveWhereSpeedDoesNotSayTheTorque) {
  simulate::Scenario s = named_scenario();
  s.presliding = friction::dynamic_friction_model("armstrong").matched({});
  const auto log = recording("a.csv", joint::Role::rough_sweep, true, false);
  EXPECT_FALSE(written_and_read(s, {log}).manifest.reference);
  s.sliding = std::make_shared<friction::WaiboerFriction>(
      friction::WaiboerFriction::Parameters{1, 1, 1, 0, 0, 1e6});
  EXPECT_TRUE(written_and_read(s, {log}).manifest.reference);
}

TEST(DatasetToml, StatesTheColumnsThatEachRecordingHas) {
  const auto rough = recording("a.csv", joint::Role::rough_sweep, true, false);
  const auto loop = recording("b.csv", joint::Role::oscillation, true, true);
  const auto run = recording("c.csv", joint::Role::constant_speed, false, false);
  const ingest::manifest::ManifestFile m = written_and_read(named_scenario(), {rough, loop, run});
  ASSERT_EQ(m.recordings.size(), 3U);
  EXPECT_TRUE(m.recordings[0].columns.speed.has_value());
  EXPECT_FALSE(m.recordings[0].columns.bristle.has_value());
  EXPECT_TRUE(m.recordings[1].columns.bristle.has_value());
  EXPECT_TRUE(m.recordings[1].columns.bristle_rate.has_value());
  EXPECT_FALSE(m.recordings[2].columns.speed.has_value());
  EXPECT_EQ(m.recordings[1].role, joint::Role::oscillation);
}

TEST(DatasetToml, KeepsHostileTextsAsTexts) {
  simulate::Scenario s = named_scenario();
  s.robot = std::string("a\"b\\c\n[joint]\x01\x7f Größe <script>");
  s.joint = std::string("'''\"\"\"");
  const ingest::manifest::ManifestFile m =
      written_and_read(s, {recording("a.csv", joint::Role::rough_sweep, true, false)});
  EXPECT_EQ(m.manifest.robot, s.robot);
  EXPECT_EQ(m.manifest.joint, s.joint);
}

TEST(DatasetToml, NamesTheDescriptionThatStandsBesideIt) {
  simulate::Scenario s = named_scenario();
  const auto recordings = {recording("a.csv", joint::Role::rough_sweep, true, false)};
  EXPECT_EQ(written_and_read(s, recordings).manifest.robot_description, "");
  s.robot_description = std::string("../arms/a \"b\".toml");
  EXPECT_EQ(written_and_read(s, recordings).manifest.robot_description, "a \"b\".toml");
}

}  // namespace
}  // namespace tribolog::dataset_toml_test
