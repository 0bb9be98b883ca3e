// What reviewers decided, wherever the archive is kept.

#include "archive/archive_place.h"
#include "archive/sample_calibration.h"
#include "base/encodings.h"
#include "base/error.h"

namespace tribolog::archive::reviews_test {
namespace {

using test::AnyArchive;
using test::sample_calibration;

const std::string now = "2026-12-24T12:00:00Z";
const std::string later = "2027-01-08T08:30:00Z";

calibration::Entry reviewed_entry(store::CalibrationArchive& archive) {
  const store::Added added = archive.add(test::sample_calibration(1, 2, 3, 0.45), false, now);
  const calibration::Entry entry = archive.find(added.id);
  archive.add_review(
      entry, {now, "A. 'Reviewer\"", calibration::Review::Decision::rejected, "too warm\nagain"});
  archive.add_review(entry, {later, "B", calibration::Review::Decision::approved, {}});
  return entry;
}

TEST_P(AnyArchive, KeepsEveryDecisionInItsOrder) {
  store::CalibrationArchive archive = open();
  const calibration::Entry entry = reviewed_entry(archive);
  const auto reviews = archive.reviews(entry);
  ASSERT_EQ(reviews.size(), 2U);
  EXPECT_EQ(reviews[0].reviewer, "A. 'Reviewer\"");
  EXPECT_EQ(reviews[0].decision, calibration::Review::Decision::rejected);
  EXPECT_EQ(reviews[0].note, "too warm\nagain");
  EXPECT_EQ(reviews[1].decision, calibration::Review::Decision::approved);
  EXPECT_EQ(reviews[1].at_utc, later);
  EXPECT_EQ(archive.find(entry.id).digest, entry.digest) << "the calibration is what it was";
  EXPECT_TRUE(faults().empty());
  const store::Added other = archive.add(test::sample_calibration(1, 2, 4, 0.45), false, now);
  EXPECT_TRUE(archive.reviews(archive.find(other.id)).empty());
}

TEST_P(AnyArchive, FindsAlteredLostAndForgedDecisions) {
  store::CalibrationArchive archive = open();
  const calibration::Entry entry = reviewed_entry(archive);
  const std::vector<std::string> wrong{entry.id.substr(0, calibration::shown_digits) +
                                       ": its reviews are not those that were given"};
  place_->run("UPDATE review SET decision = 'approved' WHERE place = 0", false);
  EXPECT_EQ(faults(), wrong);
  place_->run("UPDATE review SET decision = 'rejected' WHERE place = 0", false);
  EXPECT_TRUE(faults().empty());
  place_->run("DELETE FROM review WHERE place = 1", false);
  EXPECT_EQ(faults(), wrong);
  place_->run(
      "INSERT INTO review SELECT calibration, 1, '" + later + "', 'B', 'approved', '' FROM review",
      false);
  EXPECT_TRUE(faults().empty()) << "the same again";
  place_->run("INSERT INTO review SELECT calibration, 2, '" + later +
                  "', 'C', 'approved', '' FROM review WHERE place = 1",
              false);
  EXPECT_EQ(faults(), wrong);
}

TEST_P(AnyArchive, DecisionsGoWithTheirCalibration) {
  store::CalibrationArchive archive = open();
  const calibration::Entry entry = reviewed_entry(archive);
  archive.remove(entry, later);
  EXPECT_TRUE(faults().empty());
  archive.add(test::sample_calibration(1, 2, 3, 0.45), false, later);
  EXPECT_TRUE(archive.reviews(archive.find(entry.id)).empty());
  EXPECT_TRUE(faults().empty());
}

TEST_P(AnyArchive, FindsAReportByItsFingerprint) {
  store::CalibrationArchive archive = open();
  const store::Added added = archive.add(test::sample_calibration(1, 2, 3, 0.45), false, now);
  archive.attach_report(added.id, "<html>a</html>", now);
  ASSERT_TRUE(archive.find_report(sha256_hex("<html>a</html>")));
  EXPECT_EQ(archive.find_report(sha256_hex("<html>a</html>"))->id, added.id);
  EXPECT_FALSE(archive.find_report(sha256_hex("<html>b</html>")));
  EXPECT_FALSE(
      archive.find_report(sha256_hex(test::sample_calibration(1, 2, 3, 0.45).documents[0].bytes)))
      << "of a calibration, which is no report";
}

TEST_P(AnyArchive, RefusesTextsOfDecisionsThatItCannotKeep) {
  store::CalibrationArchive archive = open();
  const calibration::Entry entry = reviewed_entry(archive);
  EXPECT_THROW(archive.add_review(entry, {now, std::string("a\0b", 3), {}, ""}), UsageError);
  EXPECT_THROW(archive.add_review(entry, {now, "a", {}, "\xff"}), UsageError);
  EXPECT_EQ(archive.reviews(entry).size(), 2U);
  EXPECT_TRUE(faults().empty());
}

}  // namespace
}  // namespace tribolog::archive::reviews_test
