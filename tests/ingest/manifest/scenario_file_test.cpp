#include "ingest/manifest/scenario_file.h"

#include <algorithm>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/input_file.h"
#include "base/temporary_directory.h"
#include "simulate/simulate_joint.h"

namespace tribolog::scenario_file_test {
namespace {

constexpr double rad_per_deg = std::numbers::pi / 180;

std::string example(const std::string& name) {
  return std::string(TRIBOLOG_SOURCE_DIR) + "/examples/paper/" + name;
}

std::string with(const std::string& piece, const std::string& replacement) {
  std::string text = read_file(example("scenario.toml"));
  const std::size_t at = text.find(piece);
  if (at == std::string::npos) throw std::logic_error("no such piece: " + piece);
  return text.replace(at, piece.size(), replacement);
}

std::string refusal(const std::string& text) {
  return test::refusal_of<InputError>(
      [&] { return ingest::manifest::parse_scenario(text, "s.toml"); });
}

/// What is said without the line, which moves with every comment in the example.
std::string refusal_without_line(const std::string& text) {
  const std::string said = refusal(text);
  const std::size_t colon = said.find(": ");
  return colon == std::string::npos ? said : said.substr(colon + 2);
}

// The paper prints 3.3, Table 2; its joint is the one in the example.
TEST(PaperScenario, HasTheGravityTorqueBehindTheTable) {
  const simulate::Scenario s = ingest::manifest::read_scenario(example("scenario.toml"));
  EXPECT_NEAR(s.load.amplitude_Nm() / s.gear_ratio, 3.88318571, 1e-12);
  EXPECT_NEAR(joint::surrogate_mass_kg(s.load.amplitude_Nm() / s.gear_ratio, s.gear_ratio,
                                       s.surrogate_distance_m, s.load.gravity_m_s2(), 1.0),
              79.1679, 5e-5);
  EXPECT_NEAR(s.load.q_peak_rad(), -0.388019, 5e-7);
  EXPECT_NEAR(s.arm_inertia_kgm2, s.load.mass_kg() * s.load.distance_m() * s.load.distance_m(),
              1e-5);
}

TEST(PaperScenario, HasTheFrictionBehindTheTable) {
  const simulate::Scenario s = ingest::manifest::read_scenario(example("scenario.toml"));
  const auto& p = dynamic_cast<const friction::LuGreFriction&>(*s.presliding).parameters();
  const double motor_amplitude = s.gear_ratio * s.oscillation->amplitude_rad;
  const double motor_speed = motor_amplitude * 2 * std::numbers::pi * s.oscillation->frequency_Hz;
  EXPECT_NEAR(p.bristle_stiffness_Nm_rad * motor_amplitude / p.static_Nm, 5.26269819, 1e-4);
  EXPECT_NEAR((p.bristle_damping_Nms_rad + p.viscous_Nms_rad) * motor_speed, 0.04849331, 1e-5);
  EXPECT_NEAR(s.sliding->torque_Nm(1e-3), 0.88, 0.01);
  EXPECT_NEAR(s.sliding->torque_Nm(17), 0.45, 0.01);
  EXPECT_NEAR(s.sliding->torque_Nm(300), 1.17, 0.01);
}

TEST(PaperScenario, HasTheExperimentsOfThePaper) {
  const simulate::Scenario s = ingest::manifest::read_scenario(example("scenario.toml"));
  EXPECT_EQ(s.robot, "FANUC AM100iB");
  EXPECT_DOUBLE_EQ(s.rough_sweep->from_rad, -80 * rad_per_deg);
  EXPECT_DOUBLE_EQ(s.rough_sweep->speed_rad_s, 2 * rad_per_deg);
  EXPECT_DOUBLE_EQ(s.precise_sweep->to_rad, -21.2 * rad_per_deg);
  EXPECT_EQ(s.oscillation->cycles, 5);
  EXPECT_TRUE(s.oscillation->record_bristle);
  const auto& speeds = s.constant_speed->motor_speeds_rad_s;
  EXPECT_EQ(speeds.size(), 20U);
  EXPECT_EQ(speeds.front(), 1);
  EXPECT_EQ(speeds.back(), 300);
  EXPECT_TRUE(std::is_sorted(speeds.begin(), speeds.end()));
  EXPECT_EQ(s.noise.torque_white_Nm, 0);
  EXPECT_TRUE(s.noise.ripple.empty());
}

TEST(PaperScenario, StaysWithinTheJointsRange) {
  const simulate::Scenario s = ingest::manifest::read_scenario(example("scenario.toml"));
  const auto recordings = simulate::simulate_joint(s);
  EXPECT_EQ(recordings.size(), 23U);
  for (const joint::Recording& r : recordings) {
    for (const double q : r.q_rad) {
      ASSERT_GE(q, s.rough_sweep->from_rad - 1e-9) << r.name;
      ASSERT_LE(q, s.rough_sweep->to_rad + 1e-9) << r.name;
    }
  }
}

TEST(PaperScenario, NoisyOnesDifferInTheDriveOnly) {
  const simulate::Scenario ideal = ingest::manifest::read_scenario(example("scenario.toml"));
  const simulate::Scenario noisy = ingest::manifest::read_scenario(example("scenario_noise.toml"));
  const simulate::Scenario ripple =
      ingest::manifest::read_scenario(example("scenario_ripple.toml"));
  EXPECT_EQ(noisy.noise.torque_white_Nm, 0.02);
  EXPECT_EQ(noisy.noise.torque_step_Nm, 0.005);
  EXPECT_EQ(noisy.noise.encoder_counts_per_turn, 131072);
  EXPECT_EQ(noisy.noise.speed_filter_Hz, 100);
  EXPECT_EQ(noisy.oscillation->cycles, 10);
  EXPECT_FALSE(noisy.oscillation->record_bristle);
  EXPECT_TRUE(noisy.further_oscillations.empty());
  EXPECT_TRUE(noisy.noise.ripple.empty());
  ASSERT_EQ(ripple.noise.ripple.size(), 2U);
  EXPECT_EQ(ripple.noise.ripple[0].periods_per_turn, 1);
  EXPECT_EQ(ripple.noise.ripple[1].periods_per_turn, 6);
  for (const simulate::Scenario* s : {&noisy, &ripple}) {
    EXPECT_EQ(s->load.mass_kg(), ideal.load.mass_kg());
    EXPECT_EQ(s->presliding->named_parameters(), ideal.presliding->named_parameters());
    EXPECT_EQ(s->sliding->named_parameters(), ideal.sliding->named_parameters());
    EXPECT_EQ(s->constant_speed->motor_speeds_rad_s, ideal.constant_speed->motor_speeds_rad_s);
  }
}

TEST(ScenarioFile, ReadsSeveralOscillationsAndPositions) {
  const simulate::Scenario spread = ingest::manifest::parse_scenario(
      with("cycles = 5", "cycles = 5\npositions = 8"), "scenario.toml");
  EXPECT_EQ(spread.further_oscillations.size(), 7U);
  const simulate::Scenario two = ingest::manifest::parse_scenario(
      with("[oscillation]",
           "[[oscillation]]\ncentre_deg = 0\namplitude_rad = 1e-3\nfrequency_Hz = 2\ncycles = 3\n"
           "[[oscillation]]"),
      "scenario.toml");
  EXPECT_EQ(two.oscillation->amplitude_rad, 1e-3);
  ASSERT_EQ(two.further_oscillations.size(), 1U);
  EXPECT_EQ(two.further_oscillations[0].cycles, 5);
  EXPECT_EQ(
      refusal_without_line(with("cycles = 5", "cycles = 5\npositions = 0")),
      "key 'oscillation.positions': not usable, found 0, expected a whole number from 1 to 99");
}

TEST(ScenarioFile, RefusesImpossibleParametersAtTheirKey) {
  EXPECT_EQ(refusal_without_line(with("coulomb_Nm = 0.60", "coulomb_Nm = 1.4")),
            "key 'friction.presliding.coulomb_Nm': Coulomb torque 1.4 N·m exceeds static torque "
            "0.88437633 N·m; it must not be larger");
  EXPECT_EQ(
      refusal_without_line(with("viscous_power = 0.6", "viscous_power = 1.5")),
      "key 'friction.sliding.viscous_power': viscous power 1.5 is not allowed; it must be < 1");
  EXPECT_EQ(refusal_without_line(with("mass_kg = 98.9", "mass_kg = -98.9")),
            "key 'load.mass_kg': not usable, found -98.95988047910294, expected a number > 0");
  EXPECT_EQ(refusal_without_line(with("frequency_Hz = 1 ", "frequency_Hz = 0 ")),
            "key 'oscillation.frequency_Hz': not usable, found 0, expected a number > 0");
  EXPECT_EQ(refusal_without_line(with("cycles = 5", "cycles = 0.5")),
            "key 'oscillation.cycles': not usable, found 0.5, expected >= 1");
  EXPECT_NE(refusal_without_line(with("\"lugre\"", "\"lugrée\""))
                .find("key 'friction.model': not known, found 'lugrée', expected one of "),
            std::string::npos);
}

TEST(ScenarioFile, RefusesExperimentsThatCannotBeCarriedOut) {
  EXPECT_EQ(refusal_without_line(with("to_deg = 60", "to_deg = -80")),
            "key 'rough_sweep.to_deg': the sweep ends where it starts, found -1.3962634015954636 "
            "rad, expected another angle than from");
  EXPECT_NE(refusal_without_line(with("speed_deg_s = 2", "speed_deg_s = 9000"))
                .find("key 'rough_sweep.to_deg': a travel of"),
            std::string::npos);
  EXPECT_EQ(
      refusal_without_line(with("speed_deg_s = 2", "speed_deg_s = 2e-5")),
      "key 'rough_sweep.speed_deg_s': the experiment has too many samples, found 1.4e+07 s at "
      "1000 Hz, expected no more than 20 million in all recordings; hint: is it too slow, too "
      "long, or sampled too fast?");
  EXPECT_EQ(
      refusal_without_line(with("speed_deg_s = 2", "speed_deg_s = 2e-9")),
      "key 'rough_sweep.speed_deg_s': is out of any joint's range, found 2e-09, expected 1e-06 "
      "to 1e+08 deg/s; hint: is it in another unit?");
}

TEST(ScenarioFile, TakesAnAngleInOneUnit) {
  const simulate::Scenario s = ingest::manifest::parse_scenario(
      with("q_peak_deg = -22.23187", "q_peak_rad = -0.4"), "s.toml");
  EXPECT_EQ(s.load.q_peak_rad(), -0.4);
  EXPECT_EQ(refusal_without_line(with("q_peak_deg", "q_peak_rad = 1\nq_peak_deg")),
            "key 'load.q_peak_deg': is given as q_peak_rad too, expected one");
  EXPECT_EQ(refusal_without_line(with("q_peak_deg = -22.23187", "")),
            "key 'load.q_peak_rad' is missing; hint: or q_peak_deg");
}

TEST(ScenarioFile, RefusesUnknownKeysAndNothingToDo) {
  EXPECT_EQ(refusal_without_line(with("cycles = 5", "cycle = 5")),
            "key 'oscillation.cycles' is missing; hint: is 'cycle' meant to be it?");
  EXPECT_EQ(refusal_without_line(with("record_bristle", "record_bristles")),
            "unknown key 'oscillation.record_bristles'; hint: did you mean 'record_bristle'?");
  const std::string text = read_file(example("scenario.toml"));
  EXPECT_EQ(refusal(text.substr(0, text.find("[rough_sweep]"))),
            "s.toml: no experiment is stated, expected [rough_sweep], [precise_sweep], "
            "[sine_sweep], [oscillation], [constant_speed] or [break_away]");
}

TEST(ScenarioDescription, IsReadFromBesideTheScenario) {
  for (const char* name : {"scenario.toml", "scenario_noise.toml", "scenario_ripple.toml"}) {
    const simulate::Scenario s = ingest::manifest::read_scenario(example(name));
    EXPECT_EQ(s.robot_description, "am100ib.toml");
    EXPECT_EQ(s.robot_description_text, read_file(example("am100ib.toml")));
  }
}

TEST(ScenarioDescription, IsRefusedWhereItIsMissingWrongOrInTheWay) {
  const std::string key = "\"am100ib.toml\"";
  for (const std::string name : {"dataset.toml", "../arm/dataset.toml", "rough_sweep.csv", "arm"}) {
    const std::string said = refusal_without_line(with(key, fmt::format("\"{}\"", name)));
    EXPECT_EQ(said.find(fmt::format("key 'robot.description': cannot be copied beside the "
                                    "recordings, found '{}'",
                                    name)),
              0U)
        << said;
  }
  const test::TemporaryDirectory directory;
  const std::string path = directory.file("s.toml", with(key, "\"arm.toml\""));
  const auto said = [&] {
    return test::refusal_of<InputError>([&] { return ingest::manifest::read_scenario(path); });
  };
  EXPECT_EQ(said(), directory.path("arm.toml") + ": cannot open: No such file or directory");
  (void)directory.file("arm.toml", "schema = \"tribolog-robot-1\"\n");
  EXPECT_NE(said().find("arm.toml"), std::string::npos);
  EXPECT_NE(said().find("'name' is missing"), std::string::npos) << said();
}

}  // namespace
}  // namespace tribolog::scenario_file_test
