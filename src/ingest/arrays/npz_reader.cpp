#include "ingest/arrays/npz_reader.h"

#include <filesystem>

#include "base/file_contents.h"
#include "ingest/arrays/array_tables.h"
#include "ingest/arrays/npy_array.h"
#include "ingest/arrays/zip_archive.h"

namespace tribolog {
namespace {

constexpr std::string_view array_ending = ".npy";

void add_entry(std::string_view archive, const ZipEntry& entry, const std::string& file,
               FileArrays& found) {
  if (entry.name.ends_with('/')) return;  // a folder
  if (!entry.name.ends_with(array_ending)) {
    found.leave_out(entry.name, "it is no NumPy array");
    return;
  }
  // The widest number has 8 bytes; text and objects may be larger and are not unpacked then.
  if (entry.bytes > 8 * most_values) {
    found.leave_out(entry.name, "it would unpack to more than 16 GiB");
    return;
  }
  const std::string name = entry.name.substr(0, entry.name.size() - array_ending.size());
  add_npy_array(unpack_zip_entry(archive, entry, file), name, file, RecordNames::by_array_and_field,
                found);
}

}  // namespace

std::vector<LogTable> parse_npz(std::string_view bytes, const std::string& file) {
  FileArrays found;
  if (bytes.starts_with("\x93NUMPY")) {
    add_npy_array(bytes, std::filesystem::path(file).stem().string(), file, RecordNames::by_field,
                  found);
  } else {
    for (const ZipEntry& entry : list_zip(bytes, file)) add_entry(bytes, entry, file, found);
  }
  return tables_of(std::move(found), file);
}

std::vector<LogTable> read_npz(const std::string& path) { return parse_npz(read_file(path), path); }

}  // namespace tribolog
