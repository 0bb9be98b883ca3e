#include "ingest/arrays/array_libraries.h"

void tribolog_array_libraries(tribolog::ArrayLibraries& libraries) {
  libraries = {tribolog::hdf5_arrays, tribolog::hdf5_leads_to_other_files,
               tribolog::read_mat_variables};
}
