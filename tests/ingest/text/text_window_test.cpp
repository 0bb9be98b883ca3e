// Logs that come piece by piece.

#include <algorithm>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/temporary_directory.h"
#include "ingest/text/csv_lines.h"
#include "ingest/text/csv_reader.h"

namespace tribolog::text_window_test {
namespace {

/// Gives a few bytes at a time, as a pipe may.
class Trickle final : public ByteSource {
 public:
  Trickle(std::string_view bytes, std::size_t most, std::uint64_t seed)
      : memory_(bytes), most_(most), random_(seed) {}
  std::size_t read(char* to, std::size_t most) override {
    return memory_.read(to, std::min(most, 1 + random_() % most_));
  }
  [[nodiscard]] std::uint64_t likely_bytes() const override { return 0; }

 private:
  MemorySource memory_;
  std::size_t most_;
  std::mt19937_64 random_;
};

/// A start, and then the same over and over.
class Endless final : public ByteSource {
 public:
  Endless(std::string start, std::string again, std::uint64_t bytes)
      : start_(std::move(start)), again_(std::move(again)), left_(bytes) {}
  std::size_t read(char* to, std::size_t most) override {
    const std::size_t bytes = std::min<std::uint64_t>(most, left_);
    for (std::size_t i = 0; i < bytes; ++i, ++at_) {
      to[i] = at_ < start_.size() ? start_[at_] : again_[(at_ - start_.size()) % again_.size()];
    }
    left_ -= bytes;
    read_ += bytes;
    return bytes;
  }
  [[nodiscard]] std::uint64_t likely_bytes() const override { return 0; }
  [[nodiscard]] std::uint64_t bytes_read() const { return read_; }

 private:
  std::string start_, again_;
  std::uint64_t left_;
  std::uint64_t read_{0};
  std::size_t at_{0};
};

std::string log_of(const std::string& line_end, int rows) {
  std::string text = "t,tau,note" + line_end;
  for (int i = 0; i < rows; ++i) {
    if (i % 97 == 0) text += "# comment" + line_end + line_end;
    text += fmt::format("{:.3f},{},{}", 1e-3 * i, i % 89 == 0 ? "nan" : fmt::format("{}", 0.1 * i),
                        i % 83 == 0 ? "\"a, b\"" : "x");
    text += line_end;
  }
  return text;
}

TEST(TextWindow, ALogIsTheSameInPiecesOfAnySize) {
  for (const char* line_end : {"\n", "\r\n", "\r"}) {
    const std::string text = log_of(line_end, 3000);
    const ingest::text::CsvTable whole = ingest::text::read_csv(text, "f", {{"t"}, {"tau"}});
    ASSERT_EQ(whole.rows, 3000U);
    for (const std::size_t most : {1U, 2U, 7U, 1000U, 100'000U}) {
      Trickle pieces(text, most, most);
      const ingest::text::CsvTable table = ingest::text::read_csv(pieces, "f", {{"t"}, {"tau"}});
      EXPECT_EQ(table.rows, whole.rows) << most;
      EXPECT_EQ(table.columns[0].values, whole.columns[0].values) << most;
      EXPECT_EQ(table.columns[1].gaps, whole.columns[1].gaps) << most;
      EXPECT_EQ(table.line_breaks, whole.line_breaks) << most;
      EXPECT_EQ(table.notes, whole.notes) << most;
    }
  }
}

TEST(TextWindow, ManyWindowsGiveEveryRowOnce) {
  // Some 40 MB; nothing is reserved, and no window holds more than a part.
  Endless log("t,tau\n", "1,2\n0.5,-0.25\n", 6 + 14 * std::uint64_t{2'900'000});
  const ingest::text::CsvTable table = ingest::text::read_csv(log, "f", {{"t"}, {"tau"}});
  ASSERT_EQ(table.rows, 5'800'000U);
  for (std::size_t i = 0; i < table.rows; ++i) {
    ASSERT_EQ(table.columns[0].values[i], i % 2 == 0 ? 1 : 0.5) << i;
  }
  EXPECT_EQ(table.line_of(table.rows - 1), 5'800'001);
  EXPECT_EQ(table.cut_rows, 0U);
}

TEST(TextWindow, ALineWithoutEndIsRefusedBeforeItFillsTheMemory) {
  constexpr std::uint64_t eight_hundred_MB = 800'000'000;
  Endless header("t,tau", "x", eight_hundred_MB);
  EXPECT_EQ(
      test::refusal_of<InputError>([&] { return ingest::text::read_csv(header, "f", {{"t"}}); }),
      "f:1: line is longer than 1 MiB, expected a text file of columns; hint: do its rows "
      "end with line ends?");
  EXPECT_LT(header.bytes_read(), 10'000'000U);
  Endless first_row("t,tau\n0,", "1", eight_hundred_MB);
  EXPECT_EQ(
      test::refusal_of<InputError>([&] { return ingest::text::read_csv(first_row, "f", {{"t"}}); }),
      "f:2: line is longer than 1 MiB, expected a text file of columns; hint: do its rows "
      "end with line ends?");
  Endless row("t,tau\n0,1\n0,", "1", eight_hundred_MB);
  EXPECT_EQ(test::refusal_of<InputError>([&] { return ingest::text::read_csv(row, "f", {{"t"}}); }),
            "f:3: line is longer than 1 MiB, expected a text file of columns; hint: do its rows "
            "end with line ends?");
  EXPECT_LT(row.bytes_read(), 20'000'000U);
}

TEST(TextWindow, ANulByteFarBehindIsToldByItsPlace) {
  std::string text = log_of("\n", 400'000);
  ASSERT_GT(text.size(), 6'000'000U);
  text[5'000'000] = '\0';
  EXPECT_EQ(
      test::refusal_of<InputError>([&] { return ingest::text::read_csv(text, "f", {{"t"}}); }),
      "f: binary data at byte 5000000, expected a text file of columns");
}

TEST(TextWindow, LinesThatEndWithCrAloneAreReadInLinearTime) {
  std::string text = "t,tau\r";
  for (int i = 0; i < 400'000; ++i) text += "0.5,1.25\r";
  EXPECT_EQ(ingest::text::read_csv(text, "f", {{"t"}}).rows, 400'000U);
}

}  // namespace
}  // namespace tribolog::text_window_test
