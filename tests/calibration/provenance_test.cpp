#include "calibration/provenance.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace tribolog::provenance_test {
namespace {

TEST(CreationTime, FollowsSourceDateEpoch) {
  EXPECT_EQ(calibration::creation_time_utc("0"), "1970-01-01T00:00:00Z");
  EXPECT_EQ(calibration::creation_time_utc("1767225600"), "2026-01-01T00:00:00Z");
  EXPECT_EQ(calibration::creation_time_utc("253402300799"), "9999-12-31T23:59:59Z");
}

TEST(CreationTime, RefusesWhatIsNoTime) {
  for (const char* wrong :
       {"-1", "yesterday", "12x", " 12", "1.5", "253402300800", "99999999999999999999"}) {
    EXPECT_THROW(calibration::creation_time_utc(wrong), UsageError) << wrong;
  }
}

TEST(CreationTime, IsTheClockWithoutIt) {
  EXPECT_GT(calibration::creation_time_utc(nullptr), "2020-01-01T00:00:00Z");
  EXPECT_EQ(calibration::creation_time_utc("").size(), std::string("2020-01-01T00:00:00Z").size());
}

TEST(CommandLine, TellsNothingAboutTheMachine) {
  EXPECT_EQ(calibration::command_line_text({"tribolog", "report", "/home/someone/logs/m.toml",
                                            "--output=/tmp/r.html", "data/x.csv", "~/y/"}),
            "tribolog report m.toml --output=r.html data/x.csv y");
}

TEST(CommandLine, QuotesWhatAShellWouldSplit) {
  for (const char* const server :
       {"postgresql://u:secret@host/db", "--archive=postgres://u:secret@host/db"}) {
    EXPECT_EQ(calibration::command_line_text({"tribolog", server}).find("secret"),
              std::string::npos);
    EXPECT_NE(calibration::command_line_text({"tribolog", server}).find("://..."),
              std::string::npos);
  }
  EXPECT_EQ(calibration::command_line_text({"tribolog", "a b", "it's", ""}),
            "tribolog 'a b' 'it'\\''s' ''");
}

TEST(Provenance, NamesTheProgramWithoutItsDirectory) {
  const calibration::Provenance p = calibration::make_provenance({"/opt/bin/tribolog", "report"});
  EXPECT_EQ(p.command_line, "tribolog report");
  EXPECT_FALSE(p.tool_version.empty());
  EXPECT_FALSE(p.compiler.empty());
  EXPECT_FALSE(p.git_revision.empty());
}

}  // namespace
}  // namespace tribolog::provenance_test
