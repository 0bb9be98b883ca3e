#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <ostream>
#include <random>

#include <gtest/gtest.h>
#include <matio.h>

#include "base/error.h"
#include "base/temporary_directory.h"
#include "ingest/arrays/array_readers.h"
#include "ingest/hdf5_matlab/hdf5_chunks.h"
#include "ingest/log/log_format.h"
#include "support/damaged_files.h"
#include "wording/words.h"

namespace tribolog::mat_reader_test {
namespace {

using Names = std::vector<std::string>;
using Values = std::vector<double>;

struct MatForm {
  const char* name;
  mat_ft version;
  matio_compression compression;
};

constexpr MatForm forms[] = {{"v4", MAT_FT_MAT4, MAT_COMPRESSION_NONE},
                             {"v5", MAT_FT_MAT5, MAT_COMPRESSION_NONE},
                             {"v7", MAT_FT_MAT5, MAT_COMPRESSION_ZLIB},
                             {"v73", MAT_FT_MAT73, MAT_COMPRESSION_ZLIB}};

void PrintTo(const MatForm& form, std::ostream* out) { *out << form.name; }

std::string form_name(const testing::TestParamInfo<MatForm>& form) { return form.param.name; }

matvar_t* variable(const char* name, matio_classes kind, matio_types type, std::size_t rows,
                   std::size_t columns, const void* values, int options = 0) {
  std::size_t sides[2] = {rows, columns};
  return Mat_VarCreate(name, kind, type, 2, sides, const_cast<void*>(values), options);
}

matvar_t* doubles(const char* name, std::size_t rows, std::size_t columns, const Values& values) {
  return variable(name, MAT_C_DOUBLE, MAT_T_DOUBLE, rows, columns, values.data());
}

/// A MAT file in the making, by matio itself.
class MatMaker {
 public:
  MatMaker(const std::string& path, const MatForm& form)
      : file_(Mat_CreateVer(path.c_str(), nullptr, form.version)), form_(form) {}
  MatMaker(const MatMaker&) = delete;
  MatMaker& operator=(const MatMaker&) = delete;
  ~MatMaker() { Mat_Close(file_); }
  void add(matvar_t* var) {
    EXPECT_EQ(Mat_VarWrite(file_, var, form_.compression), 0) << var->name;
    Mat_VarFree(var);
  }

 private:
  mat_t* file_;
  MatForm form_;
};

Values random_values(std::size_t count) {
  std::mt19937_64 random(6);
  Values values(count);
  for (double& value : values) {
    do value = std::bit_cast<double>(random());
    while (!std::isfinite(value));
  }
  return values;
}

class Mat : public testing::TestWithParam<MatForm> {
 protected:
  test::TemporaryDirectory directory_;
  std::string path_ = directory_.path("log.mat");

  void make_robot_log() {
    MatMaker file(path_, GetParam());
    file.add(doubles("t", 1, 200, random_values(200)));
    file.add(doubles("q", 200, 3, random_values(600)));
    file.add(doubles("tau", 3, 200, random_values(600)));
    file.add(doubles("mass", 1, 1, {0.49}));
    if (GetParam().version == MAT_FT_MAT4) return;  // matio writes no texts there
    file.add(variable("robot", MAT_C_CHAR, MAT_T_UTF8, 1, 5, "UR10e"));
  }
  std::string refusal() {
    return test::refusal_of<InputError>([&] { return ingest::arrays::read_mat(path_); });
  }
};

TEST_P(Mat, RobotLogsAreReadToTheBit) {
  make_robot_log();
  const auto tables = ingest::arrays::read_mat(path_);
  ASSERT_EQ(tables.size(), 1U);
  const ingest::log::LogTable& table = tables[0];
  ASSERT_EQ(table.header.size(), 7U);
  const Values values = random_values(600);
  const auto expect = [&](const std::string& name, const auto& index) {
    const auto at = std::find(table.header.begin(), table.header.end(), name);
    ASSERT_NE(at, table.header.end()) << name;
    const auto& column = table.columns[static_cast<std::size_t>(at - table.header.begin())];
    for (std::size_t row = 0; row < 200; ++row) {
      ASSERT_EQ(std::bit_cast<std::uint64_t>(column.values[row]),
                std::bit_cast<std::uint64_t>(values[index(row)]))
          << name << " row " << row;
    }
  };
  expect("t", [](std::size_t row) { return row; });
  for (std::size_t i = 0; i < 3; ++i) {
    expect("q_" + std::to_string(i), [i](std::size_t row) { return 200 * i + row; });
    expect("tau_" + std::to_string(i), [i](std::size_t row) { return 3 * row + i; });
  }
  EXPECT_EQ(wording::words(table.notes[0]), "mass = 0.49");
  if (GetParam().version == MAT_FT_MAT4) return;
  EXPECT_EQ(wording::words(table.notes), (Names{"mass = 0.49", "robot = 'UR10e'"}));
}

TEST_P(Mat, FormatIsRecognised) {
  make_robot_log();
  EXPECT_EQ(ingest::log::detect_log_format(
                directory_.contents("log.mat").substr(0, ingest::log::log_format_bytes), path_),
            ingest::log::LogFormat::mat);
}

TEST_P(Mat, DamageIsAnswered) {
  make_robot_log();
  const std::string bytes = directory_.contents("log.mat");
  const auto read = [this](const std::string& changed) {
    return ingest::arrays::read_mat(directory_.file("damaged.mat", changed));
  };
  test::expect_cuts_answered(read, bytes, 500);
  test::expect_changes_answered(read, bytes, 500);
}

TEST_P(Mat, ACutFileGivesItsCompleteVariablesWhereItCan) {
  {
    MatMaker file(path_, GetParam());
    file.add(doubles("t", 200, 1, random_values(200)));
    file.add(doubles("q", 200, 1, random_values(200)));
  }
  const std::string bytes = directory_.contents("log.mat");
  path_ = directory_.file("cut.mat", bytes.substr(0, bytes.size() - 20));
  if (GetParam().version == MAT_FT_MAT73) {
    EXPECT_TRUE(refusal().starts_with(path_ + ": damaged or no HDF5 file")) << refusal();
    return;
  }
  const auto tables = ingest::arrays::read_mat(path_);
  EXPECT_EQ(tables[0].header, (Names{"t"}));
  EXPECT_EQ(wording::words(tables[0].notes),
            (Names{"'variable 2' is not read: the file ends inside it"}));
}

INSTANTIATE_TEST_SUITE_P(Versions, Mat, testing::ValuesIn(forms), form_name);

class NewerMat : public Mat {};

matvar_t* words(const std::string& text, const char* name = nullptr) {
  return variable(name, MAT_C_CHAR, MAT_T_UTF8, 1, text.size(), text.data());
}

matvar_t* cell(const char* name, std::vector<matvar_t*> elements) {
  return variable(name, MAT_C_CELL, MAT_T_CELL, 1, elements.size(),
                  static_cast<void*>(elements.data()));
}

TEST_P(NewerMat, CellsOfVectorsAreNamedByACellOfTextsBesideThem) {
  {
    MatMaker file(path_, GetParam());
    file.add(cell("data", {doubles(nullptr, 3, 1, {0, 1, 2}), doubles(nullptr, 1, 3, {5, 6, 7}),
                           doubles(nullptr, 3, 2, {1, 2, 3, 4, 5, 6})}));
    file.add(cell("names", {words("t_s"), words("q_rad"), words("tau")}));
    const char* fields[] = {"cells"};
    std::size_t one[2] = {1, 1};
    matvar_t* run = Mat_VarCreateStruct("run", 2, one, fields, 1);
    Mat_VarSetStructFieldByName(
        run, "cells", 0, cell(nullptr, {doubles(nullptr, 1, 3, {7, 8, 9}), words("a remark")}));
    file.add(run);
  }
  const auto tables = ingest::arrays::read_mat(path_);
  ASSERT_EQ(tables.size(), 1U);
  Names header = tables[0].header;
  std::sort(header.begin(), header.end());
  EXPECT_EQ(header, (Names{"q_rad", "run.cells_0", "t_s", "tau_0", "tau_1"}));
  const std::map<std::string, Values> expected = {{"t_s", {0, 1, 2}},
                                                  {"q_rad", {5, 6, 7}},
                                                  {"tau_0", {1, 2, 3}},
                                                  {"tau_1", {4, 5, 6}},
                                                  {"run.cells_0", {7, 8, 9}}};
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(tables[0].columns[k].values, expected.at(tables[0].header[k]));
  }
  EXPECT_EQ(
      wording::words(tables[0].notes),
      (Names{"run.cells_1 = 'a remark'", "'names' is not read: it is a cell array of texts"}));
}

TEST_P(NewerMat, CellsOfStructsAreRead) {
  {
    MatMaker file(path_, GetParam());
    const char* fields[] = {"t", "q"};
    std::size_t one[2] = {1, 1};
    std::vector<matvar_t*> runs;
    for (double start : {0.0, 10.0}) {
      runs.push_back(Mat_VarCreateStruct(nullptr, 2, one, fields, 2));
      Mat_VarSetStructFieldByName(runs.back(), "t", 0, doubles(nullptr, 1, 2, {start, start + 1}));
      Mat_VarSetStructFieldByName(runs.back(), "q", 0, doubles(nullptr, 1, 2, {start + 5, 6}));
    }
    file.add(cell("runs", runs));
    // Two cells of as many texts do not tell which names them.
    file.add(cell("names", {words("slow"), words("fast")}));
    file.add(cell("remarks", {words("cold"), words("warm")}));
  }
  const auto table = ingest::arrays::read_mat(path_).at(0);
  EXPECT_EQ(table.header, (Names{"runs_0.t", "runs_0.q", "runs_1.t", "runs_1.q"}));
  EXPECT_EQ(table.columns[3].values, (Values{15, 6}));
}

TEST_P(NewerMat, StructsGiveDottedNames) {
  {
    MatMaker file(path_, GetParam());
    const char* fields[] = {"t", "q"};
    std::size_t one[2] = {1, 1};
    matvar_t* run = Mat_VarCreateStruct("run", 2, one, fields, 2);
    Mat_VarSetStructFieldByName(run, "t", 0, doubles(nullptr, 1, 3, {0, 1, 2}));
    Mat_VarSetStructFieldByName(run, "q", 0, doubles(nullptr, 3, 2, {1, 2, 3, 4, 5, 6}));
    file.add(run);
  }
  const auto tables = ingest::arrays::read_mat(path_);
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_EQ(tables[0].header, (Names{"run.t", "run.q_0", "run.q_1"}));
  EXPECT_EQ(tables[0].columns[2].values, (Values{4, 5, 6}));
}

TEST_P(NewerMat, EveryTypeOfNumber) {
  const std::int8_t i8[] = {-1, 2};
  const std::uint8_t u8[] = {255, 1};
  const std::int16_t i16[] = {-300, 2};
  const std::uint16_t u16[] = {65535, 1};
  const std::int32_t i32[] = {-70000, 2};
  const std::uint32_t u32[] = {4294967295U, 1};
  const std::int64_t i64[] = {-(1LL << 53) - 1, 2};
  const std::uint64_t u64[] = {1ULL << 60, 1};
  const float f32[] = {0.1F, -2.5F};
  {
    MatMaker file(path_, GetParam());
    file.add(variable("a", MAT_C_INT8, MAT_T_INT8, 2, 1, i8));
    file.add(variable("b", MAT_C_UINT8, MAT_T_UINT8, 2, 1, u8, MAT_F_LOGICAL));
    file.add(variable("c", MAT_C_INT16, MAT_T_INT16, 2, 1, i16));
    file.add(variable("d", MAT_C_UINT16, MAT_T_UINT16, 2, 1, u16));
    file.add(variable("e", MAT_C_INT32, MAT_T_INT32, 2, 1, i32));
    file.add(variable("f", MAT_C_UINT32, MAT_T_UINT32, 2, 1, u32));
    file.add(variable("g", MAT_C_INT64, MAT_T_INT64, 2, 1, i64));
    file.add(variable("h", MAT_C_UINT64, MAT_T_UINT64, 2, 1, u64));
    file.add(variable("i", MAT_C_SINGLE, MAT_T_SINGLE, 2, 1, f32));
  }
  const auto tables = ingest::arrays::read_mat(path_);
  ASSERT_EQ(tables.size(), 1U);
  ASSERT_EQ(tables[0].columns.size(), 9U);
  const Values first = {-1,
                        255,
                        -300,
                        65535,
                        -70000,
                        4294967295.0,
                        -9007199254740992.0,
                        1152921504606846976.0,
                        static_cast<double>(0.1F)};
  for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(tables[0].columns[i].values[0], first[i]) << i;
  EXPECT_EQ(tables[0].notes.size(), 2U) << "g and h are rounded";
}

TEST_P(NewerMat, OthersAreNamed) {
  {
    MatMaker file(path_, GetParam());
    file.add(doubles("t", 3, 1, {0, 1, std::nan("")}));
    Values real = {1, 2, 3};
    mat_complex_split_t parts{real.data(), real.data()};
    file.add(variable("z", MAT_C_DOUBLE, MAT_T_DOUBLE, 3, 1, &parts, MAT_F_COMPLEX));
    std::size_t three[3] = {2, 2, 2};
    Values cube(8);
    file.add(Mat_VarCreate("cube", MAT_C_DOUBLE, MAT_T_DOUBLE, 3, three, cube.data(), 0));
    file.add(cell("cell", {words("a"), words("b")}));
  }
  const auto tables = ingest::arrays::read_mat(path_);
  EXPECT_EQ(tables[0].columns[0].gaps, 1U);
  Names notes = wording::words(tables[0].notes);
  std::sort(notes.begin(), notes.end());
  EXPECT_EQ(notes, (Names{"'cell' is not read: it is a cell array of texts",
                          "'cube' is not read: it has more than two dimensions: 2 x 2 x 2",
                          "'z' is not read: it holds complex numbers"}));
}

INSTANTIATE_TEST_SUITE_P(Versions, NewerMat, testing::Values(forms[1], forms[2], forms[3]),
                         form_name);

/// A variable of MAT 4 by hand: type, rows, columns, imaginary part, length of the name.
std::string mat_4(const std::vector<std::uint32_t>& header, const std::string& name,
                  const std::string& values, bool big_endian = false) {
  std::string bytes;
  for (const std::uint32_t field : header) {
    for (unsigned i = 0; i < 4; ++i) {
      bytes += static_cast<char>(field >> (8 * (big_endian ? 3 - i : i)));
    }
  }
  return bytes + name + '\0' + values;
}

class MatFiles : public testing::Test {
 protected:
  test::TemporaryDirectory directory_;
};

TEST_F(MatFiles, DamagedCompressedValuesNeverPassAsGood) {
  const std::string path = directory_.path("log.mat");
  MatMaker(path, forms[2]).add(doubles("t", 2000, 1, random_values(2000)));
  std::string bytes = directory_.contents("log.mat");
  std::mt19937 random(4);
  for (int i = 0; i < 100; ++i) {
    std::string changed = bytes;
    const std::size_t at = 136 + random() % (bytes.size() - 136);
    changed[at] = static_cast<char>(changed[at] ^ 1);
    const std::string damaged = directory_.file("damaged.mat", changed);
    EXPECT_EQ(test::refusal_of<InputError>([&] { return ingest::arrays::read_mat(damaged); }),
              damaged + ": damaged MAT file: variable 1 has a wrong checksum")
        << at;
  }
}

TEST_F(MatFiles, Version4ByHandInBothByteOrders) {
  using namespace std::string_literals;
  const auto read = [&](const std::string& bytes) {
    return ingest::arrays::read_mat(directory_.file("a.mat", bytes))[0];
  };
  const std::string text = mat_4({51, 1, 3, 0, 6}, "robot", "arm");
  const ingest::log::LogTable little = read(mat_4({30, 2, 1, 0, 2}, "q", "\1\0\xff\xff"s) + text);
  EXPECT_EQ(little.header, (Names{"q"}));
  EXPECT_EQ(little.columns[0].values, (Values{1, -1}));
  EXPECT_EQ(wording::words(little.notes), (Names{"robot = 'arm'"}));
  const ingest::log::LogTable big = read(mat_4({1030, 2, 1, 0, 2}, "q", "\0\1\xff\xff"s, true));
  EXPECT_EQ(big.columns[0].values, (Values{1, -1}));
}

TEST_F(MatFiles, Version4LengthsAreNotBelieved) {
  const std::string path = directory_.file(
      "a.mat", mat_4({0, 0xffffffffU, 0xffffffffU, 1, 2}, "q", std::string(64, '\0')));
  EXPECT_EQ(test::refusal_of<InputError>([&] { return ingest::arrays::read_mat(path); }),
            path +
                ": no rows of numbers, found 'variable 1' is not read: the file ends inside it, "
                "expected arrays of two or more numbers");
}

TEST_F(MatFiles, NothingOutsideOfA73FileIsRead) {
  const std::string path = directory_.path("log.mat");
  MatMaker(path, forms[3]).add(doubles("t", 3, 1, {0, 1, 2}));
  {
    const ingest::hdf5_matlab::Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT),
                                               H5Fclose);
    ASSERT_TRUE(file.is_open());
    H5Lcreate_external("other.mat", "/secret", file.get(), "secret", H5P_DEFAULT, H5P_DEFAULT);
  }
  EXPECT_EQ(test::refusal_of<InputError>([&] { return ingest::arrays::read_mat(path); }),
            path + ": some of its values are in other files, which are not read");
}

/// An element of MAT 5: kind, length, values, filled up to eight bytes.
std::string mat_5(std::uint32_t kind, const std::string& values) {
  std::string bytes(8, '\0');
  const auto length = static_cast<std::uint32_t>(values.size());
  std::memcpy(bytes.data(), &kind, 4);
  std::memcpy(bytes.data() + 4, &length, 4);
  return bytes + values + std::string((8 - values.size() % 8) % 8, '\0');
}

template <class Number>
std::string bytes_of(const std::vector<Number>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

std::string mat_5_flags(std::uint32_t array_class) {
  return mat_5(6, bytes_of(std::vector<std::uint32_t>{array_class, 0}));
}

std::string mat_5_numbers(const std::string& name, std::uint32_t array_class, std::uint32_t kind,
                          int count, const std::string& values) {
  return mat_5(14, mat_5_flags(array_class) + mat_5(5, bytes_of(std::vector<int>{count, 1})) +
                       mat_5(1, name) + mat_5(kind, values));
}

/// As MATLAB saves an object: its class, and a number of what it stores of all objects behind the
/// last variable.
std::string mat_5_object(const std::string& name, const std::string& class_name) {
  const std::vector<std::uint32_t> number{0xdd000000U, 2, 1, 1, 1, 1};
  return mat_5(14, mat_5_flags(17) + mat_5(1, name) + mat_5(1, "MCOS") + mat_5(1, class_name) +
                       mat_5_numbers("", 13, 6, 6, bytes_of(number)));
}

std::string mat_5_doubles(const std::string& name, const Values& values) {
  return mat_5_numbers(name, 6, 9, static_cast<int>(values.size()), bytes_of(values));
}

std::string mat_5_file(const std::string& variables) {
  std::string header = "MATLAB 5.0 MAT-file, Platform: GLNXA64" + std::string(90, ' ');
  header.replace(124, 4, std::string("\0\1IM", 4));
  const std::uint64_t stored = header.size() + variables.size();
  std::memcpy(header.data() + 116, &stored, 8);
  return header + variables + mat_5_numbers("", 9, 2, 200, std::string(200, '\7'));
}

TEST_F(MatFiles, ObjectsOfMatlabAreRefusedWithTheLineThatMakesVectors) {
  const auto tables = ingest::arrays::read_mat(directory_.file(
      "a.mat", mat_5_file(mat_5_object("tt", "timetable") + mat_5_doubles("t", {0, 1, 2}) +
                          mat_5_object("ts", "timeseries") + mat_5_doubles("q", {5, 6, 7}) +
                          mat_5_object("odd", "my.Class"))));
  ASSERT_EQ(tables.size(), 1U) << "what MATLAB stores of objects is no array";
  EXPECT_EQ(tables[0].header, (Names{"t", "q"}));
  EXPECT_EQ(tables[0].columns[1].values, (Values{5, 6, 7}));
  EXPECT_EQ(
      wording::words(tables[0].notes),
      (Names{"'tt' is not read: it is a timetable, which MATLAB alone reads; there: s = "
             "table2struct(timetable2table(tt, 'ConvertRowTimes', false), 'ToScalar', true); s.t_s "
             "= seconds(tt.Properties.RowTimes - tt.Properties.RowTimes(1)); save('plain.mat', "
             "'-struct', 's')",
             "'ts' is not read: it is a timeseries, which MATLAB alone reads; there: s.t_s = "
             "ts.Time; s.value = squeeze(ts.Data); save('plain.mat', '-struct', 's'), with a field "
             "for each further one",
             "'odd' is not read: it is an object of a MATLAB class, my.Class, which MATLAB alone "
             "reads; save its numbers there as vectors: s.t_s = ...; s.q = ...; "
             "save('plain.mat', '-struct', 's')"}));
}

TEST_F(MatFiles, ObjectsWithinAreNamedByTheirPath) {
  const auto tables = ingest::arrays::read_mat(directory_.file(
      "a.mat", mat_5_file(mat_5_doubles("t", {0, 1, 2}) +
                          mat_5(14, mat_5_flags(1) + mat_5(5, bytes_of(std::vector<int>{1, 2})) +
                                        mat_5(1, "cells") + mat_5_object("", "table") +
                                        mat_5_doubles("", {5, 6, 7})))));
  EXPECT_EQ(tables.at(0).header, (Names{"t", "cells_1"}));
  EXPECT_EQ(wording::words(tables[0].notes),
            (Names{"'cells_0' is not read: it is a table, which MATLAB alone reads; there: s = "
                   "table2struct(x, 'ToScalar', true); save('plain.mat', '-struct', 's')"}));
}

TEST_F(MatFiles, ObjectsIn73AreNamedToo) {
  const std::string path = directory_.path("log.mat");
  {
    MatMaker file(path, forms[3]);
    file.add(doubles("t", 3, 1, {0, 1, 2}));
    const std::uint32_t number[] = {0xdd000000U, 2, 1, 1, 1, 1};
    file.add(variable("tt", MAT_C_UINT32, MAT_T_UINT32, 1, 6, number));
  }
  {
    using ingest::hdf5_matlab::Hdf5Handle;
    const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
    const Hdf5Handle stored(
        H5Gcreate2(file.get(), "#subsystem#", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
    const Hdf5Handle object(H5Dopen2(file.get(), "tt", H5P_DEFAULT), H5Dclose);
    ASSERT_GE(H5Adelete(object.get(), "MATLAB_class"), 0);
    const Hdf5Handle scalar(H5Screate(H5S_SCALAR), H5Sclose);
    const Hdf5Handle text(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(text.get(), 9);
    const Hdf5Handle class_name(H5Acreate2(object.get(), "MATLAB_class", text.get(), scalar.get(),
                                           H5P_DEFAULT, H5P_DEFAULT),
                                H5Aclose);
    H5Awrite(class_name.get(), text.get(), "timetable");
    const Hdf5Handle decode(H5Acreate2(object.get(), "MATLAB_object_decode", H5T_NATIVE_INT,
                                       scalar.get(), H5P_DEFAULT, H5P_DEFAULT),
                            H5Aclose);
    const int opaque = 3;
    H5Awrite(decode.get(), H5T_NATIVE_INT, &opaque);
  }
  const auto tables = ingest::arrays::read_mat(path);
  EXPECT_EQ(tables.at(0).header, (Names{"t"}));
  ASSERT_EQ(tables[0].notes.size(), 1U);
  EXPECT_TRUE(wording::words(tables[0].notes[0])
                  .starts_with("'tt' is not read: it is a timetable, which MATLAB alone reads"))
      << wording::words(tables[0].notes[0]);
}

TEST_F(MatFiles, DamagedObjectsAreAnswered) {
  const std::string bytes =
      mat_5_file(mat_5_object("tt", "timetable") + mat_5_doubles("t", {0, 1, 2}));
  const auto read = [this](const std::string& changed) {
    return ingest::arrays::read_mat(directory_.file("damaged.mat", changed));
  };
  test::expect_cuts_answered(read, bytes, 40);
  test::expect_changes_answered(read, bytes, 40);
}

TEST_F(MatFiles, RefusalsAreOneLine) {
  const auto refusal = [&](const std::string& bytes) {
    const std::string path = directory_.file("a.mat", bytes);
    return test::refusal_of<InputError>([&] { return ingest::arrays::read_mat(path); })
        .substr(path.size());
  };
  EXPECT_EQ(refusal(""), ": file is empty");
  EXPECT_EQ(refusal("t,q,tau\n0,1,2\n0,1,2\n0,1,2\n"), ": no MAT file, or cut off in its header");
  const std::string path = directory_.path("mass.mat");
  MatMaker(path, forms[1]).add(doubles("mass", 1, 1, {0.49}));
  EXPECT_EQ(test::refusal_of<InputError>([&] { return ingest::arrays::read_mat(path); }),
            path +
                ": no rows of numbers, found mass = 0.49, expected arrays of two or more "
                "numbers");
}

}  // namespace
}  // namespace tribolog::mat_reader_test
