#include "ingest/manifest/manifest_file.h"

#include <gtest/gtest.h>

#include "base/temporary_directory.h"
#include "friction/static_laws.h"

namespace tribolog::manifest_file_test {
namespace {

const std::string minimal = R"(schema = "tribolog-dataset-1"
[robot]
name = "R"
[joint]
name = "J"
gear_ratio = 100
[effort]
kind = "motor_torque"
side = "motor"
[columns]
time = {name = "t", unit = "s"}
angle = {name = "q", unit = "rad"}
effort = {name = "tau", unit = "Nm"}
[[recording]]
role = "oscillation"
file = "a.csv"
)";

/// The minimal manifest with one piece of text replaced.
std::string with(const std::string& piece, const std::string& replacement) {
  std::string text = minimal;
  const std::size_t at = text.find(piece);
  if (at == std::string::npos) throw std::logic_error("no such piece: " + piece);
  return text.replace(at, piece.size(), replacement);
}

std::string refusal(const std::string& text) {
  return test::refusal_of<InputError>(
      [&] { return ingest::manifest::parse_manifest(text, "m.toml"); });
}

TEST(Manifest, MinimalOneIsEnough) {
  const ingest::manifest::ManifestFile m = ingest::manifest::parse_manifest(minimal, "m.toml");
  EXPECT_EQ(m.manifest.robot, "R");
  EXPECT_EQ(m.manifest.joint, "J");
  EXPECT_EQ(m.manifest.drive.gear_ratio(), 100);
  EXPECT_EQ(m.manifest.drive.kind(), joint::EffortKind::motor_torque);
  EXPECT_EQ(m.manifest.drive.side(), joint::Side::motor);
  EXPECT_EQ(m.manifest.surrogate_distance_m, 0.5);
  EXPECT_EQ(m.manifest.gravity_m_s2, 9.81);
  EXPECT_EQ(m.effort_sign, 1.0);
  ASSERT_EQ(m.recordings.size(), 1U);
  EXPECT_EQ(m.recordings[0].role, joint::Role::oscillation);
  EXPECT_EQ(m.recordings[0].columns.angle->side, joint::Side::joint);
  EXPECT_FALSE(m.recordings[0].columns.speed.has_value());
}

/// What the manifest says of when the joint was measured.
std::string measured_on(const std::string& value) {
  const std::string name = "name = \"R\"\n";
  const std::string text = with(name, name + "measured_on = " + value + "\n");
  return ingest::manifest::parse_manifest(text, "m.toml").manifest.measured_on;
}

TEST(Manifest, ADateNeedsNoQuotes) {
  EXPECT_EQ(measured_on("2026-11-21"), "2026-11-21");
  EXPECT_EQ(measured_on("2026-11-21T08:30:05"), "2026-11-21T08:30:05");
  EXPECT_EQ(measured_on("2026-11-21 08:30:05.25Z"), "2026-11-21T08:30:05Z");
  EXPECT_EQ(measured_on("2026-11-21T08:30:05-03:30"), "2026-11-21T08:30:05-03:30");
  EXPECT_EQ(measured_on("\"in March\""), "in March");
  EXPECT_THROW((void)measured_on("08:30:05"), InputError) << "a time of no day";
  EXPECT_THROW((void)measured_on("20261121"), InputError);
}

TEST(Manifest, ATimeThatThereIsNotIsRefused) {
  for (const char* const text :
       {"\"2026-11-21T08:30:05+99:99\"", "\"2026-11-21T08:30:05-15:00\"",
        "\"2026-11-21T08:30:05+01:60\"", "\"2026-13-45\"", "2026-11-21T08:30:05+23:59"}) {
    EXPECT_THROW((void)measured_on(text), InputError) << text;
  }
  EXPECT_EQ(measured_on("\"2026-11-21T08:30:05+14:00\""), "2026-11-21T08:30:05+14:00");
  EXPECT_EQ(measured_on("\"2026-11-21, in the morning\""), "2026-11-21, in the morning");
}

TEST(Manifest, NumbersOutOfEveryJointsRangeAreRefusedAtTheirPlace) {
  for (const char* const ratio : {"1e-308", "1e-320", "1e308", "9223372036854775807"}) {
    const std::string said =
        refusal(with("gear_ratio = 100", std::string("gear_ratio = ") + ratio));
    EXPECT_NE(said.find("key 'joint.gear_ratio': is out of any joint's range"), std::string::npos)
        << said;
    EXPECT_EQ(said.find("m.toml:"), 0U) << said;
  }
}

TEST(Manifest, FullOneIsReadWhole) {
  const ingest::manifest::ManifestFile m =
      ingest::manifest::parse_manifest(R"(schema = "tribolog-dataset-1"
[robot]
name = "Größe <b>"
serial = "S1"
description = "arms/one.toml"
operator = "O"
measured_on = "2026-11-21"
note = "N"
[joint]
name = "3"
gear_ratio = 50.5
[effort]
kind = "motor_current"
side = "joint"
torque_constant_Nm_A = 10.5
sign = -1
[payload]
mass_kg = 2.5
note = "gripper"
[temperature]
degC = 21.5
[surrogate]
distance_m = 0.4
gravity_m_s2 = 9.8
[columns]
time = {name = "t", unit = "ms"}
angle = {name = "q", unit = "deg", side = "motor"}
speed = {name = "dq", unit = "rpm", side = "motor"}
effort = {name = "i", unit = "mA"}
[reference.waiboer]
asperity_torque_Nm = 1
stribeck_speed_rad_s = 2
stribeck_power = 0.5
viscous_coefficient = 0.1
viscous_power = 0.6
[[recording]]
role = "rough_sweep"
file = "a.csv"
from_s = 5
to_s = 62.3
note = "warm"
[[recording]]
role = "constant_speed"
file = "b.csv"
columns = {angle = {name = "q1", unit = "rad"}}
)",
                                       "m.toml");
  EXPECT_EQ(m.manifest.robot, "Größe <b>");
  EXPECT_EQ(m.manifest.serial, "S1");
  EXPECT_EQ(m.manifest.robot_description, "arms/one.toml");
  EXPECT_EQ(m.manifest.operator_name, "O");
  EXPECT_EQ(m.manifest.measured_on, "2026-11-21");
  EXPECT_EQ(m.manifest.note, "N");
  EXPECT_EQ(m.manifest.drive.torque_constant_Nm_A(), 10.5);
  EXPECT_EQ(m.effort_sign, -1.0);
  EXPECT_EQ(m.manifest.payload_kg, 2.5);
  EXPECT_EQ(m.manifest.payload, "gripper");
  EXPECT_EQ(m.manifest.temperature_C, 21.5);
  EXPECT_EQ(m.manifest.surrogate_distance_m, 0.4);
  EXPECT_EQ(m.manifest.gravity_m_s2, 9.8);
  ASSERT_TRUE(m.manifest.reference);
  EXPECT_EQ(m.manifest.reference->name(), "waiboer");
  EXPECT_EQ(m.manifest.reference->named_parameters(),
            friction::named(friction::WaiboerFriction::Parameters{1, 2, 0.5, 0.1, 0.6, 1e6}));
  ASSERT_EQ(m.recordings.size(), 2U);
  EXPECT_EQ(m.recordings[0].from_s, 5.0);
  EXPECT_EQ(m.recordings[0].note, "warm");
  EXPECT_EQ(m.recordings[0].columns.angle->side, joint::Side::motor);
  EXPECT_EQ(m.recordings[1].columns.angle->name, "q1");
  EXPECT_EQ(m.recordings[1].columns.angle->side, joint::Side::joint);
  EXPECT_EQ(m.recordings[1].columns.effort->name, "i");
}

TEST(Manifest, ALogOfAnySizeIsToldFromAManifest) {
  const test::TemporaryDirectory directory;
  for (const char* header : {"t,q,tau\n", "sep=;\nt;q;tau\n"}) {
    std::string log = header;
    while (log.size() <= ingest::manifest::largest_manifest_bytes) log += "0.1,0.2,0.3\n";
    const std::string path = directory.file("log.csv", log);
    const std::string said =
        test::refusal_of<InputError>([&] { return ingest::manifest::read_manifest(path); });
    EXPECT_NE(said.find("log.csv:1: is no manifest"), std::string::npos) << said;
  }
}

TEST(Manifest, AClockMayStandInTwoColumnsAndBeNoNumber) {
  using enum ingest::log::ColumnReading;
  const auto time = [](const std::string& entry) {
    return *ingest::manifest::parse_manifest(with("{name = \"t\", unit = \"s\"}", entry), "m.toml")
                .recordings.at(0)
                .columns.time;
  };
  const auto seconds =
      time("{name = \"sec\", unit = \"s\", plus = {name = \"nsec\", unit = \"ns\"}}");
  EXPECT_EQ(seconds.reading, clock);
  EXPECT_EQ(seconds.plus->name, "nsec");
  EXPECT_EQ(seconds.plus->si_factor, 1e-9);
  const auto day =
      time("{name = \"t\", unit = \"hh:mm:ss\", plus = {name = \"d\", unit = \"yyyy-mm-dd\"}}");
  EXPECT_EQ(day.reading, time_of_day);
  EXPECT_EQ(day.plus->reading, date);
  EXPECT_EQ(
      refusal(with("unit = \"s\"", "unit = \"s\", plus = {name = \"d\", unit = \"yyyy-mm-dd\"}")),
      "m.toml:11:60: key 'columns.time.plus.unit': cannot be added to that of the time, found "
      "'yyyy-mm-dd', expected one of s, ms, us, ns");
}

TEST(Manifest, RowsMayBeThoseOfOneJoint) {
  const auto columns =
      ingest::manifest::parse_manifest(
          with("[columns]\n", "[columns]\nrows = {name = \"joint\", value = \"elbow\"}\n"),
          "m.toml")
          .recordings.at(0)
          .columns;
  EXPECT_EQ(columns.rows->name, "joint");
  EXPECT_EQ(columns.rows->value, "elbow");
}

TEST(Manifest, NeverGuessesWhatTheEffortIs) {
  const std::string hint =
      "; hint: state kind = \"motor_current\", \"motor_torque\" or \"joint_torque\": the same "
      "column is ampere on one robot and newton metre on another, so it is never guessed; "
      "\"target_torque\" where it is a controller's value, \"none\" where nothing was recorded";
  EXPECT_EQ(refusal(with("[effort]\nkind = \"motor_torque\"\nside = \"motor\"\n", "")),
            "m.toml:1:1: key 'effort' is missing" + hint);
  EXPECT_EQ(refusal(with("kind = \"motor_torque\"\n", "")),
            "m.toml:7:1: key 'effort.kind' is missing" + hint);
  EXPECT_EQ(refusal(with("\"motor_torque\"", "\"effort\"")),
            "m.toml:8:8: key 'effort.kind': not known, found 'effort', expected one of "
            "'motor_current', 'motor_torque', 'joint_torque', 'target_torque', 'none'" +
                hint);
  EXPECT_EQ(refusal(with("side = \"motor\"\n", "")),
            "m.toml:7:1: key 'effort.side' is missing; hint: \"motor\": before the gear, or "
            "\"joint\": after it");
}

TEST(Manifest, WantsATorqueConstantForACurrentOnly) {
  EXPECT_EQ(refusal(with("\"motor_torque\"", "\"motor_current\"")),
            "m.toml:7:1: key 'effort.torque_constant_Nm_A' is missing, expected newton metres per "
            "ampere, on the side stated; hint: without it a current cannot become a torque");
  EXPECT_EQ(refusal(with("side = \"motor\"", "side = \"motor\"\ntorque_constant_Nm_A = 2")),
            "m.toml:10:24: key 'effort.torque_constant_Nm_A': torque constant 2 N·m/A is given for "
            "an effort of kind motor_torque; it belongs to 'motor_current'");
}

TEST(Manifest, RefusesAUnitThatContradictsTheKind) {
  EXPECT_EQ(refusal(with("\"Nm\"", "\"A\"")),
            "m.toml:13:32: key 'columns.effort.unit': contradicts effort.kind, found 'A', a "
            "current, expected a torque (Nm, mNm, kNm); hint: is the kind of the effort stated "
            "rightly?");
  EXPECT_EQ(
      refusal(with("\"rad\"", "\"gon\"")),
      "m.toml:12:29: unknown unit of an angle, found 'gon', expected one of rad, mrad, deg, turn; "
      "hint: a multiple of one will do, such as \"0.018 deg\"");
}

TEST(Manifest, RefusesWhatIsMissing) {
  EXPECT_EQ(refusal(""), "m.toml:1:1: key 'schema' is missing; hint: one of 'tribolog-dataset-1'");
  EXPECT_EQ(refusal(with("dataset-1", "dataset-2")),
            "m.toml:1:10: key 'schema': not known, found 'tribolog-dataset-2', expected one of "
            "'tribolog-dataset-1'; hint: did you mean 'tribolog-dataset-1'?");
  EXPECT_EQ(refusal(with("name = \"R\"", "name = \" \"")),
            "m.toml:3:8: key 'robot.name': is empty, expected a name; hint: the report and the "
            "archive go by the robot's name");
  EXPECT_EQ(refusal(with("gear_ratio = 100\n", "")),
            "m.toml:4:1: key 'joint.gear_ratio' is missing; hint: motor angle / joint angle; 1 for "
            "a direct drive");
  EXPECT_EQ(refusal(with("gear_ratio = 100", "gear_ratio = 0")),
            "m.toml:6:14: key 'joint.gear_ratio': not usable, found 0, expected a number > 0");
  EXPECT_EQ(
      refusal(with("effort = {name = \"tau\", unit = \"Nm\"}\n", "")),
      "m.toml:13:1: no column is stated for the effort, expected effort = {name = ..., unit = "
      "...} in [columns]; hint: without torque or current nothing can be identified; where neither "
      "was recorded, effort.kind = \"none\" checks the motion alone");
  EXPECT_EQ(refusal(with(", unit = \"s\"", "")),
            "m.toml:11:8: key 'columns.time.unit' is missing; hint: one of s, ms, us, ns");
  EXPECT_EQ(
      refusal(with("[[recording]]\nrole = \"oscillation\"\nfile = \"a.csv\"\n", "")),
      "m.toml: no [[recording]] is stated, expected one or more; hint: each with role and file");
}

TEST(Manifest, RefusesUnknownKeysEverywhere) {
  EXPECT_EQ(refusal(with("[joint]", "serail = \"S\"\n[joint]")),
            "m.toml:4:10: unknown key 'robot.serail'; hint: did you mean 'serial'?");
  EXPECT_EQ(refusal(with("unit = \"s\"", "unit = \"s\", side = \"motor\"")),
            "m.toml:11:40: unknown key 'columns.time.side'; hint: known here: 'any_rate', "
            "'confirmed', 'name', "
            "'plus', "
            "'rate_Hz', 'register', 'unit'");
  EXPECT_EQ(
      refusal(with("name = \"t\", unit = \"s\"", "rate_Hz = 1000, unit = \"s\"")).substr(0, 55),
      "m.toml:11:32: unknown key 'columns.time.unit'; hint: kn");
  EXPECT_NE(refusal(with("name = \"t\", unit = \"s\"", "rate_Hz = 0")).find("a number > 0"),
            std::string::npos);
  EXPECT_EQ(refusal(minimal + "form_s = 5\n"),
            "m.toml:17:10: unknown key 'recording.form_s'; hint: did you mean 'from_s'?");
  EXPECT_EQ(refusal(minimal + "[extras]\n").substr(0, 34), "m.toml:17:1: unknown key 'extras';");
}

TEST(Manifest, AColumnOfAnglesOrOfEffortMayCountTheOtherWayRound) {
  const ingest::manifest::ManifestFile effort = ingest::manifest::parse_manifest(
      with("unit = \"Nm\"", "unit = \"mNm\", sign = -1"), "m.toml");
  EXPECT_EQ(effort.recordings[0].columns.effort->si_factor, -1e-3);
  EXPECT_EQ(effort.effort_sign, 1.0);
  const ingest::manifest::ManifestFile angle = ingest::manifest::parse_manifest(
      with("unit = \"rad\"", "unit = \"rad\", sign = -1"), "m.toml");
  EXPECT_EQ(angle.recordings[0].columns.angle->si_factor, -1.0);
  EXPECT_NE(refusal(with("unit = \"Nm\"", "unit = \"Nm\", sign = 2")).find("is neither 1 nor -1"),
            std::string::npos);
}

TEST(Manifest, RefusesImpossibleValues) {
  EXPECT_EQ(refusal(minimal + "from_s = 5\nto_s = 5\n"),
            "m.toml:18:8: key 'recording.to_s': window is empty, found 5..5 s, expected from_s < "
            "to_s");
  EXPECT_EQ(refusal(with("side = \"motor\"", "side = \"motor\"\nsign = 2")),
            "m.toml:10:8: key 'effort.sign': not usable, found 2, expected 1 or -1");
  EXPECT_EQ(refusal(with("\"oscillation\"", "\"oscilation\"")),
            "m.toml:15:8: key 'recording.role': not known, found 'oscilation', expected one of "
            "'rough_sweep', 'precise_sweep', 'oscillation', 'constant_speed', 'break_away', "
            "'friction_points'; hint: did "
            "you mean 'oscillation'?");
  EXPECT_EQ(
      refusal(minimal + "[reference.waiboer]\nasperity_torque_Nm = 1\n"
                        "stribeck_speed_rad_s = 1\nstribeck_power = 1\n"
                        "viscous_coefficient = 1\nviscous_power = 1\n"),
      "m.toml:22:17: key 'reference.waiboer.viscous_power': viscous power 1 is not allowed; it "
      "must be < 1");
}

// Speeds of the joint at which friction is to be stated: in their order, each once.
TEST(Manifest, SpeedsOfFrictionAreStated) {
  const std::string joint = "gear_ratio = 100\n";
  const auto stated = [&](const std::string& value) {
    return with(joint, joint + "friction_at_rad_s = " + value + "\n");
  };
  EXPECT_EQ(
      ingest::manifest::parse_manifest(stated("[1, 0.2, 1]"), "m.toml").manifest.friction_at_rad_s,
      (std::vector<double>{0.2, 1}));
  EXPECT_TRUE(
      ingest::manifest::parse_manifest(minimal, "m.toml").manifest.friction_at_rad_s.empty());
  EXPECT_NE(refusal(stated("[0]")).find("key 'joint.friction_at_rad_s"), std::string::npos);
  EXPECT_NE(refusal(stated("[1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21]"))
                .find("has too many speeds, found 21, expected at most 20"),
            std::string::npos);
}

TEST(Manifest, KnownCurveIsOneOfAnyModel) {
  const std::string dahl =
      "[reference.dahl]\nstiffness_Nm_rad = 400\ncoulomb_Nm = 0.6\n"
      "viscous_Nms_rad = 0.01\n";
  const auto curve = ingest::manifest::parse_manifest(minimal + dahl, "m.toml").manifest.reference;
  ASSERT_TRUE(curve);
  EXPECT_EQ(curve->name(), "dahl");
  EXPECT_DOUBLE_EQ(curve->torque_Nm(-10), -0.7);
  EXPECT_EQ(refusal(minimal + dahl +
                    "[reference.threshold_speed]\ncoulomb_Nm = 1\nstatic_Nm = 1\n"
                    "stribeck_decay_s_rad = 0\nviscous_Nms_rad = 0\n"),
            "m.toml:17:1: key 'reference.dahl': is a second known curve, expected one, "
            "'threshold_speed'");
  EXPECT_EQ(refusal(minimal + "[reference.dahl]\nstiffness_Nm_rad = 400\n"),
            "m.toml:17:1: key 'reference.dahl.coulomb_Nm' is missing; hint: Tc > 0");
  EXPECT_EQ(refusal(minimal + "[reference.waibor]\n"),
            "m.toml:17:1: unknown key 'reference.waibor'; hint: did you mean 'waiboer'?");
  EXPECT_FALSE(
      ingest::manifest::parse_manifest(minimal + "[reference]\n", "m.toml").manifest.reference);
}

TEST(Manifest, RefusesTextThatIsNotUtf8) {
  EXPECT_EQ(refusal(with("\"R\"", "\"\xff\"")).substr(0, 9), "m.toml:3:");
}

TEST(Manifest, RefusesADescriptionThatIsNoFile) {
  const auto described = [](const std::string& value) {
    return with("name = \"R\"", "name = \"R\"\ndescription = " + value);
  };
  EXPECT_EQ(
      refusal(described("\"\"")),
      "m.toml:4:15: key 'robot.description': is no name of a file, found '', expected the file "
      "that describes the arm; hint: examples/paper/am100ib.toml is one");
  EXPECT_NE(refusal(described("\"a\\u0000b.toml\"")).find("m.toml:4:15: key 'robot.description'"),
            std::string::npos);
  EXPECT_NE(refusal(described("7")).find("m.toml:4:15: key 'robot.description': wrong type"),
            std::string::npos);
}

TEST(Manifest, TheSeedIsTheOneStated) {
  EXPECT_FALSE(ingest::manifest::parse_manifest(minimal, "m.toml").manifest.seed);
  const ingest::manifest::ManifestFile stated = ingest::manifest::parse_manifest(
      with("[columns]", "[intervals]\nresamples = 500\nseed = 42\n[columns]"), "m.toml");
  EXPECT_EQ(stated.manifest.seed, 42U);
  EXPECT_NE(refusal(with("[columns]", "[intervals]\nsede = 200\n[columns]")).find("seed"),
            std::string::npos);
}

TEST(ManifestLimits, AreReadWithTheirNumbers) {
  const ingest::manifest::ManifestFile m = ingest::manifest::parse_manifest(
      minimal +
          "[[limit]]\nquantity = \"coulomb_joint_Nm\"\nmax = 15\nhalf_width_percent = 5\n"
          "[[limit]]\nquantity = \"q_peak_deg\"\nmin = -23\nmax = -21\n",
      "m.toml");
  ASSERT_EQ(m.manifest.limits.size(), 2U);
  EXPECT_EQ(m.manifest.limits[0].quantity, "coulomb_joint_Nm");
  EXPECT_EQ(m.manifest.limits[0].max, 15);
  EXPECT_EQ(m.manifest.limits[0].half_width_percent, 5);
  EXPECT_FALSE(m.manifest.limits[0].min);
  EXPECT_EQ(m.manifest.limits[1].min, -23);
}

TEST(ManifestEffects, SizesAreReadAndTheRestIsTypical) {
  namespace effect = joint::effect;
  const joint::EffectSizes sizes =
      ingest::manifest::parse_manifest(minimal + "[effects]\nhoses_percent = 0\nlag_ms = 0.25\n",
                                       "m.toml")
          .manifest.effects;
  EXPECT_TRUE(sizes.is_stated(effect::hoses));
  EXPECT_EQ(sizes.of(effect::hoses), 0);
  EXPECT_EQ(sizes.of(effect::lag), 0.25);
  EXPECT_FALSE(sizes.is_stated(effect::offset));
  EXPECT_EQ(sizes.of(effect::offset), effect::offset.typical);
}

TEST(ManifestEffects, AreRefusedWhereNoneIsSoCalledOrSoLarge) {
  const auto expect_refused = [](const std::string& line, const std::string& because) {
    try {
      (void)ingest::manifest::parse_manifest(minimal + "[effects]\n" + line + "\n", "m.toml");
      ADD_FAILURE() << line << " is accepted";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(because), std::string::npos) << error.what();
    }
  };
  expect_refused("hose_percent = 1", "hoses_percent");
  expect_refused("hoses_percent = -1", "hoses_percent");
  expect_refused("hoses_percent = 60", "from 0 (it has none) to 5");
  expect_refused("law_at_its_ends_percent = 0", "law_at_its_ends_percent");
}

TEST(ManifestUncertainty, IsReadAsHalfWidths) {
  const ingest::manifest::ManifestFile m =
      ingest::manifest::parse_manifest(minimal +
                                           "[uncertainty]\ntorque_constant_percent = "
                                           "2\nangle_zero_deg = 0.05\nhoses_percent = 0.2\n",
                                       "m.toml");
  EXPECT_EQ(m.manifest.uncertainty.torque_constant_percent, 2);
  EXPECT_EQ(m.manifest.uncertainty.angle_zero_deg, 0.05);
  EXPECT_EQ(m.manifest.uncertainty.hoses_percent, 0.2);
  EXPECT_FALSE(m.manifest.uncertainty.gear_ratio_percent);
  EXPECT_FALSE(m.manifest.uncertainty.surrogate_distance_percent);
}

TEST(ManifestUncertainty, SaysWhatAnErrorComesFrom) {
  const ingest::manifest::ManifestFile m = ingest::manifest::parse_manifest(
      minimal + "[uncertainty]\n[uncertainty.id]\ntorque_constant = \"stand 3\"\n", "m.toml");
  EXPECT_EQ(m.manifest.uncertainty.id,
            (std::map<std::string, std::string>{{"torque_constant", "stand 3"}}));
  EXPECT_NE(refusal(minimal + "[uncertainty.id]\ntorque = \"stand 3\"\n").find("torque_constant"),
            std::string::npos);
}

TEST(ManifestUncertainty, ThatCannotBeMeantIsRefused) {
  const auto stated = [](const std::string& keys) {
    return refusal(minimal + "[uncertainty]\n" + keys);
  };
  EXPECT_NE(stated("torque_constant_percent = 80\n").find("more than half of the number"),
            std::string::npos);
  EXPECT_NE(stated("torque_constant_percent = -1\n").find(">= 0"), std::string::npos);
  EXPECT_NE(stated("torque_constant = 2\n").find("did you mean 'torque_constant_percent'"),
            std::string::npos)
      << stated("torque_constant = 2\n");
}

TEST(ManifestLimits, ThatCannotBeMeantAreRefused) {
  const auto limit = [](const std::string& keys) {
    return refusal(minimal + "[[limit]]\n" + keys);
  };
  EXPECT_NE(
      limit("quantity = \"colomb_joint_Nm\"\nmax = 1\n").find("did you mean 'coulomb_joint_Nm'"),
      std::string::npos);
  EXPECT_NE(limit("quantity = \"coulomb_joint_Nm\"\n").find("no number"), std::string::npos);
  EXPECT_NE(limit("quantity = \"coulomb_joint_Nm\"\nmin = 2\nmax = 1\n").find("min <= max"),
            std::string::npos);
  EXPECT_NE(limit("quantity = \"coulomb_joint_Nm\"\nhalf_width = 0\n").find("> 0"),
            std::string::npos);
  EXPECT_NE(limit("quantity = \"coulomb_joint_Nm\"\nmaximum = 1\n").find("unknown key"),
            std::string::npos);
}

TEST(ManifestEffort, MayBeOnlyProposed) {
  EXPECT_TRUE(
      ingest::manifest::parse_manifest(with("", ""), "m.toml").manifest.effort_is_confirmed);
  const std::string text = with("side = \"motor\"", "side = \"motor\"\nconfirmed = false");
  EXPECT_FALSE(ingest::manifest::parse_manifest(text, "m.toml").manifest.effort_is_confirmed);
  EXPECT_NE(refusal(with("side = \"motor\"", "side = \"motor\"\nconfirmed = \"no\""))
                .find("effort.confirmed"),
            std::string::npos);
}

TEST(ManifestEffort, MayBeWhatAControllerLeftWhenItTookGravityOff) {
  EXPECT_FALSE(
      ingest::manifest::parse_manifest(with("", ""), "m.toml").manifest.gravity_is_removed);
  const std::string removed = with("side = \"motor\"", "side = \"motor\"\ngravity_removed = true");
  const joint::Manifest m = ingest::manifest::parse_manifest(removed, "m.toml").manifest;
  EXPECT_TRUE(m.gravity_is_removed);
  ASSERT_TRUE(m.known_gravity);
  EXPECT_EQ(m.known_gravity->amplitude_Nm(), 0);
  const std::string both = removed + "[known_gravity]\namplitude_Nm = 10\nq_peak_deg = 0\n";
  EXPECT_NE(refusal(both).find("'effort.gravity_removed': contradicts [known_gravity]"),
            std::string::npos)
      << refusal(both);
}

TEST(ManifestColumns, MayHaveUnitsThatAreOnlyProposed) {
  const auto columns_of = [](const std::string& text) {
    return ingest::manifest::parse_manifest(text, "m.toml").recordings.at(0).columns;
  };
  EXPECT_FALSE(columns_of(with("", "")).time->is_proposed);
  EXPECT_FALSE(columns_of(with("", "")).angle->is_proposed);
  EXPECT_TRUE(
      columns_of(with("unit = \"s\"", "unit = \"s\", confirmed = false")).time->is_proposed);
  EXPECT_TRUE(
      columns_of(with("unit = \"rad\"", "unit = \"rad\", confirmed = false")).angle->is_proposed);
  EXPECT_FALSE(
      columns_of(with("unit = \"rad\"", "unit = \"rad\", confirmed = true")).angle->is_proposed);
  EXPECT_NE(refusal(with("unit = \"Nm\"", "unit = \"Nm\", confirmed = false")).find("unknown key"),
            std::string::npos)
      << "an effort is confirmed under [effort]";
}

TEST(ManifestEffort, OfAModelIsATorqueOnTheSideStated) {
  const ingest::manifest::ManifestFile m = ingest::manifest::parse_manifest(
      with("kind = \"motor_torque\"", "kind = \"target_torque\""), "m.toml");
  EXPECT_EQ(m.manifest.drive.kind(), joint::EffortKind::target_torque);
  EXPECT_EQ(m.manifest.drive.side(), joint::Side::motor);
  EXPECT_EQ(joint::to_string(m.manifest.drive.kind()), "target_torque");
  EXPECT_NE(
      refusal(with("kind = \"motor_torque\"", "kind = \"target_torque\"\ntorque_constant_Nm_A = 2"))
          .find("belongs to 'motor_current'"),
      std::string::npos);
}

TEST(ManifestEffort, MayBeNoneWhereNothingWasRecorded) {
  std::string text = with("kind = \"motor_torque\"\nside = \"motor\"", "kind = \"none\"");
  const std::string column = "effort = {name = \"tau\", unit = \"Nm\"}\n";
  EXPECT_NE(refusal(text).find("contradicts effort.kind"), std::string::npos);
  text.erase(text.find(column), column.size());
  const ingest::manifest::ManifestFile m = ingest::manifest::parse_manifest(text, "m.toml");
  EXPECT_EQ(m.manifest.drive.kind(), joint::EffortKind::none);
  EXPECT_FALSE(m.recordings[0].columns.effort);
}

TEST(ManifestEffort, OfVoltageOrDutyCycleIsRefusedInOneLine) {
  for (const char* kind : {"motor_voltage", "voltage", "pwm", "duty"}) {
    const std::string message =
        refusal(with("kind = \"motor_torque\"", "kind = \"" + std::string(kind) + "\""));
    EXPECT_NE(message.find("a voltage or duty cycle is no torque"), std::string::npos) << message;
    EXPECT_NE(message.find("m.toml:8:"), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
  for (const char* unit : {"V", "mV", "%", "PWM"}) {
    const std::string message =
        refusal(with("unit = \"Nm\"", "unit = \"" + std::string(unit) + "\""));
    EXPECT_NE(message.find("a voltage or duty cycle is no torque"), std::string::npos) << message;
    EXPECT_NE(message.find("present current"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace tribolog::manifest_file_test
