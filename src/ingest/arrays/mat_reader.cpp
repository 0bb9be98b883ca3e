#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "ingest/arrays/array_readers.h"
#include "ingest/arrays/array_tables.h"
#include "ingest/arrays/byte_order.h"
#include "ingest/arrays/isolated_reading.h"
#include "ingest/arrays/mat_stream.h"
#include "ingest/arrays/matlab_objects.h"

namespace tribolog::ingest::arrays {

// The variables of a MAT file as its bytes lay them out, before a library interprets them.

namespace {

enum class MatVersion { mat_4, mat_5, mat_7_3 };

struct MatElements {
  std::size_t complete{};                  ///< Variables that are in the file as a whole.
  bool ends_inside{};                      ///< One more is begun: the file is cut off.
  std::vector<MatObjects> with_objects{};  ///< Those that are or hold objects.
};

constexpr std::size_t header_bytes_5 = 128;
constexpr std::size_t tag_bytes_5 = 8;
constexpr std::size_t header_bytes_4 = 20;

[[noreturn]] void refuse(std::size_t number, const std::string& what) {
  throw UnreadableFile("damaged MAT file: variable " + std::to_string(number) + " " + what);
}

MatElements check_version_5(MatBytes& file) {
  constexpr std::uint32_t matrix = 14;
  constexpr std::uint32_t compressed = 15;
  const bool big_endian = file.at(126, 2) == "MI";
  MatElements found;
  for (std::uint64_t at = header_bytes_5; at < file.size();) {
    const std::string tag = file.at(at, tag_bytes_5);
    const std::uint64_t left = file.size() - at;
    const std::uint64_t length =
        tag.size() < tag_bytes_5 ? left : number_at<std::uint32_t>(tag, 4, big_endian);
    if (left < tag_bytes_5 || length > left - tag_bytes_5) {
      found.ends_inside = true;
      break;
    }
    const auto type = number_at<std::uint32_t>(tag, 0, big_endian);
    if (type != matrix && type != compressed) {
      refuse(found.complete + 1, "is of the unknown kind " + std::to_string(type));
    }
    const bool is_packed = type == compressed;
    MatStream stream(file, is_packed ? at + tag_bytes_5 : at,
                     is_packed ? length : tag_bytes_5 + length, is_packed);
    MatObjects objects;
    const std::string misfit = check_mat_matrix(stream, big_endian, objects);
    if (!stream.finish()) refuse(found.complete + 1, "has a wrong checksum");
    if (!misfit.empty()) refuse(found.complete + 1, misfit);
    if (!objects.classes.empty()) found.with_objects.push_back(std::move(objects));
    at += tag_bytes_5 + length;
    ++found.complete;
  }
  return found;
}

/// Bytes of one value by the second digit of a MAT 4 type.
std::optional<std::uint64_t> value_bytes_4(std::uint32_t type) {
  constexpr std::array<std::uint64_t, 6> bytes = {8, 4, 4, 2, 2, 1};
  const std::uint32_t digit = type / 10 % 10;
  if (type >= 5000 || digit >= bytes.size()) return std::nullopt;
  return bytes[digit];
}

MatElements check_version_4(MatBytes& file) {
  MatElements found;
  for (std::uint64_t at = 0; at < file.size();) {
    const std::string header = file.at(at, header_bytes_4);
    const std::uint64_t left = file.size() - at;
    found.ends_inside = header.size() < header_bytes_4;
    if (found.ends_inside) break;
    const bool big_endian = number_at<std::uint32_t>(header, 0) >= 5000;
    const auto field = [&](std::size_t i) {
      return number_at<std::uint32_t>(header, 4 * i, big_endian);
    };
    const auto value_bytes = value_bytes_4(field(0));
    if (!value_bytes || field(3) > 1 || field(4) > 4096) {
      refuse(found.complete + 1, "has a header that cannot be");
    }
    const std::uint64_t rest = left - header_bytes_4;
    const std::uint64_t count = std::uint64_t{field(1)} * field(2);
    const std::uint64_t room = rest / *value_bytes / (1 + field(3));
    found.ends_inside =
        field(4) > rest || count > room || field(4) + count * *value_bytes * (1 + field(3)) > rest;
    if (found.ends_inside) break;
    at += header_bytes_4 + field(4) + count * *value_bytes * (1 + field(3));
    ++found.complete;
  }
  return found;
}

/// By the first 128 bytes. @throw UnreadableFile where they are of no MAT file.
MatVersion mat_version(const std::string& path) {
  MatBytes file(path);
  const std::string start = file.at(0, header_bytes_5);
  if (start.empty()) throw UnreadableFile("file is empty");
  if (start.starts_with("MATLAB 7.3 MAT") || start.starts_with("\x89HDF")) {
    return MatVersion::mat_7_3;
  }
  if (start.size() == header_bytes_5 && (start.ends_with("IM") || start.ends_with("MI"))) {
    return MatVersion::mat_5;
  }
  if (start.size() >= header_bytes_4 && (value_bytes_4(number_at<std::uint32_t>(start, 0)) ||
                                         value_bytes_4(number_at<std::uint32_t>(start, 0, true)))) {
    return MatVersion::mat_4;
  }
  throw UnreadableFile("no MAT file, or cut off in its header");
}

/// Walks the variables of a MAT 4 or 5 file from length to length, checks what is compressed
/// against its checksum, and that a variable holds the values it claims: the library does neither.
/// @throw UnreadableFile naming the variable by its number.
MatElements check_mat_elements(const std::string& path, MatVersion version) {
  MatBytes file(path);
  return version == MatVersion::mat_5 ? check_version_5(file) : check_version_4(file);
}

/// Says of the objects what the library does not: their names, their classes and the way out. What
/// MATLAB stores of them in a variable without a name is no array.
void tell_objects(const std::vector<MatObjects>& with_objects, FileArrays& found) {
  std::size_t next = 0;
  std::vector<std::pair<std::string, std::string>> unread;
  for (const auto& [name, reason] : found.left_out) {
    if (reason == is_stored_of_objects && !with_objects.empty()) continue;
    unread.emplace_back(name, reason);
    if (reason != is_matlab_object) continue;
    // Of cells and of arrays of structs the names have numbers: "runs_0.tt".
    const auto is_in = [&](const std::string& variable) {
      return name.starts_with(variable) &&
             name.find_first_of("._", variable.size()) == variable.size();
    };
    const auto it = std::find_if(
        with_objects.begin() + static_cast<std::ptrdiff_t>(next), with_objects.end(),
        [&](const MatObjects& of) { return of.is_object ? name == unnamed : is_in(of.variable); });
    if (it == with_objects.end()) continue;
    std::string& shown = unread.back().first;
    if (it->is_object) {
      next = static_cast<std::size_t>(it - with_objects.begin()) + 1;
      shown = it->variable;
    }
    const bool are_alike = std::all_of(it->classes.begin(), it->classes.end(),
                                       [&](const auto& one) { return one == it->classes[0]; });
    const bool is_called_so = it->is_object || name[it->variable.size()] == '.';
    unread.back().second =
        why_object_is_not_read(is_called_so ? shown : "x", are_alike ? it->classes[0] : "");
  }
  found.left_out = std::move(unread);
}

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
  tell_objects(elements.with_objects, found);
  if (version != MatVersion::mat_7_3 && number < elements.complete) {
    found.leave_out(fmt::format("variable {}", number + 1), "damaged, as may be those behind it");
  }
  if (elements.ends_inside) {
    found.leave_out(fmt::format("variable {}", elements.complete + 1), "the file ends inside it");
  }
  return found;
}

}  // namespace

std::vector<log::LogTable> read_mat(const std::string& path) {
  const ArrayLibraries libraries = array_libraries(path);
  return tables_of(read_isolated(path, [&] { return read_variables(path, libraries); }), path);
}

}  // namespace tribolog::ingest::arrays
