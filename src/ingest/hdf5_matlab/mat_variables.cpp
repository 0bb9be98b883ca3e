#include "ingest/hdf5_matlab/mat_variables.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <type_traits>

#include <fmt/format.h>
#include <matio.h>

#include "ingest/arrays/isolated_reading.h"
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
    case MAT_C_CELL:
      return "it is a cell array";
    case MAT_C_SPARSE:
      return "it is a sparse matrix";
    case MAT_C_FUNCTION:
      return "it is a function";
    case MAT_C_OBJECT:
    case MAT_C_OPAQUE:
      return "it is an object of a MATLAB class";
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

/// A row of characters with what is not ASCII as '?'.
void add_text(const std::string& name, const matvar_t& variable, arrays::FileArrays& found) {
  const bool is_row = variable.rank == 2 && variable.dims[0] == 1;
  if (!is_row || count_of(variable) > longest_text) return found.leave_out(name, "it holds texts");
  arrays::NamedArray codes;
  const std::string reason = read_values(variable, codes);
  if (!reason.empty()) return found.leave_out(name, reason);
  std::string text;
  for (const double code : codes.values) {
    text += code >= 32 && code < 127 ? static_cast<char>(code) : '?';
  }
  found.texts.emplace_back(name, text);
}

void add_numbers(const std::string& name, const matvar_t& variable, arrays::FileArrays& found) {
  arrays::NamedArray array;
  array.name = name;
  array.by_columns = true;
  if (!arrays::shape_array(sides_of(variable), array, found)) return;
  const std::string reason = read_values(variable, array);
  if (!reason.empty()) return found.leave_out(name, reason);
  found.arrays.push_back(std::move(array));
}

void add_variable(const std::string& name, matvar_t& variable, int depth,
                  arrays::FileArrays& found) {
  const std::string reason = why_left_out(variable);
  if (!reason.empty()) return found.leave_out(name, reason);
  if (variable.class_type == MAT_C_CHAR) return add_text(name, variable, found);
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
        add_variable(full, *member, depth + 1, found);
      }
    }
  }
}

void read_variable(mat_t* file, matvar_t& variable, arrays::FileArrays& found) {
  const std::string name = variable.name == nullptr ? "(no name)" : variable.name;
  const std::uint64_t left = arrays::most_values - std::min(found.values, arrays::most_values);
  if (values_claimed(variable) > left) {
    return found.leave_out(name, "it would give more than 2^31 numbers in one file");
  }
  const std::string reason = why_left_out(variable);
  if (!reason.empty()) return found.leave_out(name, reason);
  if (Mat_VarReadDataAll(file, &variable) != 0) {
    return found.leave_out(name, "damaged: its values cannot be read");
  }
  add_variable(name, variable, 0, found);
}

}  // namespace

std::size_t read_mat_variables(const std::string& path, std::size_t count,
                               arrays::FileArrays& found) {
  prepare_hdf5();  // which matio reads version 7.3 with
  const MatFile file(Mat_Open(path.c_str(), MAT_ACC_RDONLY));
  if (!file) throw arrays::UnreadableFile("damaged or no MAT file");
  std::size_t number = 0;
  for (; number < count; ++number) {
    const Variable variable(Mat_VarReadNextInfo(file.get()));
    if (!variable) break;
    read_variable(file.get(), *variable, found);
  }
  return number;
}

}  // namespace tribolog::ingest::hdf5_matlab
