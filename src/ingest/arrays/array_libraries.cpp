
#include "base/error.h"
#include "base/program_module.h"
#include "ingest/arrays/array_readers.h"
#include "ingest/arrays/array_tables.h"
#include "ingest/arrays/isolated_reading.h"

namespace tribolog::ingest::arrays {

ArrayLibraries array_libraries(const std::string& path) {
  try {
    void* const give =
        function_of({"tribolog_arrays", TRIBOLOG_ARRAY_PACKAGES}, "tribolog_array_libraries");
    ArrayLibraries libraries{};
    reinterpret_cast<decltype(&tribolog_array_libraries)>(give)(libraries);
    return libraries;
  } catch (const MissingModule& missing) {
    throw InputError({path, 0, 0},
                     {"logs of HDF5 and MATLAB cannot be read here", "", "", missing.what()});
  }
}

std::vector<log::LogTable> read_hdf5(const std::string& path) {
  const ArrayLibraries libraries = array_libraries(path);
  return tables_of(read_isolated(path, [&] { return libraries.hdf5_arrays(path); }), path);
}

}  // namespace tribolog::ingest::arrays
