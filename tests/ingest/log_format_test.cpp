#include "ingest/log/log_format.h"

#include <gtest/gtest.h>

namespace tribolog {
namespace {

using namespace std::string_view_literals;

TEST(LogFormat, SignaturesCountMoreThanNames) {
  EXPECT_EQ(detect_log_format("\x89MCAP0\r\n\x01"sv, "a.csv"), LogFormat::mcap);
  EXPECT_EQ(detect_log_format("SQLite format 3\0abc"sv, "a"), LogFormat::sqlite_bag);
  EXPECT_EQ(detect_log_format("\x93NUMPY\1\0"sv, "a.npz"), LogFormat::npy);
  EXPECT_EQ(detect_log_format("\x89HDF\r\n\x1a\n"sv, "a.mat"), LogFormat::hdf5);
  EXPECT_EQ(detect_log_format("MATLAB 5.0 MAT-file, Platform"sv, "a.json"), LogFormat::mat);
}

TEST(LogFormat, Matlab73IsNotTakenForPlainHdf5) {
  std::string bytes = "MATLAB 7.3 MAT-file, Platform: GLNXA64";
  bytes.resize(512, ' ');
  EXPECT_EQ(detect_log_format(bytes + "\x89HDF\r\n\x1a\n", "a.h5"), LogFormat::mat);
  EXPECT_EQ(detect_log_format(std::string(512, 'x') + "\x89HDF\r\n\x1a\n", "a"), LogFormat::hdf5);
}

TEST(LogFormat, Mat5HasAnyTextInFront) {
  const std::string text = "created by something else" + std::string(99, ' ');
  EXPECT_EQ(detect_log_format(text + std::string("\0\1IM", 4), "a"), LogFormat::mat);
  EXPECT_EQ(detect_log_format(text + std::string("\1\0MI", 4), "a"), LogFormat::mat);
}

TEST(LogFormat, Mat4NeedsItsName) {
  std::string bytes(24, '\0');
  bytes[4] = 9;
  EXPECT_EQ(detect_log_format(bytes, "run.MAT"), LogFormat::mat);
  EXPECT_EQ(detect_log_format(bytes, "run.bin"), LogFormat::text);
  EXPECT_EQ(detect_log_format("t,q,tau\n0,0,0,0,0,0,0,0\n", "run.mat"), LogFormat::text);
}

TEST(LogFormat, AZipIsNumpysByItsFirstEntry) {
  const std::string header = "PK\x03\x04" + std::string(22, '\0') + std::string("\x09\0\0\0", 4);
  EXPECT_EQ(detect_log_format(header + "times.npy", "a.zip"), LogFormat::npz);
  EXPECT_EQ(detect_log_format(header + "sheet.xml", "a.xlsx"), LogFormat::text);
  EXPECT_EQ(detect_log_format(header + "times.txt", "a.npz"), LogFormat::npz);
}

TEST(LogFormat, JsonByItsFirstTwoCharacters) {
  EXPECT_EQ(detect_log_format("\xef\xbb\xbf \n{ \"mass\": 1}", "a"), LogFormat::json);
  EXPECT_EQ(detect_log_format("[{\"t\": 0}]", "a"), LogFormat::json);
  EXPECT_EQ(detect_log_format("[ 1, 2]", "a.txt"), LogFormat::json);
  EXPECT_EQ(detect_log_format("[s] time, q\n", "a.csv"), LogFormat::text);
  EXPECT_EQ(detect_log_format("not JSON", "a.json"), LogFormat::json) << "to say what is wrong";
}

TEST(LogFormat, TheRestIsText) {
  EXPECT_EQ(detect_log_format("t,q\n1,2\n", "a.csv"), LogFormat::text);
  EXPECT_EQ(detect_log_format("", "a"), LogFormat::text);
  EXPECT_EQ(detect_log_format("\x1f\x8b", "a.csv.gz"), LogFormat::text);
}

}  // namespace
}  // namespace tribolog
