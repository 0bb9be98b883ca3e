// The Digital Calibration Certificate: its numbers are the calibration's, what is not stated says
// so, and every text from outside leaves it well-formed and valid by PTB's schema.

#include <cmath>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/temporary_directory.h"
#include "exports/export_sample.h"
#include "exports/results/calibration_exports.h"
#include "support/real_logs.h"
#include "support/run_program.h"

namespace tribolog::archive::digital_certificate_test {
namespace {

using exports::results::ArchivedJoint;
using exports::results::digital_certificate;
using nlohmann::json;

constexpr double k_normal = 1.959963984540054;

json part(const char* influence, const char* type, double half_width, double sensitivity,
          const json& percent) {
  return {{"influence", influence},
          {"type", type},
          {"id", nullptr},
          {"stated", percent},
          {"sensitivity", sensitivity},
          {"standard_uncertainty", half_width / k_normal},
          {"degrees_of_freedom", nullptr},
          {"share", 0.1}};
}

json expanded(double value, double low, double high) {
  return {{"estimate", value}, {"low", low}, {"high", high}, {"method", "m"}};
}

/// Coulomb torque 0.31 ± 0.01 N·m from the recordings; 2 % of the torque constant, 1 % of the gear
/// ratio, on which it does not depend at the motor. A limit on each side.
json coulomb_torque() {
  const double half_width = std::hypot(0.01, 0.0062);
  return {
      {"key", "coulomb_torque"},
      {"reasons", json::array()},
      {"budget",
       {{"parts",
         {part("recordings", "A", 0.01, 1, nullptr), part("torque_constant", "B", 0.0062, 1, 2),
          part("gear_ratio", "B", 0, 0, 1)}},
        {"not_included", {"gravity"}},
        {"standard_uncertainty", half_width / k_normal},
        {"degrees_of_freedom", nullptr},
        {"coverage_factor", k_normal},
        {"expanded", expanded(0.31, 0.31 - half_width, 0.31 + half_width)}}},
      {"limits",
       {{{"quantity", "coulomb_joint_Nm"}, {"state", "inside"}, {"words", "keeps 20"}},
        {{"quantity", "coulomb_motor_Nm"}, {"state", "crosses"}, {"words", "may break 0.315"}}}}};
}

/// Bristle stiffness 500 N·m/rad, 480 to 540, from the recordings alone: 12.5 degrees of freedom.
json bristle_stiffness() {
  json of_recordings = part("recordings", "A", 0, 1, nullptr);
  of_recordings["standard_uncertainty"] = 14;
  of_recordings["degrees_of_freedom"] = 12.5;
  return {{"key", "bristle_stiffness"},
          {"reasons", {"the loop is <narrow>", "another"}},
          {"budget",
           {{"parts", {of_recordings}},
            {"not_included", json::array()},
            {"standard_uncertainty", 14},
            {"degrees_of_freedom", 12.5},
            {"coverage_factor", 2.17},
            {"expanded", expanded(500, 480, 540)}}},
          {"limits", json::array()}};
}

/// @param certificate as in the calibration's file; null: of an older program.
ArchivedJoint sample(const json& certificate = nullptr) {
  ArchivedJoint joint = test::export_sample();
  json file = json::parse(joint.calibration);
  file["certificate"] = certificate;
  file["verdict"]["quantities"] = {coulomb_torque(),
                                   bristle_stiffness(),
                                   {{"key", "gravity_torque"}, {"reasons", {"too small a swing"}}}};
  // What is no UTF-8 can be in no file; in an archive's columns it can.
  joint.calibration = file.dump(-1, ' ', false, json::error_handler_t::replace);
  test::quantity_of(joint, "bristle_stiffness").estimate = statistics::Estimate{500, 480, 540, {}};
  test::quantity_of(joint, "bristle_stiffness").verdict = calibration::Verdict::doubtful;
  test::quantity_of(joint, "gravity_torque").verdict = calibration::Verdict::not_identifiable;
  return joint;
}

/// All that a manifest can state, each text as given.
json whole_certificate(const std::string& text) {
  json all;
  for (const char* const key : {"number", "replaces", "laboratory", "laboratory_address",
                                "customer", "customer_address", "place", "received_on", "procedure",
                                "conditions", "adjustment", "decision_rule", "responsible"}) {
    all[key] = text.empty() ? key + std::string(" of it") : text;
  }
  all["country"] = "PL";
  all["humidity_percent"] = 45.5;
  all["instruments"] = {{{"name", text.empty() ? "torque sensor" : text},
                         {"identification", text.empty() ? "T-17" : text},
                         {"traceability", text.empty() ? "D-K-15195-01-00, 2026-03" : text},
                         {"used_for", text.empty() ? "torque" : text}}};
  return all;
}

/// From one mark to the next.
std::string between(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t start = text.find(from);
  if (start == std::string::npos) return "";
  const std::size_t begin = start + from.size();
  const std::size_t end = text.find(to, begin);
  return end == std::string::npos ? "" : text.substr(begin, end - begin);
}

std::string leaf(const std::string& text, const std::string& element) {
  return between(text, "<" + element + ">", "</" + element + ">");
}

double number(const std::string& text, const std::string& element) {
  const std::string digits = leaf(text, element);
  return digits.empty() ? std::nan("") : std::stod(digits);
}

std::string result(const std::string& document, const std::string& quantity) {
  return between(document, "<dcc:result refType=\"tribolog_" + quantity + "\">", "</dcc:result>");
}

std::string at(const std::string& side, const std::string& document, const std::string& quantity) {
  return between(result(document, quantity), "refType=\"tribolog_" + side + "Side",
                 "</dcc:quantity>");
}

TEST(DigitalCertificate, HasTheExpandedUncertaintyOfEachSide) {
  const std::string document = digital_certificate(sample());
  const std::string motor = at("motor", document, "coulomb_torque");
  EXPECT_EQ(number(motor, "si:value"), 0.31);
  EXPECT_EQ(leaf(motor, "si:unit"), R"(\newton\metre)");
  EXPECT_NEAR(number(motor, "si:uncertainty"), std::hypot(0.01, 0.0062), 1e-15);
  EXPECT_EQ(number(motor, "si:coverageFactor"), k_normal);
  EXPECT_EQ(leaf(motor, "si:coverageProbability"), "0.95");
  EXPECT_EQ(leaf(motor, "si:distribution"), "normal");
  EXPECT_EQ(motor.find("coverageInterval"), std::string::npos);
  // At the joint the gear ratio's percent counts.
  const std::string joint = at("joint", document, "coulomb_torque");
  EXPECT_EQ(number(joint, "si:value"), 15.5);
  EXPECT_NEAR(number(joint, "si:uncertainty"), 50 * std::hypot(0.01, 0.0062, 0.0031), 1e-12);
  EXPECT_EQ(number(joint, "si:coverageFactor"), k_normal);
  EXPECT_NE(joint.find("Not stated and not included: "), std::string::npos) << joint;
}

TEST(DigitalCertificate, SaysAmperesWhereTheTorqueConstantIsNotKnown) {
  ArchivedJoint of_current = sample();
  for (calibration::Quantity& q : of_current.quantities) q.unit = joint::in_amperes(q.unit);
  const std::string document = digital_certificate(of_current);
  const auto unit = [&](const std::string& quantity) {
    return leaf(at("motor", document, quantity), "si:unit");
  };
  EXPECT_EQ(unit("coulomb_torque"), R"(\ampere)");
  EXPECT_EQ(unit("bristle_stiffness"), R"(\ampere\per\radian)");
  EXPECT_EQ(unit("viscous_coefficient"), R"(\ampere\second\per\radian)");
  EXPECT_EQ(unit("inertia"), R"(\ampere\second\tothe{2}\per\radian)");
  EXPECT_EQ(document.find("newton\\"), std::string::npos) << "the curve's";
  EXPECT_NE(document.find("<si:unitXMLList>\\ampere<"), std::string::npos);
  EXPECT_NE(document.find("The torque constant is not stated"), std::string::npos);
}

TEST(DigitalCertificate, HasBothEndsOfAnIntervalThatIsNotSymmetric) {
  const std::string document = digital_certificate(sample());
  const std::string motor = at("motor", document, "bristle_stiffness");
  EXPECT_EQ(motor.find("expandedUnc"), std::string::npos);
  EXPECT_EQ(number(motor, "si:value"), 500);
  EXPECT_EQ(number(motor, "si:standardUnc"), 14);
  EXPECT_EQ(number(motor, "si:intervalMin"), 480);
  EXPECT_EQ(number(motor, "si:intervalMax"), 540);
  EXPECT_EQ(leaf(motor, "si:unit"), R"(\newton\metre\per\radian)");
  const std::string joint = at("joint", document, "bristle_stiffness");
  EXPECT_NEAR(number(joint, "si:standardUnc"), 14 * 2500., 1e-9);
  EXPECT_NEAR(number(joint, "si:intervalMin"), 480 * 2500., 1e-6);
  EXPECT_NEAR(number(joint, "si:intervalMax"), 540 * 2500., 1e-6);
  // Of a file without a budget: what the archive has, and no factor is made up.
  const std::string viscous = at("motor", document, "viscous_coefficient");
  EXPECT_NEAR(number(viscous, "si:intervalMax"), 0.0021, 1e-15);
  EXPECT_NEAR(number(viscous, "si:standardUnc"), 0.0001 / k_normal, 1e-15);
  EXPECT_EQ(viscous.find("coverageFactor"), std::string::npos);
  EXPECT_NE(viscous.find("No budget is recorded"), std::string::npos);
}

// A factor that does not lead from the standard uncertainty to the interval is not stated as one.
TEST(DigitalCertificate, StatesNoFactorThatDoesNotBelong) {
  ArchivedJoint joint = sample();
  json file = json::parse(joint.calibration);
  json& budget = file["verdict"]["quantities"][0]["budget"];
  for (const double factor : {0.5, 2.5, 1e300}) {
    budget["coverage_factor"] = factor;
    joint.calibration = file.dump();
    const std::string motor = at("motor", digital_certificate(joint), "coulomb_torque");
    EXPECT_EQ(motor.find("coverageFactor"), std::string::npos) << factor;
    EXPECT_NEAR(number(motor, "si:intervalMax"), 0.31 + std::hypot(0.01, 0.0062), 1e-12);
  }
}

// No interval is no exact number.
TEST(DigitalCertificate, StatesNoUncertaintyWhereThereIsNone) {
  ArchivedJoint joint = sample();
  test::quantity_of(joint, "viscous_coefficient").estimate =
      statistics::Estimate{0.002, 0.002, 0.002, {}};
  const std::string motor = at("motor", digital_certificate(joint), "viscous_coefficient");
  EXPECT_EQ(number(motor, "si:value"), 0.002);
  EXPECT_EQ(motor.find("si:coverage"), std::string::npos) << motor;
  EXPECT_NE(motor.find("Its uncertainty is not stated."), std::string::npos);
}

TEST(DigitalCertificate, HasOneSideWhereTheGearMakesNoDifference) {
  ArchivedJoint joint = sample();
  joint.entry.facts.gear_ratio = 1;
  const std::string document = digital_certificate(joint);
  EXPECT_NE(at("motor", document, "coulomb_torque"), "");
  EXPECT_EQ(at("joint", document, "coulomb_torque"), "");
  EXPECT_NE(at("motor", document, "coulomb_torque").find("keeps 20"), std::string::npos);
  // Of the joint alone, whatever the gear.
  EXPECT_EQ(number(at("joint", document, "cog_angle"), "si:value"), -0.4);
  EXPECT_EQ(at("motor", document, "surrogate_mass"), "");
}

TEST(DigitalCertificate, SaysWhatIsDoubtfulAndGivesNoNumberThatWasNotIdentified) {
  const std::string document = digital_certificate(sample());
  for (const char* const side : {"motor", "joint"}) {
    const std::string doubtful = at(side, document, "bristle_stiffness");
    EXPECT_NE(doubtful.find("Doubtful: the loop is &lt;narrow&gt;."), std::string::npos)
        << doubtful;
    EXPECT_EQ(doubtful.find("another"), std::string::npos);
  }
  const std::string none = result(document, "gravity_torque");
  EXPECT_NE(none.find("not identifiable: too small a swing"), std::string::npos) << none;
  EXPECT_EQ(none.find("si:"), std::string::npos) << none;
}

std::vector<double> list_of(const std::string& text, const std::string& element) {
  std::istringstream numbers(leaf(text, element));
  return {std::istream_iterator<double>(numbers), {}};
}

/// The list of one side; its first quantity is the speed, its second the torque.
std::string curve_at(const std::string& side, const std::string& document) {
  return between(result(document, "viscous_curve"), "<dcc:list refType=\"tribolog_" + side + "Side",
                 "</dcc:list>");
}

/// Half widths of the runs' torques, and, if asked for, of the gravity that was subtracted.
ArchivedJoint with_curve_uncertainty(bool has_gravity) {
  ArchivedJoint joint = sample();
  json file = json::parse(joint.calibration);
  for (std::size_t k = 0; k < 5; ++k) {
    file["viscous"]["runs"][k]["torque_half_width_Nm"] = 0.001 * static_cast<double>(k + 1);
    file["viscous"]["runs"][k]["mean_cos"] = 0.5;
  }
  file["surrogate_masses"] = json::array();
  if (has_gravity) {
    file["surrogate_masses"].push_back(
        {{"estimator", "midline"}, {"gravity_Nm", {{"low", 3.82}, {"high", 3.94}}}});
  }
  joint.calibration = file.dump();
  return joint;
}

TEST(DigitalCertificate, HasTheFrictionCurveWithItsUncertainties) {
  const std::string document = digital_certificate(with_curve_uncertainty(false));
  const std::string motor = curve_at("motor", document);
  const std::size_t torque = motor.find("tribolog_frictionTorque");
  ASSERT_NE(torque, std::string::npos) << motor;
  EXPECT_EQ(list_of(motor.substr(0, torque), "si:valueXMLList"),
            (std::vector<double>{-100.01, -10, 10, 99.99, 200}));
  EXPECT_EQ(leaf(motor.substr(0, torque), "si:unitXMLList"), R"(\radian\per\second)");
  const std::string torques = motor.substr(torque);
  EXPECT_EQ(list_of(torques, "si:valueXMLList"),
            (std::vector<double>{-0.52, -0.34, 0.32, 0.50, 0.70}));
  EXPECT_EQ(leaf(torques, "si:unitXMLList"), R"(\newton\metre)");
  // The torque constant's 2 % are of each point's own torque.
  const std::vector<double> expanded = list_of(torques, "si:uncertaintyXMLList");
  ASSERT_EQ(expanded.size(), 5U);
  EXPECT_NEAR(expanded[0], std::hypot(0.001, 0.02 * 0.52), 1e-12);
  EXPECT_NEAR(expanded[4], std::hypot(0.005, 0.02 * 0.70), 1e-12);
  EXPECT_EQ(number(torques, "si:coverageFactorXMLList"), k_normal);
  EXPECT_NE(motor.find("gravity torque is not included"), std::string::npos);

  // At the joint the gear ratio's percent counts.
  const std::string joint = curve_at("joint", document);
  const std::string joint_torques = joint.substr(joint.find("tribolog_frictionTorque"));
  EXPECT_NEAR(list_of(joint, "si:valueXMLList")[4], 4, 1e-12);
  EXPECT_NEAR(list_of(joint_torques, "si:valueXMLList")[4], 35, 1e-12);
  EXPECT_NEAR(list_of(joint_torques, "si:uncertaintyXMLList")[4],
              50 * std::hypot(0.005, 0.02 * 0.70, 0.01 * 0.70), 1e-10);
}

TEST(DigitalCertificate, HasTheErrorOfGravityInTheCurveWhereItIsRecorded) {
  const std::string motor = curve_at("motor", digital_certificate(with_curve_uncertainty(true)));
  for (const double expanded : list_of(motor, "si:uncertaintyXMLList")) EXPECT_GT(expanded, 0.03);
  EXPECT_NEAR(list_of(motor, "si:uncertaintyXMLList")[2], std::hypot(0.003, 0.03, 0.02 * 0.32),
              1e-12);
  EXPECT_NE(motor.find("gravity torque is included"), std::string::npos);
}

TEST(DigitalCertificate, StatesNoUncertaintyOfACurveThatIsNotRecordedWhole) {
  ArchivedJoint joint = with_curve_uncertainty(false);
  json file = json::parse(joint.calibration);
  file["viscous"]["runs"][3]["torque_half_width_Nm"] = nullptr;
  joint.calibration = file.dump();
  const std::string motor = curve_at("motor", digital_certificate(joint));
  EXPECT_EQ(motor.find("Unc"), std::string::npos) << motor;
  EXPECT_NE(motor.find("Its uncertainty is not stated."), std::string::npos);
  test::quantity_of(joint, "viscous_curve").verdict = calibration::Verdict::not_identifiable;
  EXPECT_EQ(curve_at("motor", digital_certificate(joint)), "");
  file.erase("viscous");
  joint.calibration = file.dump();
  test::quantity_of(joint, "viscous_curve").verdict = calibration::Verdict::usable;
  EXPECT_NE(digital_certificate(joint).find("No friction curve is recorded."), std::string::npos);
}

TEST(DigitalCertificate, SaysWhichLimitsArePassed) {
  ArchivedJoint joint = sample();
  const auto conformity = [&](const char* side) {
    return leaf(at(side, digital_certificate(joint), "coulomb_torque"), "dcc:conformity");
  };
  EXPECT_EQ(conformity("joint"), "pass");
  EXPECT_EQ(conformity("motor"), "noPass");
  test::quantity_of(joint, "coulomb_torque").verdict = calibration::Verdict::doubtful;
  EXPECT_EQ(conformity("joint"), "noPass") << "a doubtful number passes nothing";
}

TEST(DigitalCertificate, HasWhatTheManifestStates) {
  ArchivedJoint joint = sample(whole_certificate(""));
  joint.entry.facts.measured_on = "2026-11-21T23:30:05-03:30";
  joint.entry.facts.temperature_C = 21.5;
  const std::string document = digital_certificate(joint);
  for (const char* const line : {"<dcc:countryCodeISO3166_1>PL<",
                                 "<dcc:uniqueIdentifier>number of it<",
                                 "<dcc:beginPerformanceDate>2026-11-21<",
                                 "<dcc:endPerformanceDate>2026-11-21<",
                                 "<dcc:content>laboratory of it<",
                                 "<dcc:content>laboratory_address of it<",
                                 "<dcc:content>customer of it<",
                                 "<dcc:content>customer_address of it<",
                                 "<dcc:content>place of it<",
                                 "<dcc:content>received_on of it<",
                                 "<dcc:content>procedure of it<",
                                 "<dcc:content>conditions of it<",
                                 "<dcc:content>adjustment of it<",
                                 "<dcc:content>decision_rule of it<",
                                 "<dcc:content>responsible of it<",
                                 "<dcc:referralID>replaces of it<",
                                 "<dcc:content>torque sensor<",
                                 "<dcc:value>T-17<",
                                 "<dcc:content>torque<",
                                 "<dcc:referralID>D-K-15195-01-00, 2026-03<",
                                 "<si:value>45.5<",
                                 "<si:value>21.5<"}) {
    EXPECT_NE(document.find(line), std::string::npos) << line;
  }
  EXPECT_EQ(document.find("0001-01-01"), std::string::npos);
  EXPECT_EQ(document.find("ZZ"), std::string::npos);
  EXPECT_EQ(document.find("dcc:receiptDate"), std::string::npos) << "these words are no day";
}

TEST(DigitalCertificate, SaysWhatIsNotStated) {
  ArchivedJoint joint = sample();
  joint.entry.facts.measured_on = "in autumn";
  joint.entry.facts.of.serial.clear();
  joint.entry.facts.temperature_C.reset();
  const std::string document = digital_certificate(joint);
  const auto element = [&](const char* name) {
    return between(document, "<dcc:" + std::string(name) + ">", "</dcc:" + std::string(name) + ">");
  };
  EXPECT_EQ(element("uniqueIdentifier"), "tribolog-aaaaaaaaaaaa");
  EXPECT_EQ(element("countryCodeISO3166_1"), "ZZ");
  EXPECT_EQ(element("beginPerformanceDate"), "0001-01-01");
  EXPECT_EQ(element("endPerformanceDate"), "0001-01-01");
  for (const char* const who :
       {"calibrationLaboratory", "customer", "respPersons", "manufacturer"}) {
    EXPECT_NE(element(who).find("<dcc:content lang=\"en\">not stated<"), std::string::npos) << who;
  }
  EXPECT_NE(element("items").find("<dcc:value>not stated<"), std::string::npos);
  EXPECT_NE(element("influenceConditions").find("not stated"), std::string::npos);
  EXPECT_NE(element("statements").find("traceability: not stated"), std::string::npos);
  EXPECT_NE(element("statements").find("<dcc:content>in autumn<"), std::string::npos);
  EXPECT_EQ(document.find("dcc:measuringEquipment"), std::string::npos);
}

// A day alone is a day: neither one that there is not, nor one by an offset.
TEST(DigitalCertificate, TakesADayForADayAlone) {
  ArchivedJoint joint = sample();
  for (const auto& [stated, day] : {std::pair{"2026-01-31", "2026-01-31"},
                                    {"2026-01-31 14:05", "2026-01-31"},
                                    {"2026-02-30", "0001-01-01"},
                                    {"0000-01-01", "0001-01-01"},
                                    {"2026-01-31 to 2026-02-02", "0001-01-01"},
                                    {"", "0001-01-01"}}) {
    joint.entry.facts.measured_on = stated;
    EXPECT_EQ(leaf(digital_certificate(joint), "dcc:beginPerformanceDate"), day) << stated;
  }
}

TEST(DigitalCertificate, IsRefusedWithoutTheFileThatStatesIt) {
  ArchivedJoint joint = sample();
  joint.calibration.clear();
  EXPECT_NE(test::refusal_of<UsageError>([&] {
              return digital_certificate(joint);
            }).find("its calibration's file is not archived"),
            std::string::npos);
}

/// Every text from outside tries to leave its place.
ArchivedJoint hostile() {
  ArchivedJoint joint = test::hostile_export_sample();
  const std::string text = joint.entry.facts.of.robot + joint.entry.facts.of.joint +
                           "</dcc:content>\r\n<![CDATA[\x7f\xef\xbf\xbe" + std::string(1, '\0');
  json certificate = whole_certificate(text);
  certificate["country"] = "P<";
  joint.calibration = sample(certificate).calibration;
  calibration::Facts& f = joint.entry.facts;
  for (std::string* const one :
       {&f.of.robot, &f.of.serial, &f.of.joint, &f.measured_on, &f.operator_name, &f.note,
        &f.payload, &f.sentence, &f.tool_version, &f.git_revision, &f.created_utc}) {
    *one = text;
  }
  joint.quantities.push_back(
      {text, text, text, calibration::Verdict::usable, statistics::symmetric_estimate(1, 0.1)});
  joint.quantities.push_back(joint.quantities.front());
  return joint;
}

std::string schema_refusal(const std::string& document, const std::string& schema) {
  const test::TemporaryDirectory directory;
  const std::string file = directory.file("a.xml", document);
  const auto run =
      test::run_shell("xmllint --noout --nonet --schema '" + schema + "' '" + file + "'");
  return run.status == 0 ? "" : run.err.substr(0, 2000);
}

TEST(DigitalCertificate, IsValidByItsSchema) {
  TRIBOLOG_NEEDS_REAL_LOG("dcc/dcc.xsd");
  if (test::run_shell("xmllint --version").status != 0) {
    GTEST_SKIP() << "xmllint (libxml2-utils) is not installed";
  }
  const std::string schema = test::real_log("dcc/dcc.xsd").value();
  ArchivedJoint stated = sample(whole_certificate(""));
  stated.entry.facts.measured_on = "2026-11-21";
  ArchivedJoint received = sample({{"received_on", "2026-11-20"}, {"place", "customerBranch"}});
  ArchivedJoint bare = sample();
  bare.quantities.clear();
  bare.entry.facts = {};
  for (const ArchivedJoint& joint :
       {stated, received, sample(), with_curve_uncertainty(false), with_curve_uncertainty(true),
        test::export_sample(), bare, hostile()}) {
    const std::string document = digital_certificate(joint);
    EXPECT_EQ(schema_refusal(document, schema), "") << document;
  }
  // That it would find what is wrong.
  std::string wrong = digital_certificate(stated);
  wrong.replace(wrong.find("<dcc:beginPerformanceDate>2026"), 30, "<dcc:beginPerformanceDate>soon");
  EXPECT_NE(schema_refusal(wrong, schema), "");
}

}  // namespace
}  // namespace tribolog::archive::digital_certificate_test
