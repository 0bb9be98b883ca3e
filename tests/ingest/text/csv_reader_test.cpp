// Logs that are read, with all their peculiarities.

#include "ingest/text/csv_reader.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/temporary_directory.h"
#include "wording/words.h"

namespace tribolog::csv_reader_test {
namespace {

ingest::text::CsvTable read(std::string_view text,
                            const std::vector<ingest::log::WantedColumn>& columns = {{"t"},
                                                                                     {"tau"}}) {
  return ingest::text::read_csv(text, "run.csv", columns);
}

using Values = std::vector<double>;
using Notes = std::vector<std::string>;

void expect_two_rows(std::string_view text) {
  const ingest::text::CsvTable table = read(text);
  EXPECT_EQ(table.columns.at(0).values, (Values{0, 0.5})) << text;
  EXPECT_EQ(table.columns.at(1).values, (Values{1.25, -3})) << text;
  EXPECT_EQ(table.rows, 2U);
}

TEST(CsvReader, ReadsTheColumnsAskedForInTheOrderAskedFor) {
  const ingest::text::CsvTable table =
      read("t,q,tau,text\n0,7,1.25,a\n0.5,8,-3,b\n", {{"tau"}, {"t"}});
  EXPECT_EQ(table.columns.at(0).values, (Values{1.25, -3}));
  EXPECT_EQ(table.columns.at(1).values, (Values{0, 0.5}));
  EXPECT_EQ(table.header, (std::vector<std::string>{"t", "q", "tau", "text"}));
  EXPECT_TRUE(table.notes.empty());
}

TEST(CsvReader, TakesEveryLineEndAndTheByteOrderMark) {
  expect_two_rows("t,tau\n0,1.25\n0.5,-3\n");
  expect_two_rows("t,tau\r\n0,1.25\r\n0.5,-3\r\n");
  expect_two_rows("t,tau\r0,1.25\r0.5,-3\r");
  expect_two_rows("\xef\xbb\xbft,tau\n0,1.25\n0.5,-3");
  EXPECT_EQ(wording::words(read("t,tau\r\n0,1\n1,2\r\n").notes),
            (Notes{"line ends are mixed (LF, CR LF, CR)"}));
  EXPECT_TRUE(read("t,tau\r\n0,1\r\n").notes.empty());
}

TEST(CsvReader, TakesEveryDelimiterAndStatesIt) {
  expect_two_rows("t;tau\n0;1.25\n0.5;-3\n");
  expect_two_rows("t\ttau\n0\t1.25\n0.5\t-3\n");
  expect_two_rows("t  tau\n0   1.25 \n 0.5 -3\n");
  expect_two_rows("t, tau\n0, 1.25\n 0.5 ,-3 \n");
  EXPECT_EQ(wording::words(read("t;tau\n0;1\n").notes),
            (Notes{"columns are separated by semicolons"}));
}

TEST(CsvReader, SkipsCommentsAndBlankLinesAndKeepsCountOfLines) {
  const ingest::text::CsvTable table =
      read("# a log\n\nt,tau\n# units: s, Nm\n0,1.25\n\n  \n0.5,-3\n1,1\n");
  EXPECT_EQ(table.rows, 3U);
  EXPECT_EQ(table.line_of(0), 5);
  EXPECT_EQ(table.line_of(1), 8);
  EXPECT_EQ(table.line_of(2), 9);
}

TEST(CsvReader, FindsColumnsByNameWithAndWithoutUnit) {
  const ingest::text::CsvTable table = read("\"t [s]\",tau (Nm)\n0,1\n", {{"t"}, {"tau (Nm)"}});
  EXPECT_EQ(table.columns.at(0).header.unit, "s");
  EXPECT_EQ(table.columns.at(1).header.unit, "Nm");
  expect_two_rows("t [s] tau [Nm]\n0 1.25\n0.5 -3\n");  // blanks in the header only
  // As a robot's own logger names them: brackets that are no units.
  EXPECT_EQ(read("time, state.q[0], state.q[1]\n0, 1, 2\n", {{"time"}, {"state.q[1]"}})
                .columns.at(1)
                .values,
            Values{2});
}

TEST(CsvReader, TakesNamesFromACommentAboveTheRows) {
  for (const char* text :
       {"# t tau\n0 1.25\n0.5 -3\n", "# t,tau\n0,1.25\n0.5,-3\n", "# t tau\n0,1.25\n0.5,-3\n",
        "# a log of J3\n#t [s];tau [Nm]\n0;1.25\n0.5;-3\n", "% t,tau\n0,1.25\n0.5,-3\n",
        "// t,tau\n0,1.25\n// more\n0.5,-3\n", "#,t,tau\n1,0,1.25\n2,0.5,-3\n"}) {
    expect_two_rows(text);
  }
  // As rostopic echo -p writes them, with words in the rows.
  expect_two_rows("%t,name,tau\n0,elbow,1.25\n0.5,elbow,-3\n");
  const ingest::text::CsvTable table = read("# t,tau\n# s,Nm\n0,1.25\n0.5,-3\n");
  EXPECT_EQ(table.columns.at(1).header.unit, "Nm");
  EXPECT_EQ(wording::words(table.notes),
            Notes{"column names are taken from the comment above the rows"});
  // What may be a sentence names no columns.
  EXPECT_THROW((void)read("# speed and tau\n0 1 1.25\n0.5 1 -3\n"), InputError);
}

TEST(CsvReader, TakesTheDelimiterThatALogStatesForExcel) {
  expect_two_rows("sep=;\nt;tau\n0;1.25\n0.5;-3\n");
  expect_two_rows("\xef\xbb\xbf\"sep=,\"\r\nt,tau\r\n0,1.25\r\n0.5,-3\r\n");
  expect_two_rows("sep=\t\nt\ttau\n0\t1.25\n0.5\t-3\n");
}

TEST(CsvReader, NamesRowsOfJointStates) {
  const std::string rows =
      "17,500000000,base,elbow,wrist,0.5,1,2,3,4,5\n18,0,base,elbow,wrist,0.6,1,2,3,4,6\n";
  const auto table = read(rows, {{"nanosec"}, {"elbow.position"}, {"wrist.effort"}});
  EXPECT_EQ(table.columns.at(0).values, (Values{5e8, 0}));
  EXPECT_EQ(table.columns.at(1).values, (Values{0.5, 0.6}));
  EXPECT_EQ(table.columns.at(2).values, (Values{5, 6}));
  // A row of words and numbers is no header of whatever log.
  const auto named = read("elbow,0.5,1\nelbow,0.75,2\n", {});
  EXPECT_EQ(named.rows, 2U);
  EXPECT_EQ(named.header, (std::vector<std::string>{"#1", "#2", "#3"}));
  EXPECT_EQ(read("t,1,2\n0,0.5,1\n", {{"2"}}).rows, 1U) << "joints may be called by numbers";
  // Of two numbers for each joint it does not show which are there.
  const auto two = read("17,0,,elbow,0.5,1\n18,0,,elbow,0.6,2\n", {});
  EXPECT_EQ(two.header,
            (std::vector<std::string>{"sec", "nanosec", "frame_id", "name_0", "#5", "#6"}));
}

TEST(CsvReader, ReadsTimesOfDayDatesAndWords) {
  using enum ingest::log::ColumnReading;
  const std::string log =
      "d;t;w\n2026-03-01;23:59:59.5;up\n2026-03-02;0:00:01,25;down\n"
      "2026-03-02;00:00:02;up\n";
  const auto table = read(log, {{"t", "", time_of_day}, {"d", "", date}, {"w", "", words}});
  EXPECT_EQ(table.columns.at(0).values, (Values{86399.5, 1.25, 2}));
  EXPECT_EQ(table.columns.at(1).values, (Values{0, 86400, 86400}));
  EXPECT_EQ(table.columns.at(2).values, (Values{0, 1, 0}));
  EXPECT_EQ(table.columns.at(2).words, (std::vector<std::string>{"up", "down"}));
  const auto all = read(log, {});
  EXPECT_EQ(all.columns.at(0).reading, date);
  EXPECT_EQ(all.columns.at(1).reading, time_of_day);
}

TEST(CsvReader, TellsDecimalCommasThatAreBeyondDoubt) {
  const auto shows = [](std::string_view text) {
    MemorySource source(text);
    return ingest::text::shows_decimal_commas(source, "run.csv");
  };
  EXPECT_TRUE(shows("t;q\n0,1;2\n0,25;3\n"));
  EXPECT_TRUE(shows("t q\n0 -0,123\n1 2,5\n"));
  EXPECT_TRUE(shows("0,1\t2,55\n0,2\t2,75\n")) << "without names";
  EXPECT_FALSE(shows("t;q\n1;2,500\n2;3,125\n")) << "thousands?";
  EXPECT_FALSE(shows("t;q\n0,1;2.5\n0,25;3\n")) << "both";
  EXPECT_FALSE(shows("t,q\n0,1\n1,25\n")) << "two columns";
  EXPECT_FALSE(shows("0,1\n1,25\n"));
  EXPECT_FALSE(shows("t, q\n0, 1\n1, 25\n"));
}

TEST(CsvReader, CountsGapsByColumn) {
  const ingest::text::CsvTable signs = read("t,tau\n0,-\n#N/A,1\n1,--\n2,3\n");
  EXPECT_EQ(signs.columns.at(0).gaps, 1U) << "no comment";
  EXPECT_EQ(signs.columns.at(1).gaps, 2U);
  EXPECT_EQ(read("t,tau\n0,1\n1,-").cut_rows, 1U) << "a number may have been about to come";
  const ingest::text::CsvTable table = read("t,tau,x\n0,nan,\n1,,\n,3,\n3,inf,\n4,5,\n");
  EXPECT_EQ(table.columns.at(0).gaps, 1U);
  EXPECT_EQ(table.columns.at(1).gaps, 3U);
  EXPECT_TRUE(std::isnan(table.columns.at(1).values.at(3)));
  EXPECT_EQ(table.columns.at(1).values.at(4), 5);
  EXPECT_EQ(table.rows, 5U);
}

TEST(CsvReader, ReadsQuotedFields) {
  expect_two_rows("\"t\",\"a, b\",tau\n\"0\",\"x, y\",1.25\n0.5,,\"-3\"\n");
}

TEST(CsvReader, IgnoresADelimiterAfterTheLastColumn) {
  expect_two_rows("t,tau,\n0,1.25,\n0.5,-3,\n");
  expect_two_rows("t,tau,\n0,1.25\n0.5,-3\n");
  expect_two_rows("t,tau\n0,1.25,\n0.5,-3,\n");
  EXPECT_EQ(wording::words(read("t,tau\n0,1.25,\n0.5,-3,\n").notes),
            (Notes{"rows end with a delimiter; the empty column is ignored"}));
}

TEST(CsvReader, LeavesOutALastRowThatIsCutOff) {
  for (const char* rest : {"2", "2,", "2,-", "2,1.5e", "2,\"1", "2,n"}) {
    const ingest::text::CsvTable table =
        read(std::string("t,x,tau\n0,0,1.25\n0.5,0,-3\n2,") + rest);
    EXPECT_EQ(table.rows, 2U) << rest;
    EXPECT_EQ(table.cut_rows, 1U) << rest;
    ASSERT_EQ(table.notes.size(), 1U) << rest;
  }
  EXPECT_EQ(wording::words(read("t,tau\n0,1\n2").notes),
            (Notes{"file ends inside a row at byte 11 (log truncated?); the row is left out"}));
  EXPECT_EQ(read("t,tau\n0,1\n2,3").cut_rows, 0U) << "only the line end is missing";
}

ingest::text::TextLogRules with_decimal_comma() {
  ingest::text::TextLogRules rules;
  rules.decimal_mark = ingest::text::DecimalMark::comma;
  return rules;
}

TEST(CsvReader, ReadsDecimalCommasWhereTheyAreStated) {
  for (const char* text :
       {"t;tau\n0;1,25\n0,5;-3\n", "t\ttau\n0\t1,25\n0,5\t-3,0\n", "t tau\n0 1,25\n5e-1 -3\n"}) {
    const ingest::text::CsvTable table =
        ingest::text::read_csv(text, "run.csv", {{"t"}, {"tau"}}, with_decimal_comma());
    EXPECT_EQ(table.columns.at(0).values, (Values{0, 0.5})) << text;
    EXPECT_EQ(table.columns.at(1).values, (Values{1.25, -3})) << text;
  }
  EXPECT_EQ(
      ingest::text::read_csv("tau\n1,25\n", "f", {{"tau"}}, with_decimal_comma()).columns[0].values,
      Values{1.25});
}

TEST(CsvReader, TakesTheDelimiterThatIsStated) {
  ingest::text::TextLogRules rules;
  rules.delimiter = ingest::text::Delimiter::semicolon;
  // As many commas as semicolons: unstated, nobody can tell.
  const ingest::text::CsvTable table =
      ingest::text::read_csv("a,b;tau\n1,2;3\n", "f", {{"tau"}}, rules);
  EXPECT_EQ(table.columns[0].values, Values{3});
}

TEST(CsvReader, TakesColumnsByTheirPosition) {
  const ingest::text::CsvTable headless = read("0,7,1.25\n0.5,8,-3\n", {{"#3"}, {"#1"}});
  EXPECT_EQ(headless.columns.at(0).values, (Values{1.25, -3}));
  EXPECT_EQ(headless.columns.at(1).values, (Values{0, 0.5}));
  EXPECT_EQ(headless.rows, 2U);
  EXPECT_EQ(headless.line_of(0), 1);
  EXPECT_EQ(wording::words(headless.notes),
            (Notes{"no column names; columns are taken by their position"}));
  EXPECT_EQ(read("t,q,tau\n0,7,1.25\n", {{"#3"}}).columns.at(0).values, Values{1.25});
  EXPECT_EQ(read("# t q tau\n\n0 7 1.25\n", {{"#3"}}).columns.at(0).values, Values{1.25});
}

TEST(CsvReader, TakesUnitsFromARowUnderTheHeader) {
  const ingest::text::CsvTable table = read("t,q,tau\n[ms],,Nm\n0,7,1.25\n", {{"t"}, {"tau"}});
  EXPECT_EQ(table.columns.at(0).header.unit, "ms");
  EXPECT_EQ(table.columns.at(1).header.unit, "Nm");
  EXPECT_EQ(table.rows, 1U);
  EXPECT_EQ(table.line_of(0), 3);
  EXPECT_EQ(wording::words(table.notes), (Notes{"units are taken from the row under the header"}));
}

TEST(CsvReader, ReadsEveryColumnOfNumbersWhereNoneIsAskedFor) {
  const ingest::text::CsvTable table = read(
      "when,state,q,empty,tau\n2026-03-01T08:15:00Z,run,1,,nan\n2026-03-01T08:15:01Z,stop,2,,3\n",
      {});
  ASSERT_EQ(table.columns.size(), 4U);
  EXPECT_EQ(table.columns[0].header.name, "when");
  EXPECT_EQ(table.columns[0].values, (Values{0, 1}));
  EXPECT_EQ(table.columns[1].words, (std::vector<std::string>{"run", "stop"}));
  EXPECT_EQ(table.columns[1].values, (Values{0, 1}));
  EXPECT_EQ(table.columns[2].header.name, "q");
  EXPECT_EQ(table.columns[3].values[1], 3);
  EXPECT_EQ(wording::words(table.notes),
            (Notes{"columns that hold no numbers are not read: 'empty'"}));
  EXPECT_EQ(read("0 1 2\n3 4 5\n", {}).columns.size(), 3U);
}

TEST(CsvReader, KeepsTheNanosecondsOfAClockThatCountsFrom1970) {
  std::vector<ingest::log::WantedColumn> time = {{"t", "", ingest::log::ColumnReading::clock}};
  const ingest::text::CsvTable ns =
      read("t\n1700000000123456789\n1700000000123456790\nnan\n", time);
  EXPECT_EQ(ns.columns[0].values[1] - ns.columns[0].values[0], 1);
  EXPECT_EQ(ns.columns[0].origin, 1700000000123456789.0);
  EXPECT_EQ(ns.columns[0].gaps, 1U);
  const ingest::text::CsvTable s = read("t\n1700000000.25\n1.70000000075e9\n", time);
  EXPECT_EQ(s.columns[0].values, (Values{0.25, 0.75}));
  const ingest::text::CsvTable own = read("t\n0.1\n1.1\n", time);
  EXPECT_EQ(own.columns[0].values, (Values{0.1, 1.1}));
  EXPECT_EQ(own.columns[0].origin, 0);
}

TEST(CsvReader, ReadsIsoTimes) {
  const std::vector<ingest::log::WantedColumn> wanted = {
      {"t", "", ingest::log::ColumnReading::iso_time}, {"tau"}};
  const ingest::text::CsvTable table =
      read("t,tau\n2026-03-01T08:15:00.250Z,1\n,2\n2026-03-01T08:15:01Z,3\n2026-03-01T08:15:02Z,4",
           wanted);
  EXPECT_EQ(table.columns[0].values[0], 0.25);
  EXPECT_TRUE(std::isnan(table.columns[0].values[1]));
  EXPECT_EQ(table.columns[0].values[2], 1);
  EXPECT_EQ(table.columns[0].values[3], 2);
  EXPECT_EQ(read("2026-03-01T08:15:00Z,1\n2026-03-01T08:15:09Z,3\n",
                 {{"#1", "", ingest::log::ColumnReading::iso_time}})
                .columns[0]
                .values[1],
            9);
}

TEST(CsvReader, LeavesOutBadRowsWhereThatIsStated) {
  ingest::text::TextLogRules rules;
  rules.skip_bad_rows = true;
  std::string text = "t,q,tau\n";
  for (int i = 0; i < 1000; ++i) text += std::to_string(i) + ",0,1\n";
  const auto with = [&](const std::string& bad) {
    std::string log = text;
    return log.insert(log.find("500,0,1\n"), bad);
  };
  for (const char* bad : {"499.5,0\n", "499.5,0,1,2\n", "499.5,0,fault\n", "499.5,0,1e999\n",
                          "499.5,\"0,1\n", "t,q,tau\n"}) {
    const ingest::text::CsvTable table =
        ingest::text::read_csv(with(bad), "f", {{"t"}, {"tau"}}, rules);
    EXPECT_EQ(table.rows, 1000U) << bad;
    EXPECT_EQ(table.bad_rows, 1U) << bad;
    EXPECT_EQ(table.columns[0].values[500], 500) << bad;
    EXPECT_EQ(table.line_of(499), 501) << bad;
    EXPECT_EQ(table.line_of(500), 503) << bad;
    ASSERT_EQ(table.notes.size(), 1U) << bad;
    EXPECT_EQ(wording::words(table.notes[0])
                  .find("1 of 1001 rows cannot be used and are left out; the first: f:502"),
              0U)
        << wording::words(table.notes[0]);
  }
  std::string many;
  for (int i = 0; i < 11; ++i) many += "499.5,0\n";
  EXPECT_EQ(test::refusal_of<InputError>(
                [&] { return ingest::text::read_csv(with(many), "f", {{"t"}, {"tau"}}, rules); }),
            "f:502: 11 of 1011 rows cannot be used, expected no more than 1 %; hint: the first: "
            "f:502: row has another number of fields than the header, found 2, expected 3");
}

TEST(CsvReader, ReadsNamesAndUnitsInLatin1WhereThatIsStated) {
  ingest::text::TextLogRules rules;
  rules.encoding = ingest::text::TextEncoding::latin1;
  const ingest::text::CsvTable table =
      ingest::text::read_csv("t,\xe4ngle [\xb0]\n0,1\n", "f", {{"t"}, {"\u00e4ngle"}}, rules);
  EXPECT_EQ(table.columns[1].header.full, "\u00e4ngle [\u00b0]");
  EXPECT_EQ(table.columns[1].header.unit, "\u00b0");
  const ingest::text::CsvTable below =
      ingest::text::read_csv("t,q\n\xb5s,\xb0\n0,1\n", "f", {{"t"}, {"q"}}, rules);
  EXPECT_EQ(below.columns[0].header.unit, "\u00b5s");
}

TEST(CsvReader, NamesThatStandTwiceMatterOnlyWhereTheyAreAskedFor) {
  const std::string log = "t,x,tau,x\n0,1,2,3\n";
  const ingest::text::CsvTable table = read(log);
  EXPECT_EQ(table.columns.at(1).values, Values{2});
  EXPECT_EQ(wording::words(table.notes), (Notes{"column names that occur more than once: 'x'"}));
  EXPECT_EQ(read(log, {{"#4"}}).columns.at(0).values, Values{3});
  EXPECT_EQ(read(log, {}).columns.size(), 4U);
}

TEST(CsvReader, TakesNumbersTooSmallForADoubleAsZero) {
  EXPECT_EQ(read("t,tau\n1e-400,-1e-999\n").columns.at(0).values, Values{0});
}

}  // namespace
}  // namespace tribolog::csv_reader_test
