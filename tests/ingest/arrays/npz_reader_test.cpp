#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include <gtest/gtest.h>

#include "base/error.h"
#include "ingest/arrays/array_readers.h"
#include "ingest/arrays/numpy_files.h"
#include "ingest/log/log_format.h"
#include "support/damaged_files.h"
#include "wording/words.h"

namespace tribolog::npz_reader_test {
namespace {

using namespace std::string_literals;
using Names = std::vector<std::string>;
using Values = std::vector<double>;

using test::npy;

ingest::log::LogTable only_table(const std::string& bytes) {
  auto tables = ingest::arrays::parse_npz(bytes, "dir/q.npy");
  EXPECT_EQ(tables.size(), 1U);
  return tables.front();
}

Values only_column(const std::string& bytes) {
  const ingest::log::LogTable table = only_table(bytes);
  EXPECT_EQ(table.header, (Names{"q"}));
  return table.columns.front().values;
}

std::string refusal(const std::string& bytes) {
  return test::refusal_of<InputError>([&] { return ingest::arrays::parse_npz(bytes, "q.npy"); });
}

TEST(Npy, EveryTypeOfNumberByHand) {
  EXPECT_EQ(only_column(test::npy("'|b1'", "(3,)", "\0\1\1"s)), (Values{0, 1, 1}));
  EXPECT_EQ(only_column(test::npy("'|i1'", "(2,)", "\xff\x7f")), (Values{-1, 127}));
  EXPECT_EQ(only_column(test::npy("'|u1'", "(2,)", "\xff\x7f")), (Values{255, 127}));
  EXPECT_EQ(only_column(test::npy("'<i2'", "(2,)", "\xfe\xff\x01\x02")), (Values{-2, 513}));
  EXPECT_EQ(only_column(test::npy("'>i2'", "(2,)", "\xff\xfe\x02\x01")), (Values{-2, 513}));
  EXPECT_EQ(only_column(test::npy("'>u4'", "(2,)", "\0\0\1\0\xff\xff\xff\xff"s)),
            (Values{256, 4294967295.0}));
  EXPECT_EQ(only_column(test::npy("'<i8'", "(2,)", "\1\0\0\0\0\0\0\0"s + std::string(8, '\xff'))),
            (Values{1, -1}));
  EXPECT_EQ(only_column(test::npy("'<f4'", "(2,)", "\0\0\x80\x3f\0\0\0\xc0"s)), (Values{1, -2}));
  EXPECT_EQ(only_column(test::npy("'>f8'", "(2,)", "\x3f\xf8\0\0\0\0\0\0\xc0\0\0\0\0\0\0\0"s)),
            (Values{1.5, -2}));
  EXPECT_EQ(only_column(test::npy("'<f2'", "(4,)", "\0\x3c\0\xc0\1\0\xff\x7b"s)),
            (Values{1, -2, std::ldexp(1.0, -24), 65504}));
}

TEST(Npy, EveryVersionOfTheHeader) {
  for (const int version : {1, 2, 3}) {
    EXPECT_EQ(only_column(test::npy("'|i1'", "(2,)", "\1\2", false, version)), (Values{1, 2}));
  }
  EXPECT_EQ(refusal(test::npy("'|i1'", "(2,)", "\1\2", false, 4)),
            "q.npy: array 'q': NumPy format version 4 is not known");
}

TEST(Npy, BothOrdersOfAMatrix) {
  const ingest::log::LogTable by_rows = only_table(test::npy("'|i1'", "(3, 2)", "\1\2\3\4\5\6"));
  EXPECT_EQ(by_rows.header, (Names{"q_0", "q_1"}));
  EXPECT_EQ(by_rows.columns[0].values, (Values{1, 3, 5}));
  const ingest::log::LogTable by_columns =
      only_table(test::npy("'|i1'", "(3, 2)", "\1\2\3\4\5\6", true));
  EXPECT_EQ(by_columns.columns[0].values, (Values{1, 2, 3}));
}

TEST(Npy, TimesHaveTheirUnitAndGaps) {
  const ingest::log::LogTable table =
      only_table(test::npy("'<M8[ns]'", "(2,)", "\7\0\0\0\0\0\0\0"s + "\0\0\0\0\0\0\0\x80"s));
  EXPECT_EQ(table.columns[0].header.unit, "ns");
  EXPECT_EQ(table.columns[0].values[0], 7);
  EXPECT_EQ(table.columns[0].gaps, 1U);
}

TEST(Npy, RoundedIntegersAreNoted) {
  const ingest::log::LogTable table =
      only_table(test::npy("'<i8'", "(2,)", "\1\0\0\0\0\0\x20\0"s + "\1\0\0\0\0\0\0\0"s));
  EXPECT_EQ(wording::words(table.notes),
            (Names{"'q' holds integers of 2^53 and more: they are rounded"}));
}

TEST(Npy, ObjectsAreRefusedByName) {
  EXPECT_EQ(refusal(test::npy("'|O'", "(2,)", "\x80\4\x95")),
            "q.npy: no rows of numbers, found 'q' is not read: it holds Python objects (pickled), "
            "which are not read for safety, expected arrays of two or more numbers");
  EXPECT_NE(refusal(test::npy("'<c16'", "(2,)", std::string(32, 'x'))).find("complex numbers"),
            std::string::npos);
}

TEST(Npy, HostileHeadersAreRefused) {
  const std::string values(16, '\0');
  for (const char* shape : {"(18446744073709551615, 18446744073709551615)", "(99999999999,)",
                            "(-2,)", "(2", "2", "((2,),)", "(2,) 3", "(2.5,)", "(3,)", "(1,)"}) {
    EXPECT_NE(refusal(test::npy("'<f8'", shape, values)), "") << shape;
    EXPECT_NE(refusal(test::npy("'<f8'", shape, values)).substr(0, 5), "other") << shape;
  }
  EXPECT_EQ(refusal(test::npy("'<f8'", "(3,)", values)),
            "q.npy: array 'q' is damaged or cut off, found 16 bytes of values, expected 24");
  EXPECT_NE(refusal(test::npy("'<f8", "(2,)", values)), "");
  EXPECT_NE(refusal(test::npy("[[[[", "(2,)", values)), "");
  EXPECT_NE(refusal("\x93NUMPY"), "");
}

class Npz : public test::NumpyFiles {
 protected:
  /// As FloBaRoID writes its measurements; the values are random bits of finite numbers.
  void make_robot_log() {
    run(R"(r = np.random.default_rng(1)
N = 200
t = np.arange(N) * 0.005
m = lambda: r.standard_normal((N, 6)) * 10.0 ** r.integers(-300, 300, (N, 6))
log = dict(times=t, positions=m(), velocities=np.asfortranarray(m()), accelerations=m(),
           torques=m().astype('>f8'), target_positions=m().T, frequency=200.0, robot='arm')
np.savez('stored.npz', **log)
np.savez_compressed('deflated.npz', **log)
np.concatenate([t[:, None]] + [log[k] for k in ('positions', 'velocities', 'accelerations',
    'torques')] + [log['target_positions'].T], axis=1).astype('<f8').tofile('expected.bin')
)");
  }
};

TEST_F(Npz, RobotLogsAreReadToTheBit) {
  make_robot_log();
  const std::string expected = directory_.contents("expected.bin");
  for (const char* name : {"stored.npz", "deflated.npz"}) {
    EXPECT_EQ(ingest::log::detect_log_format(directory_.contents(name), "log"),
              ingest::log::LogFormat::npz);
    const auto tables = ingest::arrays::read_npz(directory_.path(name));
    ASSERT_EQ(tables.size(), 1U);
    const ingest::log::LogTable& table = tables[0];
    ASSERT_EQ(table.columns.size(), 31U);
    EXPECT_EQ(table.header[1], "positions_0");
    EXPECT_EQ(table.header[30], "target_positions_5");
    EXPECT_EQ(wording::words(table.notes), (Names{"frequency = 200", "robot = 'arm'"}));
    for (std::size_t row = 0; row < 200; ++row) {
      for (std::size_t i = 0; i < 31; ++i) {
        double value{};
        std::memcpy(&value, &expected[8 * (31 * row + i)], 8);
        ASSERT_EQ(std::bit_cast<std::uint64_t>(table.columns[i].values[row]),
                  std::bit_cast<std::uint64_t>(value))
            << name << " row " << row << " column " << i;
      }
    }
  }
}

TEST_F(Npz, ObjectsTextsAndOthersAreNoted) {
  run(R"(np.savez('a.npz', t=np.arange(3.), o=np.array([1, 'x'], dtype=object),
  s=np.array(['a', 'b']), z=np.array([1j, 2]), c=np.zeros((2, 3, 4)), e=np.zeros((0, 3)),
  half=np.arange(3, dtype='f2'), flag=np.array([True, False, True]),
  when=np.array(['2020-01-01', 'NaT', '2020-01-02'], dtype='M8[ms]')))");
  const auto tables = ingest::arrays::read_npz(directory_.path("a.npz"));
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_EQ(tables[0].header, (Names{"t", "half", "flag", "when"}));
  EXPECT_EQ(tables[0].columns[3].gaps, 1U);
  EXPECT_EQ(tables[0].columns[3].values[0], 1577836800000.0);
  EXPECT_EQ(tables[0].notes.size(), 5U);
}

TEST_F(Npz, DamageIsAnswered) {
  make_robot_log();
  const auto read = [](const std::string& bytes) {
    return ingest::arrays::parse_npz(bytes, "a.npz");
  };
  for (const char* name : {"stored.npz", "deflated.npz"}) {
    const std::string bytes = directory_.contents(name);
    test::expect_cuts_answered(read, bytes, 500);
    test::expect_changes_answered(read, bytes, 500);
  }
}

TEST_F(Npz, DamagedValuesNeverPassAsGood) {
  make_robot_log();
  std::string bytes = directory_.contents("stored.npz");
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  EXPECT_NE(test::refusal_of<InputError>([&] {
              return ingest::arrays::parse_npz(bytes, "a.npz");
            }).find("its checksum is wrong"),
            std::string::npos);
}

TEST_F(Npz, EntriesThatShareTheirBytesAreRefused) {
  run(R"(import zipfile, io
b = io.BytesIO(); np.save(b, np.zeros(1000))
with zipfile.ZipFile('bomb.npz', 'w') as z:
    z.writestr('a.npy', b.getvalue())
    first = z.filelist[0]
    for i in range(100):
        import copy
        other = copy.copy(first); other.filename = 'a%d.npy' % i; z.filelist.append(other)
)");
  EXPECT_EQ(test::refusal_of<InputError>([&] {
              return ingest::arrays::parse_npz(directory_.contents("bomb.npz"), "a.npz");
            }),
            "a.npz: damaged zip archive: its directory contradicts its size");
}

}  // namespace
}  // namespace tribolog::npz_reader_test
