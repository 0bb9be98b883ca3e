// Whatever happens to a file, the program answers with a result or with one clear line: no crash,
// no hang, no exception of another kind. Run under sanitizers this means what it says.

#include <random>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/temporary_directory.h"
#include "ingest/dataset/recording_rows.h"
#include "ingest/manifest/manifest_file.h"
#include "ingest/manifest/scenario_file.h"
#include "ingest/text/csv_reader.h"

namespace tribolog::damaged_files_test {
namespace {

const std::string log_text =
    "\xef\xbb\xbf# log\r\n\"t [s]\", q [rad],tau (Nm)\r\n0,+1.5,nan\r\n\r\n0.01,1e-3,\"-2.5\"\r\n"
    "0.02,.5,1e400\r\n0.03,,\"a\"\"b\"\r\n0.04,1.,-0\r\n";

const std::string manifest_text = R"(schema = "tribolog-dataset-1"
[robot]
name = "R°"
[joint]
name = 'J'
gear_ratio = 1e2
[effort]
kind = "motor_torque"
side = "motor"
sign = -1
[columns]
time = {name = "t", unit = "s"}
angle = {name = "q", unit = "rad", side = "motor"}
effort = {name = "tau", unit = "N·m"}
[reference.waiboer]
asperity_torque_Nm = 1
stribeck_speed_rad_s = 1
stribeck_power = 1
viscous_coefficient = 0
viscous_power = 0
[[recording]]
role = "oscillation"
file = "a.csv"
from_s = 5
)";

/// False for a refusal of more than one line; an exception of another kind ends the test.
template <class Read>
bool is_read_or_refused(const Read& read, const std::string& bytes) {
  try {
    (void)read(bytes);
  } catch (const Error& error) {
    const std::string said = error.what();
    return error.status() == ExitStatus::input_refused && said.find('\n') == std::string::npos;
  }
  return true;
}

ingest::log::LogTable read_log(const std::string& bytes) {
  return ingest::text::read_csv(bytes, "run.csv", {{"t"}, {"q"}, {"tau"}});
}

ingest::manifest::ManifestFile read_manifest(const std::string& bytes) {
  return ingest::manifest::parse_manifest(bytes, "m.toml");
}

template <class Read>
void expect_every_prefix_answered(const Read& read, const std::string& text) {
  for (std::size_t n = 0; n <= text.size(); ++n) {
    ASSERT_TRUE(is_read_or_refused(read, text.substr(0, n))) << "first " << n << " bytes";
  }
}

template <class Read>
void expect_every_byte_change_answered(const Read& read, const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    for (int byte = 0; byte < 256; ++byte) {
      std::string changed = text;
      changed[i] = static_cast<char>(byte);
      ASSERT_TRUE(is_read_or_refused(read, changed)) << "byte " << byte << " at " << i;
    }
  }
}

TEST(DamagedLog, EveryPrefixIsAnswered) { expect_every_prefix_answered(read_log, log_text); }

TEST(DamagedLog, EveryChangedByteIsAnswered) {
  expect_every_byte_change_answered(read_log, log_text);
}

TEST(DamagedManifest, EveryPrefixIsAnswered) {
  expect_every_prefix_answered(read_manifest, manifest_text);
}

TEST(DamagedManifest, EveryChangedByteIsAnswered) {
  expect_every_byte_change_answered(read_manifest, manifest_text);
}

TEST(DamagedLog, RandomPiecesAreAnswered) {
  const std::vector<std::string> pieces = {"t",   "q",    "tau", ",",  ";",    "\t",   " ", "\n",
                                           "\r",  "\"",   "#",   "1",  ".5",   "-",    "e", "nan",
                                           "[s]", "(Nm)", "9e",  "\0", "\xff", "1e999"};
  std::mt19937 random(1);
  for (int i = 0; i < 20'000; ++i) {
    std::string text = i % 2 == 0 ? "t,q,tau\n" : "";
    for (unsigned n = random() % 40; n > 0; --n) text += pieces[random() % pieces.size()];
    ASSERT_TRUE(is_read_or_refused(read_log, text)) << printable(text, 1000);
  }
}

TEST(DamagedLog, EndlessLinesAreAnswered) {
  const std::string endless(5'000'000, 'x');
  EXPECT_TRUE(is_read_or_refused(read_log, endless));
  EXPECT_TRUE(is_read_or_refused(read_log, "t,q,tau\n" + endless));
  EXPECT_TRUE(is_read_or_refused(read_log, "t,q,tau\n0,0,\"" + endless));
  EXPECT_TRUE(is_read_or_refused(read_log, std::string(5'000'000, ',')));
  EXPECT_TRUE(is_read_or_refused(read_log, "t,q,tau\n" + std::string(5'000'000, ',')));
  EXPECT_TRUE(is_read_or_refused(read_log, "t q tau\n" + std::string(5'000'000, '1')));
}

TEST(DamagedScenario, EveryCutIsAnswered) {
  const auto read = [](const std::string& bytes) {
    return ingest::manifest::parse_scenario(bytes, "s.toml");
  };
  expect_every_prefix_answered(read,
                               "schema = \"tribolog-scenario-1\"\nname = \"x\"\n"
                               "[robot]\nname = \"r\"\n[joint]\nname = \"3\"\ngear_ratio = 1\n");
}

}  // namespace
}  // namespace tribolog::damaged_files_test
