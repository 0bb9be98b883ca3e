#pragma once
// Every key of a dataset manifest, described: what `tribolog manifest` prints. A test holds it
// against the keys that the reader accepts.

#include <string>
#include <vector>

namespace tribolog::cli {

struct ManifestKey {
  std::string name;
  std::string value;      ///< What it may be: "text", "number, 10⁻⁶ to 10⁶ N·m/A".
  std::string otherwise;  ///< "required", or what holds where it is not stated.
  std::string states;
};

/// Tables with the same keys stand together.
struct ManifestTable {
  std::vector<std::string> names;  ///< "" for the top, "robot", "columns.time".
  bool is_repeated{};              ///< `[[limit]]`
  std::string states;
  std::vector<ManifestKey> keys;
};

/// In the order in which a manifest has them.
std::vector<ManifestTable> manifest_tables();

/// Of all tables, or those whose name is `table` or begins with it and a dot, as Markdown; empty:
/// there is no such table.
std::string manifest_reference(const std::string& table = "");

}  // namespace tribolog::cli
