// `tribolog inspect` and `tribolog init`: from logs to a manifest that `identify` takes.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/small_dataset.h"
#include "support/bag_writer.h"
#include "support/cdr_writer.h"
#include "support/mcap_writer.h"
#include "support/real_logs.h"

namespace tribolog::test::inspect_test {
namespace {

constexpr double end_share = 0.02;  // of a segment's length

std::string quoted(const std::string& path) { return "'" + path + "' "; }

/// Runs init on the logs, then identify on what it wrote, and returns the calibration.
nlohmann::json identified(const ScratchDirectory& scratch, const std::string& init_arguments,
                          int expected_status = 0) {
  const std::string manifest = scratch.file("dataset.toml");
  const ProgramRun init = run_shell(program + "init " + init_arguments + " -o " + manifest);
  EXPECT_EQ(init.status, 0) << init.err;
  const std::string out = scratch.file("calibration.json");
  const ProgramRun run = run_shell(program + "identify --truth-runs 0 " + manifest + " -o " + out);
  EXPECT_EQ(run.status, expected_status) << run.err;
  return nlohmann::json::parse(read_text(out));
}

nlohmann::json inspected(const ScratchDirectory& scratch, const std::string& arguments) {
  const std::string out = scratch.file("inspection.json");
  const ProgramRun run = run_shell(program + "inspect -q " + arguments + " --json " + out);
  EXPECT_EQ(run.status, 0) << run.err;
  return nlohmann::json::parse(read_text(out));
}

const nlohmann::json& joint_of(const nlohmann::json& log) { return log["tables"][0]["joints"][0]; }

struct Ur10eJoint {
  const char* log;
  double torque_constant_Nm_A, from_s, to_s;  // as the data's description has it
  const char* hand_written;
};

class Ur10e : public testing::TestWithParam<Ur10eJoint> {};

TEST_P(Ur10e, TheSineIsFoundAndIdentifiedAsByHand) {
  const Ur10eJoint c = GetParam();
  TRIBOLOG_NEEDS_REAL_LOG(c.log);
  const ScratchDirectory scratch;
  const std::string log = quoted(*real_log(c.log));
  const nlohmann::json survey = inspected(scratch, log);
  int sweeps = 0;
  for (const auto& s : joint_of(survey["logs"][0])["segments"]) {
    if (s["kind"] != "slow sweep") continue;
    ++sweeps;
    EXPECT_NEAR(s["from_s"], c.from_s, end_share * (c.to_s - c.from_s));
    EXPECT_NEAR(s["to_s"], c.to_s, end_share * (c.to_s - c.from_s));
    EXPECT_NEAR(s["frequency_Hz"], 0.1, 0.001);
  }
  EXPECT_EQ(sweeps, 1);

  const nlohmann::json proposed =
      identified(scratch, log + fmt::format("--torque-constant {}", c.torque_constant_Nm_A));
  const std::string by_hand = scratch.file("by_hand.json");
  const ProgramRun run =
      run_shell(program + "identify --truth-runs 0 " + TRIBOLOG_SOURCE_DIR "/tests/data/" +
                c.hand_written + " -o " + by_hand);
  ASSERT_EQ(run.status, 0) << run.err;
  const nlohmann::json reference = nlohmann::json::parse(read_text(by_hand));
  for (const char* pointer : {"/cog/rough/gravity_joint_Nm/estimate", "/model/law/level_Nm"}) {
    const nlohmann::json::json_pointer at(pointer);
    ASSERT_TRUE(reference.contains(at)) << pointer;
    const double expected = reference[at];
    EXPECT_NEAR(proposed[at].get<double>(), expected, 0.02 * std::abs(expected)) << pointer;
  }
}

INSTANTIATE_TEST_SUITE_P(Inspect, Ur10e,
                         testing::Values(Ur10eJoint{"ur10e_jointwise/joint_2.csv", 10.696, 5.0,
                                                    62.3, "ur10e_joint_2.toml"},
                                         Ur10eJoint{"ur10e_jointwise/joint_3.csv", 8.457, 5.5, 62.7,
                                                    "ur10e_joint_3.toml"}),
                         [](const auto& tested) {
                           return std::filesystem::path(tested.param.log).stem().string();
                         });

/// Travel of a run by the angle alone. A joint that yields before it runs has no sharp start: it is
/// between the last samples within 2e-5 and 6e-5 rad of where it stood, three steps of this encoder
/// and ten. The end is the sample furthest from there.
struct Travel {
  double earliest_start_s, latest_start_s, end_s;
};

Travel travel_of(const std::string& csv) {
  constexpr double still_rad = 2e-5;
  constexpr double yielding_rad = 6e-5;
  std::vector<double> t, q;
  const std::string text = read_text(csv);
  std::size_t at = text.find('\n') + 1;
  while (at < text.size()) {
    const std::size_t comma = text.find(',', at);
    t.push_back(std::stod(text.substr(at, comma - at)));
    q.push_back(std::stod(text.substr(comma + 1, text.find(',', comma + 1) - comma - 1)));
    at = text.find('\n', at);
    if (at == std::string::npos) break;
    ++at;
  }
  std::size_t first = 0;
  std::size_t yielding = 0;
  std::size_t last = 0;
  for (std::size_t i = 0; i < q.size(); ++i) {
    if (std::abs(q[i] - q[0]) > std::abs(q[last] - q[0])) last = i;
  }
  for (std::size_t i = 0; i < last; ++i) {
    if (std::abs(q[i] - q[0]) <= still_rad) first = i;
    if (std::abs(q[i] - q[0]) <= yielding_rad) yielding = i;
  }
  return {t[first], t[yielding], t[last]};
}

TEST(Inspect, The57RunsOfCiceseAreRunsAtTheSpeedsOfTheirNames) {
  TRIBOLOG_NEEDS_REAL_LOG("cicese_joint1/constant_velocity/cv_pos_10.0dps.csv");
  const std::string directory =
      std::filesystem::path(*real_log("cicese_joint1/constant_velocity/cv_pos_10.0dps.csv"))
          .parent_path()
          .string();
  const ScratchDirectory scratch;
  const nlohmann::json survey = inspected(scratch, directory + "/*.csv");
  ASSERT_EQ(survey["logs"].size(), 57U);
  int runs = 0;
  for (const auto& log : survey["logs"]) {
    const std::string file = log["file"];
    SCOPED_TRACE(file);
    const std::string name = std::filesystem::path(file).filename().string();
    // In this one the joint sticks for 10 s, creeps, and never comes to its speed.
    if (name == "cv_pos_00.1dps_rep2.csv") continue;
    const double speed_deg_s =
        std::stod(name.substr(7)) * (name.starts_with("cv_neg") ? -1.0 : 1.0);
    const Travel travel = travel_of(file);
    const auto& segments = joint_of(log)["segments"];
    const auto run = std::find_if(segments.begin(), segments.end(),
                                  [](const auto& s) { return s["kind"] == "constant speed"; });
    ASSERT_NE(run, segments.end());
    ++runs;
    const double tolerance_s = end_share * (travel.end_s - travel.latest_start_s);
    EXPECT_GE((*run)["from_s"], travel.earliest_start_s - tolerance_s);
    EXPECT_LE((*run)["from_s"], travel.latest_start_s + tolerance_s);
    EXPECT_NEAR((*run)["to_s"], travel.end_s, tolerance_s);
    const double found_deg_s = (*run)["speed_rad_s"].get<double>() * 180 / std::numbers::pi *
                               (*run)["direction"].get<double>();
    // Below 1 deg/s the controller needs the whole run to reach its speed.
    const double off = std::abs(speed_deg_s) < 1 ? 0.15 : 0.02;
    EXPECT_NEAR(found_deg_s, speed_deg_s, off * std::abs(speed_deg_s));
  }
  EXPECT_EQ(runs, 56);
  const nlohmann::json calibration = identified(scratch, directory + "/*.csv");
  EXPECT_EQ(calibration["robot"]["joint"], "1") << "joint 2 moves less far";
}

TEST(Inspect, RampsAndPreslidingOfCiceseHaveTheirRoles) {
  TRIBOLOG_NEEDS_REAL_LOG("cicese_joint1/breakaway/breakaway_j1_n05_exp2.csv");
  const std::string joint =
      std::filesystem::path(*real_log("cicese_joint1/breakaway/breakaway_j1_n05_exp2.csv"))
          .parent_path()
          .parent_path();
  const ScratchDirectory scratch;
  const ProgramRun run = run_shell(program + "init " + joint + "/breakaway/*.csv " + joint +
                                   "/presliding/sine*.csv -o " + scratch.file("dataset.toml"));
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("3 oscillation, 10 break_away"), std::string::npos) << run.out;
  const std::string out = scratch.file("c.json");
  EXPECT_EQ(
      run_shell(program + "identify --truth-runs 0 " + scratch.file("dataset.toml") + " -o " + out)
          .status,
      0);
  const nlohmann::json calibration = nlohmann::json::parse(read_text(out));
  EXPECT_EQ(calibration["break_away"]["ramps"].size(), 10U);
}

TEST(Inspect, AServoThatLogsVoltageAloneIsToldWhatToRecord) {
  TRIBOLOG_NEEDS_REAL_LOG("bam_xl330_pendulum/sin_sin_kp400.csv");
  const ScratchDirectory scratch;
  const std::string log = quoted(*real_log("bam_xl330_pendulum/sin_sin_kp400.csv"));
  const ProgramRun run = run_shell(program + "inspect " + log);
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("kind = \"none\""), std::string::npos);
  EXPECT_NE(run.out.find("Record the motor current or the torque"), std::string::npos);
  EXPECT_NE(run.out.find("'u_motor_V'"), std::string::npos);
  (void)identified(scratch, log);
}

/// Joint states of two joints: the elbow sweeps there and back over its gravity peak.
std::vector<JointStateMessage> joint_states() {
  std::vector<JointStateMessage> messages;
  constexpr std::int64_t start_ns = 1'700'000'000'123'456'789;
  for (int i = 0; i < 4000; ++i) {
    const double t = 0.01 * i;
    const double direction = t < 20 ? 1 : -1;
    const double q = t < 20 ? -1 + 0.1 * t : 1 - 0.1 * (t - 20);
    const double torque = 3 * std::cos(q - 0.2) + 0.5 * direction;
    const std::int64_t stamp_ns = start_ns + static_cast<std::int64_t>(i) * 10'000'000;
    messages.push_back(
        {stamp_ns, {"wrist", "elbow"}, {0.5, q}, {0, 0.1 * direction}, {0.1, torque}});
  }
  return messages;
}

std::string joint_state_log() {
  McapWriter writer({});
  writer.add_schema(7, "sensor_msgs/msg/JointState", "ros2msg", joint_state_definition);
  writer.add_channel(3, 7, "/joint_states");
  for (const JointStateMessage& message : joint_states()) {
    writer.add_message(3, static_cast<std::uint64_t>(message.stamp_ns), message.cdr());
  }
  return writer.finish();
}

std::string json_joint_state_log() {
  McapWriter writer({});
  writer.add_channel(3, 0, "/joint_states", "json");
  for (const JointStateMessage& message : joint_states()) {
    const nlohmann::json json = {{"header",
                                  {{"stamp",
                                    {{"sec", message.stamp_ns / 1'000'000'000},
                                     {"nanosec", message.stamp_ns % 1'000'000'000}}}}},
                                 {"name", message.names},
                                 {"position", message.position},
                                 {"velocity", message.velocity},
                                 {"effort", message.effort}};
    writer.add_message(3, static_cast<std::uint64_t>(message.stamp_ns), json.dump());
  }
  return writer.finish();
}

std::string joint_state_bag() {
  std::string records =
      bag_connection(0, "/joint_states", "sensor_msgs/JointState", std::string(ros1_joint_state));
  for (const JointStateMessage& message : joint_states()) {
    Ros1Message bytes;
    bytes.add_header(message.stamp_ns).add_texts(message.names).add_sequence(message.position);
    bytes.add_sequence(message.velocity).add_sequence(message.effort);
    records += bag_message(0, static_cast<std::uint64_t>(message.stamp_ns), bytes.bytes());
  }
  return bag_start(1) + bag_chunk("none", records, records.size());
}

TEST(Inspect, JointStatesInMcapGiveAManifestThatIdentifyTakes) {
  ScratchDirectory scratch;
  const std::string log = scratch.write("states.mcap", joint_state_log());
  const nlohmann::json calibration = identified(scratch, quoted(log));
  EXPECT_EQ(calibration["robot"]["joint"], "elbow") << "the wrist stands still";
  const double gravity_Nm = calibration["cog"]["rough"]["gravity_joint_Nm"]["estimate"];
  EXPECT_NEAR(gravity_Nm, 3, 0.01);
}

TEST(Inspect, JointStatesGiveTheSameInWhateverTheyAreRecorded) {
  const auto cog = [](const std::string& name, const std::string& bytes) {
    const ScratchDirectory scratch;
    const nlohmann::json calibration = identified(scratch, quoted(scratch.write(name, bytes)));
    EXPECT_EQ(calibration["robot"]["joint"], "elbow");
    return calibration["cog"];
  };
  const nlohmann::json in_cdr = cog("states.mcap", joint_state_log());
  EXPECT_EQ(cog("json.mcap", json_joint_state_log()), in_cdr);
  EXPECT_EQ(cog("states.bag", joint_state_bag()), in_cdr);
}

TEST(Inspect, AFolderOfRosbag2IsTheFilesThatItLists) {
  ScratchDirectory scratch;
  scratch.write("bag_0.mcap", joint_state_log());
  scratch.write("another.mcap", "no log of this recording");
  scratch.write("metadata.yaml",
                "rosbag2_bagfile_information:\n  version: 5\n  relative_file_paths:\n"
                "    - \"bag_0.mcap\"\n  message_count: 4000\n");
  const nlohmann::json calibration = identified(scratch, quoted(scratch.path()));
  EXPECT_EQ(calibration["robot"]["joint"], "elbow");
  scratch.write("metadata.yaml", "  relative_file_paths:\n    - gone.mcap\n");
  const ProgramRun run = run_shell(program + "inspect " + quoted(scratch.path()));
  EXPECT_EQ(run.status, 3);
  EXPECT_NE(run.err.find("gone.mcap"), std::string::npos) << run.err;
}

TEST(Inspect, OfAFolderWhatIsNoLogIsToldAndLeftOut) {
  const SmallDataset data;
  data.scratch().write("notes.txt", "measured on a cold morning\n");
  const std::string folder = quoted(data.scratch().path());
  const std::string manifest = data.file("found.toml");
  const ProgramRun run = run_shell(program + "init " + folder + "-o " + quoted(manifest));
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.err.find("note: not used: "), std::string::npos) << run.err;
  EXPECT_NE(read_text(manifest).find("file = \"log.csv\""), std::string::npos);
  const ProgramRun over =
      run_shell(program + "init --force " + folder + "-o " + quoted(data.file("log.csv")));
  EXPECT_EQ(over.status, 2) << "a log of the folder is an input";
  const ScratchDirectory empty;
  EXPECT_EQ(run_shell(program + "inspect " + quoted(empty.path())).status, 3);
}

/// The windows that are proposed have to count as the reader counts.
TEST(Inspect, AClockFrom1970InABinaryLogGivesWindowsThatIdentifyTakes) {
  const ScratchDirectory scratch;
  nlohmann::json log;
  for (int i = 0; i < 5000; ++i) {
    const double t = 0.01 * i;
    const double way = std::clamp(t - 5, 0.0, 40.0);  // rest, there and back, rest
    const double q = way < 20 ? -1 + 0.1 * way : 1 - 0.1 * (way - 20);
    const double direction = t < 5 || t > 45 ? 0 : way < 20 ? 1 : -1;
    log["stamp"].push_back(1.7e9 + t);
    log["q_rad"].push_back(q);
    log["tau_Nm"].push_back(3 * std::cos(q - 0.2) + 0.5 * direction);
  }
  const nlohmann::json calibration =
      identified(scratch, quoted(scratch.write("run.json", log.dump())));
  const double gravity_Nm = calibration["cog"]["rough"]["gravity_joint_Nm"]["estimate"];
  EXPECT_NEAR(gravity_Nm, 3, 0.01);
}

TEST(Inspect, OneRefusedLogDoesNotHideTheOthers) {
  const SmallDataset good;
  const std::string bad = good.scratch().write("bad.csv", "t,q\n1,2\n3,x,4\n");
  const ProgramRun run =
      run_shell(program + "inspect " + quoted(bad) + quoted(good.file("log.csv")));
  EXPECT_EQ(run.status, 3);
  EXPECT_NE(run.err.find("bad.csv:3"), std::string::npos) << run.err;
  EXPECT_NE(run.out.find("log.csv"), std::string::npos);
  EXPECT_NE(run.out.find("rough_sweep"), std::string::npos);
}

TEST(Init, DoesNotReplaceAFileUnasked) {
  const SmallDataset data;
  const std::string manifest = read_text(data.file("dataset.toml"));
  const std::string command =
      program + "init " + quoted(data.file("log.csv")) + "-o " + quoted(data.file("dataset.toml"));
  const ProgramRun refused = run_shell(command);
  EXPECT_EQ(refused.status, 4);
  EXPECT_NE(refused.err.find("--force"), std::string::npos);
  EXPECT_EQ(read_text(data.file("dataset.toml")), manifest);
  EXPECT_EQ(run_shell(command + " --force").status, 0);
  EXPECT_NE(read_text(data.file("dataset.toml")), manifest);
}

TEST(Init, IsNeverWrittenOverALog) {
  const SmallDataset data;
  const std::string log = quoted(data.file("log.csv"));
  const ProgramRun run = run_shell(program + "init --force " + log + "-o " + log);
  EXPECT_EQ(run.status, 2);
}

}  // namespace
}  // namespace tribolog::test::inspect_test
