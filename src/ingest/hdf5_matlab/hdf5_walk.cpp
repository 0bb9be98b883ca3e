#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "ingest/arrays/array_tables.h"
#include "ingest/arrays/isolated_reading.h"
#include "ingest/hdf5_matlab/hdf5_chunks.h"
#include "ingest/hdf5_matlab/mat_variables.h"

namespace tribolog::ingest::hdf5_matlab {

namespace {

constexpr int deepest_group = 32;
constexpr std::size_t most_objects = 100'000;
/// Deflate, the densest filter in use, makes at most 1032 bytes of one.
constexpr std::uint64_t largest_ratio = 1032;

/// "" where the type is a text that cannot be read as one.
std::string read_text(hid_t object, hid_t type, bool is_attribute) {
  const auto read = [&](hid_t memory_type, void* data) {
    return is_attribute ? H5Aread(object, memory_type, data)
                        : H5Dread(object, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data);
  };
  const Hdf5Handle copy(H5Tcopy(type), H5Tclose);
  if (H5Tis_variable_str(type) > 0) {
    char* text = nullptr;
    if (read(copy.get(), &text) < 0 || text == nullptr) return {};
    const std::string result(text, std::min(std::char_traits<char>::length(text), longest_text));
    H5free_memory(text);
    return result;
  }
  const std::size_t length = H5Tget_size(type);
  if (length == 0 || length > longest_text) return {};
  std::string text(length, '\0');
  if (read(copy.get(), text.data()) < 0) return {};
  return text.substr(0, text.find('\0'));
}

std::string unit_of(hid_t dataset) {
  for (const char* name : {"units", "unit"}) {
    if (H5Aexists(dataset, name) <= 0) continue;
    const Hdf5Handle attribute(H5Aopen(dataset, name, H5P_DEFAULT), H5Aclose);
    const Hdf5Handle type(H5Aget_type(attribute.get()), H5Tclose);
    const Hdf5Handle space(H5Aget_space(attribute.get()), H5Sclose);
    const bool is_text = H5Tget_class(type.get()) == H5T_STRING;
    if (is_text && H5Sget_simple_extent_npoints(space.get()) == 1) {
      return read_text(attribute.get(), type.get(), true);
    }
  }
  return {};
}

std::string why_not_numbers(H5T_class_t kind) {
  switch (kind) {
    case H5T_STRING:
      return "it holds texts";
    case H5T_COMPOUND:
      return "it holds records of several fields (compound)";
    case H5T_REFERENCE:
      return "it holds references";
    case H5T_VLEN:
    case H5T_ARRAY:
      return "it holds lists";
    default:
      return "its type is not one of numbers";
  }
}

class FileWalk {
 public:
  explicit FileWalk(const std::string& path) : file_(open_hdf5_file(path), H5Fclose) {
    visit_group(file_.get(), "/", "", 0);
  }
  arrays::FileArrays found;
  bool leads_elsewhere{};

  void read_arrays() {
    for (const std::string& name : datasets_) read(name);
  }

 private:
  struct Link {
    std::string name;
    H5L_type_t type;
  };

  static herr_t keep_link(hid_t, const char* name, const H5L_info_t* info, void* links) {
    auto& list = *static_cast<std::vector<Link>*>(links);
    list.push_back({name, info->type});
    return list.size() > most_objects ? -1 : 0;
  }

  /// Nothing where the object's header is damaged.
  static std::optional<H5O_info_t> info_of(hid_t object) {
    H5O_info_t info{};
    if (H5Oget_info(object, &info) < 0) return std::nullopt;
    return info;
  }

  /// First to visit an object? Groups may hold each other.
  bool is_new(const H5O_info_t& object) { return seen_.insert(object.addr).second; }

  void visit_group(hid_t parent, const std::string& link, const std::string& path, int depth) {
    const Hdf5Handle group(H5Gopen2(parent, link.c_str(), H5P_DEFAULT), H5Gclose);
    std::vector<Link> links;
    hsize_t position = 0;
    if (!group.is_open() ||
        H5Literate(group.get(), H5_INDEX_NAME, H5_ITER_INC, &position, keep_link, &links) < 0) {
      found.leave_out(path.empty() ? "/" : path, "its list of objects is damaged");
      return;
    }
    if (depth == 0) {
      if (const auto root = info_of(group.get())) (void)is_new(*root);
    }
    for (const Link& child : links) visit_link(group.get(), child, path, depth);
  }

  void visit_link(hid_t group, const Link& link, const std::string& path, int depth) {
    const std::string full = path.empty() ? link.name : path + "/" + link.name;
    if (link.type != H5L_TYPE_HARD) {
      leads_elsewhere = leads_elsewhere || link.type != H5L_TYPE_SOFT;
      found.leave_out(full, link.type == H5L_TYPE_SOFT ? "it is a link to another name"
                                                       : "it is a link to another file");
      return;
    }
    const Hdf5Handle object(H5Oopen(group, link.name.c_str(), H5P_DEFAULT), H5Oclose);
    if (!object.is_open()) return found.leave_out(full, "damaged: " + hdf5_reason());
    const std::optional<H5O_info_t> info = info_of(object.get());
    if (!info) return found.leave_out(full, "damaged: " + hdf5_reason());
    if (!is_new(*info)) {
      return found.leave_out(full, "it is another name of an object that was met already");
    }
    if (seen_.size() > most_objects)
      throw arrays::UnreadableFile("more than 100000 objects in the file");
    if (info->type == H5O_TYPE_GROUP) {
      if (depth == deepest_group) return found.leave_out(full, "groups are nested too deeply");
      visit_group(group, link.name, full, depth + 1);
    } else if (info->type == H5O_TYPE_DATASET) {
      const bool elsewhere = reads_other_files(object.get());
      leads_elsewhere = leads_elsewhere || elsewhere;
      if (elsewhere) return found.leave_out(full, "its values are in another file");
      datasets_.push_back(full);
    }
  }

  void read(const std::string& name) {
    const Hdf5Handle dataset(H5Dopen2(file_.get(), name.c_str(), H5P_DEFAULT), H5Dclose);
    const Hdf5Handle type(H5Dget_type(dataset.get()), H5Tclose);
    const Hdf5Handle space(H5Dget_space(dataset.get()), H5Sclose);
    if (!type.is_open() || !space.is_open()) {
      return found.leave_out(name, "damaged: " + hdf5_reason());
    }
    const H5T_class_t kind = H5Tget_class(type.get());
    const bool is_number = kind == H5T_INTEGER || kind == H5T_FLOAT || kind == H5T_ENUM;
    const int rank = H5Sget_simple_extent_ndims(space.get());
    if (kind == H5T_STRING && H5Sget_simple_extent_npoints(space.get()) == 1) {
      found.texts.emplace_back(name, read_text(dataset.get(), type.get(), false));
      return;
    }
    if (!is_number) return found.leave_out(name, why_not_numbers(kind));
    if (rank < 0 || H5Sget_simple_extent_type(space.get()) == H5S_NULL) {
      return found.leave_out(name, "it is empty");
    }
    std::vector<hsize_t> sides(static_cast<std::size_t>(rank));
    H5Sget_simple_extent_dims(space.get(), sides.data(), nullptr);
    read_numbers(name, dataset.get(), type.get(), {sides.begin(), sides.end()});
  }

  /// What the file claims of a dataset and does not hold, "" where nothing is seen: looked for
  /// before memory is taken for it. Each of a damaged file's datasets may claim the same bytes.
  std::string unkept_claim(hid_t dataset, hid_t type, const std::vector<std::uint64_t>& sides,
                           std::uint64_t count) {
    const std::uint64_t stored = H5Dget_storage_size(dataset);
    const std::uint64_t file_bytes = bytes_of_file();
    if (stored > file_bytes) {
      return fmt::format("damaged: {} of the file's {} bytes are claimed", stored, file_bytes);
    }
    const Hdf5Chunks chunks = chunks_of(dataset);
    const bool is_chunked = !chunks.sides.empty();
    const std::uint64_t numbers = std::max(count, chunks.numbers);
    const std::uint64_t claimed = numbers * H5Tget_size(type);
    if (stored == 0 || claimed / (is_chunked ? largest_ratio : 1) > stored ||
        (claimed_bytes_ + claimed) / largest_ratio > file_bytes) {
      return fmt::format("{} numbers are claimed, {} bytes are stored", numbers, stored);
    }
    claimed_bytes_ += claimed;
    return is_chunked ? chunk_damage(dataset, chunks, sides, H5Tget_size(type)) : std::string();
  }

  void read_numbers(const std::string& name, hid_t dataset, hid_t type,
                    const std::vector<std::uint64_t>& sides) {
    arrays::NamedArray array;
    array.name = name;
    const std::uint64_t values_before = found.values;
    if (!arrays::shape_array(sides, array, found)) return;
    const std::uint64_t count = found.values - values_before;
    if (const std::string unkept = unkept_claim(dataset, type, sides, count); !unkept.empty()) {
      found.values = values_before;
      return found.leave_out(name, unkept);
    }
    array.values.resize(count);
    if (H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, array.values.data()) <
        0) {
      return found.leave_out(name, "damaged: " + hdf5_reason());
    }
    if (H5Tget_class(type) != H5T_FLOAT && H5Tget_size(type) == 8) {
      array.was_rounded = std::any_of(array.values.begin(), array.values.end(), [](double value) {
        return std::abs(value) >= arrays::first_rounded_integer;
      });
    }
    array.unit = unit_of(dataset);
    found.arrays.push_back(std::move(array));
  }

  [[nodiscard]] std::uint64_t bytes_of_file() const {
    hsize_t bytes = 0;
    return H5Fget_filesize(file_.get(), &bytes) < 0 ? 0 : bytes;
  }

  Hdf5Handle file_;
  std::uint64_t claimed_bytes_{0};
  std::set<haddr_t> seen_;
  std::vector<std::string> datasets_;
};

bool hdf5_leads_to_other_files(const std::string& path) {
  prepare_hdf5();
  return FileWalk(path).leads_elsewhere;
}

arrays::FileArrays hdf5_arrays(const std::string& path) {
  prepare_hdf5();
  FileWalk walk(path);
  walk.read_arrays();
  return std::move(walk.found);
}

}  // namespace
}  // namespace tribolog::ingest::hdf5_matlab

void tribolog_array_libraries(tribolog::ingest::arrays::ArrayLibraries& libraries) {
  libraries = {tribolog::ingest::hdf5_matlab::hdf5_arrays,
               tribolog::ingest::hdf5_matlab::hdf5_leads_to_other_files,
               tribolog::ingest::hdf5_matlab::read_mat_variables};
}
