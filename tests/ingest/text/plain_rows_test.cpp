// Long logs: the fast way gives what the careful way gives, to the last bit.

#include "ingest/text/plain_rows.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ingest/text/csv_reader.h"
#include "ingest/text/plain_number.h"
#include "wording/words.h"

namespace tribolog::plain_rows_test {
namespace {

void expect_same_as_from_chars(const std::string& text) {
  const char* const end = text.data() + text.size();
  double expected = 0;
  const auto read = std::from_chars(text.data(), end, expected);
  double value = 0;
  const char* const behind = ingest::text::read_plain_number(text.data(), end, '.', value);
  if (read.ec != std::errc() || !std::isfinite(expected)) {
    EXPECT_EQ(behind, text.data()) << text;
    return;
  }
  EXPECT_EQ(behind - text.data(), read.ptr - text.data()) << text;
  EXPECT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(expected)) << text;
}

TEST(PlainNumber, IsFromCharsToTheLastBit) {
  std::mt19937_64 random(1);
  const auto digits = [&](int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += static_cast<char>('0' + random() % 10);
    return text;
  };
  for (int i = 0; i < 300'000; ++i) {
    std::string text = random() % 2 ? "-" : "";
    text += digits(static_cast<int>(random() % 13));
    if (random() % 4) {
      text += '.';
      text += digits(static_cast<int>(random() % 25));
    }
    if (random() % 8 == 0) text += fmt::format("e{}", static_cast<int>(random() % 640) - 330);
    text += std::string("\0,;x \n", 6)[random() % 6];
    expect_same_as_from_chars(text);
  }
}

TEST(PlainNumber, HasNoTroubleAtItsBounds) {
  for (const char* text : {"",
                           "-",
                           ".",
                           "-.",
                           "0",
                           "-0",
                           "-0.0",
                           "1.",
                           ".5",
                           "-.5",
                           "9007199254740992",
                           "9007199254740993",
                           "0.9007199254740993",
                           "18446744073709551615",
                           "18446744073709551616",
                           "99999999999999999999999999",
                           "0.00000000000000000000000000001",
                           "1e400",
                           "1e-400",
                           "inf",
                           "nan",
                           "0x10",
                           "1e",
                           "1e+",
                           "12345678",
                           "1234567812345678",
                           "+1",
                           "1.2.3",
                           "--1",
                           "0000000000000000000000001",
                           "1.00000000000000000000000000"}) {
    expect_same_as_from_chars(text);
  }
}

TEST(PlainNumber, TakesTheMarkThatIsStated) {
  const std::string text = "-12,5;";
  double value = 0;
  EXPECT_EQ(ingest::text::read_plain_number(text.data(), text.data() + text.size(), ',', value),
            text.data() + 5);
  EXPECT_EQ(value, -12.5);
}

/// Rows of plain numbers with oddities strewn in; what the columns and lines have to be beside it.
struct LongLog {
  std::string text;
  std::vector<double> t, tau;
  std::vector<long> lines;
  std::size_t gaps{};

  explicit LongLog(std::size_t rows, const std::string& line_end = "\n") {
    text = "t,q,note,tau" + line_end;
    std::mt19937_64 random(7);
    long line = 1;
    for (std::size_t i = 0; i < rows; ++i) {
      for (; random() % 5000 == 0; ++line)
        text += random() % 2 ? "# a comment" + line_end : line_end;
      const double torque = std::bit_cast<double>(random() >> 12 | 0x3FF0000000000000U) - 1.5;
      const bool gap = random() % 700 == 0;
      const char* const note = random() % 3000 == 0 ? "\"a, b\"" : "";
      text += fmt::format("{:.6f},{},{},{}", 1e-3 * static_cast<double>(i), i % 10, note,
                          gap ? std::string("nan") : fmt::format("{}", torque));
      text += line_end;
      t.push_back(std::stod(fmt::format("{:.6f}", 1e-3 * static_cast<double>(i))));
      tau.push_back(gap ? NAN : torque);
      gaps += gap ? 1 : 0;
      lines.push_back(++line);
    }
  }
};

TEST(PlainRows, LongLogsKeepEveryRowItsLineAndItsGaps) {
  for (const char* line_end : {"\n", "\r\n"}) {
    const LongLog log(150'000, line_end);
    ASSERT_GT(log.text.size(), std::size_t{4} << 20);
    const ingest::text::CsvTable table = ingest::text::read_csv(log.text, "f", {{"tau"}, {"t"}});
    ASSERT_EQ(table.rows, log.t.size());
    EXPECT_EQ(table.columns[1].values, log.t);
    EXPECT_EQ(table.columns[0].gaps, log.gaps);
    for (std::size_t i = 0; i < log.tau.size(); ++i) {
      const double value = table.columns[0].values[i];
      ASSERT_TRUE(value == log.tau[i] || (std::isnan(value) && std::isnan(log.tau[i]))) << i;
      ASSERT_EQ(table.line_of(i), log.lines[i]) << i;
    }
    EXPECT_TRUE(table.notes.empty()) << wording::words(table.notes.front());
  }
}

/// The quote would swallow the delimiter, and the row would have as many fields as it should.
TEST(PlainRows, AQuoteInFrontOfAFieldIsNoPlainRow) {
  const ingest::text::PlainLayout layout{ingest::text::Delimiter::comma,
                                         ingest::text::DecimalMark::point,
                                         {{0, {}, {}, {}}, {1, {}, {}, {}}, {2, {}, {}, {}}},
                                         3};
  ingest::text::PlainRows rows;
  ingest::text::read_plain_rows("1,2,3\n1,\"2\n", layout, rows);
  EXPECT_EQ(rows.rows, 1U);
  EXPECT_FALSE(rows.is_whole);
}

TEST(PlainRows, AFaultFarBehindIsRefusedAtItsLine) {
  LongLog log(120'000);
  log.text += "1,2,,fault\n";
  try {
    (void)ingest::text::read_csv(log.text, "f", {{"t"}, {"tau"}});
    FAIL() << "not refused";
  } catch (const InputError& refused) {
    EXPECT_EQ(
        std::string(refused.what()),
        fmt::format(
            "f:{}:6: column 'tau', found 'fault', expected a number; hint: damaged "
            "rows? [log] skip_bad_rows = true (--skip-bad-rows) leaves them out, up to 1 % of all",
            log.lines.back() + 1));
  }
}

TEST(PlainRows, BlanksBetweenColumnsAndClocksFrom1970) {
  std::string text = "t  q   tau\n";
  for (int i = 0; i < 60'000; ++i) {
    text +=
        fmt::format(" 17000000{:02d}.{:09d}  {}\t{} \n", i / 1000, (i % 1000) * 1'000'001, i, -i);
  }
  const ingest::text::CsvTable table = ingest::text::read_csv(
      text, "f", {{"t", "", ingest::log::ColumnReading::clock}, {"q"}, {"tau"}});
  ASSERT_EQ(table.rows, 60'000U);
  for (std::size_t i = 0; i < table.rows; ++i) {
    const double t =
        static_cast<double>(i / 1000) + 1e-9 * static_cast<double>((i % 1000) * 1'000'001);
    ASSERT_NEAR(table.columns[0].values[i], t, 1e-14) << i;
    ASSERT_EQ(table.columns[2].values[i], -static_cast<double>(i));
  }
}

TEST(PlainRows, OfAWideLogTakeNoMoreRoomThanItsTextAsksFor) {
  constexpr std::size_t columns = 5000;
  std::string text;
  for (int row = 0; row < 50; ++row) {
    for (std::size_t k = 0; k < columns; ++k) text += k + 1 < columns ? "0.125," : "0.125\n";
  }
  ingest::text::PlainLayout layout{
      ingest::text::Delimiter::comma, ingest::text::DecimalMark::point, {}, columns};
  for (std::size_t k = 0; k < columns; ++k) layout.columns.push_back({static_cast<int>(k), {}, {}});
  ingest::text::PlainRows rows;
  ingest::text::read_plain_rows(text, layout, rows);
  EXPECT_EQ(rows.rows, 50U);
  EXPECT_TRUE(rows.is_whole);
  std::size_t numbers = 0;
  for (const std::vector<double>& values : rows.values) numbers += values.capacity();
  EXPECT_LT(numbers, text.size());
}

}  // namespace
}  // namespace tribolog::plain_rows_test
