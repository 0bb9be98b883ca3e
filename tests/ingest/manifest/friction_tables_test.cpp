#include <gtest/gtest.h>

#include "base/input_file.h"
#include "base/temporary_directory.h"
#include "friction/catalogue.h"
#include "ingest/manifest/scenario_tables.h"

namespace tribolog::friction_tables_test {
namespace {

const std::string contact_table = R"([friction.presliding]
bristle_stiffness_Nm_rad = 465.42
bristle_damping_Nms_rad = 0.7708
viscous_Nms_rad = 0.001
coulomb_Nm = 0.6
static_Nm = 0.88437633
stribeck_speed_rad_s = 5
)";
const friction::ContactParameters contact{465.42, 0.7708, 0.001, 0.6, 0.88437633, 5.0};
const std::string sliding_table = "[friction.sliding]\nmodel = \"dynamic\"\n";

ingest::manifest::JointFriction read(const std::string& text) {
  return ingest::manifest::read_friction(
      ingest::manifest::TomlTable::parse(text, "f.toml").table("friction"));
}

/// `[friction] model` in line 1 and 2, then whatever the test wants, then the sliding.
std::string chosen(const std::string& model, const std::string& tables) {
  return "[friction]\nmodel = \"" + model + "\"\n" + tables + sliding_table;
}

std::string refusal(const std::string& text) {
  return test::refusal_of<InputError>([&] { read(text); });
}

friction::ParameterValue value_of(const friction::FrictionModel& model, const std::string& key) {
  for (const friction::NamedParameter& one : model.named_parameters()) {
    if (one.key == key) return one.value;
  }
  throw std::logic_error("no parameter " + key);
}

TEST(FrictionTables, LuGreUnlessAnotherIsNamed) {
  const ingest::manifest::JointFriction f = read(contact_table + sliding_table);
  EXPECT_EQ(f.presliding->name(), "lugre");
  EXPECT_EQ(std::get<double>(value_of(*f.presliding, "bristle_stiffness_Nm_rad")), 465.42);
  EXPECT_FALSE(f.sliding) << "the dynamic model slides";
}

TEST(FrictionTables, EveryModelIsMatchedToTheContact) {
  for (const friction::FrictionModelEntry& one : friction::dynamic_friction_models()) {
    const ingest::manifest::JointFriction f = read(chosen(one.name, contact_table));
    EXPECT_EQ(f.presliding->name(), one.name);
    EXPECT_EQ(f.presliding->named_parameters(), one.matched_parameters(contact)) << one.name;
  }
}

TEST(FrictionTables, OwnParametersReplaceMatchedOnesKeyByKey) {
  for (const friction::FrictionModelEntry& one : friction::dynamic_friction_models()) {
    friction::NamedParameters expected = one.matched_parameters(contact);
    for (friction::NamedParameter& parameter : expected) {
      if (parameter.key != "viscous_Nms_rad") continue;
      parameter.value = 0.0625;
    }
    const ingest::manifest::JointFriction f = read(chosen(
        one.name, contact_table + "[friction." + one.name + "]\nviscous_Nms_rad = 0.0625\n"));
    EXPECT_EQ(f.presliding->named_parameters(), expected) << one.name;
  }
  const auto gms = read(chosen("gms", contact_table + R"([friction.gms]
attraction_Nm_s = 50
elements = [
  {stiffness_Nm_rad = 300, share = 0.25},
  {stiffness_Nm_rad = 100, share = 0.75},
]
)"))
                       .presliding;
  EXPECT_EQ(std::get<double>(value_of(*gms, "attraction_Nm_s")), 50);
  EXPECT_EQ(std::get<std::vector<friction::MaxwellElement>>(value_of(*gms, "elements")),
            (std::vector<friction::MaxwellElement>{{300, 0.25}, {100, 0.75}}));
  const auto bonds = read(chosen("haessig_bristles",
                                 contact_table + "[friction.haessig_bristles]\nbristles = 20\n"))
                         .presliding;
  EXPECT_EQ(std::get<std::uint64_t>(value_of(*bonds, "bristles")), 20U);
}

TEST(FrictionTables, TheDocumentedExampleIsRead) {
  const std::string page = read_file(std::string(TRIBOLOG_SOURCE_DIR) + "/docs/simulation.md");
  const std::size_t from = page.find("[friction]");
  const ingest::manifest::JointFriction f = read(page.substr(from, page.find("```", from) - from));
  EXPECT_EQ(f.presliding->name(), "gms");
  EXPECT_EQ(std::get<double>(value_of(*f.presliding, "attraction_Nm_s")), 150);
  EXPECT_FALSE(f.sliding);
}

TEST(FrictionTables, AllOwnParametersNeedNoContact) {
  const std::string dahl = "[friction.dahl]\nstiffness_Nm_rad = 400\ncoulomb_Nm = 0.5\n";
  const auto model = read(chosen("dahl", dahl + "viscous_Nms_rad = 0\n")).presliding;
  EXPECT_EQ(std::get<double>(value_of(*model, "stiffness_Nm_rad")), 400);
  EXPECT_EQ(std::get<double>(value_of(*model, "exponent")), 1) << "the usual value";
  EXPECT_EQ(refusal(chosen("dahl", dahl)),
            "f.toml:3:1: key 'friction.dahl.viscous_Nms_rad' is missing; hint: "
            "[friction.presliding] would give a value to match");
  EXPECT_EQ(refusal(chosen("dahl", "")),
            "f.toml:1:1: key 'friction.presliding' is missing; hint: the contact's six numbers, or "
            "[friction.dahl] with all of its own");
  EXPECT_EQ(refusal(chosen("gms", "[friction.gms]\ncoulomb_Nm = 1\n")),
            "f.toml:3:1: key 'friction.gms.elements' is missing, expected one or more "
            "{stiffness_Nm_rad = ..., share = ...}; hint: [friction.presliding] would give a value "
            "to match");
}

TEST(FrictionTables, StaticLawsSlide) {
  const auto sliding = [](const std::string& table) {
    return read(contact_table + "[friction.sliding]\n" + table).sliding;
  };
  const auto stribeck = sliding(
      "model = \"stribeck\"\ncoulomb_Nm = 1\nstatic_Nm = 1.5\nstribeck_speed_rad_s = 0.1\n"
      "viscous_Nms_rad = 0.4\n");
  EXPECT_EQ(stribeck->name(), "stribeck");
  EXPECT_NEAR(stribeck->torque_Nm(-10), -5, 1e-12);
  const auto threshold = sliding(
      "model = \"threshold_speed\"\ncoulomb_Nm = 1\nstatic_Nm = 1.5\nstribeck_decay_s_rad = 20\n"
      "viscous_Nms_rad = 0.4\nthreshold_rad_s = 0.001\n");
  EXPECT_EQ(threshold->name(), "threshold_speed");
  EXPECT_NEAR(threshold->torque_Nm(-10), -5, 1e-12);
}

// In lines: 1 [friction], 2 model, 3 to 9 the contact, 10 the model's own table.
TEST(FrictionTables, RefusalsQuoteTheRuleAtTheKeyAtFault) {
  const auto own = [](const std::string& model, const std::string& keys) {
    return refusal(chosen(model, contact_table + "[friction." + model + "]\n" + keys));
  };
  EXPECT_EQ(
      own("dahl", "viscous_Nms_rad = 0.01\nexponent = -1\ncoulomb_Nm = 0.5\n"),
      "f.toml:12:12: key 'friction.dahl.exponent': Dahl's exponent −1 is not allowed; it must "
      "be >= 0");
  EXPECT_EQ(own("gms", "attraction_Nm_s = 0\n"),
            "f.toml:11:19: key 'friction.gms.attraction_Nm_s': attraction 0 N·m/s is not allowed; "
            "it must be > 0");
  EXPECT_EQ(own("gms", "attraction_Nm_s = 3\nelements = [{stiffness_Nm_rad = 1, share = 0.5}]\n"),
            "f.toml:12:12: key 'friction.gms.elements': shares of the elements add up to 0.5; they "
            "must add up to 1");
  EXPECT_EQ(own("gms", "elements = [{stiffness_Nm_rad = 1, share = 1, mass = 2}]\n"),
            "f.toml:11:54: unknown key 'friction.gms.elements.mass'; hint: known here: 'share', "
            "'stiffness_Nm_rad'");
  EXPECT_EQ(own("gms", "elements = 3\n"),
            "f.toml:11:12: key 'friction.gms.elements': wrong type, found 3, expected an array of "
            "tables; hint: write [[friction.gms.elements]]");
  EXPECT_EQ(own("leuven", "elements = []\n"),
            "f.toml:11:12: key 'friction.leuven.elements' is empty, expected one or more "
            "{stiffness_Nm_rad = ..., share = ...}; hint: each with stiffness_Nm_rad > 0 and share "
            "> 0; shares add up to 1");
  EXPECT_EQ(own("leuven", "static_Nm = 2\ncoulomb_Nm = 3\n"),
            "f.toml:12:14: key 'friction.leuven.coulomb_Nm': Coulomb torque 3 N·m exceeds static "
            "torque 2 N·m; it must not be larger");
  EXPECT_EQ(own("leuven", "static_Nm = 0.5\n"),
            "f.toml:11:13: key 'friction.leuven.static_Nm': Coulomb torque 0.6 N·m exceeds static "
            "torque 0.5 N·m; it must not be larger");
  EXPECT_EQ(own("bliman_sorine", "way_ratio = 1\nfast_torque_Nm = 3\n"),
            "f.toml:11:13: key 'friction.bliman_sorine.way_ratio': ratio of the distance constants "
            "1 is not allowed; it must be < 1");
  EXPECT_EQ(own("haessig_bristles", "bristles = 0\n"),
            "f.toml:11:12: key 'friction.haessig_bristles.bristles': number of bristles 0 is not "
            "allowed; it must be from 1 to 100000");
  EXPECT_EQ(own("haessig_bristles", "bristles = 2.5\n"),
            "f.toml:11:12: key 'friction.haessig_bristles.bristles': not usable, found 2.5, "
            "expected a whole number >= 0");
  EXPECT_EQ(own("lugre", "bristle_stiffness_Nm_rad = nan\n"),
            "f.toml:11:28: key 'friction.lugre.bristle_stiffness_Nm_rad': not usable, found nan, "
            "expected a finite number");
  const std::string deflection =
      own("elasto_plastic", "bristle_stiffness_Nm_rad = 600\nbreak_away_deflection_rad = 0.01\n");
  EXPECT_EQ(deflection.substr(0, deflection.find("must be <")),
            "f.toml:12:29: key 'friction.elasto_plastic.break_away_deflection_rad': break-away "
            "deflection 0.01 rad is not allowed; it ");
}

TEST(FrictionTables, RefusesKeysOfOthers) {
  EXPECT_EQ(refusal(chosen("gms", contact_table + "[friction.gms]\nattraction_Nms = 3\n")),
            "f.toml:11:18: unknown key 'friction.gms.attraction_Nms'; hint: did you mean "
            "'attraction_Nm_s'?");
  EXPECT_EQ(refusal(chosen("gms", contact_table + "[friction.dahl]\nexponent = 1\n")),
            "f.toml:10:1: key 'friction.dahl': is of a model that is not chosen, expected "
            "[friction.gms]; hint: model = \"dahl\" in [friction] would choose it");
  EXPECT_EQ(refusal(chosen("gms", contact_table + "[friction.leuve]\n")),
            "f.toml:10:1: unknown key 'friction.leuve'; hint: did you mean 'leuven'?");
  EXPECT_EQ(
      refusal(chosen("gms", contact_table + "model = \"gms\"\n")),
      "f.toml:10:9: key 'friction.presliding.model': is stated one table up, expected model = "
      "\"gms\" in [friction]");
  EXPECT_EQ(refusal(contact_table + sliding_table + "static_Nm = 1\n"),
            "f.toml:10:13: unknown key 'friction.sliding.static_Nm'; hint: known here: "
            "'model'");
  EXPECT_EQ(refusal(contact_table + "[friction.sliding]\nmodel = \"lugre\"\n"),
            "f.toml:9:9: key 'friction.sliding.model': not known, found 'lugre', expected one of "
            "'stribeck', 'threshold_speed', 'waiboer', 'dynamic'");
  EXPECT_EQ(refusal(contact_table),
            "f.toml:1:1: key 'friction.sliding' is missing; hint: [friction.sliding] with model = "
            "\"dynamic\" for sweeps and runs by the dynamic model, or a static law");
}

}  // namespace
}  // namespace tribolog::friction_tables_test
