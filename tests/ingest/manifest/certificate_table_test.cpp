// The [certificate] table of a manifest.

#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/temporary_directory.h"
#include "ingest/manifest/manifest_file.h"

namespace tribolog::certificate_table_test {
namespace {

const std::string before = R"(schema = "tribolog-dataset-1"
[robot]
name = "R"
)";
const std::string joint = R"([joint]
name = "J"
gear_ratio = 100
)";
const std::string behind = R"([effort]
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

joint::Certificate certificate(const std::string& table) {
  return ingest::manifest::parse_manifest(before + joint + behind + table, "m.toml")
      .manifest.certificate;
}

std::string refusal(const std::string& lines) {
  return test::refusal_of<InputError>([&] { return certificate("[certificate]\n" + lines); });
}

const std::string whole = R"([certificate]
number = "K-17"
replaces = "K-16"
laboratory = "Lab & Co"
laboratory_address = "Street 1"
country = "PL"
customer = "Customer"
customer_address = "Road 2"
place = "hall 3"
received_on = 2026-11-20
procedure = "P 4"
conditions = "warmed up"
humidity_percent = 45.5
adjustment = "none"
decision_rule = "simple"
responsible = "N. N."
[[certificate.instrument]]
name = "torque sensor"
identification = "T-17"
traceability = "D-K-15195-01-00, 2026-03"
used_for = "torque"
[[certificate.instrument]]
name = "clock"
)";

const joint::Certificate read{
    "K-17",
    "K-16",
    "Lab & Co",
    "Street 1",
    "PL",
    "Customer",
    "Road 2",
    "hall 3",
    "2026-11-20",
    "P 4",
    "warmed up",
    45.5,
    "none",
    "simple",
    "N. N.",
    {{"torque sensor", "T-17", "D-K-15195-01-00, 2026-03", "torque"}, {"clock", "", "", ""}}};

TEST(CertificateTable, IsReadWhole) { EXPECT_EQ(certificate(whole), read); }

TEST(CertificateTable, IsNotNeededNorIsAnyOfItsKeys) {
  EXPECT_EQ(certificate(""), joint::Certificate{});
  EXPECT_EQ(certificate("[certificate]\n"), joint::Certificate{});
  EXPECT_EQ(certificate("[certificate]\nhumidity_percent = 0\n").humidity_percent, 0);
  EXPECT_EQ(certificate("[certificate]\nreceived_on = \"in March\"\n").received_on, "in March");
}

TEST(CertificateTable, IsSharedByTheJointsOfARobot) {
  const std::string text = before + behind + whole +
                           "[[joints]]\nname = \"J1\"\ngear_ratio = 100\n"
                           "[[joints]]\nname = \"J2\"\ngear_ratio = 50\n";
  for (const char* const name : {"J1", "J2"}) {
    EXPECT_EQ(ingest::manifest::parse_manifest(text, "m.toml", name).manifest.certificate, read);
  }
}

TEST(CertificateTable, IsRefusedWithPlaceAndReason) {
  const std::string place = "m.toml:18:";
  for (const auto& [lines, words] : {
           std::pair{"laboratry = \"x\"\n", "laboratory"},
           {"number = 17\n", "certificate.number"},
           {"humidity_percent = 100.5\n", "100.5"},
           {"humidity_percent = -1\n", "certificate.humidity_percent"},
           {"humidity_percent = \"45\"\n", "certificate.humidity_percent"},
           {"country = \"Poland\"\n", "ISO 3166-1"},
           {"country = \"pl\"\n", "'pl'"},
           {"received_on = \"2026-13-45\"\n", "is no time that there is"},
           {"received_on = 08:30:05\n", "certificate.received_on"},
           {"instrument = \"sensor\"\n", "certificate.instrument"},
       }) {
    const std::string said = refusal(lines);
    EXPECT_NE(said.find(place), std::string::npos) << lines << said;
    EXPECT_NE(said.find(words), std::string::npos) << lines << said;
  }
  EXPECT_NE(refusal("[[certificate.instrument]]\nused_for = \"x\"\n").find("name"),
            std::string::npos);
  EXPECT_NE(refusal("[[certificate.instrument]]\nname = \" \"\n").find("is empty"),
            std::string::npos);
  EXPECT_NE(refusal("[[certificate.instrument]]\nname = \"x\"\nserial = \"y\"\n").find("serial"),
            std::string::npos);
}

}  // namespace
}  // namespace tribolog::certificate_table_test
