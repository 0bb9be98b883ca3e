// What an archive takes, wherever it is kept: any text in UTF-8, every bit of a number, many
// writers.

#include <limits>
#include <random>
#include <thread>

#include "archive/archive_place.h"
#include "archive/sample_calibration.h"
#include "base/error.h"

namespace tribolog::archive::archive_limits_test {
namespace {

using test::AnyArchive;
using test::sample_calibration;

const std::string now = "2026-12-24T12:00:00Z";

/// Of characters that no compression makes shorter.
std::string noise_text(std::size_t characters) {
  std::mt19937 random(7);
  std::string text;
  for (std::size_t k = 0; k < characters; ++k) text += static_cast<char>('!' + random() % 90);
  return text;
}

TEST_P(AnyArchive, HostileTextsAreText) {
  calibration::NewCalibration hostile = test::sample_calibration(1, 2, 3, 0.45);
  hostile.facts.of.robot = "'; DROP TABLE calibration; --";
  hostile.facts.of.serial = "../../x\xe2\x80\xae\\x41%s$1";
  hostile.facts.of.joint = noise_text(10000);
  hostile.facts.note = "\xf0\x9f\xa4\x96";
  hostile.quantities[1].name = noise_text(9000);
  hostile.inputs[1].name = noise_text(11000);
  hostile.documents.push_back({calibration::DocumentKind::input, hostile.inputs[1].name, "a log"});
  store::CalibrationArchive archive = open();
  const store::Added added = archive.add(hostile, false, now);
  const calibration::Entry entry = archive.find(added.id);
  EXPECT_EQ(entry.facts.of, hostile.facts.of);
  EXPECT_EQ(entry.facts.note, hostile.facts.note);
  EXPECT_EQ(archive.document(entry, calibration::DocumentKind::input, hostile.inputs[1].name),
            "a log");
  store::Filter filter;
  filter.robot = hostile.facts.of.robot;
  filter.joint = hostile.facts.of.joint;
  EXPECT_EQ(archive.list(filter).size(), 1U);
  EXPECT_TRUE(faults().empty());
}

TEST_P(AnyArchive, TakesNoTextThatOneOfBothWouldNotKeep) {
  store::CalibrationArchive archive = open();
  for (const std::string& text : {std::string("\xff"), std::string("J\xc3"), std::string("a\0b", 3),
                                  std::string("\xed\xa0\x80")}) {
    calibration::NewCalibration wrong = test::sample_calibration(1, 2, 3, 0.45);
    wrong.facts.of.joint = text;
    EXPECT_THROW(archive.add(wrong, false, now), UsageError);
    wrong = test::sample_calibration(1, 2, 3, 0.45);
    wrong.inputs[0].name = text;
    EXPECT_THROW(archive.add(wrong, false, now), UsageError);
    store::Filter filter;
    filter.serial = text;
    EXPECT_THROW((void)archive.list(filter), UsageError);
  }
  EXPECT_EQ(archive.verify("", {}).events, 0U);
}

TEST_P(AnyArchive, GivesBackEveryBit) {
  using Limits = std::numeric_limits<double>;
  calibration::NewCalibration given = test::sample_calibration(1, 2, 3, 0.45);
  given.quantities.clear();
  for (const double value : {1.0 / 3, 0.1, -0.1, 5.0, 0.0, -0.0, Limits::max(), Limits::lowest(),
                             Limits::min(), Limits::denorm_min(), 1e15 + 0.3, 9007199254740993.0}) {
    given.quantities.push_back({fmt::format("q{}", given.quantities.size()), "", "N·m",
                                calibration::Verdict::usable,
                                statistics::Estimate{value, value, value, {}}});
  }
  given.inputs[0].bytes = 9007199254740993;  // no double has it
  std::string bytes;
  for (int k = 0; k < 4 * 256; ++k) bytes += static_cast<char>(k * 37);
  given.documents.push_back({calibration::DocumentKind::input, "log.bin", bytes});
  store::CalibrationArchive archive = open();
  const calibration::Entry entry = archive.find(archive.add(given, false, now).id);
  const auto quantities = archive.quantities(entry);
  ASSERT_EQ(quantities.size(), given.quantities.size());
  for (std::size_t k = 0; k < quantities.size(); ++k) {
    EXPECT_EQ(quantities[k].estimate->value, given.quantities[k].estimate->value);
    EXPECT_EQ(quantities[k].unit, "N·m");
  }
  EXPECT_EQ(archive.inputs(entry)[0].bytes, 9007199254740993U);
  EXPECT_EQ(archive.document(entry, calibration::DocumentKind::input, "log.bin"), bytes);
  EXPECT_TRUE(faults().empty());
}

TEST_P(AnyArchive, ManyAtOnceMakeOneArchiveAndLoseNothing) {
  constexpr int writers = 4;
  constexpr int each = 8;
  std::vector<std::thread> threads;
  for (int writer = 0; writer < writers; ++writer) {
    threads.emplace_back([&, writer] {
      store::CalibrationArchive archive =
          store::open_archive(place_->location(), sql::Access::write, 60000);
      for (int k = 0; k < each; ++k) {
        EXPECT_TRUE(archive.add(test::sample_calibration(writer, k, 3, 0.45), false, now).is_new);
        (void)archive.add(test::sample_calibration(99, k, 3, 0.45), false, now);  // all of them do
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  const store::Verification outcome = open(sql::Access::read).verify("", {});
  EXPECT_TRUE(outcome.faults.empty());
  EXPECT_EQ(outcome.entries, static_cast<std::size_t>((writers + 1) * each));
  EXPECT_EQ(outcome.events, outcome.entries);
}

}  // namespace
}  // namespace tribolog::archive::archive_limits_test
