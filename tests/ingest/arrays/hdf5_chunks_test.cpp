// A chunk that does not unpack to what the layout claims is refused; every way in which the library
// stores chunks is read.

#include "ingest/hdf5_matlab/hdf5_chunks.h"

#include <numeric>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/temporary_directory.h"
#include "ingest/arrays/array_readers.h"
#include "wording/words.h"

namespace tribolog::hdf5_chunks_test {
namespace {

using Names = std::vector<std::string>;
using Values = std::vector<double>;

constexpr hsize_t rows = 10;
constexpr hsize_t chunk_rows = 4;  // the third chunk reaches over the end
const Values ramp = [] {
  Values values(rows);
  std::iota(values.begin(), values.end(), 1.0);
  return values;
}();

class Hdf5ChunksTest : public testing::Test {
 protected:
  test::TemporaryDirectory directory_;
  std::string path_ = directory_.path("log.h5");

  /// Datasets "t", plain, and "q" in chunks with the filters that `set` puts on them.
  template <typename Set, typename Change>
  void make(const Set& set, const Change& change) {
    const ingest::hdf5_matlab::Hdf5Handle file(
        H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
    const ingest::hdf5_matlab::Hdf5Handle space(H5Screate_simple(1, &rows, nullptr), H5Sclose);
    const ingest::hdf5_matlab::Hdf5Handle plain(
        H5Dcreate2(file.get(), "t", H5T_IEEE_F64LE, space.get(), H5P_DEFAULT, H5P_DEFAULT,
                   H5P_DEFAULT),
        H5Dclose);
    H5Dwrite(plain.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, ramp.data());
    const ingest::hdf5_matlab::Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_chunk(creation.get(), 1, &chunk_rows);
    set(creation.get());
    const ingest::hdf5_matlab::Hdf5Handle data(
        H5Dcreate2(file.get(), "q", H5T_IEEE_F64LE, space.get(), H5P_DEFAULT, creation.get(),
                   H5P_DEFAULT),
        H5Dclose);
    H5Dwrite(data.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, ramp.data());
    change(data.get());
  }
  template <typename Set>
  void make(const Set& set) {
    make(set, [](hid_t) {});
  }

  [[nodiscard]] Values q() const {
    const auto tables = ingest::arrays::read_hdf5(path_);
    EXPECT_EQ(tables[0].header, (Names{"q", "t"}));
    return tables[0].columns.front().values;
  }
  [[nodiscard]] std::string first_note() const {
    const auto tables = ingest::arrays::read_hdf5(path_);
    EXPECT_EQ(tables[0].header, Names{"t"});
    return tables[0].notes.empty() ? "" : wording::words(tables[0].notes[0]);
  }
};

void deflated(hid_t creation) { H5Pset_deflate(creation, 6); }

TEST_F(Hdf5ChunksTest, EveryWayOfStoringIsRead) {
  make([](hid_t) {});
  EXPECT_EQ(q(), ramp);
  make(deflated);
  EXPECT_EQ(q(), ramp);
  make([](hid_t creation) {
    H5Pset_fletcher32(creation);
    H5Pset_shuffle(creation);
    H5Pset_deflate(creation, 6);
    H5Pset_fletcher32(creation);
  });
  EXPECT_EQ(q(), ramp);
  make([](hid_t creation) {  // shuffled after it was packed: not looked into
    H5Pset_deflate(creation, 6);
    H5Pset_shuffle(creation);
  });
  EXPECT_EQ(q(), ramp);
  make([](hid_t creation) { H5Pset_scaleoffset(creation, H5Z_SO_FLOAT_DSCALE, 2); });
  EXPECT_EQ(q(), ramp);
  make([](hid_t creation) {
    H5Pset_deflate(creation, 6);
    H5Pset_chunk_opts(creation, H5D_CHUNK_DONT_FILTER_PARTIAL_CHUNKS);
  });
  EXPECT_EQ(q(), ramp);
}

TEST_F(Hdf5ChunksTest, AChunkWhoseFilterWasLeftOutIsRead) {
  make(deflated, [](hid_t data) {
    const hsize_t corner = 4;
    const Values stored{50, 60, 70, 80};
    H5Dwrite_chunk(data, H5P_DEFAULT, 1, &corner, sizeof(double) * stored.size(), stored.data());
  });
  EXPECT_EQ(q(), (Values{1, 2, 3, 4, 50, 60, 70, 80, 9, 10}));
}

TEST_F(Hdf5ChunksTest, AChunkTooShortIsRefused) {
  make(deflated, [](hid_t data) {
    const hsize_t corner = 4;
    const Values stored{50, 60, 70};
    H5Dwrite_chunk(data, H5P_DEFAULT, 1, &corner, sizeof(double) * stored.size(), stored.data());
  });
  EXPECT_EQ(first_note(),
            "'q' is not read: damaged: 24 stored bytes do not unpack to a chunk of 4 numbers");
}

/// Chunks of 4 numbers that the layout claims to be of 5, as one changed byte of it does.
TEST_F(Hdf5ChunksTest, AChunkThatUnpacksToLessIsRefused) {
  for (const bool is_deflated : {false, true}) {
    make([is_deflated](hid_t creation) {
      if (is_deflated) deflated(creation);
    });
    std::string bytes = directory_.contents("log.h5");
    // Layout message, version 3: class 2 (chunked), 2 sides, address, then 4 and 8 in 4 bytes each.
    const std::string sides("\x04\0\0\0\x08\0\0\0", 8);
    const std::size_t at = bytes.find(sides);
    ASSERT_NE(at, std::string::npos);
    ASSERT_EQ(bytes.find(sides, at + 1), std::string::npos);
    bytes[at] = 5;
    path_ = directory_.file("log.h5", bytes);
    EXPECT_TRUE(first_note().starts_with("'q' is not read: damaged")) << first_note();
  }
}

TEST_F(Hdf5ChunksTest, MoreBytesThanTheFileHasAreRefused) {
  make([](hid_t) {});
  std::string bytes = directory_.contents("log.h5");
  // "t" is stored in one piece; its layout claims 80 bytes.
  const std::string claim("\x50\0\0\0\0\0\0\0", 8);
  std::size_t changed = 0;
  for (std::size_t at = bytes.find(claim); at != std::string::npos;
       at = bytes.find(claim, at + 1)) {
    bytes[at + 3] = 1;
    ++changed;
  }
  ASSERT_EQ(changed, 1U);
  path_ = directory_.file("log.h5", bytes);
  const std::string note = wording::words(ingest::arrays::read_hdf5(path_)[0].notes[0]);
  const std::string claimed = fmt::format(
      "'t' is not read: damaged: {} of the file's {} bytes are claimed", 0x0100'0050, bytes.size());
  // libhdf5 2 writes a checksum beside the layout.
  const std::string sum_is_wrong = "'t' is not read: damaged: incorrect metadata checksum";
  EXPECT_TRUE(note == claimed || note.starts_with(sum_is_wrong)) << note;
}

}  // namespace
}  // namespace tribolog::hdf5_chunks_test
