// What holds of an archive wherever it is kept.

#include "archive/store/calibration_archive.h"

#include "archive/archive_place.h"
#include "archive/sample_calibration.h"
#include "base/error.h"

namespace tribolog::archive::calibration_archive_test {
namespace {

using test::AnyArchive;
using test::sample_calibration;

const std::string now = "2026-12-24T12:00:00Z";

TEST_P(AnyArchive, GivesBackWhatWasAdded) {
  const calibration::NewCalibration given = test::sample_calibration(1, 2, 3, 0.45);
  const store::Added added = open().add(given, false, now);
  EXPECT_TRUE(added.is_new);
  store::CalibrationArchive again = open(sql::Access::read);
  const calibration::Entry entry = again.find(added.id.substr(0, calibration::shown_digits));
  EXPECT_EQ(entry.facts.of, given.facts.of);
  EXPECT_EQ(entry.facts.measured_at, "2026-01-04T10:00:00Z");
  EXPECT_EQ(entry.facts.temperature_C, 25.0);
  EXPECT_EQ(entry.facts.payload_kg, std::nullopt);
  const auto quantities = again.quantities(entry);
  ASSERT_EQ(quantities.size(), 2U);
  EXPECT_EQ(quantities[0].name, "coulomb_torque");
  EXPECT_EQ(quantities[0].estimate->value, 0.45);
  EXPECT_EQ(quantities[0].estimate->high, 0.46);
  EXPECT_FALSE(quantities[1].estimate);
  EXPECT_EQ(again.inputs(entry).size(), 2U);
  EXPECT_EQ(again.document(entry, calibration::DocumentKind::calibration),
            given.documents.front().bytes);
  EXPECT_EQ(again.document(entry, calibration::DocumentKind::report), std::nullopt);
  EXPECT_TRUE(faults().empty());
}

TEST_P(AnyArchive, JointsOfARobotAreKeptTogetherOrNotAtAll) {
  store::CalibrationArchive archive = open();
  std::vector<calibration::NewCalibration> joints{sample_calibration(1, 1, 1, 0.4),
                                                  sample_calibration(1, 2, 1, 0.5)};
  const std::vector<store::Added> added = archive.add(joints, false, now);
  ASSERT_EQ(added.size(), 2U);
  EXPECT_NE(added[0].id, added[1].id);
  EXPECT_EQ(archive.list({}).size(), 2U);
  joints = {sample_calibration(2, 1, 1, 0.4), sample_calibration(2, 2, 1, 0.5)};
  joints[1].facts.of.joint = std::string("\0", 1);  // no archive keeps it
  EXPECT_THROW((void)archive.add(joints, false, now), UsageError);
  EXPECT_EQ(archive.list({}).size(), 2U);
  EXPECT_TRUE(faults().empty());
}

TEST_P(AnyArchive, TheSameInputsAreOneEntry) {
  store::CalibrationArchive archive = open();
  calibration::NewCalibration one = test::sample_calibration(1, 2, 3, 0.45);
  const store::Added first = archive.add(one, false, now);
  one.facts.tool_version = "9.9";
  const store::Added second = archive.add(one, false, now);
  EXPECT_FALSE(second.is_new);
  EXPECT_EQ(second.id, first.id);
  EXPECT_EQ(second.tool_version, "0.1.0");
  EXPECT_EQ(archive.list({}).size(), 1U);
  const store::Added third = archive.add(one, true, now);
  EXPECT_TRUE(third.is_new);
  EXPECT_NE(third.id, first.id);
  EXPECT_EQ(archive.list({}).size(), 2U);
  store::Filter latest;
  latest.latest_revisions = true;
  ASSERT_EQ(archive.list(latest).size(), 1U);
  EXPECT_EQ(archive.list(latest).front().id, third.id);
  one.facts.configuration = "Resamples: 500\n";
  EXPECT_FALSE(archive.add(one, false, now).is_new) << "of the same recordings";
  std::swap(one.inputs.front(), one.inputs.back());
  EXPECT_FALSE(archive.add(one, false, now).is_new) << "in another order";
  one.inputs.front().sha256 = test::sample_calibration(1, 2, 4, 0.45).inputs.front().sha256;
  EXPECT_TRUE(archive.add(one, false, now).is_new);
}

TEST_P(AnyArchive, KeepsTheFirstReport) {
  store::CalibrationArchive archive = open();
  const store::Added added = archive.add(test::sample_calibration(1, 2, 3, 0.45), false, now);
  const std::string html = "<html>" + std::string(100000, 'x') + "</html>";
  EXPECT_TRUE(archive.attach_report(added.id, html, now));
  EXPECT_FALSE(archive.attach_report(added.id, "<html>other</html>", now));
  const calibration::Entry entry = archive.find(added.id);
  EXPECT_EQ(archive.document(entry, calibration::DocumentKind::report), html);
  EXPECT_LT(archive.documents(entry)[1].stored_bytes, 200U);
  EXPECT_TRUE(faults().empty());
}

TEST_P(AnyArchive, ListsByJointAndTime) {
  store::CalibrationArchive archive = open();
  for (const int day : {9, 3, 30}) {
    for (const int joint : {2, 1}) {
      archive.add(test::sample_calibration(1, joint, day, 0.45), false, now);
      archive.add(test::sample_calibration(2, joint, day, 0.45), false, now);
    }
  }
  store::Filter filter;
  filter.robot = "R1";
  filter.joint = "J2";
  const auto measured = archive.measured(filter);
  ASSERT_EQ(measured.size(), 3U);
  EXPECT_EQ(measured[0].entry.facts.measured_on, "2026-01-04");
  EXPECT_EQ(measured[2].entry.facts.measured_on, "2026-02-03");
  for (const calibration::Measured& one : measured) {
    EXPECT_EQ(one.entry.facts.of.joint, "J2");
    ASSERT_EQ(one.quantities.size(), 2U);
    EXPECT_EQ(one.quantities[0].estimate->value, 0.45);
  }
  EXPECT_EQ(archive.list({}).size(), 12U);
}

TEST_P(AnyArchive, FindsByEnoughDigits) {
  store::CalibrationArchive archive = open();
  const store::Added added = archive.add(test::sample_calibration(1, 2, 3, 0.45), false, now);
  EXPECT_EQ(archive.find(added.id.substr(0, 4)).id, added.id);
  EXPECT_THROW((void)archive.find(added.id.substr(0, 3)), UsageError);
  EXPECT_THROW((void)archive.find("%"), UsageError);
  EXPECT_THROW((void)archive.find("0000000000"), UsageError);
}

TEST_P(AnyArchive, VerifyFindsEveryAlteration) {
  std::string id;
  std::string head;
  const auto fill = [&] {
    store::CalibrationArchive archive = open();
    id = archive.add(test::sample_calibration(1, 2, 3, 0.45), false, now).id;
    archive.add(test::sample_calibration(1, 2, 4, 0.46), false, now);
    archive.attach_report(id, "<html></html>", now);
    head = archive.verify("", {}).head;
  };
  fill();
  EXPECT_TRUE(faults(head).empty());
  EXPECT_FALSE(faults(std::string(64, '0')).empty());
  for (const char* const statement :
       {"UPDATE quantity SET value = value * 1.001, high = high * 1.1 WHERE place = 0",
        "UPDATE calibration SET temperature_C = 26 WHERE number = 1",
        "UPDATE calibration SET robot = 'R7' WHERE number = 2",
        "DELETE FROM quantity WHERE calibration = 2 AND place = 1",
        "DELETE FROM calibration WHERE number = 1", "DELETE FROM calibration WHERE number = 2",
        "DELETE FROM event WHERE number = 2",
        "UPDATE event SET at_utc = '2020-01-01T00:00:00Z' WHERE number = 1",
        "UPDATE content SET zstd = (SELECT zstd FROM content WHERE document = 2) "
        "WHERE document = 1",
        "DELETE FROM document WHERE kind = 'report'", "DELETE FROM content WHERE document = 2",
        "UPDATE input SET bytes = bytes + 1", "DELETE FROM document"}) {
    for (const bool cascades : {false, true}) {
      place_->start_again();
      fill();
      place_->run(statement, cascades);
      EXPECT_FALSE(faults().empty()) << statement;
    }
  }
  // Cut off at its end, the chain alone is whole: the head that was written down tells. (SQLite
  // counts documents, too.)
  place_->start_again();
  fill();
  place_->run("DELETE FROM event WHERE number = 3; DELETE FROM document WHERE kind = 'report'",
              true);
  if (store::is_server(place_->location())) {
    EXPECT_TRUE(faults().empty());
  }
  EXPECT_FALSE(faults(head).empty());
}

TEST_P(AnyArchive, RemovesAndRemembersThatItDid) {
  store::CalibrationArchive archive = open();
  const store::Added added = archive.add(test::sample_calibration(1, 2, 3, 0.45), false, now);
  archive.remove(archive.find(added.id), now);
  EXPECT_TRUE(archive.list({}).empty());
  const store::Verification outcome = archive.verify("", {});
  EXPECT_TRUE(outcome.faults.empty());
  EXPECT_EQ(outcome.events, 2U);
  EXPECT_TRUE(archive.add(test::sample_calibration(1, 2, 3, 0.45), false, now).is_new);
}

TEST_P(AnyArchive, AReaderSeesOneState) {
  open().add(test::sample_calibration(1, 2, 3, 0.45), false, now);
  std::size_t removed = 0;
  const store::Verification outcome =
      open(sql::Access::read).verify("", [&](std::size_t, std::size_t) {
        try {
          store::CalibrationArchive other = open();
          for (const calibration::Entry& entry : other.list({})) {
            other.remove(entry, now);
            ++removed;
          }
        } catch (const ArchiveError&) {
          // An SQLite file's writer waits for its readers.
        }
      });
  EXPECT_TRUE(outcome.faults.empty());
  EXPECT_EQ(outcome.entries, 1U);
  EXPECT_EQ(open(sql::Access::read).list({}).size(), 1U - removed);
}

TEST_P(AnyArchive, IsAskedForWhereThereIsNone) {
  EXPECT_THROW((void)open(sql::Access::read), InputError);
}

TEST_P(AnyArchive, ImpossibleNumbersAreRefusedAndNothingIsKept) {
  calibration::NewCalibration wrong = test::sample_calibration(1, 2, 3, 0.45);
  wrong.quantities[0].estimate->low = 0.5;
  store::CalibrationArchive archive = open();
  EXPECT_ANY_THROW(archive.add(wrong, false, now));
  EXPECT_TRUE(archive.list({}).empty());
  EXPECT_EQ(archive.verify("", {}).events, 0U);
}

}  // namespace
}  // namespace tribolog::archive::calibration_archive_test
