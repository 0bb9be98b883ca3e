// How rows and columns are written: 11 to 13 and 16 to 26.

#include "cli/input_cases/case_log.h"
#include "cli/input_cases/input_case.h"
#include "cli/small_dataset.h"

namespace tribolog::test {
namespace {

const std::string damaged =
    "damaged rows? [log] skip_bad_rows = true (--skip-bad-rows) leaves them out, up to 1 % of all";
const std::string other_fields = "row has another number of fields than the header, found ";

std::string with_log_table(const std::string& keys) {
  return case_manifest("[columns]", "[log]\n" + keys + "\n[columns]");
}

void take_commas(int /*row*/, Row& fields) {
  for (std::string& field : fields) field[field.find('.')] = ',';
}

std::string with_row_inserted(const std::string& line) {
  return with_line_301(line + "\n14.95,0.695000000,3.139760838");
}

/// Rows of every twentieth to be bad, or a few.
std::string with_short_rows(int every) {
  return case_log([every](int i, Row& fields) {
    if (i % every == every - 1) fields.pop_back();
  });
}

InputCase skipped(InputCase one, const std::string& left_out) {
  one.left_out = left_out;
  one.numbers = Numbers::close;
  return with_manifest(one, with_log_table("skip_bad_rows = true"));
}

const std::string preamble = "Scope export\nStart,132000\nChannels,3\n\n";

/// Counts of 2^20 to a turn, and per mille of 2.5 N·m.
InputCase in_counts_and_per_mille() {
  constexpr double turn_rad = 6.283185307179586;
  InputCase one = with_manifest(
      accepted("22e", "CountsAndPerMille",
               case_log(
                   [](int, Row& row) {
                     row[1] = scaled(row[1], (1 << 20) / turn_rad, 0, 0);
                     row[2] = scaled(row[2], 1000 / 2.5);
                   },
                   "t,q [inc],tau [‰]")),
      replaced(case_manifest("\"tau\", unit = \"Nm\"", "\"tau\", unit = \"0.0025 Nm\""),
               "\"q\", unit = \"rad\"", "\"q\", unit = \"9.5367431640625e-7 turn\""));
  one.numbers = Numbers::close;
  return one;
}

}  // namespace

std::vector<InputCase> dialect_cases() {
  const std::string clean = case_log();
  const std::string missing = "without torque or current nothing can be identified";
  const auto add_column = [](int, Row& row) { row.push_back("7"); };
  const auto add_columns = [](int, Row& row) { row.insert(row.end(), {"7", "ok"}); };
  const std::string commas_between_commas =
      "log.csv:2: numbers with decimal commas between columns that commas separate, found 6 cells "
      "for 3 names, expected semicolons or tabs between the columns, or numbers with a point; "
      "hint: "
      "export it so (Excel: list separator \";\"; pandas: to_csv(..., decimal='.')); ";
  const std::string units_below = "log.csv: units are taken from the row under the header";
  return {
      accepted("11a", "Semicolons", case_log({}, "t;q;tau", ";"),
               "log.csv: columns are separated by semicolons"),
      accepted("11b", "Tabs", case_log({}, "t\tq\ttau", "\t"),
               "log.csv: columns are separated by tabs"),
      accepted("11c", "RunsOfSpaces",
               case_log([](int i, Row& row) { row[2] += std::string(i % 3, ' '); }, "  t q  tau ",
                        "   "),
               "log.csv: columns are separated by spaces"),
      accepted("11d", "SpacesAfterCommas", case_log({}, "t, q, tau", ", ")),
      refused("11e", "AmbiguousDelimiter", "t,q;tau\n0,1;2\n0.1,1;2\n",
              "log.csv:1: it is not clear what separates the columns, expected commas or "
              "semicolons; hint: state it: [log] delimiter = \"comma\", \"semicolon\", \"tab\" or "
              "\"spaces\""),
      refused("12a", "DecimalComma", case_log(take_commas, "t;q;tau", ";"),
              "log.csv:2:1: column 't', found '0,00', expected a number; hint: decimal comma? "
              "state it: [log] decimal_comma = true, --decimal-comma of inspect and init"),
      with_manifest(accepted("12b", "DecimalCommaAsStated", case_log(take_commas, "t;q;tau", ";"),
                             "log.csv: columns are separated by semicolons\n"
                             "log.csv: numbers have a decimal comma"),
                    with_log_table("decimal_comma = true")),
      refused("13a", "DecimalCommaBetweenCommas", case_log(take_commas),
              commas_between_commas +
                  "in every row that was looked at each number is cut in two, which can be mended: "
                  "sed -E '2,$ s/([0-9]+),([0-9]+)/\\1.\\2/g' LOG >POINTS.csv"),
      with_manifest(refused("13b", "DecimalCommaBetweenCommasAsStated", case_log(take_commas),
                            commas_between_commas +
                                "in every row that was looked at each number is cut in two, which "
                                "can be mended: sed -E '2,$ s/([0-9]+),([0-9]+)/\\1.\\2/g' LOG "
                                ">POINTS.csv"),
                    with_log_table("decimal_comma = true")),
      refused("13c", "DecimalCommasOfFractionsAlone", "t,q,tau\n0,01,1,25,3,4\n0,02,1,3,4\n",
              commas_between_commas +
                  "numbers without a fraction have no comma, so that the cells cannot be put "
                  "together again"),
      with_manifest(accepted("16", "QuotedHeader", case_log({}, "\"t\",\"q, of \"\"J1\"\"\",tau")),
                    case_manifest("\"q\"", "\"q, of \\\"J1\\\"\"")),
      refused("17a", "UnclosedQuote", with_line_301("14.95,0.695,\"3.1"),
              "log.csv:301:13: quote is not closed in its line; hint: a line end within quotes is "
              "not supported"),
      refused("17b", "UnclosedQuoteInTheHeader", case_log({}, "t,\"q,tau"),
              "log.csv:1:3: quote is not closed in its line; hint: a line end within quotes is not "
              "supported"),
      refused("17c", "QuoteThatHidesADelimiter", with_line_301("14.95,\"0.695"),
              "log.csv:301:7: quote is not closed in its line; hint: a line end within quotes is "
              "not supported"),
      refused("18", "LineEndWithinQuotes", with_line_301("14.95,\"0.695\n\",3.1"),
              "log.csv:301:7: quote is not closed in its line; hint: a line end within quotes is "
              "not supported"),
      refused("19a", "FewerFields", with_line_301("14.95,0.695"),
              "log.csv:301: " + other_fields + "2, expected 3; hint: " + damaged),
      refused("19b", "MoreFields", with_line_301("14.95,0.695,3,4"),
              "log.csv:301: " + other_fields +
                  "4, expected 3; hint: decimal or thousands commas? "
                  "write numbers with a point; " +
                  damaged),
      skipped(accepted("19c", "BadRowsSkippedAsStated", with_short_rows(200),
                       "log.csv: 4 of 801 rows cannot be used and are left out; the first: "
                       "log.csv:201: " +
                           other_fields + "2, expected 3"),
              "4: cannot be used (skip_bad_rows)"),
      with_manifest(refused("19d", "TooManyBadRows", with_short_rows(20),
                            "log.csv:21: 40 of 801 rows cannot be used, expected no more than 1 %; "
                            "hint: the first: log.csv:21: " +
                                other_fields + "2, expected 3"),
                    with_log_table("skip_bad_rows = true")),
      accepted("20a", "TrailingDelimiter", case_log([](int, Row& row) { row.emplace_back(); }),
               "log.csv: rows end with a delimiter; the empty column is ignored"),
      accepted("20b", "TrailingDelimiterAlsoInTheHeader",
               case_log([](int, Row& row) { row.emplace_back(); }, "t,q,tau,")),
      refused("21a", "NameTwice", case_log({}, "t,q,q"),
              "log.csv:1:5: column name 'q' stands twice, in columns 2 and 3; hint: name the one "
              "that is meant by its position: \"#2\" or \"#3\""),
      with_manifest(accepted("21b", "NameTwiceTakenByPosition", case_log({}, "t,q,q"),
                             "log.csv: column names that occur more than once: 'q'"),
                    replaced(case_manifest("\"q\"", "\"#2\""), "\"tau\"", "\"#3\"")),
      accepted("21c", "OtherNameTwice", case_log(add_columns, "t,q,tau,x,x"),
               "log.csv: column names that occur more than once: 'x'\ncolumns of the logs that are "
               "not used: 'x'"),
      refused("22a", "ColumnMissing", case_log({}, "t,q,current"),
              "log.csv:1: column 'tau' is missing, found 't', 'q', 'current'; hint: " + missing),
      refused("22b", "OtherCase", case_log({}, "t,q,Tau"),
              "log.csv:1: column 'tau' is missing, found 't', 'q', 'Tau'; hint: did you mean "
              "'Tau'? " +
                  missing),
      accepted("22c", "UnitInBrackets", case_log({}, "t [s],q (rad),tau [Nm]")),
      in_counts_and_per_mille(),
      accepted("26d", "LinesInFrontOfTheHeader", preamble + case_log(),
               "log.csv: lines in front of the table: 5, read for its columns' names alone"),
      with_manifest(accepted("26e", "LinesInFrontOfTheHeaderAsStated", preamble + case_log(),
                             "log.csv: 4 lines in front of the header are not read"),
                    with_log_table("header_line = 5")),
      with_manifest(refused("26f", "HeaderBehindTheEnd", case_log(),
                            "log.csv:802: the log ends in front of its header, expected the header "
                            "in line 900; hint: header_line states the line of the columns' names"),
                    with_log_table("header_line = 900")),
      refused("22d", "OtherUnitInBrackets", case_log({}, "t,q,tau [mNm]"),
              "dataset.toml:13:19: unit contradicts the header of the log, found 'Nm', expected "
              "'mNm' as in 'tau [mNm]'"),
      with_manifest(refused("23", "FewerTorquesThanJoints",
                            case_log([](int, Row& row) { row.insert(row.begin() + 1, row[1]); },
                                     "t,q_1,q_2,tau_1"),
                            "log.csv:1: column 'tau_2' is missing, found 't', 'q_1', 'q_2', "
                            "'tau_1'; hint: did you mean 'tau_1'? " +
                                missing),
                    replaced(case_manifest("\"q\"", "\"q_2\""), "\"tau\"", "\"tau_2\"")),
      accepted("24", "UnknownColumns", case_log(add_columns, "t,q,tau,mode,state"),
               "columns of the logs that are not used: 'mode', 'state'"),
      accepted("25a", "CommentsAndBlankLines",
               replaced(replaced(clean, "0.05,", "# a comment\n\n0.05,"), "t,q", "# a log\n\nt,q")),
      refused("25b", "LinesCountWithCommentsAndBlanks",
              replaced(with_line_301("14.95,0.695,fault"), "0.05,", "# a comment\n\n0.05,"),
              "log.csv:303:13: column 'tau', found 'fault', expected a number; hint: " + damaged),
      accepted("25c", "RowOfUnits", replaced(clean, "tau\n", "tau\ns,rad,Nm\n"), units_below),
      accepted("25d", "RowOfUnitsInBrackets", replaced(clean, "tau\n", "tau\n[s],[rad],[N m]\n"),
               units_below),
      refused("25e", "RowOfUnitsThatContradicts", replaced(clean, "tau\n", "tau\nms,rad,Nm\n"),
              "dataset.toml:11:17: unit contradicts the header of the log, found 's', expected "
              "'ms' as in 't'"),
      refused("25f", "RowOfUnknownUnits", replaced(clean, "tau\n", "tau\nticks,inc,raw\n"),
              "log.csv:2:1: column 't', found 'ticks', expected a number; hint: a row of units "
              "under the header? put '#' in front of it"),
      refused("25g", "NoHeader", clean.substr(8),
              "log.csv:1:1: no column names: the first row holds numbers; hint: put a first line "
              "with the columns' names, without '#', or ask for columns by their position: "
              "\"#1\", \"#2\""),
      refused("26a", "HeaderInTheMiddle", with_row_inserted("t,q,tau"),
              "log.csv:301:1: the header stands here again; hint: two logs concatenated? split the "
              "file; " +
                  damaged),
      skipped(accepted("26b", "HeaderInTheMiddleSkippedAsStated", with_row_inserted("t,q,tau"),
                       "log.csv: 1 of 802 rows cannot be used and are left out; the first: "
                       "log.csv:301:1: the header stands here again; hint: two logs concatenated? "
                       "split the file"),
              "1: cannot be used (skip_bad_rows)"),
      refused("26c", "TwoLogsWithTheirHeaders", clean + clean,
              "log.csv:803:1: the header stands here again; hint: two logs concatenated? split the "
              "file; " +
                  damaged),
      refused("26d", "TwoLogsOfOtherColumns", clean + case_log(add_column, "t,q,tau,x"),
              "log.csv:803: " + other_fields +
                  "4, expected 3; hint: decimal or thousands commas? "
                  "write numbers with a point; " +
                  damaged),
  };
}

}  // namespace tribolog::test
