// Data sets of LeRobot, from the folder to the numbers: each episode is a recording, in a file of
// its own (version 2) or with others in one (version 3).

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/small_dataset.h"
#include "support/parquet_writer.h"

namespace tribolog::test::lerobot_test {
namespace {

constexpr int episodes = 3;
constexpr int rows_of_one = 1200;

/// A sweep there and back over a gravity peak at 0.2 rad; the episodes differ in their friction.
void add_episode(int episode, bool with_torque, std::vector<std::vector<float>>& state,
                 std::vector<std::vector<float>>& torque, std::vector<double>& times,
                 std::vector<std::int64_t>& numbers) {
  constexpr double seconds = 24;
  const double friction_Nm = 0.5 + 0.01 * episode;
  for (int i = 0; i < rows_of_one; ++i) {
    const double t = seconds * i / rows_of_one;
    const bool up = t < seconds / 2;
    const double share = up ? 2 * t / seconds : 2 - 2 * t / seconds;
    const double q = -0.8 + 2 * share;
    state.push_back({static_cast<float>(q), 0.5F});
    if (with_torque) {
      torque.push_back(
          {static_cast<float>(3 * std::cos(q - 0.2) + (up ? friction_Nm : -friction_Nm)), 0});
    }
    times.push_back(t);
    numbers.push_back(episode);
  }
}

/// @param from first and @param to last episode.
std::string parquet_of(int from, int to, bool with_torque = true) {
  std::vector<std::vector<float>> state;
  std::vector<std::vector<float>> torque;
  std::vector<double> times;
  std::vector<std::int64_t> numbers;
  for (int episode = from; episode <= to; ++episode) {
    add_episode(episode, with_torque, state, torque, times, numbers);
  }
  std::vector<std::int64_t> frames(times.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    frames[i] = static_cast<std::int64_t>(i) % rows_of_one;
  }
  WrittenParquet file;
  add_lists("observation.state", state, file);
  if (with_torque) add_lists("observation.torque", torque, file);
  add_doubles("timestamp", times, file);
  add_integers("frame_index", frames, file);
  add_integers("episode_index", numbers, file);
  return write_parquet(file);
}

class LeRobotFolder {
 public:
  explicit LeRobotFolder(const std::string& version) {
    const std::string names = R"({"names": ["elbow", "gripper"]})";
    for (const char* folder : {"meta", "data/chunk-000"}) {
      std::filesystem::create_directories(scratch_.file("set/" + std::string(folder)));
    }
    scratch_.write("set/meta/info.json", R"({"codebase_version": ")" + version +
                                             R"(", "fps": 50, "features": {"observation.state": )" +
                                             names + R"(, "observation.torque": )" + names + "}}");
  }
  void write(const std::string& name, const std::string& bytes) const {
    scratch_.write("set/data/chunk-000/" + name, bytes);
  }
  [[nodiscard]] ProgramRun run(const std::string& command) const {
    return run_shell("cd '" + scratch_.path() + "' && " + program + command);
  }
  [[nodiscard]] std::string text(const std::string& name) const {
    return read_text(scratch_.file(name));
  }

 private:
  ScratchDirectory scratch_;
};

const std::string init =
    "init set -o d.toml --joint elbow --gear-ratio 1 --effort-kind joint_torque --effort-side "
    "joint";
const std::string identify = "identify --truth-runs 0 d.toml -o c.json";

/// Angle of the gravity peak and amplitude, of the sweeps.
std::vector<double> numbers_of(const LeRobotFolder& folder) {
  const nlohmann::json all = nlohmann::json::parse(folder.text("c.json"));
  const nlohmann::json& sweep = all.at("cog").at("rough");
  return {sweep.at("q_peak_rad").at("estimate").get<double>(),
          sweep.at("gravity_Nm").at("estimate").get<double>()};
}

TEST(LeRobot, EpisodesOfOneFileAreRecordings) {
  const LeRobotFolder folder("v3.0");
  folder.write("file-000.parquet", parquet_of(0, episodes - 1));
  const ProgramRun made = folder.run(init);
  ASSERT_EQ(made.status, 0) << made.err;
  const std::string manifest = folder.text("d.toml");
  for (const char* line : {R"(name = "elbow.position")", R"(name = "elbow.torque", unit = "Nm")",
                           R"(rows = { name = "episode_index", value = "0" })",
                           R"(columns = { rows = { name = "episode_index", value = "2" } })"}) {
    EXPECT_NE(manifest.find(line), std::string::npos) << line << "\n" << manifest;
  }
  const ProgramRun identified = folder.run(identify);
  ASSERT_EQ(identified.status, 0) << identified.err << manifest;
  const std::string rows = std::to_string(episodes * rows_of_one);
  EXPECT_NE((identified.out + identified.err).find("rows: " + rows + " read"), std::string::npos)
      << identified.out << identified.err;
  EXPECT_EQ((identified.out + identified.err).find("overlap"), std::string::npos);
}

TEST(LeRobot, EitherVersionGivesTheSameNumbers) {
  const LeRobotFolder one_file("v3.0");
  one_file.write("file-000.parquet", parquet_of(0, episodes - 1));
  const LeRobotFolder file_each("v2.1");
  for (int k = 0; k < episodes; ++k) {
    file_each.write("episode_00000" + std::to_string(k) + ".parquet", parquet_of(k, k));
  }
  std::vector<std::vector<double>> numbers;
  for (const LeRobotFolder* folder : {&one_file, &file_each}) {
    const ProgramRun made = folder->run(init);
    ASSERT_EQ(made.status, 0) << made.err;
    const ProgramRun identified = folder->run(identify);
    ASSERT_EQ(identified.status, 0) << identified.err;
    numbers.push_back(numbers_of(*folder));
  }
  EXPECT_EQ(numbers[0], numbers[1]);
  EXPECT_NEAR(numbers[0][0], 0.2, 1e-4) << "as simulated";
  EXPECT_NEAR(numbers[0][1], 3, 1e-3);
}

TEST(LeRobot, ASetWithoutTorqueSaysSo) {
  const LeRobotFolder folder("v3.0");
  folder.write("file-000.parquet", parquet_of(0, 1, false));
  const ProgramRun inspected = folder.run("inspect set");
  EXPECT_EQ(inspected.status, 0) << inspected.err;
  EXPECT_NE(inspected.out.find("no torque or current in observation.*"), std::string::npos)
      << inspected.out;
  EXPECT_NE(inspected.out.find("2 recordings, which 'episode_index' tells apart"),
            std::string::npos)
      << inspected.out;
}

TEST(LeRobot, ASetWithoutItsDataIsRefused) {
  const LeRobotFolder folder("v3.0");
  const ProgramRun inspected = folder.run("inspect set");
  EXPECT_EQ(inspected.status, 3);
  EXPECT_NE(inspected.err.find("set: is a data set of LeRobot without data/*/*.parquet; hint: "
                               "download its folder data too"),
            std::string::npos)
      << inspected.err;
}

}  // namespace
}  // namespace tribolog::test::lerobot_test
