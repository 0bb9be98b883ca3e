#include "ingest/hdf5_matlab/mat_variables.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <matio.h>

#include "ingest/arrays/isolated_reading.h"
#include "ingest/arrays/matlab_objects.h"
#include "ingest/hdf5_matlab/hdf5_chunks.h"

namespace tribolog::ingest::hdf5_matlab {
namespace {

constexpr int deepest_struct = 16;
constexpr std::uint64_t most_structs = 64;

struct CloseMat {
  void operator()(mat_t* file) const { Mat_Close(file); }
};
struct FreeVariable {
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using MatFile = std::unique_ptr<mat_t, CloseMat>;
using Variable = std::unique_ptr<matvar_t, FreeVariable>;

std::vector<std::uint64_t> sides_of(const matvar_t& variable) {
  if (variable.rank <= 0 || variable.dims == nullptr) return {0};
  return {variable.dims, variable.dims + variable.rank};
}

/// Bounded by 2^62, so that sums of a few do not overflow.
std::uint64_t count_of(const matvar_t& variable) {
  constexpr std::uint64_t bound = std::uint64_t{1} << 62;
  std::uint64_t count = 1;
  for (const std::uint64_t side : sides_of(variable)) {
    count = side != 0 && count > bound / side ? bound : count * side;
  }
  return count;
}

/// Values in a variable and all within it, from its headers alone.
std::uint64_t values_claimed(const matvar_t& variable, int depth = 0) {
  const bool is_nested = variable.class_type == MAT_C_STRUCT || variable.class_type == MAT_C_CELL;
  const std::uint64_t count = count_of(variable);
  if (!is_nested || variable.data == nullptr || depth > deepest_struct) return count;
  const auto* members = static_cast<matvar_t* const*>(variable.data);
  const std::size_t known = variable.nbytes / sizeof(matvar_t*);
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < known && sum <= arrays::most_values; ++i) {
    if (members[i] != nullptr) sum += values_claimed(*members[i], depth + 1);
  }
  return sum;
}

template <class Number>
void convert(const matvar_t& variable, arrays::NamedArray& array) {
  const auto* values = static_cast<const Number*>(variable.data);
  for (std::size_t i = 0; i < array.values.size(); ++i) {
    array.values[i] = static_cast<double>(values[i]);
    if constexpr (std::is_integral_v<Number> && sizeof(Number) == 8) {
      array.was_rounded =
          array.was_rounded || std::abs(array.values[i]) >= arrays::first_rounded_integer;
    }
  }
}

bool convert_all(const matvar_t& variable, arrays::NamedArray& array) {
  switch (variable.data_type) {
    case MAT_T_DOUBLE:
      convert<double>(variable, array);
      return true;
    case MAT_T_SINGLE:
      convert<float>(variable, array);
      return true;
    case MAT_T_INT8:
      convert<std::int8_t>(variable, array);
      return true;
    case MAT_T_UINT8:
    case MAT_T_UTF8:
      convert<std::uint8_t>(variable, array);
      return true;
    case MAT_T_INT16:
      convert<std::int16_t>(variable, array);
      return true;
    case MAT_T_UINT16:
    case MAT_T_UTF16:
      convert<std::uint16_t>(variable, array);
      return true;
    case MAT_T_INT32:
      convert<std::int32_t>(variable, array);
      return true;
    case MAT_T_UINT32:
      convert<std::uint32_t>(variable, array);
      return true;
    case MAT_T_INT64:
      convert<std::int64_t>(variable, array);
      return true;
    case MAT_T_UINT64:
      convert<std::uint64_t>(variable, array);
      return true;
    default:
      return false;
  }
}

std::string why_left_out(const matvar_t& variable) {
  if (variable.isComplex != 0) return "it holds complex numbers";
  switch (variable.class_type) {
    case MAT_C_SPARSE:
      return "it is a sparse matrix";
    case MAT_C_FUNCTION:
      return "it is a function";
    case MAT_C_OBJECT:
    case MAT_C_OPAQUE:
      return std::string(arrays::is_matlab_object);
    case MAT_C_EMPTY:
      return "it is empty";
    default:
      return "";
  }
}

/// The values of a numeric variable or of characters. @return "" or why there are none.
std::string read_values(const matvar_t& variable, arrays::NamedArray& array) {
  const std::uint64_t count = count_of(variable);
  const std::size_t value_bytes = Mat_SizeOf(variable.data_type);
  if (variable.data == nullptr || value_bytes == 0 || variable.nbytes / value_bytes < count) {
    return "damaged: it has fewer values than it says";
  }
  array.values.resize(count);
  return convert_all(variable, array) ? "" : "its type is not known";
}

/// A row of characters with what is not ASCII as '?'; nothing where it cannot be read as one.
std::optional<std::string> text_of(const matvar_t& variable) {
  if (variable.class_type != MAT_C_CHAR || variable.isComplex != 0) return std::nullopt;
  const bool is_row = variable.rank == 2 && variable.dims[0] == 1;
  if (!is_row || count_of(variable) > longest_text) return std::nullopt;
  arrays::NamedArray codes;
  if (!read_values(variable, codes).empty()) return std::nullopt;
  std::string text;
  for (const double code : codes.values) {
    text += code >= 32 && code < 127 ? static_cast<char>(code) : '?';
  }
  return text;
}

void add_text(const std::string& name, const matvar_t& variable, arrays::FileArrays& found) {
  if (const auto text = text_of(variable)) {
    found.texts.emplace_back(name, *text);
  } else {
    found.leave_out(name, "it holds texts");
  }
}

/// A cell array: its elements are called after it and their places, until another one names them.
struct ReadCells {
  std::string name;
  std::size_t elements{};
  std::vector<std::string> texts;  ///< Where all of them are texts; else empty.
};

/// What stands in front of the last name of "run.data".
std::string_view struct_of(std::string_view path) {
  const std::size_t end = path.rfind('.');
  return end == std::string_view::npos ? std::string_view() : path.substr(0, end + 1);
}

/// "data_0" of a cell of vectors, and "runs_0.t" of one of structs, get the names that a cell of as
/// many different texts beside it holds, where there is just one.
void name_cells(const std::vector<ReadCells>& cells, arrays::FileArrays& found) {
  for (const ReadCells& of : cells) {
    if (!of.texts.empty()) continue;
    const ReadCells* names = nullptr;
    std::size_t possible = 0;
    for (const ReadCells& other : cells) {
      const std::set<std::string> different(other.texts.begin(), other.texts.end());
      const bool may_be = different.size() == of.elements && !different.contains("") &&
                          struct_of(other.name) == struct_of(of.name);
      if (!may_be) continue;
      names = &other;
      ++possible;
    }
    if (possible != 1) continue;
    const auto rename = [&](std::string& name) {
      for (std::size_t i = 0; i < of.elements; ++i) {
        const std::string element = fmt::format("{}_{}", of.name, i);
        const bool is_it = name.starts_with(element) &&
                           (name.size() == element.size() || name[element.size()] == '.');
        if (!is_it) continue;
        name = std::string(struct_of(of.name)) + names->texts[i] + name.substr(element.size());
        return;
      }
    };
    for (arrays::NamedArray& array : found.arrays) rename(array.name);
    for (auto& text : found.texts) rename(text.first);
    for (auto& one : found.left_out) rename(one.first);
  }
}

/// What is read so far.
struct FoundInMat {
  arrays::FileArrays& found;
  std::vector<ReadCells> cells;
};

void add_numbers(const std::string& name, const matvar_t& variable, arrays::FileArrays& found) {
  arrays::NamedArray array;
  array.name = name;
  array.by_columns = true;
  if (!arrays::shape_array(sides_of(variable), array, found)) return;
  const std::string reason = read_values(variable, array);
  if (!reason.empty()) return found.leave_out(name, reason);
  found.arrays.push_back(std::move(array));
}

void add_variable(const std::string& name, matvar_t& variable, int depth, FoundInMat& in);

void add_cells(const std::string& name, matvar_t& variable, int depth, FoundInMat& in) {
  const std::uint64_t count = count_of(variable);
  if (count == 0 || variable.data == nullptr) return in.found.leave_out(name, "it is empty");
  if (count > most_structs || depth == deepest_struct) {
    return in.found.leave_out(name, count > most_structs ? "it is a cell array of more than 64"
                                                         : "cells are nested too deeply");
  }
  ReadCells cells{name, static_cast<std::size_t>(count), {}};
  for (std::size_t i = 0; i < count; ++i) {
    const matvar_t* member = Mat_VarGetCell(&variable, static_cast<int>(i));
    const auto text = member == nullptr ? std::nullopt : text_of(*member);
    if (text) cells.texts.push_back(*text);
  }
  const bool are_texts = cells.texts.size() == count;
  if (!are_texts) cells.texts.clear();
  in.cells.push_back(std::move(cells));
  if (are_texts) return in.found.leave_out(name, "it is a cell array of texts");
  for (std::size_t i = 0; i < count; ++i) {
    matvar_t* member = Mat_VarGetCell(&variable, static_cast<int>(i));
    const std::string full = fmt::format("{}_{}", name, i);
    if (member == nullptr) {
      in.found.leave_out(full, "it is empty");
    } else {
      add_variable(full, *member, depth + 1, in);
    }
  }
}

void add_variable(const std::string& name, matvar_t& variable, int depth, FoundInMat& in) {
  arrays::FileArrays& found = in.found;
  const std::string reason = why_left_out(variable);
  if (!reason.empty()) return found.leave_out(name, reason);
  if (variable.class_type == MAT_C_CHAR) return add_text(name, variable, found);
  if (variable.class_type == MAT_C_CELL) return add_cells(name, variable, depth, in);
  if (variable.class_type != MAT_C_STRUCT) return add_numbers(name, variable, found);

  const std::uint64_t structs = count_of(variable);
  const unsigned fields = Mat_VarGetNumberOfFields(&variable);
  char* const* field_names = Mat_VarGetStructFieldnames(&variable);
  if (structs == 0 || fields == 0 || field_names == nullptr || variable.data == nullptr) {
    return found.leave_out(name, "it is an empty struct");
  }
  if (structs > most_structs || depth == deepest_struct) {
    return found.leave_out(name, structs > most_structs ? "it is an array of more than 64 structs"
                                                        : "structs are nested too deeply");
  }
  for (std::size_t i = 0; i < structs; ++i) {
    for (unsigned field = 0; field < fields; ++field) {
      const std::string element = structs == 1 ? name : fmt::format("{}_{}", name, i);
      const std::string full = element + "." + (field_names[field] ? field_names[field] : "?");
      matvar_t* member = Mat_VarGetStructFieldByIndex(&variable, field, i);
      if (member == nullptr) {
        found.leave_out(full, "it is empty");
      } else {
        add_variable(full, *member, depth + 1, in);
      }
    }
  }
}

/// Variables of a 7.3 file that are objects, with their classes.
using ObjectsIn73 = std::map<std::string, std::string>;

/// @return "timetable" for a dataset that stands for an object; "" for any other.
std::string class_of_object(hid_t root, const char* name) {
  constexpr std::size_t longest = 256;
  const Hdf5Handle dataset(H5Oopen(root, name, H5P_DEFAULT), H5Oclose);
  if (!dataset.is_open() || H5Aexists(dataset.get(), "MATLAB_object_decode") <= 0) return "";
  if (H5Aexists(dataset.get(), "MATLAB_class") <= 0) return "?";
  const Hdf5Handle attribute(H5Aopen(dataset.get(), "MATLAB_class", H5P_DEFAULT), H5Aclose);
  const Hdf5Handle type(H5Aget_type(attribute.get()), H5Tclose);
  const std::size_t length = H5Tget_size(type.get());
  const bool is_plain = H5Tget_class(type.get()) == H5T_STRING &&
                        H5Tis_variable_str(type.get()) == 0 && length > 0 && length <= longest;
  std::string text(is_plain ? length : 0, '\0');
  if (!is_plain || H5Aread(attribute.get(), type.get(), text.data()) < 0) return "?";
  return text.substr(0, text.find('\0'));
}

herr_t keep_name(hid_t, const char* name, const H5L_info_t* info, void* names) {
  constexpr std::size_t most_names = 100'000;
  auto& list = *static_cast<std::vector<std::string>*>(names);
  if (info->type == H5L_TYPE_HARD) list.emplace_back(name);
  return list.size() > most_names ? -1 : 0;
}

/// The library takes them for empty arrays.
ObjectsIn73 objects_in_73(const std::string& path) {
  ObjectsIn73 objects;
  if (H5Fis_hdf5(path.c_str()) <= 0) return objects;
  const Hdf5Handle file(open_hdf5_file(path), H5Fclose);
  if (H5Lexists(file.get(), "#subsystem#", H5P_DEFAULT) <= 0) return objects;
  std::vector<std::string> names;
  hsize_t position = 0;
  if (H5Literate(file.get(), H5_INDEX_NAME, H5_ITER_INC, &position, keep_name, &names) < 0) {
    return objects;
  }
  for (const std::string& name : names) {
    const std::string class_name = class_of_object(file.get(), name.c_str());
    if (!class_name.empty()) objects[name] = class_name == "?" ? "" : class_name;
  }
  return objects;
}

void read_variable(mat_t* file, matvar_t& variable, const ObjectsIn73& objects, FoundInMat& in) {
  arrays::FileArrays& found = in.found;
  const bool has_name = variable.name != nullptr && variable.name[0] != '\0';
  const std::string name = has_name ? variable.name : std::string(arrays::unnamed);
  if (!has_name && variable.class_type != MAT_C_OPAQUE) {
    return found.leave_out(name, std::string(arrays::is_stored_of_objects));
  }
  if (const auto object = objects.find(name); object != objects.end()) {
    return found.leave_out(name, arrays::why_object_is_not_read(name, object->second));
  }
  const std::uint64_t left = arrays::most_values - std::min(found.values, arrays::most_values);
  if (values_claimed(variable) > left) {
    return found.leave_out(name, "it would give more than 2^31 numbers in one file");
  }
  const std::string reason = why_left_out(variable);
  if (!reason.empty()) return found.leave_out(name, reason);
  if (Mat_VarReadDataAll(file, &variable) != 0) {
    return found.leave_out(name, "damaged: its values cannot be read");
  }
  add_variable(name, variable, 0, in);
}

}  // namespace

std::size_t read_mat_variables(const std::string& path, std::size_t count,
                               arrays::FileArrays& found) {
  prepare_hdf5();  // which matio reads version 7.3 with
  const ObjectsIn73 objects = objects_in_73(path);
  FoundInMat in{found, {}};
  const MatFile file(Mat_Open(path.c_str(), MAT_ACC_RDONLY));
  if (!file) throw arrays::UnreadableFile("damaged or no MAT file");
  std::size_t number = 0;
  for (; number < count; ++number) {
    const Variable variable(Mat_VarReadNextInfo(file.get()));
    if (!variable) break;
    read_variable(file.get(), *variable, objects, in);
  }
  name_cells(in.cells, found);
  return number;
}

}  // namespace tribolog::ingest::hdf5_matlab
