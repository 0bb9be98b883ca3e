#include "ingest/arrays/mat_reader.h"

#include <cstddef>
#include <limits>

#include <fmt/format.h>

#include "ingest/arrays/array_libraries.h"
#include "ingest/arrays/array_tables.h"
#include "ingest/arrays/isolated_reading.h"
#include "ingest/arrays/mat_elements.h"

namespace tribolog {
namespace {

FileArrays read_variables(const std::string& path, const ArrayLibraries& libraries) {
  const MatVersion version = mat_version(path);
  MatElements elements{std::numeric_limits<std::size_t>::max(), false};
  if (version == MatVersion::mat_7_3) {
    if (libraries.hdf5_leads_to_other_files(path)) {
      throw UnreadableFile("some of its values are in other files, which are not read");
    }
  } else {
    elements = check_mat_elements(path, version);
  }
  FileArrays found;
  const std::size_t number =
      elements.complete == 0 ? 0 : libraries.read_mat_variables(path, elements.complete, found);
  if (version != MatVersion::mat_7_3 && number < elements.complete) {
    found.leave_out(fmt::format("variable {}", number + 1), "damaged, as may be those behind it");
  }
  if (elements.ends_inside) {
    found.leave_out(fmt::format("variable {}", elements.complete + 1), "the file ends inside it");
  }
  return found;
}

}  // namespace

std::vector<LogTable> read_mat(const std::string& path) {
  const ArrayLibraries libraries = array_libraries(path);
  return tables_of(read_isolated(path, [&] { return read_variables(path, libraries); }), path);
}

}  // namespace tribolog
