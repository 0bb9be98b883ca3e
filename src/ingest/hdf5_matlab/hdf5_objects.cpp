#include "ingest/hdf5_matlab/hdf5_objects.h"

#include <cstdlib>

#include "ingest/arrays/isolated_reading.h"

namespace tribolog {
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
  if (file < 0) throw UnreadableFile("damaged or no HDF5 file: " + hdf5_reason());
  return file;
}

bool reads_other_files(hid_t dataset) {
  const Hdf5Handle creation(H5Dget_create_plist(dataset), H5Pclose);
  if (!creation.is_open()) return true;
  return H5Pget_layout(creation.get()) == H5D_VIRTUAL || H5Pget_external_count(creation.get()) != 0;
}

}  // namespace tribolog
