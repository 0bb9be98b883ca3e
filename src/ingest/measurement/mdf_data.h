#pragma once
// The bytes of a data group's records, from the blocks that hold them.

#include <cstdint>
#include <string>
#include <string_view>

#include "base/statement.h"
#include "ingest/measurement/mdf_blocks.h"

namespace tribolog::ingest::measurement {

/// Most bytes that the data of one group are unpacked to: 8 GiB.
inline constexpr std::uint64_t most_unpacked_bytes = std::uint64_t{8} << 30;

struct MdfData {
  std::string_view bytes;  ///< Of the file, or of `unpacked`.
  std::string unpacked;    ///< Where they stand in several blocks, or deflated.
  std::string damage;      ///< Why nothing behind these bytes can be read; empty: nothing is there.
  Statement cut;           ///< The file ends inside them.

  MdfData() = default;
  MdfData(const MdfData&) = delete;
  MdfData& operator=(const MdfData&) = delete;
};

/// Reads blocks ##DT, ##DZ and lists of them, each of which belongs to one group alone.
/// @param link of the data group; 0: no data.
/// @param is_finalized whether the lengths of blocks are final: where not, the last one may be 0.
/// @throw InputError as MdfBlocks::once().
void read_data(MdfBlocks& blocks, MdfLink link, bool is_finalized, MdfData& data);

}  // namespace tribolog::ingest::measurement
