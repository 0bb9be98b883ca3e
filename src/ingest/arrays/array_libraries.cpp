#include "ingest/arrays/array_libraries.h"

#include "base/error.h"
#include "base/program_module.h"

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

}  // namespace tribolog::ingest::arrays
