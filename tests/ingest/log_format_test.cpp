#include "ingest/log/log_format.h"

#include <gtest/gtest.h>

namespace tribolog::log_format_test {
namespace {

using namespace std::string_view_literals;

TEST(LogFormat, SignaturesCountMoreThanNames) {
  EXPECT_EQ(ingest::log::detect_log_format("\x89MCAP0\r\n\x01"sv, "a.csv"),
            ingest::log::LogFormat::mcap);
  EXPECT_EQ(ingest::log::detect_log_format("#ROSBAG V2.0\n"sv, "a.csv"),
            ingest::log::LogFormat::rosbag);
  EXPECT_EQ(ingest::log::detect_log_format("SQLite format 3\0abc"sv, "a"),
            ingest::log::LogFormat::sqlite_bag);
  EXPECT_EQ(ingest::log::detect_log_format("\x93NUMPY\1\0"sv, "a.npz"),
            ingest::log::LogFormat::npy);
  EXPECT_EQ(ingest::log::detect_log_format("\x89HDF\r\n\x1a\n"sv, "a.mat"),
            ingest::log::LogFormat::hdf5);
  EXPECT_EQ(ingest::log::detect_log_format("MATLAB 5.0 MAT-file, Platform"sv, "a.json"),
            ingest::log::LogFormat::mat);
  EXPECT_EQ(ingest::log::detect_log_format("MDF     4.10    "sv, "a.dat"),
            ingest::log::LogFormat::mdf);
  EXPECT_EQ(ingest::log::detect_log_format("UnFinMF 4.11    "sv, "a.mf4"),
            ingest::log::LogFormat::mdf);
  EXPECT_EQ(ingest::log::detect_log_format("TDSm\x0e\0\0\0"sv, "a.csv"),
            ingest::log::LogFormat::tdms);
  EXPECT_EQ(ingest::log::detect_log_format("TDSh\x0e\0\0\0"sv, "a.tdms_index"),
            ingest::log::LogFormat::tdms);
  EXPECT_EQ(ingest::log::detect_log_format("PAR1\x15\x04"sv, "a.csv"),
            ingest::log::LogFormat::parquet);
  EXPECT_EQ(ingest::log::detect_log_format("PARE\x15\x04"sv, "a.parquet"),
            ingest::log::LogFormat::parquet);
}

TEST(LogFormat, Matlab73IsNotTakenForPlainHdf5) {
  std::string bytes = "MATLAB 7.3 MAT-file, Platform: GLNXA64";
  bytes.resize(512, ' ');
  EXPECT_EQ(ingest::log::detect_log_format(bytes + "\x89HDF\r\n\x1a\n", "a.h5"),
            ingest::log::LogFormat::mat);
  EXPECT_EQ(ingest::log::detect_log_format(std::string(512, 'x') + "\x89HDF\r\n\x1a\n", "a"),
            ingest::log::LogFormat::hdf5);
}

TEST(LogFormat, Mat5HasAnyTextInFront) {
  const std::string text = "created by something else" + std::string(99, ' ');
  EXPECT_EQ(ingest::log::detect_log_format(text + std::string("\0\1IM", 4), "a"),
            ingest::log::LogFormat::mat);
  EXPECT_EQ(ingest::log::detect_log_format(text + std::string("\1\0MI", 4), "a"),
            ingest::log::LogFormat::mat);
}

TEST(LogFormat, Mat4NeedsItsName) {
  std::string bytes(24, '\0');
  bytes[4] = 9;
  EXPECT_EQ(ingest::log::detect_log_format(bytes, "run.MAT"), ingest::log::LogFormat::mat);
  EXPECT_EQ(ingest::log::detect_log_format(bytes, "run.bin"), ingest::log::LogFormat::text);
  EXPECT_EQ(ingest::log::detect_log_format("t,q,tau\n0,0,0,0,0,0,0,0\n", "run.mat"),
            ingest::log::LogFormat::text);
}

TEST(LogFormat, AZipIsNumpysByItsFirstEntry) {
  const std::string header = "PK\x03\x04" + std::string(22, '\0') + std::string("\x09\0\0\0", 4);
  EXPECT_EQ(ingest::log::detect_log_format(header + "times.npy", "a.zip"),
            ingest::log::LogFormat::npz);
  EXPECT_EQ(ingest::log::detect_log_format(header + "sheet.xml", "a.xlsx"),
            ingest::log::LogFormat::text);
  EXPECT_EQ(ingest::log::detect_log_format(header + "times.txt", "a.npz"),
            ingest::log::LogFormat::npz);
}

TEST(LogFormat, JsonByItsFirstTwoCharacters) {
  EXPECT_EQ(ingest::log::detect_log_format("\xef\xbb\xbf \n{ \"mass\": 1}", "a"),
            ingest::log::LogFormat::json);
  EXPECT_EQ(ingest::log::detect_log_format("[{\"t\": 0}]", "a"), ingest::log::LogFormat::json);
  EXPECT_EQ(ingest::log::detect_log_format("[ 1, 2]", "a.txt"), ingest::log::LogFormat::json);
  EXPECT_EQ(ingest::log::detect_log_format("[s] time, q\n", "a.csv"), ingest::log::LogFormat::text);
  EXPECT_EQ(ingest::log::detect_log_format("not JSON", "a.json"), ingest::log::LogFormat::json)
      << "to say what is wrong";
}

TEST(LogFormat, MetadataOfZarrAreNoLog) {
  EXPECT_EQ(ingest::log::detect_log_format("{\n  \"zarr_format\": 2\n}", ".zgroup"),
            ingest::log::LogFormat::text);
  EXPECT_TRUE(ingest::log::is_zarr_metadata("{\"attributes\": {}, \"zarr_format\": 3}"));
  EXPECT_FALSE(ingest::log::is_zarr_metadata("{\"zarr\": 3}"));
}

TEST(LogFormat, TheRestIsText) {
  EXPECT_EQ(ingest::log::detect_log_format("t,q\n1,2\n", "a.csv"), ingest::log::LogFormat::text);
  EXPECT_EQ(ingest::log::detect_log_format("", "a"), ingest::log::LogFormat::text);
  EXPECT_EQ(ingest::log::detect_log_format("\x1f\x8b", "a.csv.gz"), ingest::log::LogFormat::text);
}

}  // namespace
}  // namespace tribolog::log_format_test
