#pragma once
// HDF5 handles that close themselves, and names as C++ strings. Only for the readers of HDF5.

#include <string>
#include <utility>

// One interface for HDF5 1.10, 1.12 and 1.14.
#define H5_USE_110_API
#include <hdf5.h>

namespace tribolog {

/// Owns a handle of any kind; negative where the library could not give one.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Hdf5Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;
  ~Hdf5Handle() {
    if (id_ >= 0) close_(id_);
  }
  [[nodiscard]] hid_t get() const { return id_; }
  [[nodiscard]] bool is_open() const { return id_ >= 0; }

 private:
  hid_t id_;
  Close close_;
};

/// No messages of its own on stderr, no plugins, no locks on files that are only read.
void prepare_hdf5();

/// Opens a file to read it. @throw UnreadableFile with the library's first reason.
hid_t open_hdf5_file(const std::string& path);

/// The innermost message of the library's error stack, "" where it is empty.
std::string hdf5_reason();

/// Is some of the dataset's data in other files (external storage, virtual dataset)?
bool reads_other_files(hid_t dataset);

}  // namespace tribolog
