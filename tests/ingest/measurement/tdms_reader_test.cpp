// TDMS from bytes made here: what npTDMS does not write, and what is refused.

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/temporary_directory.h"
#include "ingest/measurement/measured_bytes.h"
#include "ingest/measurement/measurement_readers.h"
#include "wording/words.h"

namespace tribolog::tdms_reader_test {
namespace {

using namespace test::measured;
using namespace std::string_literals;
using Names = std::vector<std::string>;
using Values = std::vector<double>;

constexpr std::uint32_t new_metadata = 2 | 4 | 8;
constexpr std::uint32_t raw_alone = 8;
constexpr std::uint32_t interleaved = 32;
constexpr std::uint32_t in_big_endian = 64;
constexpr std::uint32_t int8 = 1;
constexpr std::uint32_t int16 = 2;
constexpr std::uint32_t text = 0x20;

std::vector<ingest::log::LogTable> read(const std::string& bytes) {
  return ingest::measurement::parse_tdms(bytes, "a.tdms");
}
std::string refusal_of(const std::string& bytes) {
  return test::refusal_of<InputError>([&] { return read(bytes); });
}
Names notes_of(const std::vector<ingest::log::LogTable>& tables) {
  return wording::words(tables.front().notes);
}

const std::string q = "/'g'/'q'";
const std::string tau = "/'g'/'tau'";

/// Two channels of one byte, two values each in a chunk: q first.
std::string two_channels(const std::string& raw_data, std::uint32_t contents = new_metadata) {
  return tdms_segment(contents,
                      {tdms_object(q, tdms_index(int8, 2)), tdms_object(tau, tdms_index(int8, 2))},
                      raw_data);
}

TEST(TdmsReader, ChunksAreRepeatedInASegment) {
  const auto table = read(two_channels("\1\2\x0a\x0b\3\4\x0c\x0d")).at(0);
  EXPECT_EQ(column(table, "q").values, (Values{1, 2, 3, 4}));
  EXPECT_EQ(column(table, "tau").values, (Values{10, 11, 12, 13}));
}

TEST(TdmsReader, ChannelsMayTakeTurns) {
  const auto table = read(two_channels("\1\x0a\2\x0b\3\x0c", new_metadata | interleaved)).at(0);
  EXPECT_EQ(column(table, "q").values, (Values{1, 2, 3}));
  EXPECT_EQ(column(table, "tau").values, (Values{10, 11, 12}));
}

TEST(TdmsReader, LaterSegmentsGoOnAsTheOneBefore) {
  const std::string first = two_channels("\1\2\x0a\x0b");
  const std::string as_before = tdms_segment(raw_alone, {}, "\3\4\x0c\x0d");
  // Only tau changes, to one value of two bytes in a chunk; q stays in its place.
  const std::string changed =
      tdms_segment(2 | 8, {tdms_object(tau, tdms_index(int16, 1))}, "\5\6\x0e\0"s);
  const std::string reduced = tdms_segment(2 | 8, {tdms_object(tau, tdms_no_data)}, "\7\x08");
  // A new list takes the index of long before.
  const std::string again =
      tdms_segment(new_metadata, {tdms_object(tau, tdms_as_before), tdms_object(q, tdms_as_before)},
                   "\x0f\0\x09\x0a"s);
  const auto tables = read(first + as_before + changed + reduced + again);
  ASSERT_EQ(tables.size(), 2U) << "of different lengths";
  EXPECT_EQ(tables[0].columns.at(0).values, (Values{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
  EXPECT_EQ(tables[1].columns.at(0).values, (Values{10, 11, 12, 13, 14, 15}));
  EXPECT_EQ(tables[0].group, "g/q");
  EXPECT_EQ(tables[1].group, "g/tau");
}

TEST(TdmsReader, BigEndianSegments) {
  const std::string path = big(std::uint32_t{8}) + q;
  const std::string index = big(std::uint32_t{20}) + big(std::uint32_t{int16}) +
                            big(std::uint32_t{1}) + big(std::uint64_t{2});
  const std::string metadata = big(std::uint32_t{1}) + path + index + big(std::uint32_t{0});
  const std::string raw_data = big(std::int16_t{-2}) + big(std::int16_t{300});
  const std::string segment = "TDSm" + little(std::uint32_t{new_metadata | in_big_endian}) +
                              big(std::uint32_t{4713}) +
                              big(std::uint64_t{metadata.size() + raw_data.size()}) +
                              big(std::uint64_t{metadata.size()}) + metadata + raw_data;
  EXPECT_EQ(read(segment).at(0).columns.at(0).values, (Values{-2, 300}));
}

TEST(TdmsReader, TheWaveformGivesTheClock) {
  const auto with = [](const std::vector<std::pair<std::string, double>>& properties) {
    return read(tdms_segment(new_metadata, {tdms_object(q, tdms_index(int8, 3), properties)},
                             "\1\2\3"))
        .at(0);
  };
  const auto table = with({{"wf_increment", 0.25}, {"wf_start_offset", 1}});
  EXPECT_EQ(table.columns.at(0).header.name, "time");
  EXPECT_EQ(table.columns.at(0).header.unit, "s");
  EXPECT_EQ(table.columns.at(0).values, (Values{1, 1.25, 1.5}));
  EXPECT_EQ(with({}).columns.size(), 1U);
  EXPECT_EQ(with({{"wf_increment", 0}}).columns.size(), 1U);
  EXPECT_EQ(with({{"wf_increment", NAN}}).columns.size(), 1U);
}

TEST(TdmsReader, AChannelOfTimeIsTheClock) {
  const auto table = read(tdms_segment(new_metadata,
                                       {tdms_object("/'g'/'Time'", tdms_index(int8, 2)),
                                        tdms_object(q, tdms_index(int8, 2), {{"wf_increment", 1}})},
                                       "\0\5\1\2"s))
                         .at(0);
  EXPECT_EQ(table.header, (Names{"Time", "q"}));
}

TEST(TdmsReader, ChannelsOfOneRateShareATable) {
  const auto object = [](const std::string& path, double increment) {
    return tdms_object(path, tdms_index(int8, 1), {{"wf_increment", increment}});
  };
  const auto tables = read(tdms_segment(
      new_metadata, {object(q, 0.1), object(tau, 0.1), object("/'g'/'slow'", 1)}, "\1\2\3"));
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_EQ(tables[0].header, (Names{"time", "q", "tau"}));
  EXPECT_EQ(tables[1].header, (Names{"time", "slow"}));
}

TEST(TdmsReader, TimestampsCountFromTheFirst) {
  const std::string half = little(std::uint64_t{1} << 63);
  const std::string none = little(std::uint64_t{0});
  const std::string raw_data = half + little(std::int64_t{3'800'000'000}) + none +
                               little(std::int64_t{3'800'000'001}) + half +
                               little(std::int64_t{3'800'000'002});
  const auto table =
      read(tdms_segment(new_metadata, {tdms_object(q, tdms_index(0x44, 3))}, raw_data)).at(0);
  EXPECT_EQ(table.columns.at(0).values, (Values{0, 0.5, 2}));
  EXPECT_EQ(table.columns.at(0).header.unit, "s");
}

TEST(TdmsReader, WhatIsCutOffIsTold) {
  const std::string whole = two_channels("\1\2\x0a\x0b\3\4\x0c\x0d");
  const auto note = [](const std::string& bytes) { return notes_of(read(bytes)); };
  const std::string size = std::to_string(whole.size());
  const std::string chunk_at = std::to_string(whole.size() - 4);
  const auto cut = read(whole.substr(0, whole.size() - 1));
  EXPECT_EQ(cut.at(0).columns.at(0).values, (Values{1, 2}));
  EXPECT_EQ(notes_of(cut), (Names{"truncated in segment at byte 0: expected " + size +
                                      " bytes, ended after " + std::to_string(whole.size() - 1),
                                  "truncated in chunk of raw data at byte " + chunk_at +
                                      ": expected 4 bytes, ended after 3"}));
  std::string open = whole;
  open.replace(12, 8, std::string(8, '\xff'));
  EXPECT_EQ(read(open).at(0).rows, 4U);
  EXPECT_EQ(note(open), Names{"the segment at byte 0 was not closed: it is read as far as the file "
                              "reaches"});
  EXPECT_EQ(note(whole + "TDSm"), Names{"truncated in the start of a segment at byte " + size +
                                        ": expected 28 bytes, ended after 4"});
  // Of half the metadata of a last segment nothing is read.
  const std::string half = whole + whole.substr(0, 40);
  EXPECT_EQ(read(half).at(0).rows, 4U);
}

TEST(TdmsReader, ScalesThatAreNotReadLeaveTheChannelOut) {
  const auto scaled = [](const std::string& path, const std::string& type) {
    return tdms_text(path) + tdms_index(int8, 1) + little(std::uint32_t{2}) +
           tdms_text("NI_Number_Of_Scales") + little(std::uint32_t{7}) + little(std::uint32_t{1}) +
           tdms_text("NI_Scale[0]_Scale_Type") + little(std::uint32_t{text}) + tdms_text(type);
  };
  const auto tables =
      read(tdms_segment(new_metadata,
                        {tdms_object(q, tdms_index(int8, 1)), scaled(tau, "Thermocouple"),
                         scaled("/'g'/'half'", "Linear")},
                        "\1\2\3"));
  EXPECT_EQ(tables.at(0).header, Names{"q"});
  EXPECT_EQ(notes_of(tables),
            (Names{"'g/tau' is not read: its scale is of type 'Thermocouple'",
                   "'g/half' is not read: its scale lacks 'NI_Scale[0]_Linear_Y_Intercept'"}));
}

TEST(TdmsReader, ScalesThatAreNoNumberOfScalesLeaveTheChannelOut) {
  for (const double count : {0.5, -1.0, 17.0, std::numeric_limits<double>::quiet_NaN()}) {
    const std::string scaled =
        tdms_object(tau, tdms_index(int8, 1), {{"NI_Number_Of_Scales", count}});
    const auto tables =
        read(tdms_segment(new_metadata, {tdms_object(q, tdms_index(int8, 1)), scaled}, "\1\2"));
    EXPECT_EQ(tables.at(0).header, Names{"q"}) << count;
  }
}

TEST(TdmsReader, UnitsStandInThePropertyOrInTheName) {
  const auto with_unit = [](const std::string& path, const std::string& unit) {
    return tdms_text(path) + tdms_index(int8, 1) + little(std::uint32_t{1}) +
           tdms_text("unit_string") + little(std::uint32_t{text}) + tdms_text(unit);
  };
  const auto table = read(tdms_segment(new_metadata,
                                       {with_unit("/'g'/'q[0]'", "deg"),
                                        tdms_object("/'g'/'tau [Nm]'", tdms_index(int8, 1))},
                                       "\1\2"))
                         .at(0);
  EXPECT_EQ(table.columns.at(0).header.name, "q[0]");
  EXPECT_EQ(table.columns.at(0).header.unit, "deg");
  EXPECT_EQ(table.columns.at(1).header.name, "tau");
  EXPECT_EQ(table.columns.at(1).header.unit, "Nm");
}

TEST(TdmsReader, NamesHoldQuotes) {
  const auto tables = read(tdms_segment(new_metadata,
                                        {tdms_object("/'Tom''s rig'/'q''s'", tdms_index(int8, 1)),
                                         tdms_object(tau, tdms_index(int8, 1))},
                                        "\1\2"));
  EXPECT_EQ(tables.at(0).group, "Tom's rig");
  EXPECT_EQ(tables.at(0).header, Names{"q's"});
}

TEST(TdmsReader, WhatIsNoLogIsRefused) {
  EXPECT_EQ(refusal_of(""), "a.tdms: file is empty");
  EXPECT_EQ(refusal_of("t,q\n"),
            "a.tdms: is not a TDMS file (byte 0), found 't,q\\x0a', expected 'TDSm'");
  EXPECT_EQ(refusal_of("TDSh"),
            "a.tdms: is the index of a TDMS file, expected the log itself; hint: "
            "name the .tdms file beside it");
  std::string whole = two_channels("\1\2\x0a\x0b");
  EXPECT_EQ(refusal_of(std::string(whole).replace(8, 1, "\1")),
            "a.tdms: is TDMS of another version (byte 8), found 4609, expected 4712 or 4713");
  EXPECT_EQ(refusal_of(whole + std::string(28, 'x')),
            "a.tdms: damaged: no segment starts at byte " + std::to_string(whole.size()) +
                ", found 'xxxx', expected 'TDSm'");
  EXPECT_EQ(
      refusal_of(tdms_segment(new_metadata, {tdms_object(q, little(std::uint32_t{0x1269}))}, "")),
      "a.tdms: holds raw data of DAQmx, which are not read; hint: in a Python with npTDMS and "
      "pandas (pip install npTDMS pandas): python3 -c \"import nptdms; "
      "nptdms.TdmsFile.read('LOG').as_dataframe(time_index=True).to_csv('LOG.csv')\"");
}

TEST(TdmsReader, MetadataThatCannotBeAreRefused) {
  const auto refused = [](const std::string& object, const std::string& raw_data = "\1") {
    return refusal_of(tdms_segment(new_metadata, {object}, raw_data));
  };
  EXPECT_EQ(refused(tdms_object(q, tdms_as_before)),
            "a.tdms: damaged: '/'g'/'q'' is stored as before, and was not before");
  EXPECT_EQ(refused(tdms_object("q", tdms_index(int8, 1))),
            "a.tdms: damaged: 'q' is no path of an object");
  EXPECT_NE(refused(tdms_object(q, tdms_index(11, 1)))
                .find("holds extended numbers, whose size is not known"),
            std::string::npos);
  EXPECT_NE(
      refused(tdms_object(q, tdms_index(int8, std::uint64_t{1} << 60))).find("more than 2^31"),
      std::string::npos);
  EXPECT_NE(refused(tdms_object(q, tdms_no_data)).find("has raw data of no channel"),
            std::string::npos);
  EXPECT_NE(
      refused(tdms_text(q) + tdms_index(int8, 1) + std::string(4, '\xff')).find("more properties"),
      std::string::npos);
  EXPECT_NE(refusal_of(tdms_segment(new_metadata | interleaved,
                                    {tdms_object(q, tdms_index(int8, 2)),
                                     tdms_object(tau, tdms_index(int8, 1))},
                                    "\1\2"))
                .find("are not of one length"),
            std::string::npos);
}

}  // namespace
}  // namespace tribolog::tdms_reader_test
