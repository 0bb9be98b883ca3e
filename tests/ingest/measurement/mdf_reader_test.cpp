// MDF 4 from bytes made here: what asammdf does not write, and what is refused.

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

namespace tribolog::mdf_reader_test {
namespace {

using namespace test::measured;
using namespace std::string_literals;
using Names = std::vector<std::string>;
using Values = std::vector<double>;

std::vector<ingest::log::LogTable> read(const std::string& bytes) {
  return ingest::measurement::parse_mdf(bytes, "a.mf4");
}
std::string refusal_of(const std::string& bytes) {
  return test::refusal_of<InputError>([&] { return read(bytes); });
}
Names notes_of(const std::vector<ingest::log::LogTable>& tables) {
  return wording::words(tables.front().notes);
}

const CnFields clock_field{.name = "t", .type = 2, .data_type = 4, .bits = 64};

/// Three rows: t = 0, 0.5, 1, and one channel of a byte: 10, 11, 12.
CgFields clock_and_byte() {
  return {.name = "run",
          .records = 3,
          .data_bytes = 9,
          .channels = {clock_field, {.name = "q", .byte = 8, .bits = 8}}};
}
std::string clock_and_byte_rows() {
  std::string rows;
  for (int i = 0; i < 3; ++i) rows += little(0.5 * i) + static_cast<char>(10 + i);
  return rows;
}

/// One group of one channel whose records are these bytes, one after the other.
ingest::log::LogColumn one_channel(MdfBytes& file, CnFields field, const std::string& rows,
                                   std::uint32_t record_bytes, std::uint32_t invalid_bytes = 0) {
  field.name = "x";
  const std::uint64_t stride = record_bytes + invalid_bytes;
  const std::uint64_t group = file.group({.records = rows.size() / stride,
                                          .data_bytes = record_bytes,
                                          .invalid_bytes = invalid_bytes,
                                          .channels = {field}},
                                         0);
  file.data_group(group, file.add("##DT", {}, rows));
  return read(file.bytes()).at(0).columns.at(0);
}
Values values(const CnFields& field, const std::string& rows, std::uint32_t record_bytes) {
  MdfBytes file;
  return one_channel(file, field, rows, record_bytes).values;
}
/// Of bytes 0, 1, ... through a conversion.
Values converted(std::uint8_t type, const Values& parameters, const std::string& rows) {
  MdfBytes file;
  const std::uint64_t conversion = file.conversion(type, parameters);
  return one_channel(file, {.conversion = conversion}, rows, 1).values;
}

TEST(MdfReader, IntegersOfAnyWidthAtAnyBit) {
  const std::string row("\x12\x34\x56\x78\x9a\xbc\xde\xf0\xff", 9);
  EXPECT_EQ(values({.bit = 4, .bits = 4}, row, 9), Values{1});
  EXPECT_EQ(values({.bit = 3, .bits = 1}, row, 9), Values{0});
  EXPECT_EQ(values({.byte = 1, .bit = 2, .bits = 10}, row, 9), Values{(0x5634 >> 2) & 0x3ff});
  EXPECT_EQ(values({.data_type = 1, .bits = 16}, row, 9), Values{0x1234});
  EXPECT_EQ(values({.data_type = 1, .bit = 4, .bits = 12}, row, 9), Values{0x123});
  EXPECT_EQ(values({.data_type = 2, .byte = 4, .bits = 8}, row, 9), Values{-102});
  EXPECT_EQ(values({.data_type = 3, .byte = 4, .bits = 16}, row, 9), Values{-25924});
  EXPECT_EQ(values({.data_type = 2, .bits = 1}, "\1", 1), Values{-1});
  // 64 bits from bit 4 on stand in nine bytes.
  EXPECT_EQ(values({.bit = 4, .bits = 64}, row, 9),
            Values{static_cast<double>(0xff0debc9a7856341ULL)});
  EXPECT_EQ(values({.data_type = 2, .bit = 4, .bits = 64}, row, 9),
            Values{static_cast<double>(static_cast<std::int64_t>(0xff0debc9a7856341ULL))});
}

TEST(MdfReader, FloatsInBothByteOrders) {
  EXPECT_EQ(values({.data_type = 4, .bits = 32}, little(-1.5F), 4), Values{-1.5});
  EXPECT_EQ(values({.data_type = 5, .bits = 64}, big(0.1), 8), Values{0.1});
  EXPECT_EQ(values({.data_type = 4, .bits = 16}, std::string("\x01\xc0", 2), 2),
            Values{-2.001953125});
  EXPECT_EQ(values({.data_type = 5, .bits = 16}, std::string("\x00\x01", 2), 2),
            Values{std::ldexp(1, -24)});
  MdfBytes file;
  const auto column = one_channel(file, {.data_type = 4, .bits = 32},
                                  little(std::numeric_limits<float>::infinity()) + little(2.F), 4);
  EXPECT_TRUE(std::isnan(column.values.at(0)));
  EXPECT_EQ(column.gaps, 1U);
}

TEST(MdfReader, InvalidationBitsAreGaps) {
  MdfBytes file;
  const std::string rows("\1\0\2\4\3\0", 6);
  const auto column = one_channel(file, {.flags = 2, .invalid_bit = 2}, rows, 1, 1);
  EXPECT_EQ(column.gaps, 1U);
  EXPECT_EQ(column.values.at(0), 1);
  EXPECT_TRUE(std::isnan(column.values.at(1)));
  EXPECT_EQ(column.values.at(2), 3);
}

TEST(MdfReader, ConversionsAsTheStandardHasThem) {
  const std::string bytes("\0\1\2\3\4\5", 6);
  EXPECT_EQ(converted(1, {-1, 0.5}, bytes), (Values{-1, -0.5, 0, 0.5, 1, 1.5}));
  EXPECT_EQ(converted(2, {1, 0, 1, 0, 0, 2}, bytes), (Values{0.5, 1, 2.5, 5, 8.5, 13}));
  EXPECT_EQ(converted(4, {1, 10, 3, 20}, bytes), (Values{10, 10, 15, 20, 20, 20}));
  // In the middle between two keys the lower one counts.
  EXPECT_EQ(converted(5, {1, 10, 3, 20}, bytes), (Values{10, 10, 10, 20, 20, 20}));
  EXPECT_EQ(converted(6, {0, 1, 10, 3, 4, 20, -1}, bytes), (Values{10, 10, -1, 20, 20, -1}));
}

TEST(MdfReader, RangesOfFloatsDoNotHoldTheirUpperEnd) {
  MdfBytes file;
  const std::uint64_t conversion = file.conversion(6, {0, 1, 10, 1, 2, 20, -1});
  std::string rows;
  for (const double value : {0.0, 0.5, 1.0, 1.5, 2.0}) rows += little(value);
  const CnFields field{.data_type = 4, .bits = 64, .conversion = conversion};
  EXPECT_EQ(one_channel(file, field, rows, 8).values, (Values{10, 10, 20, 20, -1}));
}

TEST(MdfReader, TextsOfValuesAreWords) {
  MdfBytes file;
  const std::vector<std::uint64_t> texts{file.text("off"), file.text("on"), file.text("never"), 0};
  const std::uint64_t conversion = file.conversion(7, {0, 1, 9}, texts);
  const auto column = one_channel(file, {.conversion = conversion}, std::string("\1\0\1\5", 4), 1);
  EXPECT_EQ(column.reading, ingest::log::ColumnReading::words);
  EXPECT_EQ(column.words, (Names{"off", "on"}));
  EXPECT_EQ(column.values.at(0), 1);
  EXPECT_EQ(column.values.at(1), 0);
  EXPECT_EQ(column.gaps, 1U);
}

TEST(MdfReader, TextsAmongNumbersAreGaps) {
  MdfBytes file;
  const std::uint64_t line = file.conversion(1, {0, 0.1});
  const std::uint64_t conversion = file.conversion(7, {255}, {file.text("no signal"), line});
  const auto column =
      one_channel(file, {.conversion = conversion}, std::string("\x0a\xff\x14", 3), 1);
  EXPECT_EQ(column.reading, ingest::log::ColumnReading::number);
  EXPECT_DOUBLE_EQ(column.values.at(0), 1);
  EXPECT_TRUE(std::isnan(column.values.at(1)));
  EXPECT_DOUBLE_EQ(column.values.at(2), 2);
}

TEST(MdfReader, RecordsOfSeveralGroupsAreToldApartByTheirNumbers) {
  MdfBytes file;
  CgFields texts{.record_id = 9, .records = 1, .flags = 1};
  CgFields second{.name = "b",
                  .record_id = 2,
                  .records = 2,
                  .data_bytes = 2,
                  .channels = {{.name = "x", .bits = 16}}};
  CgFields first{.name = "a",
                 .record_id = 1,
                 .records = 3,
                 .data_bytes = 1,
                 .channels = {{.name = "x", .bits = 8}}};
  const std::string data = "\1\x0a"s + "\2\0\1"s + "\x09"s + little(std::uint32_t{5}) + "hello" +
                           "\1\x0b"s + "\1\x0c"s + "\2\0\2"s;
  const std::uint64_t group = file.group(first, file.group(second, file.group(texts, 0)));
  file.data_group(group, file.add("##DT", {}, data), 1);
  const auto tables = read(file.bytes());
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_EQ(tables[0].group, "a");
  EXPECT_EQ(tables[0].columns[0].values, (Values{10, 11, 12}));
  EXPECT_EQ(tables[1].columns[0].values, (Values{256, 512}));
}

TEST(MdfReader, DamageInOneDataGroupLeavesTheOthers) {
  MdfBytes file;
  CgFields damaged = clock_and_byte();
  damaged.record_id = 1;
  file.data_group(file.group(damaged, 0), file.add("##DT", {}, "\7"), 1);
  file.data_group(file.group(clock_and_byte(), 0), file.add("##DT", {}, clock_and_byte_rows()));
  const auto tables = read(file.bytes());
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_EQ(tables[0].group, "run");
  EXPECT_EQ(tables[0].refusal, "");
  EXPECT_EQ(tables[1].group, "run_2");
  EXPECT_EQ(tables[1].refusal,
            "record at byte 0 of the data belongs to no channel group: its number is 7");
}

TEST(MdfReader, VirtualMasterCountsTheRecords) {
  MdfBytes file;
  const std::uint64_t rate = file.conversion(1, {0, 0.25});
  const CnFields clock{.name = "t", .type = 3, .bits = 0, .conversion = rate};
  const std::uint64_t group =
      file.group({.records = 3, .data_bytes = 1, .channels = {{.name = "q"}, clock}}, 0);
  file.data_group(group, file.add("##DT", {}, "\1\2\3"));
  const auto table = read(file.bytes()).at(0);
  EXPECT_EQ(table.columns[0].header.name, "t");
  EXPECT_EQ(table.columns[0].values, (Values{0, 0.25, 0.5}));
  EXPECT_EQ(table.columns[1].values, (Values{1, 2, 3}));
}

TEST(MdfReader, AFileThatWasNotFinalizedIsReadToItsEnd) {
  MdfBytes file("UnFinMF ");
  CgFields group = clock_and_byte();
  group.records = 0;
  const std::uint64_t cg = file.group(group, 0);
  // The last block's length says nothing: only its header was written.
  file.data_group(cg, 0);
  const std::uint64_t data = file.add("##DT", {}, clock_and_byte_rows() + "cut");
  file.set(data + 8, little(std::uint64_t{24}));
  std::string bytes = file.bytes();
  const std::size_t group_link = bytes.find("##DG") + 24 + 16;
  bytes.replace(group_link, 8, little(data));
  const auto tables = read(bytes);
  EXPECT_EQ(tables.at(0).columns[1].values, (Values{10, 11, 12}));
  EXPECT_EQ(notes_of(tables), Names{"the recording was not finalized: its records are read as far "
                                    "as the file reaches"});
}

TEST(MdfReader, SaysWhatIsMissingAtTheEnd) {
  MdfBytes file;
  const std::uint64_t cg = file.group(clock_and_byte(), 0);
  file.data_group(cg, 0);
  const std::uint64_t data = file.add("##DT", {}, clock_and_byte_rows());
  std::string bytes = file.bytes();
  bytes.replace(bytes.find("##DG") + 24 + 16, 8, little(data));
  bytes.resize(bytes.size() - 2);
  const auto tables = read(bytes);
  EXPECT_EQ(tables.at(0).rows, 2U);
  EXPECT_EQ(notes_of(tables), Names{"truncated in data block ##DT at byte " + std::to_string(data) +
                                    ": expected 51 bytes, ended after 49"});
}

TEST(MdfReader, RecordsThatAreStatedAndNotThereAreTold) {
  MdfBytes file;
  CgFields group = clock_and_byte();
  group.records = 5;
  file.data_group(file.group(group, 0), file.add("##DT", {}, clock_and_byte_rows()));
  EXPECT_EQ(notes_of(read(file.bytes())), Names{"'run' states 5 records; there are 3"});
}

TEST(MdfReader, ChannelsThatCannotBeReadAreNamedWithTheirReason) {
  MdfBytes file;
  CgFields group = clock_and_byte();
  group.channels.push_back({.name = "text", .data_type = 7, .byte = 0, .bits = 8});
  group.channels.push_back({.name = "long", .type = 1});
  group.channels.push_back({.name = "far", .byte = 9, .bits = 8});
  group.channels.push_back({.name = "odd", .data_type = 4, .bits = 24});
  group.channels.push_back({.name = "off", .flags = 1});
  group.channels.push_back({.name = "formula", .conversion = file.conversion(3, {})});
  group.channels.push_back({.name = "array", .composition = file.add("##CA", {}, "")});
  file.data_group(file.group(group, 0), file.add("##DT", {}, clock_and_byte_rows()));
  EXPECT_EQ(notes_of(read(file.bytes())),
            (Names{"'run/text' is not read: it holds texts",
                   "'run/long' is not read: its values are of variable length",
                   "'run/far' is not read: it reaches beyond its record of 9 bytes",
                   "'run/odd' is not read: it has numbers of 24 bits from bit 0 on",
                   "'run/off' is not read: all its values are marked as invalid",
                   "'run/formula' is not read: its conversion is a formula",
                   "'run/array' is not read: it is an array"}));
}

TEST(MdfReader, ChannelsOfOneNameAreToldApart) {
  MdfBytes file;
  CgFields group = clock_and_byte();
  group.channels.push_back({.name = "q", .byte = 8, .bits = 4});
  file.data_group(file.group(group, 0), file.add("##DT", {}, clock_and_byte_rows()));
  const auto tables = read(file.bytes());
  EXPECT_EQ(tables[0].header, (Names{"t", "q", "q_2"}));
  EXPECT_EQ(notes_of(tables), Names{"column names that occur more than once: 'q'"});
}

TEST(MdfReader, AGroupWithEmptyRecordsIsNamed) {
  MdfBytes file;
  file.data_group(file.group({.name = "empty", .records = 1U << 31}, 0), 0);
  file.data_group(file.group(clock_and_byte(), 0), file.add("##DT", {}, clock_and_byte_rows()));
  EXPECT_EQ(notes_of(read(file.bytes())), Names{"'empty' is not read: its records are empty"});
}

TEST(MdfReader, OlderVersionsAreRefusedWithWhatToRun) {
  EXPECT_EQ(
      refusal_of(MdfBytes("MDF     ", "3.30    ").bytes()),
      "a.mf4: is MDF of another version (byte 8), found '3.30', expected 4.00 or later; hint: "
      "in a Python with asammdf (pip install asammdf): python3 -c \"import asammdf; "
      "asammdf.MDF('LOG').convert('4.10').save('LOG.mf4')\"");
}

TEST(MdfReader, BlocksThatContradictEachOtherAreRefused) {
  EXPECT_EQ(refusal_of(""), "a.mf4: file is empty");
  EXPECT_EQ(refusal_of("MDF     4.10    "),
            "a.mf4: file ends inside the first 64 bytes, found 16 bytes");
  EXPECT_EQ(refusal_of("t,q\n"),
            "a.mf4: is not an MDF file (byte 0), found 't,q\\x0a', expected "
            "'MDF     '");
  EXPECT_EQ(refusal_of(MdfBytes().bytes()),
            "a.mf4: holds no channel with numbers that can be read, "
            "found nothing, expected a channel with a number for "
            "each sample");
  const std::string whole = [] {
    MdfBytes file;
    file.data_group(file.group(clock_and_byte(), 0), file.add("##DT", {}, clock_and_byte_rows()));
    return file.bytes();
  }();
  const auto with = [&](std::size_t at, const std::string& bytes) {
    return std::string(whole).replace(at, bytes.size(), bytes);
  };
  const std::size_t dg = whole.find("##DG");
  const std::string dg_at = std::to_string(dg);
  EXPECT_EQ(refusal_of(whole.substr(0, dg)),
            "a.mf4: block ##DG stands beyond the file's end, found a link to byte " + dg_at +
                " of " + dg_at + "; hint: the file may be cut off: copy it again");
  EXPECT_EQ(refusal_of(with(dg, "##XX")),
            "a.mf4: damaged: no block ##DG at byte " + dg_at + ", found '##XX'");
  EXPECT_EQ(refusal_of(with(dg + 24, little(std::uint64_t{dg}))),
            "a.mf4: damaged: block ##DG at byte " + dg_at + " is linked twice");
  EXPECT_EQ(refusal_of(with(dg + 8, little(std::uint64_t{1} << 60))),
            "a.mf4: block ##DG at byte " + dg_at +
                " reaches beyond the file's end, found 64 bytes of "
                "1152921504606846976; hint: the file may be cut off: copy it again");
  EXPECT_EQ(refusal_of(with(dg + 56, "\3")),
            "a.mf4: damaged: record numbers of 3 bytes in block ##DG at byte " + dg_at);
}

TEST(MdfReader, ABlockThatStatesMoreThanDeflateCanGiveTakesNoMemory) {
  MdfBytes file;
  std::string dz = "DT\0\0"s + little(std::uint32_t{0}) + little(std::uint64_t{1} << 40) +
                   little(std::uint64_t{8}) + std::string(8, 'x');
  file.data_group(file.group(clock_and_byte(), 0), file.add("##DZ", {}, dz));
  EXPECT_NE(refusal_of(file.bytes()).find("would unpack to more than 8 GiB"), std::string::npos);
  dz.replace(8, 8, little(std::uint64_t{1} << 32));
  MdfBytes second;
  second.data_group(second.group(clock_and_byte(), 0), second.add("##DZ", {}, dz));
  EXPECT_NE(refusal_of(second.bytes()).find("states 4294967296 bytes, more than its 8 can hold"),
            std::string::npos);
}

TEST(MdfReader, TransposedRowsMayBeLongerThanTheirBlock) {
  // Deflate's stored form of the three bytes of one channel.
  const std::string packed = "\x78\x01\x01\x03\x00\xfc\xff\x0a\x0b\x0c\x00\x43\x00\x22"s;
  const std::string dz = "DT\1\0"s + little(std::uint32_t{0xffffffff}) + little(std::uint64_t{3}) +
                         little(std::uint64_t{packed.size()}) + packed;
  MdfBytes file;
  const std::uint64_t group =
      file.group({.records = 3, .data_bytes = 1, .channels = {{.name = "q"}}}, 0);
  file.data_group(group, file.add("##DZ", {}, dz));
  EXPECT_EQ(read(file.bytes()).at(0).columns.at(0).values, (Values{10, 11, 12}));
}

TEST(MdfReader, ChannelsThatShareTheirBitsAreLeftOutAtSomePoint) {
  MdfBytes file;
  CgFields group = clock_and_byte();
  for (int i = 0; i < 100; ++i)
    group.channels.push_back({.name = "c" + std::to_string(i), .byte = 8});
  file.data_group(file.group(group, 0), file.add("##DT", {}, clock_and_byte_rows()));
  const auto tables = read(file.bytes());
  EXPECT_EQ(tables[0].columns.size(), 29U);  // 4 times 72 bits: the clock and 28 bytes
  EXPECT_EQ(notes_of(tables).back(), "and 61 more that are not read");
}

}  // namespace
}  // namespace tribolog::mdf_reader_test
