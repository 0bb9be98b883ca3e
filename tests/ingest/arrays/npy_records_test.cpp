// Arrays of records: structured types, as NumPy writes them and as nobody should.

#include <cstring>

#include <gtest/gtest.h>

#include "base/error.h"
#include "ingest/arrays/array_readers.h"
#include "ingest/arrays/numpy_files.h"
#include "support/damaged_files.h"
#include "wording/words.h"

namespace tribolog::npy_records_test {
namespace {

using namespace std::string_literals;
using Names = std::vector<std::string>;
using Values = std::vector<double>;
using test::npy;

ingest::log::LogTable only_table(const std::vector<ingest::log::LogTable>& tables) {
  EXPECT_EQ(tables.size(), 1U);
  return tables.empty() ? ingest::log::LogTable{} : tables.front();
}

Values column(const ingest::log::LogTable& table, const std::string& name) {
  for (std::size_t k = 0; k < table.header.size(); ++k) {
    if (table.header[k] == name) return table.columns[k].values;
  }
  ADD_FAILURE() << "no column " << name;
  return {};
}

std::string refusal(const std::string& bytes) {
  return test::refusal_of<InputError>([&] { return ingest::arrays::parse_npz(bytes, "q.npy"); });
}

class NpyRecords : public test::NumpyFiles {
 protected:
  /// Writes what `make` (Python) puts into `a` as log.npy, and a dictionary `truth` of name to
  /// values as doubles; reads the former and holds every column against the latter, bit by bit.
  void expect_as_numpy_says(const std::string& make) {
    run(make + R"(
np.save('log.npy', a)
with open('names.txt', 'w', encoding='utf-8') as f:
    f.write(''.join(n + '\n' for n in truth))
np.concatenate([np.asarray(v, '<f8').ravel() for v in truth.values()]).tofile('truth.bin')
)");
    const ingest::log::LogTable table =
        only_table(ingest::arrays::read_npz(directory_.path("log.npy")));
    const std::string truth = directory_.contents("truth.bin");
    std::string names;
    std::string values;
    for (std::size_t k = 0; k < table.header.size(); ++k) {
      names += table.header[k] + "\n";
      for (const double value : table.columns[k].values) {
        values.append(reinterpret_cast<const char*>(&value), sizeof value);
      }
    }
    EXPECT_EQ(names, directory_.contents("names.txt")) << make;
    EXPECT_TRUE(values == truth) << make;
  }
};

TEST_F(NpyRecords, FieldsOfEveryKindOfNumber) {
  expect_as_numpy_says(R"(
r = np.random.default_rng(2)
kinds = 'f8 >f8 f4 >f4 f2 >f2 i8 >i8 i4 >i4 i2 >i2 i1 u8 >u8 u4 >u4 u2 >u2 u1 ?'.split()
a = np.zeros(50, dtype=[('f%d' % k, kind) for k, kind in enumerate(kinds)])
for name in a.dtype.names:
    a[name] = r.integers(0, 2, 50) if a.dtype[name] == bool else 100 * r.random(50)
truth = {name: a[name].astype('f8') for name in a.dtype.names})");
}

TEST_F(NpyRecords, PaddedAndOffsetFields) {
  expect_as_numpy_says(R"(
a = np.zeros(9, dtype=np.dtype([('flag', 'i1'), ('t', 'f8'), ('n', 'i2')], align=True))
a['flag'] = np.arange(9); a['t'] = 0.1 * np.arange(9); a['n'] = -np.arange(9)
truth = {name: a[name] for name in a.dtype.names})");
  expect_as_numpy_says(R"(
a = np.zeros(9, dtype=np.dtype({'names': ['t', 'q'], 'formats': ['<f8', '>f4'],
                                'offsets': [3, 20], 'itemsize': 40}))
a['t'] = 0.1 * np.arange(9); a['q'] = np.arange(9) ** 2
truth = {'t': a['t'], 'q': a['q']})");
  // Some fields of a wider record: NumPy keeps the gaps.
  expect_as_numpy_says(R"(
wide = np.zeros(9, dtype=[('t', 'f8'), ('x', 'f4'), ('q', 'f8'), ('y', 'S3')])
wide['t'] = np.arange(9); wide['q'] = -np.arange(9)
a = wide[['t', 'q']]
truth = {'t': a['t'], 'q': a['q']})");
}

TEST_F(NpyRecords, NestedRecordsAndArraysWithin) {
  expect_as_numpy_says(R"(
motor = np.dtype([('i', '>f4'), ('state', [('temp', 'f8'), ('count', 'u2')])], align=True)
a = np.zeros(7, dtype=[('t', 'f8'), ('q', 'f4', (3,)), ('motor', motor), ('one', 'i4', (1,))])
a['t'] = np.arange(7); a['q'] = np.arange(21).reshape(7, 3) / 8
a['motor']['i'] = np.arange(7) / 2; a['motor']['state']['temp'] = 20 + np.arange(7)
a['motor']['state']['count'] = 7 - np.arange(7); a['one'] = 5
truth = {'t': a['t'], 'motor.i': a['motor']['i'], 'motor.state.temp': a['motor']['state']['temp'],
         'motor.state.count': a['motor']['state']['count'], 'one': a['one'],
         'q_0': a['q'][:, 0], 'q_1': a['q'][:, 1], 'q_2': a['q'][:, 2]})");
  expect_as_numpy_says(R"(
a = np.zeros(70, dtype=[('t', 'f8'), ('joint', [('q', 'f8'), ('dq', '>f4')], (2,))])
a['t'] = np.arange(70)
a['joint']['q'] = np.arange(140).reshape(70, 2); a['joint']['dq'] = -np.arange(140).reshape(70, 2)
truth = {'t': a['t'], **{'joint.%s_%d' % (n, k): a['joint'][n][:, k]
                         for n in ('q', 'dq') for k in (0, 1)}})");
}

TEST_F(NpyRecords, BothOrdersOfAMatrixOfRecords) {
  for (const char* order : {"C", "F"}) {
    expect_as_numpy_says(R"(
a = np.zeros((30, 2), dtype=[('q', 'f8'), ('n', 'i2')], order=')" +
                         std::string(order) + R"(')
a['q'] = np.arange(60).reshape(30, 2); a['n'] = 100 + np.arange(60).reshape(30, 2)
truth = {'%s_%d' % (n, k): a[n][:, k] for n in ('q', 'n') for k in (0, 1)})");
  }
}

TEST_F(NpyRecords, NamesWithTitlesQuotesAndLettersOfAllKinds) {
  expect_as_numpy_says(R"(
names = ["it's", 'say "q"', 'b\\s', 'φ [rad]', 'größe', '角', '\U0001d703', "both ' and \""]
a = np.zeros(4, dtype=[(('the time', 't'), 'f8')] + [(n, 'f8') for n in names])
for k, n in enumerate(a.dtype.names): a[n] = k + np.arange(4)
truth = {n: a[n] for n in a.dtype.names})");
  expect_as_numpy_says(R"(
a = np.zeros(4, dtype=[('größe', 'f8'), ('t', 'f8')])  # Latin-1, version 1
truth = {n: a[n] for n in a.dtype.names})");
}

TEST_F(NpyRecords, TimesTextsAndOthersAmongThem) {
  run(R"(a = np.zeros(3, dtype=[('when', 'M8[ms]'), ('phase', 'U7'), ('q', 'f8'), ('z', 'c16'),
                          ('raw', 'V3'), ('day', 'M8[D]'), ('d', 'm8[us]'), ('m', 'f8', (2, 2))])
a['when'] = ['2020-01-01', 'NaT', '2020-01-02']; a['q'] = [1, 2, 3]; a['d'] = [5, 6, 7]
np.save('log.npy', a))");
  const ingest::log::LogTable table =
      only_table(ingest::arrays::read_npz(directory_.path("log.npy")));
  EXPECT_EQ(table.header, (Names{"when", "q", "d"}));
  EXPECT_EQ(table.columns[0].header.unit, "ms");
  EXPECT_EQ(table.columns[0].gaps, 1U);
  EXPECT_EQ(table.columns[0].values[0], 1577836800000.0);
  EXPECT_EQ(table.columns[1].values, (Values{1, 2, 3}));
  EXPECT_EQ(table.columns[2].values, (Values{5, 6, 7}));
  EXPECT_EQ(
      wording::words(table.notes),
      (Names{"'phase' is not read: it holds texts", "'z' is not read: it holds complex numbers",
             "'raw' is not read: its type '|V3' is not known",
             "'day' is not read: its type '<M8[D]' is not known",
             "'m' is not read: it has more than two dimensions: 3 x 2 x 2"}));
}

TEST_F(NpyRecords, InAnArchiveTheyAreNamedByTheirArray) {
  run(R"(log = np.zeros(5, dtype=[('t', 'f8'), ('q', 'f8')])
log['t'] = np.arange(5); log['q'] = -np.arange(5)
setup = np.zeros((), dtype=[('rate', 'f8'), ('robot', 'U9')]); setup['rate'] = 200
setup['robot'] = 'arm'
np.savez('stored.npz', log=log, tau=np.arange(5.), setup=setup)
np.savez_compressed('deflated.npz', log=np.rec.array(log), tau=np.arange(5.), setup=setup))");
  for (const char* name : {"stored.npz", "deflated.npz"}) {
    const ingest::log::LogTable table = only_table(ingest::arrays::read_npz(directory_.path(name)));
    EXPECT_EQ(table.header, (Names{"log.t", "log.q", "tau"}));
    EXPECT_EQ(table.columns[1].values, (Values{0, -1, -2, -3, -4}));
    EXPECT_EQ(wording::words(table.notes), (Names{"setup.rate = 200", "setup.robot = 'arm'"}));
  }
}

TEST_F(NpyRecords, ObjectsAmongThemAreNeverUnpickled) {
  run(R"(np.save('log.npy', np.zeros(5, dtype=[('t', 'f8'), ('o', object)])))");
  EXPECT_NE(refusal(directory_.contents("log.npy")).find("Python objects (pickled)"),
            std::string::npos);
}

TEST_F(NpyRecords, DamageIsAnswered) {
  run(R"(a = np.zeros(3, dtype=[('t', 'f8'), ('q', 'f4', (3,)), ('m', [('i', '>f4'), ('', 'V2')])])
np.save('log.npy', a))");
  const std::string bytes = directory_.contents("log.npy");
  const auto read = [](const std::string& damaged) {
    return ingest::arrays::parse_npz(damaged, "a.npy");
  };
  test::expect_cuts_answered(read, bytes, 300);
  test::expect_changes_answered(read, bytes, 3000);
}

// As old and new NumPy write them, and other spellings that NumPy reads.
TEST(NpyRecordsByHand, SpellingsOfOneType) {
  const std::string values = "\1\2\3\4";
  for (const char* descr :
       {"[('t', '|i1'), ('q', '|i1')]", "[('t','|i1',),('q','|i1',),]",
        "[(('title', 't'), '|i1'), ('q', '|i1', (1,))]", "[ (\"t\" , '|i1') , ('\\x71', '|i1') ]",
        "[('t', '|i1'), ('\\u0071', '|i1'), ('', '|V0')]", "[('t', '|i1', ()), ('q', '|u1')]",
        "[('t', '|i1', (1L,)), ('q', '|i1')]"}) {
    const ingest::log::LogTable table =
        only_table(ingest::arrays::parse_npz(test::npy(descr, "(2,)", values), "q.npy"));
    EXPECT_EQ(table.header, (Names{"t", "q"})) << descr;
    EXPECT_EQ(column(table, "t"), (Values{1, 3})) << descr;
    EXPECT_EQ(column(table, "q"), (Values{2, 4})) << descr;
  }
}

TEST(NpyRecordsByHand, SameNamesAreToldApart) {
  const ingest::log::LogTable table = only_table(ingest::arrays::parse_npz(
      test::npy("[('t', '|i1'), ('t', '|i1')]", "(2,)", "\1\2\3\4"), "q.npy"));
  EXPECT_EQ(table.header, (Names{"t", "t_2"}));
}

TEST(NpyRecordsByHand, HostileTypesAreRefused) {
  std::string nested = "'<f8'";
  for (int depth = 0; depth < 900; ++depth) nested = "[('a', " + nested + ")]";
  const std::string sixteen(16, 'x');
  for (const std::string& descr : {"["s,
                                   "[("s,
                                   "[]"s,
                                   "[()]"s,
                                   "[('t')]"s,
                                   "[('t', )]"s,
                                   "[('t', '')]"s,
                                   "[('t', '<f8'"s,
                                   "[('t', '<f8')"s,
                                   "[('t', '<f8'), ('q', '<f8')] ]"s,
                                   "[('t', '<f8', 2)]"s,
                                   "[('t', '<f8', (-2,))]"s,
                                   "[('t', '<f8', (2.5,))]"s,
                                   "[('t', '<f8', (2,), 3)]"s,
                                   "[(('a', 'b', 't'), '<f8')]"s,
                                   "[((('a', 'b'), 't'), '<f8')]"s,
                                   "[('t\\q', '<f8')]"s,
                                   "[('\\x7', '<f8')]"s,
                                   "[('\\ud800', '<f8')]"s,
                                   "[('\\U00110000', '<f8')]"s,
                                   "[('t\\"s,
                                   "[('t', '<f8', (4611686018427387904,))]"s,
                                   "[('t', '<f8', (4294967296, 4294967296, 4294967296))]"s,
                                   "[('t', '|V18446744073709551615')]"s,
                                   "[('t', '|V18446744073709551616')]"s,
                                   "[('t', '<U9223372036854775807')]"s,
                                   "[('', '|V1099511627776'), ('t', '<f8')]"s,
                                   "[('t', '<f9')]"s,
                                   "[('t', '<f')]"s,
                                   "[('t', 'f8')]"s,
                                   "[('t', '<f8', (0,))]"s,
                                   "[('t', '<M8[ns')]"s,
                                   "('<f8', (2,))"s,
                                   "{'names': ['t'], 'formats': ['<f8']}"s,
                                   nested}) {
    EXPECT_NE(refusal(test::npy(descr, "(2,)", sixteen, false, 2)), "") << descr;
  }
  EXPECT_EQ(refusal(test::npy("[('t', '<f8'), ('q', '<f8')]", "(2,)", sixteen)),
            "q.npy: array 'q' is damaged or cut off, found 16 bytes of values, expected 32");
  EXPECT_EQ(refusal(test::npy("[('t', '<f8', (2,))]", "(1152921504606846976,)", sixteen)),
            "q.npy: array 'q' is damaged or cut off, found 16 bytes of values, "
            "expected more than a file can hold");
  // Not UTF-8, which version 3 says it is.
  EXPECT_NE(refusal(test::npy("[('\xff', '<f8')]", "(2,)", sixteen, false, 3)), "");
}

}  // namespace
}  // namespace tribolog::npy_records_test
