#pragma once
// Whether a chunked HDF5 dataset's chunks hold what its layout claims. libhdf5 takes it on trust:
// of a chunk that unpacks to fewer bytes it hands over what lies behind it in memory.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "ingest/hdf5_matlab/hdf5_objects.h"

namespace tribolog {

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

}  // namespace tribolog
