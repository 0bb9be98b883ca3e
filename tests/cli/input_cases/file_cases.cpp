// What a file is: 1 to 10, 40, 42, 43.

#include <filesystem>

#include <sys/stat.h>
#include <unistd.h>

#include "cli/input_cases/case_log.h"
#include "cli/input_cases/input_case.h"
#include "cli/small_dataset.h"

namespace tribolog::test {
namespace {

using namespace std::string_literals;

std::string utf16(const std::string& text, bool is_little) {
  std::string bytes = is_little ? "\xff\xfe" : "\xfe\xff";
  for (const char c : text) bytes += is_little ? std::string{c, '\0'} : std::string{'\0', c};
  return bytes;
}

InputCase with_log(InputCase one, const std::function<void(const std::string& path)>& make) {
  one.prepare = [make](const ScratchDirectory& scratch) {
    std::filesystem::remove(scratch.file("log.csv"));
    make(scratch.file("log.csv"));
  };
  return one;
}

/// As somebody who may not: root may read everything.
InputCase without_permission() {
  InputCase one =
      with_log(refused("1c", "NoPermission", "", "log.csv: cannot open: Permission denied"),
               [](const std::string& path) {
                 const std::filesystem::path directory = std::filesystem::path(path).parent_path();
                 (void)run_shell("echo secret > '" + path + "'; chmod 000 '" + path +
                                 "'; chmod 777 '" + directory.string() + "'");
               });
  if (geteuid() == 0) one.environment = "setpriv --reuid=65534 --regid=65534 --clear-groups";
  return one;
}

InputCase of_file(const std::string& id, const std::string& name, const std::string& file,
                  const std::string& says) {
  return with_manifest(refused(id, name, case_log(), says), case_manifest("log.csv", file));
}

}  // namespace

std::vector<InputCase> file_cases() {
  const std::string clean = case_log();
  const std::string binary = "log.csv: is a binary file: ";
  const std::string export_it =
      ", expected a text file of columns; hint: export or unpack it as CSV";
  const std::string by_python =
      ", expected a text file of columns; hint: in a Python with pandas and pyarrow (pip install "
      "pandas pyarrow): python3 -c \"import ";
  const std::string to_csv = ".to_csv('LOG.csv')\"";
  const std::string iconv =
      "log.csv: looks like UTF-16 (byte 0), expected a text file of columns; hint: convert it: "
      "iconv -f UTF-16 -t UTF-8";
  const std::string no_line_end =
      "log.csv: the last row has no line end; if the log was cut off, its last number may be too";
  const std::string save_it = "; hint: save what comes through it as a file first";
  const auto cut = [&](const char* id, const char* name, const std::string& rest) {
    InputCase one = accepted(id, name, clean + rest,
                             "log.csv: file ends inside a row at byte " +
                                 std::to_string((clean + rest).size()) +
                                 " (log truncated?); the row is left out");
    one.left_out = "1: cut off at the end of the file";
    return one;
  };
  InputCase latin1 = with_manifest(
      accepted("6b", "Latin1AsStated", replaced(clean, "q,tau", "\xe4ngle [\xb0],tau")),
      replaced(case_manifest("\"q\", unit = \"rad\"", "\"ängle\", unit = \"deg\""), "[columns]",
               "[log]\nencoding = \"latin1\"\n[columns]"));
  latin1.numbers = Numbers::any;
  const std::string without_last_end = clean.substr(0, clean.size() - 1);
  std::string lone_cr = clean;
  for (char& c : lone_cr) c = c == '\n' ? '\r' : c;
  std::string cr_lf;
  for (const char c : clean) cr_lf += c == '\n' ? "\r\n"s : std::string{c};
  const std::string many_columns = [] {
    std::string names = "t,q,tau";
    for (int k = 4; k <= 5000; ++k) names += ",c" + std::to_string(k);
    return case_log(
        [](int, Row& row) {
          for (int k = 4; k <= 5000; ++k) row.push_back("1");
        },
        names);
  }();
  return {
      with_log(refused("1a", "Missing", "", "log.csv: cannot open: No such file or directory"),
               [](const std::string&) {}),
      with_log(refused("1b", "Directory", "", "log.csv: cannot read: is a directory"),
               [](const std::string& path) { std::filesystem::create_directory(path); }),
      without_permission(),
      with_log(
          refused("1d", "LinkToNothing", "", "log.csv: cannot open: No such file or directory"),
          [](const std::string& path) { std::filesystem::create_symlink("gone", path); }),
      with_log(refused("1e", "LinkToItself", "",
                       "log.csv: cannot open: Too many levels of symbolic links"),
               [](const std::string& path) { std::filesystem::create_symlink("log.csv", path); }),
      refused("2a", "Empty", "", "log.csv: file is empty"),
      refused("2b", "OnlyAByteOrderMark", "\xef\xbb\xbf", "log.csv: file is empty"),
      refused("2c", "OnlyCommentsAndBlanks", "# nothing\n\n  \n", "log.csv: no header row"),
      refused("3", "HeaderOnly", "t,q,tau\n", "log.csv:1: no data rows"),
      accepted("4", "ByteOrderMark", "\xef\xbb\xbf" + clean),
      refused("5a", "Utf16LittleEndian", utf16(clean, true), iconv),
      refused("5b", "Utf16BigEndian", utf16(clean, false), iconv),
      refused("5c", "Utf16WithoutMark", utf16(clean, true).substr(2), iconv),
      refused("6a", "Latin1", replaced(clean, "q,tau", "\xe4ngle [\xb0],tau"),
              "log.csv:1:3: column name is not UTF-8, found byte 0xE4; hint: Latin-1? --latin1 of "
              "inspect and init reads it; in a manifest [log] encoding = \"latin1\""),
      latin1,
      accepted("7a", "CrLf", cr_lf),
      accepted("7b", "LoneCr", lone_cr),
      accepted("7c", "MixedLineEnds", replaced(clean, "\n", "\r\n"),
               "log.csv: line ends are mixed (LF, CR LF, CR)"),
      accepted("8", "NoFinalLineEnd", without_last_end, no_line_end),
      cut("9a", "CutInsideARow", "40.05,-0.80"),
      cut("9b", "CutInsideANumber", "40.05,-0.805,1.5e"),
      cut("9c", "CutInsideQuotes", "40.05,\"-0.8"),
      refused("10a", "NulBytes", with_line_301("1,\0,2"s),
              "log.csv: binary data at byte 8940, expected a text file of columns"),
      refused("10b", "Png", "\x89PNG\r\n\x1a\n", binary + "PNG" + export_it),
      refused("10c", "Gzip", "\x1f\x8b\x08\x01", binary + "gzip" + export_it),
      refused("10d", "Elf",
              "\x7f"
              "ELF\x02\x01",
              binary + "ELF" + export_it),
      refused("10e", "BagWithoutMessages", "#ROSBAG V2.0\n",
              "log.csv: holds no topic with numbers that can be read, found has no index: the "
              "recording was not closed, expected messages of ROS, JSON or protobuf, such as "
              "sensor_msgs/JointState"),
      refused(
          "10f", "ParquetCutOff", "PAR1\x15\x04\x15\x10\x15\x14\x4c\x15\x01",
          "log.csv: damaged: the file does not end with its footer; hint: it is cut off, or was "
          "not closed by what wrote it: copy it again"),
      refused("10i", "ParquetEncrypted", "PARE\x15\x04\x15\x10\x15\x14\x4c\x15\x01",
              "log.csv: is encrypted Parquet; hint: decrypt it where its key is"),
      refused("10j", "Feather", "ARROW1\0\0\xff\xff\xff\xff"s,
              binary + "Arrow (also .feather)" + by_python + "pandas; pandas.read_feather('LOG')" +
                  to_csv),
      refused("10k", "FeatherOf2016", "FEA1\0\0\0\0"s,
              binary + "Feather (of 2016), expected a text file of columns; hint: apt-get install "
                       "python3-feather-format; /usr/bin/python3 -c \"import feather; "
                       "feather.read_dataframe('LOG').to_csv('LOG.csv')\""),
      refused("10l", "ArrowStream", "\xff\xff\xff\xff\x10\1\0\0"s,
              binary + "Arrow (a stream)" + by_python +
                  "pyarrow; pyarrow.ipc.open_stream('LOG').read_pandas()" + to_csv),
      refused("10g", "Spreadsheet", "PK\x03\x04\x14" + std::string(40, '\x01'),
              binary + "zip (also .xlsx and .npz)" + export_it),
      refused("10h", "McapWithoutMessages", "\x89MCAP0\r\n",
              "log.csv: holds no topic with numbers that can be read, found ends at byte 8 without "
              "a footer: the recording was not closed, expected messages of ROS, JSON or "
              "protobuf, such as sensor_msgs/JointState"),
      accepted("40a", "FiveThousandColumns", many_columns,
               "columns of the logs that are not used: 'c4', 'c5', 'c6', 'c7', 'c8', 'c9', 'c10', "
               "'c11', 'c12', 'c13', 'c14', 'c15', 'c16', 'c17', 'c18', 'c19', 'c20', 'c21', "
               "'c22', 'c23', 'c24', 'c25', 'c26', 'c27', ... and 4973 more"),
      refused("40b", "SeventyThousandColumns", "t" + std::string(70'000, ',') + "\n0\n",
              "log.csv:1: more than 65536 columns"),
      refused("40c", "FieldOfAHundredKilobytes",
              with_line_301("14.95,0," + std::string(100'000, '1')),
              "log.csv:301:9: field is longer than 64 KiB, found 100000 bytes"),
      with_log(refused("42a", "Fifo", "", "log.csv: cannot read: is a pipe" + save_it),
               [](const std::string& path) { (void)mkfifo(path.c_str(), 0600); }),
      of_file("42b", "DevZero", "/dev/zero",
              "/dev/zero: cannot read: is a device; hint: a log is a file"),
      of_file("42c", "DevStdin", "/dev/stdin",
              "/dev/stdin: cannot read: is a device; hint: a log is a file"),
      of_file("42d", "Dash", "-",
              "dataset.toml:16:8: key 'recording.file': standard input is not read, found '-', "
              "expected the log's name" +
                  save_it),
      of_file("42e", "ProcFile", "/proc/sys/kernel/ostype",
              "/proc/sys/kernel/ostype:1: column 't' is missing, found 'Linux'"),
      of_file("43a", "NameWithALineEnd", "a\\nb.csv",
              "a\\x0ab.csv: cannot open: No such file or directory"),
      of_file("43b", "NameWithQuotes", "a'b\\\".csv",
              "a'b\".csv: cannot open: No such file or directory"),
      of_file("43c", "NameOf300Characters", std::string(300, 'x'),
              std::string(300, 'x') + ": cannot open: File name too long"),
      of_file("43d", "NameWithANul", "a\\u0000b",
              "dataset.toml:14:1: NUL byte in the name of a file, found 'a\\x00b'"),
      of_file("43e", "NameThatTurnsRound", "a\\u202Evsc.b",
              "a\\xe2\\x80\\xaevsc.b: cannot open: No such file or directory"),
  };
}

}  // namespace tribolog::test
