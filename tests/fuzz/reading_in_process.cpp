// In place of ingest/arrays/isolated_reading.cpp and array_libraries.cpp: the fuzzed library in
// this very process, where coverage is seen and no process is started for every input. What crashes
// the library here is given to the program afterwards, whose child process has to survive it
// (run.sh).

#include <new>

#include "base/error.h"
#include "ingest/arrays/isolated_reading.h"

namespace tribolog::ingest::arrays {

FileArrays read_isolated(const std::string& path, const std::function<FileArrays()>& read) {
  try {
    return read();
  } catch (const UnreadableFile& error) {
    throw InputError({path, 0, 0}, {error.what(), "", "", ""});
  } catch (const std::bad_alloc&) {
    throw InputError({path, 0, 0}, {"it claims more memory than it can fill", "", "", ""});
  }
}

ArrayLibraries array_libraries(const std::string&) {
  ArrayLibraries libraries{};
  tribolog_array_libraries(libraries);
  return libraries;
}

}  // namespace tribolog::ingest::arrays
