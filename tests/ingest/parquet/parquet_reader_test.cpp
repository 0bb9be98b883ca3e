// What a Parquet file of a known layout gives, and with which words another is refused.

#include "ingest/parquet/parquet_reader.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/temporary_directory.h"
#include "support/parquet_writer.h"
#include "wording/words.h"

namespace tribolog::parquet_reader_test {
namespace {

using test::CompactWriter;
using test::level_runs;
using test::raw;
using test::WrittenColumn;
using test::WrittenNode;
using test::WrittenParquet;

// As the format numbers them.
constexpr int boolean = 0;
constexpr int int32 = 1;
constexpr int int64 = 2;
constexpr int int96 = 3;
constexpr int real64 = 5;
constexpr int bytes = 6;
constexpr int fixed = 7;
constexpr int optional = 1;
constexpr int repeated = 2;

ingest::log::LogTable read(const WrittenParquet& file) {
  return ingest::parquet::parse_parquet(test::write_parquet(file), "a.parquet").at(0);
}

std::string refusal(const std::string& file) {
  return test::refusal_of<InputError>(
      [&] { return ingest::parquet::parse_parquet(file, "a.parquet"); });
}

std::string refusal(const WrittenParquet& file) { return refusal(test::write_parquet(file)); }

WrittenParquet of_one(WrittenNode node, WrittenColumn column, std::int64_t rows) {
  WrittenParquet file;
  file.schema.push_back(std::move(node));
  file.columns.push_back(std::move(column));
  file.rows = rows;
  return file;
}

/// {1: yes, 2: {unit: {}}}, the logical type of a timestamp or a time.
CompactWriter of_time(int id, int unit) {
  CompactWriter inner;
  inner.boolean(1, true).structure(2, CompactWriter().structure(unit, CompactWriter()));
  return CompactWriter().structure(id, inner);
}

TEST(Parquet, ColumnsHaveTheirNamesAndUnits) {
  WrittenParquet file;
  test::add_doubles("t [s]", {0, 0.5, 1}, file);
  test::add_doubles("q", {1, HUGE_VAL, NAN}, file);
  const ingest::log::LogTable table = read(file);
  EXPECT_EQ(table.rows, 3U);
  EXPECT_EQ(table.columns[0].header.name, "t");
  EXPECT_EQ(table.columns[0].header.unit, "s");
  EXPECT_EQ(table.columns[0].values, (std::vector<double>{0, 0.5, 1}));
  EXPECT_EQ(table.columns[1].gaps, 2U) << "what is not finite is a gap";
}

TEST(Parquet, TwoColumnsOfANameAreToldApart) {
  WrittenParquet file;
  test::add_doubles("q", {1, 2}, file);
  test::add_doubles("q", {3, 4}, file);
  const ingest::log::LogTable table = read(file);
  EXPECT_EQ(table.header, (std::vector<std::string>{"q", "q_2"}));
  EXPECT_EQ(wording::words(table.notes).at(0),
            "column name 'q' occurs twice; that of array 'q' is now 'q_2'");
}

TEST(Parquet, NanosecondsSince1970AreExact) {
  constexpr std::int64_t first = 1'772'352'900'123'456'789;
  WrittenParquet file;
  test::add_integers("stamp", {first, first + 1, first + 1'000'000'007}, file);
  test::add_integers("count", {first, first + 1, first + 1'000'000'007}, file);
  file.schema[0].logical = of_time(8, 3);
  const ingest::log::LogTable table = read(file);
  const ingest::log::LogColumn& stamp = table.columns[0];
  EXPECT_EQ(stamp.reading, ingest::log::ColumnReading::iso_time);
  EXPECT_EQ(stamp.origin, 1'772'352'900);
  EXPECT_EQ(stamp.values, (std::vector<double>{0.123456789, 0.12345679, 1.123456796}));
  const ingest::log::LogColumn& count = table.columns[1];
  EXPECT_EQ(count.reading, ingest::log::ColumnReading::number);
  EXPECT_EQ(count.values[1] - count.values[0], 1);
  EXPECT_EQ(count.values[2] - count.values[0], 1'000'000'007);
  EXPECT_EQ(static_cast<std::int64_t>(count.origin) + static_cast<std::int64_t>(count.values[0]),
            first);
}

TEST(Parquet, TimesBefore1970CountFromWholeSeconds) {
  WrittenParquet file;
  test::add_integers("stamp", {-1500, -500}, file);
  file.schema[0].converted = 9;  // TIMESTAMP_MILLIS
  const ingest::log::LogTable table = read(file);
  EXPECT_EQ(table.columns[0].origin, -2);
  EXPECT_EQ(table.columns[0].values, (std::vector<double>{0.5, 1.5}));
}

TEST(Parquet, IntegersAtTheEndsOfTheirRangeAreNumbers) {
  constexpr std::int64_t lowest = std::numeric_limits<std::int64_t>::min();
  constexpr std::int64_t highest = std::numeric_limits<std::int64_t>::max();
  WrittenParquet file;
  test::add_integers("n", {lowest + 1, highest, lowest}, file);
  test::add_integers("stamp", {lowest + 1, highest, lowest}, file);
  file.schema[1].logical = of_time(8, 2);
  const ingest::log::LogTable table = read(file);
  for (const ingest::log::LogColumn& column : table.columns) {
    const double unit = column.header.full == "n" ? 1 : 1e6;
    EXPECT_DOUBLE_EQ(column.origin + column.values[0], -0x1p63 / unit);
    EXPECT_DOUBLE_EQ(column.origin + column.values[1], 0x1p63 / unit);
    EXPECT_EQ(column.gaps, 1U) << "the lowest one, as pandas' NaT is";
  }
}

TEST(Parquet, DatesAndTimesOfDayAreReadAsSuch) {
  WrittenParquet file;
  file.schema = {{"date", int32, 0, 0, 6}, {"ms", int32, 0, 0, 7}, {"us", int64, 0, 0, 8}};
  file.columns = {{int32, raw(std::vector{20513}), 1},
                  {int32, raw(std::vector{1500}), 1},
                  {int64, raw(std::vector<std::int64_t>{1500}), 1}};
  file.rows = 1;
  const ingest::log::LogTable table = read(file);
  EXPECT_EQ(table.columns[0].reading, ingest::log::ColumnReading::date);
  EXPECT_EQ(table.columns[0].values[0], 20513 * 86400.0);
  EXPECT_EQ(table.columns[1].reading, ingest::log::ColumnReading::time_of_day);
  EXPECT_EQ(table.columns[1].values[0], 1.5);
  EXPECT_EQ(table.columns[2].values[0], 0.0015);
}

TEST(Parquet, SparksInt96IsATime) {
  const std::string value = raw(std::vector<std::int64_t>{3'600'000'000'001}) +
                            raw(std::vector<std::uint32_t>{2'440'589});
  const ingest::log::LogTable table = read(of_one({"t", int96}, {int96, value + value, 2}, 2));
  EXPECT_EQ(table.columns[0].reading, ingest::log::ColumnReading::iso_time);
  EXPECT_EQ(table.columns[0].origin, 86'400 + 3'600);
  EXPECT_EQ(table.columns[0].values[0], 1e-9);
  const std::string never = std::string(8, '\0') + std::string(4, '\x7f');
  EXPECT_NE(refusal(of_one({"t", int96}, {int96, never, 1}, 1)).find("not within 1678 to 2261"),
            std::string::npos);
}

TEST(Parquet, UnsignedIntegersAreNotNegative) {
  WrittenParquet file;
  file.schema = {{"a", int32, 0, 0, 13}, {"b", int64, 0, 0, 14}};
  file.columns = {{int32, raw(std::vector{-1}), 1}, {int64, raw(std::vector<std::int64_t>{-1}), 1}};
  file.rows = 1;
  const ingest::log::LogTable table = read(file);
  EXPECT_EQ(table.columns[0].values[0], 4294967295.0);
  EXPECT_EQ(table.columns[1].values[0], 18446744073709551616.0);
  EXPECT_EQ(wording::words(table.notes).at(0),
            "'b' holds integers of 2^53 and more: they are rounded");
}

TEST(Parquet, DecimalsAreOfAnyWidth) {
  WrittenParquet file;
  file.schema = {{"a", int32, 0, 0, 5, {}, 0, 2},
                 {"b", int64, 0, 0, 5, {}, 0, 1},
                 {"c", fixed, 0, 0, 5, {}, 3, 2}};
  file.columns = {{int32, raw(std::vector{-12345}), 1},
                  {int64, raw(std::vector<std::int64_t>{15}), 1},
                  {fixed, "\xff\xff\x38", 1}};
  file.rows = 1;
  const ingest::log::LogTable table = read(file);
  EXPECT_EQ(table.columns[0].values[0], -123.45);
  EXPECT_EQ(table.columns[1].values[0], 1.5);
  EXPECT_EQ(table.columns[2].values[0], -2.0);
}

TEST(Parquet, HalfPrecisionHasItsSubnormals) {
  WrittenNode node{"h", fixed};
  node.type_bytes = 2;
  node.logical = CompactWriter().structure(15, CompactWriter());
  const std::string page =
      raw(std::vector<std::uint16_t>{0x3c00, 0xc000, 0x0001, 0x7bff, 0x7c00, 0x8000});
  const ingest::log::LogTable table = read(of_one(node, {fixed, page, 6}, 6));
  EXPECT_EQ(table.columns[0].values[0], 1);
  EXPECT_EQ(table.columns[0].values[1], -2);
  EXPECT_EQ(table.columns[0].values[2], std::ldexp(1.0, -24));
  EXPECT_EQ(table.columns[0].values[3], 65504);
  EXPECT_EQ(table.columns[0].gaps, 1U);
}

TEST(Parquet, NullsAreGapsWhicheverWayLevelsArePacked) {
  const std::string values = raw(std::vector<double>{1, 2, 3});
  const WrittenNode node{"q", real64, optional};
  const std::vector<double> expected{1, NAN, 2, 3};
  // 1, 0, 1, 1: in a group of eight from the lowest bit on; from the highest one; in runs.
  const std::string packed = raw(std::vector<std::uint32_t>{2}) + "\x03\x0d";
  WrittenColumn older{real64, "\xb0" + values, 4};
  older.level_encoding = 4;
  for (const WrittenColumn& column :
       {WrittenColumn{real64, packed + values, 4}, older,
        WrittenColumn{real64, level_runs({{1, 1}, {1, 0}, {2, 1}}) + values, 4}}) {
    const ingest::log::LogTable table = read(of_one(node, column, 4));
    EXPECT_EQ(table.columns[0].gaps, 1U);
    for (const std::size_t i : {0U, 2U, 3U}) {
      EXPECT_EQ(table.columns[0].values[i], expected[i]);
    }
  }
}

TEST(Parquet, ADictionaryIsLookedUp) {
  WrittenColumn column{real64, std::string("\x02\x03\xe4\x00", 4) /* 0 1 2 3, packed in 2 bits */,
                       4};
  column.encoding = 8;
  column.dictionary = raw(std::vector<double>{0.5, 1.5, 2.5, 3.5});
  column.dictionary_values = 4;
  EXPECT_EQ(read(of_one({"q", real64}, column, 4)).columns[0].values,
            (std::vector<double>{0.5, 1.5, 2.5, 3.5}));
  column.dictionary_values = 3;
  EXPECT_NE(
      refusal(of_one({"q", real64}, column, 4)).find("place that its dictionary does not have"),
      std::string::npos);
  column.dictionary.clear();
  EXPECT_NE(refusal(of_one({"q", real64}, column, 4)).find("dictionary is missing"),
            std::string::npos);
}

TEST(Parquet, TextsAreWordsOrTimes) {
  const auto counted = [](const std::vector<std::string>& texts) {
    std::string page;
    for (const std::string& text : texts) {
      page += raw(std::vector{static_cast<std::uint32_t>(text.size())}) + text;
    }
    return WrittenColumn{bytes, page, texts.size()};
  };
  const WrittenNode node{"s", bytes, 0, 0, 0};
  const ingest::log::LogTable words = read(of_one(node, counted({"up", "down", "up", ""}), 4));
  EXPECT_EQ(words.columns[0].reading, ingest::log::ColumnReading::words);
  EXPECT_EQ(words.columns[0].words, (std::vector<std::string>{"up", "down"}));
  EXPECT_EQ(words.columns[0].values[2], 0);
  EXPECT_EQ(words.columns[0].gaps, 1U);
  const ingest::log::LogTable times =
      read(of_one(node, counted({"2026-03-01T08:15:00.25Z", "2026-03-01T08:15:01Z"}), 2));
  EXPECT_EQ(times.columns[0].reading, ingest::log::ColumnReading::iso_time);
  EXPECT_EQ(times.columns[0].values, (std::vector<double>{0.25, 1}));
  WrittenParquet mixed = of_one(node, counted({"2026-03-01T08:15:00Z", "later"}), 2);
  mixed.root_children = 1;
  test::add_doubles("q", {1, 2}, mixed);
  EXPECT_EQ(wording::words(read(mixed).notes),
            std::vector<std::string>{"'s' is not read: it holds times and other texts"});
}

TEST(Parquet, ListsOfOneLengthAreColumns) {
  WrittenParquet file;
  test::add_lists("q", {{}, {1, 2}, {3, 4}, {}}, file);
  const ingest::log::LogTable table = read(file);
  EXPECT_EQ(table.header, (std::vector<std::string>{"q_0", "q_1"}));
  EXPECT_EQ(table.columns[0].gaps, 2U);
  EXPECT_EQ(table.columns[1].values[1], 2);
  EXPECT_EQ(table.columns[0].values[2], 3);
}

TEST(Parquet, OlderListsHaveNoElementOfTheirOwn) {
  WrittenParquet file;
  file.schema = {{"q", {}, 0, 1, 3}, {"array", real64, repeated}};
  file.root_children = 1;
  file.columns = {{real64,
                   level_runs({{1, 0}, {1, 1}, {1, 0}, {1, 1}}) + level_runs({{4, 1}}) +
                       raw(std::vector<double>{1, 2, 3, 4}),
                   4}};
  file.rows = 2;
  const ingest::log::LogTable table = read(file);
  EXPECT_EQ(table.header, (std::vector<std::string>{"q_0", "q_1"}));
  EXPECT_EQ(table.columns[1].values, (std::vector<double>{2, 4}));
}

TEST(Parquet, WhatGivesNoColumnIsNamed) {
  WrittenParquet file;
  test::add_lists("varies", {{1}, {1, 2}}, file);
  test::add_lists("empty", {{}, {}}, file);
  test::add_doubles("q", {1, 2}, file);
  file.schema.push_back({"image", bytes});
  file.columns.push_back({bytes, "not looked at", 2});
  ++file.root_children;
  EXPECT_EQ(wording::words(read(file).notes),
            (std::vector<std::string>{
                "'varies' is not read: its rows hold lists of 1 and of 2 elements",
                "'empty' is not read: all of its lists are empty",
                "'image' is not read: it holds bytes that are neither numbers nor texts"}));
}

TEST(ParquetRefusal, NamesWhatIsWrong) {
  WrittenParquet file;
  test::add_doubles("q", {1, 2}, file);
  const std::string good = test::write_parquet(file);
  EXPECT_EQ(refusal(good), "");
  EXPECT_EQ(refusal("PAR1PAR1"),
            "a.parquet: damaged: shorter than any Parquet file, found 8 bytes");
  EXPECT_EQ(
      refusal(good.substr(0, good.size() - 4)),
      "a.parquet: damaged: the file does not end with its footer; hint: it is cut off, or was "
      "not closed by what wrote it: copy it again");
  file.magic = "PARE";
  EXPECT_EQ(refusal(file), "a.parquet: is encrypted Parquet; hint: decrypt it where its key is");
  file.magic = "PAR1";
  file.columns[0].codec = 3;
  EXPECT_EQ(refusal(file),
            "a.parquet: is Parquet compressed with LZO, which is not read; hint: write it with "
            "snappy, gzip, brotli, LZ4 or zstd");
  file.columns[0].codec = 77;
  EXPECT_NE(refusal(file).find("unknown codec 77"), std::string::npos);
  file.columns[0].codec = 0;
  file.columns[0].encoding = 99;
  EXPECT_NE(refusal(file).find("encoding that is not read: 99"), std::string::npos);
  file.columns[0].encoding = 5;
  EXPECT_NE(refusal(file), "") << "differences of doubles";
}

TEST(ParquetRefusal, ChecksThePageAgainstItsCrc) {
  WrittenParquet file;
  test::add_doubles("q", {1, 2}, file);
  file.columns[0].crc = 0x12345678;
  EXPECT_NE(refusal(file).find("instead of 12345678"), std::string::npos) << refusal(file);
}

TEST(ParquetRefusal, CountsHaveToAgree) {
  WrittenParquet file;
  test::add_doubles("q", {1, 2, 3}, file);
  file.rows = 4;
  EXPECT_EQ(refusal(file), "a.parquet: damaged: a column has 3 rows where 4 are stated");
  file.rows = 0;
  file.columns[0] = {real64, "", 0};
  EXPECT_EQ(refusal(file),
            "a.parquet: no rows of numbers, found 0 rows, expected columns of numbers");
}

TEST(ParquetRefusal, TakesNoMemoryForWhatIsOnlyStated) {
  WrittenParquet file;
  file.schema = {{"q", real64, optional}};
  constexpr unsigned many = 2'000'000'000;
  const std::string runs = test::varint(std::uint64_t{many} << 1U) + std::string(1, '\0');
  file.columns = {{real64, raw(std::vector{static_cast<std::uint32_t>(runs.size())}) + runs, many}};
  file.rows = many;
  EXPECT_NE(refusal(file).find("states more numbers than a file of its size is read for"),
            std::string::npos)
      << refusal(file);
  WrittenParquet packed;
  test::add_doubles("q", {1, 2}, packed);
  packed.columns[0].codec = 6;
  packed.columns[0].stated_unpacked = 2'000'000'000;
  EXPECT_NE(refusal(packed).find("states to unpack to 2000000000"), std::string::npos);
}

TEST(ParquetRefusal, ASchemaIsATreeOfBoundedDepth) {
  WrittenParquet deep;
  for (int i = 0; i < 40; ++i) deep.schema.push_back({"a", {}, 0, 1});
  deep.schema.push_back({"q", real64});
  deep.root_children = 1;
  deep.columns = {{real64, raw(std::vector<double>{1, 2}), 2}};
  deep.rows = 2;
  EXPECT_NE(refusal(deep).find("nested too deeply"), std::string::npos) << refusal(deep);
  WrittenParquet open;
  test::add_doubles("q", {1, 2}, open);
  open.root_children = 2;
  EXPECT_NE(refusal(open).find("are no tree"), std::string::npos) << refusal(open);
}

TEST(Parquet, BooleansArePackedBitByBit) {
  const ingest::log::LogTable table = read(of_one({"on", boolean}, {boolean, "\x05", 3}, 3));
  EXPECT_EQ(table.columns[0].values, (std::vector<double>{1, 0, 1}));
}

}  // namespace
}  // namespace tribolog::parquet_reader_test
