#include "ingest/arrays/array_libraries.h"
#include "ingest/arrays/array_readers.h"
#include "ingest/arrays/array_tables.h"
#include "ingest/arrays/isolated_reading.h"

namespace tribolog::ingest::arrays {

std::vector<log::LogTable> read_hdf5(const std::string& path) {
  const ArrayLibraries libraries = array_libraries(path);
  return tables_of(read_isolated(path, [&] { return libraries.hdf5_arrays(path); }), path);
}

}  // namespace tribolog::ingest::arrays
