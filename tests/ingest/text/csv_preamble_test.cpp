// Words in front of a log's table, among its rows and behind them.

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/temporary_directory.h"
#include "ingest/text/csv_reader.h"
#include "wording/words.h"

namespace tribolog::csv_preamble_test {
namespace {

using Values = std::vector<double>;

ingest::text::CsvTable read(const std::string& text,
                            const std::vector<ingest::log::WantedColumn>& columns,
                            ingest::text::DecimalMark mark = ingest::text::DecimalMark::point) {
  ingest::text::TextLogRules rules;
  rules.decimal_mark = mark;
  return ingest::text::read_csv(text, "run.csv", columns, rules);
}

bool is_said(const std::string& part, const ingest::text::CsvTable& table) {
  const std::vector<std::string> notes = wording::words(table.notes);
  return std::any_of(notes.begin(), notes.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

std::string with_commas(std::string number) {
  const std::size_t point = number.find('.');
  if (point != std::string::npos) number[point] = ',';
  return number;
}

constexpr int rows = 12;
double angle_deg(int i) { return 0.25 * i - 1; }
double torque_Nm(int i) { return 1.5 - 0.125 * i; }

void expect_the_rows(const ingest::text::CsvTable& table) {
  ASSERT_EQ(table.columns.size(), 3U);
  ASSERT_EQ(table.rows, static_cast<std::size_t>(rows));
  for (std::size_t i = 0; i < rows; ++i) {
    const int k = static_cast<int>(i);
    EXPECT_EQ(table.columns[0].values[i], 4.0 * k) << i;
    EXPECT_EQ(table.columns[1].values[i], angle_deg(k)) << i;
    EXPECT_EQ(table.columns[2].values[i], torque_Nm(k)) << i;
  }
}

/// An export of TwinCAT Scope: properties of the file, properties of each channel in pairs, pairs
/// of a time and a value, and "EOF".
std::string scope_export(bool has_commas, const std::string& line_end = "\r\n") {
  std::string text = "\xef\xbb\xbf";
  const auto line = [&](const std::string& fields) { text += fields + line_end; };
  const auto number = [&](double value) {
    const std::string digits = fmt::format("{:.3f}", value);
    return has_commas ? with_commas(digits) : digits;
  };
  line("Name\tScope Project_AutoSave");
  line("File\tD:\\scope\\Project.csv");
  line("Starttime of export\t133238090039920000\tMontag, 20. März 2023\t19:03:23.992");
  line("");
  line("Name\tActPos\tName\tActTorque");
  line("SymbolComment\t\tSymbolComment\t");
  line("Data-Type\tREAL64\tData-Type\tREAL64");
  line("SampleTime[ms]\t4\tSampleTime[ms]\t4");
  line("VariableSize\t8\tVariableSize\t8");
  line("Unit\tdeg\tUnit\tNm");
  line("Port\t501\tPort\t501");
  line("");
  for (int i = 0; i < rows; ++i) {
    line(fmt::format("{0}\t{1}\t{0}\t{2}", 4 * i, number(angle_deg(i)), number(torque_Nm(i))));
  }
  line("EOF");
  return text;
}

TEST(Preamble, OfTwinCatScopeNamesAChannelInEachPair) {
  using enum ingest::text::DecimalMark;
  for (const ingest::text::DecimalMark mark : {point, comma}) {
    const ingest::text::CsvTable table =
        read(scope_export(mark == comma), {{"#1"}, {"ActPos"}, {"ActTorque"}}, mark);
    expect_the_rows(table);
    EXPECT_EQ(table.columns[0].header.full, "time [ms]");
    EXPECT_EQ(table.columns[0].header.unit, "ms");
    EXPECT_EQ(table.columns[1].header.unit, "deg");
    EXPECT_EQ(table.columns[2].header.unit, "Nm");
    EXPECT_EQ(table.line_of(0), 13) << "lines count from the file's first";
    EXPECT_TRUE(is_said("lines in front of the table: 12", table));
    EXPECT_TRUE(is_said("lines of words among the rows: 1, left out; the first is 'EOF'", table));
    EXPECT_EQ(table.remark_rows, 1U);
  }
}

/// LabVIEW's .lvm: properties of the file and of its channels, then names, of which the last is
/// that of a remark that no row has.
std::string labview_file(const std::string& first_property) {
  std::string text =
      "LabVIEW Measurement\t\nWriter_Version\t2\nSeparator\tTab\nDecimal_Separator\t.\n"
      "Multi_Headings\tNo\nX_Columns\tOne\nDate\t2024/03/20\nTime\t19:03:23.992\n"
      "***End_of_Header***\t\n\t\nChannels\t2\t\t\nSamples\t12\t12\t\n";
  text += first_property;
  text +=
      "Y_Unit_Label\tdeg\tNm\t\nX_Dimension\tTime\tTime\t\nX0\t0.0E+0\t0.0E+0\t\n"
      "Delta_X\t4.0\t4.0\t\n***End_of_Header***\t\t\t\nX_Value\tposition\ttorque\tComment\n";
  for (int i = 0; i < rows; ++i) {
    text += fmt::format("{:.6f}\t{:.6f}\t{:.6f}\n", 4.0 * i, angle_deg(i), torque_Nm(i));
  }
  return text;
}

TEST(Preamble, OfLabViewHasNamesAboveAndUnitsFurtherAbove) {
  for (const char* property : {"", "Date\t2024/03/20\t2024/03/20\t\n"}) {
    const ingest::text::CsvTable table =
        read(labview_file(property), {{"X_Value"}, {"position"}, {"torque"}});
    expect_the_rows(table);
    EXPECT_EQ(table.columns[0].header.unit, "s");
    EXPECT_EQ(table.columns[1].header.unit, "deg");
    EXPECT_EQ(table.columns[2].header.unit, "Nm");
  }
}

TEST(Preamble, OfABoardsGreetingIsPassed) {
  std::string text = "Booting firmware 1.2\nhoming joint 3 ... done\nready\nt,q,tau\nms,deg,Nm\n";
  for (int i = 0; i < rows; ++i) {
    text += fmt::format("{},{},{}\n", 4 * i, angle_deg(i), torque_Nm(i));
  }
  const ingest::text::CsvTable table = read(text, {{"t"}, {"q"}, {"tau"}});
  expect_the_rows(table);
  EXPECT_EQ(table.columns[0].header.unit, "ms");
  EXPECT_EQ(table.columns[2].header.unit, "Nm");
}

TEST(Preamble, OfAPlainLogIsNone) {
  for (const char* header : {"t,q,tau\n", "t,q,tau\ns,deg,Nm\n", "t [ms],q,tau\n"}) {
    std::string text = header;
    for (int i = 0; i < rows; ++i) {
      text += fmt::format("{},{},{}\n", 4 * i, angle_deg(i), torque_Nm(i));
    }
    const ingest::text::CsvTable table = read(text, {{"t"}, {"q"}, {"tau"}});
    expect_the_rows(table);
    EXPECT_FALSE(is_said("lines in front of", table)) << header;
    EXPECT_EQ(table.line_of(0), std::string(header).find("Nm") == std::string::npos ? 2 : 3);
  }
}

/// What is wrong with a header is told, not passed over as words in front of a table.
TEST(Preamble, OfAHeaderThatDoesNotFitIsNone) {
  for (const char* header : {"t,q,tau,more\n", "t,\"q,tau\n", "t,q,tau\nticks,deg,percent\n"}) {
    std::string text = header;
    for (int i = 0; i < rows; ++i) {
      text += fmt::format("{},{},{}\n", 4 * i, angle_deg(i), torque_Nm(i));
    }
    const std::string refused =
        test::refusal_of<InputError>([&] { read(text, {{"t"}, {"q"}, {"tau"}}); });
    EXPECT_TRUE(refused.starts_with("run.csv:1") || refused.starts_with("run.csv:2")) << refused;
  }
}

TEST(Remarks, BetweenRowsAreLeftOutAndCounted) {
  std::string text = "t,q,tau\n";
  for (int i = 0; i < rows; ++i) {
    text += fmt::format("{},{},{}\n", 4 * i, angle_deg(i), torque_Nm(i));
    if (i == 3) text += "homing done\n";
    if (i == 7) text += "warning: supply low, going on\n";
  }
  text += "EOF\n";
  const ingest::text::CsvTable table = read(text, {{"t"}, {"q"}, {"tau"}});
  expect_the_rows(table);
  EXPECT_EQ(table.remark_rows, 3U);
  EXPECT_EQ(table.bad_rows, 0U);
  ASSERT_EQ(table.notes.size(), 1U);
  EXPECT_EQ(wording::words(table.notes.front()),
            "lines of words among the rows: 3, left out; the first is 'homing done'");
  EXPECT_EQ(table.line_of(4), 7) << "behind a remark";
}

TEST(Remarks, AreNoRowsThatHoldANumberOrEveryColumn) {
  const auto refused = [](const std::string& row) {
    const std::string text = "t,q,tau\n0,1,2\n4,1,2\n8,1,2\n" + row + "\n12,1,2\n16,1,2\n";
    return test::refusal_of<InputError>([&] { read(text, {{"t"}, {"q"}, {"tau"}}); });
  };
  EXPECT_NE(refused("fault 17").find("run.csv:5"), std::string::npos) << refused("fault 17");
  EXPECT_NE(refused("12,fault").find("run.csv:5"), std::string::npos) << refused("12,fault");
  EXPECT_NE(refused("no,such,number").find("run.csv:5"), std::string::npos)
      << refused("no,such,number");
}

}  // namespace
}  // namespace tribolog::csv_preamble_test
