// A calibration says the same whether it was identified just now or read from its JSON, in every
// language.

#include "tribolog/calibration.h"

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "api/dataset_example.h"
#include "support/run_program.h"

namespace tribolog::test::calibration_test {
namespace {

void expect_same(const Message& a, const Message& b) {
  EXPECT_EQ(a.code, b.code) << a.words;
  EXPECT_EQ(a.words, b.words) << a.code;
}

void expect_same(const std::optional<Estimate>& a, const std::optional<Estimate>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (!a || !b) return;
  EXPECT_EQ(a->value, b->value);
  EXPECT_EQ(a->low, b->low);
  EXPECT_EQ(a->high, b->high);
}

void expect_same(const std::vector<Message>& a, const std::vector<Message>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) expect_same(a[k], b[k]);
}

void expect_same(const Calibration& a, const Calibration& b, const std::string& language) {
  EXPECT_EQ(a.verdict(), b.verdict());
  expect_same(a.sentence(language), b.sentence(language));
  expect_same(a.findings(language), b.findings(language));
  const auto quantities_a = a.quantities(language);
  const auto quantities_b = b.quantities(language);
  ASSERT_EQ(quantities_a.size(), quantities_b.size());
  for (std::size_t k = 0; k < quantities_a.size(); ++k) {
    SCOPED_TRACE(quantities_a[k].name);
    EXPECT_EQ(quantities_a[k].name, quantities_b[k].name);
    EXPECT_EQ(quantities_a[k].words, quantities_b[k].words);
    EXPECT_EQ(quantities_a[k].unit, quantities_b[k].unit);
    EXPECT_EQ(quantities_a[k].verdict, quantities_b[k].verdict);
    EXPECT_EQ(quantities_a[k].decides, quantities_b[k].decides);
    expect_same(quantities_a[k].estimate, quantities_b[k].estimate);
    expect_same(quantities_a[k].at_joint, quantities_b[k].at_joint);
    expect_same(quantities_a[k].reasons, quantities_b[k].reasons);
    expect_same(quantities_a[k].experiment, quantities_b[k].experiment);
  }
  const auto friction_a = a.friction_at_speeds(language);
  const auto friction_b = b.friction_at_speeds(language);
  ASSERT_EQ(friction_a.size(), friction_b.size());
  for (std::size_t k = 0; k < friction_a.size(); ++k) {
    EXPECT_EQ(friction_a[k].speed_rad_s, friction_b[k].speed_rad_s);
    EXPECT_EQ(friction_a[k].speed_at_joint_rad_s, friction_b[k].speed_at_joint_rad_s);
    EXPECT_EQ(friction_a[k].verdict, friction_b[k].verdict);
    expect_same(friction_a[k].torque, friction_b[k].torque);
    expect_same(friction_a[k].torque_at_joint, friction_b[k].torque_at_joint);
    ASSERT_TRUE(friction_a[k].forward && friction_a[k].backward);
    expect_same(friction_a[k].forward, friction_b[k].forward);
    expect_same(friction_a[k].backward, friction_b[k].backward);
    expect_same(friction_a[k].reason, friction_b[k].reason);
  }
  const auto checks_a = a.checks(language);
  const auto checks_b = b.checks(language);
  ASSERT_EQ(checks_a.size(), checks_b.size());
  for (std::size_t k = 0; k < checks_a.size(); ++k) {
    SCOPED_TRACE(checks_a[k].name);
    EXPECT_EQ(checks_a[k].name, checks_b[k].name);
    EXPECT_EQ(checks_a[k].words, checks_b[k].words);
    EXPECT_EQ(checks_a[k].state, checks_b[k].state);
    EXPECT_EQ(checks_a[k].recording, checks_b[k].recording);
    EXPECT_EQ(checks_a[k].measured, checks_b[k].measured);
    EXPECT_EQ(checks_a[k].at_least, checks_b[k].at_least);
    EXPECT_EQ(checks_a[k].at_most, checks_b[k].at_most);
    EXPECT_EQ(checks_a[k].unit, checks_b[k].unit);
    expect_same(checks_a[k].found, checks_b[k].found);
    expect_same(checks_a[k].consequence, checks_b[k].consequence);
    expect_same(checks_a[k].experiment, checks_b[k].experiment);
  }
  const auto stages_a = a.stages(language);
  const auto stages_b = b.stages(language);
  ASSERT_EQ(stages_a.size(), stages_b.size());
  for (std::size_t k = 0; k < stages_a.size(); ++k) {
    EXPECT_EQ(stages_a[k].name, stages_b[k].name);
    EXPECT_EQ(stages_a[k].state, stages_b[k].state) << stages_a[k].name;
    expect_same(stages_a[k].reason, stages_b[k].reason);
  }
  const auto inputs_a = a.inputs(language);
  const auto inputs_b = b.inputs(language);
  ASSERT_EQ(inputs_a.size(), inputs_b.size());
  for (std::size_t k = 0; k < inputs_a.size(); ++k) {
    EXPECT_EQ(inputs_a[k].name, inputs_b[k].name);
    EXPECT_EQ(inputs_a[k].role, inputs_b[k].role);
    EXPECT_EQ(inputs_a[k].bytes, inputs_b[k].bytes);
    EXPECT_EQ(inputs_a[k].sha256, inputs_b[k].sha256);
    EXPECT_EQ(inputs_a[k].rows_read, inputs_b[k].rows_read);
    EXPECT_EQ(inputs_a[k].rows_used, inputs_b[k].rows_used);
    EXPECT_EQ(inputs_a[k].is_recording, inputs_b[k].is_recording) << inputs_a[k].name;
  }
  EXPECT_EQ(a.estimator(), b.estimator());
  EXPECT_EQ(a.joint().robot, b.joint().robot);
  EXPECT_EQ(a.joint().gear_ratio, b.joint().gear_ratio);
}

TEST(ACalibration, IsTheSameFromItsJsonInEveryLanguage) {
  const Calibration found = identified_example();
  const Calibration read = Calibration::from_json(found.to_json());
  EXPECT_EQ(read.to_json(), found.to_json());
  ASSERT_GE(languages().size(), 2U);
  for (const std::string& language : languages()) {
    SCOPED_TRACE(language);
    expect_same(found, read, language);
  }
  EXPECT_NE(read.sentence("pl").words, read.sentence("en").words)
      << "what was read is translated too";
  EXPECT_TRUE(found.has_recordings());
  EXPECT_FALSE(read.has_recordings());
}

TEST(ACalibration, HasWhatTheProgramWrites) {
  const ScratchDirectory scratch;
  const std::string file = scratch.file("calibration.json");
  const ProgramRun run =
      run_shell(std::string("SOURCE_DATE_EPOCH=1700000000 '" TRIBOLOG_PROGRAM "' identify '") +
                example_manifest + "' --truth-runs 0 -o '" + file + "'");
  ASSERT_EQ(run.status, 0) << run.err;
  const Calibration read = Calibration::read(file);
  expect_same(identified_example(), read, "en");
  const std::string copy = scratch.file("copy.json");
  read.write(copy);
  EXPECT_EQ(read_text(copy), read_text(file));
}

TEST(ACalibration, KeepsWordsThatAreNotOfThisVersion) {
  std::string json = identified_example().to_json();
  const Message sentence = Calibration::from_json(json).sentence();
  for (std::size_t at = 0; (at = json.find(sentence.words, at)) != std::string::npos; ++at) {
    json.replace(at, sentence.words.size(), "As it was put last year.");
  }
  const Calibration read = Calibration::from_json(json);
  EXPECT_EQ(read.sentence().words, "As it was put last year.");
  EXPECT_EQ(read.sentence("pl").words, "As it was put last year.");
  EXPECT_EQ(read.sentence().code, sentence.code);
}

TEST(ACalibration, IsNotMisledByCodesThatSayNothing) {
  const std::string json = identified_example().to_json();
  const std::string words = Calibration::from_json(json).sentence().words;
  const std::string key = "\"sentence_code\": ";
  const std::size_t at = json.find(key) + key.size();
  const std::size_t end = json.rfind(',', json.find("\"findings\"", at));
  ASSERT_LT(at, end);
  std::string nested = "null";
  for (int depth = 0; depth < 200; ++depth) {
    nested = R"({"code": "general.together", "values": {"parts": [)" + nested + "]}}";
  }
  for (const std::string& code :
       {std::string(R"({"code": "verdict.known_to_angle", "values": {"degrees": "many"}})"),
        std::string(R"({"code": "verdict.known_to_angle", "values": {"degrees": {}}})"),
        std::string(R"({"code": "verdict.known_to_angle"})"), std::string(R"({"code": 7})"),
        std::string(R"("no.such_code")"), std::string("null"), std::string("[1, 2]"), nested}) {
    std::string other = json;
    other.replace(at, end - at, code);
    const Calibration read = Calibration::from_json(other);
    EXPECT_EQ(read.sentence().words, words) << code;
    EXPECT_EQ(read.sentence("pl").words, words) << code << ": no language is guessed";
    EXPECT_EQ(read.to_json(), other);
  }
}

TEST(Quantities, StandOnBothSidesOfTheGear) {
  const Calibration found = identified_example();
  const double n = found.joint().gear_ratio;
  EXPECT_EQ(n, 101);
  const struct {
    const char* name;
    const char* unit;
    double factor;
  } expected[] = {{"cog_angle", "rad", 1},
                  {"surrogate_mass", "kg", 1},
                  {"gravity_torque", "N·m", n},
                  {"coulomb_torque", "N·m", n},
                  {"viscous_coefficient", "N·m·s/rad", n * n}};
  for (const auto& one : expected) {
    const std::optional<Quantity> quantity = found.quantity(one.name);
    ASSERT_TRUE(quantity && quantity->estimate && quantity->at_joint) << one.name;
    EXPECT_EQ(quantity->unit, one.unit) << one.name;
    const Estimate& motor = *quantity->estimate;
    EXPECT_LE(motor.low, motor.value) << one.name;
    EXPECT_LE(motor.value, motor.high) << one.name;
    EXPECT_NEAR(quantity->at_joint->value, motor.value * one.factor,
                1e-12 * std::abs(quantity->at_joint->value))
        << one.name;
  }
  // What was simulated: examples/ur_like/dataset.toml states a Coulomb torque of 0.131 N·m.
  const Estimate coulomb = *found.quantity("coulomb_torque")->estimate;
  EXPECT_LT(coulomb.low, 0.131);
  EXPECT_GT(coulomb.high, 0.131);
  // Of a sweep alone whose speed changes with the angle, laws with and without a dip disagree.
  EXPECT_LT(coulomb.high - coulomb.low, 0.131 / 2.5);
  EXPECT_FALSE(found.quantity("no_such_quantity"));
}

TEST(Identifying, GivesTheSameBytesForASeedAndOthersForAnother) {
  setenv("SOURCE_DATE_EPOCH", "1700000000", 1);
  const Dataset dataset = Dataset::read(example_manifest);
  IdentifyOptions options;
  options.threads = 1;
  options.truth_runs = 1;
  const std::string once = identify_joint(dataset, options).to_json();
  options.threads = 3;
  EXPECT_EQ(identify_joint(dataset, options).to_json(), once) << "whatever the threads";
  options.seed = 7;
  EXPECT_NE(identify_joint(dataset, options).to_json(), once);
  unsetenv("SOURCE_DATE_EPOCH");
}

TEST(Identifying, TellsItsProgress) {
  IdentifyOptions options;
  std::vector<std::size_t> done;
  options.progress = [&](const std::string& what, std::size_t so_far, std::size_t all) {
    EXPECT_FALSE(what.empty());
    EXPECT_LE(so_far, all);
    done.push_back(so_far);
  };
  identify_joint(Dataset::read(example_manifest), options);
  EXPECT_GT(done.size(), 10U);
  EXPECT_EQ(done.front(), 0U);
}

}  // namespace
}  // namespace tribolog::test::calibration_test
