#include "ingest/log/log_format.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/enum_text.h"

namespace tribolog::ingest::log {
namespace {

using namespace std::string_view_literals;

struct Signature {
  std::string_view start;
  LogFormat format;
};

constexpr std::array signatures = {
    Signature{"\x89MCAP0\r\n"sv, LogFormat::mcap},
    Signature{"#ROSBAG V"sv, LogFormat::rosbag},
    Signature{"SQLite format 3\0"sv, LogFormat::sqlite_bag},
    Signature{"\x93NUMPY"sv, LogFormat::npy},
    Signature{"MATLAB 5.0 MAT"sv, LogFormat::mat},
    Signature{"MATLAB 7.3 MAT"sv, LogFormat::mat},
    Signature{"MDF     "sv, LogFormat::mdf},
    Signature{"UnFinMF "sv, LogFormat::mdf},
    Signature{"TDSm"sv, LogFormat::tdms},
    Signature{"TDSh"sv, LogFormat::tdms},
    Signature{"PAR1"sv, LogFormat::parquet},
    Signature{"PARE"sv, LogFormat::parquet},
};

bool has_extension(const std::string& path, std::string_view extension) {
  if (path.size() < extension.size()) return false;
  return std::equal(extension.rbegin(), extension.rend(), path.rbegin(), [](char wanted, char c) {
    return wanted == (c >= 'A' && c <= 'Z' ? c + 32 : c);
  });
}

std::uint32_t little_endian(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = count; i-- > 0;) {
    value = (value << 8) | static_cast<unsigned char>(bytes[at + i]);
  }
  return value;
}

/// A zip whose first entry is an array, or that calls itself so.
bool is_npz(std::string_view bytes, const std::string& path) {
  if (bytes.starts_with("PK\x05\x06"sv)) return has_extension(path, ".npz");
  if (!bytes.starts_with("PK\x03\x04"sv)) return false;
  if (has_extension(path, ".npz")) return true;
  constexpr std::size_t header_bytes = 30;
  if (bytes.size() < header_bytes) return false;
  return bytes.substr(header_bytes, little_endian(bytes, 26, 2)).ends_with(".npy");
}

/// HDF5 allows a block of the user's own of 512 bytes, or that doubled again and again, in front.
bool is_hdf5(std::string_view bytes) {
  constexpr std::string_view signature = "\x89HDF\r\n\x1a\n";
  if (bytes.starts_with(signature)) return true;
  for (std::size_t at = 512; at < bytes.size(); at *= 2) {
    if (bytes.substr(at).starts_with(signature)) return true;
  }
  return false;
}

/// MAT 5 has 124 bytes of any text, its version and the mark of its byte order.
bool is_mat_5(std::string_view bytes) {
  if (bytes.size() < 128) return false;
  const std::string_view version = bytes.substr(124, 4);
  return version == "\0\1IM"sv || version == "\1\0MI"sv;
}

/// MAT 4 has no signature; its first matrix starts with a type below 5000 as 32-bit number.
bool may_be_mat_4(std::string_view bytes, const std::string& path) {
  if (bytes.size() < 20 || !has_extension(path, ".mat")) return false;
  const bool is_little = little_endian(bytes, 0, 4) < 5000;
  const bool is_big = bytes[0] == 0 && bytes[1] == 0;
  return is_little || is_big;
}

bool is_json(std::string_view text, const std::string& path) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  if (has_extension(path, ".json")) return true;
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return false;
  const std::size_t second = text.find_first_not_of(blanks, first + 1);
  const char next = second == std::string_view::npos ? '\0' : text[second];
  // "{note}" and "[s] time" may well start a header of columns.
  if (text[first] == '{') return next == '"' || next == '}';
  return text[first] == '[' && "{[]\"-0123456789"sv.find(next) != std::string_view::npos;
}

}  // namespace

std::string to_string(LogFormat format) {
  constexpr EnumTexts<LogFormat> texts("text (CSV or a dialect)", "MAT (MATLAB)", "HDF5",
                                       "NumPy archive (.npz)", "NumPy array (.npy)", "JSON", "MCAP",
                                       "rosbag (.bag)", "rosbag2 (.db3)", "ASAM MDF (.mf4)", "TDMS",
                                       "Parquet");
  return std::string(texts.of(format));
}

bool is_zarr_metadata(std::string_view first_bytes) {
  return first_bytes.starts_with('{') &&
         first_bytes.find("\"zarr_format\"") != std::string_view::npos;
}

LogFormat detect_log_format(std::string_view first_bytes, const std::string& path) {
  for (const Signature& signature : signatures) {
    if (first_bytes.starts_with(signature.start)) return signature.format;
  }
  if (is_npz(first_bytes, path)) return LogFormat::npz;
  if (is_mat_5(first_bytes)) return LogFormat::mat;
  if (is_hdf5(first_bytes)) return LogFormat::hdf5;
  if (may_be_mat_4(first_bytes, path)) return LogFormat::mat;
  if (is_zarr_metadata(first_bytes)) return LogFormat::text;  // refused there
  if (is_json(first_bytes, path)) return LogFormat::json;
  return LogFormat::text;
}

}  // namespace tribolog::ingest::log
