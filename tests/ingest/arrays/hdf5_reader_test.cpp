#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/temporary_directory.h"
#include "ingest/arrays/array_readers.h"
#include "ingest/hdf5_matlab/hdf5_chunks.h"
#include "ingest/log/log_format.h"
#include "support/breadth.h"
#include "support/damaged_files.h"
#include "wording/words.h"

namespace tribolog::hdf5_reader_test {
namespace {

using Names = std::vector<std::string>;
using Values = std::vector<double>;
using Sides = std::vector<hsize_t>;

/// An HDF5 file in the making, by the library itself.
class Hdf5File {
 public:
  explicit Hdf5File(const std::string& path)
      : file_(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose) {}
  [[nodiscard]] hid_t id() const { return file_.get(); }

  void group(const char* name) {
    H5Gclose(H5Gcreate2(id(), name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  }
  template <class Number>
  void add(const char* name, const Sides& sides, const std::vector<Number>& values, hid_t memory,
           hid_t stored, bool deflated = false, const char* unit = nullptr) {
    const ingest::hdf5_matlab::Hdf5Handle space(
        H5Screate_simple(static_cast<int>(sides.size()), sides.data(), nullptr), H5Sclose);
    const ingest::hdf5_matlab::Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    if (deflated) {
      H5Pset_chunk(creation.get(), static_cast<int>(sides.size()), sides.data());
      H5Pset_shuffle(creation.get());
      H5Pset_deflate(creation.get(), 6);
    }
    const ingest::hdf5_matlab::Hdf5Handle data(
        H5Dcreate2(id(), name, stored, space.get(), H5P_DEFAULT, creation.get(), H5P_DEFAULT),
        H5Dclose);
    ASSERT_GE(H5Dwrite(data.get(), memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
    if (unit != nullptr) add_text_attribute(data.get(), "units", unit);
  }
  void add(const char* name, const Sides& sides, const Values& values) {
    add(name, sides, values, H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE);
  }
  void add_text(const char* name, const char* text) {
    const ingest::hdf5_matlab::Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type.get(), std::strlen(text));
    const ingest::hdf5_matlab::Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const ingest::hdf5_matlab::Hdf5Handle data(
        H5Dcreate2(id(), name, type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
        H5Dclose);
    H5Dwrite(data.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text);
  }

 private:
  static void add_text_attribute(hid_t object, const char* name, const char* text) {
    const ingest::hdf5_matlab::Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type.get(), H5T_VARIABLE);
    const ingest::hdf5_matlab::Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const ingest::hdf5_matlab::Hdf5Handle attribute(
        H5Acreate2(object, name, type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    H5Awrite(attribute.get(), type.get(), &text);
  }
  ingest::hdf5_matlab::Hdf5Handle file_;
};

Values random_values(std::size_t count) {
  std::mt19937_64 random(5);
  Values values(count);
  for (double& value : values) {
    do value = std::bit_cast<double>(random());
    while (!std::isfinite(value));
  }
  return values;
}

class Hdf5 : public testing::Test {
 protected:
  test::TemporaryDirectory directory_;
  std::string path_ = directory_.path("log.h5");

  void make_robot_log(bool deflated) {
    Hdf5File file(path_);
    file.group("arm");
    file.add("arm/q", {200, 3}, random_values(600), H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE, deflated,
             "rad");
    file.add("t", {200}, random_values(200), H5T_NATIVE_DOUBLE, H5T_IEEE_F64BE, deflated);
    file.add("arm/mass", {1}, {0.49});
    file.add_text("robot", "UR10e");
  }
  std::string refusal() {
    return test::refusal_of<InputError>([&] { return ingest::arrays::read_hdf5(path_); });
  }
};

TEST_F(Hdf5, RobotLogsAreReadToTheBit) {
  for (const bool deflated : {false, true}) {
    make_robot_log(deflated);
    EXPECT_EQ(ingest::log::detect_log_format(directory_.contents("log.h5"), path_),
              ingest::log::LogFormat::hdf5);
    const auto tables = ingest::arrays::read_hdf5(path_);
    ASSERT_EQ(tables.size(), 1U);
    const ingest::log::LogTable& table = tables[0];
    ASSERT_EQ(table.header, (Names{"t", "arm/q_0", "arm/q_1", "arm/q_2"}));
    EXPECT_EQ(table.columns[1].header.unit, "rad");
    EXPECT_EQ(wording::words(table.notes), (Names{"arm/mass = 0.49", "robot = 'UR10e'"}));
    const Values t = random_values(200);
    const Values q = random_values(600);
    for (std::size_t row = 0; row < 200; ++row) {
      ASSERT_EQ(std::bit_cast<std::uint64_t>(table.columns[0].values[row]),
                std::bit_cast<std::uint64_t>(t[row]));
      for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_EQ(std::bit_cast<std::uint64_t>(table.columns[1 + i].values[row]),
                  std::bit_cast<std::uint64_t>(q[3 * row + i]));
      }
    }
  }
}

TEST_F(Hdf5, IntegersAndBooleans) {
  {
    Hdf5File file(path_);
    file.add<std::int64_t>("stamp", {2}, {(1LL << 53) + 1, 5}, H5T_NATIVE_INT64, H5T_STD_I64BE);
    file.add<std::int16_t>("ticks", {2}, {-7, 9}, H5T_NATIVE_INT16, H5T_STD_I16BE);
    const ingest::hdf5_matlab::Hdf5Handle boolean(H5Tenum_create(H5T_NATIVE_INT8), H5Tclose);
    const signed char no = 0;
    const signed char yes = 1;
    H5Tenum_insert(boolean.get(), "FALSE", &no);
    H5Tenum_insert(boolean.get(), "TRUE", &yes);
    file.add<signed char>("enabled", {2}, {1, 0}, boolean.get(), boolean.get());
  }
  const auto tables = ingest::arrays::read_hdf5(path_);
  ASSERT_EQ(tables[0].header, (Names{"enabled", "stamp", "ticks"}));
  EXPECT_EQ(tables[0].columns[0].values, (Values{1, 0}));
  EXPECT_EQ(tables[0].columns[2].values, (Values{-7, 9}));
  EXPECT_EQ(wording::words(tables[0].notes),
            (Names{"'stamp' holds integers of 2^53 and more: they are rounded"}));
}

TEST_F(Hdf5, OtherLengthsAndTypesAreNamed) {
  {
    Hdf5File file(path_);
    file.group("fast");
    file.add("fast/q", {4}, {1, 2, 3, std::nan("")});
    file.add("limits", {2}, {1, 2});
    file.add("picture", {2, 2, 2}, Values(8));
    const ingest::hdf5_matlab::Hdf5Handle record(H5Tcreate(H5T_COMPOUND, 8), H5Tclose);
    H5Tinsert(record.get(), "x", 0, H5T_NATIVE_DOUBLE);
    file.add("records", {2}, Values(2), record.get(), record.get());
    const ingest::hdf5_matlab::Hdf5Handle space(H5Screate(H5S_NULL), H5Sclose);
    H5Dclose(H5Dcreate2(file.id(), "nothing", H5T_NATIVE_DOUBLE, space.get(), H5P_DEFAULT,
                        H5P_DEFAULT, H5P_DEFAULT));
  }
  const auto tables = ingest::arrays::read_hdf5(path_);
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_EQ(tables[0].group, "fast");
  EXPECT_EQ(tables[0].columns[0].gaps, 1U);
  EXPECT_EQ(tables[1].group, "limits");
  EXPECT_EQ(wording::words(tables[0].notes),
            (Names{"'nothing' is not read: it is empty",
                   "'picture' is not read: it has more than two dimensions: 2 x 2 x 2",
                   "'records' is not read: it holds records of several fields (compound)"}));
}

TEST_F(Hdf5, NothingOutsideOfTheFileIsRead) {
  const std::string other = directory_.path("other.h5");
  Hdf5File(other).add("secret", {3}, {1, 2, 3});
  const std::string raw = directory_.file("raw.bin", std::string(24, 'x'));
  {
    Hdf5File file(path_);
    file.add("t", {3}, {0, 1, 2});
    H5Lcreate_external(other.c_str(), "/secret", file.id(), "external", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_soft("/t", file.id(), "soft", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_soft("/external/secret", file.id(), "soft_out", H5P_DEFAULT, H5P_DEFAULT);
    const hsize_t three = 3;
    const ingest::hdf5_matlab::Hdf5Handle space(H5Screate_simple(1, &three, nullptr), H5Sclose);
    const ingest::hdf5_matlab::Hdf5Handle storage(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_external(storage.get(), raw.c_str(), 0, 24);
    H5Dclose(H5Dcreate2(file.id(), "stored_elsewhere", H5T_NATIVE_DOUBLE, space.get(), H5P_DEFAULT,
                        storage.get(), H5P_DEFAULT));
    const ingest::hdf5_matlab::Hdf5Handle mapping(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_virtual(mapping.get(), space.get(), other.c_str(), "/secret", space.get());
    H5Dclose(H5Dcreate2(file.id(), "virtual", H5T_NATIVE_DOUBLE, space.get(), H5P_DEFAULT,
                        mapping.get(), H5P_DEFAULT));
  }
  const auto tables = ingest::arrays::read_hdf5(path_);
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_EQ(tables[0].header, (Names{"t"}));
  EXPECT_EQ(wording::words(tables[0].notes),
            (Names{"'external' is not read: it is a link to another file",
                   "'soft' is not read: it is a link to another name",
                   "'soft_out' is not read: it is a link to another name",
                   "'stored_elsewhere' is not read: its values are in another file",
                   "'virtual' is not read: its values are in another file"}));
}

TEST_F(Hdf5, GroupsThatHoldEachOtherEnd) {
  {
    Hdf5File file(path_);
    file.group("a");
    H5Lcreate_hard(file.id(), "/", file.id(), "a/root", H5P_DEFAULT, H5P_DEFAULT);
    file.add("a/t", {2}, {0, 1});
    H5Lcreate_hard(file.id(), "a/t", file.id(), "t", H5P_DEFAULT, H5P_DEFAULT);
  }
  const auto tables = ingest::arrays::read_hdf5(path_);
  EXPECT_EQ(tables[0].header, (Names{"a/t"}));
  EXPECT_EQ(tables[0].notes.size(), 2U);
}

TEST_F(Hdf5, ClaimedLengthsAreNotBelieved) {
  {
    Hdf5File file(path_);
    file.add("t", {2}, {0, 1});
    const hsize_t huge = hsize_t{1} << 30;
    const hsize_t chunk = 1024;
    const ingest::hdf5_matlab::Hdf5Handle space(H5Screate_simple(1, &huge, nullptr), H5Sclose);
    const ingest::hdf5_matlab::Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_chunk(creation.get(), 1, &chunk);
    H5Dclose(H5Dcreate2(file.id(), "empty_8_GiB", H5T_NATIVE_DOUBLE, space.get(), H5P_DEFAULT,
                        creation.get(), H5P_DEFAULT));
  }
  EXPECT_EQ(wording::words(ingest::arrays::read_hdf5(path_)[0].notes),
            (Names{"'empty_8_GiB' is not read: 1073741824 numbers are claimed, 0 bytes are "
                   "stored"}));
}

TEST_F(Hdf5, RefusalsAreOneLine) {
  path_ = directory_.file("log.h5", "no HDF5");
  // What follows is the library's own reason, which differs between its versions.
  EXPECT_TRUE(refusal().starts_with(path_ + ": damaged or no HDF5 file: ")) << refusal();
  Hdf5File(path_).add("mass", {1}, {0.49});
  EXPECT_EQ(refusal(), path_ +
                           ": no rows of numbers, found mass = 0.49, expected arrays of two or "
                           "more numbers");
  path_ = directory_.path();
  EXPECT_EQ(refusal(), path_ + ": cannot read: is a directory");
}

TEST_F(Hdf5, DamageIsAnswered) {
  const auto read = [this](const std::string& bytes) {
    return ingest::arrays::read_hdf5(directory_.file("damaged.h5", bytes));
  };
  for (const bool deflated : {false, true}) {
    make_robot_log(deflated);
    const std::string bytes = directory_.contents("log.h5");
    test::expect_cuts_answered(read, bytes, 250);
    test::expect_changes_answered(read, bytes, 250);
  }
}

/// Most of a file is values: here the bytes of its structure are changed, which lie at its start
/// and where the library puts its tables.
TEST_F(Hdf5, DamagedStructureIsAnswered) {
  make_robot_log(true);
  const std::string bytes = directory_.contents("log.h5");
  std::mt19937 random(7);
  for (std::size_t i = 0; i < test::seeds_of(125, 500); ++i) {
    std::string changed = bytes;
    for (int k = 0; k < 4; ++k) changed[random() % 3000] = static_cast<char>(random());
    test::expect_answer(
        [this](const std::string& b) {
          return ingest::arrays::read_hdf5(directory_.file("damaged.h5", b));
        },
        changed, "case " + std::to_string(i));
  }
}

}  // namespace
}  // namespace tribolog::hdf5_reader_test
