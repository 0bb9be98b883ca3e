#pragma once
// Which format a log is in.

#include <cstddef>
#include <string>
#include <string_view>

namespace tribolog::ingest::log {

enum class LogFormat {
  text,
  mat,
  hdf5,
  npz,
  npy,
  json,
  mcap,
  rosbag,
  sqlite_bag,
  mdf,
  tdms,
  parquet
};

/// "CSV or the like", for people.
std::string to_string(LogFormat format);

/// Bytes from the start of a file that detect_log_format() wants to see, if there are as many.
inline constexpr std::size_t log_format_bytes = 4096;

/// By the bytes that a format's files start with, then by what a text starts with ('{' or '[' as
/// JSON has them), and only where neither tells by the name (".mat" of version 4, ".json"). What is
/// none of these is `text`; start_of_text() names and refuses other binary formats.
LogFormat detect_log_format(std::string_view first_bytes, const std::string& path);

/// Of a Zarr store, a folder of many files: the arrays and groups are described in JSON.
bool is_zarr_metadata(std::string_view first_bytes);

/// What makes a log of such a folder, for messages.
inline constexpr std::string_view by_zarr =
    "in a Python with zarr (pip install zarr): python3 -c \"import numpy, zarr; "
    "numpy.savez('LOG.npz', **{n: a[:] for n, a in zarr.open_group('LOG', mode='r').arrays()})\"";

}  // namespace tribolog::ingest::log
