#include "ingest/manifest/scenario_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/error.h"
#include "base/input_file.h"
#include "ingest/manifest/robot_file.h"
#include "ingest/manifest/robot_joints.h"
#include "ingest/manifest/scenario_tables.h"
#include "ingest/manifest/toml_document.h"
#include "ingest/manifest/toml_table.h"
#include "simulate/simulate_joint.h"

namespace tribolog::ingest::manifest {
namespace {

constexpr std::uint64_t largest_scenario_bytes = 1 << 20;
constexpr double most_samples = 2e7;  ///< Of all recordings; a gigabyte of memory.

std::string required_name(const TomlTable& table) {
  std::string name = table.text("name");
  if (name.empty()) table.refuse("name", {"is empty", "", "a name", ""});
  return name;
}

/// The description is copied beside the recordings: its name must be none of theirs.
std::string read_copied_description_name(const TomlTable& robot) {
  std::string name = read_description_name(robot);
  const std::filesystem::path file(name);
  if (!name.empty() && (file.extension() != ".toml" || file.filename() == "dataset.toml")) {
    robot.refuse("description", {"cannot be copied beside the recordings", in_quotes(name),
                                 "a name that ends in .toml and is not dataset.toml", ""});
  }
  return name;
}

void read_joint(const TomlTable& joint, simulate::Scenario& scenario) {
  scenario.joint = required_name(joint);
  scenario.gear_ratio = joint.number("gear_ratio", Sign::positive);
  scenario.motor_inertia_kgm2 = joint.number("motor_inertia_kgm2", Sign::not_negative);
  scenario.arm_inertia_kgm2 = joint.number("arm_inertia_kgm2", Sign::not_negative);
  joint.refuse_unknown_keys();
}

/// A misplaced point in a speed or a rate asks for more samples than there is memory for.
class SampleCount {
 public:
  /// @throw InputError at the key that makes an experiment long, or at its rate.
  void add(const TomlTable& table, const char* long_by, double duration_s, double sample_rate_Hz) {
    const double samples = duration_s * sample_rate_Hz;
    samples_ += samples;
    if (samples_ <= most_samples) return;
    constexpr double fast_Hz = 1e5;
    const bool is_fast = sample_rate_Hz > fast_Hz && table.has("sample_rate_Hz");
    table.refuse(is_fast ? "sample_rate_Hz" : long_by,
                 {"the experiment has too many samples",
                  fmt::format("{:.4g} s at {:g} Hz", duration_s, sample_rate_Hz),
                  "no more than 20 million in all recordings",
                  "is it too slow, too long, or sampled too fast?"});
  }

 private:
  double samples_{};
};

const char* in_use(const TomlTable& table, const char* in_deg, const char* in_rad) {
  return table.has(in_deg) ? in_deg : in_rad;
}

void read_experiments(const TomlTable& top, simulate::Scenario& scenario) {
  SampleCount count;
  const auto sweep = [&](const char* key) -> std::optional<simulate::SweepExperiment> {
    const auto table = top.find_table(key);
    if (!table) return std::nullopt;
    const simulate::SweepExperiment e = read_sweep(*table);
    const double strokes = e.both_directions ? 2 : 1;
    count.add(*table, in_use(*table, "speed_deg_s", "speed_rad_s"),
              strokes * std::abs(e.to_rad - e.from_rad) / e.speed_rad_s, e.sample_rate_Hz);
    return e;
  };
  scenario.rough_sweep = sweep("rough_sweep");
  scenario.precise_sweep = sweep("precise_sweep");
  if (const auto table = top.find_table("sine_sweep")) {
    scenario.sine_sweep = read_sine_sweep(*table);
    const simulate::SineSweepExperiment& e = *scenario.sine_sweep;
    count.add(*table, "frequency_Hz", e.cycles / e.frequency_Hz, e.sample_rate_Hz);
  }
  for (const TomlTable& table : top.one_or_more_tables("oscillation")) {
    for (const simulate::OscillationExperiment& e : read_oscillation(table, scenario.gear_ratio)) {
      count.add(table, "frequency_Hz", e.cycles / e.frequency_Hz, e.sample_rate_Hz);
      if (scenario.oscillation) {
        scenario.further_oscillations.push_back(e);
      } else {
        scenario.oscillation = e;
      }
    }
  }
  if (const auto table = top.find_table("break_away")) {
    const simulate::BreakAwayExperiment e = read_break_away(*table);
    const double ramps = static_cast<double>(e.repeats) * (e.both_directions ? 2 : 1);
    count.add(*table, "rate_Nm_s", ramps * e.largest_torque_Nm / e.rate_Nm_s, e.sample_rate_Hz);
    scenario.break_away = e;
  }
  if (const auto table = top.find_table("constant_speed")) {
    scenario.constant_speed = read_constant_speed(*table);
    const simulate::ConstantSpeedExperiment& e = *scenario.constant_speed;
    for (const double motor_speed : e.motor_speeds_rad_s) {
      const simulate::TravelMotion motion = guarded(*table, "longest_plateau_s", [&] {
        return simulate::TravelMotion(simulate::run_at(motor_speed, e, scenario.gear_ratio));
      });
      count.add(*table, "longest_plateau_s", motion.duration_s(), e.sample_rate_Hz);
    }
  }
}

simulate::Scenario scenario_of(const TomlTable& top, const std::string& file) {
  (void)top.choice("schema", {"tribolog-scenario-1"});
  simulate::Scenario scenario;
  scenario.name = required_name(top);
  const TomlTable robot = top.table("robot");
  scenario.robot = required_name(robot);
  scenario.serial = robot.text_or("serial", "");
  scenario.robot_description = read_copied_description_name(robot);
  robot.refuse_unknown_keys();
  read_joint(top.table("joint"), scenario);
  scenario.load = read_load(top.table("load"));
  if (const auto surrogate = top.find_table("surrogate")) {
    scenario.surrogate_distance_m =
        surrogate->number_or("distance_m", scenario.surrogate_distance_m, Sign::positive);
    surrogate->refuse_unknown_keys();
  }
  const JointFriction friction = read_friction(top.table("friction"));
  scenario.presliding = friction.presliding;
  scenario.sliding = friction.sliding;
  read_experiments(top, scenario);
  if (const auto noise = top.find_table("noise")) scenario.noise = read_noise(*noise);
  if (const auto log = top.find_table("log")) scenario.log = read_log_form(*log);
  top.refuse_unknown_keys();
  if (!scenario.rough_sweep && !scenario.precise_sweep && !scenario.sine_sweep &&
      !scenario.oscillation && !scenario.constant_speed && !scenario.break_away) {
    throw InputError(
        {file, 0, 0},
        {"no experiment is stated", "",
         "[rough_sweep], [precise_sweep], [sine_sweep], [oscillation], [constant_speed] or "
         "[break_away]",
         ""});
  }
  return scenario;
}

}  // namespace

simulate::Scenario parse_scenario(std::string_view text, const std::string& file) {
  return scenario_of(TomlTable::parse(text, file), file);
}

std::vector<simulate::Scenario> read_robot_scenario(const std::string& path) {
  const std::string text = read_file(path, largest_scenario_bytes);
  precheck_toml(text, path);
  const TomlNode document = parse_toml(text, path);
  std::vector<simulate::Scenario> scenarios;
  for (const std::string& joint : joint_names(document, path)) {
    scenarios.push_back(scenario_of(TomlTable::of(manifest_of_joint(document, joint), path), path));
  }
  return scenarios;
}

simulate::Scenario read_scenario(const std::string& path) {
  simulate::Scenario scenario = parse_scenario(read_file(path, largest_scenario_bytes), path);
  if (!scenario.robot_description.empty()) {
    const std::filesystem::path file =
        std::filesystem::path(path).parent_path() / scenario.robot_description;
    scenario.robot_description_text = read_file(file.string(), largest_robot_bytes);
    (void)parse_robot(scenario.robot_description_text, file.string());
  }
  return scenario;
}

}  // namespace tribolog::ingest::manifest
