#pragma once
// HDF5 handles, and whether a dataset's chunks hold what its layout claims.

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

// One interface for HDF5 1.10, 1.12 and 1.14: stated before the library's own header is read.
#define H5_USE_110_API
#include <hdf5.h>

namespace tribolog::ingest::hdf5_matlab {

/// Owns a handle of any kind; negative where the library could not give one.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Hdf5Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;
  ~Hdf5Handle() {
    if (id_ >= 0) close_(id_);
  }
  [[nodiscard]] hid_t get() const { return id_; }
  [[nodiscard]] bool is_open() const { return id_ >= 0; }

 private:
  hid_t id_;
  Close close_;
};

/// No messages of its own on stderr, no plugins, no locks on files that are only read.
void prepare_hdf5();

/// Opens a file to read it. @throw UnreadableFile with the library's first reason.
hid_t open_hdf5_file(const std::string& path);

/// The innermost message of the library's error stack, "" where it is empty.
std::string hdf5_reason();

/// Is some of the dataset's data in other files (external storage, virtual dataset)?
bool reads_other_files(hid_t dataset);

// Whether a chunked HDF5 dataset's chunks hold what its layout claims. libhdf5 takes it on trust:
// of a chunk that unpacks to fewer bytes it hands over what lies behind it in memory.

/// A dataset's layout. Not chunked: no sides.
struct Hdf5Chunks {
  std::vector<hsize_t> sides;  ///< Of one chunk, in numbers.
  std::uint64_t numbers{};     ///< In one chunk, which the library unpacks whole; at most 2^32 - 1.
};

Hdf5Chunks chunks_of(hid_t dataset);

/// What is wrong with the chunks that are stored, "" where nothing is. Deflated chunks are unpacked
/// once for it; those of filters other than deflate, shuffle and fletcher32 are not looked into.
/// @param sides of the dataset; @param number_bytes of one stored number.
std::string chunk_damage(hid_t dataset, const Hdf5Chunks& chunks,
                         const std::vector<std::uint64_t>& sides, std::size_t number_bytes);

}  // namespace tribolog::ingest::hdf5_matlab
