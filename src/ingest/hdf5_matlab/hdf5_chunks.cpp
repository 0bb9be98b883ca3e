#include "ingest/hdf5_matlab/hdf5_chunks.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <libdeflate.h>

#include "ingest/arrays/isolated_reading.h"

namespace tribolog::ingest::hdf5_matlab {

namespace {

herr_t keep_message(unsigned, const H5E_error2_t* error, void* text) {
  if (error->desc != nullptr) *static_cast<std::string*>(text) = error->desc;
  return 1;  // the first is the innermost
}

}  // namespace

void prepare_hdf5() {
  ::setenv("HDF5_USE_FILE_LOCKING", "FALSE", 1);
  ::unsetenv("HDF5_PLUGIN_PRELOAD");
  ::setenv("HDF5_PLUGIN_PATH", "/nonexistent", 1);
  H5open();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  H5PLset_loading_state(0);
}

std::string hdf5_reason() {
  std::string text;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_message, &text);
  return text;
}

hid_t open_hdf5_file(const std::string& path) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (file < 0) throw arrays::UnreadableFile("damaged or no HDF5 file: " + hdf5_reason());
  return file;
}

bool reads_other_files(hid_t dataset) {
  const Hdf5Handle creation(H5Dget_create_plist(dataset), H5Pclose);
  if (!creation.is_open()) return true;
  return H5Pget_layout(creation.get()) == H5D_VIRTUAL || H5Pget_external_count(creation.get()) != 0;
}

namespace {

constexpr std::size_t checksum_bytes = 4;

/// What writing did to a chunk, first to last.
struct Pipeline {
  std::vector<H5Z_filter_t> filters;
  bool spares_edges{};  ///< Chunks that reach over the dataset's end are stored as they are.
};

Pipeline pipeline_of(hid_t creation) {
  Pipeline pipeline;
  unsigned options = 0;
  pipeline.spares_edges = H5Pget_chunk_opts(creation, &options) >= 0 &&
                          (options & H5D_CHUNK_DONT_FILTER_PARTIAL_CHUNKS) != 0;
  const int count = H5Pget_nfilters(creation);
  for (int k = 0; k < count; ++k) {
    unsigned flags = 0;
    unsigned config = 0;
    std::size_t values = 0;
    pipeline.filters.push_back(H5Pget_filter2(creation, static_cast<unsigned>(k), &flags, &values,
                                              nullptr, 0, nullptr, &config));
  }
  return pipeline;
}

/// Unpacks chunks to see how long they are.
class ChunkLengths {
 public:
  explicit ChunkLengths(std::size_t chunk_bytes)
      : chunk_bytes_(chunk_bytes), unpacker_(libdeflate_alloc_decompressor()) {}

  /// Do `stored` bytes come to one chunk with these filters (first to last)? Nothing where that
  /// cannot be seen from outside the library.
  std::optional<bool> are_whole(const std::vector<std::uint8_t>& stored,
                                const std::vector<H5Z_filter_t>& filters) {
    const auto is_deflate = [](H5Z_filter_t filter) { return filter == H5Z_FILTER_DEFLATE; };
    const auto deflate = std::find_if(filters.begin(), filters.end(), is_deflate);
    std::size_t checksums_inside = 0;
    std::size_t checksums_outside = 0;
    for (auto filter = filters.begin(); filter != filters.end(); ++filter) {
      const bool is_inside = filter < deflate;
      if (*filter == H5Z_FILTER_FLETCHER32) {
        (is_inside ? checksums_inside : checksums_outside) += checksum_bytes;
      } else if (filter != deflate &&
                 (*filter != H5Z_FILTER_SHUFFLE || (!is_inside && deflate != filters.end()))) {
        return std::nullopt;
      }
    }
    if (stored.size() < checksums_outside) return false;
    const std::size_t packed = stored.size() - checksums_outside;
    if (deflate == filters.end()) return stored.size() == chunk_bytes_ + checksums_inside;
    unpacked_.resize(chunk_bytes_ + checksums_inside);
    return libdeflate_zlib_decompress(unpacker_.get(), stored.data(), packed, unpacked_.data(),
                                      unpacked_.size(), nullptr) == LIBDEFLATE_SUCCESS;
  }

 private:
  struct Free {
    void operator()(libdeflate_decompressor* unpacker) const {
      libdeflate_free_decompressor(unpacker);
    }
  };
  std::size_t chunk_bytes_;
  std::unique_ptr<libdeflate_decompressor, Free> unpacker_;
  std::vector<std::uint8_t> unpacked_;
};

/// The chunk's filters that were not left out when it was written.
std::vector<H5Z_filter_t> applied(const std::vector<H5Z_filter_t>& filters,
                                  std::uint32_t left_out) {
  std::vector<H5Z_filter_t> kept;
  for (std::size_t k = 0; k < filters.size(); ++k) {
    if (k >= 32 || (left_out >> k & 1U) == 0) kept.push_back(filters[k]);
  }
  return kept;
}

/// Goes to the next chunk's corner, the last side fastest. @return false behind the last.
bool step(std::vector<hsize_t>& corner, const std::vector<hsize_t>& chunk,
          const std::vector<std::uint64_t>& sides) {
  for (std::size_t k = corner.size(); k-- > 0;) {
    corner[k] += chunk[k];
    if (corner[k] < sides[k]) return true;
    corner[k] = 0;
  }
  return false;
}

bool reaches_over(const std::vector<hsize_t>& corner, const std::vector<hsize_t>& chunk,
                  const std::vector<std::uint64_t>& sides) {
  for (std::size_t k = 0; k < corner.size(); ++k) {
    if (corner[k] + chunk[k] > sides[k]) return true;
  }
  return false;
}

/// As the file has it of its first chunk; of chunks without filters the library itself goes by the
/// layout. 0 where there is none.
hsize_t first_chunk_bytes(hid_t dataset) {
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
  std::array<hsize_t, H5S_MAX_RANK> corner{};
  unsigned left_out = 0;
  haddr_t address = 0;
  hsize_t bytes = 0;
  const auto found =
      H5Dget_chunk_info(dataset, space.get(), 0, corner.data(), &left_out, &address, &bytes);
  return found < 0 ? 0 : bytes;
}

}  // namespace

Hdf5Chunks chunks_of(hid_t dataset) {
  constexpr std::uint64_t most = 0xFFFF'FFFF;  // the library's own bound
  const Hdf5Handle creation(H5Dget_create_plist(dataset), H5Pclose);
  if (!creation.is_open() || H5Pget_layout(creation.get()) != H5D_CHUNKED) return {};
  std::array<hsize_t, H5S_MAX_RANK> sides{};
  const int rank = H5Pget_chunk(creation.get(), H5S_MAX_RANK, sides.data());
  Hdf5Chunks chunks;
  chunks.sides.assign(sides.begin(), sides.begin() + std::max(rank, 0));
  chunks.numbers = 1;
  for (const hsize_t side : chunks.sides) {
    chunks.numbers = side != 0 && chunks.numbers > most / side ? most : chunks.numbers * side;
  }
  return chunks;
}

std::string chunk_damage(hid_t dataset, const Hdf5Chunks& chunks,
                         const std::vector<std::uint64_t>& sides, std::size_t number_bytes) {
  if (chunks.sides.size() != sides.size() || chunks.numbers == 0) {
    return "damaged: its chunks are of another shape";
  }
  const Hdf5Handle creation(H5Dget_create_plist(dataset), H5Pclose);
  const Pipeline pipeline = pipeline_of(creation.get());
  const hsize_t chunk_bytes = chunks.numbers * number_bytes;
  if (pipeline.filters.empty() && first_chunk_bytes(dataset) != chunk_bytes) {
    return fmt::format("damaged: its chunks are not of {} numbers", chunks.numbers);
  }
  ChunkLengths lengths(chunk_bytes);
  std::vector<hsize_t> corner(sides.size(), 0);
  std::vector<std::uint8_t> stored;
  do {
    hsize_t bytes = 0;
    if (H5Dget_chunk_storage_size(dataset, corner.data(), &bytes) < 0) {
      return "damaged: " + hdf5_reason();
    }
    if (bytes == 0) continue;  // never written: its numbers are the fill value
    stored.resize(bytes);
    std::uint32_t left_out = 0;
    if (H5Dread_chunk(dataset, H5P_DEFAULT, corner.data(), &left_out, stored.data()) < 0) {
      return "damaged: " + hdf5_reason();
    }
    const bool is_spared = pipeline.spares_edges && reaches_over(corner, chunks.sides, sides);
    const std::vector<H5Z_filter_t> filters =
        is_spared ? std::vector<H5Z_filter_t>{} : applied(pipeline.filters, left_out);
    if (!lengths.are_whole(stored, filters).value_or(true)) {
      return fmt::format("damaged: {} stored bytes do not unpack to a chunk of {} numbers", bytes,
                         chunks.numbers);
    }
  } while (step(corner, chunks.sides, sides));
  return {};
}

}  // namespace tribolog::ingest::hdf5_matlab
