// Logs that are refused, each with one clear line.

#include <gtest/gtest.h>

#include "base/temporary_directory.h"
#include "ingest/text/csv_reader.h"

namespace tribolog::csv_refusal_test {
namespace {

using namespace std::string_view_literals;

struct Case {
  const char* name;
  std::string_view text;
  std::string said;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

const std::string damaged =
    "damaged rows? [log] skip_bad_rows = true (--skip-bad-rows) leaves them out, up to 1 % of all";

class RefusedLog : public testing::TestWithParam<Case> {};

TEST_P(RefusedLog, SaysWhereAndWhy) {
  const std::string said = test::refusal_of<InputError>([] {
    return ingest::text::read_csv(GetParam().text, "run.csv", {{"t"}, {"tau", "it is needed"}});
  });
  EXPECT_EQ(said, GetParam().said);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, RefusedLog,
    testing::Values(
        Case{"Empty", "", "run.csv: file is empty"},
        Case{"OnlyAByteOrderMark", "\xef\xbb\xbf", "run.csv: file is empty"},
        Case{"OnlyComments", "# nothing\n\n", "run.csv: no header row"},
        Case{"HeaderOnly", "t,tau\n", "run.csv:1: no data rows"},
        Case{"Utf16", "\xff\xfet\0,\0"sv,
             "run.csv: looks like UTF-16 (byte 0), expected a text file of columns; hint: convert "
             "it: iconv -f UTF-16 -t UTF-8"},
        Case{"Utf16WithoutMark", "t\0,\0t\0a\0"sv,
             "run.csv: looks like UTF-16 (byte 0), expected a text file of columns; hint: convert "
             "it: iconv -f UTF-16 -t UTF-8"},
        Case{"Gzip", "\x1f\x8b\x08",
             "run.csv: is a binary file: gzip, expected a text file of columns; hint: export or "
             "unpack it as CSV"},
        Case{"Mcap", "\x89MCAP0\r\n",
             "run.csv: is a binary file: MCAP, expected a text file of columns; hint: export or "
             "unpack it as CSV"},
        Case{"ULog", "ULog\x01\x12\x35\x01\0\0"sv,
             "run.csv: is a binary file: ULog (PX4), expected a text file of columns; hint: pip "
             "install pyulog; ulog2csv LOG"},
        Case{
            "ZarrMetadata", "{\n  \"zarr_format\": 2\n}",
            "run.csv: is a file of a Zarr store, not a log; hint: in a Python with zarr (pip "
            "install zarr): python3 -c \"import numpy, zarr; numpy.savez('LOG.npz', **{n: a[:] for "
            "n, a in zarr.open_group('LOG', mode='r').arrays()})\""},
        Case{"Rerun", "RRF2\0\x29\0\0\1\2\0\0"sv,
             "run.csv: is a binary file: Rerun (.rrd), expected a text file of columns; hint: in a "
             "Python with rerun (pip install 'rerun-sdk[catalog]'): python3 -c \"import os; from "
             "rerun.server import Server; s = Server(datasets={'log': [os.path.abspath('LOG')]}); "
             "d = s.client().get_dataset('log'); n = sorted((i.name for i in "
             "d.schema().index_columns()), key=lambda n: n.startswith('log_'))[0]; "
             "d.reader(index=n).to_pandas().map(lambda v: v.total_seconds() if hasattr(v, "
             "'total_seconds') else v[0] if hasattr(v, 'shape') and v.shape else "
             "v).to_csv('LOG.csv', index=False)\""},
        Case{"NulByte", "t,tau\n0,1\n\0,2\n"sv,
             "run.csv: binary data at byte 10, expected a text file of columns"},
        Case{"Latin1", "t,tau,\xb5\n0,1,2\n",
             "run.csv:1:7: column name is not UTF-8, found byte 0xB5; hint: Latin-1? "
             "--latin1 of inspect and init reads it; in a manifest [log] encoding = \"latin1\""},
        Case{"NoHeader", "0,1\n1,2\n",
             "run.csv:1:1: no column names: the first row holds numbers; hint: put a first line "
             "with the columns' names, without '#', or ask for columns by their position: "
             "\"#1\", \"#2\""},
        Case{"WordsInAComment", "# a log\n0 1\n1 2\n",
             "run.csv:2:1: no column names: the first row holds numbers; hint: put a first line "
             "with the columns' names, without '#', or ask for columns by their position: "
             "\"#1\", \"#2\""},
        Case{"MissingColumn", "t,Tau_3,q\n0,1,2\n",
             "run.csv:1: column 'tau' is missing, found 't', 'Tau_3', 'q'; hint: did you mean "
             "'Tau_3'? it is needed"},
        Case{"NothingLikeTheColumn", "t,q\n0,1\n",
             "run.csv:1: column 'tau' is missing, found 't', 'q'; hint: it is needed"},
        Case{"AmbiguousColumn", "t,tau [Nm],tau [mNm]\n0,1,2\n",
             "run.csv:1: column 'tau' is ambiguous, found 't', 'tau [Nm]', 'tau [mNm]'; hint: name "
             "it with what stands in its brackets, or by its position: \"#2\""},
        Case{"NameTwice", "t,tau,q,tau\n0,1,2,3\n",
             "run.csv:1:9: column name 'tau' stands twice, in columns 2 and 4; hint: name the one "
             "that "
             "is meant by its position: \"#2\" or \"#4\""},
        Case{"Text", "t,tau\n0,1\n0.5,fault\n",
             "run.csv:3:5: column 'tau', found 'fault', expected a number; hint: " + damaged},
        Case{"TerminalEscape", "t,tau\n0,1\n0.5,\x1b[31m\n",
             R"(run.csv:3:5: column 'tau', found '\x1b[31m', expected a number; hint: )" + damaged},
        Case{"RowOfUnits", "t,tau\nticks,raw\n0,1\n",
             "run.csv:2:1: column 't', found 'ticks', expected a number; hint: a row of units "
             "under the "
             "header? put '#' in front of it"},
        Case{"DecimalComma", "t;tau\n0;1\n1;1,25\n",
             "run.csv:3:3: column 'tau', found '1,25', expected a number; hint: decimal comma? "
             "state it: [log] decimal_comma = true, --decimal-comma of inspect and init"},
        Case{"DecimalCommaBetweenCommas", "t,tau\n0,1\n0,5,1,25\n",
             "run.csv:3: row has another number of fields than the header, found 4, expected 2; "
             "hint: decimal or thousands commas? write numbers with a point; " +
                 damaged},
        Case{"ThousandsSeparator", "t;tau\n0;1\n1;1 234.5\n",
             "run.csv:3:3: column 'tau', found '1 234.5', expected a number; hint: thousands "
             "separators? write numbers without"},
        Case{"Hexadecimal", "t,tau\n0,1\n1,0x1p3\n",
             "run.csv:3:3: column 'tau', found '0x1p3', expected a number; hint: " + damaged},
        Case{"FortranExponent", "t,tau\n0,1\n1,1d3\n",
             "run.csv:3:3: column 'tau', found '1d3', expected a number; hint: " + damaged},
        Case{"Overflow", "t,tau\n0,1\n1,-1e400\n",
             "run.csv:3:3: column 'tau': number is too large, found '-1e400'; hint: " + damaged},
        Case{"ShortRow", "t,q,tau\n0,1,2\n1,2\n2,3,4\n",
             "run.csv:3: row has another number of fields than the header, found 2, expected 3; "
             "hint: " +
                 damaged},
        Case{"LongRow", "t;tau\n0;1\n1;2;3\n",
             "run.csv:3: row has another number of fields than the header, found 3, expected 2; "
             "hint: " +
                 damaged},
        Case{"HeaderAgain", "t,tau\n0,1\nt,tau\n0,1\n",
             "run.csv:3:1: the header stands here again; hint: two logs concatenated? split the "
             "file; " +
                 damaged},
        Case{"UnclosedQuote", "t,tau\n0,\"1\n1,2\n",
             "run.csv:2:3: quote is not closed in its line; hint: a line end within quotes is not "
             "supported"},
        Case{"OnlyACutRow", "t,tau\n0", "run.csv:2: no data rows"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(CsvReader, RefusesWhatContradictsTheStatedRules) {
  ingest::text::TextLogRules comma;
  comma.decimal_mark = ingest::text::DecimalMark::comma;
  EXPECT_EQ(test::refusal_of<InputError>([&] {
              return ingest::text::read_csv("t;tau\n0;1\n1;1.25\n", "f", {{"t"}, {"tau"}}, comma);
            }),
            "f:3:3: column 'tau', found '1.25', expected a number with a decimal comma; hint: " +
                damaged);
  EXPECT_EQ(test::refusal_of<InputError>([&] {
              return ingest::text::read_csv("t;tau\n0;1\n1;1,234,5\n", "f", {{"t"}, {"tau"}},
                                            comma);
            }),
            "f:3:3: column 'tau', found '1,234,5', expected a number with a decimal comma; hint: " +
                damaged);
  EXPECT_EQ(test::refusal_of<InputError>(
                [&] { return ingest::text::read_csv("t,tau\n0,1\n", "f", {{"#3"}}); }),
            "f:1: there is no column '#3', found 2 columns");
  EXPECT_EQ(test::refusal_of<InputError>([&] {
              return ingest::text::read_csv("t,tau\n12:30,1\n", "f",
                                            {{"t", "", ingest::log::ColumnReading::iso_time}});
            }),
            "f:2:1: column 't', found '12:30', expected a time such as 2026-03-01T08:15:00.25Z; "
            "hint: a row of units under the header? put '#' in front of it");
}

TEST(CsvReader, RefusesAColumnAskedForTwice) {
  EXPECT_EQ(test::refusal_of<InputError>(
                [] { return ingest::text::read_csv("t,tau\n0,1\n", "f", {{"t"}, {"t"}}); }),
            "f:1:1: column 't' is asked for twice");
}

}  // namespace
}  // namespace tribolog::csv_refusal_test
